// The contacts of a pair in a world: the part of finding manifolds in which the spaces differ.
//
// Guarantee: each pair has the answer of `contacts` of its space, bit for bit, but for fixed bodies beside it.
#pragma once

#include "composite/composite.hpp"
#include "composite/internal_edges/face_contact.hpp"
#include "graze/plane/space.hpp"
#include "narrow/batch/lane_pairs.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/sat/cached_axis.hpp"
#include "plane/beside.hpp"
#include "plane/pairs/placed_pairs.hpp"

namespace graze {

template <class T, class Space>
struct PairContacts;

/// Pairs in three dimensions: kinds with a kernel across lanes, other convex pairs one by one with the direction in
/// which they were apart, and composites.
template <class T>
struct PairContacts<T, Space<T>> {
  using Lanes = LanesFor;
  using Pair = PairRef<T>;

  static Lanes lanes(std::uint8_t type_a, std::uint8_t type_b) { return lane_table<T>(type_a, type_b); }
  static bool has_kernel(const Lanes& lanes) { return with_contact_lanes(lanes.pair); }
  static bool is_turned(const Lanes& lanes) { return lanes.turned; }
  /// The concrete shape as kernels take it, or null.
  static const void* concrete(const Shape<T>& shape) { return concrete_for_lanes(shape); }
  template <class Sink>
  static void visit(const Lanes& lanes, const Pair* pairs, std::size_t count, Sink& sink) {
    visit_lane_contacts(lanes, pairs, count, sink);
  }

  static bool overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
    return any_overlap<T>(a, pose_a, b, pose_b);
  }
  /// Whether convex pairs are computed as a single manifold, with an axis.
  static constexpr bool has_axes = true;
  static bool is_single(const Shape<T>& a, const Shape<T>& b) { return a.convex() && b.convex(); }
  static bool still_apart(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                          const Vec3<T>& axis, T margin) {
    return graze::still_apart(a, pose_a, b, pose_b, axis, margin);
  }
  /// The manifold of two convex shapes; returns whether they overlap.
  static bool single(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                     Manifold<T>& manifold) {
    return convex_contacts<T>(a, pose_a, b, pose_b, margin, manifold) <= T(0);
  }
  /// An axis of the world in the frame of a body.
  static Vec3<T> in_frame(const Pose<T>& pose, const Vec3<T>& axis) { return rotate(conjugate(pose.rotation), axis); }
  /// Appends all manifolds of a pair; returns whether it overlaps.
  static bool all(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                  Manifolds<T>& manifolds, const Surroundings<T>& beside) {
    return any_contacts<T>(a, pose_a, b, pose_b, margin, manifolds, beside) <= T(0);
  }

  /// Whether the contacts of two convex shapes stay the same when all fixed bodies beside either count.
  static bool stays(const PlacedRef<T>& first, const PlacedRef<T>& second, const Surroundings<T>& beside,
                    const Vec3<T>& normal, std::span<const SolverPoint<T>> points) {
    const auto piece = [](const PlacedRef<T>& of, std::span<const PlacedRef<T>> around) {
      return LeafInContext<T>{*of.shape, *of.pose, *of.shape, *of.pose, around};
    };
    const LeafInContext<T> a = piece(first, beside.of_a), b = piece(second, beside.of_b);
    return (a.beside.empty() || stands_clear(a, b, normal, standing_point(points, &ContactPoint<T>::a))) &&
           (b.beside.empty() || stands_clear(b, a, -normal, standing_point(points, &ContactPoint<T>::b)));
  }
};

/// Pairs in the plane: kinds with a kernel, of shapes without a rounding, across lanes, all others one by one.
template <class T>
struct PairContacts<T, plane::Space<T>> {
  using Shape = plane::Shape<T>;
  using Pose = plane::Pose2<T>;
  using Around = Surroundings<T, plane::PlacedRef<T>>;
  static T extent_of(const Shape& shape) {
    return plane::is_bounded(shape) ? plane::extent(shape) : std::numeric_limits<T>::infinity();
  }
  using Lanes = plane::PairKinds;
  using Pair = plane::PlacedPair<T>;

  static Lanes lanes(std::uint8_t type_a, std::uint8_t type_b) { return plane::pair_kinds<T>(type_a, type_b); }
  static bool has_kernel(const Lanes& lanes) { return lanes.entry.has_value(); }
  static bool is_turned(const Lanes& lanes) { return lanes.entry->turned; }
  static const void* concrete(const Shape& shape) { return plane::concrete_for_lanes(shape); }
  template <class Sink>
  static void visit(const Lanes& lanes, const Pair* pairs, std::size_t count, Sink& sink) {
    plane::visit_contacts(lanes, pairs, count, sink);
  }

  static bool overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
    return plane::overlap(a, pose_a, b, pose_b);
  }
  static constexpr bool has_axes = false;
  static bool all(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, T margin,
                  plane::Manifolds<T>& manifolds, const Around& beside) {
    return beside.empty() ? plane::contacts(a, pose_a, b, pose_b, margin, manifolds)
                          : plane::contacts_beside(a, pose_a, b, pose_b, margin, manifolds, beside.of_a, beside.of_b);
  }

  /// Whether the contacts of two convex shapes surely stay the same when all fixed bodies beside either count: none of
  /// these is near the points.
  static bool stays(const plane::PlacedRef<T>& a, const plane::PlacedRef<T>& b, const Around& beside,
                    const plane::Vec2<T>&, std::span<const SolverPoint<T, plane::Space<T>>> points) {
    const T step = T(plane::seam_step) * least(extent_of(*a.shape), extent_of(*b.shape));
    const auto clear = [&](std::span<const plane::PlacedRef<T>> around, const plane::Shape<T>* own, auto point) {
      return std::all_of(around.begin(), around.end(), [&](const plane::PlacedRef<T>& body) {
        if (body.shape == own) return true;
        const plane::Aabb2<T> box = plane::bounds(*body.shape, *body.pose);
        return std::none_of(points.begin(), points.end(), [&](const auto& p) {
          const plane::Vec2<T> off = p.*point - least(greatest(p.*point, box.lower), box.upper);
          return length(off) <= step + std::abs(p.distance);
        });
      });
    };
    return clear(beside.of_a, a.shape, &plane::ContactPoint<T>::a) &&
           clear(beside.of_b, b.shape, &plane::ContactPoint<T>::b);
  }
};

}  // namespace graze
