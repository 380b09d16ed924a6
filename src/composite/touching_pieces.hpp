// The contacts of two shapes as their pieces are visited: settled among their neighbours, laid on flat faces, joined.
//
// Guarantee: what touches has a point, though every contact of its pieces be a ghost; and so has what is near, unless
// the contact is that of a body beside. Runs of triangles give the bits of triangles one by one.
#pragma once

#include <limits>
#include <optional>

#include "composite/composite.hpp"
#include "composite/flat_faces.hpp"
#include "composite/internal_edges/ghost_contacts.hpp"
#include "composite/internal_edges/sphere_capsule_on_surface.hpp"
#include "composite/internal_edges/voronoi_neighbours.hpp"
#include "composite/leaf_pairs.hpp"
#include "composite/merge_manifolds.hpp"
#include "composite/solid.hpp"
#include "composite/triangle_run.hpp"
#include "composite/ways_out.hpp"
#include "narrow/pair_table.hpp"

namespace graze {

/// Whether a shape is a compound.
template <class T>
bool is_compound(const Shape<T>& shape) {
  return shape.template as<Compound<T>>() != nullptr;
}

/// Whether a triangle would push along a direction that leads from its back. A sliver's normal is rounding, and along
/// an edge the direction lies in the triangle's plane but for that: both push.
template <class T>
bool from_behind(const Part<T>& part, const Vec3<T>& outward) {
  const auto* triangle = part.shape.template as<Triangle<T>>();
  if (!triangle) return false;
  const Vec3<T> u = triangle->point(1) - triangle->point(0), v = triangle->point(2) - triangle->point(0);
  const T along = dot(rotate(part.pose.rotation, cross(u, v)), outward);
  return along < -same_normal<T> * max_abs(u) * max_abs(v);
}

/// Whether either of two pieces that pushes from its front alone, for this reason, would push from its back. The normal
/// of their contact leads from A to B.
template <class T>
bool from_behind(const Part<T>& a, const Part<T>& b, Pushes reason, const Vec3<T>& normal) {
  return (a.pushes == reason && from_behind(a, normal)) || (b.pushes == reason && from_behind(b, -normal));
}

/// Whether a normal leads out of the body that a mesh bounds, at a place on the mesh that it may leave there: nothing
/// around rises above the plane through the place, and the mesh does not enclose what lies a little further along. So
/// it is on an edge where the faces bend by more than a right angle: between them are normals that one of the two has
/// behind it.
template <class T>
bool leaves_body(const LeafInContext<T>& self, const Vec3<T>& place, const Vec3<T>& outward) {
  constexpr T further = T(10) * on_piece<T>;  // a part of the piece, far more than what a place may be off by
  const auto* mesh = self.whole.template as<Mesh<T>>();
  if (!mesh || neighbour_outside_region(self, place, outward, Among::all)) return false;
  const Vec3<T> beyond = place + outward * (further * max_abs(bounds(self.piece, self.pose).extent()));
  return !encloses(mesh->data(), converted<double>(inverse_transform(self.whole_pose, beyond)));
}

/// Sets the numbers of the pieces that a manifold is of.
template <class T>
void name_pieces(Manifold<T>& manifold, const Part<T>& a, const Part<T>& b) {
  manifold.piece_a = a.number;
  manifold.piece_b = b.number;
}

/// The worth of a last resort: its normal leads into a body; it is none of the surface's; it is one of the surface's.
enum class Worth : std::uint8_t { inward, ghost, real };

/// The contact of a triangle that was passed over as a ghost while nothing nearer was known.
template <class T>
struct NearGhost {
  std::uint32_t triangle;
  bool surface_is_a;
  Pushes pushes;
  T distance;
  Manifold<T> manifold;
};

/// The contacts of two shapes, found piece by piece.
template <class T>
struct TouchingPieces {
  const Part<T>&a, &b;  ///< the whole shapes
  const Surroundings<T>& beside;
  T margin;
  bool singly;  ///< without kernels
  ManifoldGroups<T> groups;
  FlatFaces<T> faces{a, b, margin, beside.empty()};
  WaysOut<T> ways_out = {};
  T least_distance = std::numeric_limits<T>::infinity();
  Manifold<T> instead = {};  ///< the last resort, where nothing else is left
  Worth instead_worth = Worth::real;
  T instead_distance = std::numeric_limits<T>::infinity();
  std::optional<NearGhost<T>> ghost = {};  ///< the last resort, if it is still to be laid along the surface

