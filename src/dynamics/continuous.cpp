// Continuous collision: casts of the bodies that moved in a step by more than half of the depth of their centre of
// mass.
//
// A body that met something is held back at the moment of contact, and goes on from there in the next step, which finds
// the contact. What comes behind it is cast again, as it meets one that stands. `World::find_impacts` casts both of two
// that move, turning included, so that rods do not pass posts nor bullets each other. A body that something fast
// strikes which no blow stops, a kinematic one, is carried along by it to the end of the step. Bodies that hard joints
// hold together are held back together, at the first contact that any of them makes: alone it would be torn off the
// others, which gives them energy when they pull it back. A body that lies on something is held back together with the
// body that strikes it and would push it in.
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

/// The constant velocity that takes a body from where the step found it to where it is, turning about as often as it
/// does at `spin`.
template <class T, class Space>
typename Space::Velocity mean_velocity(const typename Space::Pose& from, const typename Space::Pose& to,
                                       const typename Space::Turning& spin, T dt) {
  const typename Space::Turning turning = turning_between(from.rotation, to.rotation, dt);
  return {(to.translation - from.translation) / dt, by_whole_turns(turning, spin, dt)};
}

/// The part of the motion that needs no cast by which a body that is as deep as that may still sink in a step: less
/// than contacts push it out, but not nothing, or it would hang there.
template <class T>
constexpr T sunk_on = T(0.125);

/// The pair of two bodies, if the step had contacts of them.
template <class T, class Space>
const ContactPair<T>* met(const ContactArrays<T, Space>& contacts, std::uint32_t a, std::uint32_t b) {
  const IdPair ids{std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(contacts.pairs.begin(), contacts.pairs.end(), ids,
                                   [](const ContactPair<T>& pair, const IdPair& wanted) {
                                     return IdPair{pair.a, pair.b} < wanted;
                                   });
  const bool found = at != contacts.pairs.end() && at->a == ids.a && at->b == ids.b && at->manifold_count != 0;
  return found ? &*at : nullptr;
}

/// How deep the two were in each other where the step began.
template <class T, class Space>
T depth_of(const ContactArrays<T, Space>& contacts, const ContactPair<T>& pair) {
  T deepest(0);
  for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair))
    for (const SolverPoint<T, Space>& p : contacts.points_of(m)) deepest = greatest(deepest, -p.distance);
  return deepest;
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

/// Gives bodies that are joined the earliest of their `ends`, and the way by which the one of them is carried whose end
/// that is. Returns which bodies are joined to anything.
template <class T, class Space>
std::vector<std::uint8_t> end_together(const SimulationParts<T, Space>& parts, std::span<T> ends,
                                       std::span<typename Space::Vec> carried) {
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
    const auto members = groups.bodies_of(group);
    const std::uint32_t earliest = *std::min_element(
        members.begin(), members.end(), [&](std::uint32_t i, std::uint32_t j) { return ends[i] < ends[j]; });
    const T first = ends[earliest];
    const typename Space::Vec way = carried[earliest];
    for (const std::uint32_t i : members) {
      ends[i] = first;
      carried[i] = way;
    }
  }
  return joined;
}

/// The way by which a body that is held back came to where it was.
template <class Space>
struct HeldBody {
  bool joined{}, pushed{};           ///< by a hard joint; by contacts or joints, in this step
  bool touched{};                    ///< what holds it back, when the step began
  bool bounces{};                    ///< off that
  typename Space::Vec carried_by{};  ///< how far from its own way, by what it met and goes on
};

/// The angle in a step beyond which a body that is held back by what it touches turns too fast for the steps: its
/// contacts lie elsewhere before they have pushed, so that it is held back in every step and never gets out. The rest
/// of its spin is taken, as by the blows that a shorter step would show.
template <class T>
constexpr T followed_turn = T(1);
/// The angle in a step for a body that is held back and does not bounce, whose spin is no blow's: of 16,500 bodies,
/// round, flat and long, that are thrown down at 20 to 60 m/s, 25 came out below without this.
template <class T>
constexpr T followed_turn_at_rest = T(0.5);

