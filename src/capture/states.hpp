// The states that a captured simulation keeps.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "graze/capture.hpp"
#include "graze/error.hpp"

namespace graze {

template <class T, class Space>
struct CapturedStates {
  static constexpr std::size_t most = CapturedSimulation<T, Space>::most_states;
  std::array<std::optional<State<T, Space>>, most> states;

  void save(std::size_t number, const Simulation<T, Space>& simulation) { of(number) = simulation.save(); }
  void restore(std::size_t number, Simulation<T, Space>& simulation) {
    const auto& state = of(number);
    if (!state) throw InvalidValue("number", "that of a state that was saved", std::to_string(number));
    simulation.restore(*state);
  }

 private:
  std::optional<State<T, Space>>& of(std::size_t number) {
    if (number >= most) throw InvalidValue("number", "below " + std::to_string(most), std::to_string(number));
    return states[number];
  }
};

}  // namespace graze
