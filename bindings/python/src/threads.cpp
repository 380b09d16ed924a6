#include "threads.hpp"

#include <optional>

#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

#include "raised.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

constexpr std::size_t most_threads = 1024;

long process_number() {
#ifdef _WIN32
  return _getpid();
#else
  return getpid();
#endif
}

std::size_t count_of(const Whole& given) {
  if (given.value < py::int_(1) || given.value > py::int_(most_threads))
    validate::fail("threads", "a number from 1 to " + std::to_string(most_threads),
                   std::string(py::str(py::handle(given.value))));
  return given.value.cast<std::size_t>();
}

/// `graze.Threads`, what `make` has for a number, or null for None.
template <class Make>
std::shared_ptr<Threads> threads_from(const py::object& given, const Make& make) {
  if (given.is_none()) return nullptr;
  if (py::isinstance<Threads>(given)) return given.cast<std::shared_ptr<Threads>>();
  return make(count_of(given.cast<Whole>()));
}

}  // namespace

Threads::Threads(std::size_t count)
    : count_(count), process_(process_number()), pool_(std::make_unique<cli::ThreadExecutor>(count)) {}

Threads::~Threads() {
  if (forked()) static_cast<void>(pool_.release());  // its threads, which this process has not, could not be joined
}

bool Threads::forked() const { return process_number() != process_; }

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count_ == 1 || count < 2 || forked() || busy_.test_and_set(std::memory_order_acquire)) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  {
    std::optional<py::gil_scoped_release> free;
    if (PyGILState_Check() != 0) free.emplace();
    RunningCall* const call = running_call();
    pool_->run(count, [&](std::size_t i) {
      const WorkingFor working(call);
      task(i);
    });
  }
  busy_.clear(std::memory_order_release);
}

std::shared_ptr<Threads> ThreadsArgument::own() const {
  return threads_from(given, [](std::size_t count) { return std::make_shared<Threads>(count); });
}

std::shared_ptr<Threads> ThreadsArgument::of_call() const {
  return threads_from(given, [](std::size_t count) {
    // Never destroyed: threads cannot be joined while a process ends.
    static auto* const kept = new std::shared_ptr<Threads>();
    if (!*kept || (*kept)->concurrency() != count) *kept = std::make_shared<Threads>(count);
    return *kept;
  });
}

void add_threads(py::module_& m) {
  py::class_<Threads, std::shared_ptr<Threads>>(
      m, "Threads", R"(Threads that worlds, simulations and batches share, as their argument `threads`.

count: from 1 to 1024, the calling thread among them. Answers have the same bits with any number. While
the threads work for one call, others that would use them are answered by their own thread alone.
Functions of yours that are called meanwhile, `allow` and support functions, hold the interpreter's
lock, so that only one of them runs at a time. Not pickled. Raises ValueError for another count.

>>> import graze, numpy as np
>>> threads = graze.Threads(2)
>>> places = np.zeros((1000, 7))
>>> places[:, 0], places[:, 6] = np.arange(1000), 1
>>> int(graze.batch.overlap(graze.Sphere(10), None, graze.Box((1, 1, 1)), places, threads=threads).sum())
11
>>> world = graze.World(threads=threads)
)")
      .def(py::init([](const Whole& count) { return std::make_shared<Threads>(count_of(count)); }), py::arg("count"))
      .def_property_readonly("count", &Threads::concurrency, "How many, the calling one among them.")
      .def("__repr__", [](const Threads& t) { return "graze.Threads(" + std::to_string(t.concurrency()) + ")"; });
}

}  // namespace graze::python
