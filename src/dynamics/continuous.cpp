// Continuous collision: casts of the bodies that moved in a step by more than half of the depth of their centre of
// mass.
//
// A body that met something is held back at the moment of contact, and goes on from there in the next step, which finds
// the contact. `World::find_impacts` casts both of two that move, turning included, so that rods do not pass posts nor
// bullets each other. Bodies that hard joints hold together are held back together, at the first contact that any of
// them makes: alone it would be torn off the others, which gives them energy when they pull it back. A body that lies
// on something is held back together with the body that strikes it and would push it in.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/simulation_parts.hpp"
#include "dynamics/sinking.hpp"

namespace graze {

namespace {

/// The part of the depth of its centre of mass that a body may move in a step without a cast.
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

/// The first contact of a body in a step.
template <class T, class Space>
struct Meeting {
  T time{};
  std::uint32_t other{};
  typename Space::Vec point{}, normal{};
};

/// A flag for each body that contacts or joints pushed in this step.
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
  if (c == T(0) || !(a > T(0))) return v;
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

/// The way by which a body that is held back came to where it was.
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

/// The bodies that may have passed through something in this step.
template <class T, class Space>
std::vector<std::uint32_t> fast_bodies(const SimulationParts<T, Space>& parts, T dt) {
  const auto alive = parts.world.bodies().alive();
  std::vector<std::uint32_t> fast;
  for (std::uint32_t i = 0; i < parts.bodies.size(); ++i) {
    const SimulatedBody<T, Space>& body = parts.bodies[i];
    if (alive[i] == 0 || !body.movable || body.asleep) continue;
    const MotionIn<Space> m = parts.motion(i);
    const T way = (length(m.linear) + length(m.angular) * body.radius) * dt;
    if (way > unasked_motion<T> * body.depth) fast.push_back(i);
  }
  return fast;
}

/// The time at which an impact holds its bodies back, `dt` for one that does not. Rows of contacts let bodies approach
/// little: a body that slides fast is not held back by the one it slides on. A body that sinks beside the points of
/// contact goes on by a part of what it may, or it would hang there.
template <class T, class Space>
T holding_time(const SimulationParts<T, Space>& parts, const Impact<T, Space>& impact,
               std::span<const typename Space::Velocity> mean, T dt) {
  const std::uint32_t a = impact.a.index, b = impact.b.index;
  if (!met<T, Space>(parts.world.contacts(), a, b)) return impact.hit.t;
  const auto shapes = parts.world.bodies().shapes();
  const MovingPair<T, Space> pair{shapes[a], shapes[b], parts.found_at[a], parts.found_at[b], mean[a], mean[b]};
  const T most = unasked_motion<T> * least(parts.bodies[a].depth, parts.bodies[b].depth);
  const T way = dot(mean[a].linear - mean[b].linear, impact.hit.normal) * dt;
  const std::optional<T> sunk = time_to_sink(pair, most, dt);
  return greatest(impact.hit.t, sunk ? *sunk : way > most ? dt * (most / way) : dt);
}

}  // namespace

template <class T, class Space>
void SimulationParts<T, Space>::hold_back(T dt) {
  const std::vector<std::uint32_t> fast = fast_bodies(*this, dt);
  if (fast.empty()) return;
  const auto alive = world.bodies().alive();
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
  for (const std::uint32_t i : fast) world.set_fast(world.bodies().id(i), false);
  std::vector<Meeting<T, Space>> first(bodies.size(), Meeting<T, Space>{dt});
  for (const Impact<T, Space>& impact : world.impacts()) {
    if (impact.trigger) continue;
    const std::uint32_t a = impact.a.index, b = impact.b.index;
    const T time = holding_time<T, Space>(*this, impact, mean, dt);
    for (const std::uint32_t i : {a, b})
      if (bodies[i].movable && time < first[i].time)
        first[i] = {time, i == a ? b : a, impact.hit.point, impact.hit.normal};
  }
  if (std::none_of(fast.begin(), fast.end(), [&](std::uint32_t i) { return first[i].time < dt; })) return;
  const std::vector<std::uint8_t> pushed = pushed_bodies(*this);
  std::vector<T> ends(bodies.size(), dt);
  for (const std::uint32_t i : fast) {
    if (!(first[i].time < dt)) continue;
    ends[i] = first[i].time;
    const std::uint32_t striking = first[i].other;
    if (pushed[i] != 0 && bodies[striking].movable) ends[striking] = first[striking].time;
  }
  const std::vector<std::uint8_t> joined = end_together<T, Space>(*this, ends);
  // The velocity of a body's material point at a place and a time of the step.
  const auto speed_of = [&](std::uint32_t i, const typename Space::Vec& point, T time) {
    return mean[i].linear + cross(mean[i].angular, point - (found_at[i].translation + mean[i].linear * time));
  };
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!(ends[i] < dt)) continue;
    ++last.stopped;
    typename Space::Pose at = pose_at(found_at[i], mean[i], ends[i]);
    typename Space::Vec carried_by{};
    if (joined[i] == 0) {  // The body it met may go on: it stays in touch, along the normal.
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
