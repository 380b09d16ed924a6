// Whole numbers from Python.
//
// Guarantee: one that its parameter cannot hold is a ValueError that names the parameter and the number, and what is no
// whole number a TypeError.
#pragma once

#include <limits>
#include <string>

#include "convert.hpp"

namespace graze::python {

/// A parameter that takes a whole number of any size.
struct Whole {
  py::int_ value;

  Whole() = default;
  template <class Number>
  explicit Whole(Number number) : value(number) {}

  /// The number. Throws `InvalidValue` for one that the type does not hold.
  template <class Number>
  Number as(const char* path) const {
    constexpr Number least = std::numeric_limits<Number>::lowest(), most = (std::numeric_limits<Number>::max)();
    if (value < py::int_(least) || value > py::int_(most))
      validate::fail(path, "an integer from " + std::to_string(least) + " to " + std::to_string(most),
                     std::string(py::str(py::handle(value))));
    return value.cast<Number>();
  }
  /// The number, which is not less than `least`. Throws `InvalidValue`.
  template <class Number>
  Number at_least(Number least, const char* path) const {
    const Number number = as<Number>(path);
    if (number < least)
      validate::fail(path, "a number >= " + std::to_string(least), std::string(py::str(py::handle(value))));
    return number;
  }
};

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::Whole> {
  PYBIND11_TYPE_CASTER(graze::python::Whole, const_name("int"));
  bool load(handle from, bool) {
    if (!PyIndex_Check(from.ptr())) return false;
    value.value = reinterpret_steal<int_>(PyNumber_Index(from.ptr()));
    if (!value.value) PyErr_Clear();
    return static_cast<bool>(value.value);
  }
  static handle cast(const graze::python::Whole& whole, return_value_policy, handle) { return whole.value.inc_ref(); }
};

}  // namespace pybind11::detail
