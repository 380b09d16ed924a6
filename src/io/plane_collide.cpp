#include <algorithm>
#include <numeric>

#include "graze/io/plane_scene.hpp"
#include "graze/plane/query.hpp"
#include "io/scene_world.hpp"
#include "io/single_plane_shape.hpp"

namespace graze::io {

namespace {

/// A collider in the precision of the questions, and its bounds with half of the margin around them.
template <class T>
struct Placed2 {
  plane::Shape<T> shape;
  plane::Pose2<T> pose;
  plane::Aabb2<T> box;
};

template <class T>
Placed2<T> placed(const PlaneScene& scene, const PlaneCollider& c, T margin) {
  try {
    Placed2<T> out{in_precision<T>(c.shape), plane::converted<T>(c.pose), {}};
    plane::detail::checked_point(out.pose.translation, "translation");
    out.box = plane::bounds(out.shape, out.pose);
    // Up by a rounding, so that bounds touch wherever shapes come within the margin.
    const T reach = margin * (T(1) + 4 * std::numeric_limits<T>::epsilon()) +
                    4 * std::numeric_limits<T>::epsilon() * plane::max_abs(out.pose.translation);
    out.box.lower -= {reach, reach};
    out.box.upper += {reach, reach};
    return out;
  } catch (const InvalidValue& e) {
    throw e.below(scene.source + ": " + c.name);
  }
}

template <class T>
Manifolds<double> in_space(const plane::Manifolds<T>& manifolds) {
  const auto wide = [](const plane::Vec2<T>& v) { return Vec3d{double(v.x), double(v.y), 0}; };
  Manifolds<double> out;
  for (const plane::Manifold<T>& m : manifolds) {
    Manifold<double>& to = out.emplace_back();
    to.normal = wide(m.normal);
    to.piece_a = m.piece_a;
    to.piece_b = m.piece_b;
    for (const plane::ContactPoint<T>& p : m.points)
      to.points.push_back({wide(p.a), wide(p.b), double(p.distance), p.feature, double(p.weight)});
  }
  return out;
}

template <class T>
std::vector<TouchingPair> collide_in(const PlaneScene& scene, const CollideOptions& options) {
  const T margin = checked_margin<T>(options.margin);
  const std::vector<PlaneCollider>& colliders = scene.colliders;
  std::vector<Placed2<T>> all;
  all.reserve(colliders.size());
  for (const PlaneCollider& c : colliders) all.push_back(placed(scene, c, margin));
  const auto is_fixed = [&](std::uint32_t i) { return scene.bodies[colliders[i].body].type == MotionType::fixed; };
  const bool moves = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                 [](const PlaneSceneBody& b) { return b.type != MotionType::fixed; });
  // Sort and sweep along X.
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t k) { return all[i].box.lower.x < all[k].box.lower.x; });
  std::vector<TouchingPair> touching;
  plane::Manifolds<T> manifolds;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (options.progress && k % 64 == 0) options.progress(k, order.size());
    for (std::size_t l = k + 1; l < order.size() && all[order[l]].box.lower.x <= all[order[k]].box.upper.x; ++l) {
      const auto [i, j] = std::minmax(order[k], order[l]);
      if (moves && is_fixed(i) && is_fixed(j)) continue;
      const PlaneCollider &a = colliders[i], &b = colliders[j];
      if (!may_collide(a.filter, b.filter) || !plane::overlap(all[i].box, all[j].box)) continue;
      manifolds.clear();
      const bool overlap = plane::contacts(all[i].shape, all[i].pose, all[j].shape, all[j].pose, margin, manifolds);
      if (!overlap && manifolds.empty()) continue;
      touching.push_back({i, j, overlap, a.trigger || b.trigger, in_space(manifolds)});
    }
  }
  if (options.progress) options.progress(order.size(), order.size());
  std::sort(touching.begin(), touching.end(),
            [](const TouchingPair& p, const TouchingPair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  return touching;
}

}  // namespace

std::vector<TouchingPair> collide(const PlaneScene& scene, const CollideOptions& options) {
  return options.precision == Precision::double_precision ? collide_in<double>(scene, options)
                                                          : collide_in<float>(scene, options);
}

}  // namespace graze::io
