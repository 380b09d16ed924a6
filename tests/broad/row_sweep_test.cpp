// The pairs of a frame against all pairs, on the scenes that grids find hard.
#include "broad/row_sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "broad/radix_sort.hpp"
#include "broad/wide_boxes.hpp"

#include "broad/all_pairs.hpp"

namespace graze {
namespace {

std::vector<Isa> available_levels() {
  std::vector<Isa> levels{Isa::baseline, Isa::avx2, Isa::avx512};
  std::erase_if(levels, [](Isa level) { return !isa_available(level); });
  return levels;
}

/// All pairs: those that are swept, and those of boxes that are left to be compared with everything.
template <class T>
void find_all(RowSweep<T>& sweep, Isa level, const std::vector<Aabb<T>>& boxes, std::vector<IdPair>& found) {
  ASSERT_TRUE(sweep.find(boxes));
  sweep.sort_into(found);
  if (sweep.wide().empty()) return;
  const std::vector<IdPair> swept = found;
  WideBoxes<T>().merge(level, boxes, sweep.wide(), swept, found);
}

template <class T>
void expect_same(const std::vector<Aabb<T>>& boxes, const char* what) {
  const std::vector<IdPair> expected = all_pairs(boxes);
  for (const Isa level : available_levels()) {
    RowSweep<T> sweep(level);
    std::vector<IdPair> found;
    for (int again = 0; again < 2; ++again) {  // the second time in used memory
      find_all(sweep, level, boxes, found);
      EXPECT_EQ(found, expected) << what << ", " << boxes.size() << " boxes, level " << static_cast<int>(level);
    }
  }
}

template <class T>
class Scenes {
 public:
  T number(double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  Aabb<T> box(double reach, double size) {
    const Vec3<T> low{number(-reach, reach), number(-reach, reach), number(-reach, reach)};
    return {low, low + Vec3<T>{number(0, size), number(0, size), number(0, size)}};
  }
  std::vector<Aabb<T>> many(std::size_t count, double reach, double size) {
    std::vector<Aabb<T>> boxes;
    for (std::size_t i = 0; i < count; ++i) boxes.push_back(box(reach, size));
    return boxes;
  }

 private:
  std::mt19937_64 random_{3};
};

template <class T>
void check_scenes() {
  Scenes<T> s;
  expect_same<T>({}, "none");
  expect_same<T>(s.many(1, 1, 1), "one");
  for (const double size : {0.0, 0.1, 1.0, 30.0}) expect_same(s.many(700, 10, size), "random");
  auto uneven = s.many(700, 10, 0.5);
  for (std::size_t i = 0; i < uneven.size(); i += 100) uneven[i].upper = uneven[i].lower + Vec3<T>{T(25), T(25), T(25)};
  expect_same(uneven, "uneven");
  auto levels = s.many(600, 10, 1);
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i].upper = levels[i].lower + (levels[i].upper - levels[i].lower) * static_cast<T>(std::pow(4.0, i % 9));
  expect_same(levels, "nine sizes");
  auto clusters = s.many(600, 1, 0.2);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Vec3<T> away{T(1e6) * T(i % 3), T(-1e5) * T(i % 5), T(3e6) * T(i % 2)};
    clusters[i] = {clusters[i].lower + away, clusters[i].upper + away};
  }
  expect_same(clusters, "clusters far apart");
  expect_same(std::vector<Aabb<T>>(40, s.box(1, 1)), "identical");
  expect_same(std::vector<Aabb<T>>(40, {Vec3<T>{T(1), T(2), T(3)}, Vec3<T>{T(1), T(2), T(3)}}), "one point");
  auto flat = s.many(500, 5, 2);
  for (std::size_t i = 0; i < flat.size(); ++i) flat[i].upper[i % 3] = flat[i].lower[i % 3];
  expect_same(flat, "flat");
  auto needles = s.many(500, 5, 0.2);
  for (std::size_t i = 0; i < needles.size(); ++i) needles[i].upper[i % 3] += T(8);
  expect_same(needles, "needles");
  auto far = s.many(500, 0.01, 0.003);
  for (auto& b : far) b = {b.lower + Vec3<T>{T(1e4), T(1e4), T(1e4)}, b.upper + Vec3<T>{T(1e4), T(1e4), T(1e4)}};
  expect_same(far, "far from the origin");
}

TEST(RowSweep, AgreesWithAllPairsInDouble) { check_scenes<double>(); }
TEST(RowSweep, AgreesWithAllPairsInFloat) { check_scenes<float>(); }

TEST(RowSweep, TakesWhatNoGridCanHold) {
  Scenes<float> s;
  constexpr float inf = std::numeric_limits<float>::infinity(), huge = std::numeric_limits<float>::max();
  auto boxes = s.many(100, 5, 2);
  boxes.push_back(Aabbf::everything());
  boxes.push_back({{-inf, 0, 0}, {inf, 1, 1}});
  boxes.push_back({{-huge, -huge, -huge}, {huge, huge, huge}});
  boxes.push_back({{-huge / 2, 0, 0}, {huge / 3, 1, 1}});
  boxes.push_back({{huge, huge, huge}, {huge, huge, huge}});
  boxes.push_back({{1e-40f, 1e-40f, 0}, {2e-40f, 1e-40f, 0}});
  boxes.push_back({{1e30f, -1e30f, 1e30f}, {1.1e30f, -0.9e30f, 1.2e30f}});
  expect_same(boxes, "unbounded");
  expect_same(std::vector<Aabbf>(boxes.begin() + 100, boxes.end()), "only unbounded");
}

/// On a small grid, so that boxes touch in faces, edges and corners all the time.
RC_GTEST_PROP(RowSweep, CountsTouchingOnALattice, (const std::vector<std::array<std::uint8_t, 6>>& numbers)) {
  std::vector<Aabbd> boxes;
  for (const auto& n : numbers) {
    const Vec3d low{double(n[0] % 9), double(n[1] % 9), double(n[2] % 9)};
    boxes.push_back({low, low + Vec3d{double(n[3] % 4), double(n[4] % 4), double(n[5] % 4)}});
  }
  for (const Isa level : available_levels()) {
    RowSweep<double> sweep(level);
    std::vector<IdPair> found;
    find_all(sweep, level, boxes, found);
    RC_ASSERT(found == all_pairs(boxes));
  }
}

/// What stands alone far out stretches the grid by any factor; the strips then follow the boxes.
template <class T>
void check_outliers() {
  Scenes<T> s;
  for (const double far : {1e4, 1e9, 1e30}) {
    auto boxes = s.many(900, 10, 1);
    const Vec3<T> away{T(far), T(-far), T(far)};
    for (const T sign : {T(1), T(-1)}) boxes.push_back({away * sign, away * sign});
    boxes.push_back({{T(0), T(far), T(0)}, {T(1), T(far), T(1)}});
    expect_same(boxes, "outliers");
  }
  auto diagonal = s.many(900, 1, 1);
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const T at = T(i / 3) * T(200);
    diagonal[i] = {diagonal[i].lower + Vec3<T>{at, at, at}, diagonal[i].upper + Vec3<T>{at, at, at}};
  }
  expect_same(diagonal, "small groups on a diagonal");
  auto points = s.many(900, 10, 0);
  for (std::size_t i = 1; i < points.size(); i += 2) points[i] = points[i - 1];
  expect_same(points, "points in pairs");
  auto line = s.many(900, 1e30, 0);
  for (auto& b : line) b = {{b.lower.x, 0, 0}, {b.lower.x, 1, 1}};
  expect_same(line, "a line");
  for (auto& b : line) b = {{T(1e-30) * b.lower.x, 0, 0}, {T(1e-30) * b.lower.x + T(1e-6), 1, 1}};
  line.push_back({{T(1e30), 0, 0}, {T(1e30), 1, 1}});
  expect_same(line, "all but one in one place along X");
}
TEST(RowSweep, FollowsOutliersInDouble) { check_outliers<double>(); }
TEST(RowSweep, FollowsOutliersInFloat) { check_outliers<float>(); }

