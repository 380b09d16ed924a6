// Poses and points of the plane.
#include "plane_convert.hpp"

namespace graze::python {

namespace {

using plane::Pose2d, plane::Rot2d, plane::Vec2d;

/// The error of a matrix's columns in unit length and right angle that single precision leaves.
constexpr double matrix_slack = 1e-6;

Rot2d rotation_of(double angle) {
  if (!std::isfinite(angle)) validate::fail("angle", "a finite number", angle);
  return Rot2d::from_angle(angle);
}

Pose2d pose_of(const double (&m)[9]) {
  const double last[3] = {0, 0, 1};
  for (std::size_t i = 0; i < 3; ++i)
    if (m[6 + i] != last[i]) validate::fail("pose[2][" + std::to_string(i) + "]", i == 2 ? "1" : "0", m[6 + i]);
  const Rot2d r = unit_rotation(m[0], m[3], "pose");
  const double off[4] = {m[0] - r.cosine, m[1] + r.sine, m[3] - r.sine, m[4] - r.cosine};
  for (const double by : off)
    if (!(std::abs(by) <= matrix_slack))
      validate::fail("pose", "a rotation and a translation, without scale, shear or mirroring",
                     "a matrix that is off by " + validate::number(by));
  return {{m[2], m[5]}, r};
}

py::array_t<double> matrix_of(const Pose2d& p) {
  const Rot2d& r = p.rotation;
  const double m[9] = {r.cosine, -r.sine, p.translation.x, r.sine, r.cosine, p.translation.y, 0, 0, 1};
  return py::array_t<double>({3, 3}, m);
}

double angle_of(const Pose2d& p) { return std::atan2(p.rotation.sine, p.rotation.cosine); }

/// A pose from a row of numbers; false for anything else.
bool read_row(py::handle from, Pose2d& to) {
  double n[9];
  if (read_numbers(from, n, 2))
    to = {{n[0], n[1]}, {}};
  else if (read_numbers(from, n, 3))
    to = {{n[0], n[1]}, rotation_of(n[2])};
  else if (read_numbers(from, n, 4))
    to = {{n[0], n[1]}, unit_rotation(n[2], n[3], "rotation")};
  else if (py::isinstance<py::array>(from) && read_numbers(from, n, 9))
    to = pose_of(n);
  else
    return false;
  return true;
}

}  // namespace

py::array_t<double> array_of_points(std::span<const Vec2d> points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  double* out = array.mutable_data();
  for (const Vec2d& p : points) {
    *out++ = p.x;
    *out++ = p.y;
  }
  return array;
}

std::vector<Vec2d> points_of_plane(py::handle from, const char* name) {
  const Rows array = rows(from, 2, name);
  std::vector<Vec2d> points(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {array.data()[2 * i], array.data()[2 * i + 1]};
  return points;
}

Rot2d unit_rotation(double cosine, double sine, const char* path) {
  const double parts[2] = {cosine, sine};
  for (const double part : parts)
    if (!std::isfinite(part)) validate::fail(path, "finite numbers", part);
  if (cosine == 0 && sine == 0) validate::fail(path, "a cosine and a sine that are not both zero", "[0, 0]");
  return normalized(Rot2d{cosine, sine});
}

Vec2d checked(const Vec2d& point, const char* name) { return plane::detail::checked_point(point, name); }

bool read_vector(py::handle from, Vec2d& to) {
  double n[2];
  if (!read_numbers(from, n, 2)) return false;
  to = {n[0], n[1]};
  return true;
}

bool read_pose(py::handle from, Pose2d& to) {
  if (from.is_none()) {
    to = {};
    return true;
  }
  if (py::isinstance<Pose2d>(from)) {
    to = *from.cast<const Pose2d*>();
    return true;
  }
  double angle;
  if (PyTuple_Check(from.ptr()) && PyTuple_GET_SIZE(from.ptr()) == 2 &&
      read_vector(PyTuple_GET_ITEM(from.ptr(), 0), to.translation)) {
    angle = PyFloat_AsDouble(PyTuple_GET_ITEM(from.ptr(), 1));
    if (angle == -1 && PyErr_Occurred()) {
      PyErr_Clear();
      return false;
    }
    to.rotation = rotation_of(angle);
  } else if (!read_row(from, to)) {
    return false;
  }
  to.translation = checked(to.translation, "translation");
  return true;
}

void add_plane_pose(py::module_& m) {
  py::class_<Pose2d>(m, "Pose", R"(Where a body of the plane stands and how it is turned.

translation: two numbers. angle: radians, counter-clockwise.
Wherever a pose is asked for, these do as well: a pair (translation, angle), two numbers (a
translation), three (x, y, angle), four (x, y, cosine, sine), a 3x3 matrix without scale, None (the
origin). Raises ValueError for numbers that are not finite or too large.

>>> from graze import plane
>>> plane.Pose((1, 2)) @ (0, 1)
array([1., 3.])
)")
      .def(py::init([](const Vector2& translation, double angle) {
             return Pose2d{checked(translation.value, "translation"), rotation_of(angle)};
           }),
           py::arg("translation") = Vector2{}, py::arg("angle") = 0.0)
      .def_static(
          "from_matrix",
          [](const py::object& matrix) {
            double n[9];
            if (!read_numbers(rows(matrix, 3, "matrix"), n, 9))
              validate::fail("matrix", "an array of shape (3, 3)", "another shape");
            Pose2d pose = pose_of(n);
            pose.translation = checked(pose.translation, "translation");
            return pose;
          },
          py::arg("matrix"), "The pose of a 3x3 matrix without scale, shear or mirroring.")
      .def_property_readonly(
          "translation", [](const Pose2d& p) { return array_of(p.translation); }, "Of the origin, lengths.")
      .def_property_readonly("angle", &angle_of, "Radians, from -pi to pi.")
      .def_property_readonly(
          "rotation",
          [](const Pose2d& p) {
            return array_of(Vec2d{p.rotation.cosine, p.rotation.sine});
          },
          "Cosine and sine of the angle.")
      .def_property_readonly("matrix", &matrix_of, "The 3x3 matrix.")
      .def(
          "inverse", [](const Pose2d& p) { return relative(p, Pose2d{}); }, "The motion back.")
      .def(
          "__matmul__", [](const Pose2d& p, const Pose2d& q) { return compose(p, q); }, py::is_operator())
      .def(
          "__matmul__", [](const Pose2d& p, const Vector2& v) { return array_of(transform(p, v.value)); },
          py::is_operator())
      .def(
          "__matmul__",
          [](const Pose2d& p, const py::array& points) {
            std::vector<Vec2d> moved = points_of_plane(points, "points");
            for (Vec2d& point : moved) point = transform(p, point);
            return array_of_points(moved);
          },
          py::is_operator())
      .def(
          "__eq__", [](const Pose2d& p, const Pose2d& q) { return p == q; }, py::is_operator())
      .def("__hash__",
           [](const Pose2d& p) {
             return py::hash(py::make_tuple(tuple_of(p.translation), p.rotation.cosine, p.rotation.sine));
           })
      .def("__repr__",
           [](const Pose2d& p) {
             return py::str("graze.plane.Pose(translation={}, angle={})").format(tuple_of(p.translation), angle_of(p));
           })
      // A pose is stored by cosine and sine, not by the angle, which rounds.
      .def(py::pickle(
          [](const Pose2d& p) {
            return py::make_tuple(p.translation.x, p.translation.y, p.rotation.cosine, p.rotation.sine);
          },
          [](const py::tuple& state) {
            double n[4];
            if (!read_numbers(state, n, 4)) throw py::type_error("state of a Pose: expected four numbers");
            static_cast<void>(unit_rotation(n[2], n[3], "rotation"));
            return Pose2d{checked({n[0], n[1]}, "translation"), {n[2], n[3]}};
          }));
}

}  // namespace graze::python
