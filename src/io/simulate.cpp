#include "graze/io/simulate.hpp"

#include <cmath>

#include "io/playing.hpp"
#include "io/simulated_scene.hpp"

namespace graze::io {

namespace {

template <class T>
SimulateSummary play_in(const Scene& scene, const SimulateOptions& options,
                        const std::function<void(const SimulationFrame&)>& each) {
  frame_count(options);  // refused before anything is built
  SimulatedScene<T> simulated(scene, options);
  SimulateSummary summary = play(simulated, options, each);
  summary.bodies = moving_bodies(scene).size();
  summary.joints = simulated.joints();
  summary.notices = simulated.notices();
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
  return options.precision == Precision::double_precision ? play_in<double>(scene, options, each)
                                                          : play_in<float>(scene, options, each);
}

}  // namespace graze::io
