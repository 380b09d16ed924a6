// Answers for Python: plain objects whose vectors are arrays, and records of many.
#pragma once

#include "convert.hpp"

namespace graze::python {

/// A trace as a dictionary of lists, tuples and numbers.
py::dict object_of(const Trace& trace);

/// An answer as an object of Python, which it may be already.
template <class Answer>
py::object object_of_answer(Answer&& answer) {
  if constexpr (std::is_base_of_v<py::handle, std::decay_t<Answer>>)
    return std::forward<Answer>(answer);
  else
    return py::cast(std::forward<Answer>(answer));
}

void add_answers(py::module_& m);
void add_queries(py::module_& m);
void add_batches(py::module_& m);
void add_motion(py::module_& m);
void add_world(py::module_& m);
void add_simulation(py::module_& m);
void add_replay(py::module_& m);
void add_scenes(py::module_& m);
void add_plane(py::module_& m);
void add_broad(py::module_& m);
void add_draw(py::module_& m);

/// Records of contact points, with or without a solver's impulses.
py::dtype distance_type();
py::dtype point_type();
py::dtype solver_point_type();

}  // namespace graze::python
