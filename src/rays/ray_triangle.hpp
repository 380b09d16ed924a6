// Rays against flat convex polygons, triangles above all, in a frame in which the ray runs along an axis
// (Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", JCGT 2(1)).
//
// Guarantee: watertight. Proof: a vertex is sheared by the same operations whichever triangle asks, so the sheared mesh
// is one mesh of exact points in the plane across the ray, and the ray is the point zero there. Move the mesh in its
// plane by a little that avoids all its edges: zero then lies inside a triangle that is not seen edge-on, wherever the
// surface separates the ray's two ends. As that little goes to nothing, one such triangle remains which holds zero in
// its interior or on its border. The three sides of its edges thus have exactly one sign or are zero, and not all are
// zero. `edge_side` returns these exact signs; a triangle is hit when they do not differ and are not all zero. No step
// asks in which order triangles or vertices come. (Only products that underflow, of coordinates below 1e-140, escape
// the proof.)
#pragma once

#include "rays/round.hpp"

namespace graze::rays {

/// The frame: z along the ray in its own unit, x and y what is left across it.
class Sheared {
 public:
  explicit Sheared(const LocalRay& ray) : origin_(ray.origin) {
    const Vec3d a = abs(ray.direction);
    z_ = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (ray.direction[z_] < 0) std::swap(x_, y_);  // keeps the sense of rotation
    shear_ = {ray.direction[x_] / ray.direction[z_], ray.direction[y_] / ray.direction[z_], 1 / ray.direction[z_]};
  }
  Vec3d operator()(const Vec3d& p) const {
    const Vec3d q = p - origin_;
    return {q[x_] - shear_.x * q[z_], q[y_] - shear_.y * q[z_], shear_.z * q[z_]};
  }

  /// The axis of the frame's x (0), y (1) and z (2), and what makes up the frame.
  std::size_t axis(std::size_t i) const { return i == 0 ? x_ : i == 1 ? y_ : z_; }
  const Vec3d& origin() const { return origin_; }
  const Vec3d& shear() const { return shear_; }

 private:
  Vec3d origin_, shear_;
  std::size_t x_, y_, z_;
};

/// What rounding took from the product of `a` and `b`, exactly (Dekker 1971, "A floating-point technique for extending
/// the available precision": Veltkamp's splitting into halves of 26 digits, whose products are exact).
inline double product_error(double a, double b, double product) {
  const auto high_half = [](double v) {
    const double c = v * 134217729.0;  // 2^27 + 1
    return c - (c - v);
  };
  const double a1 = high_half(a), b1 = high_half(b), a2 = a - a1, b2 = b - b1;
  return a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2);
}

/// Twice the area of the triangle of the ray and the edge from `p` to `q`, with its exact sign: positive where a front
/// face has the ray on its inner side. Rounding is monotonic: it can make two products equal, but not exchange which is
/// the greater. Where they became equal, what rounding took from them decides.
inline double edge_side(const Vec3d& p, const Vec3d& q) {
  const double one = q.x * p.y, other = q.y * p.x;
  if (one != other) return one - other;
  return product_error(q.x, p.y, one) - product_error(q.y, p.x, other);
}

/// How the line of a ray passes a triangle of sheared vertices, and where along it when it passes through.
struct Crossing {
  enum Kind { none, front, back, edge_on } kind;
  double t;
};
inline Crossing crossing(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double u = edge_side(b, c), v = edge_side(c, a), w = edge_side(a, b);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {Crossing::none, 0};
  const double whole = u + v + w;
  if (whole == 0) return {Crossing::edge_on, 0};
  return {whole > 0 ? Crossing::front : Crossing::back, (u * a.z + v * b.z + w * c.z) / whole};
}

/// The sum of the cross products of neighbouring vertices, relative to the first (Newell's normal).
template <class Vertex>
Vec3d area_vector(std::size_t count, const Vertex& vertex) {
  const Vec3d first = vertex(0);
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < count; ++i) sum += cross(vertex(i) - first, vertex(i + 1) - first);
  return sum;
}

/// A polygon in whose plane the ray lies, as a solid of that plane: the ray clipped by the edges.
template <class Vertex>
MaybeHit hit_in_plane(const LocalRay& ray, std::size_t count, const Vertex& vertex) {
  std::size_t one = 0, other = 0;  // the ends of the longest side
  double size = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (const double side = length(vertex((i + 1) % count) - vertex(i)); side > size) {
      size = side;
      one = i;
      other = (i + 1) % count;
    }
  const Vec3d area = area_vector(count, vertex);
  const double slack = 8 * epsilon * (size + max_abs(ray.origin - vertex(0)));
  // So thin that its plane is not known: its longest side holds the others.
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

/// A flat convex polygon, from both sides or only from where `vertex(0)`, `vertex(1)`, ... run counter-clockwise.
template <class Vertex>
MaybeHit hit_polygon(const LocalRay& far, std::size_t count, const Vertex& vertex, bool both_sides = true) {
  const Recentered near = recentered(far, (vertex(0) + vertex(1) + vertex(2)) / 3.0);
  const LocalRay& ray = near.ray;
  const Sheared sheared(ray);
  double whole = 0;
  bool left = false, right = false;
  Vec3d from = sheared(vertex(count - 1));
  double low = infinity, high = -infinity;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d to = sheared(vertex(i));
    const double side = edge_side(from, to);
    left = left || side > 0;
    right = right || side < 0;
    whole += side;
    low = least(low, to.z);
    high = greatest(high, to.z);
    from = to;
  }
  if (left && right) return {};
  if (whole == 0) return near.restored(hit_in_plane(ray, count, vertex));
  if (whole < 0 && !both_sides) return {};
  const Vec3d normal = normalized(area_vector(count, vertex), -ray.direction);
  // Seen at a glancing angle the plane's t has few digits; the vertices bound it.
  const double t = clamp(dot(normal, vertex(0) - ray.origin) / dot(normal, ray.direction), low, high);
  if (!(t >= ray.begin && t <= ray.end)) return {};
  return near.restored(hit_at(ray, t, against(ray, normal)));
}

}  // namespace graze::rays
