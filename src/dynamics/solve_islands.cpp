// The islands of a step, found and solved.
#include <algorithm>

#include "dynamics/rolling_arm.hpp"
#include "dynamics/simulation_parts.hpp"

namespace graze {

namespace {

constexpr std::size_t islands_per_task = 8;

/// The links from which on the contacts and bodies of an island are shared among the threads, after all smaller
/// islands.
constexpr std::uint32_t links_of_large = 512;

}  // namespace

/// Islands of contacts and joints. One in which anything is awake, or that something touches which moves by itself, is
/// awake as a whole.
template <class T, class Space>
void SimulationParts<T, Space>::find_islands() {
  const auto alive = world.bodies().alive();
  movable.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) movable[i] = alive[i] != 0 && bodies[i].movable ? 1 : 0;
  links.clear();
  link_pairs.clear();
  const auto link = [&](std::uint32_t a, std::uint32_t b, std::size_t place) {
    if (movable[a] == 0 && movable[b] == 0) return;
    links.push_back({a, b});
    link_pairs.push_back(static_cast<std::uint32_t>(place));
  };
  const auto& pairs = world.contacts().pairs;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].manifold_count != 0) link(pairs[i].a, pairs[i].b, i);
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].alive) link(joints[j].in_place.a, joints[j].in_place.b, pairs.size() + j);
  islands.find(movable, links);

  awake.assign(islands.ranges().size(), 0);
  // Bodies that nothing pushes wake those that they touch where they move, and where they have just been put.
  const auto disturbs = [&](std::uint32_t i) {
    if (movable[i] != 0) return false;
    return bodies[i].placed || (bodies[i].moves && !(bodies[i].free.linear == typename Space::Vec{} &&
                                                     bodies[i].spin == typename Space::Turning{}));
  };
  for (std::size_t k = 0; k < awake.size(); ++k) {
    const Islands::Range& r = islands.ranges()[k];
    for (const std::uint32_t i : islands.bodies_of(r)) awake[k] |= !bodies[i].asleep;
    for (const std::uint32_t l : islands.links_of(r)) awake[k] |= disturbs(links[l].a) || disturbs(links[l].b);
    if (awake[k] == 0) continue;
    ++last.islands;
    last.awake += r.body_count;
    for (const std::uint32_t i : islands.bodies_of(r))
      if (bodies[i].asleep) wake(i);
  }
}

template <class T, class Space>
IslandBody<T, Space> SimulationParts<T, Space>::island_body(std::uint32_t index) const {
  const SimulatedBody<T, Space>& body = bodies[index];
  IslandBody<T, Space> b;
  b.free = body.free;
  b.first = before[index];
  b.inertia = body.mass.inertia;
  b.inverse_mass = body.mass.inverse_mass;
  b.spin = body.spin;
  b.influences = {settings.gravity * body.gravity_factor + body.force * body.mass.inverse_mass, body.torque,
                  body.linear_damping, body.angular_damping, shares[index]};
  b.sub_steps = body.sub_steps;
  b.movable = body.movable;
  b.placed = body.placed;
  return b;
}

/// The way by which the arm of a body's point of contact changes in a time, as it rolls.
template <class T, class Space>
auto SimulationParts<T, Space>::rolled_by(std::uint32_t index, const typename Space::Vec& outward,
                                          const typename Space::Vec& point, T time) const -> typename Space::Vec {
  const SimulatedBody<T, Space>& body = bodies[index];
  if (!body.movable) return {};
  return rate_of_arm(world.bodies().shapes()[index], found_at[index].rotation, angular_velocity(body.free), outward,
                     point - body.free.center) *
         time;
}

/// The radius of the ball that a body's surface is at a point of contact; nothing for a body that is not moved.
template <class T, class Space>
T SimulationParts<T, Space>::round_at(std::uint32_t index, const typename Space::Vec& outward,
                                      const typename Space::Vec& point) const {
  const SimulatedBody<T, Space>& body = bodies[index];
  if (!body.moves) return T(0);
  const typename Space::Pose& pose = found_at[index];
  return radius_of_rolling(world.bodies().shapes()[index], rotate(conjugate(pose.rotation), outward),
                           inverse_transform(pose, point));
}

