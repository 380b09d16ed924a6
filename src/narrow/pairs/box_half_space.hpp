// A box on a half-space: the corners of its lowest face, each with its own height, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The distance is that of `distance`, bit for bit, and the
// lowest point's; the face is the one that `Box::core_face` gives up to `side_lean`, with its vertices in that order.
// There are points exactly where the distance is within the margin.
#pragma once

#include "narrow/pairs/box_box/clip_box_faces.hpp"
#include "narrow/pairs/half_space_slots.hpp"

namespace graze {

/// The contacts of a box without rounding. `plane` is the height of the half-space's surface in its own frame; points
/// are found up to `margin` above it.
template <class S>
Rest<S> rest(const Rounded<BoxCore<S>, S>& box, const Pose<S>& pose, const S& plane, const Pose<S>& plane_pose,
             const S& margin) {
  const Vec3<S>& half_extents = box.core.half;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S zero(0), one(1);
  const Vec3<S> plane_up{zero, one, zero};
  const Pose<S> seen = relative(plane_pose, pose);
  const Vec3<S> down = rotate(conjugate(seen.rotation), -plane_up);
  const auto lower = [&](const S& along, const S& half) { return select(along < zero, -half, half); };
  const Vec3<S> lowest{lower(down.x, half_extents.x), lower(down.y, half_extents.y), lower(down.z, half_extents.z)};

  Rest<S> found;
  found.distance = transform(seen, lowest).y - plane;
  found.up = rotate(plane_pose.rotation, plane_up);

  // The axes of the box permuted until the one normal to its lowest face comes last.
  const auto face = AxisPermutation<S>::longest(down);
  const Vec3<S> d = face.turned(down), half = face.turned(half_extents), bits = face.turned(Vec3<S>{one, S(2), S(4)});
  const Mat3<S> turn = rotation_of(pose.rotation);
  const Vec3<S> wx = face.turned(turn.row[0]), wy = face.turned(turn.row[1]), wz = face.turned(turn.row[2]);
  // The lowest face leans by less than 55 degrees: it is the whole one that has points, but for sides of no length.
  const Mask flat_u = half.x > zero, flat_v = half.y > zero, both = flat_u & flat_v;
  const Mask at_u = d.x >= zero, at_v = d.y >= zero, forward = d.z >= zero;
  // Order of the vertices: around the face as its axes are right-handed; along an edge as it points.
  const Mask all = zero == zero,  // NOLINT(misc-redundant-expression): true in every lane
      any_flat = flat_u | flat_v, behind = !forward;
  const Mask first_u = at_u & (!flat_u), first_v = at_v & (!flat_v);
  const Mask second_u = (both & forward) | ((!both) & (flat_u | at_u)),
             second_v = (both & behind) | ((!both) & (flat_v | at_v));
  const Mask is[] = {all, any_flat, both, both}, upper_u[] = {first_u, second_u, all, behind},
             upper_v[] = {first_v, second_v, all, forward};
  const S front = select(forward, half.z, -half.z);
  // Corners level with the lowest up to rounding are kept with it, so that a face that touches touches whole.
  const S noise = S(box_rounding<T>) * (length(half_extents) + max_abs(seen.translation)),
          limit = greatest(margin, found.distance + noise), lowest_along = dot(d, face.turned(lowest));
  const Mask near = found.distance <= margin;
  found.filled = zero;
  for (std::size_t i = 0; i < most_half_space_points; ++i) {
    const Vec3<S> corner{select(upper_u[i], half.x, -half.x), select(upper_v[i], half.y, -half.y), front};
    auto& slot = found.slots[i];
    slot.distance = found.distance + (lowest_along - dot(d, corner));
    slot.of_body = pose.translation + Vec3<S>{dot(wx, corner), dot(wy, corner), dot(wz, corner)};
    slot.of_plane = slot.of_body - found.up * slot.distance;
    // A side of zero length has one corner for its two ends, with one number.
    slot.corner = select(upper_u[i] & (half.x > zero), bits.x, zero) +
                  select(upper_v[i] & (half.y > zero), bits.y, zero) + select(forward, bits.z, zero);
    found.filled = found.filled + select(near & is[i] & (slot.distance <= limit), S(T(1 << i)), zero);
  }
  return found;
}

}  // namespace graze
