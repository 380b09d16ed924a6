// Rays against flat convex polygons, above all triangles, in a frame in which the ray runs along an axis (Woop,
// Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1)).
//
// Guarantee: watertight. Proof: a vertex is sheared by the same operations for every triangle, so the sheared mesh is
// one mesh of exact points in the plane across the ray, and the ray is the point zero there. Move the mesh in its plane
// by a little that avoids all its edges: zero then lies inside a triangle that is not seen edge-on, wherever the
// surface separates the ray's two ends. As that little goes to nothing, one such triangle remains which has zero in its
// interior or on its border. The three sides of its edges thus have exactly one sign or are zero, and not all are zero.
// `edge_side` returns these exact signs; a triangle is hit when they do not differ and are not all zero. No step
// depends on the order of triangles or vertices. (Only products that underflow, of coordinates below 1e-140, escape the
// proof.)
#pragma once

#include "rays/round.hpp"

namespace graze::rays {

/// The order of the axes in a ray's frame: the one along which its direction is longest last, the others such that the
/// sense of rotation stays. Each lane has its own order.
template <class S>
class AxisOrder {
 public:
  [[gnu::always_inline]] explicit AxisOrder(const Vec3<S>& direction) {
    const Vec3<S> a = abs(direction);
    along_x_ = (a.x >= a.y) & (a.x >= a.z);
    along_y_ = (!along_x_) & (a.y >= a.z);
    back_ = select(along_x_, direction.x, select(along_y_, direction.y, direction.z)) < S(0);
  }
  [[gnu::always_inline]] Vec3<S> operator()(const Vec3<S>& v) const {
    const S x = select(along_x_, v.y, select(along_y_, v.z, v.x)),
            y = select(along_x_, v.z, select(along_y_, v.x, v.y)),
            z = select(along_x_, v.x, select(along_y_, v.y, v.z));
    return {select(back_, y, x), select(back_, x, y), z};
  }

 private:
  MaskOf<S> along_x_{}, along_y_{}, back_{};
};

/// The order for one ray, by the numbers of the axes in place of masks.
template <>
class AxisOrder<double> {
 public:
  explicit AxisOrder(const Vec3d& direction) {
    const Vec3d a = abs(direction);
    z_ = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (direction[z_] < 0) std::swap(x_, y_);
  }
  Vec3d operator()(const Vec3d& v) const { return {v[x_], v[y_], v[z_]}; }

 private:
  std::size_t x_, y_, z_;
};

/// The frame of a ray: z along it in the unit of its direction, x and y across it.
template <class S>
class RayAlignedFrame {
 public:
  [[gnu::always_inline]] explicit RayAlignedFrame(const LocalRayOf<S>& ray)
      : origin_(ray.origin), order_(ray.direction) {
    const Vec3<S> d = order_(ray.direction);
    shear_ = {d.x / d.z, d.y / d.z, S(1) / d.z};
  }
  [[gnu::always_inline]] Vec3<S> operator()(const Vec3<S>& p) const { return sheared(order_(p - origin_), shear_); }

  /// A point relative to the ray's origin, in the order of the axes, sheared into the frame.
  [[gnu::always_inline]] static Vec3<S> sheared(const Vec3<S>& p, const Vec3<S>& shear) {
    return {p.x - shear.x * p.z, p.y - shear.y * p.z, shear.z * p.z};
  }
  const AxisOrder<S>& order() const { return order_; }
  const Vec3<S>& shear() const { return shear_; }

 private:
  Vec3<S> origin_, shear_;
  AxisOrder<S> order_;
};

/// The rounding error of the product of `a` and `b`, exactly (Dekker 1971, "A floating-point technique for extending
/// the available precision": Veltkamp's splitting into halves of 26 digits, whose products are exact).
template <class S>
[[gnu::always_inline]] inline S product_error(const S& a, const S& b, const S& product) {
  const auto high_half = [](const S& v) __attribute__((always_inline)) {
    const S c = v * S(134217729.0);  // 2^27 + 1
    return c - (c - v);
  };
  const S a1 = high_half(a), b1 = high_half(b), a2 = a - a1, b2 = b - b1;
  return a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2);
}

/// Twice the area of the triangle of the ray and the edge from `p` to `q`, with its exact sign: positive where a front
/// face has the ray on its inner side. Rounding is monotonic: it can make two products equal, but not exchange which is
/// the greater. Where they became equal, their rounding errors decide.
template <class S>
[[gnu::always_inline]] inline S edge_side(const Vec3<S>& p, const Vec3<S>& q) {
  const S one = q.x * p.y, other = q.y * p.x;
  const MaskOf<S> equal = one == other;
  S side = one - other;
  if (any(equal)) side = select(equal, product_error(q.x, p.y, one) - product_error(q.y, p.x, other), side);
  return side;
}

