// What composites are compared with: every convex piece against every other, without any hierarchy.
#pragma once

#include <algorithm>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {

/// The convex pieces of a shape, each where it stands.
template <class T>
void append_pieces(const Shape<T>& shape, const Pose<T>& pose, std::vector<Placed<T>>& out) {
  if (const auto* mesh = shape.template as<Mesh<T>>()) {
    for (const auto& t : mesh->triangles())
      out.push_back({Triangle<T>(mesh->points()[t[0]], mesh->points()[t[1]], mesh->points()[t[2]]), pose});
  } else if (const auto* field = shape.template as<HeightField<T>>()) {
    for (std::uint32_t i = 0; i < field->triangle_numbers(); ++i) {
      if (!field->has_triangle(i)) continue;
      const auto t = field->triangle(i);
      out.push_back({Triangle<T>(t[0], t[1], t[2]), pose});
    }
  } else if (const auto* compound = shape.template as<Compound<T>>()) {
    for (const auto& child : compound->children()) append_pieces(child.shape, compose(pose, child.pose), out);
  } else {
    out.push_back({shape, pose});
  }
}

template <class T>
std::vector<Placed<T>> pieces_of(const Shape<T>& shape, const Pose<T>& pose) {
  std::vector<Placed<T>> out;
  append_pieces(shape, pose, out);
  return out;
}

/// The smallest signed distance of all pairs of pieces.
template <class T>
T brute_force_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  T least = std::numeric_limits<T>::infinity();
  const auto pieces_b = pieces_of(b, pose_b);
  for (const auto& p : pieces_of(a, pose_a))
    for (const auto& q : pieces_b) least = std::min(least, distance(p.shape, p.pose, q.shape, q.pose).distance);
  return least;
}

/// Every point of contact of all pairs of pieces.
template <class T>
std::vector<ContactPoint<T>> brute_force_points(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                const Pose<T>& pose_b, T margin) {
  std::vector<ContactPoint<T>> points;
  const auto pieces_b = pieces_of(b, pose_b);
  for (const auto& p : pieces_of(a, pose_a))
    for (const auto& q : pieces_b) {
      Manifolds<T> manifolds;
      contacts(p.shape, p.pose, q.shape, q.pose, margin, manifolds);
      for (const auto& m : manifolds) points.insert(points.end(), m.points.begin(), m.points.end());
    }
  return points;
}

/// The points of manifolds, sorted, those that coincide on both shapes once.
template <class T>
std::vector<std::array<T, 6>> different_points(const std::vector<ContactPoint<T>>& points) {
  std::vector<std::array<T, 6>> out;
  for (const auto& p : points) out.push_back({p.a.x, p.a.y, p.a.z, p.b.x, p.b.y, p.b.z});
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

template <class T>
std::vector<ContactPoint<T>> all_points(const Manifolds<T>& manifolds) {
  std::vector<ContactPoint<T>> points;
  for (const auto& m : manifolds) points.insert(points.end(), m.points.begin(), m.points.end());
  return points;
}

}  // namespace graze::testing
