// Support functions in Python, for shapes of space and of the plane.
#pragma once

#include <memory>
#include <string>

#include "convert.hpp"
#include "raised.hpp"

namespace graze::python {

/// A support function in Python. `Words` has its base class `Function`, the class `Vector` of its points, and what
/// reads and makes these.
template <class Words>
class PythonSupport final : public Words::Function, public std::enable_shared_from_this<PythonSupport<Words>> {
 public:
  using Vector = typename Words::Vector;

  explicit PythonSupport(py::function function) : function_(std::move(function)) {}
  PythonSupport(const PythonSupport&) = delete;
  PythonSupport& operator=(const PythonSupport&) = delete;
  ~PythonSupport() override {
    const py::gil_scoped_acquire lock;
    function_ = py::function();
  }

  /// The support point; the origin where the call will raise an exception.
  Vector support(const Vector& direction) const override {
    Vector found{};
    if (raising()) return found;
    const py::gil_scoped_acquire lock;
    raise_later([&] {
      const py::object point = function_(Words::object_of(direction));
      if (!Words::read(point, found))
        throw py::type_error(std::string("support: expected ") + Words::expected + ", got " +
                             std::string(py::str(py::repr(point))));
    });
    return found;
  }

  const py::function& function() const { return function_; }
  /// The function where one shape alone has it, as the garbage collector has to know, else null.
  PyObject* held_alone() const { return this->weak_from_this().use_count() == 1 ? function_.ptr() : nullptr; }
  /// Drops the function of a shape that nobody can reach any more.
  void let_go() const { function_ = py::function(); }

 private:
  mutable py::function function_;
};

/// The support function in Python of a shape by one, or null.
template <class Words, class UserConvex>
const PythonSupport<Words>* python_support_of(const UserConvex& shape) {
  return dynamic_cast<const PythonSupport<Words>*>(&shape.function());
}

}  // namespace graze::python
