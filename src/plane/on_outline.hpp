// Contacts of pieces along normals that belong to the outline.
//
// Guarantee: the normals that a piece of a polygon or a chain may have follow from the edges on both sides of its
// vertices: an edge of the outline has its own normal, a convex vertex those between the normals of its edges (its
// Voronoi region), a reflex one none, a cut none. No measure of closeness takes part but the rounding of the numbers
// at hand and, where a core is curved, the error of the normal that was searched for.
#pragma once

#include <optional>

#include "plane/nearest.hpp"

namespace graze::plane {

/// Whether the normal of nearest points, and the features that they lie on, belong to the outlines of both cores.
template <class T>
bool on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double size);

/// Whether a feature of a piece of a polygon, the one along `n` in its frame, is a cut.
template <class T>
bool on_cut(const Core<T>& core, std::uint32_t feature, const Vec2d& n);

/// The doubt whether such a normal belongs to the outlines: the error that it must have for that, zero where its
/// rounding is enough, and the error that it may have. Of polygons both are rounding.
struct Doubt {
  double taken = 0, possible = 0;
};
template <class T>
Doubt doubt(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double size);

/// Nearest points along a normal that belongs to the outlines.
struct OnOutline : Nearest {
  bool of_neighbour = false;  ///< whether the normal is that of an edge beside the piece of a polygon or a chain
  /// Whether the normal is that of an edge of A or B, a polygon or a piece of one, with the other core all behind it.
  bool behind_a = false, behind_b = false;
};

/// The axis of least overlap of two cores among the normals that belong to the outlines. The normals of edges beside
/// the pieces take part, so that a piece gives way where its neighbour is less deep. Nothing where the pieces have no
/// such axis.
template <class T>
std::optional<OnOutline> least_overlap_on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a);

/// The nearest points along normals that belong to the outlines: `found` where its normal does, the axis of least
/// overlap where cores overlap, and nothing where the contact is a neighbour's.
template <class T>
std::optional<OnOutline> nearest_on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                             const Nearest& found, double size);

/// The point of a polygon's outline that is nearest to a point inside the polygon or, as far as rounding tells, on its
/// outer side; `piece` is one piece of the polygon. All in its frame; the normal leads out. Cost: linear in the
/// vertices.
template <class T>
Nearest nearest_on_outline(const Core<T>& piece, const Vec2d& from, bool inside);

}  // namespace graze::plane
