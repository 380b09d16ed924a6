// Worlds and simulations whose calls go into a file.
#pragma once

#include <filesystem>
#include <fstream>

#include "graze/capture.hpp"
#include "graze/error.hpp"
#include "state_number.hpp"

namespace graze::python {

/// The file of a capture. Throws `InvalidValue` for one that cannot be written.
class CaptureFile {
 public:
  explicit CaptureFile(const std::filesystem::path& file) : out_(file, std::ios::binary) {
    if (!out_) throw InvalidValue("file", "one that can be written", file.string());
  }
  std::ostream& stream() { return out_; }

 private:
  std::ofstream out_;
};

/// A `CapturedWorld` or `CapturedSimulation` together with its file.
template <class Captured>
class ToFile : private CaptureFile, public Captured {
 public:
  template <class Settings>
  ToFile(const std::filesystem::path& file, const Settings& settings, Executor* executor)
      : CaptureFile(file), Captured(&stream(), settings, executor) {}
};

/// A captured simulation, whose states are objects of Python.
template <class Space>
class SimulationToFile : public ToFile<CapturedSimulation<double, Space>> {
 public:
  using ToFile<CapturedSimulation<double, Space>>::ToFile;

  StateNumber save() {
    StateNumber kept(states_);
    CapturedSimulation<double, Space>::save(kept.number);
    return kept;
  }
  void restore(const StateNumber& state) {
    state.check(states_);
    CapturedSimulation<double, Space>::restore(state.number);
  }

 private:
  TakenNumbers states_ = std::make_shared<TakenNumbers::element_type>();
};

// The world or simulation for queries, where changes may go through a capture.
template <class T, class Space>
const World<T, Space>& asked(const World<T, Space>& world) {
  return world;
}
template <class T, class Space>
const World<T, Space>& asked(const CapturedWorld<T, Space>& world) {
  return world.world();
}
template <class T, class Space>
const Simulation<T, Space>& asked(const Simulation<T, Space>& simulation) {
  return simulation;
}
template <class T, class Space>
const Simulation<T, Space>& asked(const CapturedSimulation<T, Space>& simulation) {
  return simulation.simulation();
}

}  // namespace graze::python
