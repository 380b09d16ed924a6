#include "shapes.hpp"

namespace graze::python {

namespace {

py::array_t<double> matrix_of(const Posed& pose) {
  const Mat3d r = rotation_matrix(pose.rotation);
  py::array_t<double> m({4, 4});
  double* out = m.mutable_data();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[4 * i + j] = r.row[i][j];
    out[4 * i + 3] = pose.translation[i];
    out[12 + i] = 0;
  }
  out[15] = 1;
  return m;
}

}  // namespace

void add_pose(py::module_& m) {
  py::class_<Posed>(m, "Pose", R"(Where a body stands and how it is turned: p -> translation + rotation p.

translation: three numbers. rotation: a quaternion (x, y, z, w), brought to unit length where it is off by more than
1e-6.
Wherever a pose is asked for, these do as well: a pair (translation, rotation), an array of
seven numbers, a 4x4 matrix without scale, three numbers (a translation alone), None (the origin).
Raises ValueError for numbers that are not finite or too large, and for a matrix that is no pose.

>>> import graze, numpy as np
>>> graze.Pose((1, 2, 3)) @ (0, 0, 1)
array([1., 2., 4.])
>>> graze.Pose((1, 2, 3)) @ np.eye(3)               # an array of points
array([[2., 2., 3.],
       [1., 3., 3.],
       [1., 2., 4.]])
>>> graze.Pose((1, 2, 3)).inverse()
graze.Pose(translation=(-1.0, -2.0, -3.0), rotation=(-0.0, -0.0, -0.0, 1.0))
)")
      .def(py::init([](const Vector& translation, const py::object& rotation) {
             Placement p;
             if (!read_pose(py::make_tuple(tuple_of(translation.value), rotation), p.value))
               throw py::type_error("rotation: expected a quaternion (x, y, z, w)");
             return p.value;
           }),
           py::arg("translation") = Vector{}, py::arg("rotation") = py::make_tuple(0.0, 0.0, 0.0, 1.0))
      .def_static(
          "from_matrix",
          [](const py::object& matrix) {
            const Rows numbers = rows(matrix, 4, "matrix");
            Posed pose;
            if (numbers.shape(0) != 4 || !read_pose(numbers, pose))
              validate::fail("matrix", "an array of shape (4, 4)", "another shape");
            return pose;
          },
          py::arg("matrix"), "The pose of a 4x4 matrix without scale, shear or mirroring.")
      .def_property_readonly(
          "translation", [](const Posed& p) { return array_of(p.translation); }, "Of the origin, lengths.")
      .def_property_readonly(
          "rotation",
          [](const Posed& p) {
            const double q[4] = {p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w};
            return py::array_t<double>(4, q);
          },
          "The unit quaternion (x, y, z, w).")
      .def_property_readonly("matrix", &matrix_of, "The 4x4 matrix.")
      .def(
          "inverse", [](const Posed& p) { return inverse(p); },
          "The pose that undoes this one: `pose @ pose.inverse()` is the identity.")
      .def(
          "__matmul__", [](const Posed& p, const Posed& q) { return compose(p, q); }, py::is_operator())
      .def(
          "__matmul__", [](const Posed& p, const Vector& v) { return array_of(transform(p, v.value)); },
          py::is_operator())
      .def(
          "__matmul__",
          [](const Posed& p, const py::array& points) {
            std::vector<Vec3d> moved = points_of(rows(points, 3, "points"));
            for (Vec3d& point : moved) point = transform(p, point);
            return array_of_points(moved);
          },
          py::is_operator())
      .def(
          "__eq__", [](const Posed& p, const Posed& q) { return p == q; }, py::is_operator())
      .def("__hash__",
           [](const Posed& p) { return py::hash(py::make_tuple(tuple_of(p.translation), tuple_of(p.rotation))); })
      .def("__repr__",
           [](const Posed& p) {
             return py::str("graze.Pose(translation={}, rotation={})")
                 .format(tuple_of(p.translation), tuple_of(p.rotation));
           })
      .def(py::pickle([](const Posed& p) { return py::make_tuple(tuple_of(p.translation), tuple_of(p.rotation)); },
                      [](const py::tuple& state) {
                        Posed pose;
                        if (!read_pose(state, pose)) throw py::type_error("state of a Pose: expected two tuples");
                        return pose;
                      }));
}

}  // namespace graze::python
