// Memory of answers that nobody holds any more, for the next ones: fresh pages cost as much as many answers.
//
// Guarantee: of each type of record two arrays are kept, for one answer is often held until the next is there, of 32 MB
// each at most. Used with the interpreter's lock held.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "convert.hpp"

namespace graze::python {

/// The arrays that are kept, the larger one first. They are never destroyed: arrays of Python may outlive the module's
/// objects.
template <class Record>
std::array<std::vector<Record>, 2>& spares() {
  static auto* const kept = new std::array<std::vector<Record>, 2>();
  return *kept;
}

/// Keeps an array's memory if it is more than one that is kept.
template <class Record>
void keep_spare(std::vector<Record>& given) {
  constexpr std::size_t most_bytes = 32u << 20;
  if (given.capacity() > most_bytes / sizeof(Record)) return;
  for (std::vector<Record>& kept : spares<Record>())
    if (given.capacity() > kept.capacity()) kept.swap(given);
}

/// The larger array that is kept, with what was in it.
template <class Record>
std::vector<Record> taken_spare() {
  auto& kept = spares<Record>();
  std::vector<Record> taken = std::exchange(kept[0], {});
  kept[0].swap(kept[1]);
  return taken;
}

/// Calls `f` for each array of the answers.
template <class Answers, class F>
void each_array(Answers& answers, const F& f) {
  if constexpr (requires { answers.capacity(); }) {
    f(answers);
  } else if constexpr (requires { answers.points; }) {
    if constexpr (requires { answers.pairs; }) f(answers.pairs);
    f(answers.manifolds);
    f(answers.points);
  } else {
    f(answers.all);
    f(answers.ends);
  }
}

/// Answers whose arrays have the memory that is kept, and in it what was there.
template <class Answers>
Answers spare_of() {
  Answers answers;
  each_array(answers, []<class Record>(std::vector<Record>& array) { array = taken_spare<Record>(); });
  return answers;
}

/// Puts the elements of an array behind those of another.
template <class Record>
void behind(std::vector<Record>& all, const std::vector<Record>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

/// An array's elements as an array of Python that owns them. Nothing is copied but what takes less than half of its
/// memory: small answers that are held for long would keep that of large ones.
template <class Record>
py::array records(std::vector<Record>&& values, const py::dtype& type) {
  if (values.size() < values.capacity() / 2) {
    std::vector<Record> small(values.begin(), values.end());
    keep_spare(values);
    values = std::move(small);
  }
  auto kept = std::make_unique<std::vector<Record>>(std::move(values));
  const auto size = static_cast<py::ssize_t>(kept->size());
  const Record* data = kept->data();
  py::capsule owner(kept.get(), [](void* p) {
    const std::unique_ptr<std::vector<Record>> freed(static_cast<std::vector<Record>*>(p));
    keep_spare(*freed);
  });
  static_cast<void>(kept.release());
  return py::array(type, {size}, {static_cast<py::ssize_t>(sizeof(Record))}, data, owner);
}

}  // namespace graze::python
