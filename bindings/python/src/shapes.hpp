// The shapes as Python classes.
#pragma once

#include "convert.hpp"

namespace graze::python {

/// The Python object of a shape, of the class with its name.
py::object object_of(const Shaped& shape);

/// A sequence of shapes, for batches: made once, read many times.
struct ShapeArray {
  std::vector<Shaped> shapes;
};

void add_pose(py::module_& m);
void add_shapes(py::module_& m);

}  // namespace graze::python
