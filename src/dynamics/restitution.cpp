// Blows: what bounces, at the time at which it touches.
//
// A body that meets something with restitution within the step, or met it within the last one, is first taken along its
// own flight to the moment of contact; there the blow is struck and passed on through all that touches (`blows.hpp`);
// what is left of the step it flies on. Its energy is that of the closed form, however long the step. Contacts slower
// than what gravity does in two steps have no restitution, and rest.
#include <algorithm>
#include <limits>

#include "dynamics/simulation_parts.hpp"
#include "graze/blows.hpp"

namespace graze {

namespace {

/// What of the size of bodies may lie between them that pass a blow on.
template <class T>
constexpr T touching = T(0.002);

/// How fast an approach has to be to bounce, in changes of speed that gravity makes in a step.
template <class T>
constexpr T bouncing_steps = T(2);

/// Blows that an island strikes in a step, for each contact, at most: rounding alone goes on for longer.
constexpr std::size_t blows_per_contact = 16;

/// A point of a manifold where the bodies are now, halfway between its two material points.
template <class T>
struct MovedPoint {
  Vec3<T> position;
  T distance;
};

template <class T>
Vec3<T> moved(const FreeBody<T>& from, const FreeBody<T>& to, const Vec3<T>& point) {
  if (from.center == to.center && from.rotation == to.rotation) return point;
  return to.center + rotate(to.rotation * conjugate(from.rotation), point - from.center);
}

template <class T>
MovedPoint<T> moved(const SimulationParts<T>& parts, const ContactPair<T>& pair, const Vec3<T>& normal,
                    const ContactPoint<T>& p) {
  const Vec3<T> a = moved(parts.before[pair.a], parts.bodies[pair.a].free, p.a);
  const Vec3<T> b = moved(parts.before[pair.b], parts.bodies[pair.b].free, p.b);
  return {a + (b - a) * p.weight, dot(b - a, normal)};
}

/// The first blow that a body has part in, as the time from now; later than any without.
template <class T>
struct Flight {
  T until = std::numeric_limits<T>::infinity();
  bool supported = false;  ///< something bears it
};

/// When the points of a manifold meet, seen from now; negative when they have. Infinite for what does not bounce.
template <class T>
T time_of_blow(const SimulationParts<T>& parts, const ContactPair<T>& pair, const ContactManifold<T>& m,
               std::span<const SolverPoint<T>> points, T slow, T dt) {
  const Motion<T> a = parts.motion(pair.a), b = parts.motion(pair.b);
  T first = std::numeric_limits<T>::infinity();
  bool known = false;
  for (const SolverPoint<T>& p : points) {
    known = known || !(p.impulse == Vec3<T>{});
    const T speed = -relative_velocity(p, m.normal, a, b).normal;
    if (speed > slow) first = least(first, p.distance / speed);
  }
  if (first > dt) return std::numeric_limits<T>::infinity();
  return known ? T(0) : greatest(first, -dt);
}

/// Takes the struck body along its flight to the blow.
template <class T>
void fly(SimulationParts<T>& parts, std::uint32_t index, const Flight<T>& flight, T dt) {
  SimulatedBody<T>& body = parts.bodies[index];
  const Vec3<T> acceleration = flight.supported ? Vec3<T>{} : parts.settings.gravity * body.gravity_factor;
  advance(body.free, acceleration, flight.until);
  parts.shares[index] = (dt - flight.until) / dt;
}

/// The blows of an island and its bodies, side by side.
template <class T>
struct IslandBlows {
  std::vector<std::uint32_t> indices;
  std::vector<StruckBody<T>> bodies;
  std::vector<Motion<T>> before;
  std::vector<Blow<T>> blows;
  std::vector<T> friction;  ///< of each blow
  std::vector<Vec3<T>> points;
  std::vector<T> impulses;
};

template <class T>
std::uint32_t place_of(const SimulationParts<T>& parts, std::span<const std::uint32_t> members, std::uint32_t index,
                       IslandBlows<T>& island) {
  if (parts.movable[index] != 0)
    return static_cast<std::uint32_t>(std::lower_bound(members.begin(), members.end(), index) - members.begin());
  island.indices.push_back(index);
  island.bodies.push_back({parts.motion(index), {}});
  return static_cast<std::uint32_t>(island.bodies.size() - 1);
}

/// Coulomb's friction of what each point pushed, no longer than it takes to end the sliding there.
template <class T>
void rub(IslandBlows<T>& island) {
  for (std::size_t k = 0; k < island.blows.size(); ++k) {
    const Blow<T>& blow = island.blows[k];
    StruckBody<T>&a = island.bodies[blow.a], &b = island.bodies[blow.b];
    for (std::uint32_t i = blow.first_point; i < blow.first_point + blow.point_count; ++i) {
      if (!(island.impulses[i] > T(0))) continue;
      const Vec3<T>& at = island.points[i];
      const Vec3<T> v = velocity_at(b.motion, at) - velocity_at(a.motion, at);
      const Vec3<T> slip = v - blow.normal * dot(v, blow.normal);
      const T speed = length(slip);
      if (!(speed > T(0))) continue;
      const Vec3<T> along = slip / speed;
      const auto yields = [&](const StruckBody<T>& body) {
        const Vec3<T> turn = cross(at - body.motion.center, along);
        return body.mass.mass + dot(turn, body.mass.inertia * turn);
      };
      const T push = least(island.friction[k] * island.impulses[i], speed / (yields(a) + yields(b)));
      a.motion = apply_impulse(a, along * push, at);
      b.motion = apply_impulse(b, along * -push, at);
    }
  }
}

template <class T>
void gather(const SimulationParts<T>& parts, const Islands::Range& range, IslandBlows<T>& island) {
  const auto members = parts.islands.bodies_of(range);
  for (const std::uint32_t i : members) {
    const SimulatedBody<T>& body = parts.bodies[i];
    const Mat3<T> r = rotation_matrix(body.free.rotation);
    island.indices.push_back(i);
    island.bodies.push_back(
        {parts.motion(i), {body.mass.inverse_mass, r * Mat3<T>::diagonal(body.free.inverse_inertia) * transposed(r)}});
  }
  for (const std::uint32_t l : parts.islands.links_of(range)) {
    const ContactPair<T>* pair = parts.contact_of(l);
    if (!pair) continue;
    const ContactMaterial<T> material = parts.material_of(*pair);
    const T near = touching<T> * least(parts.bodies[pair->a].size, parts.bodies[pair->b].size);
    std::uint32_t a = 0, b = 0;
    bool placed = false;
    for (const ContactManifold<T>& m : parts.world.contacts().manifolds_of(*pair)) {
      const auto first = static_cast<std::uint32_t>(island.points.size());
      for (const SolverPoint<T>& p : parts.world.contacts().points_of(m)) {
        const MovedPoint<T> at = moved(parts, *pair, m.normal, p);
        if (at.distance <= near) island.points.push_back(at.position);
      }
      const auto count = static_cast<std::uint32_t>(island.points.size()) - first;
      if (count == 0) continue;
      if (!placed) {
        a = place_of(parts, members, pair->a, island);
        b = place_of(parts, members, pair->b, island);
        placed = true;
      }
      island.blows.push_back({a, b, m.normal, material.restitution, first, count});
      island.friction.push_back(material.dynamic_friction);
    }
  }
  island.impulses.assign(island.points.size(), T(0));
  for (const StruckBody<T>& body : island.bodies) island.before.push_back(body.motion);
}

/// Gives the bodies the motions that the blows left, by what was added to them.
template <class T>
void take_over(SimulationParts<T>& parts, const IslandBlows<T>& island, std::size_t members) {
  for (std::size_t k = 0; k < members; ++k) {
    SimulatedBody<T>& body = parts.bodies[island.indices[k]];
    const Motion<T>&was = island.before[k], &is = island.bodies[k].motion;
    body.free.linear = is.linear;
    if (is.angular == was.angular) continue;
    Vec3<T> gained = rotate(conjugate(body.free.rotation), is.angular - was.angular);
    for (std::size_t i = 0; i < 3; ++i)
      gained[i] = body.free.inverse_inertia[i] > T(0) ? gained[i] * body.mass.inertia[i] : T(0);
    body.free.angular_momentum += rotate(body.free.rotation, gained);
  }
}

}  // namespace

template <class T>
void SimulationParts<T>::pass_blows_on(T dt) {
  const T slow = bouncing_steps<T> * length(settings.gravity) * dt;
  const ContactArrays<T>& contacts = world.contacts();
  std::vector<Flight<T>> flights;
  IslandBlows<T> blows;
  for (std::size_t k = 0; k < awake.size(); ++k) {
    if (awake[k] == 0) continue;
    const Islands::Range& range = islands.ranges()[k];
    const auto members = islands.bodies_of(range);
    const auto links_here = islands.links_of(range);
    const bool bounces = std::any_of(links_here.begin(), links_here.end(), [&](std::uint32_t l) {
      const ContactPair<T>* pair = contact_of(l);
      return pair && material_of(*pair).restitution > T(0);
    });
    if (!bounces) continue;
    flights.assign(members.size(), {});
    bool struck = false;
    const auto flight_of = [&](std::uint32_t index) -> Flight<T>* {
      if (movable[index] == 0) return nullptr;
      return &flights[static_cast<std::size_t>(std::lower_bound(members.begin(), members.end(), index) -
                                               members.begin())];
    };
    for (const std::uint32_t l : links_here) {
      const ContactPair<T>* pair = contact_of(l);
      if (!pair) continue;
      const bool bouncy = material_of(*pair).restitution > T(0);
      for (const ContactManifold<T>& m : contacts.manifolds_of(*pair)) {
        const auto points = contacts.points_of(m);
        const T t = bouncy ? time_of_blow(*this, *pair, m, points, slow, dt) : std::numeric_limits<T>::infinity();
        const bool bears = std::any_of(points.begin(), points.end(),
                                       [](const SolverPoint<T>& p) { return !(p.impulse == Vec3<T>{}); });
        struck = struck || t <= dt;
        for (const std::uint32_t i : {pair->a, pair->b}) {
          Flight<T>* flight = flight_of(i);
          if (!flight) continue;
          flight->supported = flight->supported || bears;
          if (t <= dt && length(motion(i).linear) > slow) flight->until = least(flight->until, t);
        }
      }
    }
    if (!struck) continue;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (flights[i].until <= dt) fly(*this, members[i], flights[i], dt);
    blows = {};
    gather(*this, range, blows);
    pass_on<T>(blows.bodies, blows.blows, blows.points, blows.impulses, slow, blows_per_contact * blows.blows.size());
    rub(blows);
    take_over(*this, blows, members.size());
  }
}

template void SimulationParts<float>::pass_blows_on(float);
template void SimulationParts<double>::pass_blows_on(double);

}  // namespace graze
