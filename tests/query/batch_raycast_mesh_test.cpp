// Many rays at a mesh at a time: each gets what it gets alone, to the bit, whatever is under way beside it.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/specimen.hpp"
#include "graze/batch_raycast.hpp"
#include "query/as_alone.hpp"
#include "rays/ray_stream.hpp"
#include "shape/mesh_data.hpp"

namespace graze::testing {
namespace {

template <class T>
struct MeshRays {
  std::vector<Ray<T>> rays;
  T length;
};

/// A closed surface on a grid of whole numbers, so that rays meet its edges exactly; among its triangles some that lie
/// over others, some that stand across, and some without area.
template <class T>
Mesh<T> gridded(Random& random, std::uint32_t side, T size) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t x = 0; x <= side; ++x)
    for (std::uint32_t z = 0; z <= side; ++z)
      points.push_back(Vec3<T>{T(x), T(x % 4 < 2 ? 0 : random() % 3), T(z)} * size);
  const auto at = [&](std::uint32_t x, std::uint32_t z) { return x * (side + 1) + z; };
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t z = 0; z < side; ++z) {
      triangles.push_back({at(x, z), at(x, z + 1), at(x + 1, z + 1)});
      triangles.push_back({at(x, z), at(x + 1, z + 1), at(x + 1, z)});
      if (random() % 6 == 0) triangles.push_back({at(x + 1, z), at(x, z), at(x, z + 1)});
      if (random() % 9 == 0) triangles.push_back({at(x, z), at(x, z), at(x + 1, z + 1)});
      if (random() % 9 == 0)
        triangles.push_back({at(x, z), at(x, z + 1), at(x, static_cast<std::uint32_t>(random() % side))});
    }
  return {points, triangles};
}

/// A picture, a shadow's parallel rays, any directions, and along axes at corners and edges; some that are none.
template <class T>
std::vector<MeshRays<T>> questions(Random& random, const Aabb<T>& bounds) {
  const Vec3<T> center = bounds.center();
  const T size = length(bounds.extent());
  const auto inside = [&] { return center + converted<T>(random_vector(random, 0.5f)) * size; };
  std::vector<MeshRays<T>> all;
  for (const T far : {T(0.7), T(1000)}) {
    MeshRays<T> picture{{}, std::numeric_limits<T>::infinity()}, shadow{{}, size * T(1.5)}, any = picture,
                                                                                            axes = picture;
    const Vec3<T> toward = normalized(Vec3<T>{T(1), T(2), T(3)}), eye = center + toward * (size * far);
    for (int i = 0; i < 400; ++i) {
      const Vec3<T> across{T(i % 20 - 10), T(0), T(i / 20 - 10)};
      const Vec3<T> target = center + across * (size / T(20));
      picture.rays.push_back({eye, target - eye});
      shadow.rays.push_back({target + toward * size, -toward});
      const Vec3<T> from = center + normalized(converted<T>(random_vector(random, 1))) * (size * far);
      any.rays.push_back({from, inside() - from});
      Ray<T> ray{bounds.lower + across + Vec3<T>{T(0), size, T(0)}, {T(0), T(-1), T(0)}};
      if (i % 4 == 1) ray.direction = {T(1), T(0), T(0)};
      if (i % 8 == 1) ray.origin.y = T(0);
      if (i % 4 == 2) ray.direction = {T(1), T(-1), T(0)};
      if (i % 31 == 0) ray.direction = {};
      if (i % 37 == 0) ray.origin.x = std::numeric_limits<T>::quiet_NaN();
      axes.rays.push_back(ray);
    }
    all.insert(all.end(), {picture, shadow, any, axes});
  }
  return all;
}

template <class T>
class BatchRaycastMesh : public ::testing::Test {};
using MeshScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BatchRaycastMesh, MeshScalars);

