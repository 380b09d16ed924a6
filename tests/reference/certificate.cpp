#include "certificate.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>

namespace graze::reference {

namespace {

// The solids of revolution are measured in their half plane (radius, y).
struct Planar {
  Real r, y;
};

Real segment_distance(const Planar& p, const Planar& a, const Planar& b) {
  const Real ur = b.r - a.r, uy = b.y - a.y, squared = ur * ur + uy * uy;
  const Real t = squared > 0 ? std::clamp(((p.r - a.r) * ur + (p.y - a.y) * uy) / squared, 0.0L, 1.0L) : 0;
  return std::hypot(p.r - a.r - t * ur, p.y - a.y - t * uy);
}

Real cylinder_outside(const Shape& s, const Planar& p) {
  const Real half = s.height / 2;
  if (std::fabs(p.y) <= half) {
    // Radius at this height times the height, which may be zero.
    const Real reach = s.radius_bottom * (half - p.y) + s.radius_top * (half + p.y);
    if (p.r * s.height <= reach && s.height > 0) return 0;
  }
  const Planar bottom{s.radius_bottom, -half}, top{s.radius_top, half};
  return std::min(
      {segment_distance(p, {0, -half}, bottom), segment_distance(p, bottom, top), segment_distance(p, top, {0, half})});
}

// Signed. The side of the hull of two circles is their common tangent; `along`
// tells which of the two arcs or the tangent is nearest.
Real capsule_outside(const Shape& s, const Planar& p) {
  const Real half = s.height / 2, taper = s.radius_bottom - s.radius_top;
  const Real to_bottom = std::hypot(p.r, p.y + half) - s.radius_bottom;
  const Real to_top = std::hypot(p.r, p.y - half) - s.radius_top;
  if (std::fabs(taper) >= s.height) return taper > 0 ? to_bottom : to_top;
  const Real sine = taper / s.height, cosine = std::sqrt((1 - sine) * (1 + sine));
  const Real along = -sine * p.r + cosine * (p.y + half);
  if (along <= 0) return to_bottom;
  if (along >= cosine * s.height) return to_top;
  return cosine * p.r + sine * (p.y + half) - s.radius_bottom;
}

// The nearest point is x = r^2 p / (r^2 + t) for the t >= 0 that puts it on the
// surface (Eberly, Distance from a Point to an Ellipsoid). By bisection, which a
// zero radius does not upset.
Real ellipsoid_outside(const Vector& radii, const Vector& p) {
  const Real r[3] = {radii.x, radii.y, radii.z}, q[3] = {p.x, p.y, p.z};
  const auto excess = [&](Real t) {
    Real sum = -1;
    for (int i = 0; i < 3; ++i)
      if (r[i] > 0) {
        const Real x = r[i] * q[i] / (r[i] * r[i] + t);
        sum += x * x;
      }
    return sum;
  };
  Real lo = 0, hi = std::max({r[0], r[1], r[2]}) * length(p);
  if (excess(0) <= 0) {
    hi = 0;
  } else {
    for (int i = 0; i < 300; ++i) {
      const Real t = lo + (hi - lo) / 2;
      (excess(t) > 0 ? lo : hi) = t;
    }
  }
  const auto gap = [&](int i) { return r[i] > 0 ? hi * q[i] / (r[i] * r[i] + hi) : q[i]; };
  return length({gap(0), gap(1), gap(2)});
}

Real core_outside(const Placed& placed, const Vector& world_point) {
  const Shape& s = placed.shape;
  const Vector p = placed.to_local(world_point);
  const Planar planar{std::hypot(p.x, p.z), p.y};
  switch (s.kind) {
  case Kind::Polytope: {
    Placed core = placed;
    core.shape.margin = 0;
    return signed_distance(core, place(point(), world_point)).distance;
  }
  case Kind::Capsule: return capsule_outside(s, planar);
  case Kind::Cylinder: return cylinder_outside(s, planar);
  case Kind::Ellipsoid: return ellipsoid_outside(s.radii, p);
  case Kind::Halfspace: break;
  }
  return p.y;
}

std::ostream& operator<<(std::ostream& out, const Vector& v) {
  return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream out;
  out.precision(std::numeric_limits<Real>::digits10);
  (out << ... << parts);
  return out.str();
}

bool finite(const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Real outside_distance(const Placed& placed, const Vector& world_point) {
  return std::max<Real>(0, core_outside(placed, world_point) - placed.shape.margin);
}

std::optional<std::string> disprove(const Placed& a, const Placed& b, const Answer& answer, Real tolerance,
                                    bool search) {
  const bool unbounded =
      a.shape.kind == Kind::Halfspace && b.shape.kind == Kind::Halfspace && std::isinf(signed_distance(a, b).distance);
  if (unbounded) {
    if (std::isinf(answer.distance) && answer.distance < 0) return {};
    return sentence("the halfspaces overlap without bound, but the distance claimed is ", answer.distance);
  }
  const Real d = answer.distance;
  const Vector& n = answer.normal;
  if (!std::isfinite(d) || !finite(n) || !finite(answer.a) || !finite(answer.b))
    return sentence("the answer is not finite: distance ", d, ", normal ", n, ", a ", answer.a, ", b ", answer.b);

  if (const Real l = length(n); std::fabs(l - 1) > unit_tolerance)
    return sentence("the normal ", n, " has length ", l, ", off by ", l - 1);
  if (const Real gap = length(answer.b - answer.a - d * n); gap > tolerance)
    return sentence("b - a = ", answer.b - answer.a, " differs from distance * normal = ", d * n, " by ", gap,
                    ", tolerance ", tolerance);

  struct Side {
    const char* name;
    const Placed& placed;
    const Vector& witness;
    Vector outward;
  };
  for (const Side& side : {Side{"a", a, answer.a, n}, Side{"b", b, answer.b, -n}}) {
    if (const Real out = outside_distance(side.placed, side.witness); out > tolerance)
      return sentence("witness ", side.name, " = ", side.witness, " lies outside its shape by ", out, ", tolerance ",
                      tolerance);
    // Relative to the witness, so that a far-off pair loses no digits.
    Placed shifted = side.placed;
    shifted.translation = shifted.translation - side.witness;
    Vector outward = normalized(side.outward);
    if (side.placed.shape.kind == Kind::Halfspace && is_halfspace_normal(side.placed, outward))
      outward = side.placed.axis_y;
    if (const Real beyond = support_value(shifted, outward); beyond > tolerance)
      return sentence("witness ", side.name, " = ", side.witness, " is not a support point along ", outward,
                      ": its shape reaches farther by ", beyond, ", tolerance ", tolerance);
  }

  const Real s = separation(a, b, n);
  if (s < d - tolerance)
    return sentence("the normal ", n, " separates by ", s, " only, less than the distance ", d, " by ", d - s,
                    ", tolerance ", tolerance);
  // The opposite normal is cheap to try, and is the better one exactly when
  // overlap is claimed of a separated pair.
  for (const Vector& m : {n, -n})
    if (const Real other = separation(a, b, m); other > d + tolerance)
      return sentence("the normal ", m, " separates by ", other, ", more than the distance ", d, " by ", other - d,
                      ", tolerance ", tolerance);
  if (search && d < tolerance) {
    const Signed best = signed_distance(a, b);
    if (best.distance > d + tolerance)
      return sentence("the normal ", best.normal, " separates by ", best.distance, ", more than the distance ", d,
                      " by ", best.distance - d, ", tolerance ", tolerance);
  }
  return {};
}

}  // namespace graze::reference
