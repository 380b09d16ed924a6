// Continuous collision: what moved by more than half of its size's half in a step is asked what it met on the way.
//
// A body that met something is held back at the moment of contact, and goes on from there in the next step, which finds
// the contact. Both of two that move are asked by `World::find_impacts`, turning included, so that rods do not pass
// posts nor bullets each other.
#include <algorithm>

#include "dynamics/simulation_parts.hpp"

namespace graze {

namespace {

/// Of half of its size: what a body may move in a step before it is asked.
template <class T>
constexpr T unasked_motion = T(0.5);

/// The constant velocity that takes a body from where the step found it to where it is.
template <class T, class Space>
typename Space::Velocity mean_velocity(const typename Space::Pose& from, const typename Space::Pose& to, T dt) {
  return {(to.translation - from.translation) / dt, turning_between(from.rotation, to.rotation, dt)};
}

/// Whether the step had contacts of the two.
template <class T, class Space>
bool met(const ContactArrays<T, Space>& contacts, std::uint32_t a, std::uint32_t b) {
  const auto at = std::lower_bound(contacts.pairs.begin(), contacts.pairs.end(), IdPair{a, b},
                                   [](const ContactPair<T>& pair, const IdPair& wanted) {
                                     return IdPair{pair.a, pair.b} < wanted;
                                   });
  return at != contacts.pairs.end() && at->a == a && at->b == b && at->manifold_count != 0;
}

}  // namespace

template <class T, class Space>
void SimulationParts<T, Space>::hold_back(T dt) {
  const auto alive = world.bodies().alive();
  std::vector<std::uint32_t> fast;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    const SimulatedBody<T, Space>& body = bodies[i];
    if (alive[i] == 0 || !body.movable || body.asleep) continue;
    const MotionIn<Space> m = motion(i);
    const T way = (length(m.linear) + length(m.angular) * body.radius) * dt;
    if (way > unasked_motion<T> * body.size / T(2)) fast.push_back(i);
  }
  if (fast.empty()) return;
  std::vector<typename Space::Velocity> mean(bodies.size());
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (alive[i] == 0 || !bodies[i].moves || bodies[i].asleep) continue;
    mean[i] = mean_velocity<T, Space>(found_at[i], pose_of(i), dt);
    const T reached = greatest(max_abs(mean[i].linear), max_abs(mean[i].angular));
    if (!(reached <= largest_magnitude<T>)) mean[i] = {};
    world.move(world.bodies().id(i), found_at[i], mean[i].linear, mean[i].angular);
  }
  for (const std::uint32_t i : fast) world.set_fast(world.bodies().id(i), true);
  world.find_impacts(dt);
  std::vector<T> until(bodies.size(), dt);
  for (const Impact<T, Space>& impact : world.impacts()) {
    const std::uint32_t a = impact.a.index, b = impact.b.index;
    // Rows of contacts let bodies approach little; a body that slides fast is not held back by what it slides on.
    const T approach = dot(mean[a].linear - mean[b].linear, impact.hit.normal) * dt;
    const bool slow = approach < unasked_motion<T> * least(bodies[a].size, bodies[b].size) / T(2);
    if (impact.trigger || (slow && met<T, Space>(world.contacts(), a, b))) continue;
    for (const std::uint32_t i : {a, b})
      if (bodies[i].movable) until[i] = least(until[i], impact.hit.t);
  }
  for (const std::uint32_t i : fast) {
    world.set_fast(world.bodies().id(i), false);
    if (!(until[i] < dt)) continue;
    ++last.stopped;
    const typename Space::Pose at = pose_at(found_at[i], mean[i], until[i]);
    SimulatedBody<T, Space>& body = bodies[i];
    const typename Space::Turning angular = motion(i).angular;
    const typename Space::Vec linear = body.free.linear;
    place(i, at, {});
    body.free.linear = linear;
    set_angular_velocity(body.free, angular);
  }
}

#define GRAZE_HOLD_BACK(T, Space) template void SimulationParts<T, Space>::hold_back(T);
GRAZE_HOLD_BACK(float, Space<float>)
GRAZE_HOLD_BACK(double, Space<double>)
GRAZE_HOLD_BACK(float, plane::Space<float>)
GRAZE_HOLD_BACK(double, plane::Space<double>)
#undef GRAZE_HOLD_BACK

}  // namespace graze
