// Cores with curved sides: a polygon inside the Minkowski difference A - B grows where the origin is nearest.
//
// Guarantee: with every step there is a proven lower and upper bound of the distance or the depth, and it ends when
// they meet. No step of GJK's that drops a vertex can go round in circles, since none is dropped: outside, the steps
// are those of GJK (Gilbert, Johnson, Keerthi 1988), inside those of the expanding polytope (van den Bergen 2001), on
// one polygon.
#pragma once

#include <limits>

#include "graze/small_vector.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

/// A vertex of the growing polygon: the point of the difference furthest along `direction`.
struct GrownVertex {
  Vec2d direction;
  CorePoint a, b;
  Vec2d point;
};

/// The point of the polygon's outline nearest to the origin.
struct GrownFoot {
  std::size_t edge = 0;  ///< from vertex `edge` to the next
  double parameter = 0;
  Vec2d point{};
  bool inside = false;  ///< the origin is inside
  Vec2d normal{};       ///< outward, towards the origin where that is outside
  double reach = 0;     ///< of the polygon along the normal
};

inline constexpr std::size_t most_grown_vertices = 256;

/// The difference as a support function, in A's frame.
template <class T>
struct CurvedDifference {
  const Core<T>&a, &b;
  const Pose2d& b_in_a;

  GrownVertex operator()(const Vec2d& direction) const {
    CorePoint on_b = support(b, -inverse_rotate(b_in_a.rotation, direction));
    on_b.point = transform(b_in_a, on_b.point);
    const CorePoint on_a = support(a, direction);
    return {direction, on_a, on_b, on_a.point - on_b.point};
  }
};

class GrowingPolygon {
 public:
  std::size_t size() const { return vertices_.size(); }
  const GrownVertex& operator[](std::size_t i) const { return vertices_[i]; }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  void push(const GrownVertex& v) { vertices_.push_back(v); }

  /// Puts `v` where its direction belongs, which is near vertex `i`: the foot may be an end of an edge, and the
  /// direction beyond that end's. Directions of neighbours are less than half a turn apart.
  void insert(std::size_t i, const GrownVertex& v) {
    const auto behind = [&](std::size_t k) { return cross(vertices_[k].direction, v.direction) >= 0; };
    for (std::size_t k = 0; k < size() && !behind(i); ++k) i = i == 0 ? size() - 1 : i - 1;
    for (std::size_t k = 0; k < size() && behind(next(i)); ++k) i = next(i);
    vertices_.push_back(v);
    for (std::size_t k = size() - 1; k > i + 1; --k) vertices_[k] = vertices_[k - 1];
    vertices_[i + 1] = v;
  }

