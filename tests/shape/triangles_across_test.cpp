// The triangle beyond each edge of a mesh or height field, against a look at all pairs of triangles.
#include "shape/triangles_across.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/specimen.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

/// The corners of a triangle by number, in the order in which its edges are counted.
using CornerNumbers = std::array<std::uint32_t, 3>;

bool has_edge(const CornerNumbers& t, std::uint32_t from, std::uint32_t to) {
  for (std::size_t i = 0; i < 3; ++i)
    if ((t[i] == from && t[(i + 1) % 3] == to) || (t[i] == to && t[(i + 1) % 3] == from)) return true;
  return false;
}

/// Triangles that can be told to be beyond an edge of triangle `number`: all others that have it.
std::vector<std::uint32_t> beyond(const std::vector<CornerNumbers>& all, std::uint32_t number, std::size_t edge) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < all.size(); ++i)
    if (i != number && has_edge(all[i], all[number][edge], all[number][(edge + 1) % 3])) found.push_back(i);
  return found;
}

/// Some triangles of a grid of points, in any turn and order, and some between points anywhere.
std::vector<CornerNumbers> irregular_triangles(std::uint32_t side, Random& random) {
  std::vector<CornerNumbers> triangles;
  for (std::uint32_t i = 0; i + side + 1 < side * side; ++i) {
    if (i % side + 1 == side) continue;
    if (random() % 8 != 0) triangles.push_back({i, i + side, i + 1});
    if (random() % 8 != 0) triangles.push_back({i + 1, i + side, i + side + 1});
    if (random() % 8 == 0) triangles.push_back({i, i + 1, static_cast<std::uint32_t>(random() % (side * side))});
  }
  for (CornerNumbers& t : triangles) {
    if (random() % 4 == 0) std::swap(t[0], t[1]);
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return triangles;
}

TEST(TrianglesAcross, OfAMeshAreThoseThatHaveTheEdge) {
  Random random(3);
  std::size_t shared = 0, rims = 0, fans = 0;
  for (int round = 0; round < 40; ++round) {
    const std::uint32_t side = 5;
    std::vector<Vec3f> points;
    for (std::uint32_t i = 0; i < side * side; ++i)
      points.push_back({static_cast<float>(i % side), uniform(random, -1, 1), static_cast<float>(i / side)});
    const std::vector<CornerNumbers> triangles = irregular_triangles(side, random);
    const Mesh<float> mesh(points, triangles);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const CornerNumbers& t = triangles[i];
        const bool repeats = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
        std::vector<std::uint32_t> others = beyond(triangles, i, edge);
        std::erase_if(others, [&](std::uint32_t k) {
          const CornerNumbers& u = triangles[k];
          return u[0] == u[1] || u[1] == u[2] || u[2] == u[0];
        });
        const std::uint32_t told = mesh.data().across(i)[edge];
        if (repeats || others.empty()) {
          EXPECT_EQ(told, no_triangle);
          ++rims;
          continue;
        }
        EXPECT_EQ(std::count(others.begin(), others.end(), told), 1) << "triangle " << i << ", edge " << edge;
        ++(others.size() == 1 ? shared : fans);
      }
  }
  EXPECT_GT(shared, 1000u);
  EXPECT_GT(rims, 100u);
  EXPECT_GT(fans, 100u);
}

TEST(TrianglesAcross, OfAHeightFieldAreThoseThatHaveTheEdge) {
  Random random(4);
  for (const auto& [columns, rows] : {std::pair{2u, 2u}, {2u, 5u}, {5u, 2u}, {6u, 5u}}) {
    std::vector<float> heights(columns * rows);
    for (float& h : heights) h = uniform(random, -1, 1);
    std::vector<std::uint8_t> holes(heights.size(), 0);  // each takes the cells around it away
    for (std::uint8_t& hole : holes) hole = holes.size() > 10 && random() % 8 == 0 ? 1 : 0;
    const HeightField<float> field(columns, rows, heights, holes);
    const HeightFieldData<float>& data = field.data();
    const auto is_hole = [&, c = columns](std::uint32_t triangle) {
      const std::uint32_t at = triangle / 2 / (c - 1) * c + triangle / 2 % (c - 1);
      return (holes[at] | holes[at + 1] | holes[at + c] | holes[at + c + 1]) != 0;
    };
    const auto number_of = [&, c = columns, r = rows](const Vec3f& p) {
      return static_cast<std::uint32_t>(std::lround(p.z + static_cast<float>(r - 1) / 2)) * c +
             static_cast<std::uint32_t>(std::lround(p.x + static_cast<float>(c - 1) / 2));
    };
    std::vector<CornerNumbers> triangles;
    for (std::uint32_t i = 0; i < data.size(); ++i) {
      const std::array<Vec3f, 3> corners = data.triangle(i);
      triangles.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for (std::size_t edge = 0; edge < 3; ++edge) {
        if (is_hole(i)) continue;
        std::vector<std::uint32_t> others = beyond(triangles, i, edge);
        std::erase_if(others, is_hole);
        ASSERT_LE(others.size(), 1u);
        EXPECT_EQ(data.across(i)[edge], others.empty() ? no_triangle : others[0]) << "triangle " << i << ", " << edge;
      }
  }
}

}  // namespace
}  // namespace graze
