// A lower bound of the depth of two bodies of revolution whose axes are the same, or nearly.
//
// Coincident axes make all directions around them equal, and a polytope that expands towards the depth has to
// approximate a whole circle of these: it ends at its bound of steps with an error bound of 1e-4 for a depth that is
// right. But the Minkowski difference of the two is a body of revolution itself, and its profile the sum of theirs: a
// convex polygon with rounded corners. The depth of the origin in it is the least over its flat sides, which have the
// directions of the axis and of the sides of either (on a rounded corner the depth is least at an end, or along the
// axis).
//
// Guarantee: no more than the true depth but for rounding. A motion of a body by at most `d` changes a depth by at most
// `d`, so that nearly coincident axes have a bound too: that of coincident ones, less the motion.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "graze/pose.hpp"
#include "graze/shape.hpp"

namespace graze {

/// A unit vector of the half-plane of an axis. Both components are kept: one that is computed of the other loses half
/// of its digits on flat cones.
struct ProfileDirection {
  double across, along;
};

/// A core of revolution about Y: the hull of two discs, or of two balls, at -half_height and half_height.
struct RevolvedCore {
  double half_height;
  double disc[2], ball[2];  ///< radii of the lower and of the upper one
  double extent;            ///< radius of a ball about the origin that contains it

  /// The extent along a direction of its half-plane, whose component `across` is not negative.
  double reach(double across, double along) const {
    return greatest(disc[0] * across - half_height * along + ball[0], disc[1] * across + half_height * along + ball[1]);
  }
  /// The normal of the side; nothing where one end holds the other.
  std::optional<ProfileDirection> side() const {
    const double taper = disc[0] - disc[1], taper_of_balls = ball[0] - ball[1], height = 2 * half_height;
    if (taper_of_balls != 0) {
      if (!(std::abs(taper_of_balls) < height)) return std::nullopt;
      const double across = std::sqrt((height - taper_of_balls) * (height + taper_of_balls));
      return ProfileDirection{across / height, taper_of_balls / height};
    }
    const double slant = std::sqrt(height * height + taper * taper);
    if (!(slant > 0)) return std::nullopt;
    return ProfileDirection{height / slant, taper / slant};
  }
};

template <class T>
std::optional<RevolvedCore> revolved_core(const Shape<T>& shape) {
  if (const auto* c = shape.template as<Cylinder<T>>())
    return RevolvedCore{static_cast<double>(c->half_height()),
                        {static_cast<double>(c->radius_bottom()), static_cast<double>(c->radius_top())},
                        {0, 0},
                        static_cast<double>(c->core_extent())};
  if (const auto* c = shape.template as<Capsule<T>>()) {
    const auto core = static_cast<double>(c->core_radius());
    return RevolvedCore{static_cast<double>(c->half_height()),
                        {0, 0},
                        {static_cast<double>(c->radius_bottom()) - core, static_cast<double>(c->radius_top()) - core},
                        static_cast<double>(c->core_extent())};
  }
  return std::nullopt;
}

/// The depth for coincident axes: `rise` is the position of B's origin along A's axis, `toward` 1 where B's axis has
/// the direction of A's and -1 where it has the opposite one.
inline double coaxial_depth(const RevolvedCore& a, const RevolvedCore& b, double rise, double toward) {
  double least_depth = std::numeric_limits<double>::infinity();
  const auto consider = [&](const ProfileDirection& d) {
    const double depth = a.reach(d.across, d.along) + b.reach(d.across, -d.along * toward) - d.along * rise;
    least_depth = least(least_depth, depth);
  };
  consider({0, 1});
  consider({0, -1});
  if (const auto side = a.side()) consider(*side);
  if (const auto side = b.side()) consider({side->across, -side->along * toward});
  return least_depth;
}

/// The bound for any two shapes; minus infinity where one is no body of revolution.
template <class T>
double depth_as_coaxial(const Shape<T>& shape_a, const Shape<T>& shape_b, const Posed& b_in_a) {
  const auto a = revolved_core(shape_a), b = revolved_core(shape_b);
  if (!a || !b) return -std::numeric_limits<double>::infinity();
  const Vec3d up{0, 1, 0}, axis = rotate(b_in_a.rotation, up), &between = b_in_a.translation;
  const double toward = axis.y < 0 ? -1 : 1, tilt = length(axis * toward - up);
  // B is moved onto A's axis or A onto B's, by its offset across the axis and by the rotation of its furthest point.
  const auto beside = [&](const Vec3d& along) { return length(between - along * dot(between, along)); };
  const double of_b = beside(up) + tilt * b->extent, of_a = beside(axis) + tilt * a->extent;
  const double rise = of_b <= of_a ? between.y : dot(between, axis) * toward;
  return coaxial_depth(*a, *b, rise, toward) - least(of_a, of_b);
}

}  // namespace graze