  /// The foot of a difference that is known up to `near`.
  GrownFoot foot(double near) const {
    for (std::size_t i = 0; i < size(); ++i)
      if (length_squared(vertices_[i].point) <= near * near) return at_vertex(i);
    GrownFoot inner;
    double least_reach = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i) {
      const Vec2d p = vertices_[i].point, e = vertices_[next(i)].point - p;
      const double l = length(e);
      if (!(l > 0)) continue;
      const double reach = cross(p, e) / l;
      if (reach < least_reach) {
        least_reach = reach;
        inner = foot_on(i);
        inner.normal = right(e) / l;
        inner.reach = reach;
        inner.inside = true;
      }
    }
    const double allowed = 4 * least_reach * least_reach;
    if (least_reach >= 0 && inner.inside && length_squared(inner.point) <= allowed) return inner;
    // The foot lies on an edge in line with the nearest one, as with polygons, or there is no inside.
    GrownFoot outside = nearest_outside(inner, near);
    if (!(least_reach >= 0 && inner.inside && length_squared(outside.point) <= allowed)) return outside;
    outside.inside = true;
    outside.normal = inner.normal;
    outside.reach = inner.reach;
    return outside;
  }

 private:
  GrownFoot foot_on(std::size_t i) const {
    const Vec2d p = vertices_[i].point, q = vertices_[next(i)].point, e = q - p;
    const double l2 = length_squared(e);
    GrownFoot f;
    f.edge = i;
    f.parameter = l2 > 0 ? clamp(-dot(p, e) / l2, 0.0, 1.0) : 0.0;
    f.point = f.parameter <= 0.5 ? p + e * f.parameter : q - e * (1 - f.parameter);
    return f;
  }
  /// A vertex at the origin, up to what the difference is known to. The way to the origin is rounding there and has no
  /// direction; the one along which the vertex is furthest is a normal, since the difference ends at the origin there.
  GrownFoot at_vertex(std::size_t i) const {
    GrownFoot f;
    f.edge = i;
    f.point = vertices_[i].point;
    f.normal = normalized(vertices_[i].direction);
    f.reach = dot(f.point, f.normal);
    f.inside = f.reach >= 0;
    return f;
  }
  GrownFoot nearest_outside(const GrownFoot& otherwise, double near) const {
    GrownFoot best = otherwise;
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i)
      if (const GrownFoot f = foot_on(i); length_squared(f.point) < squared)
        squared = length_squared(f.point), best = f;
    best.inside = false;
    // Within an edge the normal is both the edge's and the way's to the origin: rounding of the vertices turns the
    // longer of the two least, and the way is all rounding where the edge runs through the origin. The edge faces the
    // origin, unless the difference is thinner than it is known and this is its other side.
    const Vec2d across = right(vertices_[next(best.edge)].point - vertices_[best.edge].point);
    const double squared_across = length_squared(across), beyond = dot(best.point, across);
    const bool within = 0 < best.parameter && best.parameter < 1;
    const bool longer = squared_across > squared;
    const bool faces = beyond <= 0 || beyond * beyond <= near * near * squared_across;
    best.normal = normalized(within && longer && faces ? across : -best.point);
    best.reach = dot(best.point, best.normal);
    return best;
  }

  SmallVector<GrownVertex, 24> vertices_;
};

/// The answer on the edge of a foot.
inline Nearest on_edge(const GrowingPolygon& polygon, const GrownFoot& foot, double distance) {
  const GrownVertex &p = polygon[foot.edge], &q = polygon[polygon.next(foot.edge)];
  const auto between = [&](const CorePoint& from, const CorePoint& to) {
    const double t = foot.parameter;
    return CorePoint{t <= 0.5 ? from.point + (to.point - from.point) * t : to.point - (to.point - from.point) * (1 - t),
                     t <= 0.5 ? from.feature : to.feature};
  };
  Nearest out;
  out.normal = foot.normal;
  out.distance = distance;
  out.a = between(p.a, q.a);
  out.b = between(p.b, q.b);
  return out;
}

/// The nearest points of two bounded cores. Calls `seen(polygon, foot, found)` at each step: with the polygon so far,
/// its point nearest to the origin, and the point of the difference furthest along the normal there.
template <class T, class Seen>
Nearest search_curved(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, const Seen& seen) {
  const CurvedDifference<T> difference{a, b, b_in_a};
  GrowingPolygon polygon;
  for (const Vec2d& d : {Vec2d{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) polygon.push(difference(d));
  const double near = accuracy(a, b, b_in_a, size);
  for (;;) {
    const GrownFoot foot = polygon.foot(near);
    const GrownVertex found = difference(foot.normal);
    const double reached = dot(found.point, foot.normal);
    seen(polygon, foot, found);
    // Outside: the distance lies between the gap along this normal and the polygon's distance. Inside: the depth lies
    // between the polygon's and what the difference reaches along the normal.
    const double gap = reached - foot.reach;
    const bool met = gap <= near, full = polygon.size() >= most_grown_vertices;
    if (met || full) {
      const double outside = greatest(-reached, 0.0);
      Nearest out = on_edge(polygon, foot, foot.inside ? -reached : outside);
      if (foot.inside) {
        // Along the normal as far as the difference reaches, so that b - a = distance * normal.
        out.a.point += foot.normal * gap;
      }
      if (!met) out.status = Status::bounded, out.error = gap;
      return out;
    }
    polygon.insert(foot.edge, found);
  }
}

}  // namespace graze::plane
