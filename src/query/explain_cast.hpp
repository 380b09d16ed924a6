// What an explanation says of two bodies that move.
//
// Guarantee: made after the answer and from it; nothing here is run, and nothing of it decides, when no explanation is
// asked for.
#pragma once

#include "graze/cast.hpp"

namespace graze {

/// A body on its way, for the span of a call.
template <class T>
struct BodyOnItsWay {
  const Shape<T>& shape;
  const Pose<T>& pose;
  const Velocity<T>& velocity;
};

/// Writes the steps of conservative advancement up to the hit, or to where the bodies are known to miss, and the
/// separating axes as they are then.
template <class T>
void explain_cast(const BodyOnItsWay<T>& a, const BodyOnItsWay<T>& b, T duration, const std::optional<CastHit<T>>& hit,
                  Trace& trace);

}  // namespace graze
