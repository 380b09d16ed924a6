// Bumpy ground for tests: the same heights as a height field, or as the triangles of a mesh.
#pragma once

#include <vector>

#include "common/specimen.hpp"
#include "graze/shape.hpp"

namespace graze::testing {

/// `side` times `side` heights of up to `rough`, up and down, a `cell` apart.
template <class T>
struct HeightGrid {
  std::uint32_t side;
  T cell;
  std::vector<T> heights;

  HeightGrid(std::uint32_t corners, float width, float rough, Random& random)
      : side(corners), cell(static_cast<T>(width)), heights(corners * corners) {
    for (T& h : heights) h = static_cast<T>(uniform(random, -rough, rough));
  }

  Shape<T> field(Sides sides = Sides::both) const { return HeightField<T>(side, side, heights, cell, cell, sides); }
  /// The corners, the middle one about the origin.
  std::vector<Vec3<T>> points() const {
    std::vector<Vec3<T>> out;
    for (std::uint32_t i = 0; i < heights.size(); ++i) out.push_back({place(i % side), heights[i], place(i / side)});
    return out;
  }
  /// Two for each cell, seen from above.
  std::vector<typename Mesh<T>::Index> triangles() const {
    std::vector<typename Mesh<T>::Index> out;
    for (std::uint32_t i = 0; i < heights.size(); ++i) {
      if (i % side + 1 == side || i / side + 1 == side) continue;
      out.push_back({i, i + side, i + 1});
      out.push_back({i + 1, i + side, i + side + 1});
    }
    return out;
  }

 private:
  T place(std::uint32_t number) const { return (static_cast<T>(number) - static_cast<T>(side / 2)) * cell; }
};

}  // namespace graze::testing
