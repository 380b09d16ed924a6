// Classes that Python's garbage collector looks through.
#pragma once

#include "convert.hpp"

namespace graze::python {

/// Lets the collector follow an object to the function of Python that it holds: a method of the object that holds it,
/// as often as not, and the two would keep each other alive for good. `held_by(const Own&)` is that function, of which
/// the object has a reference for itself, or null; `let_go(Own&)` drops it.
template <class Own>
py::custom_type_setup collected() {
  static constexpr auto own_of = [](PyObject* self) -> Own* {
    const auto* type = py::detail::get_type_info(typeid(Own));
    const auto held = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder(type, false);
    return held.inst != nullptr && held.holder_constructed() ? held.template value_ptr<Own>() : nullptr;
  };
  return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
    PyTypeObject& type = heap_type->ht_type;
    type.tp_flags |= Py_TPFLAGS_HAVE_GC;
    type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) -> int {
      Py_VISIT(Py_TYPE(self));
      if (const Own* own = own_of(self)) Py_VISIT(held_by(*own));
      return 0;
    };
    type.tp_clear = [](PyObject* self) -> int {
      if (Own* own = own_of(self)) let_go(*own);
      return 0;
    };
  });
}

}  // namespace graze::python
