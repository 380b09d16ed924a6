// The drawing of worlds, simulations and their parts: bodies, bounds, contacts, joints, trees.
#include <algorithm>

#include "draw/points.hpp"
#include "graze/draw.hpp"
#include "graze/error.hpp"

namespace graze {

namespace {

using draw_detail::draw_points;
using draw_detail::in_space;

/// One byte a body: whether a contact of the last update is its own.
template <class T, class Space>
std::vector<std::uint8_t> touching_bodies(const World<T, Space>& world) {
  std::vector<std::uint8_t> touching(world.bodies().size(), 0);
  for (const ContactPair<T>& pair : world.contacts().pairs)
    if (pair.overlap && pair.manifold_count > 0) touching[pair.a] = touching[pair.b] = 1;
  return touching;
}

template <class T, class Space>
DrawMeaning meaning_of(const World<T, Space>& world, std::uint32_t i, bool touching) {
  if (world.bodies().triggers()[i]) return DrawMeaning::trigger;
  if (world.bodies().fixed()[i]) return touching ? DrawMeaning::touched : DrawMeaning::fixed;
  return touching ? DrawMeaning::touching : DrawMeaning::moving;
}

template <class T, class Space>
void draw_contacts(DebugDraw& on, const World<T, Space>& world) {
  const ContactArrays<T, Space>& contacts = world.contacts();
  if (!on.wants(DrawLayer::contacts)) return;
  for (const ContactPair<T>& pair : contacts.pairs)
    for (const auto& manifold : contacts.manifolds_of(pair))
      draw_points(on, manifold.normal, contacts.points_of(manifold));
}

template <class T, class Space, class AnyPose>
void draw_body(DebugDraw& on, const World<T, Space>& world, std::uint32_t i, const AnyPose& pose, DrawMeaning meaning) {
  const auto& shape = world.bodies().shapes()[i];
  draw(on, shape, pose, meaning);
  if (on.wants(DrawLayer::bounds)) draw(on, Space::bounds(shape, pose));
}

/// Draws the bodies. `asleep(i)`: whether a body that touches something rests on it.
template <class T, class Space, class Poses, class Asleep>
void draw_bodies(DebugDraw& on, const World<T, Space>& world, const Poses& poses, const Asleep& asleep) {
  const auto& bodies = world.bodies();
  const std::vector<std::uint8_t> touching = touching_bodies(world);
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (bodies.alive()[i])
      draw_body(on, world, i, poses[i], asleep(i) ? DrawMeaning::asleep : meaning_of(world, i, touching[i] != 0));
}

/// The number of a body that is there.
template <class T, class Space>
std::uint32_t number_of(const World<T, Space>& world, BodyId id) {
  if (!world.bodies().contains(id)) throw InvalidValue("id", "a body of this world", "one that is not in it");
  return id.index;
}

template <class T, class Space>
bool touches(const World<T, Space>& world, std::uint32_t body) {
  const auto& pairs = world.contacts().pairs;
  return std::any_of(pairs.begin(), pairs.end(), [&](const ContactPair<T>& pair) {
    return pair.overlap && pair.manifold_count > 0 && (pair.a == body || pair.b == body);
  });
}

/// Draws the boxes of a tree, each as `shown` gives it.
template <class T, class Shown>
void draw_tree(DebugDraw& on, const DynamicTree<T>& tree, const Shown& shown) {
  if (!on.wants(DrawLayer::tree)) return;
  const auto draw_box = [&](const Aabb<T>& box) {
    draw(on, shown(box), DrawLayer::tree, DrawMeaning::bounds);
    return true;
  };
  tree.visit(draw_box, [](std::uint32_t, const Aabb<T>&) {});
}

template <class T>
void draw_tree_of(DebugDraw& on, const World<T, Space<T>>& world) {
  draw(on, world.tree());
}
/// The boxes of a tree are those of space. In the plane only the margin around bodies is left of their third side.
template <class T>
void draw_tree_of(DebugDraw& on, const World<T, plane::Space<T>>& world) {
  draw_tree(on, world.tree(), [](Aabb<T> box) {
    box.lower.z = box.upper.z = T(0);
    return box;
  });
}

template <class AnyJoint, class AnyPose>
void draw_joint(DebugDraw& on, const AnyJoint& joint, const AnyPose& pose_a, const AnyPose& pose_b) {
  if (!on.wants(DrawLayer::joints)) return;
  const Vec3d a = in_space(transform(pose_a, joint.frame_a.translation));
  const Vec3d b = in_space(transform(pose_b, joint.frame_b.translation));
  on.line(in_space(pose_a.translation), a, DrawLayer::joints, DrawMeaning::joint);
  on.line(in_space(pose_b.translation), b, DrawLayer::joints, DrawMeaning::joint);
  on.line(a, b, DrawLayer::joints, DrawMeaning::gap);
  on.point(a, DrawLayer::joints, DrawMeaning::a);
  on.point(b, DrawLayer::joints, DrawMeaning::b);
}

}  // namespace

template <class T, class Space>
DrawArea draw_area(const World<T, Space>& world) {
  Aabb<T> all = Aabb<T>::empty();
  const auto& bodies = world.bodies();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.alive()[i]) continue;
    const Aabb<T> box = Space::bounds(bodies.shapes()[i], bodies.poses()[i]);
    if (max_abs(box.extent()) < std::numeric_limits<T>::infinity()) all = merged(all, box);
  }
  DrawArea area;
  if (all.lower.x <= all.upper.x) area.center = (in_space(all.lower) + in_space(all.upper)) * 0.5;
  if (const double size = max_abs(in_space(all.extent())); size > 0 && all.lower.x <= all.upper.x) area.size = size;
  return area;
}

