#include "simulate_picture.hpp"

#include <algorithm>
#include <cmath>

#include "graze/io/collide.hpp"
#include "graze/io/file.hpp"
#include "graze/io/picture.hpp"
#include "graze/plane/space.hpp"

namespace graze::cli {

namespace {

Aabbd box_of(const io::Collider& c) { return bounds(c.shape, c.pose); }
Aabbd box_of(const io::PlaneCollider& c) { return plane::Space<double>::bounds(c.shape, c.pose); }

Vec3d origin_of(const io::Collider& c) { return c.pose.translation; }
Vec3d origin_of(const io::PlaneCollider& c) { return {c.pose.translation.x, c.pose.translation.y, 0}; }

/// The bounds of all bounded colliders; empty where there is none.
template <class AnyScene>
Aabbd bounds_of(const AnyScene& scene) {
  Aabbd all = Aabbd::empty();
  for (const auto& c : scene.colliders)
    if (const Aabbd box = box_of(c); max_abs(box.extent()) < 1e300) all = merged(all, box);
  return all;
}

const Posed& pose_of_body(const io::Scene& scene, std::uint32_t body) { return scene.bodies[body].pose; }
/// A body of the plane is where its first collider is.
const plane::Pose2d& pose_of_body(const io::PlaneScene& scene, std::uint32_t body) {
  return std::find_if(scene.colliders.begin(), scene.colliders.end(),
                      [&](const io::PlaneCollider& c) { return c.body == body; })
      ->pose;
}

const Posed& pose_of(const io::BodyState& state) { return state.pose; }
plane::Pose2d pose_of(const io::PlaneBodyState& state) {
  return {state.translation, plane::Rot2d::from_angle(state.rotation)};
}

/// The scene with its bodies where a frame has them, but for those that have left it by more than its own size.
template <class AnyScene, class Frame>
AnyScene moved_to(const AnyScene& scene, const Frame& frame) {
  AnyScene moved = scene;
  moved.colliders.clear();
  const Aabbd around = bounds_of(scene);
  const Vec3d size = around.extent();
  const auto moving = io::moving_bodies(scene);
  for (auto c : scene.colliders) {
    const auto at = std::find(moving.begin(), moving.end(), c.body);
    if (at != moving.end()) {
      const auto& state = frame.bodies[static_cast<std::size_t>(at - moving.begin())];
      c.pose = compose(pose_of(state), relative(pose_of_body(scene, c.body), c.pose));
    }
    const Vec3d past = origin_of(c) - around.center();
    if (std::abs(past.x) <= size.x && std::abs(past.y) <= size.y && std::abs(past.z) <= size.z)
      moved.colliders.push_back(std::move(c));
  }
  return moved;
}

std::string drawn(const io::Scene& scene) { return io::draw_picture(scene, io::collide(scene), {1, 0.6, 1.4}); }
std::string drawn(const io::PlaneScene& scene) { return io::draw_picture(scene, io::collide(scene)); }

template <class AnyScene>
void write_two(const std::string& file, AnyScene before, AnyScene after) {
  before.source += ", before";
  after.source += ", after";
  std::string below = drawn(after);
  const std::size_t root = below.find("<svg");
  below.insert(root + 4, " y=\"600\"");
  io::write_file(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 1200\" width=\"960\" "
                       "height=\"1200\">\n" +
                           drawn(before) + below.substr(root) + "</svg>\n");
}

}  // namespace

void write_pictures(const std::string& file, const io::Scene& scene, const io::SimulationFrame& last) {
  write_two(file, scene, moved_to(scene, last));
}

void write_pictures(const std::string& file, const io::PlaneScene& scene, const io::PlaneSimulationFrame& last) {
  write_two(file, scene, moved_to(scene, last));
}

}  // namespace graze::cli
