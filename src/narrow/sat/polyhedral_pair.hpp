// Two shapes with flat sides, in the frame of A: their separating axes, and the faces that meet along one.
//
// Two boxes take the fifteen-axis test; two small polyhedra in float, of which one at least is a hull, the test on
// lanes; every other pair of box, rectangle, triangle and hull that has few edges the general one. All answer the same
// questions, so what is built on them is written once.
#pragma once

#include <optional>
#include <vector>

#include "graze/trace.hpp"
#include "narrow/core/faceted_shape.hpp"
#include "narrow/general.hpp"
#include "narrow/manifold/contact_side.hpp"
#include "narrow/pairs/box_box/sat.hpp"
#include "narrow/sat/separating_axes.hpp"

namespace graze {

/// Whether the separating axes answer for these two shapes: both have flat sides, and so few edges that trying their
/// products costs no more than what finds the depth otherwise (EPA).
template <class T>
bool has_separating_axes(const Shape<T>& a, const Shape<T>& b);

/// The two as boxes, if they are.
template <class T>
std::optional<BoxPair<double>> as_boxes(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a);

/// The face of a box that leans least from a direction given in the box's own frame; without length along one of its
/// sides, an edge, along both a corner.
PlacedFace box_face(const Vec3d& half, const Vec3d& direction);

template <class T>
class PolyhedralPair {
 public:
  /// Two shapes that have separating axes, and outlive this.
  PolyhedralPair(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a);

  /// All axes that may be the best, or fewer where one is found that separates the cores by more than `enough`; nothing
  /// where the depth is sooner found otherwise.
  std::optional<SeparatingAxes> axes(double enough) const;
  /// All axes, whichever way the depth is found.
  SeparatingAxes all_axes() const;
  /// Every axis with the intervals of both cores on it, in the frame of A, for an explanation.
  std::vector<TraceAxis> intervals() const;
  std::string name(const SeparatingAxis& axis) const;
  /// The face of each that meets the other along `normal` (from A to B); each has its side.
  PlacedFace face_a(const Side<T>& side, const Vec3d& normal) const;
  PlacedFace face_b(const Side<T>& side, const Vec3d& normal) const;

 private:
  void set_polyhedra(Polyhedron& a, Polyhedron& b) const;

  const Shape<T>&shape_a_, &shape_b_;
  Posed b_in_a_;
  std::optional<BoxPair<double>> boxes_;
  std::optional<FacetedShape> facets_a_, facets_b_;  ///< of two such
  std::optional<Polyhedron> a_, b_;                  ///< of what is neither
};

}  // namespace graze
