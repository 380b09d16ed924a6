// Explanations: one query of the protocol answered with its trace, as text and as a picture.
//
// Guarantee: the answer is the ordinary one, bit by bit, and the explanation is made after it. Every query that the
// protocol answers can be explained.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graze/cast.hpp"
#include "graze/impulse.hpp"
#include "graze/io/protocol.hpp"
#include "graze/plane/shape.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze::io {

/// A ray cast and its result.
struct ExplainedRay {
  Ray<double> ray;                    ///< the ray of the query
  double length;                      ///< length of the query; may be infinite
  std::optional<RayHit<double>> hit;  ///< result of the query
};

/// Two moving bodies and their first contact.
struct ExplainedCast {
  Velocity<double> a, b;               ///< velocities of the two
  double duration;                     ///< duration of the motion
  std::optional<CastHit<double>> hit;  ///< result of the query
};

/// A blow: the contact, the bodies before it, and the response with all quantities that lead to it.
struct ExplainedResponse {
  StruckContact<double> contact;  ///< contact of the query
  StruckBody<double> a, b;        ///< bodies of the query
  Response<double> result;        ///< result of the query
};

/// A query with its result and its trace. Numbers of a query in float are widened.
struct Explanation {
  std::string query;  ///< "overlap", "distance", "contacts", "raycast", "cast", "closest" or "response"
  int dimension = 3;  ///< 2 or 3
  /// The bodies, in space. B of a `closest` is the point, as a ball of zero radius; a `raycast` has no B; those of a
  /// `response` are there if the query gives their shapes.
  std::optional<Placed<double>> a, b;
  /// The bodies, in the plane; all vectors below then have z = 0.
  std::optional<plane::Placed<double>> plane_a, plane_b;
  bool overlap = false;                       ///< for `raycast` and `cast`: whether there is a hit
  std::optional<Distance<double>> distance;   ///< result of `distance` and `closest`
  Manifolds<double> manifolds;                ///< result of `contacts`
  std::optional<ExplainedRay> ray;            ///< query and result of `raycast`
  std::optional<ExplainedCast> cast;          ///< query and result of `cast`
  std::optional<ExplainedResponse> response;  ///< query and result of `response`
  Trace trace;                                ///< steps of the query
};

/// Answers and explains a query, one line of the protocol. Throws `InvalidValue` where the protocol answers with an
/// error.
GRAZE_API Explanation explain(std::string_view question, Precision precision);

/// The result in one line: "the shapes overlap, depth 0.25".
GRAZE_API std::string outcome_text(const Explanation& explanation);

/// The explanation as a table for a terminal.
GRAZE_API std::string explanation_text(const Explanation& explanation);

/// The explanation as a picture in SVG: the shapes, labelled A and B, the winning axis with the intervals of both, the
/// points of contact with their ids, and all axes beside each other; for a ray its spans, for moving bodies both at the
/// start and at the hit, and the steps up to there; for a blow the velocities before and after it, the impulse and
/// Coulomb's cone. Seen across the winning axis, from the side of `toward_viewer`; the plane is seen from above, with
/// all axes of two boxes drawn as projections, and below them the Minkowski difference with the steps of GJK and EPA.
GRAZE_API std::string draw_explanation(const Explanation& explanation, const Vec3d& toward_viewer);

/// The features of a contact's number in words: "face 5 of A, vertex 0 of B".
GRAZE_API std::string feature_text(std::uint32_t feature);
/// The features of a contact's number in words, with the shapes known: an edge by its two vertices ("edge 2-6 of A"), a
/// feature of a round shape as its surface, side or end.
GRAZE_API std::string feature_text(std::uint32_t feature, const Explanation& explanation);

}  // namespace graze::io
