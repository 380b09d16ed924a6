// How far off numbers are that were rounded to the scalar of an answer: for routines in double that serve both scalars.
#pragma once

#include "graze/result.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

/// Relative to the smaller shape.
struct AnswerRounding {
  double normal;  ///< of its components
  double point;   ///< up to where two points count as one
};
template <class T>
consteval AnswerRounding answer_rounding() {
  return {normal_rounding<T>, static_cast<double>(tolerance<T>)};
}

}  // namespace graze
