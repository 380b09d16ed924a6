#include "io/collider_motion.hpp"

#include <algorithm>

#include "io/scaled_shape.hpp"

namespace graze::io {

namespace {

bool in_range(const Vec3d& v) {
  return !validate::fault_of_coordinate(v.x) && !validate::fault_of_coordinate(v.y) &&
         !validate::fault_of_coordinate(v.z);
}

/// Whether two maps differ by a rotation alone: their axes have the same lengths and angles, up to what files hold.
bool same_but_turned(const Mat3d& a, const Mat3d& b) {
  if ((determinant(a) < 0) != (determinant(b) < 0)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      const double room = file_precision * length(b.column(i)) * length(b.column(j));
      if (!(std::abs(dot(a.column(i), a.column(j)) - dot(b.column(i), b.column(j))) <= room)) return false;
    }
  return true;
}

}  // namespace

ColliderMotion::ColliderMotion(const Scene& scene, const Animation& animation) : tracks_(animation.tracks) {
  const NodeTree& tree = *tracks_->tree;
  const auto has = [](std::size_t first, std::size_t count, std::size_t all) {
    return first <= all && count <= all - first;
  };
  if (!has(animation.first_collider, tree.colliders.size(), scene.colliders.size()))
    throw InvalidValue(scene.source, "the colliders that its animations were read with", "fewer");
  if (!has(animation.first_body, tree.bodies.size(), scene.bodies.size()))
    throw InvalidValue(scene.source, "the bodies that its animations were read with", "fewer");
  for (const Channel& c : tracks_->channels) channels_.push_back(&c);
  std::sort(channels_.begin(), channels_.end(), [](const Channel* x, const Channel* y) {
    return std::pair(x->node, x->property) < std::pair(y->node, y->property);
  });

  const std::vector<char> moves = moving_nodes();
  add_steps(moves);
  std::vector<std::size_t> step_of(tree.nodes.size(), 0);
  for (std::size_t i = 0; i < steps_.size(); ++i) step_of[steps_[i].node] = i;
  for (std::size_t i = 0; i < tree.colliders.size(); ++i) {
    const RestCollider& rest = tree.colliders[i];
    if (!moves[rest.node]) continue;
    const auto index = animation.first_collider + static_cast<std::uint32_t>(i);
    const Collider& collider = scene.colliders[index];
    moved_.push_back({index, true, false, collider.pose, collider.shape});
    made_.push_back({step_of[rest.node], rest.shape, rest.map, collider.pose.rotation});
  }
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    if (!moves[tree.bodies[i]]) continue;
    const auto index = animation.first_body + static_cast<std::uint32_t>(i);
    bodies_.push_back({index, scene.bodies[index].pose});
    steps_of_bodies_.push_back(step_of[tree.bodies[i]]);
  }
}

/// The nodes that move: those with a channel, and all below them.
std::vector<char> ColliderMotion::moving_nodes() const {
  const NodeTree& tree = *tracks_->tree;
  std::vector<char> moves(tree.nodes.size(), 0);
  for (const Channel* c : channels_) moves[c->node] = 1;
  for (const std::size_t n : tree.order)
    if (tree.nodes[n].parent >= 0 && moves[static_cast<std::size_t>(tree.nodes[n].parent)]) moves[n] = 1;
  return moves;
}

/// Adds a step for each node that moves with a collider or body, and for those above them.
void ColliderMotion::add_steps(const std::vector<char>& moves) {
  const NodeTree& tree = *tracks_->tree;
  std::vector<char> wanted(tree.nodes.size(), 0);
  for (const RestCollider& c : tree.colliders)
    if (moves[c.node]) wanted[c.node] = 1;
  for (const std::size_t n : tree.bodies)
    if (moves[n]) wanted[n] = 1;
  for (auto n = tree.order.rbegin(); n != tree.order.rend(); ++n)
    if (wanted[*n] && tree.nodes[*n].parent >= 0) wanted[static_cast<std::size_t>(tree.nodes[*n].parent)] = 1;

  std::vector<std::size_t> step_of(tree.nodes.size(), 0);
  for (const std::size_t n : tree.order) {
    if (!wanted[n]) continue;
    const auto first =
        std::partition_point(channels_.begin(), channels_.end(), [n](const Channel* c) { return c->node < n; });
    const auto end = std::find_if(first, channels_.end(), [n](const Channel* c) { return c->node != n; });
    const std::ptrdiff_t parent = tree.nodes[n].parent;
    step_of[n] = steps_.size();
    steps_.push_back({n, parent < 0 ? -1 : static_cast<std::ptrdiff_t>(step_of[static_cast<std::size_t>(parent)]),
                      first != end, static_cast<std::size_t>(first - channels_.begin()),
                      static_cast<std::size_t>(end - channels_.begin())});
  }
}

void ColliderMotion::go_to(double t) {
  for (Step& step : steps_) {
    const TreeNode& node = tracks_->tree->nodes[step.node];
    Affine map = node.map;
    if (step.animated) {
      NodeTransform local = node.rest;
      for (std::size_t i = step.first_channel; i < step.end_channel; ++i) {
        const Channel& c = *channels_[i];
        if (c.property == NodeProperty::translation) local.translation = c.keys.vector(t);
        if (c.property == NodeProperty::rotation) local.rotation = c.keys.rotation(t);
        if (c.property == NodeProperty::scale) local.scale = c.keys.vector(t);
      }
      map = local.map();
    }
    step.world = step.parent < 0 ? map : steps_[static_cast<std::size_t>(step.parent)].world * map;
  }
  for (std::size_t i = 0; i < moved_.size(); ++i) place(i, t);
  for (std::size_t i = 0; i < bodies_.size(); ++i) place_body(i, t);
}

std::string ColliderMotion::path(std::size_t step, double t) const {
  return "nodes[" + std::to_string(steps_[step].node) + "] (in the world, at " + validate::number(t) + " s)";
}

/// Checks that a step's map is one to compute with. A map with infinities would seem to have no volume.
void ColliderMotion::check_in_range(std::size_t step, double t) const {
  const Affine& map = steps_[step].world;
  for (const Vec3d& row : map.linear.row)
    if (!in_range(row)) validate::point(row, path(step, t) + ".scale");
  if (!in_range(map.translation)) validate::point(map.translation, path(step, t) + ".translation");
}

void ColliderMotion::place_body(std::size_t i, double t) {
  const std::size_t step = steps_of_bodies_[i];
  check_in_range(step, t);
  if (is_regular(steps_[step].world)) bodies_[i].pose = body_pose(steps_[step].world);
}

void ColliderMotion::place(std::size_t i, double t) {
  MovedCollider& moved = moved_[i];
  Made& made = made_[i];
  const Affine& map = steps_[made.step].world;
  moved.reshaped = false;
  check_in_range(made.step, t);
  moved.shown = is_regular(map);
  if (!moved.shown) return;
  moved.pose.translation = map.translation;
  if (same_but_turned(map.linear, made.map.linear)) {
    const Mat3d turn = turned_axes(map.linear) * transposed(turned_axes(made.map.linear));
    moved.pose.rotation = normalized(rotation_quaternion(turn) * made.rotation);
    return;
  }
  try {
    MappedShape result = mapped(made.base, map);
    moved.shape = std::move(result.shape);
    moved.pose = result.pose;
  } catch (const InvalidValue& e) {
    throw e.below(path(made.step, t));
  }
  moved.reshaped = true;
  made.map = map;
  made.rotation = moved.pose.rotation;
}

}  // namespace graze::io