  void operator()(const Part<T>& pa, const Part<T>& pb) {
    if (faces.passes_over(pa, pb, touching())) return;
    Manifold<T> manifold;
    take(pa, pb, convex_contacts(pa.shape, pa.pose, pb.shape, pb.pose, margin, manifold), manifold);
  }
  void operator()(const TriangleRun<T>& run) {
    if (!faces.knows_faces()) return ask(run);
    ask(run.without([&](std::size_t i) { return is_on_known_face(run, i); }));
  }

  /// Adds the ways out of solid meshes.
  void add_ways_out() {
    ways_out.for_each([&](const Manifold<T>& manifold, const LeafPair& leaves) { groups.add(manifold, leaves); });
  }

  /// Whether the shapes are within the margin and nothing is beside them whose contact it could be.
  bool near_alone() const { return least_distance <= margin && beside.empty(); }

  /// Adds the point without which what touches or is near alone would have none.
  void add_last_resort() {
    if (ghost) {
      const Part<T>& whole = ghost->surface_is_a ? a : b;
      Corners<T> corners;
      with_surface(whole.shape, [&](const auto& surface) { corners = surface.triangle(ghost->triangle); });
      const Shape<T> shape = triangle_shape(corners);
      Part<T> piece = whole.piece(shape, whole.pose, ghost->triangle);
      piece.pushes = ghost->pushes;
      const Part<T>&pa = ghost->surface_is_a ? piece : a, &pb = ghost->surface_is_a ? b : piece;
      name_pieces(ghost->manifold, pa, pb);
      instead = settled(pa, pb, ghost->distance, ghost->manifold).instead;
    }
    if (!instead.points.empty()) groups.add(instead, {});  // the points of one pair
  }

  /// Whether the shapes are known to touch.
  bool touching() const { return least_distance <= T(0); }

 private:
  static LeafInContext<T> in_context(const Part<T>& whole, const Part<T>& piece, std::span<const PlacedRef<T>> beside) {
    const auto* mesh = piece.pushes != Pushes::either_way ? whole.shape.template as<Mesh<T>>() : nullptr;
    const bool of_body = mesh && mesh->data().outward;
    return {whole.shape, whole.pose, piece.shape, piece.pose, beside, piece.number, piece.patch, of_body};
  }

  static constexpr std::size_t few = 3;  ///< fewer triangles are asked as quickly one by one

  /// Whether the i-th triangle of a run needs no contact of its own, as its body stands on a face that it is inside of.
  bool is_on_known_face(const TriangleRun<T>& run, std::size_t i) const {
    return faces.passes_over(run.number[i], run.corners(i), run.body, touching());
  }

  /// Finds the contacts of a run.
  void ask(const TriangleRun<T>& run) {
    const auto alone = [&](std::size_t i) {
      if (run.question.may_reach(run.corners(i), margin)) run.with_pair(i, *this);
    };
    if (singly || run.count < few) {
      for (std::size_t i = 0; i < run.count; ++i) alone(i);
      return;
    }
    const std::optional<SphereCapsuleOnSurface<T>> sphere_capsule = sphere_capsule_on_surface(run);
    const auto touch = [&](std::size_t i, T distance, Manifold<T>& manifold) {
      if (sphere_capsule && sphere_capsule->is_ghost(run.number[i], manifold, run.surface_is_a))
        return pass_over(run, i, distance, manifold);
      run.with_pair(i, [&](const Part<T>& pa, const Part<T>& pb) { take(pa, pb, distance, manifold); });
    };
    visit_run_contacts(run, margin, touch, alone);
  }

  /// The surface and the round body of a run, if edges tell which of its contacts are ghosts: it is no child, pushes to
  /// both sides, and nothing is beside it.
  std::optional<SphereCapsuleOnSurface<T>> sphere_capsule_on_surface(const TriangleRun<T>& run) const {
    const Part<T>& whole = run.surface_is_a ? a : b;
    const bool alone = (run.surface_is_a ? beside.of_a : beside.of_b).empty();
    if (is_compound(whole.shape) || !alone || run.surface.pushes == Pushes::frontward) return std::nullopt;
    return SphereCapsuleOnSurface<T>::of(whole.shape, whole.pose, run.body.shape, run.body.pose);
  }
  void pass_over(const TriangleRun<T>& run, std::size_t i, T distance, const Manifold<T>& manifold) {
    if (!(distance < least_distance)) return;
    least_distance = distance;
    ghost = NearGhost<T>{run.number[i], run.surface_is_a, run.surface.pushes, distance, manifold};
  }

