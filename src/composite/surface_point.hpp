// The point of a mesh or height field nearest to another, and on which side of the surface that lies.
//
// Guarantee: in double, whichever scalar the surface has. Of a surface that bounds a solid the side is exact but for
// rounding, also where an edge or a vertex is nearest: it is that of the normals around it, weighted by their
// triangles' angles (Bærentzen, Aanæs 2005, "Signed distance computation using the angle weighted pseudonormal").
#pragma once

#include "composite/leaves.hpp"
#include "graze/geometry.hpp"

namespace graze {

/// The angle between two vectors in radians, by the four operations and roots alone, so that it is the same everywhere.
inline double angle_between(const Vec3d& a, const Vec3d& b) {
  const Vec3d u = normalized(a, Vec3d{}), v = normalized(b, Vec3d{});
  // Kahan 2006, "How futile are mindless assessments of roundoff", section 12: of the unit vectors' difference and sum.
  const double apart = length(u - v), along = length(u + v), larger = greatest(apart, along);
  if (!(larger > 0)) return 0;
  double x = least(apart, along) / larger;
  // The arc tangent by three halvings of its angle, then seven terms of its series: x < 0.1 leaves 1e-16.
  for (int i = 0; i < 3; ++i) x = x / (1 + std::sqrt(1 + x * x));
  const double q = x * x;
  double sum = 0;
  for (int k = 13; k > 0; k -= 2) sum = 1.0 / k - q * sum;
  const double half = 8 * x * sum;
  constexpr double pi = 3.14159265358979323846;
  return 2 * (apart <= along ? half : pi / 2 - half);
}

/// The nearest point of a triangle, with weights that are exactly zero for the corners that it does not lie between.
inline TrianglePoint<double> nearest_on_triangle(const std::array<Vec3d, 3>& t, const Vec3d& p) {
  TrianglePoint<double> nearest = closest_point_on_triangle(t[0], t[1], t[2], p);
  const Vec3d& w = nearest.weight;
  if (!(w.x > 0 && w.y > 0 && w.z > 0)) return nearest;
  // The place within the face of a sliver is rounding: an edge may be nearer.
  double least_squared = length_squared(nearest.point - p);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    const Segment<double> edge{t[i], t[k]};
    const double at = closest_parameter(edge, p);
    const Vec3d point = point_at(edge, at);
    if (!(length_squared(point - p) < least_squared)) continue;
    least_squared = length_squared(point - p);
    nearest = {point, {}};
    nearest.weight[i] = 1 - at;
    nearest.weight[k] = at;
  }
  return nearest;
}

/// The nearest point of a surface.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  TrianglePoint<double> place{};
  double distance = std::numeric_limits<double>::infinity();
};

template <class Surface>
std::array<Vec3d, 3> corners_in_double(const Surface& surface, std::uint32_t triangle) {
  const auto t = surface.triangle(triangle);
  return {converted<double>(t[0]), converted<double>(t[1]), converted<double>(t[2])};
}

/// The surface's nearest point to `p`, a point of its frame, if it is no further than `limit`; else one at infinity.
template <class T, class Surface>
SurfacePoint nearest_point(const Surface& surface, const Vec3d& p, double limit) {
  SurfacePoint best;
  best.distance = limit;
  bool found = false;
  // In the tree's scalar: what that rounds off must not rule anything out.
  const T slack = T(4) * std::numeric_limits<T>::epsilon() * (surface.extent + static_cast<T>(max_abs(p)));
  const Aabb<T> region = inflated(Aabb<T>{converted<T>(p), converted<T>(p)}, slack);
  const auto within = [&] { return static_cast<T>(best.distance) + slack; };
  visit(surface.hierarchy(), region, within, [&](std::uint32_t triangle) {
    const TrianglePoint<double> place = nearest_on_triangle(corners_in_double(surface, triangle), p);
    const double distance = length(place.point - p);
    if (found ? !(distance < best.distance) : !(distance <= best.distance)) return;
    best = {triangle, place, distance};
    found = true;
  });
  if (!found) best.distance = std::numeric_limits<double>::infinity();
  return best;
}

/// The sum of the normals of all triangles that meet where the point lies (in a face, on an edge, at a vertex), each
/// weighted by its angle there; not of unit length, and zero where none of them has an area.
template <class T, class Surface>
Vec3d pseudonormal(const Surface& surface, const SurfacePoint& at) {
  const std::array<Vec3<T>, 3> own = surface.triangle(at.triangle);
  SmallVector<Vec3<T>, 3> shared;  // the corners that the point lies between
  for (std::size_t i = 0; i < 3; ++i)
    if (at.place.weight[i] != 0) shared.push_back(own[i]);
  Vec3d sum;
  const auto add = [&](std::uint32_t triangle) {
    const std::array<Vec3<T>, 3> t = surface.triangle(triangle);
    // By place and not by index, since triangles without area may join corners of different numbers.
    for (const Vec3<T>& corner : shared)
      if (corner != t[0] && corner != t[1] && corner != t[2]) return;
    const std::array<Vec3d, 3> c = corners_in_double(surface, triangle);
    const Vec3d normal = normalized(cross(c[1] - c[0], c[2] - c[0]), Vec3d{});
    double weight = 1;
    for (std::size_t i = 0; i < 3 && shared.size() == 1; ++i)
      if (t[i] == shared[0]) weight = angle_between(c[(i + 1) % 3] - c[i], c[(i + 2) % 3] - c[i]);
    sum += normal * weight;
  };
  if (shared.size() == 3)
    add(at.triangle);
  else
    visit(
        surface.hierarchy(), Aabb<T>{shared[0], shared[0]}, [] { return T(0); }, add);
  return sum;
}

}  // namespace graze
