#include "simulate_picture.hpp"

#include <cmath>
#include <vector>

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

/// The poses of all bodies as the scene begins.
std::vector<Posed> poses_of_bodies(const io::Scene& scene) {
  std::vector<Posed> poses;
  for (const io::Body& body : scene.bodies) poses.push_back(body.pose);
  return poses;
}
/// A body of the plane is where its first collider is.
std::vector<plane::Pose2d> poses_of_bodies(const io::PlaneScene& scene) {
  std::vector<plane::Pose2d> poses(scene.bodies.size());
  for (auto c = scene.colliders.rbegin(); c != scene.colliders.rend(); ++c) poses[c->body] = c->pose;
  return poses;
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
  const auto begun = poses_of_bodies(scene);
  auto ended = begun;
  const auto moving = io::moving_bodies(scene);
  for (std::size_t i = 0; i < moving.size(); ++i) ended[moving[i]] = pose_of(frame.bodies[i]);
  std::vector<bool> moves(begun.size());
  for (const std::uint32_t body : moving) moves[body] = true;
  for (auto c : scene.colliders) {
    if (moves[c.body]) c.pose = compose(ended[c.body], relative(begun[c.body], c.pose));
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
