// The support function of the Minkowski difference of two cores that are sums of a box and an ellipsoid.
//
// Along a unit vector n from A to B the overlap of such cores is
//   h(n) = -c.n + sum of half |e.n| + sum of |R n|,
// with c the offset between their centres, the first sum over the axes e of both boxes, the second over both
// ellipsoids. h is smooth except for a crease along each great circle e.n = 0 and a kink at the normal of a disc's
// face, and its gradient and its curvature are closed forms.
//
// Guarantee: all in double, in the frame of A; a few tens of operations and a root for each ellipsoid.
#pragma once

#include <limits>
#include <utility>

#include "narrow/core/minkowski.hpp"

namespace graze {

/// Least ratio of the smaller eigenvalue to the other; a smaller one counts as that.
inline constexpr double flattest = 1e-6;

/// A symmetric form on a tangent plane, by its values for the two vectors of the basis and for both.
struct TangentForm {
  double uu = 0, uv = 0, vv = 0;

  void add(const TangentForm& other) {
    uu += other.uu;
    uv += other.uv;
    vv += other.vv;
  }
  /// Newton's step for a gradient, with the magnitudes of the eigenvalues in place of these: it leads down even where
  /// the form is not positive (Dauphin et al. 2014, "Identifying and attacking the saddle point problem").
  std::pair<double, double> downhill(double gu, double gv) const {
    double a = uu, b = uv, c = vv, det = a * c - b * b;
    if (!(a + c > 0 && det > flattest * (a + c) * (a + c))) {
      const double mean = (a + c) * 0.5, half = (a - c) * 0.5, r = std::sqrt(half * half + b * b);
      if (!(std::abs(mean) + r > 0)) return {-gu, -gv};
      const double floor = flattest * (std::abs(mean) + r);
      const double high = greatest(std::abs(mean + r), floor), low = greatest(std::abs(mean - r), floor);
      const double whole = (high + low) * 0.5, part = r > 0 ? (high - low) * 0.5 / r : 0;
      a = whole + part * half;
      b = part * b;
      c = whole - part * half;
      det = a * c - b * b;
    }
    return {(b * gv - c * gu) / det, (b * gu - a * gv) / det};
  }
  double least_eigenvalue() const {
    const double mean = (uu + vv) * 0.5, half = (uu - vv) * 0.5;
    return mean - std::sqrt(half * half + uv * uv);
  }
};

/// One of the two cores.
class SumSide {
 public:
  explicit SumSide(const SummedCore& core)
      : center(core.center), half(core.half), radii(core.radii), squared_(scaled(core.radii, core.radii)) {
    round = max_abs(radii) > 0;
    disc = round && radii.y == 0 && radii.x == radii.z;
  }

  Vec3d center, half, radii;
  bool round;  ///< has an ellipsoid
  bool disc;   ///< the ellipsoid is a cylinder's disc, about its Y

  /// The extent of the core along a vector.
  double extent(const Vec3d& n) const {
    if (disc) return half.y * std::abs(n.y) + radii.x * std::sqrt(n.x * n.x + n.z * n.z);
    const double sum = dot(half, abs(n));
    return round ? sum + length(scaled(radii, n)) : sum;
  }
  /// The ellipsoid's support point.
  Vec3d round_point(const Vec3d& n) const {
    if (!round) return {};
    if (disc) {
      const double across = std::sqrt(n.x * n.x + n.z * n.z), scale = across > 0 ? radii.x / across : 0;
      return {n.x * scale, 0, n.z * scale};
    }
    const double extent = length(scaled(radii, n));
    return extent > 0 ? scaled(squared_, n) / extent : Vec3d{};
  }
  /// Adds the second derivatives of the ellipsoid's extent |R n|, given its support point at n.
  void add_curvature(const Vec3d& n, const Vec3d& point, const Vec3d& u, const Vec3d& v, TangentForm& form) const {
    const double extent = dot(point, n);
    if (!(extent > 0)) return;
    const TangentForm beside = across(u, v, dot(point, u), dot(point, v));
    const double inverse = 1 / extent;
    form.add({beside.uu * inverse, beside.uv * inverse, beside.vv * inverse});
  }
  /// The second derivative of the ellipsoid's extent along u alone.
  double curvature(const Vec3d& n, const Vec3d& point, const Vec3d& u) const {
    const double extent = dot(point, n);
    if (!(extent > 0)) return 0;
    const Vec3d ru = scaled(radii, u);
    const double pu = dot(point, u);
    return (dot(ru, ru) - pu * pu) / extent;
  }
  /// |R t|^2 - (p.t)^2 for tangents t, given the products of the support point p with u and v.
  TangentForm across(const Vec3d& u, const Vec3d& v, double pu, double pv) const {
    const Vec3d ru = scaled(radii, u), rv = scaled(radii, v);
    return {dot(ru, ru) - pu * pu, dot(ru, rv) - pu * pv, dot(rv, rv) - pv * pv};
  }
  /// A lower bound of the radius of curvature along the great circle through n and a tangent t: a quadratic form in t.
  /// With m = n x t normal to the circle's plane it is |cof(R) m|^2 / |R n|^3, that of the ellipse that the ellipsoid
  /// projects onto the plane.
  TangentForm least_radius(const Vec3d& u, const Vec3d& v) const {
    const double widest = max_abs(radii), scale = 1 / (widest * widest * widest);
    const Vec3d minors{radii.y * radii.z, radii.x * radii.z, radii.x * radii.y};
    const Vec3d mu = scaled(minors, u), mv = scaled(minors, v);
    // n x u = v and n x v = -u.
    return {dot(mv, mv) * scale, -dot(mu, mv) * scale, dot(mu, mu) * scale};
  }
  /// A lower bound of the depth of a point inside; negative outside.
  double inside(const Vec3d& point) const {
    const Vec3d beside = half - abs(point);
    if (disc) return least(beside.y, radii.x - std::sqrt(point.x * point.x + point.z * point.z));
    if (round) return -std::numeric_limits<double>::infinity();  // not known without iteration
    return least(beside.x, least(beside.y, beside.z));
  }

 private:
  Vec3d squared_;
};

}  // namespace graze
