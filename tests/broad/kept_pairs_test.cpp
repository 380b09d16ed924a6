// The pairs of frame after frame against all pairs: what is remembered of the frames before changes no answer.
#include "broad/kept_pairs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <random>

#include "broad/all_pairs.hpp"

namespace graze {
namespace {

/// Boxes that move at random.
template <class T>
class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed) {}

  T number(double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  bool happens(double chance) { return std::bernoulli_distribution(chance)(random_); }

  Aabb<T> anywhere(double longest) {
    const Vec3<T> low{number(0, reach), number(0, reach), number(0, reach)};
    return {low, low + Vec3<T>{number(0, longest), number(0, longest), number(0, longest)}};
  }
  void add(std::size_t count) {
    while (count-- > 0) boxes.push_back(anywhere(happens(uneven) ? 6 : 1.2));
  }
  /// Each with a chance of `share`, by up to `step` on each side; some jump.
  void move(double share, double step, double jumps) {
    for (Aabb<T>& box : boxes) {
      if (!happens(share)) continue;
      const Vec3<T> by{number(-step, step), number(-step, step), number(-step, step)};
      box = happens(jumps) ? anywhere(1.2) : Aabb<T>{box.lower + by, box.upper + by};
    }
  }

  double reach = 6, uneven = 0;
  std::vector<Aabb<T>> boxes;

 private:
  std::mt19937_64 random_;
};

/// Compares every frame at every level, each with its own memory.
template <class T>
class Finders {
 public:
  Finders() {
    for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512})
      if (isa_available(level)) finders_.emplace_back(level);
  }
  bool agree(const std::vector<Aabb<T>>& boxes) {
    const std::vector<IdPair> expected = all_pairs(boxes);
    bool same = true;
    for (KeptPairs<T>& finder : finders_) {
      finder.find(boxes, found_, serial_);
      same = same && found_ == expected;
    }
    return same;
  }
  bool have_list() const { return finders_[0].has_list(); }

 private:
  SerialExecutor serial_;
  std::vector<KeptPairs<T>> finders_;
  std::vector<IdPair> found_;
};

template <class T>
void check_random_motion(std::uint64_t seed) {
  Crowd<T> crowd(seed);
  crowd.uneven = *rc::gen::element(0.0, 0.02);
  crowd.add(*rc::gen::inRange<std::size_t>(0, 150));
  if (*rc::gen::arbitrary<bool>()) crowd.boxes.push_back(Aabb<T>::everything());
  Finders<T> finders;
  for (int frame = 0; frame < 14; ++frame) {
    const double share = *rc::gen::element(0.0, 0.02, 0.1, 1.0), step = *rc::gen::element(0.0, 0.01, 0.04, 0.4);
    crowd.move(share, step, *rc::gen::element(0.0, 0.0, 0.05, 1.0));
    if (*rc::gen::inRange(0, 4) == 0) crowd.add(*rc::gen::inRange<std::size_t>(0, 9));
    if (*rc::gen::inRange(0, 4) == 0 && !crowd.boxes.empty()) {
      const std::size_t gone = *rc::gen::inRange<std::size_t>(0, crowd.boxes.size());
      if (*rc::gen::arbitrary<bool>()) crowd.boxes[gone] = crowd.boxes.back();
      crowd.boxes.pop_back();
    }
    RC_ASSERT(finders.agree(crowd.boxes));
  }
}
RC_GTEST_PROP(KeptPairs, AgreeWithAllPairsInEveryFrameInDouble, (std::uint64_t seed)) {
  check_random_motion<double>(seed);
}
RC_GTEST_PROP(KeptPairs, AgreeWithAllPairsInEveryFrameInFloat, (std::uint64_t seed)) {
  check_random_motion<float>(seed);
}

/// Every share of boxes that move, from none to all, and both sides of what ends a list.
TEST(KeptPairs, AgreeForEveryShareThatMoves) {
  for (const double share : {0.0, 0.01, 0.06, 0.12, 0.14, 0.5, 1.0})
    for (const double step : {0.015, 0.3}) {
      Crowd<float> crowd(7);
      crowd.reach = 9;
      crowd.add(500);
      Finders<float> finders;
      for (int frame = 0; frame < 16; ++frame) {
        EXPECT_TRUE(finders.agree(crowd.boxes)) << share << " by " << step << ", frame " << frame;
        crowd.move(share, step, 0);
      }
    }
}