/// Many rows and more than one vector of neighbours in each, which the scenes above are too small for.
TEST(RowSweep, AgreesOnAWideScene) {
  Scenes<float> s;
  expect_same(s.many(6000, 12, 1.5), "dense");
  auto uneven = s.many(6000, 12, 0.5);
  for (std::size_t i = 0; i < uneven.size(); i += 100) uneven[i].upper = uneven[i].lower + Vec3f{9, 3, 6};
  expect_same(uneven, "uneven");
}

TEST(RowSweep, KeepsItsMemory) {
  Scenes<float> s;
  const auto boxes = s.many(3000, 10, 1), other = s.many(2500, 10, 1);
  RowSweep<float> sweep;
  std::vector<IdPair> found;
  const auto find = [&](const std::vector<Aabb<float>>& scene) {
    EXPECT_TRUE(sweep.find(scene));
    sweep.sort_into(found);
  };
  find(boxes), find(other);
  const std::size_t memory = sweep.memory(), room = found.capacity();
  find(other), find(boxes);
  EXPECT_EQ(sweep.memory(), memory);
  EXPECT_EQ(found.capacity(), room);
}

TEST(Strips, OfBoxesThatOverlapAreNeighbours) {
  Scenes<float> s;
  for (const double reach : {1.0, 100.0, 1e4, 1e9}) {
    std::vector<float> begins, sorted;
    for (int i = 0; i < 3000; ++i) begins.push_back(s.number(-reach, reach));
    sorted = begins;
    Strips<float> strips;
    const auto [low, high] = std::minmax_element(begins.begin(), begins.end());
    if (!strips.set(*low, *high, 1)) strips.adapt(sorted, 1);
    EXPECT_LE(strips.count(), Strips<float>::most);
    for (const float b : begins) {
      const std::uint32_t at = strips.strip(b);
      EXPECT_LT(at, strips.count());
      EXPECT_EQ(strips.nearest(b), at);
      if (b + 1 <= *high) {
        EXPECT_LE(strips.nearest(b + 1), at + 1);
        EXPECT_GE(strips.nearest(b + 1), at);
      }
    }
    EXPECT_EQ(strips.nearest(-std::numeric_limits<float>::max()), 0u);
    EXPECT_EQ(strips.nearest(std::numeric_limits<float>::max()), strips.count() - 1);
  }
}

TEST(RadixSort, IsStable) {
  for (const int bits : {0, 6, 11, 13, 32}) {
    std::vector<std::uint64_t> items(5000), scratch(5000), expected(5000);
    std::mt19937_64 random(1);
    for (std::uint64_t& item : expected) item = random();
    const std::vector<std::uint64_t> given = expected;
    const auto digits_of = [bits](std::uint64_t v) { return v >> 7 & ((std::uint64_t{1} << bits) - 1); };
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint64_t p, std::uint64_t q) { return digits_of(p) < digits_of(q); });
    Digits digits;
    digits.add(7, bits);
    const std::uint64_t* sorted = radix_sort(
        given.size(), [&](std::size_t i) { return given[i]; }, digits, [](std::uint64_t v) { return v; }, items.data(),
        scratch.data());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), sorted)) << bits;
  }
}

}  // namespace
}  // namespace graze
