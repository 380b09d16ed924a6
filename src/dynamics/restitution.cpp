// Blows: bodies that bounce, at the time at which they touch.
//
// A body that meets something with restitution within the step, or met it within the last one, is first taken along its
// own flight to the moment of contact; there the blow is struck and passed on through all that touches (`blows.hpp`);
// for the rest of the step the body flies on, and one that is alone to the next blow if there is one: a box that comes
// down on a corner has the next one a few milliseconds later. Its energy is that of the closed form, however long the
// step. Contacts slower than the speed that gravity gives in two steps have no restitution, and rest.
#include <algorithm>
#include <limits>

#include "dynamics/rolling_arm.hpp"
#include "dynamics/simulation_parts.hpp"
#include "dynamics/stopping_impulse.hpp"
#include "graze/plane/blows.hpp"

namespace graze {

namespace {

/// The largest gap, as a part of the size of bodies, across which they pass a blow on.
template <class T>
constexpr T touching = T(0.002);

/// The least speed of an approach that bounces, as a multiple of the speed that gravity gives in a step.
template <class T>
constexpr T bouncing_steps = T(2);

/// Blows that an island strikes in a step, for each contact, at most: rounding alone goes on for longer.
constexpr std::size_t blows_per_contact = 16;

/// Blows in a step, one after the other, of a body that meets nothing which can be pushed, at most. Of several bodies
/// each has flown for another time after the first blow, and they would fly into each other.
constexpr int most_flights = 8;

/// The ball about the core of a shape. A point of contact stands on it, wherever the body turns below.
template <class T>
struct Roundness {
  T radius{};
  bool ball = false;  ///< the core is a point
};
template <class T>
Roundness<T> roundness_of(const Shape<T>& shape) {
  if (!shape.convex()) return {};
  return {rounding_radius(shape), shape.template as<Sphere<T>>() != nullptr};
}
template <class T>
Roundness<T> roundness_of(const plane::Shape<T>& shape) {
  return {rounding_radius(shape), shape.template as<plane::Circle<T>>() != nullptr};
}

/// A point of a manifold where the bodies are now.
template <class T, class Space>
struct MovedPoint {
  using Vec = typename Space::Vec;
  Vec core_a, core_b;  ///< below the points of both surfaces by their radii
  Vec normal;          ///< of two balls that of the way between their centres
  Roundness<T> round_a, round_b;
  T weight{};  ///< of B's point in their common place