TEST(KeptPairs, MakeAListOfWhatMovesLittleAndNoneOfWhatJumps) {
  Crowd<double> crowd(5);
  crowd.reach = 12;
  crowd.add(1000);
  Finders<double> finders;
  for (int frame = 0; frame < 4; ++frame) {
    EXPECT_TRUE(finders.agree(crowd.boxes));
    EXPECT_EQ(finders.have_list(), frame > 0) << frame;
    crowd.move(1, 0.005, 0);
  }
  crowd.move(1, 0, 1);
  EXPECT_TRUE(finders.agree(crowd.boxes));
  EXPECT_FALSE(finders.have_list());
}

/// Those that come and go at the end of the array are no reason to give the list up.
TEST(KeptPairs, KeepTheirListWhenBoxesComeAndGo) {
  Crowd<float> crowd(11);
  crowd.add(200);
  Finders<float> finders;
  for (int frame = 0; frame < 12; ++frame) {
    EXPECT_TRUE(finders.agree(crowd.boxes)) << frame;
    EXPECT_EQ(finders.have_list(), frame > 0) << frame;
    crowd.move(0.05, 0.01, 0);
    if (frame % 3 == 0) crowd.boxes.resize(crowd.boxes.size() - 7);
    if (frame % 3 == 1) crowd.add(7);
  }
}

/// A floor and something large that moves over all others, beside what no grid can hold.
TEST(KeptPairs, AgreeWithWideBoxes) {
  Crowd<float> crowd(13);
  crowd.reach = 40;
  crowd.add(400);
  crowd.boxes.push_back({{-100, -1, -100}, {100, 2, 100}});
  crowd.boxes.push_back(Aabbf::everything());
  crowd.boxes.push_back({{0, 0, 0}, {30, 30, 30}});
  constexpr float inf = std::numeric_limits<float>::infinity();
  crowd.boxes.push_back({{inf, inf, inf}, {inf, inf, inf}});
  Finders<float> finders;
  for (int frame = 0; frame < 12; ++frame) {
    EXPECT_TRUE(finders.agree(crowd.boxes)) << frame;
    crowd.move(0.1, 0.01, 0.2);
    if (frame % 4 == 3) crowd.boxes[401] = frame % 8 == 3 ? crowd.anywhere(1) : Aabbf::everything();
  }
}

/// Many that overlap a good part of all others: they may move, shrink, come and go without an end of the list.
TEST(KeptPairs, AgreeWithManyWideBoxes) {
  Crowd<double> crowd(19);
  crowd.reach = 24;
  crowd.add(900);
  const auto widen = [&](std::size_t i) { crowd.boxes[i].upper = crowd.boxes[i].lower + Vec3d{20, 24, 18}; };
  for (std::size_t i = 5; i < 900; i += 40) widen(i);
  Finders<double> finders;
  for (int frame = 0; frame < 24; ++frame) {
    EXPECT_TRUE(finders.agree(crowd.boxes)) << frame;
    EXPECT_EQ(finders.have_list(), frame > 0) << frame;
    crowd.move(0.3, 0.005, 0);
    const Vec3d far = Vec3d{1, -2, 0.5} * (frame % 2 == 0 ? 1 : -1);
    for (std::size_t i = 5; i < crowd.boxes.size(); i += 80)  // every other of them
      crowd.boxes[i] = {crowd.boxes[i].lower + far, crowd.boxes[i].upper + far};
    if (frame % 5 == 1) crowd.boxes[45 + 40 * static_cast<std::size_t>(frame / 5)] = crowd.anywhere(1);
    if (frame % 6 == 2) crowd.boxes.resize(crowd.boxes.size() - 45);
    if (frame % 6 == 5) crowd.add(45);
  }
}

