// Compounds, polygons and chains taken apart into convex shapes in place.
//
// Guarantee: visits every convex shape of a shape once, in order; `piece` is the number of the child or piece of the
// outermost shape.
#pragma once

#include <optional>
#include <type_traits>

#include "plane/core.hpp"
#include "plane/unit_rotation.hpp"

namespace graze::plane {

/// A filter of pieces that lets all of them through.
struct Everywhere {
  bool operator()(const Pose2d&, const Aabb2<double>&, double) const { return true; }
};

/// A walk over the convex shapes that a shape is made of.
template <class T, class Wanted, class F>
class LeafWalk {
 public:
  LeafWalk(const Wanted& wanted, F& f) : wanted_(wanted), f_(f) {}

  /// Visits a shape; `piece` is its number in the outermost one, none for that itself, and `grown` the rounding of the
  /// compounds that it is in.
  void visit(const Shape<T>& shape, const Pose2d& pose, std::optional<std::uint32_t> piece, double grown) {
    const double rounding = double(shape.rounding()) + grown;
    if (const auto* compound = shape.template as<Compound<T>>()) {
      std::uint32_t number = 0;
      for (const Placed<T>& child : compound->children()) {
        visit(child.shape, compose(pose, at_unit(child.pose)), piece.value_or(number), rounding);
        ++number;
      }
      return;
    }
    const double size = double(extent(shape)) + grown;
    const std::uint32_t leaf = leaf_++;
    const auto* polygon = shape.template as<Polygon<T>>();
    const auto* chain = shape.template as<Chain<T>>();
    if (!polygon && !chain) {
      Core<T> core = convex_core(shape);
      core.radius += grown;
      core.leaf = leaf;
      return f_(core, pose, size, piece.value_or(0));
    }
    const Pieces<T>& pieces = polygon ? polygon->pieces() : chain->pieces();
    const auto near = [&](const Aabb2<double>& box) { return wanted_(pose, box, rounding); };
    pieces.for_each(near, [&](std::uint32_t i) {
      Core<T> core = piece_core(pieces, i);
      core.radius = rounding;
      core.chain = chain;
      core.leaf = leaf;
      f_(core, pose, size, piece.value_or(i));
    });
  }

 private:
  const Wanted& wanted_;
  F& f_;
  std::uint32_t leaf_ = 0;
};

/// Calls `f(core, pose, extent, piece)`. The pose is in double and of unit length there, so that a float's rounding of
/// it does not lengthen what it turns. Pieces of polygons and chains are left out where `wanted(pose, box, rounding)`
/// refuses a box around them, in the frame of that pose. `grown` is the rounding of the compounds that the shape is in.
template <class T, class Wanted, class F>
void for_each_leaf(const Shape<T>& shape, const Pose2d& pose, const Wanted& wanted, F&& f, double grown = 0) {
  LeafWalk<T, Wanted, std::remove_reference_t<F>>(wanted, f).visit(shape, pose, {}, grown);
}
template <class T, class F>
void for_each_leaf(const Shape<T>& shape, const Pose2<T>& pose, F&& f) {
  for_each_leaf(shape, at_unit(pose), Everywhere{}, f);
}

/// Whether a shape has no half-plane in it.
template <class T>
bool is_bounded(const Shape<T>& shape) {
  if (shape.template as<HalfPlane<T>>()) return false;
  if (const auto* compound = shape.template as<Compound<T>>())
    for (const Placed<T>& child : compound->children())
      if (!is_bounded(child.shape)) return false;
  return true;
}

/// A lower bound of the distance of two discs whose centres are as far from each other as `between` is long.
inline double discs_apart(const Vec2d& between, double radius_a, double radius_b) {
  return length(between) * (1 - 1e-15) - (radius_a + radius_b) * (1 + 1e-15);
}

/// Two convex shapes in place, one of each body.
template <class T>
struct LeafPair {
  const Core<T>&a, &b;
  const Pose2d &pose_a, &pose_b;
  double extent_a, extent_b;
  std::uint32_t piece_a, piece_b;

  /// Whether both are bounded.
  bool bounded() const { return a.kind != CoreKind::half_plane && b.kind != CoreKind::half_plane; }
  /// A lower bound of their distance, by the discs around them. None where one is unbounded.
  double apart() const {
    if (!bounded()) return -std::numeric_limits<double>::infinity();
    return discs_apart(pose_b.translation - pose_a.translation, extent_a, extent_b);
  }
  double size() const { return greatest(extent_a, extent_b); }
};

/// Whether a disc reaches into a box of pieces, each rounded, or comes as near as `reach()` to it. The test leaves room
/// for the rounding of a few numbers as large as the way between them.
template <class Reach>
auto near_disc(const Vec2d& center, double radius, const Reach& reach) {
  return [center, radius, &reach](const Pose2d& pose, const Aabb2<double>& box, double rounding) {
    const Vec2d own = inverse_transform(pose, center);
    const Vec2d off = own - least(greatest(own, box.lower), box.upper);
    // A centre inside the box has no such bound for its depth.
    if (off == Vec2d{}) return true;
    return !(length(off) * (1 - 1e-14) - 1e-14 * length(own) > (radius + rounding) * (1 + 1e-14) + reach());
  };
}

/// Calls `f` with two shapes of one piece each, unless the discs around them are further apart than `reach`.
template <class T, class F>
void with_convex_pair(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                      double reach, F&& f) {
  const auto extent_a = double(extent(a)), extent_b = double(extent(b));
  if (!a.template as<HalfPlane<T>>() && !b.template as<HalfPlane<T>>()) {
    const Vec2d between = converted<double>(pose_b.translation) - converted<double>(pose_a.translation);
    if (discs_apart(between, extent_a, extent_b) > reach) return;
  }
  const Core<T> core_a = convex_core(a), core_b = convex_core(b);
  const Pose2d at_a = at_unit(pose_a), at_b = at_unit(pose_b);
  f(LeafPair<T>{core_a, core_b, at_a, at_b, extent_a, extent_b, 0, 0});
}

/// Calls `f` with every pair of convex shapes of two bodies but those that are surely further apart than `reach()`,
/// which may become less on the way.
template <class T, class Reach, class F>
void for_each_pair_within(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                          const Reach& reach, F&& f) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (a.convex() && b.convex()) return with_convex_pair(a, pose_a, b, pose_b, reach(), f);
  const Pose2d at_a = at_unit(pose_a), at_b = at_unit(pose_b);
  bool bounded = true;
  for (const Shape<T>* s : {&a, &b}) bounded = bounded && is_bounded(*s);
  const auto near_b = near_disc(at_b.translation, bounded ? double(extent(b)) : inf, reach);
  for_each_leaf(a, at_a, near_b,
                [&](const Core<T>& core_a, const Pose2d& in_a, double extent_a, std::uint32_t piece_a) {
                  const auto near_a = near_disc(in_a.translation, bounded ? extent_a : inf, reach);
                  for_each_leaf(b, at_b, near_a,
                                [&](const Core<T>& core_b, const Pose2d& in_b, double extent_b, std::uint32_t piece_b) {
                                  f(LeafPair<T>{core_a, core_b, in_a, in_b, extent_a, extent_b, piece_a, piece_b});
                                });
                });
}
/// Calls `f` with every pair of convex shapes of two bodies.
template <class T, class F>
void for_each_pair(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, F&& f) {
  for_each_pair_within(
      a, pose_a, b, pose_b, [] { return std::numeric_limits<double>::infinity(); }, f);
}

}  // namespace graze::plane
