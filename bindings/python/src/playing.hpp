// Scenes that are played.
#pragma once

#include "convert.hpp"

namespace graze::python {

void add_playing(py::module_& m);
void add_plane_playing(py::module_& m);

}  // namespace graze::python
