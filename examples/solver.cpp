// A solver of your own on a world's contacts: ten boxes stand on each other, by sequential impulses (Catto 2005).
//
//     solver [iterations [slop]]     20 and half the contact margin unless told otherwise; docs/solver.md says why
#include <graze/impulse.hpp>
#include <graze/query.hpp>
#include <graze/world.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using graze::Posed, graze::Quatd, graze::Vec3d;

constexpr double step = 1.0 / 60, gravity = 9.81, friction = 0.6;
constexpr double recovery = 0.2;  // of what is deeper than the slop, a step (Baumgarte 1972)

struct Body {
  graze::BodyId id;
  Posed pose;
  graze::StruckBody<double> state;  // its motion and inverse mass: the floor's are zero
};

/// A point of contact as the solver sees it.
struct Row {
  graze::SolverPoint<double>* point;
  Vec3d normal;
  Body *a, *b;

  void push(const Vec3d& impulse) const {
    a->state.motion = apply_impulse(a->state, -impulse, point->position());
    b->state.motion = apply_impulse(b->state, impulse, point->position());
  }
  graze::RelativeVelocity<double> velocity() const {
    return relative_velocity(*point, normal, a->state.motion, b->state.motion);
  }
  double effective_mass(const Vec3d& direction) const {
    double inverse = a->state.mass.mass + b->state.mass.mass;
    for (const Body* body : {a, b}) {
      const Vec3d turn = cross(point->position() - body->state.motion.center, direction);
      inverse += dot(turn, body->state.mass.inertia * turn);
    }
    return 1 / inverse;
  }
  /// One visit: the impulse so far is corrected, never pulls, and stays in Coulomb's cone.
  void solve(double slop) const {
    const double depth = -point->distance;
    const double wanted = depth < 0 ? depth / step : recovery * graze::greatest(0.0, depth - slop) / step;
    const double normal_before = dot(point->impulse, normal);
    const double normal_after =
        graze::greatest(0.0, normal_before + (wanted - velocity().normal) * effective_mass(normal));
    push(normal * (normal_after - normal_before));

    const Vec3d sliding = velocity().tangential, tangential_before = point->impulse - normal * normal_before;
    Vec3d tangential = tangential_before - sliding * effective_mass(normalized(sliding, normal));
    if (const double l = length(tangential); l > friction * normal_after) tangential *= friction * normal_after / l;
    push(tangential - tangential_before);
    point->impulse = normal * normal_after + tangential;
  }
};

void move(Body& body, graze::Worldd& world) {
  auto& [linear, angular, center] = body.state.motion;
  center += linear * step;
  const Vec3d w = angular * (step / 2);
  const Quatd& q = body.pose.rotation;
  const Quatd turn = Quatd{w.x, w.y, w.z, 0} * q;
  body.pose = {center, normalized(Quatd{q.x + turn.x, q.y + turn.y, q.z + turn.z, q.w + turn.w})};
  world.move(body.id, body.pose, linear, angular);
}

}  // namespace

int main(int argc, char** argv) {
  const graze::Shaped box = graze::Box<double>({1, 1, 1});
  const int iterations = argc > 1 ? std::atoi(argv[1]) : 20;
  const double slop = argc > 2 ? std::atof(argv[2]) : contact_margin(box, box) / 2;
  graze::Worldd world;
  graze::Body<double> floor{graze::HalfSpace<double>()};
  floor.fixed = true;
  std::vector<Body> bodies{{world.add(floor), {}, {}}};
  for (int i = 0; i < 10; ++i) {
    const Posed pose{{0, 0.5 + i, 0}, {}};
    bodies.push_back({world.add({box, pose}), pose, {{{}, {}, pose.translation}, {}}});
  }

  std::vector<Row> rows;
  for (int frame = 0; frame < 20 * 60; ++frame) {
    world.update();
    rows.clear();
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      bodies[i].state.mass = graze::inverse_mass(1000.0, inertia_of(box, 1000.0), bodies[i].pose.rotation);
      bodies[i].state.motion.linear.y -= gravity * step;
    }
    auto& contacts = world.contacts();
    for (const auto& pair : contacts.pairs)
      for (const auto& manifold : contacts.manifolds_of(pair))
        for (std::uint32_t i = 0; i < manifold.point_count; ++i)
          rows.push_back(
              {&contacts.points[manifold.first_point + i], manifold.normal, &bodies[pair.a], &bodies[pair.b]});
    for (const Row& row : rows) row.push(row.point->impulse);  // warm start: what held it up a step ago
    // There and back: what one direction leaves over always lies on the same side, and the tower would lean that way.
    for (int i = 0; i < iterations; ++i) {
      for (const Row& row : rows) row.solve(slop);
      std::reverse(rows.begin(), rows.end());
    }
    for (std::size_t i = 1; i < bodies.size(); ++i) move(bodies[i], world);
  }

  double deepest = 0;
  for (const auto& point : world.contacts().points) deepest = graze::greatest(deepest, -point.distance);
  const Vec3d top = bodies.back().pose.translation;
  std::printf(
      "%d iterations, slop %g m: after 20 s the top box is %.1f mm aside and %.1f mm down, deepest contact %.2f mm\n",
      iterations, slop, 1e3 * length(Vec3d{top.x, 0, top.z}), 1e3 * (9.5 - top.y), 1e3 * deepest);
  return top.y > 9 ? 0 : 1;
}
