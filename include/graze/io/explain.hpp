// Why an answer is what it is: one question of the protocol, asked with its trace, as text and as a picture.
//
// Guarantee: the answer is the ordinary one, bit by bit, and what explains it is made after it. Every question that the
// protocol answers can be explained.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graze/cast.hpp"
#include "graze/io/protocol.hpp"
#include "graze/plane/shape.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze::io {

/// A ray that was cast, and what it hit.
struct ExplainedRay {
  Ray<double> ray;                    ///< what was asked
  double length;                      ///< as it was asked; may be infinite
  std::optional<RayHit<double>> hit;  ///< what was answered
};

/// Two bodies that moved, and how they met.
struct ExplainedCast {
  Velocity<double> a, b;               ///< how both move
  double duration;                     ///< how long
  std::optional<CastHit<double>> hit;  ///< what was answered
};

/// What was asked, what came out, and what was done for it. Numbers of a question in float are widened.
struct Explanation {
  std::string query;  ///< "overlap", "distance", "contacts", "raycast", "cast" or "closest"
  int dimension = 3;  ///< 2 or 3.
  /// In space. Of `closest` B is the point, as a ball of no radius; of `raycast` there is none.
  std::optional<Placed<double>> a, b;
  /// In the plane, likewise; all vectors below then have z = 0.
  std::optional<plane::Placed<double>> plane_a, plane_b;
  bool overlap = false;                      ///< of `raycast` and `cast` whether they hit
  std::optional<Distance<double>> distance;  ///< of `distance` and `closest`
  Manifolds<double> manifolds;               ///< of `contacts`
  std::optional<ExplainedRay> ray;           ///< of `raycast`
  std::optional<ExplainedCast> cast;         ///< of `cast`
  Trace trace;                               ///< what the query did
};

/// Asks a question, one line of the protocol. Throws `InvalidValue` as the protocol would answer with an error.
GRAZE_API Explanation explain(std::string_view question, Precision precision);

/// What came out, in one line: "the shapes overlap, depth 0.25".
GRAZE_API std::string outcome_text(const Explanation& explanation);

/// The explanation as a table for a terminal.
GRAZE_API std::string explanation_text(const Explanation& explanation);

/// As a picture: the shapes, the winning axis with the intervals of both, the points of contact with their ids, and all
/// axes beside each other; of a ray its spans, of bodies that move both at the start and where they meet, and the steps
/// up to there. Seen across the winning axis, from the side of `toward_viewer`; the plane is seen from above, with all
/// axes of two boxes drawn as projections, and below them the Minkowski difference with the steps of GJK and EPA.
GRAZE_API std::string draw_explanation(const Explanation& explanation, const Vec3d& toward_viewer);

/// The features that a contact's number names: "face 5 of A, vertex 0 of B"; with the shapes known, an edge by the two
/// vertices that it joins ("edge 2-6 of A"), and of a round shape its surface, side or end.
GRAZE_API std::string feature_text(std::uint32_t feature);
/// A feature in words: "edge 3 of A".
GRAZE_API std::string feature_text(std::uint32_t feature, const Explanation& explanation);

}  // namespace graze::io
