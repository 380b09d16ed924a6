// Explanation of a cast of two moving bodies.
//
// Guarantee: made from the answer and after it; nothing here runs without a request for an explanation, nor has an
// influence on an answer.
#pragma once

#include "graze/cast.hpp"

namespace graze {

/// A moving body, for the duration of a call.
template <class T>
struct BodyOnItsWay {
  const Shape<T>& shape;
  const Pose<T>& pose;
  const Velocity<T>& velocity;
};

/// Writes the steps of conservative advancement up to the hit, or up to the time from which a miss is certain, and the
/// separating axes at that time.
template <class T>
void explain_cast(const BodyOnItsWay<T>& a, const BodyOnItsWay<T>& b, T duration, const std::optional<CastHit<T>>& hit,
                  Trace& trace);

}  // namespace graze
