// Explanations of the answers for any two shapes; of composites, at the pair of pieces that decides: the nearest or
// deepest, and of contacts the one that gave the deepest point.
//
// Guarantee: as narrow/explain.hpp.
#pragma once

#include <span>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

template <class T>
void explain_any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                          const Distance<T>& answer, Trace& trace);

template <class T>
void explain_any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         Trace& trace);

/// `answer`: the manifolds that were found.
template <class T>
void explain_any_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                          std::span<const Manifold<T>> answer, Trace& trace);

template <class T>
void explain_any_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, const Closest<T>& answer,
                         Trace& trace);

}  // namespace graze
