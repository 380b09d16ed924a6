// What a query did, step by step: the data behind every explanation.
//
// Guarantee: filled only when asked for; asking changes no bit of the answer. Vectors are in world space, with the two
// shapes in the order in which the caller gave them; simplices and polytopes are of the shapes' cores, rounding aside.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graze/vec3.hpp"

namespace graze {

/// One separating axis: the intervals that both shapes cover on it.
struct TraceAxis {
  std::string name;                           ///< "A0", "B2", "A1×B0", "A face 12", "A edge 1 × B edge 7", "normal"
  Vec3d direction;                            ///< unit, from A to B
  double a_lower, a_upper, b_lower, b_upper;  ///< the intervals of A and of B on the axis
  /// Positive when the shapes' intervals overlap along `direction`, negative when there is a gap.
  double overlap() const { return a_upper - b_lower; }
};

/// One point of the Minkowski difference B - A and the support points it was made of.
struct TraceSupport {
  Vec3d a, b;  ///< the support points of A and of B
};

/// One iteration of GJK: where it looked, what it found, and what it knew then.
struct TraceGjk {
  std::vector<TraceSupport> simplex;  ///< at the beginning of the iteration
  Vec3d direction;                    ///< the search direction, from A to B
  TraceSupport found;                 ///< what was found along the direction
  double lower, upper;                ///< bounds of the distance of the cores after it
  /// In the plane, where all vertices are kept and `simplex` is the nearest edge: all of them, counter-clockwise.
  std::vector<TraceSupport> polygon{};
};

/// One expansion of EPA's polytope.
struct TraceEpa {
  Vec3d normal;        ///< of the face that lay nearest to the origin, from A to B
  double face_depth;   ///< the depth if that face were final: a lower bound
  double found_depth;  ///< the depth along that normal: an upper bound
  TraceSupport found;  ///< what was found along the direction
  std::size_t faces;   ///< of the polytope, after the expansion
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
  double t;         ///< where along the ray, or when
  double distance;  ///< of the shapes there and then
  Vec3d normal;     ///< unit, from A to B: of the plane that the step runs up to
};

/// One cut of the face of one shape by the plane through a side of the other's, upright on the contact plane.
struct TraceCut {
  Vec3d from, to;           ///< the side
  std::vector<Vec3d> left;  ///< what is left of the face that is cut, counter-clockwise seen from B
};

/// Everything that one query did.
struct Trace {
  std::string method;  ///< "closed form", "separating axes", "gjk", "gjk + epa", "slabs", "conservative advancement"
  std::vector<TraceAxis> axes;  ///< separating axes that were tried
  std::vector<TraceGjk> gjk;    ///< iterations of GJK
  std::vector<TraceEpa> epa;    ///< expansions of EPA
  /// In the plane: the outline of the difference of the bounded cores, counter-clockwise; of curved ones sampled.
  std::vector<TraceSupport> difference;
  double rounding = 0;                                ///< of both cores together: how near to it counts as contact
  std::vector<TraceSupport> polytope;                 ///< EPA's final vertices
  std::vector<std::array<std::size_t, 3>> triangles;  ///< and its triangles
  /// The faces that contacts stand on, where they stand on faces: an edge has two corners.
  std::vector<Vec3d> face_a, face_b;
  /// How the faces are laid over each other: what is left of A's after each cut along B's, or of B's along A's where
  /// only B's is an edge. Empty where both are edges.
  std::vector<TraceCut> cuts;
  std::vector<TraceSpan> spans;       ///< of a ray at a convex shape in closed form
  std::vector<TraceStep> steps;       ///< of casts, and of rays at what is known by its distance
  std::size_t nodes = 0, pieces = 0;  ///< of a composite's tree, that a ray visited
  std::string winner;                 ///< the axis or span that the answer stands on, if any
  std::string reason;                 ///< why it won, in one sentence
};

}  // namespace graze
