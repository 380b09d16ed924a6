// Contacts of a capsule and a box: an end of the capsule, its side across an edge of the box, or its side on a face.
//
// Guarantee: in every lane the bits that the pair gives alone: the distance is that of `distance`, and the points and
// features are those of clipped faces.
#pragma once

#include "narrow/batch/one_contacts.hpp"
#include "narrow/pairs/box_box/box_like_pair.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze {

/// The part of the box that its closest point lies on; `near_other` as for `box_part`.
template <class S>
S box_part_at(const PlacedBox<S>& box, const CoreDistance<S>& at, const S& near_other) {
  const Mat3<S> turn = rotation_of(box.pose.rotation);
  return sphere_capsule::box_part(box.half, transposed_times(turn, -at.normal),
                                  transposed_times(turn, at.b + at.normal * box.radius - box.pose.translation),
                                  near_other);
}

/// The contact at the closest points. Only for capsules with a length, and boxes with one along every side. Pairs up to
/// `limit` apart are classified: whether the capsule's side lies on the box.
template <class S>
OneContact<S> capsule_box_contact(const PlacedBox<S>& capsule, const PlacedBox<S>& box, const BoxDistance<S>& found,
                                  const S& limit) {
  using T = typename LaneOf<S>::type;
  const CoreDistance<S> at{found.at.distance, found.at.normal, found.at.a, found.at.b};
  const S up = dot(rotation_of(capsule.pose.rotation).column(1), at.normal), lean(face_lean<T>);
  const auto lies = (up * up <= lean * lean) & (at.distance <= limit);
  return {at, select(up > S(0), S(1), S(0)), box_part_at(box, at, S(std::numeric_limits<T>::infinity())),
          select(found.proven, select(lies, S(0), S(1)), S(-1))};
}

namespace sphere_capsule {

/// A capsule in front of the face of a box that leans least from the normal, in coordinates of that face: its axis
/// comes last and points out of the box.
template <class S>
struct CapsuleOnFace {
  using Mask = decltype(S() < S());

  Vec3<S> half;          ///< half extents of the box
  Vec3<S> middle, axis;  ///< centre and axis of the capsule
  Vec3<S> toward;        ///< the opposite of the normal
  Vec3<S> outward;       ///< outward normal of the face, in the world
  S part;                ///< part number of the face

  CapsuleOnFace(const PlacedBox<S>& capsule, const Vec3<S>& axis_in_world, const PlacedBox<S>& box,
                const Vec3<S>& normal) {
    const Mat3<S> turn = rotation_of(box.pose.rotation);
    const Vec3<S> against = transposed_times(turn, -normal);
    const auto face = AxisPermutation<S>::longest(against);
    const Mask positive = face.pick(against) >= S(0);
    const S side = select(positive, S(1), S(-1));
    const auto seen = [&](const Vec3<S>& v) {
      const Vec3<S> t = face.turned(v);
      return Vec3<S>{t.x, t.y, t.z * side};
    };
    half = face.turned(box.half);
    middle = seen(transposed_times(turn, capsule.pose.translation - box.pose.translation));
    axis = seen(transposed_times(turn, axis_in_world));
    toward = seen(against);
    outward = face.pick(turn) * side;
    part = face_part(face, positive);
  }
};

}  // namespace sphere_capsule

