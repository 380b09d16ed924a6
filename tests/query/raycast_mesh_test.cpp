// Rays at meshes: none slips between triangles, whatever is aimed at; the answer is that of testing every triangle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

using Index = Mesh<double>::Index;

template <class T>
struct Surface {
  std::vector<Vec3<T>> points;
  std::vector<Index> triangles;
  Vec3<T> inside;  ///< a point well within
  bool convex;
};

/// By the solid angle of all triangles (van Oosterom, Strackee 1983), with no ray in it.
template <class T>
bool holds(const Surface<T>& s, const Vec3<T>& point) {
  double whole = 0;
  for (const Index& t : s.triangles) {
    Vec3d p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = normalized(converted<double>(s.points[t[i]]) - converted<double>(point));
    whole += 2 * std::atan2(dot(p[0], cross(p[1], p[2])), 1 + dot(p[0], p[1]) + dot(p[1], p[2]) + dot(p[2], p[0]));
  }
  return std::abs(whole) > 6.283185307179586;
}

/// An icosahedron, its faces split in four `times` times, on the unit sphere.
template <class T>
Surface<T> icosphere(int times) {
  const T g = static_cast<T>(0.5 + std::sqrt(1.25));
  Surface<T> s{{{-1, g, 0},
                {1, g, 0},
                {-1, -g, 0},
                {1, -g, 0},
                {0, -1, g},
                {0, 1, g},
                {0, -1, -g},
                {0, 1, -g},
                {g, 0, -1},
                {g, 0, 1},
                {-g, 0, -1},
                {-g, 0, 1}},
               {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
               {},
               true};
  for (Vec3<T>& p : s.points) p = normalized(p);
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.points.size()));
      if (fresh) s.points.push_back(normalized(s.points[a] + s.points[b]));
      return place->second;
    };
    std::vector<Index> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangles = finer;
  }
  return s;
}

template <class T>
Surface<T> cuboid() {
  Surface<T> s{{}, {}, {}, true};
  for (int i = 0; i < 8; ++i) s.points.push_back({T(i & 1 ? 1 : -1), T(i & 2 ? 0.5 : -0.5), T(i & 4 ? 0.25 : -0.25)});
  for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({a, c, d});
  }
  return s;
}

/// Major radius 1, minor radius 0.3, made of long thin triangles.
template <class T>
Surface<T> torus(std::uint32_t around, std::uint32_t across) {
  Surface<T> s{{}, {}, {T(1), T(0), T(0)}, false};
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = 6.283185307179586 * i / around, v = 6.283185307179586 * k / across;
      const double rho = 1 + 0.3 * std::cos(v);
      s.points.push_back(converted<T>(Vec3d{rho * std::cos(u), 0.3 * std::sin(v), rho * std::sin(u)}));
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return (a % around) * across + b % across; };
      s.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      s.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  return s;
}

template <class T>
std::vector<Surface<T>> closed_surfaces() {
  return {icosphere<T>(0), icosphere<T>(3), cuboid<T>(), torus<T>(7, 5), torus<T>(90, 6)};
}

/// The same triangles in another order, each begun at another corner.
template <class T>
Surface<T> shuffled(Surface<T> s, Random& random) {
  for (std::size_t i = s.triangles.size(); i > 1; --i) std::swap(s.triangles[i - 1], s.triangles[random() % i]);
  for (Index& t : s.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  return s;
}

std::uint64_t rays_wanted() {
  const char* more = std::getenv("GRAZE_TEST_RAYS");
  return more ? std::strtoull(more, nullptr, 10) : 200'000;
}

/// A point of an edge; of a vertex one time in three.
template <class T>
Vec3<T> on_an_edge(const Surface<T>& s, Random& random) {
  const Index& t = s.triangles[random() % s.triangles.size()];
  const std::size_t k = random() % 3;
  const Vec3<T> a = s.points[t[k]], b = s.points[t[(k + 1) % 3]];
  switch (random() % 3) {
  case 0: return a;
  case 1: return (a + b) / T(2);
  default: return a + (b - a) * static_cast<T>(uniform(random, 0, 1));
  }
}

/// Rays between a point inside and one outside, through edges and vertices, both ways: each crosses the surface.
template <class T>
void expect_watertight(const Surface<T>& surface, std::uint64_t rays, Random& random) {
  const Shape<T> mesh(Mesh<T>(surface.points, surface.triangles));
  for (std::uint64_t i = 0; i < rays; ++i) {
    const Vec3<T> target = on_an_edge(surface, random);
    const T far = random() % 4 == 0 ? T(1e6) : T(4);
    Ray<T> ray{surface.inside, target - surface.inside};
    if (random() % 2 == 0) {
      // The end is what rounding makes of a point behind the target; it only has to lie outside.
      const Vec3<T> from = surface.inside + normalized(target - surface.inside) * far;
      ray = {from, random() % 2 == 0 ? surface.inside - from : target - from};
    }
    const auto hit = raycast(mesh, {}, ray);
    ASSERT_TRUE(hit) << "ray " << i << " from " << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " to "
                     << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z;
    ASSERT_TRUE(raycast_any(mesh, {}, ray));
  }
}

/// From points close under an edge to another, nearly in the planes of the faces between them: whatever begins inside
/// must come out. Those of a surface that is not convex begin about its middle.
template <class T>
void expect_no_grazing_escape(const Surface<T>& surface, std::uint64_t rays, Random& random) {
  const Shape<T> mesh(Mesh<T>(surface.points, surface.triangles));
  for (std::uint64_t i = 0; i < rays; ++i) {
    const Vec3<T> from =
        surface.inside + (on_an_edge(surface, random) - surface.inside) * T(surface.convex ? 0.999 : 0.0625);
    const Ray<T> ray{from, on_an_edge(surface, random) - from};
    ASSERT_TRUE(raycast(mesh, {}, ray)) << "ray " << i;
  }
}

template <class T>
class RaycastMesh : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RaycastMesh, Scalars);

