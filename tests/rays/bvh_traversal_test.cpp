// The way of a ray down a mesh's tree: at every level of the instruction set the same triangles in the same order,
// none that is crossed left out, and few others.
#include "rays/bvh_traversal.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/specimen.hpp"
#include "rays/ray_triangle.hpp"
#include "shape/mesh_data.hpp"

namespace graze::testing {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Triangles of some size about a centre; a few of them flat or all in one point.
template <class T>
Mesh<T> soup(Random& random, std::size_t count, T size, const Vec3<T>& center) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3<T> at = center + converted<T>(random_vector(random, 1)) * size;
    for (std::uint32_t k = 0; k < 3; ++k)
      points.push_back(i % 50 == 0 ? at : at + converted<T>(random_vector(random, 0.3f)) * size);
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {points, triangles};
}

/// What a kernel tells of, in its order; of the whole ray.
template <class T>
Numbers told(void (*kernel)(const BvhQuestion<T>&), const MeshData<T>& mesh, const rays::LocalRay& ray) {
  struct Owner {
    const MeshData<T>& mesh;
    double end;
    Numbers numbers;
  } owner{mesh, ray.end, {}};
  const auto found = [](void* to, std::uint32_t place) {
    Owner& o = *static_cast<Owner*>(to);
    o.numbers.push_back(o.mesh.tree.order()[place]);
    return o.end;
  };
  kernel({mesh.tree.nodes().data(),
          mesh.leaves.data(),
          static_cast<double>(mesh.extent),
          mesh.radius,
          {ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z},
          ray.begin,
          ray.end,
          found,
          &owner});
  return owner.numbers;
}

template <class T>
Numbers crossed(const MeshData<T>& mesh, const rays::LocalRay& ray) {
  const rays::RayAlignedFrame<double> frame(ray);
  Numbers numbers;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto p = mesh.triangle(i);
    const auto corner = [&](std::size_t k) { return frame(converted<double>(p[k])); };
    const rays::LineCrossing<double> at = rays::line_crossing(corner(0), corner(1), corner(2));
    if (at.through && at.t >= ray.begin && at.t <= ray.end) numbers.push_back(i);
  }
  return numbers;
}

template <class T>
class TreeWalks : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TreeWalks, Scalars);

TYPED_TEST(TreeWalks, TellTheSameAtEveryLevelAndLeaveNothingOut) {
  using T = TypeParam;
  Random random(1);
  std::size_t all = 0, met = 0;
  for (const std::size_t count : {1u, 3u, 30u, 700u})
    for (const T size : {T(1e-4), T(1), T(1e4)})
      for (const T away : {T(0), T(50)}) {
        const Mesh<T> mesh = soup<T>(random, count, size, Vec3<T>{size, -size, size} * away);
        const MeshData<T>& data = mesh.data();
        const Vec3d center = converted<double>(data.tree.bounds().center());
        for (int i = 0; i < 150; ++i) {
          // At a corner one time in four: that is crossed or not by the sign of nothing.
          const Vec3d to = i % 4 == 0 ? converted<double>(data.points[random() % data.points.size()])
                                      : center + converted<double>(random_vector(random, 1)) * double(size);
          Vec3d along = converted<double>(random_vector(random, 1));
          if (i % 3 == 0) along[random() % 3] = 0;
          along = normalized(along);
          const rays::LocalRay ray = {to - along * dot(to - center, along), along, -double(size),
                                      i % 2 == 0 ? rays::infinity : double(size) / 3, 0};
          const Numbers baseline = told(GRAZE_KERNEL(Isa::baseline, traverse_bvh<T>), data, ray);
          for (const Isa level : {Isa::avx2, Isa::avx512})
            if (isa_available(level)) {
              ASSERT_EQ(told(GRAZE_KERNEL(level, traverse_bvh<T>), data, ray), baseline);
            }
          Numbers sorted = baseline;
          std::sort(sorted.begin(), sorted.end());
          const Numbers needed = crossed(data, ray);
          ASSERT_TRUE(std::includes(sorted.begin(), sorted.end(), needed.begin(), needed.end()))
              << "size " << size << ", " << away << " sizes away, ray " << i;
          all += sorted.size();
          met += needed.size();
        }
      }
  EXPECT_GT(met, 1000u);
  // Beside what is crossed, what lies off the ray's ends, is seen edge-on or is aimed at where it is no more than a
  // point.
  EXPECT_LT(all, 2 * met);
}

}  // namespace
}  // namespace graze::testing
