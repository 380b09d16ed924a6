// Triangle meshes: surfaces without thickness, of which both sides count by default, or solids.
//
// Guarantee: any finite triangles, degenerate ones included; indices are checked once, by the constructor. Shared and
// immutable, with a tree of bounds over the triangles, so that copies are cheap and queries from any thread safe. A
// triangle that repeats another, with the same corners in the same turn, counts once: answers name the first.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/detail/lent.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/sides.hpp"

namespace graze {

template <class T>
struct MeshData;

/// A triangle mesh: a surface, or a solid if it is closed and made one.
template <class T>
class GRAZE_API Mesh {
 public:
  static constexpr const char* name = "mesh";
  using Index = std::array<std::uint32_t, 3>;  ///< three indices of points

  /// A mesh whose `triangles` index `points`, counter-clockwise seen from outside. Cost n log n, half a second for a
  /// million triangles. In float a connected surface keeps some 60 bytes for each triangle, points and triangles
  /// included (`memory`). A `solid` mesh is a body and not a surface: shapes wholly inside it touch it. Throws
  /// `InvalidValue`, also for a solid that is not `closed`.
  Mesh(std::vector<Vec3<T>> points, std::vector<Index> triangles, Sides sides = Sides::both, bool solid = false);
  Mesh(const Mesh& lender, Lent) : data_(std::shared_ptr<void>(), lender.data_.get()) {}

  std::span<const Vec3<T>> points() const;   ///< the points
  std::span<const Index> triangles() const;  ///< the triangles, counter-clockwise seen from their front
  /// Whether the triangles bound a solid: each edge, by its indices, is shared by two that run through it in opposite
  /// directions. A closed mesh has a mass, and an inside for `closest`; for all other queries it has an inside if it is
  /// made `solid`.
  bool closed() const;
  Sides sides() const;  ///< sides that push
  /// Whether the inside belongs to the mesh: for `overlap`, `distance`, `contacts`, casts and rays.
  bool solid() const;
  std::size_t memory() const;  ///< bytes that it keeps, those of points and triangles included
  /// The data that copies of the shape share.
  const MeshData<T>& data() const { return *data_; }

  T core_extent() const;
  /// The bounds under a pose. For a turned mesh of more than 256 triangles up to 1/128 of its size too wide on each
  /// side.
  Aabb<T> core_bounds(const Pose<T>& pose) const;

 private:
  std::shared_ptr<const MeshData<T>> data_;
};

}  // namespace graze