/// The turning of a body before it was set back: what flew freely keeps its angular momentum, what was pushed its
/// angular velocity, which holds for its contacts.
template <class Space>
struct TurningBody {
  typename Space::Turning momentum, angular;
};

/// Turns a body that was set back as it turned before, or more slowly: it gains no energy by standing otherwise, and
/// `most` is the speed that steps can follow.
template <class T, class Space>
void turn_on(FreeBodyIn<Space>& body, const TurningBody<Space>& before, bool flew, T most) {
  if (flew)
    body.angular_momentum = before.momentum;
  else
    set_angular_velocity(body, before.angular);
  const typename Space::Turning angular = angular_velocity(body);
  const T was = dot(before.angular, before.momentum), is = dot(angular, body.angular_momentum), speed = length(angular);
  T part = is > was ? std::sqrt(greatest(T(0), was) / is) : T(1);
  if (speed > most) part = least(part, most / speed);
  if (part < T(1)) body.angular_momentum = body.angular_momentum * part;
}

/// Puts a body where it was `late` ago in a step of `dt`. What flew freely has the speed that it had then, and no more
/// from a fall that was not.
template <class T, class Space>
void set_back(SimulationParts<T, Space>& parts, std::uint32_t index, const typename Space::Pose& at, T late, T dt,
              const HeldBody<Space>& held) {
  SimulatedBody<T, Space>& body = parts.bodies[index];
  const MotionIn<Space> end = parts.motion(index);
  const TurningBody<Space> turning{body.free.angular_momentum, end.angular};
  const typename Space::Vec acceleration = parts.settings.gravity * body.gravity_factor;
  parts.place(index, at, {});
  T part(1);
  if (held.joined || held.pushed)
    part = part_given_back<T>(end.linear, acceleration, end.center - body.free.center, late);
  body.free.linear = part > T(0) ? end.linear - acceleration * (late * part) : end.linear;
  body.free.linear = keeping_energy<T>(body.free.linear, acceleration, held.carried_by);
  const bool in_touch = (held.pushed || held.touched) && !held.joined;
  turn_on<T, Space>(body.free, turning, !held.pushed && !held.joined,
                    !in_touch      ? std::numeric_limits<T>::infinity()
                    : held.bounces ? followed_turn<T> / dt
                                   : followed_turn_at_rest<T> / dt);
}

/// The bodies that may have passed through something in this step, kinematic ones among them: by the way that they have
/// moved, which is long of what a contact stopped at the end of it, or by their velocity. What has no bounds, a
/// half-space that moves, has no other side to come out on.
template <class T, class Space>
std::vector<std::uint32_t> fast_bodies(const SimulationParts<T, Space>& parts, T dt) {
  const auto alive = parts.world.bodies().alive();
  std::vector<std::uint32_t> fast;
  for (std::uint32_t i = 0; i < parts.bodies.size(); ++i) {
    const SimulatedBody<T, Space>& body = parts.bodies[i];
    if (alive[i] == 0 || !body.moves || body.asleep) continue;
    if (!(body.radius <= largest_magnitude<T>)) continue;
    const MotionIn<Space> m = parts.motion(i);
    const FreeBodyIn<Space>& from = parts.before[i];
    const T moved = greatest(length(m.linear) * dt, length(body.free.center - from.center));
    const T turned = dt * greatest(length(m.angular), length(turning_between(from.rotation, body.free.rotation, dt)));
    const T way = moved + turned * body.radius;
    if (way > unasked_motion<T> * body.depth) fast.push_back(i);
  }
  return fast;
}

