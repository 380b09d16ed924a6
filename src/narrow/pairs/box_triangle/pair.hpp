// Box against triangle.
//
// Guarantee: the answer of the kernels for many pairs, bit for bit.
#pragma once

#include <optional>

#include "narrow/batch/contact_sink.hpp"
#include "narrow/pairs/box_triangle/overlap.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

/// The contacts of the kernel. Nothing for a sliver, for lengths whose products overflow, or where the faces do not
/// determine the points.
template <class T>
std::optional<T> triangle_contacts(const BoxCore<T>& a, const Pose<T>& pose_a, const TriangleCore<T>& b,
                                   const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), triangle_contact<T>);
  ContactSlots<T> found;
  const T distance = kernel({&a, &b, &pose_a, &pose_b, margin}, found);
  if (!(distance > margin)) {
    if (found.known == T(0)) return std::nullopt;
    take_points<T>(
        static_cast<unsigned>(found.filled), [&](std::size_t i) { return found.slot(i); }, box_features.of,
        triangle_features, manifold.points);
  }
  manifold.normal = found.normal;
  return distance;
}

/// The contacts in units in which no product overflows; scaling by a power of two takes no digit from any number.
template <class T>
std::optional<T> large_triangle_contacts(const BoxCore<T>& a, const Pose<T>& pose_a, const TriangleCore<T>& b,
                                         const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  constexpr T u = T(0x1p-40);
  const auto smaller = [&](const Pose<T>& pose) { return Pose<T>{pose.translation * u, pose.rotation}; };
  const auto distance =
      triangle_contacts<T>({a.half * u}, smaller(pose_a), {{b.point[0] * u, b.point[1] * u, b.point[2] * u}},
                           smaller(pose_b), margin * u, manifold);
  if (!distance) return std::nullopt;
  for (ContactPoint<T>& p : manifold.points) p = {p.a / u, p.b / u, p.distance / u, p.feature, p.weight};
  return *distance / u;
}

struct BoxTriangle : PairOfKinds<Box, Triangle> {
  static constexpr bool overlaps_by_mpr = true;

  /// Whether the two touch; nothing where the axes do not decide.
  template <class T>
  GRAZE_FLATTEN static std::optional<bool> overlap(const InPlace<Box<T>, T>& a, const InPlace<Triangle<T>, T>& b) {
    if (a.rounding() != T(0) || b.rounding() != T(0)) return std::nullopt;
    const BoxTouchesTriangle<T> found(core_of(a.shape), a.pose, rounded_core(b.shape, T(0)).core, b.pose);
    if (!found.known) return std::nullopt;
    return found.touch;
  }
  /// The signed distance (where nothing is within the margin, a lower bound that exceeds it) and the points; nothing
  /// for rounded shapes, and where the faces do not determine the points.
  template <class T>
  static std::optional<T> contacts(const InPlace<Box<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                   Manifold<T>& manifold) {
    if (a.rounding() != T(0) || b.rounding() != T(0)) return std::nullopt;
    const BoxCore<T> box = core_of(a.shape);
    const TriangleCore<T> triangle = rounded_core(b.shape, T(0)).core;
    const auto& p = triangle.point;
    constexpr T large = T(0x1p27);
    const T size = greatest(greatest(max_abs(box.half), max_abs(p[0])), greatest(max_abs(p[1]), max_abs(p[2])));
    const bool small = !(size > large);
    if (!regular_box(small ? box.half : box.half * T(0x1p-40))) return std::nullopt;
    return small ? triangle_contacts(box, a.pose, triangle, b.pose, margin, manifold)
                 : large_triangle_contacts(box, a.pose, triangle, b.pose, margin, manifold);
  }

  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), row_overlaps<Box<T>, Triangle<T>, T>);
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, Sink& sink) {
    visit_triangle_contacts(
        pairs, count, [&](std::size_t i) { sink.apart(i); }, [&](const MetPairs<T>& met) { sink.met(met, turned); },
        [&](std::size_t i) { sink.unknown(i); });
  }
};

}  // namespace graze
