// Sphere against cylinder, cone or truncated cone: the nearest point of the surface to the centre, in double.
#pragma once

#include <optional>

#include "narrow/core/minkowski.hpp"
#include "narrow/core/point_frustum.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

struct SphereCylinder : PairOfKinds<Sphere, Cylinder> {
  static constexpr bool overlaps_by_distance = true, overlaps_by_mpr = true;

  template <class T>
  GRAZE_FLATTEN static std::optional<Distance<T>> distance(const InPlace<Sphere<T>, T>& a,
                                                           const InPlace<Cylinder<T>, T>& b) {
    const Posed pose_a = converted<double>(a.pose), pose_b = converted<double>(b.pose);
    const auto radius_a = static_cast<double>(a.radius()), radius_b = static_cast<double>(b.radius());
    const Vec3d offset = converted<double>(a.shape.center()), between = pose_a.translation - pose_b.translation;
    // Offsets from A's origin along the world's axes: coordinates far from the world's origin cost no digits.
    const Vec3d center = rotation_of(pose_a.rotation) * offset;
    const Mat3d turn = rotation_of(pose_b.rotation);
    const OutwardDistance core = distance_from(FrustumCore{static_cast<double>(b.shape.half_height()),
                                                           static_cast<double>(b.shape.radius_bottom()),
                                                           static_cast<double>(b.shape.radius_top())},
                                               transposed_times(turn, center + between));

    const double radii = radius_a + radius_b, extent = static_cast<double>(b.shape.core_extent());
    const double noise = rounding_error * (greatest(length(offset) + radius_a, extent + radius_b) + max_abs(between));
    // A distance within rounding of zero is zero: the two touch.
    const double apart = std::abs(core.distance - radii) <= noise ? radii : core.distance;
    const Vec3d normal = -(turn * core.normal);
    return rounded<T>(Distance<double>{apart - radii, normal, pose_a.translation + (center + normal * radius_a),
                                       pose_a.translation + (center + normal * (apart - radius_b))});
  }
};

}  // namespace graze