  Vec a() const { return core_a + normal * round_a.radius; }
  Vec b() const { return core_b - normal * round_b.radius; }
  /// The common place. Bodies that slide on each other take their points along; a ball is met below its centre.
  Vec position() const {
    if (round_a.ball) return a() + normal * (distance() * weight);
    if (round_b.ball) return b() - normal * (distance() * (T(1) - weight));
    return a() + (b() - a()) * weight;
  }
  T distance() const { return dot(b() - a(), normal); }
};

template <class T, class Space>
typename Space::Vec moved(const FreeBodyIn<Space>& from, const FreeBodyIn<Space>& to,
                          const typename Space::Vec& point) {
  if (from.center == to.center && from.rotation == to.rotation) return point;
  return to.center + rotate(to.rotation * conjugate(from.rotation), point - from.center);
}

template <class T, class Space>
MovedPoint<T, Space> moved(const SimulationParts<T, Space>& parts, const ContactPair<T>& pair,
                           const typename Space::Vec& normal, const typename Space::ContactPoint& p) {
  MovedPoint<T, Space> at;
  at.weight = p.weight;
  at.round_a = roundness_of(parts.world.bodies().shapes()[pair.a]);
  at.round_b = roundness_of(parts.world.bodies().shapes()[pair.b]);
  at.core_a = moved<T, Space>(parts.before[pair.a], parts.bodies[pair.a].free, p.a - normal * at.round_a.radius);
  at.core_b = moved<T, Space>(parts.before[pair.b], parts.bodies[pair.b].free, p.b + normal * at.round_b.radius);
  at.normal = at.round_a.ball && at.round_b.ball ? normalized(at.core_b - at.core_a, normal) : normal;
  return at;
}

/// A meeting to come.
template <class T>
struct Meeting {
  T time = std::numeric_limits<T>::infinity();  ///< from now; negative where the bodies have met already
  T speed{};                                    ///< of the approach then
};

/// The meeting of two balls that approach each other, by the root of |d + v t| = r.
template <class T, class Vec>
Meeting<T> meeting_of_balls(const Vec& d, const Vec& v, T r) {
  const T half = dot(d, v), beyond = length_squared(d) - r * r, root_squared = half * half - length_squared(v) * beyond;
  if (!(half < T(0)) || !(root_squared > T(0)) || !(r > T(0))) return {};
  const T root = std::sqrt(root_squared);
  return {beyond / (root - half), root / r};
}

/// The acceleration of a body's material point along its circle.
template <class T, class Space>
typename Space::Vec toward_center(const MotionIn<Space>& motion, const typename Space::Vec& point) {
  return cross(motion.angular, cross(motion.angular, point - motion.center));
}

/// The meeting at a point of a manifold, which turns with its bodies: a corner that hardly moves may be about to come
/// down fast. `behind_a` and `behind_b`: for how long the bodies have still to move on.
template <class T, class Space>
Meeting<T> meeting_at(MovedPoint<T, Space> at, const MotionIn<Space>& a, const MotionIn<Space>& b, T behind_a,
                      T behind_b) {
  at.core_a += velocity_at(a, at.core_a) * behind_a;
  at.core_b += velocity_at(b, at.core_b) * behind_b;
  if (at.round_a.ball && at.round_b.ball)
    return meeting_of_balls(at.core_b - at.core_a, velocity_at(b, at.core_b) - velocity_at(a, at.core_a),
                            at.round_a.radius + at.round_b.radius);
  const auto point = at.position();
  const T gap = at.distance(), speed = dot(velocity_at(a, point) - velocity_at(b, point), at.normal);
  const T bent = dot(toward_center<T, Space>(a, at.core_a) - toward_center<T, Space>(b, at.core_b), at.normal);
  // The first root of gap - speed t - bent t² / 2, and the speed of the approach there.
  const T square = speed * speed + T(2) * bent * gap;
  if (!(square > T(0)) || !(speed > T(0) || gap > T(0))) return {};
  const T then = std::sqrt(square);
  return speed + then > T(0) ? Meeting<T>{T(2) * gap / (speed + then), then} : Meeting<T>{};
}

/// The first blow that a body has part in, as the time from now; later than any without.
template <class T>
struct Flight {
  T until = std::numeric_limits<T>::infinity();
  bool supported = false;  ///< something bears it
};

/// The part of the step that the further of two bodies has still to fly; what nothing pushes is wherever the other is.
template <class T, class Space>
T share_of(const SimulationParts<T, Space>& parts, const ContactPair<T>& pair) {
  if (parts.movable[pair.a] == 0) return parts.shares[pair.b];
  if (parts.movable[pair.b] == 0) return parts.shares[pair.a];
  return least(parts.shares[pair.a], parts.shares[pair.b]);
}

/// The time at which the points of a manifold meet, from the time to which the further of both bodies has flown:
/// negative where they have just met, never so where they bore an impulse before or a body has flown to a blow
/// already; infinite where they do not bounce.
template <class T, class Space>
T time_of_blow(const SimulationParts<T, Space>& parts, const ContactPair<T>& pair, const ContactManifold<T, Space>& m,
               std::span<const SolverPoint<T, Space>> points, T slow, T dt) {
  const MotionIn<Space> a = parts.motion(pair.a), b = parts.motion(pair.b);
  const T share = share_of(parts, pair);
  const bool flown = parts.shares[pair.a] != T(1) || parts.shares[pair.b] != T(1);
  const T gained = slow / bouncing_steps<T>;  // at most, by gravity in the step
  T first = std::numeric_limits<T>::infinity(), soonest = first;
  const T behind_a = (parts.shares[pair.a] - share) * dt, behind_b = (parts.shares[pair.b] - share) * dt;
  for (const SolverPoint<T, Space>& p : points) {
    const bool known = flown || !(p.impulse == typename Space::Vec{});
    const Meeting<T> meeting = meeting_at(moved<T, Space>(parts, pair, m.normal, p), a, b, behind_a, behind_b);
    if (!(meeting.speed > slow)) continue;
    first = least(first, greatest(meeting.time, known ? T(0) : -dt));
    soonest = least(soonest, meeting.time * meeting.speed / (meeting.speed + gained));
  }
  if (soonest > dt * share) return std::numeric_limits<T>::infinity();
  return least(first, dt * share);
}

/// Takes the struck body along its flight to the blow.
template <class T, class Space>
void fly(SimulationParts<T, Space>& parts, std::uint32_t index, const Flight<T>& flight, T dt) {
  SimulatedBody<T, Space>& body = parts.bodies[index];
  const typename Space::Vec acceleration =
      flight.supported ? typename Space::Vec{} : parts.settings.gravity * body.gravity_factor;
  advance(body.free, acceleration, flight.until);
  parts.shares[index] = (dt * parts.shares[index] - flight.until) / dt;
}

/// The blows of an island and its bodies, side by side.
template <class T, class Space>
struct IslandBlows {
  std::vector<std::uint32_t> indices;
  std::vector<StruckBody<T, Space>> bodies;
  std::vector<MotionIn<Space>> before;
  std::vector<Blow<T, Space>> blows;
  std::vector<T> friction;  ///< of each blow
  std::vector<typename Space::Vec> points;
  std::vector<T> impulses;
};

template <class T, class Space>
std::uint32_t place_of(const SimulationParts<T, Space>& parts, std::span<const std::uint32_t> members,
                       std::uint32_t index, IslandBlows<T, Space>& island) {
  if (parts.movable[index] != 0)
    return static_cast<std::uint32_t>(std::lower_bound(members.begin(), members.end(), index) - members.begin());
  island.indices.push_back(index);
  island.bodies.push_back({parts.motion(index), {}});
  return static_cast<std::uint32_t>(island.bodies.size() - 1);
}

/// Adds Coulomb's friction at each point that was struck, no more than ends the sliding there: at one point as
/// `response` has it.
template <class T, class Space>
void rub(IslandBlows<T, Space>& island) {
  for (std::size_t k = 0; k < island.blows.size(); ++k) {
    const Blow<T, Space>& blow = island.blows[k];
    StruckBody<T, Space>&a = island.bodies[blow.a], &b = island.bodies[blow.b];
    for (std::uint32_t i = blow.first_point; i < blow.first_point + blow.point_count; ++i) {
      if (!(island.impulses[i] > T(0))) continue;
      const typename Space::Vec& at = island.points[i];
      const typename Space::Vec v = velocity_at(b.motion, at) - velocity_at(a.motion, at);
      const typename Space::Vec slip = v - blow.normal * dot(v, blow.normal);
      typename Space::Vec push = stopping_impulse(a, b, at, blow.normal, slip);
      const T needed = length(push), most = island.friction[k] * island.impulses[i];
      if (needed > most) push = push * (most / needed);
      a.motion = apply_impulse(a, -push, at);
      b.motion = apply_impulse(b, push, at);
    }
  }
}

template <class T, class Space>
void gather(const SimulationParts<T, Space>& parts, const Islands::Range& range, IslandBlows<T, Space>& island) {
  const auto members = parts.islands.bodies_of(range);
  for (const std::uint32_t i : members) {
    const SimulatedBody<T, Space>& body = parts.bodies[i];
    island.indices.push_back(i);
    island.bodies.push_back(
        {parts.motion(i), {body.mass.inverse_mass, in_world(body.free.inverse_inertia, body.free.rotation)}});
  }
  for (const std::uint32_t l : parts.islands.links_of(range)) {
    const ContactPair<T>* pair = parts.contact_of(l);
    if (!pair) continue;
    const T near = touching<T> * least(parts.bodies[pair->a].size, parts.bodies[pair->b].size);
    std::uint32_t a = 0, b = 0;
    bool placed = false;
    const auto add = [&](const ContactManifold<T, Space>& m, const ContactMaterial<T>& material) {
      const auto first = static_cast<std::uint32_t>(island.points.size());
      typename Space::Vec normal = m.normal;
      for (const SolverPoint<T, Space>& p : parts.world.contacts().points_of(m)) {
        const MovedPoint<T, Space> at = moved<T, Space>(parts, *pair, m.normal, p);
        if (at.distance() > near) continue;
        island.points.push_back(at.position());
        normal = at.normal;
      }
      const auto count = static_cast<std::uint32_t>(island.points.size()) - first;
      if (count == 0) return;
      if (!placed) {
        a = place_of<T, Space>(parts, members, pair->a, island);
        b = place_of<T, Space>(parts, members, pair->b, island);
        placed = true;
      }
      island.blows.push_back({a, b, normal, material.restitution, first, count});
      island.friction.push_back(material.dynamic_friction);
    };
    parts.each_surface(*pair, [&](auto manifolds, const auto& sides, std::size_t) {
      for (const ContactManifold<T, Space>& m : manifolds) add(m, sides.combined());
    });
  }
  island.impulses.assign(island.points.size(), T(0));
  for (const StruckBody<T, Space>& body : island.bodies) island.before.push_back(body.motion);
}

/// Adds the changes of the bodies' motions by the blows.
template <class T, class Space>
void take_over(SimulationParts<T, Space>& parts, const IslandBlows<T, Space>& island, std::size_t members) {
  for (std::size_t k = 0; k < members; ++k) {
    SimulatedBody<T, Space>& body = parts.bodies[island.indices[k]];
    const MotionIn<Space>&was = island.before[k], &is = island.bodies[k].motion;
    body.free.linear = is.linear;
    if (is.angular == was.angular) continue;
    body.free.angular_momentum += momentum_of(body.free, body.mass.inertia, is.angular - was.angular);
  }
}

}  // namespace

/// Takes the bodies of an island to their next blows, and strikes these. Returns whether there are any.
template <class T, class Space>
bool SimulationParts<T, Space>::strike_next(const Islands::Range& range, T slow, T dt) {
  const ContactArrays<T, Space>& contacts = world.contacts();
  const auto members = islands.bodies_of(range);
  std::vector<Flight<T>> flights(members.size());
  const auto flight_of = [&](std::uint32_t index) -> Flight<T>* {
    if (movable[index] == 0) return nullptr;
    return &flights[static_cast<std::size_t>(std::lower_bound(members.begin(), members.end(), index) -
                                             members.begin())];
  };
  bool struck = false;
  for (const std::uint32_t l : islands.links_of(range)) {
    const ContactPair<T>* pair = contact_of(l);
    if (!pair) continue;
    const T share = share_of(*this, *pair);
    const auto look_at = [&](const ContactManifold<T, Space>& m, bool bouncy) {
      const auto points = contacts.points_of(m);
      const T t =
          bouncy ? time_of_blow<T, Space>(*this, *pair, m, points, slow, dt) : std::numeric_limits<T>::infinity();
      const bool bears = std::any_of(points.begin(), points.end(), [](const SolverPoint<T, Space>& p) {
        return !(p.impulse == typename Space::Vec{});
      });
      const bool meets = t < std::numeric_limits<T>::infinity();
      struck = struck || meets;
      for (const std::uint32_t i : {pair->a, pair->b}) {
        Flight<T>* flight = flight_of(i);
        if (!flight) continue;
        flight->supported = flight->supported || bears;
        if (meets && length(motion(i).linear) > slow)
          flight->until = least(flight->until, t + (shares[i] - share) * dt);
      }
    };
    each_surface(*pair, [&](auto manifolds, const Sides& sides, std::size_t) {
      const bool bouncy = sides.combined().restitution > T(0);
      for (const ContactManifold<T, Space>& m : manifolds) look_at(m, bouncy);
    });
  }
  if (!struck) return false;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (flights[i].until < std::numeric_limits<T>::infinity()) fly(*this, members[i], flights[i], dt);
  IslandBlows<T, Space> blows;
  gather(*this, range, blows);
  pass_on<T>(blows.bodies, blows.blows, blows.points, blows.impulses, slow, blows_per_contact * blows.blows.size());
  rub(blows);
  take_over(*this, blows, members.size());
  return true;
}

template <class T, class Space>
bool SimulationParts<T, Space>::may_bounce(const ContactPair<T>& pair) const {
  bool any = false;
  each_surface(pair, [&](auto, const Sides& sides, std::size_t) { any = any || sides.combined().restitution > T(0); });
  return any;
}

template <class T, class Space>
void SimulationParts<T, Space>::pass_blows_on(T dt) {
  const T slow = bouncing_steps<T> * length(settings.gravity) * dt;
  for (std::size_t k = 0; k < awake.size(); ++k) {
    if (awake[k] == 0) continue;
    const Islands::Range& range = islands.ranges()[k];
    const auto links_here = islands.links_of(range);
    const bool bounces = std::any_of(links_here.begin(), links_here.end(), [&](std::uint32_t l) {
      const ContactPair<T>* pair = contact_of(l);
      return pair && may_bounce(*pair);
    });
    if (!bounces) continue;
    const int most = range.body_count == 1 ? most_flights : 1;
    for (int flight = 0; flight < most && strike_next(range, slow, dt); ++flight) {
    }
  }
}

#define GRAZE_PASS_BLOWS_ON(T, Space)                                                                                  \
  template bool SimulationParts<T, Space>::may_bounce(const ContactPair<T>&) const;                                    \
  template void SimulationParts<T, Space>::pass_blows_on(T);
GRAZE_PASS_BLOWS_ON(float, Space<float>)
GRAZE_PASS_BLOWS_ON(double, Space<double>)
GRAZE_PASS_BLOWS_ON(float, plane::Space<float>)
GRAZE_PASS_BLOWS_ON(double, plane::Space<double>)
#undef GRAZE_PASS_BLOWS_ON

}  // namespace graze
