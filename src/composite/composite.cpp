#include "composite/composite.hpp"

#include <algorithm>

#include "composite/leaf_pairs.hpp"
#include "composite/solid.hpp"
#include "composite/touching_pieces.hpp"
#include "narrow/alike_order.hpp"
#include "narrow/general_contacts.hpp"
#include "narrow/pair_table.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// Whether two pieces are further apart along the best normal so far than what is nearest: two support points tell,
/// where the distance takes an iteration. Triangles have been asked before.
template <class T>
bool ruled_out(const Part<T>& a, const Part<T>& b, const Distance<T>& best) {
  const Shape<T>&shape_a = a.shape, &shape_b = b.shape;
  if (best.normal == Vec3<T>{} || shape_a.template as<HalfSpace<T>>() || shape_b.template as<HalfSpace<T>>() ||
      (shape_a.template as<Triangle<T>>() && shape_b.template as<Triangle<T>>()))
    return false;
  // Seen from A, since far from the world's origin both points would be rounded.
  const Vec3<T> normal = rotate(conjugate(a.pose.rotation), best.normal);
  const Pose<T> b_in_a = relative(a.pose, b.pose);
  const Vec3<T> high = support(shape_a, normal);
  const Vec3<T> low = transform(b_in_a, support(shape_b, rotate(conjugate(b_in_a.rotation), -normal)));
  const T slack = T(32) * std::numeric_limits<T>::epsilon() * (max_abs(high) + max_abs(low));
  return dot(low - high, normal) > best.distance + slack;
}

/// The answer `best`, or that of a body inside a solid mesh, which is deeper than the mesh's surface is far.
template <class T>
Distance<T> or_enclosed(const Distance<T>& best, const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                        const Pose<T>& pose_b) {
  // Two shapes of one part each that touch do not lie inside one another.
  if (!(best.distance > T(0)) && !is_compound(a) && !is_compound(b)) return best;
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  return inside && inside->distance.distance < best.distance ? inside->distance : best;
}

}  // namespace

template <class T>
Distance<T> any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit) {
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b);
  Distance<T> best;
  best.distance = limit;
  bool found = false;
  auto nearer = [&](const Part<T>& pa, const Part<T>& pb) {
    if (ruled_out(pa, pb, best)) return;
    const Distance<T> d = convex_distance(pa.shape, pa.pose, pb.shape, pb.pose);
    if (d.distance < best.distance || (!found && d.distance == best.distance)) {
      best = d;
      found = true;
    }
  };
  visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {best.distance, &best.normal}, PairVisitor<T>(nearer));
  if (!found) best.distance = std::numeric_limits<T>::infinity();
  return has_solid_mesh(a) || has_solid_mesh(b) ? or_enclosed(best, a, pose_a, b, pose_b) : best;
}

template <class T>
bool any_within(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit) {
  if (!(limit > T(0))) return any_overlap(a, pose_a, b, pose_b);
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b).distance <= limit;
  auto beyond = [&](const Part<T>& pa, const Part<T>& pb) {
    return !(convex_distance(pa.shape, pa.pose, pb.shape, pb.pose).distance <= limit);
  };
  return !visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {just_above(limit)}, PairVisitor<T>(beyond)) ||
         any_enclosed(a, pose_a, b, pose_b);
}

template <class T>
void any_near_pieces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                     std::vector<PieceDistance<T>>& out) {
  auto keep = [&](const Part<T>& pa, const Part<T>& pb) {
    const Distance<T> d = convex_distance(pa.shape, pa.pose, pb.shape, pb.pose);
    if (d.distance <= margin) out.push_back({pa.number, pb.number, d});
  };
  visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {margin}, PairVisitor<T>(keep));
}

template <class T>
bool any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  if (a.convex() && b.convex()) return convex_overlap(a, pose_a, b, pose_b);
  const T touching(0);
  auto apart = [&](const Part<T>& pa, const Part<T>& pb) {
    return !convex_overlap(pa.shape, pa.pose, pb.shape, pb.pose);
  };
  return !visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {touching}, PairVisitor<T>(apart)) ||
         any_enclosed(a, pose_a, b, pose_b);
}

