// What composites are compared with: every convex piece against every other, without any hierarchy.
#pragma once

#include <algorithm>

#include "common/specimen.hpp"
#include "composite/internal_edges/ghost_contacts.hpp"
#include "graze/query.hpp"
#include "narrow/general_contacts.hpp"

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

/// The manifold of a pair of pieces, alone; and whether it is what a composite answers: not where a solid may have met
/// the inner edge of a surface.
template <class T>
struct PieceManifold {
  Manifold<T> manifold;
  bool stands;
};

/// Those of all pairs of pieces.
template <class T>
std::vector<PieceManifold<T>> brute_force_manifolds(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                    const Pose<T>& pose_b, T margin) {
  std::vector<PieceManifold<T>> all;
  const auto pieces_b = pieces_of(b, pose_b);
  for (const auto& p : pieces_of(a, pose_a))
    for (const auto& q : pieces_b) {
      Manifolds<T> manifolds;
      contacts(p.shape, p.pose, q.shape, q.pose, margin, manifolds);
      const bool stands = (a.convex() || !is_solid(q.shape)) && (b.convex() || !is_solid(p.shape));
      for (const auto& m : manifolds) all.push_back({m, stands});
      // Two composites are answered in an order of their own, in which pieces of one kind may have other last bits.
      manifolds.clear();
      contacts(q.shape, q.pose, p.shape, p.pose, margin, manifolds);
      for (auto& m : manifolds) {
        mirror(m);
        all.push_back({m, stands});
      }
    }
  return all;
}

/// Whether a point lies between those of a manifold and not deeper than they are there: then in no direction across the
/// normal, and for no weight of the depth, it reaches further than all of them.
template <class T>
bool spanned(const ContactPoint<T>& point, const Manifold<T>& by, Random& random, T noise) {
  for (int i = 0; i < 32; ++i) {
    const Vec3<T> any = converted<T>(random_vector(random, 1));
    const Vec3<T> across = any - by.normal * dot(any, by.normal);
    const T weight = i % 4 == 0 ? T(100) : static_cast<T>(uniform(random, 0, 2));
    const auto reaches = [&](const ContactPoint<T>& q) {
      return dot(q.a - point.a, across) - weight * (q.distance - point.distance) >= -noise * (T(1) + weight);
    };
    if (std::none_of(by.points.begin(), by.points.end(), reaches)) return false;
  }
  return true;
}

/// Whether the manifolds answer for all that pairs of pieces find: they have each of their points or others around it,
/// and none that no pair has.
template <class T>
void expect_manifolds(const Manifolds<T>& manifolds, const std::vector<PieceManifold<T>>& expected, T noise) {
  Random random(99);
  const auto same_normal = [&](const Vec3<T>& m, const Vec3<T>& n) { return length(m - n) <= noise; };
  bool all_stand = true;
  for (const PieceManifold<T>& of : expected) {
    all_stand = all_stand && of.stands;
    if (!of.stands) continue;
    for (const ContactPoint<T>& p : of.manifold.points)
      EXPECT_TRUE(std::any_of(manifolds.begin(), manifolds.end(), [&](const Manifold<T>& m) {
        return same_normal(m.normal, of.manifold.normal) && spanned(p, m, random, noise);
      }));
  }
  if (!all_stand) return;
  for (const Manifold<T>& m : manifolds)
    for (const ContactPoint<T>& p : m.points)
      EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const PieceManifold<T>& e) {
        const auto same = [&](const ContactPoint<T>& q) { return q.a == p.a && q.b == p.b; };
        return same_normal(e.manifold.normal, m.normal) &&
               std::any_of(e.manifold.points.begin(), e.manifold.points.end(), same);
      }));
}

}  // namespace graze::testing
