// Explanation of a ray at a convex shape, in the shape's own frame: the spans of the ray that meet each condition of a
// closed form, or the steps of an advancing ray.
//
// Guarantee: made after the answer. Spans are as exact as plain double arithmetic, without the answer's care for far
// origins and grazing rays.
#pragma once

#include <string>

#include "graze/trace.hpp"
#include "rays/convex.hpp"

namespace graze::rays {

/// Combination of the conditions that make up a shape: all, any, or none where the ray advances by steps.
enum class Made { of_all, of_any, by_steps };

/// Fills `trace` with the spans or steps of a ray at one shape.
class RayExplanation {
 public:
  RayExplanation(const LocalRay& ray, Trace& trace) : ray_(ray), trace_(trace) {}

  template <class T>
  Made of(const Sphere<T>& s, T rounding) {
    ball("ball", converted<double>(s.center()), wide(s.radius()) + wide(rounding));
    return Made::of_all;
  }
  template <class T>
  Made of(const Capsule<T>& c, T rounding) {
    const double h = wide(c.half_height()), m = wide(rounding);
    return balls({0, -h, 0}, wide(c.radius_bottom()) + m, {0, h, 0}, wide(c.radius_top()) + m);
  }
  template <class T>
  Made of(const LineSegment<T>& s, T rounding) {
    return balls(converted<double>(s.point(0)), wide(rounding), converted<double>(s.point(1)), wide(rounding));
  }
  template <class T>
  Made of(const Box<T>& box, T rounding) {
    const Vec3d half = converted<double>(box.half_extents());
    if (rounding > T(0)) return steps(box, rounding, DistanceToBox{half});
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3d axis{};
      axis[i] = 1;
      slab(std::string("slab ") + "xyz"[i], axis, half[i]);
    }
    trace_.method = "slabs";
    return Made::of_all;
  }
  template <class T>
  Made of(const Rectangle<T>& rectangle, T rounding) {
    return of(rectangle.as_box(), rounding);
  }
  template <class T>
  Made of(const Cylinder<T>& c, T rounding) {
    const double h = wide(c.half_height()), bottom = wide(c.radius_bottom()), top = wide(c.radius_top());
    if (rounding > T(0)) return steps(c, rounding, DistanceToFrustum{{h, bottom, top}});
    slab("slab of the caps", {0, 1, 0}, h);
    side(h, bottom, top);
    trace_.method = "slab and quadratic of the side";
    return Made::of_all;
  }
  template <class T>
  Made of(const Ellipsoid<T>& e, T rounding) {
    const Vec3d radii = converted<double>(e.radii());
    if (rounding > T(0) || !(radii.x > 0 && radii.y > 0 && radii.z > 0))
      return steps(e, rounding, DistanceBySupport<Ellipsoid<T>>{e});
    const auto scaled = [&](const Vec3d& p) { return Vec3d{p.x / radii.x, p.y / radii.y, p.z / radii.z}; };
    const Vec3d direction = scaled(ray_.direction);
    const double speed = length(direction);
    const Span at = ball_span(LocalRay{scaled(ray_.origin), direction / speed, 0, 0, 0}, {}, 1);
    const Span span{at.enter / speed, at.leave / speed};
    add("quadratic", normalized(scaled(scaled(ray_.at(span.enter))), -ray_.direction), span);
    trace_.method = "quadratic";
    return Made::of_all;
  }
  template <class T>
  Made of(const Triangle<T>& t, T rounding) {
    const Vec3d p[3] = {converted<double>(t.point(0)), converted<double>(t.point(1)), converted<double>(t.point(2))};
    if (rounding > T(0)) return steps(t, rounding, DistanceToTriangle{p[0], p[1], p[2]});
    return polygon(3, [&](std::size_t i) { return p[i]; });
  }
  template <class T>
  Made of(const ConvexHull<T>& hull, T rounding) {
    const HullData<T>& data = hull.data();
    const auto vertex = [&](std::size_t i) { return converted<double>(data.vertices[i]); };
    if (rounding > T(0)) return steps(hull, rounding, DistanceBySupport<ConvexHull<T>>{hull});
    if (data.dimension < 2) return balls(vertex(0), 0, vertex(static_cast<std::size_t>(data.dimension)), 0);
    if (data.dimension == 2) {
      const auto loop = data.loop(0);
      return polygon(loop.size(), [&](std::size_t i) { return vertex(loop[i]); });
    }
    for (std::size_t i = 0; i < data.planes.size(); ++i)
      behind("face " + std::to_string(i), converted<double>(data.planes[i].normal), wide(data.planes[i].offset));
    trace_.method = "planes of the faces";
    return Made::of_all;
  }
  template <class T>
  Made of(const UserConvex<T>& user, T rounding) {
    return steps(user, rounding, DistanceBySupport<UserConvex<T>>{user});
  }
  template <class T>
  Made of(const HalfSpace<T>&, T rounding) {
    behind("plane", {0, 1, 0}, wide(rounding));
    trace_.method = "plane";
    return Made::of_all;
  }

 private:
  void add(std::string name, const Vec3d& normal, const Span& span) {
    const bool met = span.enter <= span.leave;
    trace_.spans.push_back({std::move(name), met ? normal : Vec3d{}, span.enter, span.leave});
  }