/// The time at which an impact holds its bodies back, `dt` for one that does not. Two that meet go on where the step
/// takes them no deeper than it may without a cast: the next step finds their contact, as that of slow bodies. Bodies
/// that fall side by side meet all the time, and each that is held back is struck by those behind it. Rows of contacts
/// let bodies approach little: a body that slides fast is not held back by the one it slides on. A body that sinks
/// beside the points of contact goes on by a part of what it may, or it would hang there; so does one that touches
/// another and has no point of contact with it, until it overlaps that, which gives it one.
template <class T, class Space>
T holding_time(const SimulationParts<T, Space>& parts, const Impact<T, Space>& impact,
               std::span<const typename Space::Velocity> mean, T dt) {
  const std::uint32_t a = impact.a.index, b = impact.b.index;
  const ContactPair<T>* pair_met = met<T, Space>(parts.world.contacts(), a, b);
  const auto shapes = parts.world.bodies().shapes();
  const MovingPair<T, Space> pair{shapes[a], shapes[b], parts.found_at[a], parts.found_at[b], mean[a], mean[b]};
  const T most = unasked_motion<T> * least(parts.bodies[a].depth, parts.bodies[b].depth);
  if (!pair_met && impact.hit.t > T(0)) {
    const std::optional<T> sunk = time_to_sink(pair, T(2) * most, dt);
    return sunk && !(*sunk < dt) ? dt : impact.hit.t;
  }
  if (const std::optional<T> sunk = time_to_sink(pair, most, dt)) return greatest(impact.hit.t, *sunk);
  const T depth = pair_met ? depth_of<T, Space>(parts.world.contacts(), *pair_met) : most;
  const T left = greatest(most - depth, most * sunk_on<T>);
  const T way = dot(mean[a].linear - mean[b].linear, impact.hit.normal) * dt;
  return greatest(impact.hit.t, way > left ? dt * (left / way) : dt);
}

/// The velocities that take the bodies of a step from where it found them to where they are, which the world is given
/// for casts; zero for what does not move.
template <class T, class Space>
std::vector<typename Space::Velocity> mean_velocities(SimulationParts<T, Space>& parts, T dt) {
  const auto alive = parts.world.bodies().alive();
  std::vector<typename Space::Velocity> mean(parts.bodies.size());
  for (std::uint32_t i = 0; i < parts.bodies.size(); ++i) {
    if (alive[i] == 0 || !parts.bodies[i].moves || parts.bodies[i].asleep) continue;
    mean[i] = mean_velocity<T, Space>(parts.found_at[i], parts.pose_of(i), parts.motion(i).angular, dt);
    const T reached = greatest(max_abs(mean[i].linear), max_abs(mean[i].angular));
    if (!(reached <= largest_magnitude<T>)) mean[i] = {};
    parts.world.move(parts.world.bodies().id(i), parts.found_at[i], mean[i].linear, mean[i].angular);
  }
  return mean;
}

/// The first contacts of the bodies of a step, and the times at which these are held back, `dt` for those that are not.
template <class T, class Space>
struct Meetings {
  std::vector<Meeting<T, Space>> first;
  std::vector<T> ends;
};

