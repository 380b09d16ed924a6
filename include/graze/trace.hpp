// Traces: the steps of a query, the data behind every explanation.
//
// Guarantee: filled only on request, after the answer; no bit of the answer changes by it. Vectors are in world space,
// with the two shapes in the order in which the caller gave them; simplices and polytopes are of the shapes' cores,
// without rounding.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graze/vec3.hpp"

namespace graze {

/// One separating axis: the intervals that the projections of both shapes cover on it.
struct TraceAxis {
  std::string name;                           ///< "A0", "B2", "A1×B0", "A face 12", "A edge 1 × B edge 7", "normal"
  Vec3d direction;                            ///< unit, from A to B
  double a_lower, a_upper, b_lower, b_upper;  ///< the intervals of A and of B on the axis
  /// Positive when the shapes' intervals overlap along `direction`, negative when there is a gap.
  double overlap() const { return a_upper - b_lower; }
};

/// One point of the Minkowski difference B - A and the support points that it is made of.
struct TraceSupport {
  Vec3d a, b;  ///< the support points of A and of B
};

/// One iteration of GJK: the simplex, the search direction, the support point found, and the bounds that follow.
struct TraceGjk {
  std::vector<TraceSupport> simplex;  ///< simplex at the beginning of the iteration
  Vec3d direction;                    ///< the search direction, from A to B
  TraceSupport found;                 ///< support point found along the direction
  double lower, upper;                ///< bounds of the cores' distance after the iteration
  /// In the plane: all vertices, counter-clockwise, since all are kept there and `simplex` is the nearest edge.
  std::vector<TraceSupport> polygon{};
};

/// One expansion of EPA's polytope.
struct TraceEpa {
  Vec3d normal;        ///< unit normal of the face nearest to the origin, from A to B
  double face_depth;   ///< the depth if that face were final: a lower bound
  double found_depth;  ///< the depth along that normal: an upper bound
  TraceSupport found;  ///< support point found along the normal
  std::size_t faces;   ///< faces of the polytope after the expansion
  /// In the plane the polytope before the expansion, counter-clockwise.
  std::vector<TraceSupport> polygon{};
};

/// One condition on the points of a shape (between two parallel faces, behind a plane, in a ball), and the part of a
/// ray that meets it.
struct TraceSpan {
  std::string name;     ///< "slab x", "face 12", "ball", "side"
  Vec3d normal;         ///< unit, outward, where the ray comes in; zero where it never does
  double enter, leave;  ///< along the ray, in units of length; nowhere when enter > leave
};

/// One step of conservative advancement, of a ray or of moving shapes.
struct TraceStep {
  double t;         ///< distance along the ray, or time
  double distance;  ///< distance of the shapes at t
  Vec3d normal;     ///< unit, from A to B: normal of the plane that the step runs up to
};

/// One cut of the face of one shape by the plane through a side of the other's, upright on the contact plane.
struct TraceCut {
  Vec3d from, to;           ///< a side of the cutting face, as a segment
  std::vector<Vec3d> left;  ///< remainder of the face that is cut, counter-clockwise seen from B
};

/// All steps of one query.
struct Trace {
  std::string method;  ///< "closed form", "separating axes", "gjk", "gjk + epa", "slabs", "conservative advancement"
  std::vector<TraceAxis> axes;  ///< separating axes that were tried
  std::vector<TraceGjk> gjk;    ///< iterations of GJK
  std::vector<TraceEpa> epa;    ///< expansions of EPA
  /// In the plane: the outline of the difference of the bounded cores, counter-clockwise; curved ones are sampled.
  std::vector<TraceSupport> difference;
  double rounding = 0;                                ///< rounding radius of both cores together: the distance from the
                                                      ///< origin that counts as contact
  std::vector<TraceSupport> polytope;                 ///< EPA's final vertices
  std::vector<std::array<std::size_t, 3>> triangles;  ///< triangles of EPA's final polytope
  /// The faces that contacts are clipped from; an edge has two corners.
  std::vector<Vec3d> face_a, face_b;
  /// The cuts of the clipping: the remainder of A's face after each cut along B's sides, or of B's along A's where only
  /// B's is an edge. Empty where both are edges.
  std::vector<TraceCut> cuts;
  std::vector<TraceSpan> spans;       ///< spans of a ray at a convex shape in closed form
  std::vector<TraceStep> steps;       ///< steps of casts, and of rays at shapes given by their distance
  std::size_t nodes = 0, pieces = 0;  ///< nodes of a composite's tree and pieces that a ray visited
  std::string winner;                 ///< the axis or span that decided, if any
  std::string reason;                 ///< the reason for the winner, in one sentence
};

}  // namespace graze
