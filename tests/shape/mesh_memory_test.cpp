// What a mesh keeps for each triangle, with all that is found when it is built.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/shape/mesh.hpp"

namespace graze::testing {
namespace {

using Index = Mesh<float>::Index;

double bytes_a_triangle(const Mesh<float>& mesh) {
  return static_cast<double>(mesh.memory()) / static_cast<double>(mesh.triangles().size());
}

/// Rows of points around an axis, or beside each other, joined by two triangles for each four.
Mesh<float> woven(std::uint32_t columns, std::uint32_t rows, bool around, auto&& place) {
  std::vector<Vec3<float>> points;
  std::vector<Index> triangles;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) points.push_back(converted<float>(Vec3d(place(i, j))));
  for (std::uint32_t j = 0; j + 1 < rows; ++j)
    for (std::uint32_t i = 0; i + (around ? 0u : 1u) < columns; ++i) {
      const std::uint32_t a = j * columns + i, b = j * columns + (i + 1) % columns, c = a + columns, d = b + columns;
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  return Mesh<float>(std::move(points), std::move(triangles));
}

TEST(MeshMemory, IsSomeSixtyBytesATriangleOfASurface) {
  for (const std::uint32_t n : {40u, 100u, 300u}) {
    const auto hill = [](std::uint32_t i, std::uint32_t j) { return Vec3d{i * 1.0, std::sin(i * 0.4) * 3, j * 1.0}; };
    const auto ball = [n](std::uint32_t i, std::uint32_t j) {
      const double around = std::numbers::pi * i / n, down = std::numbers::pi * (j + 0.5) / n;
      return Vec3d{std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
    };
    EXPECT_LT(bytes_a_triangle(woven(n, n, false, hill)), 62) << n;
    EXPECT_LT(bytes_a_triangle(woven(2 * n, n, true, ball)), 62) << n;
  }
}

// Copies share what is kept, and one triangle is no reason to reserve much.
TEST(MeshMemory, OfOneTriangleIsUnderAKilobyte) {
  const Mesh<float> one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_LT(one.memory(), 1024u);
}

}  // namespace
}  // namespace graze::testing