namespace {

/// The radius of a shape about its own origin; none of a half-space.
template <class T>
T size_about_origin(const Shape<T>& shape) {
  return shape.visit([&](const auto& c) -> T {
    if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
      return c.core_extent() + rounding_radius(c, shape.rounding());
    return c.core_extent();
  });
}

/// The part of the smaller shape by which the deepest contact may be less deep than the distance (see `contacts`).
template <class T>
inline constexpr T shallower = T(1) / T(200);

/// Whether any point of the manifolds from `first` on is as deep as that.
template <class T>
bool any_as_deep(const Manifolds<T>& manifolds, std::size_t first, T distance) {
  const auto as_deep = [&](const ContactPoint<T>& p) { return p.distance <= distance; };
  return std::any_of(manifolds.begin() + static_cast<std::ptrdiff_t>(first), manifolds.end(),
                     [&](const auto& m) { return std::any_of(m.points.begin(), m.points.end(), as_deep); });
}

/// A point for what lies inside a solid mesh. The way from within to the surface is no contact then: it would push
/// inward.
template <class T>
void add_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, std::size_t first,
                  T& least_distance, Manifolds<T>& manifolds, ManifoldGroups<T>& groups) {
  const bool of_one_part = !is_compound(a) && !is_compound(b);
  if (of_one_part && least_distance <= T(0)) return;
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  if (!inside) return;
  if (of_one_part) manifolds.resize(first);
  const Distance<T>& d = inside->distance;
  Manifold<T> manifold;
  manifold.normal = d.normal;
  manifold.piece_a = inside->piece_a;
  manifold.piece_b = inside->piece_b;
  manifold.points.push_back({d.a, d.b, d.distance});
  manifold.status = d.status;
  manifold.error = d.error;
  groups.add(manifold, {});  // one point
  least_distance = least(least_distance, d.distance);
}

/// By themselves, so that two convex shapes do not pay for what only composites need.
template <class T>
[[gnu::noinline]] T composite_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                       const Pose<T>& pose_b, T margin, Manifolds<T>& manifolds,
                                       const Surroundings<T>& beside, bool singly) {
  const std::size_t first = manifolds.size();
  const Part<T> whole_a{a, pose_a}, whole_b{b, pose_b};
  TouchingPieces<T> found{whole_a, whole_b, beside, margin, singly || !(margin >= T(0)), ManifoldGroups<T>(manifolds)};
  visit_convex_pairs<T>(whole_a, whole_b, {margin, nullptr, true}, PairVisitor<T>(found));
  found.add_ways_out();
  const bool solid = has_solid_mesh(a) || has_solid_mesh(b);
  if (solid) add_enclosed(a, pose_a, b, pose_b, first, found.least_distance, manifolds, found.groups);
  const T size = least(size_about_origin(a), size_about_origin(b));
  const bool none = manifolds.size() == first;
  if (found.touching() ? !any_as_deep(manifolds, first, found.least_distance + size * shallower<T>)
                       : none && found.near_alone())
    found.add_last_resort();
  found.groups.finish();
  found.groups.name_spanning(size);
  return found.least_distance;
}

/// Whether two composites are swapped: contacts are settled among the pieces of one first, and then among those of the
/// other. Ground that others continue comes first.
template <class T>
bool composite_stands_second(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             const Surroundings<T>& beside) {
  if (a.convex() || b.convex()) return false;
  if (beside.of_a.empty() != beside.of_b.empty()) return beside.of_a.empty();
  return a.index() == b.index() ? stands_second(a, pose_a, b, pose_b) : against_order(a, b);
}

/// The contacts of composites that are swapped.
template <class T>
[[gnu::noinline]] T mirrored_composite_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                const Pose<T>& pose_b, T margin, Manifolds<T>& manifolds,
                                                const Surroundings<T>& beside, bool singly) {
  const std::size_t first = manifolds.size();
  const Surroundings<T> swapped{beside.of_b, beside.of_a};
  const T distance = composite_contacts(b, pose_b, a, pose_a, margin, manifolds, swapped, singly);
  for (std::size_t i = first; i < manifolds.size(); ++i) {
    mirror(manifolds[i]);
    std::swap(manifolds[i].piece_a, manifolds[i].piece_b);
  }
  return distance;
}

/// A convex pair's where the list is full: nothing is allocated unless the pair touches.
template <class T>
[[gnu::noinline]] T added_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                   T margin, Manifolds<T>& manifolds) {
  Manifold<T> manifold;
  const T distance = convex_contacts(a, pose_a, b, pose_b, margin, manifold);
  if (!manifold.points.empty()) manifolds.push_back(std::move(manifold));
  return distance;
}

}  // namespace

template <class T>
T any_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
               Manifolds<T>& manifolds, const Surroundings<T>& beside, bool singly) {
  if (!a.convex() || !b.convex() || !beside.empty())
    return composite_stands_second(a, pose_a, b, pose_b, beside)
               ? mirrored_composite_contacts(a, pose_a, b, pose_b, margin, manifolds, beside, singly)
               : composite_contacts(a, pose_a, b, pose_b, margin, manifolds, beside, singly);
  if (manifolds.size() == manifolds.capacity()) return added_contacts(a, pose_a, b, pose_b, margin, manifolds);
  Manifold<T>& manifold = manifolds.emplace_back();
  const T distance = convex_contacts(a, pose_a, b, pose_b, margin, manifold);
  if (manifold.points.empty()) manifolds.pop_back();
  return distance;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Distance<T> any_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T);              \
  template bool any_within(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T);                       \
  template void any_near_pieces(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T,                   \
                                std::vector<PieceDistance<T>>&);                                                       \
  template bool any_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);                         \
  template T any_contacts(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T, Manifolds<T>&,          \
                          const Surroundings<T>&, bool);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
