// A capsule and a box that touch in one point: an end of the capsule, or its side across an edge of the box.
//
// Guarantee: in every lane the bits that the pair gives alone: those of `distance`, and the names that the faces give.
// Where the capsule's side lies on the box, which may give two points, `known` says so: the faces answer then.
#pragma once

#include "narrow/pairs/box_distance.hpp"
#include "narrow/pairs/round_contacts.hpp"

namespace graze {

/// What `at` is where: only for capsules with a length, and boxes with one along every side. Up to `limit` apart it is
/// asked whether the side lies on the box.
template <class S>
RoundContact<S> capsule_box_contact(const PlacedBox<S>& capsule, const PlacedBox<S>& box, const BoxDistance<S>& found,
                                    const S& limit) {
  const Vec3<S>& n = found.at.normal;
  const Mat3<S> turn = rotation_of(box.pose.rotation);
  const Vec3<S> core = found.at.b + n * box.radius - box.pose.translation;
  const S up = dot(rotation_of(capsule.pose.rotation).column(1), n), lean(face_lean<typename LaneOf<S>::type>);
  const auto lies = (up * up <= lean * lean) & (found.at.distance <= limit);
  return {{found.at.distance, n, found.at.a, found.at.b},
          select(up > S(0), S(1), S(0)),
          round::box_part(box.half, transposed_times(turn, -n), transposed_times(turn, core)),
          select(found.proven & (!lies), S(1), S(0))};
}

/// In double, as the distance.
template <class T>
RoundContact<T> round_contact(const Rounded<AxisCore<T>, T>& a, const Pose<T>& pose_a, const Rounded<BoxCore<T>, T>& b,
                              const Pose<T>& pose_b, const T& margin) {
  const auto capsule = cast<double>(placed_box(a, pose_a)), box = cast<double>(placed_box(b, pose_b));
  const RoundContact<double> found =
      capsule_box_contact(capsule, box, box_distance(capsule, box), before_rounding<T>(static_cast<double>(margin)));
  const CoreDistance<double>& at = found.at;
  return {{static_cast<T>(at.distance), cast<T>(at.normal), cast<T>(at.a), cast<T>(at.b)},
          static_cast<T>(found.part_a),
          static_cast<T>(found.part_b),
          static_cast<T>(found.known)};
}

template <class T>
std::optional<T> own_contacts(const Capsule<T>& a, T margin_a, const Pose<T>& pose_a, const Box<T>& b, T margin_b,
                              const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  if (!round::regular(a) || !round::regular(b)) return std::nullopt;
  return round_contacts(a, margin_a, pose_a, b, margin_b, pose_b, margin, manifold);
}

}  // namespace graze