template <class T, class Space>
void SimulationParts<T, Space>::solve_island(IslandSolver<T, Space>& solver, const Islands::Range& island, T dt,
                                             Executor* threads) {
  ContactArrays<T, Space>& contacts = world.contacts();
  const T gravity = length(settings.gravity), share = last_step > T(0) ? dt / last_step : T(0);
  const auto members = islands.bodies_of(island);
  solver.clear(threads);
  for (const std::uint32_t i : members) solver.add(island_body(i));
  const auto place_of = [&](std::uint32_t i) {
    if (movable[i] == 0) return solver.add_once(i, island_body(i));
    return static_cast<std::uint32_t>(std::lower_bound(members.begin(), members.end(), i) - members.begin());
  };
  for (const std::uint32_t l : islands.links_of(island)) {
    const std::uint32_t a = place_of(links[l].a), b = place_of(links[l].b);
    const ContactPair<T>* pair = contact_of(l);
    if (!pair) {
      solver.add(joint_of(l), a, b);
      continue;
    }
    const SimulatedBody<T, Space>&body_a = bodies[pair->a], &body_b = bodies[pair->b];
    const auto belt_of = [&](const MaterialIn<T, Space>& material, std::uint32_t index) {
      return rotate(found_at[index].rotation, material.surface_velocity);
    };
    each_surface(
        *pair, [&](std::span<const ContactManifold<T, Space>> manifolds, const Sides& sides, std::size_t first) {
          TouchingBodies<T, Space> touching{a,
                                            b,
                                            {sides.combined(), belt_of(*sides.b, pair->b) - belt_of(*sides.a, pair->a),
                                             least(body_a.size, body_b.size)}};
          if (touching.between.material.rolling_friction > T(0)) touching.rolling = rolling.of(first);
          for (const ContactManifold<T, Space>& m : manifolds) {
            if (m.point_count == 0) continue;
            touching.between.round_a = round_at(pair->a, m.normal, contacts.points_of(m)[0].a);
            touching.between.round_b = round_at(pair->b, -m.normal, contacts.points_of(m)[0].b);
            break;
          }
          if (manifolds.size() == 1 && manifolds[0].point_count == 1) {
            const auto& point = contacts.points_of(manifolds[0])[0];
            touching.between.rolled_a = rolled_by(pair->a, manifolds[0].normal, point.a, dt / T(2));
            touching.between.rolled_b = rolled_by(pair->b, -manifolds[0].normal, point.b, dt / T(2));
          }
          solver.add(touching, manifolds);
        });
  }
  const StepTime<T> time{dt, usual_step, share, settings.warm_start};
  solver.choose_sub_steps(contacts.points, time, gravity, settings.sub_steps, settings.most_sub_steps);
  solver.solve(contacts.points, time, gravity);
  solver.store(contacts.points);
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    bodies[members[i]].free = solver.body(i);
    bodies[members[i]].sub_steps = solver.sub_steps();
    bodies[members[i]].placed = solver.placed(i);
  }
}

template <class T, class Space>
void SimulationParts<T, Space>::solve_islands(T dt) {
  const auto ranges = islands.ranges();
  const std::size_t tasks = (ranges.size() + islands_per_task - 1) / islands_per_task;
  if (solvers.size() < tasks) solvers.resize(tasks);
  struct Outcome {
    std::size_t contacts = 0, colors = 0;
    int sub_steps = 0;
    T residual{};
  };
  std::vector<Outcome> outcomes(tasks + 1);
  const auto solve = [&](std::size_t k, IslandSolver<T, Space>& solver, Outcome& outcome, Executor* threads) {
    solve_island(solver, ranges[k], dt, threads);
    outcome.contacts += solver.point_count();
    outcome.colors = std::max(outcome.colors, solver.color_count());
    outcome.sub_steps = std::max(outcome.sub_steps, solver.sub_steps());
    outcome.residual = greatest(outcome.residual, solver.residual());
  };
  const auto is_large = [&](std::size_t k) { return ranges[k].link_count >= links_of_large; };
  for_each_chunk(*executor, ranges.size(), islands_per_task, [&](std::size_t begin, std::size_t end, std::size_t task) {
    for (std::size_t k = begin; k < end; ++k)
      if (awake[k] != 0 && !is_large(k)) solve(k, solvers[task], outcomes[task], nullptr);
  });
  Executor* threads = executor->concurrency() > 1 ? executor : nullptr;
  for (std::size_t k = 0; k < ranges.size(); ++k)
    if (awake[k] != 0 && is_large(k)) solve(k, solvers[0], outcomes[tasks], threads);
  for (const Outcome& o : outcomes) {
    last.contacts += o.contacts;
    last.colors = std::max(last.colors, o.colors);
    last.most_sub_steps = std::max(last.most_sub_steps, o.sub_steps);
    last.residual = greatest(last.residual, o.residual);
  }
  const auto alive = world.bodies().alive();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    SimulatedBody<T, Space>& body = bodies[i];
    if (alive[i] == 0 || body.movable) continue;
    body.placed = false;
    if (!body.moves) continue;
    FreeBodyIn<Space> moving = spinning(body.free, body.spin);
    advance(moving, typename Space::Vec{}, dt);
    body.free.center = moving.center;
    body.free.rotation = moving.rotation;
  }
}

#define GRAZE_ISLANDS(T, Space)                                                                                        \
  template void SimulationParts<T, Space>::find_islands();                                                             \
  template IslandBody<T, Space> SimulationParts<T, Space>::island_body(std::uint32_t) const;                           \
  template void SimulationParts<T, Space>::solve_islands(T);
GRAZE_ISLANDS(float, Space<float>)
GRAZE_ISLANDS(double, Space<double>)
GRAZE_ISLANDS(float, plane::Space<float>)
GRAZE_ISLANDS(double, plane::Space<double>)
#undef GRAZE_ISLANDS

}  // namespace graze
