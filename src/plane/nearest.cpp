// The choice of a way to the nearest points by the kinds of a pair; half-planes need only the other core's support
// point, an ellipse and a point one root.
#include "plane/nearest.hpp"

#include <limits>

#include "plane/nearest_ellipse.hpp"

namespace graze::plane {

namespace {

/// A half-plane and a bounded core, seen from the half-plane.
template <class T>
Nearest above_half_plane(const Core<T>& other, const Pose2d& pose) {
  const Vec2d down = inverse_rotate(pose.rotation, Vec2d{0, -1});
  const CorePoint lowest = support(other, down);
  Nearest out;
  out.b = {transform(pose, lowest.point), lowest.feature};
  out.a = {{out.b.point.x, 0}, side_feature(0)};
  out.normal = {0, 1};
  out.distance = out.b.point.y;
  return out;
}

/// Two half-planes: opposite ones have a gap or a depth, of all others the overlap has no end.
inline Nearest two_half_planes(const Pose2d& b_in_a) {
  Nearest out;
  out.a = {{b_in_a.translation.x, 0}, side_feature(0)};
  out.b = {b_in_a.translation, side_feature(0)};
  out.normal = {0, 1};
  // Opposite within the rounding of two rotations in double.
  const bool opposite = b_in_a.rotation.cosine < 0 && std::abs(b_in_a.rotation.sine) <= 1e-15;
  if (opposite) {
    out.distance = b_in_a.translation.y;
  } else {
    out.distance = -std::numeric_limits<double>::infinity();
    out.status = Status::unbounded;
  }
  return out;
}

/// Nearest points with A and B exchanged, brought from B's frame to A's.
Nearest swapped(const Nearest& of_b, const Pose2d& b_in_a) {
  Nearest out = of_b;
  out.normal = -rotate(b_in_a.rotation, of_b.normal);
  out.a = {transform(b_in_a, of_b.b.point), of_b.b.feature};
  out.b = {transform(b_in_a, of_b.a.point), of_b.a.feature};
  return out;
}

/// Whether a core is an ellipse with an area; one without is a segment or a point.
template <class T>
bool is_round(const Core<T>& core) {
  return core.kind == CoreKind::ellipse && core.radii.x > 0 && core.radii.y > 0;
}
template <class T>
bool is_point(const Core<T>& core) {
  return core.kind == CoreKind::polygon && core.count == 1;
}

/// A seen from B.
Pose2d inverse(const Pose2d& b_in_a) { return relative(b_in_a, Pose2d{}); }

}  // namespace

template <class T>
Nearest nearest(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  const bool half_a = a.kind == CoreKind::half_plane, half_b = b.kind == CoreKind::half_plane;
  if (half_a && half_b) return two_half_planes(b_in_a);
  if (half_a) return above_half_plane(b, b_in_a);
  if (half_b) return swapped(above_half_plane(a, inverse(b_in_a)), b_in_a);
  if (a.kind == CoreKind::polygon && b.kind == CoreKind::polygon) {
    const bool inside = a.count > 2 || b.count > 2;
    return inside ? nearest_polygons(a, b, b_in_a, size) : nearest_by_walk(a, b, b_in_a);
  }
  if (is_round(a) && is_point(b)) return nearest_ellipse_point(a, b, b_in_a);
  if (is_round(b) && is_point(a)) return swapped(nearest_ellipse_point(b, a, inverse(b_in_a)), b_in_a);
  return nearest_curved(a, b, b_in_a, size);
}

template Nearest nearest(const Core<float>&, const Core<float>&, const Pose2d&, double);
template Nearest nearest(const Core<double>&, const Core<double>&, const Pose2d&, double);

}  // namespace graze::plane
