// The triangles of a mesh around what touches it, found once for all contacts there.
//
// Guarantee: a patch that was filled holds every triangle whose bounds meet the region that it covers, in the order in
// which the tree tells them. No allocation.
#pragma once

#include "composite/internal_edges/leaf_in_context.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

/// The largest distance of a triangle's bounds from a point that lies on it. `noise`: the error of its coordinates.
template <class T>
T reach_on(const MeshData<T>& mesh, T noise) {
  return on_piece<T> * T(1.01) * (mesh.longest + noise) + noise;  // one hundredth for what the reach itself adds
}

template <class T>
class MeshPatch {
 public:
  /// Takes the triangles that come within `distance` of the question's region, and so near to it that a point which
  /// does may lie on them; false where they are too many.
  bool fill(const Mesh<T>& mesh, const BoxQuestion<T>& question, T distance) {
    const MeshData<T>& data = mesh.data();
    mesh_ = &data;
    const T reach = distance + reach_on(data, T(0));
    covered_ = inflated(question.region, reach);
    // A triangle that meets the covered box is no further from the region than the corners of the box.
    const T diagonal = T(1.75) * reach;
    count_ = 0;
    return visit(
        data.tree, question, [&] { return diagonal; },
        [&](std::uint32_t number) {
          const Aabb<T> box = bounds_of(data.triangle(number));
          if (!overlap(box, covered_)) return true;
          if (count_ == most) return false;
          numbers_[count_] = number;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            lower_[count_][axis] = box.lower[axis];
            upper_[count_][axis] = box.upper[axis];
          }
          ++count_;
          return true;
        });
  }

  /// Calls `f(number)` for the triangles whose bounds `near` lets pass, until it returns false; returns whether it went
  /// to the end.
  template <class Near, class F>
  bool each(const Near& near, F&& f) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (near(box(i)) && !f(numbers_[i])) return false;
    return true;
  }
  bool covers(const MeshData<T>& mesh, const Aabb<T>& region) const {
    return &mesh == mesh_ && contains(covered_, region);
  }

 private:
  static constexpr std::size_t most = 96;

  Aabb<T> box(std::size_t i) const {
    return {{lower_[i][0], lower_[i][1], lower_[i][2]}, {upper_[i][0], upper_[i][1], upper_[i][2]}};
  }

  const MeshData<T>* mesh_ = nullptr;
  Aabb<T> covered_;
  std::uint32_t numbers_[most];
  T lower_[most][3], upper_[most][3];  ///< bounds; plain, so that none is cleared that is not used
  std::size_t count_ = 0;
};

}  // namespace graze
