// Box against triangle by separating axes: three of the box, the triangle's normal and those of its sides in its plane,
// and the nine products of their edges (Akenine-Möller 2001, "Fast 3D triangle-box overlap testing", Journal of Graphics
// Tools).
//
// Guarantee: the axes and faces that the two have as polyhedra, but for products of edges that are no facet of their
// difference: of those the separation is no larger than the distance, and than that of the best facet when they overlap.
#pragma once

#include "narrow/polyhedral_pair.hpp"

namespace graze {

class BoxTriangle {
 public:
  /// A triangle that is no sliver, seen from the box.
  template <class T>
  BoxTriangle(const Box<T>& box, const Triangle<T>& triangle, const Posed& b_in_a)
      : half_(cast<double>(box.half_extents())) {
    const Mat3d rotation = rotation_matrix(b_in_a.rotation);
    for (std::size_t i = 0; i < 3; ++i) p_[i] = rotation * cast<double>(triangle.point(i)) + b_in_a.translation;
    normal_ = unit(cross(p_[1] - p_[0], p_[2] - p_[0]));
  }

  /// As `PolyhedralPair`.
  SeparatingAxes axes(double enough) const;
  PlacedFace face_a(const Vec3d& normal) const { return box_face(half_, normal); }
  PlacedFace face_b(const Vec3d& normal) const;

 private:
  void look_from_box(SeparatingAxis& best) const;
  void look_from_triangle(SeparatingAxis& best) const;
  void look_along_edges(double least_gain, SeparatingAxis& best) const;
  double reach(const Vec3d& direction) const { return dot(abs(direction), half_); }

  Vec3d half_, p_[3], normal_;
};

}  // namespace graze
