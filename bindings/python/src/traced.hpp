// The trace of a query beside its answer.
#pragma once

#include "answers.hpp"
#include "draw.hpp"

namespace graze::python {

/// The answer of `ask`, a function of a `Trace*`. `trace` is false for the answer alone, true for (answer, trace), or a
/// renderer of `draw`, onto which the steps of the query are drawn before the answer is returned.
template <class F>
py::object traced(const py::object& trace, const F& ask) {
  const bool flag = trace.is_none() || PyNumber_Check(trace.ptr()) != 0;
  if (flag && !py::bool_(trace)) return ask(nullptr);
  Trace made;
  py::object answer = ask(&made);
  if (flag) return py::make_tuple(answer, object_of(made));
  PythonDraw on(trace);
  draw(on, made);
  return answer;
}

}  // namespace graze::python
