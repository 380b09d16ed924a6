// A capsule walks through a scene: over a floor, up steps, along a wall, into a corner.
//
// `slide` moves a shape until it touches and turns the rest along the surface. A step is the same way a little higher,
// and down again; it is taken when it leads further.
#include <graze/slide.hpp>

#include <cstdio>

namespace {

using graze::Posed;
using graze::Vec3d;

constexpr double step_height = 0.35, radius = 0.3, half_height = 0.9;

class Walker {
 public:
  explicit Walker(const graze::Worldd& world) : world_(world) {}

  const Vec3d& position() const { return pose_.translation; }

  /// One frame's way: as it is, or over a step; then down to the ground.
  void walk(const Vec3d& motion) {
    const Posed flat = slid(pose_, motion);
    const Posed raised = slid(slid(pose_, {0, step_height, 0}), motion);
    const Posed stepped = dropped(raised, step_height);
    pose_ = made(stepped, motion) > made(flat, motion) + 1e-3 ? stepped : dropped(flat, step_height);
  }

 private:
  Posed slid(const Posed& from, const Vec3d& motion) const { return graze::slide(shape_, from, motion, world_).pose; }
  /// Down to the ground and no further; nothing slides off an edge.
  Posed dropped(const Posed& from, double height) const {
    const auto hit = world_.cast(shape_, from, {{0, -height, 0}, {}}, 1, {}, {graze::Separating::ignored});
    return {from.translation - Vec3d{0, hit ? height * hit->hit.t : height, 0}, from.rotation};
  }
  double made(const Posed& to, const Vec3d& motion) const {
    return dot(to.translation - pose_.translation, graze::normalized(motion));
  }

  const graze::Worldd& world_;
  graze::Shaped shape_ = graze::Capsule<double>(2 * (half_height - radius), radius, radius);
  Posed pose_{{0, half_height, 0}, {}};
};

void add_box(graze::Worldd& world, const Vec3d& size, const Vec3d& center) {
  graze::Body<double> body{graze::Shaped(graze::Box<double>(size)), {center, {}}};
  body.fixed = true;
  world.add(body);
}

}  // namespace

int main() {
  graze::Worldd world;
  world.add({graze::Shaped(graze::HalfSpace<double>())});
  for (int i = 0; i < 4; ++i) {  // four steps of 0.25, the last one a landing
    const double height = 0.25 * (i + 1), length = i == 3 ? 4 : 0.5;
    add_box(world, {length, height, 4}, {3 + 0.5 * i + length / 2, height / 2, 0});
  }
  add_box(world, {0.2, 3, 20}, {8.6, 1.5, 0});  // a wall across the way, which leads along it
  add_box(world, {20, 3, 0.2}, {0, 1.5, 1.9});  // and another: a corner

  Walker walker(world);
  std::printf("frame      x      y      z\n");
  for (int frame = 0; frame <= 120; ++frame) {
    if (frame % 10 == 0) {
      const Vec3d feet = walker.position() - Vec3d{0, half_height, 0};
      std::printf("%5d %6.2f %6.2f %6.2f\n", frame, feet.x, feet.y + 0.0, feet.z);
    }
    walker.walk({0.1, 0, 0.02});
  }
}