/// Casts the bodies whose ways are new. The fast ones are held back by what they meet before `until`, and what they
/// meet by those that cannot be. What flies freely is held back with what it meets, fast or not: both end on their own
/// ways, along their velocities, which keeps their angular momentum. `pushed`: by contacts or joints, in this step; a
/// sleeper that is struck becomes so.
template <class T, class Space>
Meetings<T, Space> find_meetings(SimulationParts<T, Space>& parts, std::span<const std::uint32_t> fast,
                                 std::span<const std::uint32_t> anew, std::span<const typename Space::Velocity> mean,
                                 std::span<std::uint8_t> pushed, T dt, T until) {
  const std::size_t count = parts.bodies.size();
  std::vector<std::uint8_t> is_fast(count, 0);
  for (const std::uint32_t i : fast) is_fast[i] = 1;
  for (const std::uint32_t i : anew) parts.world.set_fast(parts.world.bodies().id(i), true);
  parts.world.find_impacts(dt);
  for (const std::uint32_t i : anew) parts.world.set_fast(parts.world.bodies().id(i), false);
  Meetings<T, Space> found{{count, Meeting<T, Space>{dt}}, std::vector<T>(count, dt)};
  std::vector<Meeting<T, Space>> driven(found.first);  // with what is fast and cannot be held back
  for (const Impact<T, Space>& impact : parts.world.impacts()) {
    if (impact.trigger) continue;
    const std::uint32_t a = impact.a.index, b = impact.b.index;
    const T time = holding_time<T, Space>(parts, impact, mean, dt);
    if (!(time < until)) continue;
    for (const std::uint32_t i : {a, b}) {
      const Meeting<T, Space> meeting{time, i == a ? b : a, impact.hit.point, impact.hit.normal};
      if (!parts.bodies[i].movable) continue;
      if (time < found.first[i].time) found.first[i] = meeting;
      if (time < driven[i].time && is_fast[i] == 0 && !parts.bodies[meeting.other].movable) driven[i] = meeting;
    }
  }
  for (const std::uint32_t i : fast) {
    if (!(found.first[i].time < dt)) continue;
    found.ends[i] = found.first[i].time;
    const std::uint32_t other = found.first[i].other;
    const bool other_flies = pushed[other] == 0 && !parts.bodies[other].asleep;
    if ((pushed[i] != 0 || other_flies) && parts.bodies[other].movable) found.ends[other] = found.first[other].time;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!(driven[i].time < found.ends[i])) continue;
    found.first[i] = driven[i];
    found.ends[i] = driven[i].time;
    pushed[i] |= static_cast<std::uint8_t>(parts.bodies[i].asleep);  // what sleeps did not fall
    if (parts.bodies[i].asleep) parts.wake_around(i);
  }
  return found;
}

/// The rounds of casts that a step takes at most. Each holds back those behind whom the one before has held back: a
/// crowd that moves as one has as many as it is deep, and what is left after these sinks into each other. In the plane
/// nothing gives way to the side: what is held there by round after round is pressed the deeper by what comes behind,
/// of a thousand random scenes in seven by more than half of its size, and one round holds back.
template <class Space>
constexpr int most_rounds = 16;
template <class T>
constexpr int most_rounds<plane::Space<T>> = 1;
/// The part of a body's way in a step beyond which a further round holds it back no more: those that stand in touch
/// where the last round left them meet at the very end of their ways, up to rounding.
template <class T>
constexpr T worth_a_round = T(63) / T(64);

/// The bodies that a step holds back, round by round: where, and for which part of the step each has moved.
template <class T, class Space>
struct Rounds {
  using Pose = typename Space::Pose;
  using Vec = typename Space::Vec;

  SimulationParts<T, Space>& parts;
  T dt;
  std::span<const std::uint32_t> fast;
  std::vector<typename Space::Velocity> mean;                 ///< of each body's way, as far as it goes by now
  std::vector<std::uint32_t> anew{fast.begin(), fast.end()};  ///< bodies whose ways are not cast yet
  std::vector<T> ends = std::vector<T>(mean.size(), dt);
  std::vector<Pose> at = std::vector<Pose>(mean.size());
  std::vector<HeldBody<Space>> held = std::vector<HeldBody<Space>>(mean.size());
  std::vector<std::uint8_t> pushed = pushed_bodies(parts);  ///< by contacts or joints, in this step

