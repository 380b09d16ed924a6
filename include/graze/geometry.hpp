// Elementary geometric queries: nearest points between points, lines, planes, triangles and boxes; rays against them;
// planes from points and normals; a box as vertices, planes or edge vectors.
//
// Guarantee: closed forms in IEEE-exact operations, without a branch on the data, so that they run on any lane type.
// Degenerate input (a segment without length, a triangle without area) is treated as the point or segment it has
// become.
// Sources: Ericson 2005, "Real-time collision detection", chapter 5; Eberly 2000-2020, "Geometric tools", distance
// pages; Möller, Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
#pragma once

#include <array>
#include <limits>

#include "graze/detail/extended.hpp"
#include "graze/lines.hpp"
#include "graze/pose.hpp"
#include "graze/wide.hpp"

namespace graze {

/// `numerator / denominator`, or zero where the denominator is not positive.
template <class T>
T ratio(const T& numerator, const T& denominator) {
  const auto positive = denominator > T(0);
  return select(positive, numerator / select(positive, denominator, T(1)), T(0));
}

/// The parameter, from 0 at `a` to 1 at `b`, of the point of the segment nearest to `p`.
template <class T>
T closest_parameter(const Segment<T>& s, const Vec3<T>& p) {
  const Vec3<T> d = s.b - s.a;
  return clamp(ratio(dot(p - s.a, d), dot(d, d)), T(0), T(1));
}

/// The point of the segment at parameter `t`, computed from the nearer end, so that t = 1 gives `b` to the last bit.
template <class T>
Vec3<T> point_at(const Segment<T>& s, const T& t) {
  const Vec3<T> d = s.b - s.a;
  return select(t <= T(0.5), s.a + d * t, s.b - d * (T(1) - t));
}

/// The point of the segment nearest to `p`.
template <class T>
Vec3<T> closest_point(const Segment<T>& s, const Vec3<T>& p) {
  return point_at(s, closest_parameter(s, p));
}

/// The nearest point of the infinite line through a ray's origin along its direction.
template <class T>
Vec3<T> closest_point_on_line(const Ray<T>& line, const Vec3<T>& p) {
  return line.origin +
         line.direction * ratio(dot(p - line.origin, line.direction), dot(line.direction, line.direction));
}

/// The point of the plane nearest to `p`.
template <class T>
Vec3<T> closest_point(const Plane<T>& plane, const Vec3<T>& p) {
  return p - plane.normal * signed_distance(plane, p);
}

/// The nearest point of the box |q_i| <= half_i: `p` itself when inside.
template <class T>
Vec3<T> closest_point_in_box(const Vec3<T>& half, const Vec3<T>& p) {
  return greatest(-half, least(half, p));
}

/// A point of a triangle with its barycentric weights.
template <class T>
struct TrianglePoint {
  Vec3<T> point;   ///< the point
  Vec3<T> weight;  ///< barycentric weights of the vertices a, b, c; they sum to one
};

namespace detail {

/// The point of a triangle nearest to `p`, by barycentric coordinates, which are areas, and by the edges. An area loses
/// as many digits as the triangle is slender.
template <class T>
TrianglePoint<T> closest_point_by_areas(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& p) {
  const Vec3<T> n = cross(b - a, c - a);
  const T area = dot(n, n);
  // Barycentric coordinates of the projection of p; all positive inside.
  const T u = dot(n, cross(b - p, c - p)), v = dot(n, cross(c - p, a - p)), w = dot(n, cross(a - p, b - p));
  const auto inside = (u > T(0)) & (v > T(0)) & (w > T(0)) & (area > T(0));
  const T whole = select(inside, u + v + w, T(1));
  const TrianglePoint<T> in_face{a * (u / whole) + b * (v / whole) + c * (w / whole),
                                 {u / whole, v / whole, w / whole}};

  const T ab = closest_parameter<T>({a, b}, p), bc = closest_parameter<T>({b, c}, p),
          ca = closest_parameter<T>({c, a}, p);
  const Vec3<T> on_ab = point_at<T>({a, b}, ab), on_bc = point_at<T>({b, c}, bc), on_ca = point_at<T>({c, a}, ca);
  const T d_ab = length_squared(on_ab - p), d_bc = length_squared(on_bc - p), d_ca = length_squared(on_ca - p);
  const auto take_bc = d_bc < d_ab;
  const T d_first = select(take_bc, d_bc, d_ab);
  const Vec3<T> first = select(take_bc, on_bc, on_ab);
  const Vec3<T> first_weight = select(take_bc, Vec3<T>{T(0), T(1) - bc, bc}, Vec3<T>{T(1) - ab, ab, T(0)});
  const auto take_ca = d_ca < d_first;
  const Vec3<T> edge = select(take_ca, on_ca, first);
  const Vec3<T> edge_weight = select(take_ca, Vec3<T>{ca, T(0), T(1) - ca}, first_weight);
  return {select(inside, in_face.point, edge), select(inside, in_face.weight, edge_weight)};
}

}  // namespace detail

/// The height of a triangle over its longest edge, relative to that edge, below which areas are computed with twice the
/// digits: at this ratio they have lost two digits.
inline constexpr double slender_triangle = 1.0 / 128;

/// The point of the triangle a, b, c nearest to `p`, accurate to some roundings of the coordinates and of the distance
/// however slender the triangle. Slender ones take some twenty times as long.
template <class T>
TrianglePoint<T> closest_point_on_triangle(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& p) {
  const TrianglePoint<T> by_areas = detail::closest_point_by_areas(a, b, c, p);
  const T longest = greatest(length_squared(b - a), greatest(length_squared(c - b), length_squared(a - c)));
  const auto slender = length_squared(cross(b - a, c - a)) < T(slender_triangle * slender_triangle) * longest * longest;
  if (!any(slender)) return by_areas;
  const auto exact = detail::closest_point_by_areas(extended(a), extended(b), extended(c), extended(p));
  return {select(slender, converted<T>(exact.point), by_areas.point),
          select(slender, converted<T>(exact.weight), by_areas.weight)};
}

/// Parameters of the nearest points of two segments or of two lines.
template <class T>
struct ClosestParameters {
  T s, t;  ///< along the first and the second, in units of their directions
};

/// The parameters of the nearest points of two segments; for parallel ones, of some nearest pair.
template <class T>
ClosestParameters<T> closest_parameters(const Segment<T>& p, const Segment<T>& q) {
  const Vec3<T> d1 = p.b - p.a, d2 = q.b - q.a, r = p.a - q.a;
  const T a = dot(d1, d1), e = dot(d2, d2), b = dot(d1, d2);
  // Numerators by the cross product, which loses no digits to cancellation for near-parallel segments.
  const Vec3<T> n = cross(d1, d2);
  // Scaled, so that lengths are multiplied twice and not four times.
  const T scale = max_abs(n);
  const Vec3<T> m = n / select(scale > T(0), scale, T(1));
  const T s_line = clamp(ratio(ratio(dot(cross(d2, r), m), scale), dot(m, m)), T(0), T(1));
  // Clamp one, answer with the other, clamp that, and answer once more (Ericson 2005, section 5.1.9).
  const T t = clamp(ratio(b * s_line + dot(d2, r), e), T(0), T(1));
  const T s = clamp(ratio(b * t - dot(d1, r), a), T(0), T(1));
  const T t_again = clamp(ratio(b * s + dot(d2, r), e), T(0), T(1));
  return {s, t_again};
}

/// The parameters of the nearest points of two infinite lines; for parallel ones s = 0.
template <class T>
ClosestParameters<T> closest_parameters_of_lines(const Ray<T>& p, const Ray<T>& q) {
  const Vec3<T> r = p.origin - q.origin, n = cross(p.direction, q.direction);
  const T nn = dot(n, n);
  const T s = ratio(dot(cross(q.direction, r), n), nn);
  const T t = ratio(dot(q.direction, r + p.direction * s), dot(q.direction, q.direction));
  return {s, t};
}

/// The parameter `t` at which a ray meets a plane, in multiples of the ray's direction; infinite for a miss.
template <class T>
T intersect(const Ray<T>& ray, const Plane<T>& plane) {
  const T toward = dot(plane.normal, ray.direction), above = signed_distance(plane, ray.origin);
  const T t = -above / select(toward != T(0), toward, T(1));
  const auto hit = (toward != T(0)) & (t >= T(0));
  return select(hit, t, select(above == T(0), T(0), T(std::numeric_limits<float>::infinity())));
}

/// The parameter of a ray's first hit with a ball's surface, 0 when the ray starts inside, infinite for a miss. The
/// direction is of unit length.
template <class T>
T intersect_sphere(const Ray<T>& ray, const Vec3<T>& center, const T& radius) {
  using std::sqrt;
  const Vec3<T> to = center - ray.origin;
  const T along = dot(to, ray.direction);
  // Distance of the centre from the ray by the perpendicular part of `to`, not by a difference of squares, which
  // cancels (Hearn, Baker).
  const Vec3<T> across = to - ray.direction * along;
  const T under = radius * radius - dot(across, across);
  const auto inside = dot(to, to) <= radius * radius;
  const auto hit = (under >= T(0)) & (along >= T(0));
  const T entry = along - sqrt(select(hit, under, T(0)));
  return select(inside, T(0), select(hit, entry, T(std::numeric_limits<float>::infinity())));
}

/// The parameter of a ray's first hit with the box |q_i| <= half_i, 0 when the ray starts inside, infinite for a miss
/// (slabs: Kay, Kajiya 1986).
template <class T>
T intersect_box(const Ray<T>& ray, const Vec3<T>& half) {
  const T inf(std::numeric_limits<float>::infinity());
  T enter(0), leave = inf;
  for (std::size_t i = 0; i < 3; ++i) {
    const T d = ray.direction[i], o = ray.origin[i];
    const auto moving = d != T(0);
    const T inverse = T(1) / select(moving, d, T(1));
    const T t0 = (-half[i] - o) * inverse, t1 = (half[i] - o) * inverse;
    const auto within = (o >= -half[i]) & (o <= half[i]);
    enter = greatest(enter, select(moving, least(t0, t1), select(within, T(0), inf)));
    leave = least(leave, select(moving, greatest(t0, t1), inf));
  }
  return select(enter <= leave, enter, inf);
}

/// The hit of a ray with a triangle.
template <class T>
struct TriangleHit {
  T t;             ///< parameter along the ray, in units of its direction; infinite for a miss
  Vec3<T> weight;  ///< barycentric weights of the vertices; they sum to one
};

/// The hit of a ray with the triangle a, b, c (Möller, Trumbore 1997). Both sides count; a ray in the triangle's plane
/// misses.
template <class T>
TriangleHit<T> intersect_triangle(const Ray<T>& ray, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const Vec3<T> ab = b - a, ac = c - a, p = cross(ray.direction, ac);
  const T det = dot(ab, p);
  const auto facing = det != T(0);
  const T inverse = T(1) / select(facing, det, T(1));
  const Vec3<T> from = ray.origin - a, q = cross(from, ab);
  const T v = dot(from, p) * inverse, w = dot(ray.direction, q) * inverse, t = dot(ac, q) * inverse;
  const auto hit = facing & (v >= T(0)) & (w >= T(0)) & (v + w <= T(1)) & (t >= T(0));
  return {select(hit, t, T(std::numeric_limits<float>::infinity())), {T(1) - v - w, v, w}};
}

/// The plane of three points, its normal on the side from which they run counter-clockwise; for collinear points, a
/// plane through them.
template <class T>
Plane<T> plane_through(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const Vec3<T> n = normalized(cross(b - a, c - a), any_perpendicular(normalized(b - a)));
  return {n, dot(n, a)};
}
/// The plane with a normal (of any length but zero) through a point.
template <class T>
Plane<T> plane_at(const Vec3<T>& normal, const Vec3<T>& point) {
  const Vec3<T> n = normalized(normal);
  return {n, dot(n, point)};
}
/// The plane with a normal (of any length but zero) at a signed distance from the origin.
template <class T>
Plane<T> plane_from(const Vec3<T>& normal, const T& distance) {
  return {normalized(normal), distance};
}

/// A box in any place: centre and rotation as a pose, half extents along its own axes.
template <class T>
struct OrientedBox {
  Pose<T> pose{};  ///< pose of the box's frame
  Vec3<T> half{};  ///< half of the edge lengths
};

/// A box as one corner and the three edge vectors that leave it, right-handed and perpendicular.
template <class T>
struct CornerBox {
  Vec3<T> corner{};   ///< one corner
  Vec3<T> edge[3]{};  ///< from the corner to its three neighbours
};

/// The eight vertices: bit i of the index is set on the positive side of axis i.
template <class T>
std::array<Vec3<T>, 8> vertices_of(const OrientedBox<T>& box) {
  std::array<Vec3<T>, 8> out;
  for (std::size_t i = 0; i < 8; ++i)
    out[i] = transform(box.pose, {i & 1 ? box.half.x : -box.half.x, i & 2 ? box.half.y : -box.half.y,
                                  i & 4 ? box.half.z : -box.half.z});
  return out;
}
/// The six planes, outward: negative and positive side of x, then y, then z.
template <class T>
std::array<Plane<T>, 6> planes_of(const OrientedBox<T>& box) {
  const Mat3<T> m = rotation_matrix(box.pose.rotation);
  std::array<Plane<T>, 6> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<T> n = m.column(i);
    const T at = dot(n, box.pose.translation);
    out[2 * i] = {-n, box.half[i] - at};
    out[2 * i + 1] = {n, at + box.half[i]};
  }
  return out;
}
/// The box by its corner of least local coordinates and the edges that leave it.
template <class T>
CornerBox<T> corner_of(const OrientedBox<T>& box) {
  const Mat3<T> m = rotation_matrix(box.pose.rotation);
  return {transform(box.pose, -box.half),
          {m.column(0) * (T(2) * box.half.x), m.column(1) * (T(2) * box.half.y), m.column(2) * (T(2) * box.half.z)}};
}

