// A world of the plane: a ball rolls down a chain into a zone, and the world tells what begins and ends on the way.
#include <graze/plane/world.hpp>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

int main() {
  namespace plane = graze::plane;
  plane::Worldd world;
  std::map<graze::BodyId, std::string> names;

  // The ground is a chain: what slides over it meets one line, and not its seams.
  const std::vector<plane::Vec2d> points{{-4, 2}, {-2, 1}, {0, 0.25}, {2, 0}, {6, 0}};
  plane::Body<double> ground{plane::Chain<double>(points)};
  ground.fixed = true;
  names[world.add(ground)] = "ground";

  plane::Body<double> zone{plane::Box<double>({1, 1}), {{3, 0.5}, {}}};
  zone.fixed = zone.trigger = true;  // tells who is inside, and stops nobody
  names[world.add(zone)] = "zone";

  constexpr double radius = 0.25, dt = 1.0 / 60;
  plane::Pose2d pose{{-3.5, 3}, {}};
  plane::Vec2d velocity{};
  const graze::BodyId ball = world.add({plane::Circle<double>(radius), pose});
  names[ball] = "ball";

  for (int frame = 0; frame < 140; ++frame) {
    velocity.y -= 9.81 * dt;
    pose.translation += velocity * dt;
    world.move(ball, pose);
    world.update();

    for (const graze::ContactEvent& e : world.events())
      if (e.kind != graze::EventKind::stay)
        std::printf("frame %3d: %s and %s %s at x = %.2f\n", frame, names[e.a].c_str(), names[e.b].c_str(),
                    e.kind == graze::EventKind::begin ? "begin to touch" : "no longer touch", pose.translation.x);

    // A poor man's solver: what has sunk is lifted out, and does not go deeper. Normals point from A to B: to the ball.
    const auto& contacts = world.contacts();
    for (const auto& pair : contacts.pairs)
      for (const auto& manifold : contacts.manifolds_of(pair))
        for (const auto& point : contacts.points_of(manifold)) {
          if (point.distance < 0) pose.translation -= manifold.normal * point.distance;
          if (const double into = dot(velocity, manifold.normal); into < 0) velocity -= manifold.normal * into;
        }
  }

  // What the world is asked: what is below the ball, and what is near.
  graze::QueryFilter others;
  others.accept = [&](graze::BodyId id) { return id != ball; };
  const auto below = world.raycast({pose.translation, {0, -1}}, 10, others);
  const auto nearest = world.closest(plane::Circle<double>(0), {{3, 3}, {}});
  std::printf("below the ball at x = %.2f: %s, %.2f from its centre; nearest to (3, 3): %s, %.2f away\n",
              pose.translation.x, below ? names[below->body].c_str() : "nothing", below ? below->hit.t : 0.0,
              nearest ? names[nearest->body].c_str() : "nothing", nearest ? nearest->distance.distance : 0.0);
}
