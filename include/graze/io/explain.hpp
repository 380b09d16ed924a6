// Why an answer is what it is: one question of the protocol, asked with its trace, as text and as a picture.
//
// Guarantee: the explanation is of the very computation that answers the question; nothing is computed again in another
// way. Every question that the protocol answers can be explained.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graze/io/protocol.hpp"
#include "graze/query.hpp"

namespace graze::io {

/// What was asked, what came out, and what was done for it. Numbers of a question in float are widened.
struct Explanation {
  std::string query;                   ///< "overlap", "distance", "contacts" or "closest"
  int dimension = 3;                   ///< of two, figures are prisms along Z
  std::optional<Placed<double>> a, b;  ///< of `closest` B is the point, as a ball of no radius
  bool overlap = false;
  std::optional<Distance<double>> distance;  ///< of `distance` and `closest`
  Manifolds<double> manifolds;               ///< of `contacts`
  Trace trace;
};

/// Asks a question, one line of the protocol. Throws `InvalidValue` as the protocol would answer with an error.
Explanation explain(std::string_view question, Precision precision);

/// The explanation as a table for a terminal.
std::string explanation_text(const Explanation& explanation);

/// As a picture: the shapes, the winning axis with the intervals of both, the points of contact with their ids, and all
/// axes beside each other. Seen across the winning axis, from the side of `toward_viewer`.
std::string draw_explanation(const Explanation& explanation, const Vec3d& toward_viewer);

/// The features that a contact's number names: "A face 5, B vertex 0".
std::string feature_text(std::uint32_t feature);

}  // namespace graze::io
