// Triangles that a mesh knows to lie level with all around them, against the search among the neighbours.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/specimen.hpp"
#include "composite/height_grid.hpp"
#include "composite/internal_edges/voronoi_neighbours.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

template <class T>
class Level : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Level, Scalars);

/// A floor of 12 by 12 cells whose corners are moved about in the plane; some are lifted, some cells have corners of
/// their own, some are cut at a T-junction, some have a triangle without area on a side, some bear a small wall.
template <class T>
Mesh<T> rough_and_level(Random& random, bool spoilt) {
  constexpr std::uint32_t side = 12;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  const auto number = [&](float low, float high) { return static_cast<T>(uniform(random, low, high)); };
  for (std::uint32_t r = 0; r <= side; ++r)
    for (std::uint32_t c = 0; c <= side; ++c)
      points.push_back({T(c) + number(-0.2f, 0.2f), spoilt && random() % 20 == 0 ? number(-0.5f, 0.5f) : T(0),
                        T(r) + number(-0.2f, 0.2f)});
  for (std::uint32_t r = 0; r < side; ++r)
    for (std::uint32_t c = 0; c < side; ++c) {
      std::array<std::uint32_t, 4> p{r * (side + 1) + c, r * (side + 1) + c + 1, (r + 1) * (side + 1) + c + 1,
                                     (r + 1) * (side + 1) + c};
      const auto another = [&](const Vec3<T>& at) {
        points.push_back(at);
        return static_cast<std::uint32_t>(points.size() - 1);
      };
      const std::uint64_t kind = spoilt ? random() % 12 : 99;
      if (kind == 0)
        for (std::uint32_t& i : p) i = another(points[i]);
      if (kind == 1) {  // a T-junction
        const std::uint32_t middle = another((points[p[0]] + points[p[1]]) * T(0.5));
        triangles.insert(triangles.end(), {{p[0], p[3], middle}, {middle, p[3], p[2]}, {middle, p[2], p[1]}});
        continue;
      }
      triangles.push_back({p[0], p[2], p[1]});
      triangles.push_back({p[0], p[3], p[2]});
      if (kind == 2) triangles.push_back({p[0], p[1], p[1]});
      if (kind == 3) triangles.push_back({p[0], another((points[p[0]] + points[p[1]]) * T(0.5)), p[1]});
      if (kind == 4) triangles.push_back({p[0], p[1], another(points[p[0]] + Vec3<T>{0, 1, 0})});
    }
  return Mesh<T>(std::move(points), std::move(triangles));
}

/// On a level triangle, its edges and corners among the places, no normal but the face's is the surface's.
TYPED_TEST(Level, TrianglesHaveNeighboursThatRiseAboveAnyOtherNormal) {
  using T = TypeParam;
  Random random(5);
  std::size_t level = 0;
  for (int i = 0; i < 60; ++i) {
    const Shape<T> shape = rough_and_level<T>(random, i % 4 != 0);
    const T away = i % 2 == 0 ? T(0) : std::is_same_v<T, float> ? T(30) : T(1e5);
    const Pose<T> pose{{away, away, -away}, normalized(converted<T>(testing::random_rotation(random)))};
    const MeshData<T>& data = shape.template as<Mesh<T>>()->data();
    for (std::uint32_t t = 0; t < data.triangles.size(); ++t) {
      if (!data.level[t]) continue;
      ++level;
      const std::array<Vec3<T>, 3> c = data.triangle(t);
      const Shape<T> piece = Triangle<T>(c[0], c[1], c[2]);
      T u = static_cast<T>(uniform(random, 0, 1)), v = static_cast<T>(uniform(random, 0, 1)) * (T(1) - u);
      if (random() % 3 == 0) v = T(0);
      if (random() % 3 == 0) u = T(0);
      const Vec3<T> place = transform(pose, c[0] + (c[1] - c[0]) * u + (c[2] - c[0]) * v);
      const Vec3<T> up = rotate(pose.rotation, normalized(cross(c[1] - c[0], c[2] - c[0])));
      const Vec3<T> any = normalized(converted<T>(testing::random_vector(random, 1)));
      const Vec3<T> aside = normalized(any - up * dot(any, up));
      const Vec3<T> outward = normalized(up + aside * static_cast<T>(uniform(random, 0.02f, 3)));
      EXPECT_TRUE(neighbour_outside_region<T>({shape, pose, piece, pose}, place, outward))
          << "triangle " << t << " of mesh " << i;
    }
  }
  EXPECT_GT(level, 3000u);
}

