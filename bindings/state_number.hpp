// The numbers under which a captured simulation keeps its states, as objects of the languages that have handles.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "graze/capture.hpp"
#include "graze/detail/validate.hpp"

namespace graze {

/// The numbers of a simulation's states that belong to handles.
using TakenNumbers = std::shared_ptr<std::array<bool, CapturedSimulation<double>::most_states>>;

/// The number of a kept state, free again when the handle that has it ends; or none.
struct StateNumber {
  TakenNumbers of;
  std::size_t number = 0;

  StateNumber() = default;
  /// Takes a free number. Throws `InvalidValue` where all are taken.
  explicit StateNumber(const TakenNumbers& taken) : of(taken) {
    const auto free = std::find(taken->begin(), taken->end(), false);
    if (free == taken->end())
      validate::fail("simulation", "at most 16 states of a captured simulation at a time", "one more");
    *free = true;
    number = static_cast<std::size_t>(free - taken->begin());
  }
  StateNumber(StateNumber&& other) noexcept : of(std::move(other.of)), number(other.number) {}
  StateNumber& operator=(StateNumber&& other) noexcept {
    std::swap(of, other.of), std::swap(number, other.number);
    return *this;
  }
  ~StateNumber() {
    if (of) (*of)[number] = false;
  }

  /// Checks the simulation. Throws `InvalidValue` for the state of another one.
  void check(const TakenNumbers& simulation) const {
    if (of != simulation)
      validate::fail("state", "one of this simulation", "one of another, which is captured or where this one is");
  }
};

}  // namespace graze
