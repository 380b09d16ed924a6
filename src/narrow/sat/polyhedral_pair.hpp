// Two flat-sided shapes, in the frame of A: their separating axes, and the faces that meet along one.
//
// Two boxes take the fifteen-axis test; two small polyhedra in float, of which one at least is a hull, the test on
// lanes; every other pair of box, rectangle, triangle and hull with few edges the general one. All have the same
// interface, so that code that uses them is written once.
#pragma once

#include <optional>
#include <vector>

#include "narrow/core/faceted_shape.hpp"
#include "narrow/general.hpp"
#include "narrow/manifold/contact_side.hpp"
#include "narrow/pairs/box_box/sat.hpp"
#include "narrow/sat/separating_axes.hpp"

namespace graze {

/// An axis, and the intervals that two cores take on it.
struct AxisIntervals {
  SeparatingAxis axis;
  double a_lower, a_upper, b_lower, b_upper;
};

/// Whether separating axes are used for these two shapes: both are flat-sided, with so few edges that trying their
/// products costs no more than EPA.
template <class T>
bool has_separating_axes(const Shape<T>& a, const Shape<T>& b);

/// The two shapes as boxes, if they are.
template <class T>
std::optional<BoxPair<double>> as_boxes(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a);

/// The face of a box that leans least from a direction given in the box's own frame; with zero length along one of its
/// sides an edge, along both a corner. `Side::face` would round the direction to the shapes' scalar first, which may
/// choose another face of a box in float that meets along an edge.
PlacedFace box_face(const Vec3d& half, const Vec3d& direction);

template <class T>
class PolyhedralPair {
 public:
  /// Takes two shapes that have separating axes, which must outlive this object.
  PolyhedralPair(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a);

  /// All axes that may be the best, or fewer where one separates the cores by more than `enough`; nothing where EPA is
  /// faster.
  std::optional<SeparatingAxes> axes(double enough) const;
  /// All axes, whichever way the depth is found.
  SeparatingAxes all_axes() const;
  /// Every axis with the intervals of both cores on it, in the frame of A, for an explanation.
  std::vector<AxisIntervals> intervals() const;
  std::string name(const SeparatingAxis& axis) const;
  /// The face of A that meets B along `normal` (from A to B), and that of B; each takes its shape's side.
  PlacedFace face_a(const Side<T>& side, const Vec3d& normal) const;
  PlacedFace face_b(const Side<T>& side, const Vec3d& normal) const;

 private:
  void set_polyhedra(Polyhedron& a, Polyhedron& b) const;

  const Shape<T>&shape_a_, &shape_b_;
  Posed b_in_a_;
  std::optional<BoxPair<double>> boxes_;
  std::optional<FacetedShape> facets_a_, facets_b_;  ///< where both have facets
  std::optional<Polyhedron> a_, b_;                  ///< for all other pairs
};

}  // namespace graze
