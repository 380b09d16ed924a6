// Vectors, rotations and poses from the forms that Python passes, and numbers for Python.
//
// Guarantee: an argument of another form is a TypeError, a value that is refused a ValueError that names it; a pose
// that has passed here is finite and its quaternion of unit length, so that queries may trust it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <vector>

#include "graze/graze.hpp"

namespace graze::python {

namespace py = pybind11;

/// The rounding of a unit length, squared, where a rotation was computed or stored in single precision.
inline constexpr double unit_slack = 1e-6;

/// A parameter that takes three numbers: a tuple, a list, an array.
struct Vector {
  Vec3d value{};
};

/// A parameter that takes a `Pose`, (translation, quaternion), seven numbers, a 4×4 matrix, three numbers (a
/// translation) or None (the origin).
struct Placement {
  Posed value{};
};

/// A ray from its parts. Throws `InvalidValue` for numbers that queries do not take.
inline Ray<double> ray_of(const Vector& origin, const Vector& direction) {
  return {validate::point(origin.value, "origin"), validate::point(direction.value, "direction")};
}

/// Three numbers as an array of their own.
inline py::array_t<double> array_of(const Vec3d& v) {
  const double numbers[3] = {v.x, v.y, v.z};
  return py::array_t<double>(3, numbers);
}
py::array_t<double> array_of_points(std::span<const Vec3d> points);
inline py::tuple tuple_of(const Vec3d& v) { return py::make_tuple(v.x, v.y, v.z); }
inline py::tuple tuple_of(const Quatd& q) { return py::make_tuple(q.x, q.y, q.z, q.w); }

/// `size` numbers from a tuple, a list or an array; false for anything else.
bool read_numbers(py::handle from, double* to, py::ssize_t size);
/// Three numbers from Python, unchecked but for their form; false if it is another.
bool read_vector(py::handle from, Vec3d& to);
/// A pose in any of its forms. Throws `InvalidValue` for numbers that are no pose.
bool read_pose(py::handle from, Posed& to);

/// An array of `columns` numbers a row, as it stands if it is contiguous and of doubles, else copied. An empty list is
/// an array of no rows.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
Rows rows(py::handle from, py::ssize_t columns, const char* name);
/// An array of whole numbers that are indices, always copied.
using IndexRows = py::array_t<std::uint32_t, py::array::c_style>;
IndexRows index_rows(py::handle from, py::ssize_t columns, const char* name);

inline std::vector<Vec3d> points_of(const Rows& array) {
  std::vector<Vec3d> points(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* row = array.data(static_cast<py::ssize_t>(i), 0);
    points[i] = {row[0], row[1], row[2]};
  }
  return points;
}

/// One field of a record: its name, its type as NumPy writes it, and where it stands.
struct Field {
  const char* name;
  const char* type;
  std::size_t offset;
};
py::dtype record_type(std::initializer_list<Field> fields, std::size_t size);

/// A vector of unit length, of the words of space or the plane. Throws `InvalidValue` that names `path` for another.
template <class Words>
typename Words::Vector unit_vector(const typename Words::Vector& v, const std::string& path) {
  Words::check(v, path);
  const double square = dot(v, v);
  if (!(std::abs(square - 1) <= unit_slack)) validate::fail(path, "a vector of unit length", std::sqrt(square));
  return v;
}

/// A number from Python. Throws a TypeError that names `path` for what is none.
double number_from(const py::object& from, const char* path);

/// A limit, a length or a margin, which may be infinite. Throws `InvalidValue` for a number that is negative or none.
inline double checked_reach(double value, const char* name) {
  if (!(value >= 0)) validate::fail(name, "a number >= 0", value);
  return value;
}

/// The time that something moves. Throws `InvalidValue` for a number that is negative or not finite.
inline double checked_duration(double duration) {
  if (!(duration >= 0 && duration <= largest_magnitude<double>))
    validate::fail("duration", "a finite number >= 0", duration);
  return duration;
}

inline const char* text_of(Status status) {
  return status == Status::converged ? "converged" : status == Status::bounded ? "bounded" : "unbounded";
}

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::Vector> {
  PYBIND11_TYPE_CASTER(graze::python::Vector, const_name("ArrayLike"));
  bool load(handle from, bool) { return graze::python::read_vector(from, value.value); }
  static handle cast(const graze::python::Vector& v, return_value_policy, handle) {
    return graze::python::tuple_of(v.value).release();
  }
};

template <>
struct type_caster<graze::python::Placement> {
  PYBIND11_TYPE_CASTER(graze::python::Placement, const_name("PoseLike"));
  bool load(handle from, bool) { return graze::python::read_pose(from, value.value); }
  static handle cast(const graze::python::Placement& p, return_value_policy policy, handle parent) {
    return pybind11::cast(p.value, policy, parent).release();
  }
};

}  // namespace pybind11::detail
