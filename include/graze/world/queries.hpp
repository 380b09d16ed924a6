// Queries on a scene: bodies that touch a shape, the nearest ones, and those in the way of a ray or a moving shape.
//
// Guarantee: exactly the bodies that the query is about, whatever structure finds them, sorted as each query says and
// by index where that is equal: a function of the scene and the arguments alone. Bodies are where they were last put,
// whether or not the world was updated since. Safe from several threads while nothing changes.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/world/bodies.hpp"

namespace graze {

/// The bodies that a query considers.
struct QueryFilter {
  Filter filter{};                     ///< filter of the query: it finds bodies that it may collide with
  bool triggers = false;               ///< finds triggers too
  std::function<bool(BodyId)> accept;  ///< final decision on a body; none accepts all
};

/// A body and its distance from the query's shape, which is A.
template <class T, class Space = graze::Space<T>>
struct BodyDistance {
  BodyId body;                        ///< the body
  typename Space::Distance distance;  ///< to the body
};

/// A body that a ray hits.
template <class T, class Space = graze::Space<T>>
struct BodyRayHit {
  BodyId body;                 ///< the body
  typename Space::RayHit hit;  ///< the hit
};

/// A body that a moving shape hits; the moving shape is A of the hit.
template <class T, class Space = graze::Space<T>>
struct BodyCastHit {
  BodyId body;                  ///< the body
  typename Space::CastHit hit;  ///< the hit
};

}  // namespace graze
