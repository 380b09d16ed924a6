// Questions in the plane read as questions in space: an independent reference for the plane's kernels.
#pragma once

#include "io/question.hpp"

namespace graze::io {

/// Reads a question with `"dimension": 2` of circles, boxes, capsules, half-planes, hulls, segments, ellipses and
/// compounds; each figure becomes a prism that is deeper than any overlap in the plane can reach.
template <class T>
Question<T> read_prism_question(const JsonValue& json);

/// A figure of the plane, as the prism |z| <= `depth` over it.
template <class T>
Shape<T> read_prism(const JsonValue& json, T depth);

}  // namespace graze::io
