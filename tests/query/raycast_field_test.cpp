// Rays at height fields: none slips between triangles or past a block; the answer is that of testing every triangle,
// and each ray of many gets what it gets alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "common/specimen.hpp"
#include "graze/batch_raycast.hpp"
#include "query/as_alone.hpp"
#include "rays/height_field_traversal.hpp"
#include "rays/ray_triangle.hpp"
#include "shape/height_field_data.hpp"

namespace graze::testing {
namespace {

/// Steps, slopes and plains; one height in nine a hole, where there are to be any.
template <class T>
HeightField<T> bumpy(Random& random, std::size_t columns, std::size_t rows, T size, bool holes) {
  std::vector<T> heights;
  for (std::size_t i = 0; i < columns * rows; ++i)
    heights.push_back(holes && i > 3 + columns && random() % 9 == 0 ? std::numeric_limits<T>::quiet_NaN()
                                                                    : size * T(random() % 5 < 3 ? 0 : random() % 4));
  return HeightField<T>(columns, rows, heights, size, size / T(2));
}

/// About a field; along axes too, and half of them at its corners where they may be.
template <class T>
std::vector<Ray<T>> field_rays(Random& random, const HeightFieldData<T>& field, std::size_t count,
                               bool at_corners = true) {
  const T size = length(field.bounds().extent());
  std::vector<Ray<T>> rays;
  while (rays.size() < count) {
    Vec3<T> to = field.triangle(static_cast<std::uint32_t>(random() % field.size()))[random() % 3];
    if (!(to == to)) continue;
    if (!at_corners || random() % 2 == 0) to = to + converted<T>(random_vector(random, 0.5f)) * field.spacing_x;
    Vec3<T> along = converted<T>(random_vector(random, 1));
    if (random() % 2 == 0) along.y = along.y / T(8);
    if (random() % 3 == 0) along[random() % 3] = T(0);
    if (random() % 9 == 0) along = {T(0), T(random() % 2 == 0 ? 1 : -1), T(0)};
    if (random() % 9 == 0) along = {T(random() % 2 == 0 ? 1 : -1), T(0), T(0)};
    rays.push_back({to - along * (size * T(random() % 5 == 0 ? 100 : random() % 3)), along});
  }
  return rays;
}

template <class T>
class RaycastField : public ::testing::Test {};
using FieldScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RaycastField, FieldScalars);

constexpr std::pair<std::size_t, std::size_t> field_sizes[] = {{2, 2}, {3, 6}, {2, 40}, {18, 17}, {70, 5}};

TYPED_TEST(RaycastField, AnswersAsEveryTriangleByItself) {
  using T = TypeParam;
  Random random(1);
  std::size_t met = 0;
  for (const auto& [columns, rows] : field_sizes)
    for (const T size : {T(1e-4), T(1), T(1e4)}) {
      const HeightField<T> field = bumpy<T>(random, columns, rows, size, random() % 2 == 0);
      for (const Ray<T>& ray : field_rays(random, field.data(), 60, false)) {
        std::vector<RayHit<T>> hits;
        raycast_all<T>(field, {}, ray, hits);
        std::vector<std::uint32_t> found, expected;
        for (const auto& hit : hits) found.push_back(hit.piece);
        for (std::uint32_t k = 0; k < field.triangle_numbers(); ++k) {
          if (!field.has_triangle(k)) continue;
          const auto p = field.triangle(k);
          if (raycast<T>(Triangle<T>(p[0], p[1], p[2]), {}, ray)) expected.push_back(k);
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, expected) << columns << " x " << rows << ", size " << size;
        met += found.size();
      }
    }
  EXPECT_GT(met, 500u);
}

// From above to below, through corners and edges.
TYPED_TEST(RaycastField, IsWatertight) {
  using T = TypeParam;
  Random random(2);
  const char* more = std::getenv("GRAZE_TEST_RAYS");
  const std::uint64_t rays = (more ? std::strtoull(more, nullptr, 10) : 200'000) / 8;
  const HeightField<T> field = bumpy<T>(random, 67, 50, T(0.3), false);
  const Shape<T> shape = field;
  const Aabb<T> bounds = field.data().bounds();
  std::vector<Ray<T>> all;
  for (std::uint64_t i = 0; i < rays; ++i) {
    const std::uint32_t number = static_cast<std::uint32_t>(random() % field.triangle_numbers());
    const auto p = field.triangle(number);
    const std::size_t k = random() % 3;
    Vec3<T> to = random() % 2 == 0 ? p[k] : p[k] + (p[(k + 1) % 3] - p[k]) * T(uniform(random, 0, 1));
    // Within the field, whatever rounding does to the ray.
    to.x = clamp(to.x, bounds.lower.x * T(0.99), bounds.upper.x * T(0.99));
    to.z = clamp(to.z, bounds.lower.z * T(0.99), bounds.upper.z * T(0.99));
    const Vec3<T> above{clamp(to.x + T(uniform(random, -1, 1)), bounds.lower.x, bounds.upper.x) * T(0.99),
                        bounds.upper.y + T(uniform(random, 0.01f, 3)),
                        clamp(to.z + T(uniform(random, -1, 1)), bounds.lower.z, bounds.upper.z) * T(0.99)};
    const Vec3<T> below{to.x, bounds.lower.y - T(0.01), to.z};
    all.push_back({above, (i % 4 == 0 ? below : to) - above});
    if (i % 4 != 0 && to.y > bounds.lower.y) all.back() = {{to.x, above.y, to.z}, {T(0), T(-1), T(0)}};
    ASSERT_TRUE(raycast(shape, {}, all.back())) << "ray " << i;
    ASSERT_TRUE(raycast_any(shape, {}, all.back())) << "ray " << i;
  }
  std::vector<std::optional<RayHit<T>>> hits(all.size());
  raycast<T>(shape, {}, all, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) ASSERT_TRUE(hits[i]) << "ray " << i;
}

TYPED_TEST(RaycastField, AnswersManyRaysAsEachAlone) {
  using T = TypeParam;
  Random random(3);
  std::size_t met = 0;
  for (const auto& [columns, rows] : field_sizes) {
    const Shape<T> shape = bumpy<T>(random, columns, rows, T(0.5), random() % 2 == 0);
    const HeightFieldData<T>& data = shape.template as<HeightField<T>>()->data();
    for (const Pose<T>& pose : {Pose<T>{}, Pose<T>{converted<T>(random_vector(random, 9)),
                                                   normalized(converted<T>(random_rotation(random)))}}) {
      std::vector<Ray<T>> rays = field_rays(random, data, 500);
      for (Ray<T>& ray : rays) ray = {transform(pose, ray.origin), rotate(pose.rotation, ray.direction)};
      const T end = random() % 2 == 0 ? std::numeric_limits<T>::infinity() : length(data.bounds().extent());
      const BackFaces back = random() % 2 == 0 ? BackFaces::hit : BackFaces::ignored;
      std::vector<std::optional<RayHit<T>>> hits(rays.size());
      bool any[500] = {};
      raycast<T>(shape, pose, rays, hits, end, back);
      raycast_any<T>(shape, pose, rays, any, end, back);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        expect_as_alone(hits[i], any[i], shape, pose, rays[i], end, back, met);
        if (::testing::Test::HasFatalFailure()) FAIL() << i;
      }
    }
  }
  EXPECT_GT(met, 1000u);
}

// And no cell is left out in which the ray crosses a triangle, by the exact signs of its edges in the same frame.
TYPED_TEST(RaycastField, GivesTheSameBitsAtEveryLevel) {
  using T = TypeParam;
  Random random(4);
  const HeightField<T> field = bumpy<T>(random, 70, 33, T(0.5), true);
  const HeightFieldData<T>& data = field.data();
  const Vec3d center = converted<double>(data.bounds().center());
  using Cells = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const auto nearest = [&](const Ray<T>& ray) {
    const Vec3d along = normalized(converted<double>(ray.direction)), from = converted<double>(ray.origin);
    return rays::LocalRay{from + along * dot(center - from, along), along, -1e9, 1e9, 0};
  };
  const auto cells = [&](Isa level, const Ray<T>& ray) {
    Cells told;
    const auto [near, along, begin, end, blur] = nearest(ray);
    const auto found = [](void* to, std::uint32_t column, std::uint32_t row) {
      static_cast<Cells*>(to)->push_back({column, row});
      return 1e9;
    };
    if (length(near - center) <= data.radius) GRAZE_KERNEL(level, traverse_field<T>)
    ({&data.pyramid,
      static_cast<double>(data.extent),
      data.radius,
      {near.x, near.y, near.z},
      {along.x, along.y, along.z},
      -1e9,
      1e9,
      found,
      &told});
    return told;
  };
  struct Answers {
    rays::RayBlock block{};
    std::uint32_t pieces[rays::RayBlock::size] = {};
  };
  const rays::BlockField<T> question{
      &data.pyramid, static_cast<double>(data.extent), {center.x, center.y, center.z}, data.radius, true, false};
  const auto answers = [&](Isa level, const Ray<T>* rays) {
    Answers a;
    GRAZE_KERNEL(level, block_to_local<T>)
    (a.block, &rays->origin.x, rays::RayBlock::size, 1e9, {{}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    GRAZE_KERNEL(level, block_at_field<T>)(a.block, rays::RayBlock::size, question, a.pieces);
    return a;
  };
  std::size_t met = 0;
  for (int round = 0; round < 8; ++round) {
    const std::vector<Ray<T>> rays = field_rays(random, data, rays::RayBlock::size);
    const Answers one = answers(Isa::baseline, rays.data());
    for (const Ray<T>& ray : rays) {
      const Cells told = cells(Isa::baseline, ray);
      const rays::RayAlignedFrame<double> frame(nearest(ray));
      for (std::uint32_t k = 0; k < field.triangle_numbers(); ++k) {
        if (!field.has_triangle(k)) continue;
        const auto p = field.triangle(k);
        const auto corner = [&](std::size_t i) { return frame(converted<double>(p[i])); };
        if (!rays::line_crossing(corner(0), corner(1), corner(2)).through) continue;
        const std::pair cell{k / 2 % 69, k / 2 / 69};
        ASSERT_NE(std::find(told.begin(), told.end(), cell), told.end()) << "triangle " << k;
      }
    }
    for (const Isa level : {Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      const Answers other = answers(level, rays.data());
      for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(cells(level, rays[i]), cells(Isa::baseline, rays[i]));
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
  EXPECT_TRUE(met > 200 || !isa_available(Isa::avx2)) << met;
}

}  // namespace
}  // namespace graze::testing
