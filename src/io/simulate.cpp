#include "graze/io/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "io/simulated_scene.hpp"

namespace graze::io {

namespace {

template <class T>
SimulateSummary play(const Scene& scene, const SimulateOptions& options,
                     const std::function<void(const SimulationFrame&)>& each) {
  const std::size_t frames = frame_count(options);
  SimulatedScene<T> simulated(scene, options);
  SimulateSummary summary;
  summary.bodies = moving_bodies(scene).size();
  summary.joints = simulated.joints();
  summary.notices = simulated.notices();
  SimulationFrame frame = simulated.frame(0);
  summary.first_energy = frame.kinetic_energy + frame.potential_energy;
  each(frame);
  for (std::size_t i = 1; i < frames; ++i) {
    const double time = static_cast<double>(i) / options.rate;
    simulated.step(time, 1 / options.rate);
    frame = simulated.frame(time);
    each(frame);
    const StepReport<T> r = simulated.report();
    summary.collide_ms += r.collide_ms;
    summary.prepare_ms += r.prepare_ms;
    summary.solve_ms += r.solve_ms;
    summary.continuous_ms += r.continuous_ms;
    summary.whole_ms += r.whole_ms;
    summary.slowest_ms = std::max(summary.slowest_ms, r.whole_ms);
    summary.most_sub_steps = std::max(summary.most_sub_steps, r.most_sub_steps);
    if (const auto depth = static_cast<double>(r.deepest); depth > summary.deepest) {
      summary.deepest = depth;
      summary.deepest_time = static_cast<double>(i - 1) / options.rate;  // contacts are those that a step begins with
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

}  // namespace

std::size_t frame_count(const SimulateOptions& options) {
  if (!(options.seconds >= 0) || !std::isfinite(options.seconds))
    validate::fail("seconds", "a finite number >= 0", options.seconds);
  if (!(options.rate >= 1) || !std::isfinite(options.rate))
    validate::fail("rate", "a finite number >= 1", options.rate);
  // The product of a decimal fraction and a rate may be a rounding below a whole number.
  const double last = std::floor(options.seconds * options.rate * (1 + 4 * std::numeric_limits<double>::epsilon()));
  if (!(last < most_frames))
    throw InvalidValue("seconds", "at most " + validate::number(most_frames) + " frames in all",
                       validate::number(options.seconds) + " s of " + validate::number(options.rate) + " a second");
  return static_cast<std::size_t>(last) + 1;
}

SimulateSummary simulate(const Scene& scene, const SimulateOptions& options,
                         const std::function<void(const SimulationFrame&)>& each) {
  return options.precision == Precision::double_precision ? play<double>(scene, options, each)
                                                          : play<float>(scene, options, each);
}

}  // namespace graze::io
