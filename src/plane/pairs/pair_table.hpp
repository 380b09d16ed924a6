// One pair of shapes answered by the special pair for its kinds, where there is one.
//
// Guarantee: no answer for a pair that no entry of the list takes, or that an entry declines: compounds, curved shapes,
// rotations that are not of unit length. The bits are those of the same pair in a batch.
#pragma once

#include <optional>

#include "graze/plane/query.hpp"

namespace graze::plane {

template <class T>
std::optional<bool> special_overlap(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                    const Pose2<T>& pose_b);

/// Writes the distance and returns whether a special pair answers.
template <class T>
bool special_distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                      Distance<T>& out);

/// Appends the manifold, if the shapes are within `margin`, and returns whether they overlap; nothing where no special
/// pair answers.
template <class T>
std::optional<bool> special_contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                     const Pose2<T>& pose_b, T margin, Manifolds<T>& manifolds);

}  // namespace graze::plane