TYPED_TEST(RaycastMesh, IsWatertight) {
  using T = TypeParam;
  Random random(1);
  const auto surfaces = closed_surfaces<T>();
  const std::uint64_t each = rays_wanted() / surfaces.size() / 4;  // half of all for each scalar
  for (const Surface<T>& surface : surfaces) {
    ASSERT_NO_FATAL_FAILURE(expect_watertight(shuffled(surface, random), each, random));
    ASSERT_NO_FATAL_FAILURE(expect_no_grazing_escape(shuffled(surface, random), each, random));
  }
}

// As a surface has no ends, the parity of the crossings also tells whether the ray begins inside.
TYPED_TEST(RaycastMesh, AnswersAsEveryTriangleByItself) {
  using T = TypeParam;
  Random random(2);
  for (const Surface<T>& surface : closed_surfaces<T>()) {
    const Shape<T> mesh(Mesh<T>(surface.points, surface.triangles));
    const T tol = tolerance<T> * T(4);
    for (int i = 0; i < 400; ++i) {
      const Vec3<T> from = converted<T>(random_vector(random, 2)), to = converted<T>(random_vector(random, 1));
      const Ray<T> ray{from, to - from};
      std::vector<RayHit<T>> hits, single;
      raycast_all(mesh, {}, ray, hits);
      for (std::uint32_t k = 0; k < surface.triangles.size(); ++k) {
        const Index& t = surface.triangles[k];
        const Shape<T> triangle(Triangle<T>(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
        if (const auto hit = raycast(triangle, {}, ray)) {
          single.push_back(*hit);
          single.back().piece = k;
        }
      }
      std::sort(single.begin(), single.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
      ASSERT_EQ(hits.size(), single.size());
      ASSERT_EQ(hits.size() % 2, holds(surface, from) ? 1u : 0u) << "a closed surface is left as often as entered";
      const auto first = raycast(mesh, {}, ray);
      ASSERT_EQ(first.has_value(), !hits.empty());
      for (std::size_t k = 0; k < hits.size(); ++k) {
        ASSERT_NEAR(hits[k].t, single[k].t, tol * (1 + length(from)));
        ASSERT_LE(hits[k > 0 ? k - 1 : 0].t, hits[k].t);
      }
      if (first) {
        ASSERT_EQ(first->t, hits[0].t);
        ASSERT_EQ(first->piece, hits[0].piece);
        const auto again = raycast(mesh, {}, ray, first->t);
        ASSERT_TRUE(again) << "a ray that ends at its hit";
        ASSERT_EQ(again->t, first->t);
      }
    }
  }
}

// Whatever the size, however far from the frame's origin, and along axes too, where a ray does not move across.
TYPED_TEST(RaycastMesh, AnswersTheSameAtEverySizeAndPlace) {
  using T = TypeParam;
  Random random(3);
  for (const T size : {T(1e-4), T(1), T(1e4)})
    for (const T away : {T(0), T(30)}) {
      Surface<T> surface = torus<T>(40, 6);
      const Vec3<T> middle = Vec3<T>{size, -size, size} * away;
      for (Vec3<T>& p : surface.points) p = p * size + middle;
      const Shape<T> mesh(Mesh<T>(surface.points, surface.triangles));
      std::size_t met = 0;
      for (int i = 0; i < 300; ++i) {
        const Vec3<T> from = converted<T>(random_vector(random, 2)) * size + middle;
        Ray<T> ray{from, converted<T>(random_vector(random, 1)) * size + middle - from};
        if (i % 3 == 0) ray.direction[random() % 3] = T(0);
        if (i % 9 == 0) ray.direction = {T(0), T(i % 2 == 0 ? 1 : -1), T(0)};
        std::vector<RayHit<T>> hits;
        raycast_all(mesh, {}, ray, hits);
        std::vector<std::uint32_t> found, expected;
        for (const auto& hit : hits) found.push_back(hit.piece);
        for (std::uint32_t k = 0; k < surface.triangles.size(); ++k) {
          const Index& t = surface.triangles[k];
          const Shape<T> triangle(Triangle<T>(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
          if (raycast(triangle, {}, ray)) expected.push_back(k);
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << "size " << size << ", " << away << " sizes away, ray " << i;
        met += expected.size();
      }
      EXPECT_GT(met, 100u);
    }
}

}  // namespace
}  // namespace graze::testing
