// The data of a saved state.
//
// Guarantee: plain values, none of which belongs to the simulation that saved them. Arrays by index of body are as long
// as each other; of a state from bytes `read_state` checks that.
#pragma once

#include "dynamics/simulation_parts.hpp"

namespace graze {

template <class T, class Space>
struct State<T, Space>::Kept {
  std::vector<SimulatedBody<T, Space>> bodies;
  std::vector<JointPlace<T, Space>> joints;
  std::vector<BodyId> ids;           ///< of the bodies that are there, by index
  std::vector<std::uint32_t> kinds;  ///< of the shapes, by index of body
  std::vector<typename Space::Pose> poses, found_at;
  std::vector<typename Space::Vec> linear;
  std::vector<typename Space::Turning> angular;
  std::vector<typename Space::Vec> impulses;  ///< in the order of pairs
  std::vector<RollingImpulse<typename Space::Turning>> rolling;
  std::vector<ContactEvent> events;  ///< of the last step; their pairs are found anew
  SimulationSettings<T, Space> settings;
  StepReport<T, Space> last;
  T last_step{}, usual_step{};
};

}  // namespace graze
