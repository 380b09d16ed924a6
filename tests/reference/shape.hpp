// Placed convex shapes for the test oracle, in extended precision.
//
// Nothing here may use the library: an oracle that shares code with what it
// judges shares its mistakes. Hence the vector types of its own.
//
// A shape is a core plus a rounding radius `margin` (Minkowski sum with a
// ball). Frames are right-handed, height runs along Y, and every shape but the
// polytope is centred on its origin. Every size may be zero.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace graze::reference {

using Real = long double;

struct Vector {
  Real x = 0, y = 0, z = 0;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(const Vector& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vector operator*(Real s, const Vector& a) { return a * s; }
inline Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(const Vector& a);
// The zero vector comes back unchanged.
Vector normalized(const Vector& a);
// Two unit vectors which with the unit vector `n` form a right-handed frame.
std::pair<Vector, Vector> tangents(const Vector& n);

struct Quaternion {
  Real x = 0, y = 0, z = 0, w = 1;
};

enum class Kind { Polytope, Capsule, Cylinder, Ellipsoid, Halfspace };

struct Edge {
  std::size_t first, second;
};

struct Shape {
  Kind kind = Kind::Polytope;
  Real height = 0, radius_bottom = 0, radius_top = 0;  // capsule, cylinder
  Vector radii;                                        // ellipsoid
  Real margin = 0;
  // Polytope only. Faces and edges are supersets (see hull_features): they
  // supply candidate directions, where one too many costs only time.
  std::vector<Vector> vertices;
  std::vector<Vector> face_normals;  // up to sign
  std::vector<Edge> edges;
  std::vector<Vector> edge_directions;  // unit, up to sign, without repeats
};

Shape polytope(std::vector<Vector> vertices, Real margin = 0);
Shape point(Real margin = 0);
Shape box(const Vector& full_size, Real margin = 0);
Shape sphere(Real radius);
// Convex hull of two spheres, their centres `height` apart.
Shape capsule(Real height, Real radius_bottom, Real radius_top, Real margin = 0);
// Truncated cone; a zero radius makes a cone.
Shape cylinder(Real height, Real radius_bottom, Real radius_top, Real margin = 0);
Shape ellipsoid(const Vector& radii, Real margin = 0);
// y <= margin
Shape halfspace(Real margin = 0);

struct Placed {
  Shape shape;
  Vector translation;
  Vector axis_x{1, 0, 0}, axis_y{0, 1, 0}, axis_z{0, 0, 1};  // columns of the rotation

  Vector to_world_direction(const Vector& v) const { return v.x * axis_x + v.y * axis_y + v.z * axis_z; }
  Vector to_world(const Vector& p) const { return translation + to_world_direction(p); }
  Vector to_local_direction(const Vector& v) const { return {dot(axis_x, v), dot(axis_y, v), dot(axis_z, v)}; }
  Vector to_local(const Vector& p) const { return to_local_direction(p - translation); }
};

// The quaternion is normalised in extended precision; a zero one means none.
Placed place(Shape shape, const Vector& translation = {}, const Quaternion& rotation = {});

// A halfspace is bounded in one direction only. Directions closer to its
// outward normal than this (radians) count as that normal, because a caller's
// normal is rounded, to single precision at worst.
inline constexpr Real halfspace_alignment = 1e-6L;
bool is_halfspace_normal(const Placed& halfspace, const Vector& unit);

// A point of the shape (margin included) farthest along `n`. For a halfspace,
// the point of its boundary nearest to its origin, whatever `n`.
Vector support(const Placed& placed, const Vector& n);
// max over the shape of n.x for the given n, normalised inside; +infinity for
// a halfspace in any direction but its normal.
Real support_value(const Placed& placed, const Vector& n);

// Radius about the shape's own origin of a ball that holds it, margin included;
// zero for a halfspace.
Real bounding_radius(const Shape& shape);

}  // namespace graze::reference
