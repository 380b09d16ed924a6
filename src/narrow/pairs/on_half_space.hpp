// Half-space against any shape, and the contacts of boxes, triangles, balls and untapered capsules on one: the points
// that `rest` finds, as a manifold.
//
// Guarantee: the distance is that of `distance`, bit for bit; the points are those of the general path, up to rounding,
// with the same features.
#pragma once

#include <optional>

#include "narrow/batch/contact_sink.hpp"
#include "narrow/batch/half_space_batch.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/half_space_distance.hpp"
#include "narrow/pairs/pair.hpp"

namespace graze {

/// Fills the manifold of a body on a half-space as `convex_contacts` does, and returns the distance.
template <class C, class T>
T resting_contacts(const C& body, T margin_body, const Pose<T>& pose_body, T margin_plane, const Pose<T>& pose_plane,
                   T margin, Manifold<T>& manifold) {
  const Rest<T> found = rest(rounded_core(body, margin_body), pose_body, margin_plane, pose_plane, margin);
  manifold.normal = -found.up;
  each_half_space_point<T>(
      static_cast<unsigned>(found.filled), merge_distance(body, margin_body),
      [&](std::size_t i) { return found.slots[i]; }, [&](const ContactPoint<T>& p) { manifold.points.push_back(p); });
  return found.distance;
}

/// Whether a shape that has slots meets a half-space in them alone: a tapered capsule does not, nor does a rounded box
/// or triangle, whose corners do not lie straight above its lowest points.
template <class C, class T>
bool rests_on_slots(const C&, T rounding) {
  return rounding == T(0);
}
template <class T>
bool rests_on_slots(const Sphere<T>&, T) {
  return true;
}
template <class T>
bool rests_on_slots(const Capsule<T>& capsule, T) {
  return has_untapered_side(capsule);
}

template <class C, class T>
Distance<T> distance_on_half_space(const InPlace<C, T>& a, const InPlace<HalfSpace<T>, T>& b) {
  return mirrored(finished(half_space_distance(a.shape, relative(b.pose, a.pose)), b.radius(), a.radius(), b.pose));
}
/// Two half-spaces: apart only where they face each other.
template <class T>
Distance<T> distance_on_half_space(const InPlace<HalfSpace<T>, T>& a, const InPlace<HalfSpace<T>, T>& b) {
  const Pose<T> pose = relative(a.pose, b.pose);
  const Vec3<T> up{T(0), T(1), T(0)};
  Distance<T> d =
      finished<T>({pose.translation.y, up, {pose.translation.x, T(0), pose.translation.z}, pose.translation},
                  a.radius(), b.radius(), a.pose);
  if (opposite(rotate(pose.rotation, up))) return d;
  d.distance = -std::numeric_limits<T>::infinity();
  d.status = Status::unbounded;
  return d;
}

/// Any convex shape against a half-space. Spheres, capsules, boxes and triangles have contacts of their own and lanes.
template <template <class> class Kind>
struct OnHalfSpace : PairOfKinds<Kind, HalfSpace> {
  static constexpr bool overlaps_by_distance = true;
  /// Whether a kind's contacts are at its corners, or at the ends of its axis.
  template <class T>
  static constexpr bool has_slots = requires(const Kind<T>& shape) {
    merge_distance(shape, T());
  };
  static constexpr bool closed_form_rows = has_slots<float>, half_space_kernels = has_slots<float>;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Kind<T>, T>& a, const InPlace<HalfSpace<T>, T>& b) {
    return distance_on_half_space(a, b);
  }
  /// The contacts; nothing for shapes that do not rest on their slots.
  template <class T>
  static std::optional<T> contacts(const InPlace<Kind<T>, T>& a, const InPlace<HalfSpace<T>, T>& b, T margin,
                                   Manifold<T>& manifold) requires has_slots<T> {
    if (!rests_on_slots(a.shape, a.rounding())) return std::nullopt;
    return resting_contacts(a.shape, a.rounding(), a.pose, b.rounding(), b.pose, margin, manifold);
  }

  template <class T>
  static auto overlap_rows() requires has_slots<T> {
    return GRAZE_KERNEL(chosen_isa(), row_overlaps<Kind<T>, HalfSpace<T>, T>);
  }
  template <class T>
  static auto distance_rows() requires has_slots<T> {
    return GRAZE_KERNEL(chosen_isa(), row_distances<Kind<T>, HalfSpace<T>, T>);
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned,
                             Sink& sink) requires has_slots<T> {
    visit_half_space_contacts<Kind<T>>(
        pairs, count, turned, [&](std::size_t i) { sink.apart(i); },
        [&](std::size_t i, T distance, const HalfSpacePoints<T>& points) {
          sink.several(i, distance, points.normal(), points, most_contact_slots);
        });
  }
};

}  // namespace graze
