// The data of a mesh.
//
// Guarantee: indices are in range; the tree covers every triangle, but for those that repeat another.
#pragma once

#include "graze/shape/mesh.hpp"
#include "shape/packed_leaf.hpp"
#include "shape/triangles_across.hpp"
#include "shape/wide_tree.hpp"

namespace graze {

template <class T>
struct MeshData {
  using Scalar = T;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  WideTree<T> tree;
  std::vector<PackedLeaf> leaves;  ///< of the tree, in the order of `TreeNode::first_leaf`
  T extent = T(0);                 ///< the greatest distance of a point from the frame's origin
  T longest = T(0);                ///< side of all triangles
  double radius = 0;               ///< of a ball about the centre of the bounds, as rounded, that holds all of them
  bool closed = false;             ///< bounds a solid
  bool outward = false;            ///< closed, and its fronts lead out of it: its volume is positive
  std::vector<bool> level;         ///< of each triangle: lies level with all around it
  std::vector<TrianglesAcross> neighbours;  ///< of each triangle
  Sides sides = Sides::both;
  bool solid = false;                  ///< its inside counts; then it is closed
  std::vector<std::uint32_t> islands;  ///< a point, by number, of each connected part

  const WideTree<T>& hierarchy() const { return tree; }
  const TrianglesAcross& across(std::uint32_t number) const { return neighbours[number]; }
  bool lies_level(std::uint32_t number) const { return level[number]; }
  /// Bytes that are kept.
  std::size_t memory() const {
    const auto of = [](const auto& list) { return list.size() * sizeof list[0]; };
    return sizeof *this + of(points) + of(triangles) + tree.memory() + of(leaves) + level.size() / 8 + of(neighbours) +
           of(islands);
  }
  std::array<Vec3<T>, 3> triangle(std::uint32_t number) const {
    const auto& t = triangles[number];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }
};

/// The radius of a ball that holds a box, about its rounded centre, and a little more.
template <class T>
double ball_radius(const Aabb<T>& box) {
  constexpr double epsilon = std::numeric_limits<T>::epsilon();
  const Vec3d lower = converted<double>(box.lower), upper = converted<double>(box.upper);
  return length(upper - lower) * 0.5005 + 2 * epsilon * greatest(max_abs(lower), max_abs(upper));
}

template <class T>
Aabb<T> bounds_of(const std::array<Vec3<T>, 3>& corners) {
  return {least(corners[0], least(corners[1], corners[2])), greatest(corners[0], greatest(corners[1], corners[2]))};
}

}  // namespace graze
