// What is found in a mesh: against counts known by hand, against a look at every corner, and in any order of its parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "common/specimen.hpp"
#include "graze/shape/mesh_findings.hpp"

namespace graze::testing {
namespace {

template <class T>
struct Parts {
  std::vector<Vec3<T>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  MeshFindings found() const { return findings(Mesh<T>(points, triangles)); }
};

template <class T>
Parts<T> cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

/// Every triangle with corners of its own, as an STL file has them.
template <class T>
Parts<T> soup(const Parts<T>& parts) {
  Parts<T> out;
  for (const auto& t : parts.triangles) {
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (const std::uint32_t i : t) out.points.push_back(parts.points[i]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

template <class T>
Parts<T> shuffled(const Parts<T>& parts, Random& random) {
  std::vector<std::uint32_t> place(parts.points.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  Parts<T> out{std::vector<Vec3<T>>(parts.points.size()), parts.triangles};
  for (std::size_t i = 0; i < place.size(); ++i) out.points[place[i]] = parts.points[i];
  for (auto& t : out.triangles) {
    for (std::uint32_t& i : t) i = place[i];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  std::shuffle(out.triangles.begin(), out.triangles.end(), random);
  return out;
}

void expect_same(const MeshFindings& a, const MeshFindings& b) {
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.repeated_triangles, b.repeated_triangles);
  EXPECT_EQ(a.without_area, b.without_area);
  EXPECT_EQ(a.slivers, b.slivers);
  EXPECT_EQ(a.flat_edges, b.flat_edges);
  EXPECT_EQ(a.convex_edges, b.convex_edges);
  EXPECT_EQ(a.concave_edges, b.concave_edges);
  EXPECT_EQ(a.open_edges, b.open_edges);
  EXPECT_EQ(a.irregular_edges, b.irregular_edges);
  EXPECT_EQ(a.t_junctions, b.t_junctions);
}

template <class T>
class MeshFinding : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MeshFinding, Scalars);

TYPED_TEST(MeshFinding, CubeHasTwelveRidges) {
  const MeshFindings found = cube<TypeParam>().found();
  EXPECT_EQ(found.triangles, 12u);
  EXPECT_EQ(found.convex_edges, 12u);
  EXPECT_EQ(found.flat_edges, 6u);
  EXPECT_EQ(found.edges(), 18u);  // Euler: three halves of the triangles
  EXPECT_EQ(found.repeated_points + found.slivers + found.without_area + found.t_junctions, 0u);
}

TYPED_TEST(MeshFinding, TurnedInsideOutRidgesAreValleys) {
  Parts<TypeParam> parts = cube<TypeParam>();
  for (auto& t : parts.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(parts.found().concave_edges, 12u);
  EXPECT_EQ(parts.found().convex_edges, 0u);
}

TYPED_TEST(MeshFinding, HoleHasAnOpenRim) {
  Parts<TypeParam> parts = cube<TypeParam>();
  parts.triangles.pop_back();
  EXPECT_EQ(parts.found().open_edges, 3u);
  EXPECT_EQ(parts.found().t_junctions, 0u);  // corners at the rim's ends are none
}

TYPED_TEST(MeshFinding, CornersAreToldByPlace) {
  const MeshFindings found = soup(cube<TypeParam>()).found();
  EXPECT_EQ(found.repeated_points, 28u);
  EXPECT_EQ(found.convex_edges, 12u);
  EXPECT_EQ(found.open_edges, 0u);
}

TYPED_TEST(MeshFinding, TrianglesThatAreNone) {
  Parts<TypeParam> parts = cube<TypeParam>();
  parts.triangles.push_back({2, 1, 0});  // as the first, begun elsewhere
  parts.triangles.push_back({0, 0, 6});
  parts.points.push_back({TypeParam(0.5), TypeParam(-1e-4), TypeParam(0)});
  parts.triangles.push_back({0, 1, 8});
  const MeshFindings found = parts.found();
  EXPECT_EQ(found.triangles, 15u);
  EXPECT_EQ(found.repeated_triangles, 1u);
  EXPECT_EQ(found.without_area, 1u);
  EXPECT_EQ(found.slivers, 1u);
}

TYPED_TEST(MeshFinding, ThreeAtAnEdgeAndTwoInOneDirection) {
  using T = TypeParam;
  const std::vector<Vec3<T>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
  const MeshFindings three = Parts<T>{points, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}}.found();
  EXPECT_EQ(three.irregular_edges, 1u);
  EXPECT_EQ(three.open_edges, 6u);
  const MeshFindings turned = Parts<T>{points, {{0, 1, 2}, {0, 1, 3}}}.found();
  EXPECT_EQ(turned.irregular_edges, 1u);
}

// One long edge meets two short ones: a T-junction, here and a kilometre off, in the coordinates' own rounding.
TYPED_TEST(MeshFinding, TJunctionIsACornerInsideAnOpenEdge) {
  using T = TypeParam;
  for (const T off : {T(0), T(1000)}) {
    const auto at = [&](T x, T y) { return Vec3<T>{off + x, y, x / T(3) + y / T(7)}; };
    const Parts<T> parts{{at(0, 0), at(3, 1), at(1, 3), at(2, 2), at(4, 4)}, {{0, 1, 2}, {1, 4, 3}, {3, 4, 2}}};
    const MeshFindings found = parts.found();
    EXPECT_EQ(found.t_junctions, 1u) << off;
    EXPECT_EQ(found.open_edges, 7u) << off;
    EXPECT_EQ(found.flat_edges, 1u) << off;
  }
}

/// A grid of cells of which some are cut in four: T-junctions wherever a cut cell lies beside a whole one.
template <class T>
Parts<T> refined_grid(Random& random, std::uint32_t cells, std::vector<bool>& cut) {
  Parts<T> out;
  const std::uint32_t row = 2 * cells + 1;
  for (std::uint32_t y = 0; y < row; ++y)
    for (std::uint32_t x = 0; x < row; ++x) out.points.push_back({T(x), T(y), T(0)});
  const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t size) {
    const std::uint32_t a = y * row + x, b = a + size, c = a + size * row, d = c + size;
    out.triangles.push_back({a, b, d});
    out.triangles.push_back({a, d, c});
  };
  cut.assign(cells * cells, false);
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      cut[y * cells + x] = random() % 2 == 0;
      if (!cut[y * cells + x])
        add(2 * x, 2 * y, 2);
      else
        for (const std::uint32_t i : {0u, 1u})
          for (const std::uint32_t j : {0u, 1u}) add(2 * x + i, 2 * y + j, 1);
    }
  return out;
}

TYPED_TEST(MeshFinding, TJunctionsOfARefinedGrid) {
  Random random(23);
  constexpr std::uint32_t cells = 24;
  std::vector<bool> cut;
  const Parts<TypeParam> parts = refined_grid<TypeParam>(random, cells, cut);
  std::size_t expected = 0;
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      if (x + 1 < cells) expected += cut[y * cells + x] != cut[y * cells + x + 1] ? 1 : 0;
      if (y + 1 < cells) expected += cut[y * cells + x] != cut[(y + 1) * cells + x] ? 1 : 0;
    }
  ASSERT_GT(expected, cells);
  EXPECT_EQ(parts.found().t_junctions, expected);
  EXPECT_EQ(parts.found().convex_edges + parts.found().concave_edges, 0u);
}

TYPED_TEST(MeshFinding, NoOrderOfPartsMatters) {
  Random random(29);
  std::vector<bool> cut;
  for (int repeat = 0; repeat < 20; ++repeat) {
    Parts<TypeParam> parts = refined_grid<TypeParam>(random, 6, cut);
    for (Vec3<TypeParam>& p : parts.points) p.z = TypeParam(random() % 4) / TypeParam(2);
    const MeshFindings found = parts.found();
    expect_same(shuffled(parts, random).found(), found);
    expect_same(shuffled(soup(parts), random).found(), found);
  }
}

}  // namespace
}  // namespace graze::testing
