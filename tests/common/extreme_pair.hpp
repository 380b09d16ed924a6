// Pairs that leave an expanding polytope little to hold on to: of extreme ratios of size, concentric, nearly identical,
// nearly parallel; and what an answer about them may be off by.
#pragma once

#include <limits>
#include <utility>

#include "common/specimen.hpp"
#include "graze/result.hpp"
#include "reference/distance.hpp"

namespace graze::testing {

float log_uniform(Random& random, float low, float high);

/// One up to ten thousand times as large as the other and about it, or both alike, by `round`; turned by nothing,
/// little or much.
std::pair<PlacedSpecimen, PlacedSpecimen> extreme_pair(Kind kind_a, Kind kind_b, Random& random, int round);

/// What an answer that is proven may be off by. A coordinate of the scene is rounded, too, however small the shapes.
template <class T>
reference::Real allowed_error(const PlacedSpecimen& a, const PlacedSpecimen& b, reference::Real size) {
  using reference::Real;
  return static_cast<Real>(tolerance<T>) * size + 16 * static_cast<Real>(std::numeric_limits<T>::epsilon()) *
                                                      static_cast<Real>(max_abs(a.translation - b.translation));
}

}  // namespace graze::testing