TYPED_TEST(BatchRaycastMesh, AnswersAsForEachRayAlone) {
  using T = TypeParam;
  Random random(1);
  std::size_t met = 0;
  for (const std::uint32_t side : {1u, 5u, 30u})
    for (const T scale : {T(1), T(0.125)}) {
      const Mesh<T> mesh = gridded<T>(random, side, scale);
      const Shape<T> shape = mesh;
      for (const Pose<T>& pose : {Pose<T>{}, Pose<T>{converted<T>(random_vector(random, 9)),
                                                     normalized(converted<T>(random_rotation(random)))}})
        for (auto [rays, end] : questions<T>(random, mesh.data().tree.bounds())) {
          const BackFaces back = random() % 2 == 0 ? BackFaces::hit : BackFaces::ignored;
          if (random() % 2 == 0)
            for (std::size_t i = rays.size(); i > 1; --i) std::swap(rays[i - 1], rays[random() % i]);
          std::vector<std::optional<RayHit<T>>> hits(rays.size());
          bool any[400] = {};
          for (std::size_t first = 0; first < rays.size();) {
            const std::size_t count = std::min<std::size_t>(1 + random() % 200, rays.size() - first);
            const auto some = std::span<const Ray<T>>(rays).subspan(first, count);
            raycast<T>(shape, pose, some, std::span(hits).subspan(first), end, back);
            raycast_any<T>(shape, pose, some, std::span(any).subspan(first), end, back);
            first += count;
          }
          for (std::size_t i = 0; i < rays.size(); ++i) {
            expect_as_alone(hits[i], any[i], shape, pose, rays[i], end, back, met);
            if (::testing::Test::HasFatalFailure()) FAIL() << i;
          }
        }
    }
  EXPECT_GT(met, 5000u);
}

TYPED_TEST(BatchRaycastMesh, GivesTheSameBitsAtEveryLevel) {
  using T = TypeParam;
  Random random(2);
  struct Answers {
    rays::RayBlock block{};
    std::uint32_t pieces[rays::RayBlock::size] = {};
  };
  const Mesh<T> mesh = gridded<T>(random, 20, T(1));
  const MeshData<T>& data = mesh.data();
  const Vec3d center = converted<double>(data.tree.bounds().center());
  rays::BlockMesh<T> question{data.tree.nodes().data(),
                              data.leaves.data(),
                              &data.points.data()->x,
                              data.triangles.data()->data(),
                              data.tree.order().data(),
                              static_cast<double>(data.extent),
                              {center.x, center.y, center.z},
                              data.radius,
                              true,
                              false};
  const auto answers = [&](Isa level, const Ray<T>* rays) {
    Answers a;
    GRAZE_KERNEL(level, block_to_local<T>)
    (a.block, &rays->origin.x, rays::RayBlock::size, 1e9, {{}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    GRAZE_KERNEL(level, block_at_mesh<T>)(a.block, rays::RayBlock::size, question, a.pieces);
    return a;
  };
  std::size_t met = 0;
  for (const MeshRays<T>& q : questions<T>(random, data.tree.bounds()))
    for (std::size_t first = 0; first + rays::RayBlock::size <= q.rays.size(); first += rays::RayBlock::size) {
      question.both_sides = random() % 2 == 0;
      const Answers one = answers(Isa::baseline, &q.rays[first]);
      for (const Isa level : {Isa::avx2, Isa::avx512}) {
        if (!isa_available(level)) continue;
        const Answers other = answers(level, &q.rays[first]);
        for (std::size_t i = 0; i < rays::RayBlock::size; ++i) {
          ASSERT_EQ(one.block.state[i], other.block.state[i]);
          if (one.block.state[i] != rays::ray_hit) continue;
          met += 1;
          ASSERT_EQ(one.pieces[i], other.pieces[i]);
          ASSERT_EQ(one.block.t[i], other.block.t[i]);
          for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_EQ(one.block.point[k][i], other.block.point[k][i]);
            ASSERT_EQ(one.block.normal[k][i], other.block.normal[k][i]);
          }
        }
      }
    }
  EXPECT_TRUE(met > 500 || !isa_available(Isa::avx2)) << met;
}

}  // namespace
}  // namespace graze::testing
