// Continuous collision: a body that moved in a step by more than half of what its centre of mass is deep in it is asked
// what it met on the way.
//
// A body that met something is held back at the moment of contact, and goes on from there in the next step, which finds
// the contact. Both of two that move are asked by `World::find_impacts`, turning included, so that rods do not pass
// posts nor bullets each other. Bodies that hard joints hold together are held back together, at the first contact that
// any of them makes: alone it would be torn off the others, which gives them energy when they pull it back. Nor is a
// body that lies on something pushed into it by what strikes it: the two are held back together.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/simulation_parts.hpp"
#include "dynamics/sinking.hpp"

namespace graze {

namespace {

/// The part of what the centre of mass is deep in a body that it may move in a step before it is asked.
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

/// The part of what gravity `g` gave a body in the time `late` that is taken from its velocity v where it is set back
/// by `way`, so that it keeps its energy: v becomes v - part · g late. All of it where the body flew freely, nothing
/// where it neither rose nor fell.
template <class T, class Vec>
T part_given_back(const Vec& v, const Vec& g, const Vec& way, T late) {
  // Half of |g late|² part² - 2 v · g late part + 2 g · way = 0.
  const Vec gained = g * late;
  const T a = dot(gained, gained) / T(2), b = dot(v, gained), c = dot(g, way);
  if (!(a > T(0)) || (c > T(0) && !(b > T(0)))) return T(0);
  const T root = std::sqrt(greatest(T(0), b * b - T(4) * a * c));
  return least(T(1), c > T(0) ? T(2) * c / (b + root) : (b + root) / (T(2) * a));
}

/// The velocity of a body that was at v and is carried by `way` under gravity `g`, its energy kept: lifted, it loses
/// speed along g, and all of that where it has too little.
template <class T, class Vec>
Vec keeping_energy(const Vec& v, const Vec& g, const Vec& way) {
  // Half of g² x² - v · g x - g · way = 0 for v - x g, of its roots the one nearer to nothing.
  const T a = dot(g, g) / T(2), b = dot(v, g), c = -dot(g, way);
  if (c == T(0)) return v;
  const T square = b * b - T(4) * a * c;
  if (!(square > T(0))) return v - g * (b / (T(2) * a));
  const T root = std::sqrt(square);
  return v - g * (T(2) * c / (b < T(0) ? b - root : b + root));
}

/// Whether a joint holds anything without giving way.
template <class T, class Space>
bool is_hard(const Joint<T, Space>& joint) {
  return std::any_of(joint.limits.begin(), joint.limits.end(),
                     [](const JointLimit<T>& limit) { return !limit.stiffness; });
}

/// Gives bodies that are joined the earliest of their `ends`. Returns which bodies are joined to anything.
template <class T, class Space>
std::vector<std::uint8_t> end_together(const SimulationParts<T, Space>& parts, std::span<T> ends) {
  std::vector<std::uint8_t> joined(parts.bodies.size(), 0);
  std::vector<IslandLink> links;
  for (const JointPlace<T, Space>& place : parts.joints) {
    if (!place.alive || !is_hard(place.in_place.joint)) continue;
    const std::uint32_t a = place.in_place.a, b = place.in_place.b;
    if (parts.movable[a] == 0 && parts.movable[b] == 0) continue;
    links.push_back({a, b});
    for (const std::uint32_t i : {a, b}) joined[i] |= parts.movable[i];
  }
  if (links.empty()) return joined;
  Islands groups;
  groups.find(joined, links);
  for (const Islands::Range& group : groups.ranges()) {
    T first = std::numeric_limits<T>::infinity();
    for (const std::uint32_t i : groups.bodies_of(group)) first = least(first, ends[i]);
    for (const std::uint32_t i : groups.bodies_of(group)) ends[i] = first;
  }
  return joined;
}

/// How a body that is held back came to where it was.
template <class Space>
struct HeldBody {
  bool joined, pushed;             ///< by a hard joint; by contacts or joints, in this step
  typename Space::Vec carried_by;  ///< how far from its own way, by what it met and goes on
};

/// Puts a body where it was `late` ago. What flew freely has the speed that it had then, and no more from a fall that
/// was not.
template <class T, class Space>
void set_back(SimulationParts<T, Space>& parts, std::uint32_t index, const typename Space::Pose& at, T late,
              const HeldBody<Space>& held) {
  SimulatedBody<T, Space>& body = parts.bodies[index];
  const MotionIn<Space> end = parts.motion(index);
  const typename Space::Vec acceleration = parts.settings.gravity * body.gravity_factor;
  parts.place(index, at, {});
  T part = held.pushed ? T(0) : T(1);
  if (held.joined) part = part_given_back<T>(end.linear, acceleration, end.center - body.free.center, late);
  body.free.linear = part > T(0) ? end.linear - acceleration * (late * part) : end.linear;
  body.free.linear = keeping_energy<T>(body.free.linear, acceleration, held.carried_by);
  set_angular_velocity(body.free, end.angular);
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
    if (way > unasked_motion<T> * body.depth) fast.push_back(i);
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
    // that sinks beside the points that touch goes on by a part of what it may, or it would hang there.
    T time = impact.hit.t;
    if (met<T, Space>(world.contacts(), a, b)) {
      const MovingPair<T, Space> pair{
          world.bodies().shapes()[a], world.bodies().shapes()[b], found_at[a], found_at[b], mean[a], mean[b]};
      const T most = unasked_motion<T> * least(bodies[a].depth, bodies[b].depth);
      const T way = dot(mean[a].linear - mean[b].linear, impact.hit.normal) * dt;
      const std::optional<T> sunk = time_to_sink(pair, most, dt);
      time = greatest(time, sunk ? *sunk : way > most ? dt * (most / way) : dt);
    }
    for (const std::uint32_t i : {a, b})
      if (bodies[i].movable && time < first[i].time)
        first[i] = {time, i == a ? b : a, impact.hit.point, impact.hit.normal};
  }
  std::vector<T> ends(bodies.size(), dt);
  for (const std::uint32_t i : fast) {
    world.set_fast(world.bodies().id(i), false);
    ends[i] = first[i].time;
    any = any || ends[i] < dt;
  }
  if (!any) return;
  const std::vector<std::uint8_t> pushed = pushed_bodies(*this);
  for (const std::uint32_t i : fast) {
    const std::uint32_t other = first[i].other;
    if (ends[i] < dt && pushed[i] != 0 && bodies[other].movable) ends[other] = least(ends[other], first[i].time);
  }
  const std::vector<std::uint8_t> joined = end_together<T, Space>(*this, ends);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!(ends[i] < dt)) continue;
    ++last.stopped;
    typename Space::Pose at = pose_at(found_at[i], mean[i], ends[i]);
    typename Space::Vec carried_by{};
    if (joined[i] == 0) {  // What it met may go on: it stays in touch, along the normal.
      const Meeting<T, Space>& meeting = first[i];
      const typename Space::Vec carried = speed_of(meeting.other, meeting.point, meeting.time);
      const T rest = greatest(T(0), ends[meeting.other] - meeting.time);
      carried_by = meeting.normal * (dot(carried, meeting.normal) * rest);
      at.translation += carried_by;
    }
    set_back<T, Space>(*this, i, at, dt - ends[i], {joined[i] != 0, pushed[i] != 0, carried_by});
  }
}

#define GRAZE_HOLD_BACK(T, Space) template void SimulationParts<T, Space>::hold_back(T);
GRAZE_HOLD_BACK(float, Space<float>)
GRAZE_HOLD_BACK(double, Space<double>)
GRAZE_HOLD_BACK(float, plane::Space<float>)
GRAZE_HOLD_BACK(double, plane::Space<double>)
#undef GRAZE_HOLD_BACK

}  // namespace graze
