// Rounding of numbers to the scalar of an answer, for routines in double that serve both scalars.
#pragma once

#include "graze/result.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

/// Roundings relative to the smaller shape.
struct AnswerRounding {
  double normal;  ///< rounding of a normal's components
  double point;   ///< distance within which two points count as one
};
template <class T>
consteval AnswerRounding answer_rounding() {
  return {normal_rounding<T>, static_cast<double>(tolerance<T>)};
}

}  // namespace graze
