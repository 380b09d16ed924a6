// Threads for worlds, simulations and batches: the argument `threads` of Python.
//
// Guarantee: tasks that call functions of Python get the interpreter's lock, whoever holds it when they are begun; what
// such a function raises is raised by the call that the tasks belong to. A call that comes while the threads work for
// another one, also from within its tasks, is answered by its own thread alone, and so is every call of a process that
// was forked after the threads were begun, which has none of them. Answers have the same bits throughout.
#pragma once

#include <atomic>
#include <memory>

#include "cli/thread_executor.hpp"
#include "convert.hpp"

namespace graze::python {

/// A fixed number of threads, the calling one among them.
class Threads final : public Executor {
 public:
  explicit Threads(std::size_t count);
  ~Threads() override;
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  std::size_t concurrency() const override { return count_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override;

 private:
  bool forked() const;

  std::size_t count_;
  long process_;  ///< the one that has the threads
  std::atomic_flag busy_ = ATOMIC_FLAG_INIT;
  std::unique_ptr<cli::ThreadExecutor> pool_;
};

/// A parameter that takes a number of threads, a `graze.Threads` or None.
struct ThreadsArgument {
  py::object given = py::none();

  /// The threads, those of a number made for the caller; null for None. Throws `InvalidValue` for a number that is none
  /// of threads.
  std::shared_ptr<Threads> own() const;
  /// Threads for one call; those of a number are kept from one call to the next.
  std::shared_ptr<Threads> of_call() const;
};

void add_threads(py::module_& m);

}  // namespace graze::python

namespace pybind11::detail {

template <>
struct type_caster<graze::python::ThreadsArgument> {
  PYBIND11_TYPE_CASTER(graze::python::ThreadsArgument, const_name("Threads | int | None"));
  bool load(handle from, bool) {
    value.given = reinterpret_borrow<object>(from);
    return from.is_none() || isinstance<graze::python::Threads>(from) || PyIndex_Check(from.ptr()) != 0;
  }
  static handle cast(const graze::python::ThreadsArgument& threads, return_value_policy, handle) {
    return threads.given.inc_ref();
  }
};

}  // namespace pybind11::detail