  /// Casts the bodies whose ways are new and ends the ways of those that meet something before `until`. Returns whether
  /// there are any.
  bool hold(T until) {
    auto [first, stops] = find_meetings<T, Space>(parts, fast, anew, mean, pushed, dt, until);
    anew.clear();
    if (std::none_of(stops.begin(), stops.end(), [&](T stop) { return stop < dt; })) return false;
    const std::size_t count = mean.size();
    std::vector<Vec> carried(count);
    const auto goes_on = [&, &first = first](std::uint32_t i) { return !parts.bodies[first[i].other].movable; };
    for (std::uint32_t i = 0; i < count; ++i)
      if (stops[i] < dt && goes_on(i)) carried[i] = carried_by(i, first[i], stops);
    const std::vector<std::uint8_t> joined = end_together<T, Space>(parts, stops, carried);
    for (std::uint32_t i = 0; i < count; ++i)
      if (stops[i] < dt && joined[i] == 0 && !goes_on(i)) carried[i] = carried_by(i, first[i], stops);
    for (std::uint32_t i = 0; i < count; ++i)
      if (stops[i] < dt) end(i, stops[i], carried[i], first[i].other, joined[i] != 0);
    return true;
  }

 private:
  /// The way of a body that stays in touch with what it met, which goes on: along the normal with the material point
  /// that it met, and around with what nothing pushes, whose point may lead far from it in a step.
  Vec carried_by(std::uint32_t i, const Meeting<T, Space>& meeting, std::span<const T> stops) const {
    const std::uint32_t other = meeting.other;
    const typename Space::Velocity& motion = mean[other];
    const T late = greatest(T(0), stops[other] - meeting.time);
    const Vec center = parts.found_at[other].translation + motion.linear * meeting.time;
    const bool around = !parts.bodies[other].movable && !(motion.angular == typename Space::Turning{});
    const Vec speed = around ? motion.linear : motion.linear + cross(motion.angular, meeting.point - center);
    const Vec along = meeting.normal * (dot(speed, meeting.normal) * late);
    if (!around) return along;
    const Vec arm = pose_at(parts.found_at[i], mean[i], stops[i]).translation - center;
    return along + (rotate(pose_at(Pose{}, motion, late).rotation, arm) - arm);
  }

  /// Ends a body's way at `stop`, and carries it.
  void end(std::uint32_t i, T stop, const Vec& carried, std::uint32_t other, bool joined) {
    const T part = stop / dt;
    at[i] = pose_at(parts.found_at[i], mean[i], stop);
    at[i].translation += carried;
    const ContactPair<T>* const pair = met<T, Space>(parts.world.contacts(), i, other);
    const bool bounces = held[i].bounces || (pair && parts.may_bounce(*pair));
    anew.push_back(i);
    held[i] = {joined, pushed[i] != 0, held[i].touched || pair, bounces, held[i].carried_by * part + carried};
    ends[i] = ends[i] < dt ? ends[i] * part : stop;
    mean[i] = {mean[i].linear * part + carried / dt, mean[i].angular * part};
    parts.world.move(parts.world.bodies().id(i), parts.found_at[i], mean[i].linear, mean[i].angular);
  }
};

}  // namespace

template <class T, class Space>
void SimulationParts<T, Space>::hold_back(T dt) {
  const std::vector<std::uint32_t> fast = fast_bodies(*this, dt);
  if (fast.empty()) return;
  Rounds<T, Space> rounds{*this, dt, fast, mean_velocities(*this, dt)};
  for (int round = 0; round < most_rounds<Space> && rounds.hold(round == 0 ? dt : dt * worth_a_round<T>); ++round) {
  }
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!(rounds.ends[i] < dt)) continue;
    ++last.stopped;
    set_back<T, Space>(*this, i, rounds.at[i], dt - rounds.ends[i], dt, rounds.held[i]);
  }
}

#define GRAZE_HOLD_BACK(T, Space) template void SimulationParts<T, Space>::hold_back(T);
GRAZE_HOLD_BACK(float, Space<float>)
GRAZE_HOLD_BACK(double, Space<double>)
GRAZE_HOLD_BACK(float, plane::Space<float>)
GRAZE_HOLD_BACK(double, plane::Space<double>)
#undef GRAZE_HOLD_BACK

}  // namespace graze
