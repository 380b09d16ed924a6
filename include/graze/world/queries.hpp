// What a scene is asked: what is here, what is nearest, what is in the way.
//
// Guarantee: exactly the bodies that the question is about, whatever structure finds them, sorted as each question says
// and by index where that is equal: a function of the scene and the question alone. Bodies are where they were last
// put, whether or not the world was updated since. Safe from several threads while nothing changes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/world/bodies.hpp"

namespace graze {

/// Which bodies a question is about.
struct QueryFilter {
  Filter filter{};                     ///< of the one who asks: it finds what it may collide with
  bool triggers = false;               ///< finds triggers too
  std::function<bool(BodyId)> accept;  ///< a last word; none accepts all
};

/// A body and how far it is from the shape that was asked about, which is A of the distance.
template <class T, class Space = graze::Space<T>>
struct BodyDistance {
  BodyId body;                        ///< which body it is
  typename Space::Distance distance;  ///< to the body
};

/// A body that a ray hits.
template <class T, class Space = graze::Space<T>>
struct BodyRayHit {
  BodyId body;                 ///< which body it is
  typename Space::RayHit hit;  ///< where it is hit
};

/// A body that a moving shape hits, which is A of the hit.
template <class T, class Space = graze::Space<T>>
struct BodyCastHit {
  BodyId body;                  ///< which body it is
  typename Space::CastHit hit;  ///< where it is hit
};

}  // namespace graze
