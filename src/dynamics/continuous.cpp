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

/// What a body meets first.
template <class T, class Space>
struct Meeting {
  T time{};
  std::uint32_t other{};
  typename Space::Vec point{}, normal{};
};

/// Which bodies contacts or joints pushed in this step.
template <class T, class Space>
std::vector<std::uint8_t> pushed_bodies(const SimulationParts<T, Space>& parts) {
  std::vector<std::uint8_t> pushed(parts.bodies.size(), 0);
  const ContactArrays<T, Space>& contacts = parts.world.contacts();
  for (const ContactPair<T>& pair : contacts.pairs)
    for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair))
      for (const SolverPoint<T, Space>& p : contacts.points_of(m))
        if (!(p.impulse == typename Space::Vec{})) pushed[pair.a] = pushed[pair.b] = 1;
  for (const JointPlace<T, Space>& joint : parts.joints)
    if (joint.alive) pushed[joint.in_place.a] = pushed[joint.in_place.b] = 1;
  return pushed;
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
  // Of a body's material point at a place and a time of the step.
  const auto speed_of = [&](std::uint32_t i, const typename Space::Vec& point, T time) {
    return mean[i].linear + cross(mean[i].angular, point - (found_at[i].translation + mean[i].linear * time));
  };
  std::vector<Meeting<T, Space>> first(bodies.size(), Meeting<T, Space>{dt});
  bool any = false;
  for (const Impact<T, Space>& impact : world.impacts()) {
    const std::uint32_t a = impact.a.index, b = impact.b.index;
    if (impact.trigger) continue;
    // Rows of contacts let bodies approach little; a body that slides fast is not held back by what it slides on. One
    // that turns may come down beside the point that touches and is left: it goes on by as much as nobody asks about,
    // or it would hang there.
    T time = impact.hit.t;
    if (met<T, Space>(world.contacts(), a, b)) {
      const T unasked = unasked_motion<T> * least(bodies[a].size, bodies[b].size) / T(2);
      const T way = dot(mean[a].linear - mean[b].linear, impact.hit.normal) * dt;
      if (way < unasked) continue;
      const auto closing = speed_of(a, impact.hit.point, time) - speed_of(b, impact.hit.point, time);
      if (dot(closing, impact.hit.normal) * dt < unasked) time = greatest(time, dt * (unasked / way));
    }
    for (const std::uint32_t i : {a, b})
      if (bodies[i].movable && time < first[i].time)
        first[i] = {time, i == a ? b : a, impact.hit.point, impact.hit.normal};
  }
  for (const std::uint32_t i : fast) {
    world.set_fast(world.bodies().id(i), false);
    any = any || first[i].time < dt;
  }
  if (!any) return;
  const std::vector<std::uint8_t> pushed = pushed_bodies(*this);
  const auto end_of = [&](std::uint32_t i) {
    return std::binary_search(fast.begin(), fast.end(), i) ? first[i].time : dt;
  };
  for (const std::uint32_t i : fast) {
    const Meeting<T, Space>& meeting = first[i];
    if (!(meeting.time < dt)) continue;
    ++last.stopped;
    typename Space::Pose at = pose_at(found_at[i], mean[i], meeting.time);
    // What it met may go on: it stays in touch, along the normal.
    const typename Space::Vec carried = speed_of(meeting.other, meeting.point, meeting.time);
    const T rest = greatest(T(0), end_of(meeting.other) - meeting.time);
    at.translation += meeting.normal * (dot(carried, meeting.normal) * rest);
    SimulatedBody<T, Space>& body = bodies[i];
    const typename Space::Turning angular = motion(i).angular;
    typename Space::Vec linear = body.free.linear;
    // What flew freely has the speed that it had then, and no more from a fall that was not.
    if (pushed[i] == 0) linear -= (settings.gravity * body.gravity_factor) * (dt - meeting.time);
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
