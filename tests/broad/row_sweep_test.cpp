// The pairs of a frame against all pairs, on the scenes that grids find hard.
#include "broad/row_sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace graze {
namespace {

template <class T>
std::vector<IdPair> brute_force(const std::vector<Aabb<T>>& boxes) {
  std::vector<IdPair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (overlap(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}

template <class T>
void expect_same(const std::vector<Aabb<T>>& boxes, const char* what) {
  RowSweep<T> sweep;
  std::vector<IdPair> found;
  for (int again = 0; again < 2; ++again) {  // the second time in used memory
    sweep.find(boxes, found);
    EXPECT_EQ(found, brute_force(boxes)) << what << ", " << boxes.size() << " boxes";
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
  RowSweep<double> sweep;
  std::vector<IdPair> found;
  sweep.find(boxes, found);
  RC_ASSERT(found == brute_force(boxes));
}

TEST(RadixSort, IsStableAndOrdersNumbers) {
  std::vector<KeyedPlace> items, scratch;
  for (std::uint32_t i = 0; i < 1000; ++i) items.push_back({(i * 7919u) % 50, i});
  radix_sort(items, scratch, 6);
  for (std::size_t i = 1; i < items.size(); ++i)
    EXPECT_TRUE(items[i - 1].key < items[i].key ||
                (items[i - 1].key == items[i].key && items[i - 1].place < items[i].place));
  const float numbers[] = {-1e30f, -2, -1e-40f, 0, 1e-40f, 1, 3e38f};
  for (std::size_t i = 1; i < std::size(numbers); ++i) {
    EXPECT_LT(order_key(numbers[i - 1]), order_key(numbers[i]));
    EXPECT_LE(order_key(double(numbers[i - 1])), order_key(double(numbers[i])));
  }
  EXPECT_EQ(order_key(-0.0f), order_key(0.0f));
}

}  // namespace
}  // namespace graze
