// Changes of pairs from call to call, against all pairs before and after.
#include "graze/pair_changes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace graze {
namespace {

template <class T>
struct ChangesOfPairs : ::testing::Test {
  std::mt19937_64 random{11};
  T uniform(double low, double high) { return T(std::uniform_real_distribution<double>(low, high)(random)); }
  Aabb<T> box(double spread) {
    const Vec3<T> at{uniform(0, spread), uniform(0, spread), uniform(0, spread)};
    const Vec3<T> half{uniform(0, 1), uniform(0, 1), uniform(0, 1)};
    return {at - half, at + half};
  }
};
using ChangedScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ChangesOfPairs, ChangedScalars);

/// The slow and obvious way.
template <class T>
std::set<IdPair> overlapping_of(const std::map<std::uint32_t, Aabb<T>>& boxes) {
  std::set<IdPair> pairs;
  for (auto i = boxes.begin(); i != boxes.end(); ++i)
    for (auto j = std::next(i); j != boxes.end(); ++j)
      if (overlap(i->second, j->second)) pairs.insert({i->first, j->first});
  return pairs;
}

TYPED_TEST(ChangesOfPairs, AreWhatTellsAllPairsNowFromThoseBefore) {
  using T = TypeParam;
  for (const auto make : {make_dynamic_tree<T>, make_sort_and_sweep<T>, make_sweep_and_prune<T>, make_hashed_grid<T>,
                          make_loose_octree<T>, make_bsp<T>}) {
    PairChanges<T> changes(make());
    std::map<std::uint32_t, Aabb<T>> boxes;
    std::set<IdPair> before;
    std::vector<IdPair> begun, ended;
    std::size_t begins = 0, ends = 0;
    for (int frame = 0; frame < 60; ++frame) {
      for (std::uint32_t id = 0; id < 120; ++id) {
        const auto fate = this->random() % 20;
        const bool there = boxes.contains(id);
        if (!there && (frame == 0 || fate == 0)) {
          boxes[id] = this->box(5);
          changes.insert(id, boxes[id]);
        } else if (there && fate == 0) {
          boxes.erase(id);
          changes.remove(id);
          if (frame % 3 == 0) continue;
          boxes[id] = this->box(5);  // removed and inserted anew, elsewhere or not far away
          changes.insert(id, boxes[id]);
        } else if (there && fate < 3) {
          const Vec3<T> by{this->uniform(-0.5, 0.5), this->uniform(-0.5, 0.5), this->uniform(-0.5, 0.5)};
          boxes[id] = {boxes[id].lower + by, boxes[id].upper + by};
          changes.move(id, boxes[id]);
        }
      }
      changes.find(begun, ended);
      const std::set<IdPair> now = overlapping_of(boxes);
      std::vector<IdPair> came, went;
      std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(came));
      std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(went));
      ASSERT_EQ(begun, came) << "frame " << frame;
      ASSERT_EQ(ended, went) << "frame " << frame;
      begins += begun.size(), ends += ended.size();
      before = now;
    }
    EXPECT_GT(begins, 500u);
    EXPECT_GT(ends, 300u);
    changes.find(begun, ended);
    EXPECT_TRUE(begun.empty() && ended.empty()) << "nothing was touched";
    EXPECT_GT(changes.memory(), changes.boxes().memory());
  }
}

TYPED_TEST(ChangesOfPairs, RefuseWhatTheBroadPhaseRefuses) {
  using T = TypeParam;
  PairChanges<T> changes;
  const Aabb<T> unit{{T(0), T(0), T(0)}, {T(1), T(1), T(1)}};
  changes.insert(4, unit);
  EXPECT_THROW(changes.insert(4, unit), InvalidValue);
  EXPECT_THROW(changes.move(5, unit), InvalidValue);
  EXPECT_THROW(changes.remove(5), InvalidValue);
  changes.insert(9, unit);
  std::vector<IdPair> begun, ended;
  changes.find(begun, ended);
  EXPECT_EQ(begun, (std::vector<IdPair>{{4, 9}}));
  changes.remove(4);
  changes.find(begun, ended);
  EXPECT_TRUE(begun.empty());
  EXPECT_EQ(ended, (std::vector<IdPair>{{4, 9}}));
}

}  // namespace
}  // namespace graze