/// The crossing of a ray's line with a triangle whose vertices are given in the ray's frame.
template <class S>
struct LineCrossing {
  MaskOf<S> through{}, edge_on{};  ///< through the inside or the border; along the plane
  S whole{}, t{};                  ///< twice the area, positive from the front; parameter along the line, if `through`
};
template <class S>
[[gnu::always_inline]] inline LineCrossing<S> line_crossing(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c) {
  const S zero(0), u = edge_side(b, c), v = edge_side(c, a), w = edge_side(a, b);
  const MaskOf<S> passed = ((u < zero) | (v < zero) | (w < zero)) & ((u > zero) | (v > zero) | (w > zero));
  if (alone(passed)) return {};
  const S whole = u + v + w;
  const MaskOf<S> flat = whole == zero, through = (!passed) & (!flat), edge_on = (!passed) & flat;
  return {through, edge_on, whole, (u * a.z + v * b.z + w * c.z) / whole};
}

/// The sum of the cross products of neighbouring vertices, relative to the first (Newell's normal).
template <class Vertex>
[[gnu::always_inline]] inline auto area_vector(std::size_t count, const Vertex& vertex) {
  const auto first = vertex(0);
  decltype(vertex(0)) sum{};
  for (std::size_t i = 1; i + 1 < count; ++i) sum += cross(vertex(i) - first, vertex(i + 1) - first);
  return sum;
}

/// The hit of a polygon in whose plane the ray lies, as a solid of that plane: the ray clipped by the edges.
template <class Vertex>
MaybeHit hit_in_plane(const LocalRay& ray, std::size_t count, const Vertex& vertex) {
  std::size_t one = 0, other = 0;  // ends of the longest side
  double size = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (const double side = length(vertex((i + 1) % count) - vertex(i)); side > size) {
      size = side;
      one = i;
      other = (i + 1) % count;
    }
  const Vec3d area = area_vector(count, vertex);
  const double slack = 8 * epsilon * (size + max_abs(ray.origin - vertex(0)));
  // The plane of so thin a polygon is unknown: its longest side contains the others.
  if (!(length(area) > slack * size)) return hit_balls(ray, vertex(one), 0, vertex(other), 0);
  const Vec3d up = normalized(area);
  double enter = -infinity, leave = infinity;
  Vec3d normal = -ray.direction;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d out = cross(vertex((i + 1) % count) - vertex(i), up);
    const double along = length(out);
    if (!(along > 0)) continue;
    const double above = dot(out, ray.origin - vertex(i)) / along, toward = dot(out, ray.direction) / along;
    if (std::abs(toward) <= 8 * epsilon) {
      if (above > slack) return {};
    } else if (const double t = -above / toward; toward > 0) {
      leave = least(leave, t);
    } else if (t > enter) {
      enter = t;
      normal = out / along;
    }
  }
  // A corner that the ray only touches is entered and left at once, by rounding in either order.
  return entered(ray, enter, leave + slack, normal);
}

/// The hit of a flat convex polygon, from both sides or only from the side where `vertex(0)`, `vertex(1)`, ... run
/// counter-clockwise. Undecided where the ray lies in the polygon's plane: `hit_in_plane`.
template <class S, class Vertex>
[[gnu::always_inline]] inline FoundHit<S> hit_across(const RecenteredOf<S>& near, std::size_t count,
                                                     const Vertex& vertex, bool both_sides) {
  const LocalRayOf<S>& ray = near.ray;
  const RayAlignedFrame<S> frame(ray);
  const S zero(0);
  S whole(0), low(infinity), high(-infinity);
  MaskOf<S> left{}, right{};
  Vec3<S> from = frame(vertex(count - 1));
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3<S> to = frame(vertex(i));
    const S side = edge_side(from, to);
    left = left | (side > zero);
    right = right | (side < zero);
    whole = whole + side;
    low = least(low, to.z);
    high = greatest(high, to.z);
    from = to;
  }
  MaskOf<S> met = !(left & right);
  if (alone(!met)) return {};
  FoundHit<S> found;
  found.undecided = met & (whole == zero);
  if (alone(found.undecided)) return found;
  if (!both_sides) met = met & !(whole < zero);
  if (alone(!met)) return {};
  const Vec3<S> normal = normalized(area_vector(count, vertex), -ray.direction);
  // Seen at a glancing angle the plane's t has few digits; the vertices bound it.
  const S t = clamp(dot(normal, vertex(0) - ray.origin) / dot(normal, ray.direction), low, high);
  found.hit = met & (t >= ray.begin) & (t <= ray.end);
  found.t = t;
  found.point = ray.at(t);
  found.normal = against(ray, normal);
  return near.restored(found);
}

/// The hit of a flat convex polygon, also where the ray lies in its plane.
template <class Vertex>
MaybeHit hit_polygon(const LocalRay& far, std::size_t count, const Vertex& vertex, bool both_sides = true) {
  const Recentered near = recentered(far, (vertex(0) + vertex(1) + vertex(2)) / 3.0);
  const FoundHit<double> found = hit_across(near, count, vertex, both_sides);
  if (found.undecided) return near.restored(hit_in_plane(near.ray, count, vertex));
  return found;
}

}  // namespace graze::rays
