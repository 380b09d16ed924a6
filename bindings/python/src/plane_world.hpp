// Worlds of the plane: the words in which they differ from those of space.
#pragma once

#include "plane_convert.hpp"
#include "world.hpp"

namespace graze::python {

/// A parameter that takes a shape of the plane, together with its Python object.
struct PlaneShapeObject {
  const plane::Shaped* shape = nullptr;
  py::object object;
};

/// The words of the plane: vectors of two numbers, a number for a velocity of turning; rows of four numbers for poses.
struct PlaneWords {
  using Space = plane::Space<double>;
  using Vector = Vector2;
  using Turning = double;
  using Placement = Placement2;
  using Shape = PlaneShapeObject;
  /// The Python objects of the bodies' shapes: polygons, chains and compounds in C++ hold only their pieces.
  class Shapes {
   public:
    void keep(std::size_t index, const PlaneShapeObject& shape) {
      if (objects_.size() <= index) objects_.resize(index + 1);
      objects_[index] = shape.object;
    }
    void drop(std::size_t index) { objects_[index] = py::object(); }
    py::object object(const plane::World<double>&, std::size_t index) const { return objects_[index]; }

   private:
    std::vector<py::object> objects_;
  };

  static constexpr py::ssize_t vector_size = 2, pose_size = 4;
  static constexpr const char* vector_type = "(2,)f8";
  static constexpr const char* pose_row = "(x, y, cosine, sine), shape (n, 4)";
  static constexpr const char* turning_unit = "radians per unit of time, counter-clockwise";
  static constexpr const char* measure = "a mass of its area";
  static constexpr const char* hinge = "The origins of the frames stay one; a turn is free.";
  static constexpr const char* joint_axes = "Linear axes are x and y of `frame_a`, the angular one is z.";

  static constexpr const char* inertia_given = "a number, about the centre of mass";

  static const plane::Shaped& value_of(const PlaneShapeObject& shape) { return *shape.shape; }
  static const plane::Vec2d& value_of(const Vector2& v) { return v.value; }
  static double value_of(double turning) { return turning; }
  static py::array_t<double> object_of(const plane::Vec2d& v) { return array_of(v); }
  static plane::Vec2d checked(const Vector2& v, const char* name) { return python::checked(v.value, name); }
  static py::float_ object_of(double turning) { return py::float_(turning); }
  static plane::Velocity<double> velocity(const Vector2& linear, double angular);
  /// A pose from a row. Throws `InvalidValue` that names the part.
  static plane::Pose2d pose_of_row(const double* p);
  static plane::Vec2d vector_of_row(const double* p) { return python::checked({p[0], p[1]}, "impulse"); }
  /// Sets the inertia of a body, which is checked by the simulation.
  static void set_inertia(plane::Dynamics<double>& dynamics, const py::object& given) {
    dynamics.inertia = number_from(given, "inertia");
  }
};

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::PlaneShapeObject> {
  PYBIND11_TYPE_CASTER(graze::python::PlaneShapeObject, const_name("Shape"));
  bool load(handle from, bool) {
    if (!isinstance<graze::plane::Shaped>(from)) return false;
    value.shape = from.cast<const graze::plane::Shaped*>();
    value.object = reinterpret_borrow<object>(from);
    return true;
  }
};

}  // namespace pybind11::detail
