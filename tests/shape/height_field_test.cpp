// Height fields: the geometry that the protocol tells, what they refuse, and a pyramid that misses nothing.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "common/specimen.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"
#include "shape/placed_bounds.hpp"

namespace graze::testing {
namespace {

constexpr double hole = std::numeric_limits<double>::quiet_NaN();

std::string field_refusal(std::size_t columns, std::size_t rows, std::vector<double> heights, double dx = 1,
                          double dz = 1) {
  try {
    const HeightField<double> field(columns, rows, std::move(heights), dx, dz);
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "";
}

// A cell is split along (c, r) - (c + 1, r + 1); both triangles face +Y.
TEST(HeightField, StandsAboutTheOriginSplitAlongTheFallingDiagonal) {
  const HeightField<double> field(3, 2, {0, 1, 2, 3, 4, 5}, 2.0, 0.5);
  EXPECT_EQ(field.triangle_numbers(), 4u);
  const auto first = field.triangle(0), second = field.triangle(1);
  EXPECT_EQ(first[0], (Vec3d{-2, 0, -0.25}));
  EXPECT_EQ(first[1], (Vec3d{0, 4, 0.25}));
  EXPECT_EQ(first[2], (Vec3d{0, 1, -0.25}));
  EXPECT_EQ(second[0], (Vec3d{-2, 0, -0.25}));
  EXPECT_EQ(second[1], (Vec3d{-2, 3, 0.25}));
  EXPECT_EQ(second[2], (Vec3d{0, 4, 0.25}));
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto t = field.triangle(i);
    EXPECT_GT(cross(t[1] - t[0], t[2] - t[0]).y, 0);
  }
}

TEST(HeightField, NamesWhatItCannotTake) {
  EXPECT_EQ(field_refusal(1, 2, {0, 0}), "columns: expected a whole number >= 2, got 1");
  EXPECT_EQ(field_refusal(2, 0, {0, 0}), "rows: expected a whole number >= 2, got 0");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0}), "heights: expected columns x rows = 2 x 2 values, got 3");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0, std::numeric_limits<double>::infinity()}),
            "heights[3]: expected a finite number or a hole, got inf");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0, hole}), "heights: expected at least one cell without a hole, got none");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0, 0}, -1), "spacing[0]: expected a finite number >= 0, got -1");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0, 0}, 1, hole).substr(0, 11), "spacing[1]:");
  EXPECT_NE(field_refusal(std::size_t{1} << 33, std::size_t{1} << 31, {0, 0}), "");
  EXPECT_EQ(field_refusal(2, 2, {0, 0, 0, 0}, 0, 0), "");
  EXPECT_THROW(Shaped(HeightField<double>(2, 2, {0, 0, 0, 0}), 0.1), InvalidValue);
}

TEST(HeightField, HolesMayBeNamedApart) {
  const std::vector<std::uint8_t> holes{0, 0, 0, 0, 0, 1};
  const HeightField<double> field(3, 2, {0, 1, 2, 3, 4, 5}, holes);
  EXPECT_TRUE(field.hole(2, 1));
  EXPECT_FALSE(field.hole(1, 1));
  EXPECT_TRUE(field.has_triangle(0) && field.has_triangle(1));
  EXPECT_FALSE(field.has_triangle(2) || field.has_triangle(3) || field.has_triangle(4));
  EXPECT_THROW(HeightField<double>(2, 2, {0, 0, 0, 0}, std::span(holes)), InvalidValue);
}

TEST(HeightField, KeepsAnEighthOfItsHeightsBesides) {
  const HeightField<float> field(1025, 1025, std::vector<float>(1025 * 1025, 0.0f));
  std::size_t bytes = 0;
  for (const auto& level : field.data().levels) bytes += level.spans.size() * sizeof level.spans[0];
  EXPECT_LT(static_cast<double>(bytes), 0.14 * 1025 * 1025 * sizeof(float));
}

template <class T>
class HeightFields : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(HeightFields, Scalars);

// Grids of all small sizes, holes among them: each whole triangle near a region is visited once, and no other.
TYPED_TEST(HeightFields, ThePyramidMissesNothing) {
  using T = TypeParam;
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const std::size_t columns = 2 + random() % 23, rows = 2 + random() % 23;
    std::vector<T> heights(columns * rows);
    for (T& h : heights)
      h = random() % 8 == 0 ? std::numeric_limits<T>::quiet_NaN() : static_cast<T>(uniform(random, -1, 1));
    heights[0] = heights[1] = heights[columns] = heights[columns + 1] = T(0);
    const HeightField<T> field(columns, rows, heights, T(0.7), T(1.3));
    const HeightFieldData<T>& data = field.data();
    const Vec3<T> p = converted<T>(random_vector(random, 12));
    const BoxQuestion<T> question{inflated(Aabb<T>{p, p}, T(uniform(random, 0, 3)))};
    const T limit = T(uniform(random, 0, 2));
    std::set<std::uint32_t> found;
    visit(
        data, question, [&] { return limit; },
        [&](std::uint32_t t) {
          EXPECT_TRUE(field.has_triangle(t));
          EXPECT_TRUE(found.insert(t).second);
        });
    std::size_t whole = 0;
    for (std::uint32_t t = 0; t < field.triangle_numbers(); ++t) {
      if (!field.has_triangle(t)) continue;
      ++whole;
      const Aabb<T> box = bounds_of(field.triangle(t));
      EXPECT_TRUE(contains(data.bounds(), box));
      if (question(box) <= signed_square(limit)) {
        EXPECT_TRUE(found.count(t));
      }
    }
    EXPECT_LE(found.size(), whole);

    // What the grid tells without a search: of a small region, at a corner of the grid in one case of two.
    const std::array<Vec3<T>, 3> some =
        field.triangle(2 * (static_cast<std::uint32_t>(random() % ((columns - 1) * (rows - 1)))));
    const Vec3<T> q = random() % 2 == 0 ? some[random() % 3] : converted<T>(random_vector(random, 12));
    const Aabb<T> near = inflated(Aabb<T>{{q.x, -1, q.z}, {q.x, 1, q.z}}, T(uniform(random, 0, 1e-3f)));
    std::set<std::uint32_t> told;
    auto tell = [&](std::uint32_t t) { EXPECT_TRUE(field.has_triangle(t) && told.insert(t).second); };
    data.each_at(near, tell);
    for (std::uint32_t t = 0; t < field.triangle_numbers(); ++t)
      EXPECT_TRUE(!field.has_triangle(t) || !overlap(bounds_of(field.triangle(t)), near) || told.count(t));
    EXPECT_LE(told.size(), 2 * 5 * 5u);

    // The bounds under a pose contain every corner, and are not wider than that but for rounding and what
    // `loose_bounds` allows.
    const Pose<T> pose{converted<T>(random_vector(random, 5)), normalized(converted<T>(random_rotation(random)))};
    const Aabb<T> bounds = graze::bounds(Shape<T>(field), pose);
    Aabb<T> corners = Aabb<T>::empty();
    for (std::uint32_t t = 0; t < field.triangle_numbers(); ++t)
      if (field.has_triangle(t))
        for (const Vec3<T>& v : field.triangle(t)) corners = merged(corners, transform(pose, v));
    EXPECT_TRUE(contains(bounds, corners));
    const T loose = field.triangle_numbers() > 256 ? T(2 * loose_bounds) * max_abs(data.bounds().extent()) : T(0);
    EXPECT_TRUE(contains(inflated(corners, loose + T(3000) * std::numeric_limits<T>::epsilon()), bounds));
  }
}

}  // namespace
}  // namespace graze::testing
