// The shapes as Python classes.
#pragma once

#include "convert.hpp"
#include "shape_array.hpp"

namespace graze::python {

/// The Python object of a shape, of the class with its name.
py::object object_of(const Shaped& shape);

/// The Python object of a shape, as the answer of a function whose signature says so.
struct ShapeObject {
  py::object object;
};

/// A sequence of shapes, for batches: made once, read many times.
using ShapeArray = ShapesOf<Shaped, Sphere<double>, Capsule<double>, Box<double>, Cylinder<double>, Ellipsoid<double>,
                            Rectangle<double>, LineSegment<double>, Triangle<double>, HalfSpace<double>>;

void add_pose(py::module_& m);
void add_shapes(py::module_& m);

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::ShapeObject> {
  PYBIND11_TYPE_CASTER(graze::python::ShapeObject, const_name("Shape"));
  static handle cast(const graze::python::ShapeObject& shape, return_value_policy, handle) {
    return shape.object.inc_ref();
  }
};

}  // namespace pybind11::detail