  /// The span in which the ray is behind a plane.
  Span behind_span(const Vec3d& normal, double offset) const {
    const double above = dot(normal, ray_.origin) - offset, along = dot(normal, ray_.direction);
    if (along == 0) return above <= 0 ? Span{-infinity, infinity} : Span{};
    const double t = -above / along;
    return along > 0 ? Span{-infinity, t} : Span{t, infinity};
  }
  void behind(std::string name, const Vec3d& normal, double offset) {
    add(std::move(name), normal, behind_span(normal, offset));
  }
  void slab(std::string name, const Vec3d& axis, double half) {
    const Span below = behind_span(axis, half), above = behind_span(-axis, half);
    add(std::move(name), against(ray_, axis), {greatest(below.enter, above.enter), least(below.leave, above.leave)});
  }
  void ball(std::string name, const Vec3d& center, double radius) {
    const Span span = ball_span(ray_, center, radius > 0 ? radius : ray_.blur);
    add(std::move(name), normalized(ray_.at(span.enter) - center, -ray_.direction), span);
    trace_.method = "quadratic";
  }

  /// Two balls and the cone tangent to both; the ray is in their hull from the first of the spans to the last.
  Made balls(const Vec3d& a, double radius_a, const Vec3d& b, double radius_b) {
    const double height = length(b - a);
    if (height <= std::abs(radius_a - radius_b)) {
      ball("ball", radius_a >= radius_b ? a : b, greatest(radius_a, radius_b));
      return Made::of_all;
    }
    ball("ball at the bottom", a, radius_a);
    ball("ball at the top", b, radius_b);
    const auto whole = [&](const LocalRay& ray) { return hit_balls(ray, a, radius_a, b, radius_b); };
    add("balls and side", {}, crossing_span(whole, length(a) + length(b) + radius_a + radius_b));
    trace_.method = "quadratics of two balls and of the side between them";
    return Made::of_any;
  }

  /// The span from the hit of the ray, coming from far away, to that of its reverse.
  template <class Hit>
  Span crossing_span(const Hit& hit, double reach) const {
    const double far = length(ray_.origin) + 4 * reach;
    const LocalRay there{ray_.at(-far), ray_.direction, 0, 4 * far, ray_.blur},
        back{ray_.at(2 * far), -ray_.direction, 0, 4 * far, ray_.blur};
    const MaybeHit first = hit(there), last = hit(back);
    return first && last ? Span{first->t - far, 2 * far - last->t} : Span{};
  }

  /// The infinite cone or cylinder about y: |across|^2 - radius^2 is quadratic in t; of a cone only the nappe of the
  /// frustum counts.
  void side(double half, double bottom, double top) {
    const double slope = half > 0 ? (top - bottom) / (2 * half) : 0, middle = (top + bottom) / 2;
    const Vec3d across{ray_.direction.x, 0, ray_.direction.z}, off{ray_.origin.x, 0, ray_.origin.z};
    const double dy = ray_.direction.y, radius = middle + slope * ray_.origin.y;
    const double a = dot(across, across) - slope * slope * dy * dy;
    const Roots r = roots(a, dot(off, across) - slope * dy * radius, dot(off, off) - radius * radius);
    const auto radius_at = [&](double t) { return radius + slope * dy * t; };
    Span span;
    if (!r.real || a == 0) {
      if (dot(off, off) <= radius * radius) span = {-infinity, infinity};
    } else if (a > 0) {
      if (radius_at((r.first + r.second) / 2) >= 0) span = {r.first, r.second};
    } else {
      span = slope * dy > 0 ? Span{r.second, infinity} : Span{-infinity, r.first};
    }
    const Vec3d p = ray_.at(span.enter);
    const double rho = length(Vec3d{p.x, 0, p.z});
    add("side", rho > 0 && rho < infinity ? normalized(Vec3d{p.x / rho, -slope, p.z / rho}) : Vec3d{}, span);
  }

  /// The slab of the polygon's plane, and the spans inside its edges.
  template <class Vertex>
  Made polygon(std::size_t count, const Vertex& vertex) {
    Vec3d area{};
    for (std::size_t i = 1; i + 1 < count; ++i) area += cross(vertex(i) - vertex(0), vertex(i + 1) - vertex(0));
    const Vec3d normal = normalized(area);
    slab("plane", normal, 0, dot(normal, vertex(0)));
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3d from = vertex(i), along = vertex((i + 1) % count) - from, out = normalized(cross(along, normal));
      behind("edge " + std::to_string(i), out, dot(out, from));
    }
    trace_.method = "plane and edges";
    return Made::of_all;
  }
  /// A slab about a plane that does not go through the origin.
  void slab(std::string name, const Vec3d& axis, double half, double offset) {
    const Span below = behind_span(axis, offset + half), above = behind_span(-axis, half - offset);
    add(std::move(name), against(ray_, axis), {greatest(below.enter, above.enter), least(below.leave, above.leave)});
  }

  /// The steps of the advancement towards a core plus a ball, recorded from its distance queries.
  template <class C, class T, class DistanceAt>
  Made steps(const C& concrete, T rounding, const DistanceAt& distance_at) {
    const double radius = wide(rounding), size = wide(concrete.core_extent()) + radius;
    const auto noted = [&](const Vec3d& p) {
      const PointDistance gap = distance_at(p);
      const double t = dot(p - ray_.origin, ray_.direction);
      // Points beside the ray, or behind the last step, belong to the search for a better normal.
      const bool beside = length(p - ray_.at(t)) > 1e-9 * (size + length(p - ray_.origin));
      if (!beside && (trace_.steps.empty() || t > trace_.steps.back().t))
        trace_.steps.push_back({t, gap.distance - radius, gap.normal});
      return gap;
    };
    hit_rounded(ray_, noted, radius, wide(concrete.core_extent()), slack_of(concrete, rounding));
    trace_.method = "conservative advancement";
    return Made::by_steps;
  }

  const LocalRay& ray_;
  Trace& trace_;
};

}  // namespace graze::rays
