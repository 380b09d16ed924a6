// A bowl of triangles.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "graze/shape/mesh.hpp"

namespace graze::bench {

/// The inside of the lower half of a sphere about the origin: rings of flat triangles, counterclockwise seen from
/// inside.
struct Bowl {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> indices;  ///< three a triangle

  template <class T>
  Mesh<T> mesh() const {
    std::vector<Vec3<T>> converted_points;
    for (const Vec3d& p : points) converted_points.push_back(converted<T>(p));
    std::vector<typename Mesh<T>::Index> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3)
      triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    return Mesh<T>(std::move(converted_points), std::move(triangles));
  }
};
Bowl bowl_of(double radius);

}  // namespace graze::bench
