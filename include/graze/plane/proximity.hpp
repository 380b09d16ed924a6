// Whether shapes of the plane are near each other, for those who need not know how far apart others are.
//
// Guarantee: as `graze/plane/query.hpp`, to the last bit of `distance`. Of compounds, polygons and chains the cost is
// that of what lies within the limit: pieces further away are not looked at.
#pragma once

#include <optional>
#include <vector>

#include "graze/plane/query.hpp"

namespace graze::plane {

/// A convex piece of A and one of B, and how far apart they are.
template <class T>
struct PieceDistance {
  /// The child of the outermost compound, the piece of a polygon or the segment of a chain, else 0.
  std::uint32_t piece_a = 0, piece_b = 0;
  Distance<T> distance{};  ///< between the two pieces
};

/// Whether the shapes are no further apart than `limit` >= 0: distance <= limit. Ends at the first pair of pieces that
/// is.
template <class T>
GRAZE_API bool within(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T limit);

/// The signed distance of shapes that are no further apart than `limit` >= 0, the same bits as `distance`; nothing for
/// those that are.
template <class T>
GRAZE_API std::optional<Distance<T>> distance_up_to(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                                    const Pose2<T>& pose_b, T limit);

/// Appends every pair of convex pieces that is no further apart than `margin` >= 0, with its distance, in the order of
/// the pieces; of two convex shapes there is one pair. The depth of a piece of a solid polygon is that of its way out
/// through the outline.
template <class T>
GRAZE_API void near_pieces(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                           T margin, std::vector<PieceDistance<T>>& pieces);

}  // namespace graze::plane