/// Once they are wide no more, the next list has them in it.
TEST(KeptPairs, EndTheListOfThoseThatAreWideNoMore) {
  Crowd<float> crowd(23);
  crowd.reach = 24;
  crowd.add(900);
  const std::vector<Aabbf> all_small = crowd.boxes;
  for (std::size_t i = 0; i < 900; i += 40) crowd.boxes[i].upper += Vec3f{20, 24, 18};
  Finders<float> finders;
  for (const bool has_list : {false, true, true}) {
    EXPECT_TRUE(finders.agree(crowd.boxes));
    EXPECT_EQ(finders.have_list(), has_list);
  }
  crowd.boxes = all_small;
  for (const bool has_list : {false, true}) {
    EXPECT_TRUE(finders.agree(crowd.boxes));
    EXPECT_EQ(finders.have_list(), has_list);
  }
}

/// Boxes that do not overlap, each with scores of others just out of reach: a list of them all would be of no use.
TEST(KeptPairs, MakeNoListOfMoreThanIsWorthHaving) {
  std::vector<Aabbf> boxes;
  for (int i = 0; i < 2560; ++i) {
    const Vec3f low{0.2f * static_cast<float>(i / 64), 1.05f * static_cast<float>(i / 8 % 8),
                    1.05f * static_cast<float>(i % 8)};
    boxes.push_back({low, low + Vec3f{1, 1, 1}});
  }
  Finders<float> finders;
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(finders.agree(boxes)) << frame;
    EXPECT_FALSE(finders.have_list()) << frame;
  }
}

/// Dust and needles between larger boxes have no more room than is in proportion to them.
TEST(KeptPairs, GiveSmallBoxesLittleRoom) {
  Crowd<double> crowd(17);
  crowd.reach = 12;
  crowd.add(700);
  for (int i = 0; i < 300; ++i) {
    const Vec3d dust = crowd.anywhere(0).lower * 0.05, needle = crowd.anywhere(0).lower * 0.1;
    crowd.boxes.push_back({dust, dust + Vec3d{0.001, 0.001, 0.001}});
    crowd.boxes.push_back({needle, needle + Vec3d{0.001, 1.5, 0.001}});
  }
  Finders<double> finders;
  for (int frame = 0; frame < 8; ++frame) {
    EXPECT_TRUE(finders.agree(crowd.boxes)) << frame;
    EXPECT_EQ(finders.have_list(), frame > 0) << frame;
    crowd.move(0.05, 0.0001, 0);
  }
}

/// The last task first, as if each had a thread of its own and the first was the slowest.
struct BackwardsExecutor final : Executor {
  std::size_t most = 0;

  std::size_t concurrency() const override { return 3; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    most = std::max(most, count);
    while (count > 0) task(--count);
  }
};

TEST(KeptPairs, AreTheSameFromSeveralThreads) {
  Crowd<float> crowd(4);
  crowd.reach = 12;
  crowd.add(4000);
  KeptPairs<float> alone, together;
  SerialExecutor serial;
  BackwardsExecutor backwards;
  std::vector<IdPair> expected, found;
  for (int frame = 0; frame < 12; ++frame) {
    alone.find(crowd.boxes, expected, serial);
    together.find(crowd.boxes, found, backwards);
    EXPECT_EQ(found, expected) << frame;
    crowd.move(frame % 4 == 3 ? 0.05 : 1, 0.01, 0.001);
  }
  EXPECT_TRUE(together.has_list());
  EXPECT_GT(backwards.most, 2u);
}

TEST(KeptPairs, KeepTheirMemory) {
  Crowd<float> crowd(3);
  crowd.reach = 20;
  crowd.add(3000);
  KeptPairs<float> finder;
  SerialExecutor serial;
  std::vector<IdPair> found;
  const auto run = [&] {
    for (int frame = 0; frame < 20; ++frame) {
      finder.find(crowd.boxes, found, serial);
      crowd.move(1, 0.01, 0.001);
    }
  };
  run();
  const std::size_t memory = finder.memory();
  run();
  // Pairs and those who leave are not the same number in each frame.
  EXPECT_LE(finder.memory(), memory + memory / 4);
}

}  // namespace
}  // namespace graze