template <class T>
void draw(DebugDraw& on, const DynamicTree<T>& tree) {
  draw_tree(on, tree, [](const Aabb<T>& box) { return box; });
}

template <class T>
void draw(DebugDraw& on, const Joint<T>& joint, const Pose<T>& pose_a, const Pose<T>& pose_b) {
  draw_joint(on, joint, pose_a, pose_b);
}
template <class T>
void draw(DebugDraw& on, const Joint<T, plane::Space<T>>& joint, const plane::Pose2<T>& pose_a,
          const plane::Pose2<T>& pose_b) {
  draw_joint(on, joint, pose_a, pose_b);
}

template <class T, class Space>
void draw(DebugDraw& on, const World<T, Space>& world) {
  draw_bodies(on, world, world.bodies().poses(), [](std::uint32_t) { return false; });
  draw_tree_of(on, world);
  draw_contacts(on, world);
}

template <class T, class Space>
void draw(DebugDraw& on, const World<T, Space>& world, BodyId body) {
  const std::uint32_t i = number_of(world, body);
  draw_body(on, world, i, world.bodies().poses()[i], meaning_of(world, i, touches(world, i)));
}

template <class T, class Space>
void draw(DebugDraw& on, const Simulation<T, Space>& simulation, BodyId body) {
  const World<T, Space>& world = simulation.world();
  const std::uint32_t i = number_of(world, body);
  const bool asleep = simulation.asleep(body);
  draw_body(on, world, i, simulation.poses()[i],
            asleep ? DrawMeaning::asleep : meaning_of(world, i, touches(world, i)));
}

template <class T, class Space>
void draw(DebugDraw& on, const Simulation<T, Space>& simulation) {
  const World<T, Space>& world = simulation.world();
  const auto& poses = simulation.poses();
  draw_bodies(on, world, poses, [&](std::uint32_t i) { return simulation.asleep(world.bodies().id(i)); });
  draw_tree_of(on, world);
  draw_contacts(on, world);
  if (!on.wants(DrawLayer::joints)) return;
  for (const JointId id : simulation.joints()) {
    const Joint<T, Space>& joint = simulation.joint(id);
    draw(on, joint, poses[joint.a.index], poses[joint.b.index]);
  }
}

#define GRAZE_DRAW_WORLDS(T, Space)                                                                                    \
  template DrawArea draw_area(const World<T, Space<T>>&);                                                              \
  template void draw(DebugDraw&, const World<T, Space<T>>&);                                                           \
  template void draw(DebugDraw&, const World<T, Space<T>>&, BodyId);                                                   \
  template void draw(DebugDraw&, const Simulation<T, Space<T>>&, BodyId);                                              \
  template void draw(DebugDraw&, const Simulation<T, Space<T>>&)
#define GRAZE_DRAW_PARTS(T)                                                                                            \
  template void draw(DebugDraw&, const DynamicTree<T>&);                                                               \
  template void draw(DebugDraw&, const Joint<T>&, const Pose<T>&, const Pose<T>&);                                     \
  template void draw(DebugDraw&, const Joint<T, plane::Space<T>>&, const plane::Pose2<T>&, const plane::Pose2<T>&)
GRAZE_DRAW_PARTS(float);
GRAZE_DRAW_PARTS(double);
GRAZE_DRAW_WORLDS(float, Space);
GRAZE_DRAW_WORLDS(double, Space);
GRAZE_DRAW_WORLDS(float, plane::Space);
GRAZE_DRAW_WORLDS(double, plane::Space);
#undef GRAZE_DRAW_WORLDS
#undef GRAZE_DRAW_PARTS

}  // namespace graze
