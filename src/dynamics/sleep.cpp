// Sleep of islands in which nothing has moved for a while. A body that sleeps does not move, so the world finds it
// unchanged, and its contacts keep their impulses for the moment in which it wakes.
#include <algorithm>

#include "dynamics/simulation_parts.hpp"

namespace graze {

namespace {

/// The speed that counts as rest, as a part of that of a fall through half a body's size: 1 cm/s of a box of 1 m on
/// earth.
template <class T>
constexpr T resting_speed = T(0.003);

/// The time for which a body has to be slow, in times of such a fall: half a second of a box of 1 m on earth.
template <class T>
constexpr T resting_time = T(1.6);

/// The least number of steps for which a body has to be slow.
template <class T>
constexpr T resting_steps = T(10);

}  // namespace

template <class T, class Space>
void SimulationParts<T, Space>::wake(std::uint32_t index) {
  bodies[index].asleep = false;
  bodies[index].rested = T(0);
}

template <class T, class Space>
void SimulationParts<T, Space>::wake_around(std::uint32_t index) {
  wake(index);
  if (world.bodies().triggers()[index] == 0)  // which nothing rests on
    for (const ContactPair<T>& pair : world.contacts().pairs) {
      if (pair.manifold_count == 0) continue;  // of a trigger
      if (pair.a == index) wake(pair.b);
      if (pair.b == index) wake(pair.a);
    }
  for (const JointPlace<T, Space>& joint : joints) {
    if (!joint.alive || (joint.in_place.a != index && joint.in_place.b != index)) continue;
    wake(joint.in_place.a);
    wake(joint.in_place.b);
  }
}

/// Whether a link moves its bodies for as long as they are awake, however slowly: a surface of one of them runs, as a
/// belt's does, or a drive has a speed to keep.
template <class T, class Space>
bool SimulationParts<T, Space>::is_driven(std::uint32_t link) const {
  const ContactPair<T>* pair = contact_of(link);
  const auto runs = [&](std::uint32_t i) {
    return bodies[i].any_material(
        [](const auto& material) { return !(material.surface_velocity == typename Space::Vec{}); });
  };
  if (pair) return runs(pair->a) || runs(pair->b);
  const std::vector<JointDrive<T>>& drives = joint_of(link).joint.drives;
  return std::any_of(drives.begin(), drives.end(), [](const JointDrive<T>& d) { return d.velocity_target != T(0); });
}

template <class T, class Space>
void SimulationParts<T, Space>::put_to_sleep(T dt) {
  if (!settings.sleep) return;
  const Scales<T> scale = scales(dt);
  for (std::size_t k = 0; k < awake.size(); ++k) {
    if (awake[k] == 0) continue;
    const auto members = islands.bodies_of(islands.ranges()[k]);
    const auto links_here = islands.links_of(islands.ranges()[k]);
    bool still = std::none_of(links_here.begin(), links_here.end(), [&](std::uint32_t l) { return is_driven(l); });
    const bool held = std::any_of(links_here.begin(), links_here.end(), [&](std::uint32_t l) {
      return movable[links[l].a] == 0 || movable[links[l].b] == 0;
    });
    for (const std::uint32_t i : members) {
      SimulatedBody<T, Space>& body = bodies[i];
      const MotionIn<Space> m = motion(i);
      const T speed = length(m.linear) + length(m.angular) * body.radius;
      body.rested = speed < resting_speed<T> * scale.speed(body.size) ? body.rested + dt : T(0);
      const T long_enough = greatest(resting_time<T> * scale.time(body.size), resting_steps<T> * dt);
      still = still && body.may_sleep && body.rested >= long_enough;
      // Bodies that nothing immovable holds go on, however slowly: they have a momentum to keep.
      still = still && (held || speed == T(0));
    }
    if (!still) continue;
    for (const std::uint32_t i : members) {
      SimulatedBody<T, Space>& body = bodies[i];
      body.asleep = true;
      body.free.linear = {};
      body.free.angular_momentum = {};
      const BodyId id = world.bodies().id(i);
      world.move(id, pose_of(i), {}, {});
    }
  }
}

#define GRAZE_SLEEP(T, Space)                                                                                          \
  template void SimulationParts<T, Space>::wake(std::uint32_t);                                                        \
  template void SimulationParts<T, Space>::wake_around(std::uint32_t);                                                 \
  template bool SimulationParts<T, Space>::is_driven(std::uint32_t) const;                                             \
  template void SimulationParts<T, Space>::put_to_sleep(T);
GRAZE_SLEEP(float, Space<float>)
GRAZE_SLEEP(double, Space<double>)
GRAZE_SLEEP(float, plane::Space<float>)
GRAZE_SLEEP(double, plane::Space<double>)
#undef GRAZE_SLEEP

}  // namespace graze
