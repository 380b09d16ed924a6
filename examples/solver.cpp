// A solver of your own on a world's contacts: ten boxes stand on each other, by sequential impulses (Catto 2005).
// solver [iterations [slop]]: 20 and half the contact margin unless told otherwise; docs/solver.md says why.
#include <graze/impulse.hpp>
#include <graze/query.hpp>
#include <graze/world.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace graze;

constexpr double step = 1.0 / 60, gravity = 9.81, friction = 0.6;
constexpr double recovery = 0.2;  // of what is deeper than the slop, a step (Baumgarte 1972)

struct Row {  // a point of contact, and the two bodies
  SolverPoint<double>* point;
  Vec3d normal;
  StruckBody<double>*a, *b;

  void push(const Vec3d& impulse) const {
    a->motion = apply_impulse(*a, -impulse, point->position());
    b->motion = apply_impulse(*b, impulse, point->position());
  }
  Response<double> now() const { return response<double>({point->position(), normal, 0, friction}, *a, *b); }
  // A visit: the impulse so far is corrected, never pulls, and stays in Coulomb's cone.
  void solve(double slop) const {
    const double depth = -point->distance, before = dot(point->impulse, normal);
    const double wanted = depth < 0 ? depth / step : recovery * greatest(0.0, depth - slop) / step;
    const Response<double> r = now();
    const double after = greatest(0.0, before + (wanted - r.approach.normal) * r.effective_mass);
    push(normal * (after - before));
    const Vec3d held = point->impulse - normal * before;
    Vec3d holds = held + now().stopping_impulse;
    if (const double l = length(holds); l > friction * after) holds *= friction * after / l;
    push(holds - held);
    point->impulse = normal * after + holds;
  }
};

int main(int argc, char** argv) {
  const Shaped box = Box<double>({1, 1, 1});  // of 1 m and 1 t
  const int iterations = argc > 1 ? std::atoi(argv[1]) : 20;
  const double slop = argc > 2 ? std::atof(argv[2]) : contact_margin(box, box) / 2;
  Worldd world;
  std::vector<BodyId> ids{world.add({.shape = HalfSpace<double>(), .fixed = true})};
  std::vector<StruckBody<double>> bodies(11);  // motion and inverse mass: zero of the floor
  for (int i = 0; i < 10; ++i) ids.push_back(world.add({.shape = box, .pose = {{0, 0.5 + i, 0}, {}}}));
  std::vector<Row> rows;
  for (int frame = 0; frame < 20 * 60; ++frame) {
    world.update();
    rows.clear();
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const Posed& pose = world.bodies().poses()[ids[i].index];
      bodies[i].mass = inverse_mass(1000.0, inertia_of(box, 1000.0), pose.rotation);
      bodies[i].motion.center = pose.translation;
      bodies[i].motion.linear.y -= gravity * step;
    }
    auto& contacts = world.contacts();
    for (const auto& pair : contacts.pairs)
      for (const auto& m : contacts.manifolds_of(pair))
        for (std::uint32_t i = m.first_point; i < m.first_point + m.point_count; ++i)
          rows.push_back({&contacts.points[i], m.normal, &bodies[pair.a], &bodies[pair.b]});
    for (const Row& row : rows) row.push(row.point->impulse);  // warm start: what held it up a step ago
    for (int i = 0; i < iterations; ++i) {  // there and back, or the tower leans the way of what is left over
      for (const Row& row : rows) row.solve(slop);
      std::reverse(rows.begin(), rows.end());
    }
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const auto& [linear, angular, center] = bodies[i].motion;
      world.move(ids[i], pose_at(world.bodies().poses()[ids[i].index], {linear, angular}, step));
    }
  }
  const Vec3d top = bodies[10].motion.center;
  std::printf("%d iterations, slop %g m: after 20 s the top box is %.1f mm aside and %.1f mm down\n", iterations, slop,
              1e3 * length(Vec3d{top.x, 0, top.z}), 1e3 * (9.5 - top.y));
  return top.y > 9 ? 0 : 1;
}