  /// The contact of two pieces after a look at the pieces around them.
  struct Taken {
    bool behind;  ///< it leads from the back of a surface that pushes outward
    Manifold<T> manifold, instead;
    Worth instead_worth;
  };
  Taken settled(const Part<T>& pa, const Part<T>& pb, T distance, const Manifold<T>& manifold) const {
    const LeafInContext<T> self_a = in_context(a, pa, beside.of_a), self_b = in_context(b, pb, beside.of_b);
    Settled<T> found = settle_normal(self_a, self_b, margin, manifold, distance);
    const bool behind = enters_body(self_a, pa, found.manifold, true) || enters_body(self_b, pb, found.manifold, false);
    if (behind && distance <= T(0)) found.instead = found.manifold;
    const Worth worth = from_behind(pa, pb, Pushes::outward, found.instead.normal) ? Worth::inward
                        : found.instead_is_ghost                                   ? Worth::ghost
                                                                                   : Worth::real;
    return {behind, found.manifold, found.instead, worth};
  }

  /// Whether a contact leads from the back of a piece that pushes outward alone, and into the body.
  static bool enters_body(const LeafInContext<T>& self, const Part<T>& piece, const Manifold<T>& manifold, bool of_a) {
    const Vec3<T> outward = of_a ? manifold.normal : -manifold.normal;
    if (piece.pushes != Pushes::outward || !from_behind(piece, outward)) return false;
    const auto side = of_a ? &ContactPoint<T>::a : &ContactPoint<T>::b;
    return manifold.points.empty() || !leaves_body(self, standing_point<T>(manifold.points, side), outward);
  }

  /// Whether a contact would pull a body further into a solid mesh in which its middle is. Of a body that comes from
  /// outside what is behind counts for nothing anyway.
  bool pulls_in(const Part<T>& pa, const Part<T>& pb, T distance, const Manifold<T>& manifold) {
    if (manifold.points.empty() || distance > T(0)) return false;
    const Vec3<T>& normal = manifold.normal;
    const auto met_from_behind = [](const Part<T>& part, const Vec3<T>& outward) {
      return part.solid && part.pushes != Pushes::outward && from_behind(part, outward);
    };
    return (met_from_behind(pa, normal) && ways_out.leads_out(pb, pa, false, margin)) ||
           (met_from_behind(pb, -normal) && ways_out.leads_out(pa, pb, true, margin));
  }

  /// Keeps a last resort if it is worth more than the one before, or as much and nearer. What is nearest and needs none
  /// leaves none.
  void keep_instead(const Taken& taken, T distance, bool nearest) {
    const bool needed = !taken.instead.points.empty(), first = instead.points.empty();
    const bool better = taken.instead_worth > instead_worth,
               nearer = taken.instead_worth == instead_worth && distance < instead_distance;
    if (needed ? !(better || nearer || (first && nearest)) : !nearest) return;
    instead = taken.instead;
    instead_worth = taken.instead_worth;
    instead_distance = distance;
  }

  /// The manifold of a pair of pieces, and their distance.
  void take(const Part<T>& pa, const Part<T>& pb, T distance, Manifold<T>& manifold) {
    if (pulls_in(pa, pb, distance, manifold)) {
      least_distance = least(least_distance, distance);
      return;
    }
    if (from_behind(pa, pb, Pushes::frontward, manifold.normal)) return;
    const bool nearest = distance < least_distance;
    least_distance = least(least_distance, distance);
    if (manifold.points.empty()) return;
    if (faces.passes_over(pa, pb, true)) return;  // its distance counts already
    name_pieces(manifold, pa, pb);
    Taken taken = settled(pa, pb, distance, manifold);
    if (pulls_in(pa, pb, distance, taken.manifold)) return;
    keep_instead(taken, distance, nearest);
    if (nearest) ghost.reset();
    if (taken.behind || taken.manifold.points.empty()) return;
    const auto standing = faces.stand(pa, pb, taken.manifold);
    if (standing == FlatFaces<T>::Standing::on_known_face) return;
    const bool on_face = standing == FlatFaces<T>::Standing::on_face;
    groups.add(taken.manifold, on_face ? faces.leaves_on_face(pa, pb) : LeafPair{pa.leaf, pb.leaf});
  }
};

}  // namespace graze
