// Worlds for Python: one to read, which a simulation has too, and one of its own to change. They are written once for
// space and the plane, which differ in their `Words`.
#pragma once

#include "alone.hpp"
#include "capture.hpp"
#include "collected.hpp"
#include "threads.hpp"

namespace graze::python {

/// A world to read. It belongs to another object, which lives longer.
template <class Words>
class WorldView {
 public:
  using World = graze::World<double, typename Words::Space>;
  using Shapes = typename Words::Shapes;

  WorldView(const World& world, const Shapes& shapes, const Alone& alone) : WorldView(shapes, alone) {
    world_ = &world;
  }
  Alone::Reading<World> read() const { return {*world_, *alone_}; }
  py::object shape(BodyId id) const;

 protected:
  /// A view before there is a world.
  WorldView(const Shapes& shapes, const Alone& alone) : shapes_(&shapes), alone_(&alone) {}

  const World* world_ = nullptr;

 private:
  const Shapes* shapes_;
  const Alone* alone_;
};

/// A world that Python made, and may change. Changes go to `Inner`.
template <class Words, class Inner = graze::World<double, typename Words::Space>>
class OwnWorld : public WorldView<Words> {
 public:
  using Shapes = typename Words::Shapes;

  /// `threads`, which may be null, run the updates.
  template <class... Arguments>
  explicit OwnWorld(std::shared_ptr<Threads> threads, const Arguments&... arguments)
      : WorldView<Words>(shapes_, alone_), threads_(std::move(threads)), inner_(arguments..., threads_.get()) {
    this->world_ = &asked(inner_);
  }
  OwnWorld(const OwnWorld&) = delete;
  OwnWorld& operator=(const OwnWorld&) = delete;

  Alone::Changing<Inner> change() { return {inner_, alone_}; }
  /// The Python objects of the bodies' shapes, to be changed together with the world.
  Shapes& shapes() { return shapes_; }
  /// Keeps in mind which object decides on pairs. The world within has the only share of it.
  void note_allow(const py::object& allow) { allow_ = allow.is_none() ? nullptr : allow.ptr(); }
  PyObject* allow() const { return allow_; }
  void forget_allow() {
    allow_ = nullptr;
    inner_.set_allow(nullptr);
  }
  void update(double duration) {
    const auto world = change();
    const py::gil_scoped_release free;
    world->update(duration);
  }

 private:
  Alone alone_;
  Shapes shapes_;
  std::shared_ptr<Threads> threads_;
  Inner inner_;
  PyObject* allow_ = nullptr;
};

template <class Words, class Inner>
PyObject* held_by(const OwnWorld<Words, Inner>& world) {
  return world.allow();
}
template <class Words, class Inner>
void let_go(OwnWorld<Words, Inner>& world) {
  world.forget_allow();
}

/// A body's place in the arrays of its world. Throws `InvalidValue` for one that is gone.
template <class World>
std::size_t index_of(const World& world, BodyId id) {
  if (!world.bodies().contains(id)) refuse_missing("body", "a body of the world", id);
  return id.index;
}

template <class Words>
py::object WorldView<Words>::shape(BodyId id) const {
  const auto world = read();
  return shapes_->object(*world, index_of(*world, id));
}

/// The words of space: vectors of three numbers, also for velocities of turning; rows of seven numbers for poses.
struct SpaceWords {
  using Space = graze::Space<double>;
  using Vector = python::Vector;
  using Turning = python::Vector;
  using Placement = python::Placement;
  using Shape = Shaped;
  /// The objects of shapes. In space nothing is kept: a shape holds all that it was made of.
  struct Shapes {
    static void keep(std::size_t, const Shaped&) {}
    static void drop(std::size_t) {}
    static py::object object(const World<double>& world, std::size_t index);
  };

  static constexpr py::ssize_t vector_size = 3, pose_size = 7;
  static constexpr const char* vector_type = "(3,)f8";
  static constexpr const char* pose_row = "translation and quaternion, shape (n, 7)";
  static constexpr const char* turning_unit = "radians per unit of time about each axis";
  static constexpr const char* measure = "a mass of its volume";
  static constexpr const char* hinge = "A turn about the frames' x axis is free.";
  static constexpr const char* joint_axes = "Axes are x, y and z of `frame_a`.";

  static constexpr const char* inertia_given = "three moments about the axes of the body's frame, (moments, "
                                               "quaternion) of other axes, or a matrix of shape\n(3, 3) "
                                               "in that frame";

  static const Shaped& value_of(const Shaped& shape) { return shape; }
  static const Vec3d& value_of(const python::Vector& v) { return v.value; }
  static py::array_t<double> object_of(const Vec3d& v) { return array_of(v); }
  static Vec3d checked(const python::Vector& v, const char* name) { return validate::point(v.value, name); }
  static Velocity<double> velocity(const Vector& linear, const Turning& angular) {
    return {validate::point(linear.value, "linear"), validate::point(angular.value, "angular")};
  }
  /// A pose from a row. Throws `InvalidValue` that names the part.
  static Posed pose_of_row(const double* p) {
    return {validate::point(Vec3d{p[0], p[1], p[2]}, "translation"),
            validate::rotation(Quatd{p[3], p[4], p[5], p[6]}, "rotation")};
  }
  static Vec3d vector_of_row(const double* p) { return validate::point(Vec3d{p[0], p[1], p[2]}, "impulse"); }
  /// Sets the inertia of a body. Moments and axes are checked by the simulation.
  static void set_inertia(Dynamics<double>& dynamics, const py::object& given);
};

}  // namespace graze::python
