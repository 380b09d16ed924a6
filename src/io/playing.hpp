// The loop of a simulation that is played frame by frame, of space or of the plane, and its summary.
#pragma once

#include <algorithm>

#include "graze/io/simulate.hpp"

namespace graze::io {

/// Steps `simulated` through all frames of `options` and calls `each` with each frame, the first at time 0. The members
/// of the summary about the scene (bodies, joints, notices) are left to the caller.
template <class Simulated, class Each>
SimulateSummary play(Simulated& simulated, const SimulateOptions& options, const Each& each) {
  const std::size_t frames = frame_count(options);
  SimulateSummary summary;
  auto frame = simulated.frame(0);
  summary.first_energy = frame.kinetic_energy + frame.potential_energy;
  each(frame);
  for (std::size_t i = 1; i < frames; ++i) {
    const double time = static_cast<double>(i) / options.rate;
    simulated.step(time, 1 / options.rate);
    const double before = static_cast<double>(i - 1) / options.rate;  // contacts are those that a step begins with
    simulated.note_triggers(before, summary.triggers);
    frame = simulated.frame(time);
    each(frame);
    const auto r = simulated.report();
    summary.collide_ms += r.collide_ms;
    summary.prepare_ms += r.prepare_ms;
    summary.solve_ms += r.solve_ms;
    summary.continuous_ms += r.continuous_ms;
    summary.whole_ms += r.whole_ms;
    summary.slowest_ms = std::max(summary.slowest_ms, r.whole_ms);
    summary.most_sub_steps = std::max(summary.most_sub_steps, r.most_sub_steps);
    if (const auto depth = static_cast<double>(r.deepest); depth > summary.deepest) {
      summary.deepest = depth;
      summary.deepest_time = before;
    }
  }
  summary.steps = frames - 1;
  if (summary.steps > 0)
    for (double* ms :
         {&summary.collide_ms, &summary.prepare_ms, &summary.solve_ms, &summary.continuous_ms, &summary.whole_ms})
      *ms /= static_cast<double>(summary.steps);
  summary.kinetic_energy = frame.kinetic_energy;
  summary.potential_energy = frame.potential_energy;
  summary.awake = simulated.awake();
  return summary;
}

}  // namespace graze::io
