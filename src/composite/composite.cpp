#include "composite/composite.hpp"

#include "composite/flat_faces.hpp"
#include "composite/internal_edges/ghost_contacts.hpp"
#include "composite/leaf_pairs.hpp"
#include "composite/merge_manifolds.hpp"
#include "composite/solid.hpp"
#include "composite/spanning_points.hpp"
#include "composite/triangle_run.hpp"
#include "narrow/pair_table.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

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

/// Whether a triangle that pushes from its front alone, for this reason, would push along a direction that leads from
/// its back. A sliver's normal is rounding, and along an edge the direction lies in the triangle's plane but for that:
/// both push.
template <class T>
bool from_behind(const Part<T>& part, Pushes reason, const Vec3<T>& outward) {
  const auto* triangle = part.pushes == reason ? part.shape.template as<Triangle<T>>() : nullptr;
  if (!triangle) return false;
  const Vec3<T> u = triangle->point(1) - triangle->point(0), v = triangle->point(2) - triangle->point(0);
  const T along = dot(rotate(part.pose.rotation, cross(u, v)), outward);
  return along < -same_normal<T> * max_abs(u) * max_abs(v);
}

/// The same of either of two pieces, the normal of whose contact leads from A to B.
template <class T>
bool from_behind(const Part<T>& a, const Part<T>& b, Pushes reason, const Vec3<T>& normal) {
  return from_behind(a, reason, normal) || from_behind(b, reason, -normal);
}

template <class T>
bool is_compound(const Shape<T>& shape) {
  return shape.template as<Compound<T>>() != nullptr;
}

/// What lies inside a solid mesh is deeper than its surface is far.
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
  if (!found) best.distance = infinity<T>;
  return has_solid_mesh(a) || has_solid_mesh(b) ? or_enclosed(best, a, pose_a, b, pose_b) : best;
}

template <class T>
bool any_within(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit) {
  if (!(limit > T(0))) return any_overlap(a, pose_a, b, pose_b);
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b).distance <= limit;
  auto beyond = [&](const Part<T>& pa, const Part<T>& pb) {
    return !(convex_distance(pa.shape, pa.pose, pb.shape, pb.pose).distance <= limit);
  };
  return !visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {limit}, PairVisitor<T>(beyond)) ||
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

template <class T>
void name_pieces(Manifold<T>& manifold, const Part<T>& a, const Part<T>& b) {
  manifold.piece_a = a.number;
  manifold.piece_b = b.number;
}

/// What is found of the contacts of two shapes, piece by piece.
template <class T>
struct TouchingPieces {
  const Part<T>&a, &b;  ///< the whole shapes
  const Surroundings<T>& beside;
  T margin;
  bool singly;  ///< without kernels
  ManifoldGroups<T> groups;
  FlatFaces<T> faces{a, b, margin};
  T least_distance = infinity<T>;
  Manifold<T> instead = {};  ///< what is left where nothing else is

  void operator()(const Part<T>& pa, const Part<T>& pb) {
    Manifold<T> manifold;
    take(pa, pb, convex_contacts(pa.shape, pa.pose, pb.shape, pb.pose, margin, manifold), manifold);
  }
  void operator()(const TriangleRun<T>& run) {
    const auto alone = [&](std::size_t i) {
      if (run.question.may_reach(run.corners(i), margin)) run.with_pair(i, *this);
    };
    if (singly || run.count < few)
      for (std::size_t i = 0; i < run.count; ++i) alone(i);
    else
      visit_run_contacts(
          run, margin,
          [&](std::size_t i, T distance, Manifold<T>& manifold) {
            run.with_pair(i, [&](const Part<T>& pa, const Part<T>& pb) { take(pa, pb, distance, manifold); });
          },
          alone);
  }

 private:
  static LeafInContext<T> in_context(const Part<T>& whole, const Part<T>& piece,
                                     std::span<const PlacedRef<T>> beside) {
    const auto* mesh = piece.pushes != Pushes::either_way ? whole.shape.template as<Mesh<T>>() : nullptr;
    const bool of_body = mesh && mesh->data().outward;
    return {whole.shape, whole.pose, piece.shape, piece.pose, beside, piece.number, piece.patch, of_body};
  }

  static constexpr std::size_t few = 3;  ///< fewer triangles are asked as quickly one by one

  /// The manifold of a pair of pieces, and their distance.
  void take(const Part<T>& pa, const Part<T>& pb, T distance, Manifold<T>& manifold) {
    if (from_behind(pa, pb, Pushes::frontward, manifold.normal)) return;
    const bool nearest = distance < least_distance;
    least_distance = least(least_distance, distance);
    if (manifold.points.empty()) return;
    if (faces.passes_over(pa, pb, beside.empty())) return;
    name_pieces(manifold, pa, pb);
    Settled<T> settled = settle_normal(in_context(a, pa, beside.of_a), in_context(b, pb, beside.of_b), margin,
                                       manifold, distance);
    const bool behind = from_behind(pa, pb, Pushes::outward, settled.manifold.normal);
    if (nearest) instead = behind && distance <= T(0) ? settled.manifold : settled.instead;
    if (behind || settled.manifold.points.empty()) return;
    if (faces.stand(pa, pb, settled.manifold) == FlatFaces<T>::Standing::on_known_face) return;
    groups.add(settled.manifold);
  }
};

/// A point for what lies inside a solid mesh. The way from within to the surface is no contact then: it would push
/// inward.
template <class T>
void add_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, std::size_t first,
                  T& least_distance, Manifolds<T>& manifolds) {
  const bool of_one_part = !is_compound(a) && !is_compound(b);
  if (of_one_part && least_distance <= T(0)) return;
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  if (!inside) return;
  if (of_one_part) manifolds.resize(first);
  const Distance<T>& d = inside->distance;
  Manifold<T>& manifold = manifolds.emplace_back();
  manifold.normal = d.normal;
  manifold.piece_a = inside->piece_a;
  manifold.piece_b = inside->piece_b;
  manifold.points.push_back({d.a, d.b, d.distance});
  manifold.status = d.status;
  manifold.error = d.error;
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
  found.groups.finish();
  const bool solid = has_solid_mesh(a) || has_solid_mesh(b);
  if (solid) add_enclosed(a, pose_a, b, pose_b, first, found.least_distance, manifolds);
  // What touches is not left without a point.
  if (manifolds.size() == first && !found.instead.points.empty()) manifolds.push_back(found.instead);
  const T size = least(size_about_origin(a), size_about_origin(b));
  for (std::size_t i = first; i < manifolds.size(); ++i) keep_spanning(manifolds[i], size);
  return found.least_distance;
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
    return composite_contacts(a, pose_a, b, pose_b, margin, manifolds, beside, singly);
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
