// Contacts of balls and untapered capsules on a half-space, across lanes: the point below a ball, below the lower end
// of a capsule, or below both ends of a capsule that lies on its side.
//
// Guarantee: in every lane the bits that the pair gives alone. The distance is that of `distance`, bit for bit; the
// points are those of the general path, up to rounding, with the same features. There are points exactly where the
// distance is within the margin.
#pragma once

#include "graze/shape/face.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"
#include "narrow/pairs/half_space_slots.hpp"

namespace graze {

namespace detail {

/// A sphere or capsule on a half-space whose surface has the height `plane` in its own frame.
template <class S>
struct SphereCapsuleRest {
  const Pose<S>& pose;
  Pose<S> seen;  ///< pose in the half-space's frame
  Vec3<S> up;    ///< in the world
  Vec3<S> down;  ///< in the body's frame
  S plane, radius;

  SphereCapsuleRest(const Pose<S>& pose_body, const S& rounding, const S& height, const Pose<S>& plane_pose)
      : pose(pose_body), seen(relative(plane_pose, pose_body)), plane(height), radius(rounding) {
    const Vec3<S> plane_up{S(0), S(1), S(0)};
    up = rotate(plane_pose.rotation, plane_up);
    down = rotate(conjugate(seen.rotation), -plane_up);
  }
  S distance_at(const Vec3<S>& lowest) const { return transform(seen, lowest).y - (plane + radius); }
  /// The contact below a point of the core, where the surface lies `rise` straight below that.
  typename Rest<S>::Slot below(const Vec3<S>& point, const S& number, const S& rise) const {
    const S apart = seen.translation.y - dot(down, point) - (plane + rise);
    const Vec3<S> low = transform(pose, point) - up * rise;
    return {low, low - up * apart, apart, number};
  }
};

}  // namespace detail

template <class S>
Rest<S> rest(const Rounded<PointCore<S>, S>& ball, const Pose<S>& pose, const S& plane, const Pose<S>& plane_pose,
             const S& margin) {
  const detail::SphereCapsuleRest<S> body(pose, ball.radius, plane, plane_pose);
  Rest<S> found;
  found.distance = body.distance_at(ball.core.point);
  found.up = body.up;
  found.slots[0] = body.below(ball.core.point, S(0), ball.radius);
  found.filled = select(found.distance <= margin, S(1), S(0));
  return found;
}

/// The contacts of a capsule with a length.
template <class S>
Rest<S> rest(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose, const S& plane, const Pose<S>& plane_pose,
             const S& margin) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  const detail::SphereCapsuleRest<S> body(pose, capsule.radius, plane, plane_pose);
  const S zero(0), one(1), half = capsule.core.half_height, length = half * S(2), radius = capsule.radius;
  const S along = body.down.y, steep = body.down.x * body.down.x + body.down.z * body.down.z;
  const auto lies = abs(along) <= S(side_lean<T>), top = along > zero;
  // Straight below an end of a leaning side, the side or the other end's ball may be lowest.
  const auto rise = [&](const S& toward_other) {
    const S side = radius / sqrt(select(lies, steep, one)), place = side * toward_other;
    const S by_side = select((place >= zero) & (place <= length), greatest(radius, side), radius);
    const S beside = radius * radius - length * length * steep;
    const S by_ball = sqrt(greatest(beside, zero)) + length * toward_other;
    return select(lies, select(beside >= zero, greatest(by_side, by_ball), by_side), radius);
  };
  const auto end = [&](const S& at) { return Vec3<S>{zero, at, zero}; };

  Rest<S> found;
  found.distance = body.distance_at(end(select(along < zero, -half, half)));
  found.up = body.up;
  const auto first_top = top & (!lies);
  found.slots[0] = body.below(end(select(first_top, half, -half)), select(first_top, one, zero), rise(along));
  found.slots[1] = body.below(end(half), one, rise(-along));
  // Points level with the lowest up to rounding are kept with it, so that a side that touches touches whole.
  const S noise = S(box_rounding<T>) * (half + radius + max_abs(body.seen.translation)),
          limit = greatest(margin, found.distance + noise);
  const auto near = found.distance <= margin;
  found.filled = select(near & (found.slots[0].distance <= limit), one, zero) +
                 select(near & lies & (found.slots[1].distance <= limit), S(2), zero);
  return found;
}

}  // namespace graze
