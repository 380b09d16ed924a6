// What a scene is asked: what is here, what is nearest, what is in the way.
//
// Guarantee: every body that answers and is asked for, whichever structure found it; sorted as each question says, so a
// function of the scene and the question alone. The nearer parts are looked at first, and nothing that is further than
// what is known already.
#pragma once

#include <functional>
#include <vector>

#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "graze/world/bodies.hpp"

namespace graze {

/// Which bodies a question is about.
struct QueryFilter {
  Filter filter{};                     ///< the one who asks: it sees what it could collide with
  bool triggers = false;               ///< sees triggers too
  std::function<bool(BodyId)> accept;  ///< a last word; none accepts all
};

/// A body and how far it is.
template <class T>
struct BodyDistance {
  BodyId body;
  Distance<T> distance;  ///< from the shape that was asked about (A) to the body (B)
};

template <class T>
struct BodyRayHit {
  BodyId body;
  RayHit<T> hit;
};

template <class T>
struct BodyCastHit {
  BodyId body;
  CastHit<T> hit;
};

}  // namespace graze