/// The unit quaternion of a rotation matrix (Shepperd 1978, "Quaternion from rotation matrix": by the largest of the
/// four components, so that no root is taken of a small difference).
template <class T>
Quat<T> rotation_quaternion(const Mat3<T>& m) {
  using std::sqrt;
  const T xx = m.row[0].x, yy = m.row[1].y, zz = m.row[2].z;
  const T four[4] = {T(1) + xx - yy - zz, T(1) - xx + yy - zz, T(1) - xx - yy + zz, T(1) + xx + yy + zz};
  std::size_t i = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (four[k] > four[i]) i = k;
  const T yz = m.row[2].y + m.row[1].z, zx = m.row[0].z + m.row[2].x, xy = m.row[1].x + m.row[0].y;
  const T wx = m.row[2].y - m.row[1].z, wy = m.row[0].z - m.row[2].x, wz = m.row[1].x - m.row[0].y;
  const Quat<T> q = i == 0   ? Quat<T>{four[0], xy, zx, wx}
                    : i == 1 ? Quat<T>{xy, four[1], yz, wy}
                    : i == 2 ? Quat<T>{zx, yz, four[2], wz}
                             : Quat<T>{wx, wy, wz, four[3]};
  return normalized(q);
}

/// The box of a corner and its edge vectors. An edge of zero length takes the direction that the others leave it.
template <class T>
OrientedBox<T> box_of(const CornerBox<T>& c) {
  const Vec3<T> sum = c.edge[0] + c.edge[1] + c.edge[2];
  const Vec3<T> l{length(c.edge[0]), length(c.edge[1]), length(c.edge[2])};
  Vec3<T> axis[3];
  std::size_t longest = l.x >= l.y && l.x >= l.z ? 0 : l.y >= l.z ? 1 : 2;
  const std::size_t next = (longest + 1) % 3, last = (longest + 2) % 3;
  axis[longest] = normalized(c.edge[longest], longest == 0 ? Vec3<T>{T(1), T(0), T(0)} : Vec3<T>{T(0), T(1), T(0)});
  const Vec3<T> guess = l[next] > T(0)   ? normalized(c.edge[next])
                        : l[last] > T(0) ? cross(normalized(c.edge[last]), axis[longest])
                                         : any_perpendicular(axis[longest]);
  axis[last] = normalized(cross(axis[longest], guess), any_perpendicular(axis[longest]));
  axis[next] = cross(axis[last], axis[longest]);
  const Mat3<T> m = Mat3<T>::from_columns(axis[0], axis[1], axis[2]);
  return {{c.corner + sum * T(0.5), rotation_quaternion(m)}, l * T(0.5)};
}
/// The box of its eight vertices, in the order of `vertices_of`.
template <class T>
OrientedBox<T> box_of(const std::array<Vec3<T>, 8>& v) {
  return box_of(CornerBox<T>{v[0], {v[1] - v[0], v[2] - v[0], v[4] - v[0]}});
}
/// The box of its six planes, in the order of `planes_of`.
template <class T>
OrientedBox<T> box_of(const std::array<Plane<T>, 6>& p) {
  OrientedBox<T> box;
  const Mat3<T> m = Mat3<T>::from_columns(p[1].normal, p[3].normal, p[5].normal);
  for (std::size_t i = 0; i < 3; ++i) {
    box.half[i] = (p[2 * i].offset + p[2 * i + 1].offset) * T(0.5);
    box.pose.translation += p[2 * i + 1].normal * ((p[2 * i + 1].offset - p[2 * i].offset) * T(0.5));
  }
  box.pose.rotation = rotation_quaternion(m);
  return box;
}

}  // namespace graze
