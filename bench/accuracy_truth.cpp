#include "accuracy_truth.hpp"

#include <cmath>
#include <functional>

#include "../tests/reference/certificate.hpp"

namespace graze::bench {

namespace {

reference::Vector wide(const Vec3d& v) { return {v.x, v.y, v.z}; }

reference::Shape reference_shape(const Body& body) {
  const reference::Vector s = wide(body.size);
  switch (body.kind) {
  case Kind::sphere: return reference::sphere(s.x);
  case Kind::capsule: return reference::capsule(s.y, s.x, s.x);
  case Kind::box: return reference::box(s);
  case Kind::cylinder: return reference::cylinder(s.y, s.x, s.x);
  case Kind::cone: return reference::cylinder(s.y, s.x, 0);
  case Kind::ellipsoid: return reference::ellipsoid(s);
  case Kind::half_space: return reference::halfspace();
  case Kind::hull:
  case Kind::triangle:
  case Kind::mesh: break;  // none is asked about
  }
  std::vector<reference::Vector> points;
  for (const Vec3d& p : body.corners->points) points.push_back(wide(p));
  return reference::polytope(points);
}

// Some roundings of extended precision.
constexpr Real met = 1e-17L;

// The first zero in [0, 1] of a gap that is a convex function of time and closes by no more than `speed`. Both the step
// that this speed allows and the chord through the last two places stay before the zero; the chord converges as the
// secant method does. A gap that no longer closes never will.
std::optional<Meeting> first_zero(const std::function<Real(Real)>& gap, Real speed, Real size) {
  Real t = 0, value = gap(0), closing = speed;
  for (int round = 0; round < 1000; ++round) {
    if (value <= met * size) return Meeting{t, closing};
    const Real next = t + value / closing;
    if (!(next <= 1)) return std::nullopt;
    if (next == t) return Meeting{t, closing};
    const Real there = gap(next), chord = (value - there) / (next - t);
    if (there > met * size) {
      if (chord <= 0) return std::nullopt;
      closing = chord < speed ? chord : speed;
    }
    t = next;
    value = there;
  }
  return Meeting{t, closing};
}

}  // namespace

reference::Placed referenced(const Body& body) {
  const Quatd& q = body.pose.rotation;
  return reference::place(reference_shape(body), wide(body.pose.translation), {q.x, q.y, q.z, q.w});
}

std::optional<Meeting> ray_meeting(const reference::Placed& target, const reference::Vector& from,
                                   const reference::Vector& way, Real size) {
  const auto gap = [&](Real t) { return reference::outside_distance(target, from + way * t); };
  return first_zero(gap, reference::length(way), size);
}

std::optional<Meeting> ray_meeting(const Pair& ray) {
  return ray_meeting(referenced(ray.a), wide(ray.b.pose.translation), wide(ray.motion), ray.a.reach());
}

std::optional<Meeting> cast_meeting(const Pair& way) {
  reference::Placed a = referenced(way.a);
  const reference::Placed b = referenced(way.b);
  const reference::Vector from = a.translation, motion = wide(way.motion);
  const auto gap = [&](Real t) {
    a.translation = from + motion * t;
    return reference::signed_distance(a, b).distance;
  };
  return first_zero(gap, reference::length(motion), way.size());
}

}  // namespace graze::bench
