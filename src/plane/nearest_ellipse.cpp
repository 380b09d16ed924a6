// The nearest point of an ellipse, by one root (Eberly 2011, "Distance from a point to an ellipse, an ellipsoid, or a
// hyperellipsoid", section 2.9).
//
// With radii a >= b and the point (u, v) in the first quadrant, the nearest point is (a² u / (t + a²), b² v / (t + b²))
// for the largest t with which it lies on the ellipse. In w = (t + b²) / b² the condition's left side falls and is
// convex right of zero, so Newton's method from the left of the root never passes it.
#include "plane/nearest_ellipse.hpp"

#include <utility>

namespace graze::plane {

namespace {

/// A bound on the steps of Newton's method, which ends where rounding stops it: after six in the mean, and after at
/// most 89 of three million random ellipses and points, with coordinates down to 1e-300.
constexpr int most_steps = 1100;

/// The point of the ellipse with radii a >= b that is nearest to (u, v) with u, v >= 0.
Vec2d nearest_in_quadrant(double a, double b, double u, double v) {
  // On the longer axis, and so near to the middle that the shorter one is nearer: there are two, above and below.
  if (!(v > 0)) {
    const double squares = (a - b) * (a + b), x = squares > 0 ? a * (a * u / squares) : a;
    return x < a ? Vec2d{x, b * std::sqrt(1 - x / a * (x / a))} : Vec2d{a, 0};
  }
  if (!(u > 0)) return {0, b};
  // a² / b² - 1, with the digits that it has where the ellipse is nearly a circle.
  const double flatness = (a - b) / b * ((a + b) / b);
  const double along = (1 + flatness) * (u / a), across = v / b;
  double w = across;
  for (int step = 0; step < most_steps; ++step) {
    const double p = along / (w + flatness), q = across / w;
    const double value = p * p + q * q - 1, slope = -2 * (p * p / (w + flatness) + q * q / w);
    const double next = w - value / slope;
    if (!(value > 0) || !(next > w)) break;
    w = next;
  }
  return {a * (along / (w + flatness)), b * (across / w)};
}

}  // namespace

template <class T>
Nearest nearest_ellipse_point(const Core<T>& ellipse, const Core<T>& point, const Pose2d& b_in_a) {
  const Vec2d at = transform(b_in_a, point.vertex(0)), radii = ellipse.radii;
  const Vec2d folded{std::abs(at.x), std::abs(at.y)};
  const bool upright = radii.x < radii.y;
  Vec2d near = upright ? nearest_in_quadrant(radii.y, radii.x, folded.y, folded.x)
                       : nearest_in_quadrant(radii.x, radii.y, folded.x, folded.y);
  if (upright) std::swap(near.x, near.y);
  near = {at.x < 0 ? -near.x : near.x, at.y < 0 ? -near.y : near.y};
  // The gradient of the ellipse's equation, without squares that overflow.
  const Vec2d outward = normalized(Vec2d{near.x / radii.x * (radii.y / radii.x), near.y / radii.y});
  Nearest out;
  out.normal = outward;
  out.a = {near, vertex_feature(0)};
  out.b = {at, vertex_feature(0)};
  out.distance = dot(at - near, outward);
  return out;
}

template Nearest nearest_ellipse_point(const Core<float>&, const Core<float>&, const Pose2d&);
template Nearest nearest_ellipse_point(const Core<double>&, const Core<double>&, const Pose2d&);

}  // namespace graze::plane
