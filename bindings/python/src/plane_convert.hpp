// Vectors and poses of the plane from the forms that Python passes, and back.
//
// Guarantee: that of convert.hpp: a pose that has passed here is finite and its rotation of unit length.
#pragma once

#include "answers.hpp"
#include "graze/plane/batch.hpp"
#include "graze/plane/cast.hpp"

namespace graze::python {

/// A parameter that takes two numbers: a tuple, a list, an array.
struct Vector2 {
  plane::Vec2d value{};
};

/// A parameter that takes a `Pose`, (translation, angle), two numbers (a translation), three (x, y, angle), four (x, y,
/// cosine, sine), a 3×3 matrix, or None (the origin).
struct Placement2 {
  plane::Pose2d value{};
};

inline py::tuple tuple_of(const plane::Vec2d& v) { return py::make_tuple(v.x, v.y); }
inline py::array_t<double> array_of(const plane::Vec2d& v) {
  const double numbers[2] = {v.x, v.y};
  return py::array_t<double>(2, numbers);
}
py::array_t<double> array_of_points(std::span<const plane::Vec2d> points);
std::vector<plane::Vec2d> points_of_plane(py::handle from, const char* name);

bool read_vector(py::handle from, plane::Vec2d& to);
/// A pose in any of its forms. Throws `InvalidValue` for numbers that are no pose.
bool read_pose(py::handle from, plane::Pose2d& to);
/// A point with coordinates that queries take.
plane::Vec2d checked(const plane::Vec2d& point, const char* name);
/// A shape as an object of the class of its kind; polygons and chains have the corners that the library keeps.
py::object object_of(const plane::Shaped& shape);
/// A ray from its parts. Throws `InvalidValue` for numbers that queries do not take.
inline plane::Ray<double> ray_of(const Vector2& origin, const Vector2& direction) {
  return {checked(origin.value, "origin"), checked(direction.value, "direction")};
}
/// The rotation of a cosine and a sine, brought to unit length. Throws `InvalidValue` where they are none.
plane::Rot2d unit_rotation(double cosine, double sine, const char* path);

void add_plane_pose(py::module_& m);
void add_plane_shapes(py::module_& m);
void add_plane_answers(py::module_& m);
void add_plane_queries(py::module_& m);
void add_plane_batches(py::module_& m);
void add_plane_motion(py::module_& m);
void add_plane_world(py::module_& m);
void add_plane_simulation(py::module_& m);
void add_plane_draw(py::module_& m);
void add_plane_scenes(py::module_& m);

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::Vector2> {
  PYBIND11_TYPE_CASTER(graze::python::Vector2, const_name("ArrayLike"));
  bool load(handle from, bool) { return graze::python::read_vector(from, value.value); }
  static handle cast(const graze::python::Vector2& v, return_value_policy, handle) {
    return graze::python::tuple_of(v.value).release();
  }
};

template <>
struct type_caster<graze::python::Placement2> {
  PYBIND11_TYPE_CASTER(graze::python::Placement2, const_name("PoseLike"));
  bool load(handle from, bool) { return graze::python::read_pose(from, value.value); }
  static handle cast(const graze::python::Placement2& p, return_value_policy policy, handle parent) {
    return pybind11::cast(p.value, policy, parent).release();
  }
};

}  // namespace pybind11::detail