/// The contacts of a capsule whose side lies on the box: its axis clipped by the face. `at`: the closest points, as
/// rounded to T, the scalar of the shapes. `margin`: largest distance of contacts. Only for pairs within the margin of
/// each other.
template <class T, class S>
SegmentContact<S> side_contact(const PlacedBox<S>& capsule, const PlacedBox<S>& box, const CoreDistance<S>& at,
                               const S& margin) {
  using std::abs, std::sqrt;
  using Lane = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S zero(0), one(1), half = capsule.half.y, radii = capsule.radius + box.radius;
  const Vec3<S> axis = rotation_of(capsule.pose.rotation).column(1);
  const sphere_capsule::CapsuleOnFace<S> on(capsule, axis, box, at.normal);
  const Vec3<S>&h = on.half, &m = on.middle, &c = on.axis;

  // Along the face's normal where that shows about the whole distance, as on the general path.
  const S size_a = half + capsule.radius, size_b = length(box.half) + box.radius, smaller = least(size_a, size_b);
  const S nearest = at.distance - S(Lane(face_preference)) * smaller;
  const Vec3<S> lean = on.toward - Vec3<S>{zero, zero, one};
  const Mask by_face =
      (m.z - abs(c.z) * half - h.z - radii >= nearest) | (max_abs(lean) <= S(Lane(normal_rounding<T>)));
  const Vec3<S> v{select(by_face, zero, on.toward.x), select(by_face, zero, on.toward.y),
                  select(by_face, one, on.toward.z)};
  const S up = dot(c, v), steep = one / v.z;
  const sphere_capsule::Side<S> side{half, capsule.radius, -up, one - up * up};
  const S near = least(side.near_end(), sphere_capsule::near_rim(h, v)),
          slack = S(Lane(along_rim)) * sqrt(near) + S(Lane(normal_rounding<T>)) * (radii + smaller);

  const Vec3<S> down = v * steep;
  const Vec3<S> foot = m - down * (m.z - h.z), pace = c - down * c.z;
  sphere_capsule::Stretch<S> stretch(half);
  stretch.cut(foot.x, pace.x, h.x, slack);
  stretch.cut(foot.y, pace.y, h.y, slack);

  SegmentContact<S> found;
  found.distance = at.distance;
  found.normal = select(by_face, -on.outward, at.normal);
  const auto put = [&](typename SegmentContact<S>::Slot& slot, const S& along) -> Mask {
    const S rise = side.rise(along);
    slot.distance = (m.z + c.z * along - h.z) * steep - (rise + box.radius);
    slot.a = capsule.pose.translation + (axis * along + found.normal * rise);
    slot.b = slot.a + found.normal * slot.distance;
    slot.place = feature_place(sphere_capsule::part_at(along, half, side.seen, near),
                               on.part + sphere_capsule::rims_part(h, v, foot + pace * along, near));
    return rise >= zero;
  };
  const S lean_most(static_cast<Lane>(face_lean<T>));
  const Mask meet = stretch.any & (stretch.low <= stretch.high) & (abs(up) <= lean_most);
  const Mask first = meet & put(found.slots[0], stretch.low), second = meet & put(found.slots[1], stretch.high);
  const S noise = S(box_rounding<Lane>) * (size_a + size_b + abs(at.distance));
  const Mask faces =
      sphere_capsule::keep_points(found, first, second, greatest(margin, at.distance + noise),
                                  S(Lane(tolerance<T>)) * smaller, at.distance + S(Lane(face_preference)) * smaller);
  if (!all(faces)) {
    const S up_there = dot(axis, at.normal);
    const sphere_capsule::Side<S> there{half, capsule.radius, up_there, one - up_there * up_there};
    const Vec3<S> from_middle = at.a - at.normal * capsule.radius - capsule.pose.translation;
    const S part_a = sphere_capsule::part_at(dot(from_middle, axis), half, there.seen,
                                             least(there.near_end(), sphere_capsule::near_rim(h, on.toward)));
    const S part_b = box_part_at(box, at, there.near_end());
    sphere_capsule::put_closest(found, faces, at, feature_place(part_a, part_b));
  }
  // For a rounded box only contacts over its face are known.
  found.filled = select(by_face | (box.radius == zero), found.filled, zero);
  return found;
}

/// The contact, computed in double as the distance is.
template <class T>
OneContact<T> closest_contact(const Rounded<AxisCore<T>, T>& a, const Pose<T>& pose_a, const Rounded<BoxCore<T>, T>& b,
                              const Pose<T>& pose_b, const T& margin) {
  const auto capsule = converted<double>(placed_box(a, pose_a)), box = converted<double>(placed_box(b, pose_b));
  return converted<T>(
      capsule_box_contact(capsule, box, box_distance(capsule, box), before_rounding<T>(static_cast<double>(margin))));
}

struct CapsuleBox : BoxLikePair<Capsule, Box> {
  static constexpr bool overlaps_by_distance = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Capsule<T>, T>& a, const InPlace<Box<T>, T>& b) {
    if (const auto found = BoxLikePair::distance(a, b)) return found;
    return closed_form_distance(a, b);
  }
  template <class T, class M>
  static std::optional<T> contacts(const InPlace<Capsule<T>, T>& a, const InPlace<Box<T>, T>& b, T margin,
                                   M& manifold) {
    return regular_contact(a, b, margin, manifold);
  }
  template <class T, class M>
  static std::optional<T> more_contacts(const InPlace<Capsule<T>, T>& a, const InPlace<Box<T>, T>& b, T margin,
                                        M& manifold) {
    const auto found = side_contact<T>(converted<double>(placed_box(rounded_core(a.shape, a.rounding()), a.pose)),
                                       converted<double>(placed_box(rounded_core(b.shape, b.rounding()), b.pose)),
                                       converted<double>(take_closest(manifold)), static_cast<double>(margin));
    return put_sides(converted<T>(found), ids_with_box, manifold);
  }

  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_like_row_overlaps<Capsule<T>, Box<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_row_distances<Capsule<T>, Box<T>, T>);
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, Sink& sink) {
    visit_one_contacts<T>(GRAZE_KERNEL(chosen_isa(), capsule_box_contacts<T>), ids_with_box.of, pairs, count, turned,
                          sink);
  }
};

}  // namespace graze
