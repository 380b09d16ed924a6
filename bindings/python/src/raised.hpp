// Exceptions of functions in Python that the library calls in the middle of a query.
//
// Guarantee: none of them passes through the library's code, which is not made for it. The first one of a call is
// raised in place of its answer, when the function of the module that Python called returns.
#pragma once

#include <pybind11/pybind11.h>

namespace graze::python {

/// Whether the call that runs in this thread will raise: its answer is thrown away, so nobody has to be asked any more.
bool raising();

/// A call of the module that runs in some thread.
struct RunningCall;
/// The one that runs in this thread, or null.
RunningCall* running_call();

/// Makes this thread one that works for a call, as long as this lives: what functions raise in it, the call raises.
class WorkingFor {
 public:
  explicit WorkingFor(RunningCall* call);
  ~WorkingFor();
  WorkingFor(const WorkingFor&) = delete;
  WorkingFor& operator=(const WorkingFor&) = delete;

 private:
  RunningCall* before_;
};

/// Keeps the exception that is set until the call that runs in this thread returns, unless the call has one already. In
/// a thread in which no call runs, the exception is reported as Python reports those of destructors.
void keep_raised();

/// Runs `body`, whose exceptions are raised later. With the interpreter's lock held.
template <class Body>
void raise_later(const Body& body) {
  try {
    body();
  } catch (pybind11::error_already_set& error) {
    error.restore();
    keep_raised();
  } catch (const pybind11::builtin_exception& error) {
    error.set_error();
    keep_raised();
  }
}

/// Makes all functions, methods and properties of a module raise what their calls have kept.
void raise_after_calls(const pybind11::module_& module);

}  // namespace graze::python
