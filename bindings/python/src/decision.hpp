// Decisions on bodies by functions in Python, called by the library in the middle of a query.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "convert.hpp"
#include "raised.hpp"

namespace graze::python {

/// The decision of `given`, a function of those handles, or none where it is None. An exception of it is raised in
/// place of the call's answer. The library may copy and destroy a decision without the interpreter's lock. Throws a
/// TypeError that names `path` for what cannot be called.
template <class... Ids>
std::function<bool(Ids...)> decision(const py::object& given, const char* path) {
  if (given.is_none()) return nullptr;
  if (PyCallable_Check(given.ptr()) == 0) throw py::type_error(std::string(path) + ": expected a function or None");
  const std::shared_ptr<py::object> kept(new py::object(given), [](const py::object* function) {
    const py::gil_scoped_acquire lock;
    delete function;
  });
  return [kept](Ids... ids) {
    bool yes = true;
    if (raising()) return yes;
    const py::gil_scoped_acquire lock;
    raise_later([&] { yes = py::bool_((*kept)(ids...)); });
    return yes;
  };
}

}  // namespace graze::python