/// All but what has a corner on the border; and none around a corner that is lifted or a cell with corners of its own.
TYPED_TEST(Level, TrianglesAreThoseThatTheSurfaceGoesOnAround) {
  using T = TypeParam;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (int i = 0; i < 49; ++i) points.push_back({T(i % 7), T(0), T(i / 7)});
  for (std::uint32_t i = 0; i < 42; ++i)
    if (i % 7 != 6) triangles.insert(triangles.end(), {{i, i + 8, i + 1}, {i, i + 7, i + 8}});
  const auto count = [](const Mesh<T>& mesh) {
    return std::count(mesh.data().level.begin(), mesh.data().level.end(), true);
  };
  EXPECT_EQ(count(Mesh<T>(points, triangles)), 2 * 4 * 4);
  std::vector<Vec3<T>> lifted = points;
  lifted[24].y = T(0.01);  // the middle: it and the six around it are corners of what is not level
  EXPECT_EQ(count(Mesh<T>(lifted, triangles)), 8);
  auto split = triangles;
  const auto n = static_cast<std::uint32_t>(points.size());
  points.push_back(points[24]);
  split[36][0] = n;  // one triangle at the middle has that corner to itself
  EXPECT_LT(count(Mesh<T>(points, split)), 2 * 4 * 4);
}

/// Those of a height field are level where the triangles of the nine cells about them have one normal: on slopes, about
/// corners that are lifted and holes, and at the border.
TYPED_TEST(Level, TrianglesOfHeightFieldsAreThoseWhoseNineCellsHaveOneNormal) {
  using T = TypeParam;
  Random random(6);
  std::size_t level = 0;
  for (int i = 0; i < 40; ++i) {
    testing::HeightGrid<T> grid(14, 0.25f, 0, random);
    // Steps of a power of two along x and z, whose sums are exact.
    const T slope_x = T(0.0625) * T(i % 3), slope_z = T(-0.125) * T(i % 2);
    for (std::size_t k = 0; k < grid.heights.size(); ++k) {
      grid.heights[k] = slope_x * T(k % grid.side) + slope_z * T(k / grid.side);
      if (random() % 30 == 0) grid.heights[k] += static_cast<T>(uniform(random, 0.001f, 1));
      if (random() % 60 == 0) grid.heights[k] = std::numeric_limits<T>::quiet_NaN();
    }
    const Shape<T> shape = grid.field();
    const HeightFieldData<T>& field = shape.template as<HeightField<T>>()->data();
    const std::uint32_t cells = grid.side - 1;
    const auto normal_of = [&](std::uint32_t t) {
      const std::array<Vec3<T>, 3> c = field.triangle(t);
      return normalized(cross(c[1] - c[0], c[2] - c[0]));
    };
    const auto one_normal_about = [&](std::uint32_t t) {
      const std::uint32_t column = t / 2 % cells, row = t / 2 / cells;
      if (column == 0 || row == 0 || column + 1 == cells || row + 1 == cells) return false;
      for (std::uint32_t k = 0; k < 9; ++k) {
        const std::uint32_t c = column + k % 3 - 1, r = row + k / 3 - 1;
        const auto heights = field.cell(c, r);
        if (!(heights.low <= heights.high)) return false;
        for (const std::uint32_t other : {2 * (r * cells + c), 2 * (r * cells + c) + 1})
          if (!(length(normal_of(other) - normal_of(t)) < T(1e-5))) return false;
      }
      return true;
    };
    for (std::uint32_t t = 0; t < field.size(); ++t) {
      EXPECT_EQ(field.lies_level(t), one_normal_about(t)) << "triangle " << t << " of field " << i;
      level += field.lies_level(t) ? 1 : 0;
    }
  }
  EXPECT_GT(level, 1000u);
}

}  // namespace
}  // namespace graze
