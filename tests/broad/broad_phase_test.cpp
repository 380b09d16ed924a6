// Every broad phase against all pairs: what is random, crowded, uneven, degenerate, infinite, and what moves, comes and
// goes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <map>
#include <random>

#include "graze/broad_phase.hpp"

namespace graze {
namespace {

enum class Method { sort_and_sweep, sweep_and_prune, hashed_grid, loose_octree, bsp, dynamic_tree };
constexpr Method all_methods[] = {
    Method::sort_and_sweep, Method::sweep_and_prune, Method::hashed_grid, Method::loose_octree, Method::bsp,
    Method::dynamic_tree};

template <class T>
std::unique_ptr<BroadPhase<T>> make(Method method) {
  switch (method) {
  case Method::sort_and_sweep: return make_sort_and_sweep<T>();
  case Method::sweep_and_prune: return make_sweep_and_prune<T>();
  case Method::hashed_grid: return make_hashed_grid<T>();
  case Method::loose_octree: return make_loose_octree<T>();
  case Method::bsp: return make_bsp<T>();
  case Method::dynamic_tree: return make_dynamic_tree<T>();
  }
  return nullptr;
}

/// The slow and obvious way: all pairs.
template <class T>
class AllPairs {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) { boxes_[id] = {box, true}; }
  void move(std::uint32_t id, const Aabb<T>& box) { boxes_[id] = {box, true}; }
  void remove(std::uint32_t id) { boxes_.erase(id); }

  std::vector<IdPair> pairs(bool moved_only) {
    std::vector<IdPair> found;
    for (auto i = boxes_.begin(); i != boxes_.end(); ++i)
      for (auto j = std::next(i); j != boxes_.end(); ++j)
        if ((!moved_only || i->second.moved || j->second.moved) && overlap(i->second.box, j->second.box))
          found.push_back({i->first, j->first});
    for (auto& [id, entry] : boxes_) entry.moved = false;
    return found;
  }
  std::vector<std::uint32_t> query(const Aabb<T>& box) const {
    std::vector<std::uint32_t> found;
    for (const auto& [id, entry] : boxes_)
      if (overlap(entry.box, box)) found.push_back(id);
    return found;
  }
  const Aabb<T>& operator[](std::uint32_t id) const { return boxes_.at(id).box; }
  std::vector<std::uint32_t> ids() const {
    std::vector<std::uint32_t> all;
    for (const auto& [id, entry] : boxes_) all.push_back(id);
    return all;
  }

 private:
  struct Entry {
    Aabb<T> box;
    bool moved = true;
  };
  std::map<std::uint32_t, Entry> boxes_;
};

/// Whether the box, grown by `slack` of all coordinates that take part, touches the other while it moves: the times of
/// contact along each axis, in a wider type than the one under test.
template <class T>
bool touches(const Aabb<T>& box, const Vec3<T>& motion, const Aabb<T>& other, long double slack) {
  long double enter = 0, leave = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto wide = [](T x) { return static_cast<long double>(x); };
    const long double v = wide(motion[i]);
    const auto share = [&](T x) { return std::isfinite(x) ? slack * std::abs(wide(x)) : 0; };
    const long double grown =
        share(box.lower[i]) + share(box.upper[i]) + share(motion[i]) + share(other.lower[i]) + share(other.upper[i]);
    const long double low = wide(other.lower[i]) - wide(box.upper[i]) - grown;
    const long double high = wide(other.upper[i]) - wide(box.lower[i]) + grown;
    if (v == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    enter = std::max(enter, (v > 0 ? low : high) / v);
    leave = std::min(leave, (v > 0 ? high : low) / v);
  }
  return enter <= leave;
}

/// The structure under test and the reference, always told the same.
template <class T>
class Both {
 public:
  explicit Both(Method method) : tested_(make<T>(method)) {}

  void insert(std::uint32_t id, const Aabb<T>& box) {
    tested_->insert(id, box);
    reference_.insert(id, box);
  }
  void move(std::uint32_t id, const Aabb<T>& box) {
    tested_->move(id, box);
    reference_.move(id, box);
  }
  void remove(std::uint32_t id) {
    tested_->remove(id);
    reference_.remove(id);
  }
  void insert_all(const std::vector<Aabb<T>>& boxes) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) insert(i, boxes[i]);
  }

  testing::AssertionResult same_pairs(bool moved_only = false) {
    std::vector<IdPair> found;
    if (moved_only)
      tested_->moved_pairs(found);
    else
      tested_->pairs(found);
    const std::vector<IdPair> expected = reference_.pairs(moved_only);
    if (found == expected) return testing::AssertionSuccess();
    return testing::AssertionFailure() << found.size() << " pairs instead of " << expected.size();
  }
  testing::AssertionResult same_query(const Aabb<T>& box) const {
    std::vector<std::uint32_t> found;
    tested_->query(box, found);
    const auto expected = reference_.query(box);
    if (found == expected) return testing::AssertionSuccess();
    return testing::AssertionFailure() << found.size() << " boxes instead of " << expected.size();
  }
  testing::AssertionResult right_sweep(const Aabb<T>& box, const Vec3<T>& motion) const {
    std::vector<std::uint32_t> found;
    tested_->sweep(box, motion, found);
    if (!std::is_sorted(found.begin(), found.end()) || std::adjacent_find(found.begin(), found.end()) != found.end())
      return testing::AssertionFailure() << "not sorted, or something twice";
    if (motion == Vec3<T>{} && found != reference_.query(box))
      return testing::AssertionFailure() << "without motion not a query";
    for (const std::uint32_t id : reference_.ids()) {
      const bool reported = std::binary_search(found.begin(), found.end(), id);
      if (!reported && touches(box, motion, reference_[id], 0)) return testing::AssertionFailure() << id << " missing";
      if (reported && !touches(box, motion, reference_[id], 1e-5L))
        return testing::AssertionFailure() << id << " too many";
    }
    return testing::AssertionSuccess();
  }
  /// With every box of the scene as the one asked about.
  void expect_right() {
    EXPECT_TRUE(same_pairs());
    for (const std::uint32_t id : reference_.ids()) ASSERT_TRUE(same_query(reference_[id])) << id;
  }

  BroadPhase<T>& tested() { return *tested_; }
  const AllPairs<T>& reference() const { return reference_; }

 private:
  std::unique_ptr<BroadPhase<T>> tested_;
  AllPairs<T> reference_;
};

template <class T>
struct Random {
  std::mt19937 bits{7};

  T operator()(double low, double high) {
    return static_cast<T>(low + (high - low) * static_cast<double>(bits()) / 4294967296.0);
  }
  Vec3<T> point(double range) { return {(*this)(-range, range), (*this)(-range, range), (*this)(-range, range)}; }
  Aabb<T> box(const Vec3<T>& center, double size) {
    const Vec3<T> half{(*this)(0, size), (*this)(0, size), (*this)(0, size)};
    return {center - half, center + half};
  }
};

template <class T>
Aabb<T> shifted(const Aabb<T>& box, const Vec3<T>& by) {
  return {box.lower + by, box.upper + by};
}
template <class T>
Aabb<T> point_box(T x, T y, T z) {
  return {{x, y, z}, {x, y, z}};
}

/// The scenes, by name. All of about `n` boxes.
template <class T>
std::map<std::string, std::vector<Aabb<T>>> scenes(std::size_t n) {
  constexpr T inf = std::numeric_limits<T>::infinity();
  std::map<std::string, std::vector<Aabb<T>>> all;
  Random<T> random;
  const T huge = sizeof(T) == 4 ? T(1e30) : static_cast<T>(1e300);
  for (std::size_t i = 0; i < n; ++i) {
    const T k = static_cast<T>(i);
    all["random"].push_back(random.box(random.point(10), 1));
    all["clustered"].push_back(random.box(random.point(0.3) + Vec3<T>{T(100) * static_cast<T>(i % 5), 0, 0}, 0.05));
    all["uneven"].push_back(random.box(random.point(50), i % 100 == 0 ? 50 : 1));
    all["all scales"].push_back(random.box(random.point(1), std::pow(0.5, static_cast<double>(i % 60))));
    all["points"].push_back(i % 3 == 0 ? point_box<T>(T(1), T(2), T(3)) : Aabb<T>{});
    const Vec3<T> on_lattice{static_cast<T>(i % 7), static_cast<T>(i / 7 % 7), static_cast<T>(i % 3)};
    all["different points"].push_back({on_lattice, on_lattice});
    all["lattice"].push_back({on_lattice, on_lattice + Vec3<T>{T(1), T(1), T(1)}});
    all["flat"].push_back({on_lattice, on_lattice + Vec3<T>{T(i % 2), T(2), T(0)}});
    all["identical"].push_back({{T(-1), T(-2), T(-3)}, {T(1), T(2), T(3)}});
    all["nested"].push_back({{-k, -k, -k}, {k, k, k}});
    all["a line"].push_back({{k, 0, 0}, {k + T(1.5), 1, 1}});
    all["sticks"].push_back({{random(-1, 0), k, 0}, {random(0, 1), k + T(1), 1}});
    all["far away"].push_back(shifted(random.box(random.point(10), 1), {T(1e6), T(-1e6), T(1e5)}));
    // Near zero, and some where a coordinate times another overflows.
    all["outliers"].push_back(random.box(random.point(i % 20 == 0 ? static_cast<double>(huge) : 1.0), 0.1));
    all["huge"].push_back(random.box(random.point(1) * huge, 0.2 * static_cast<double>(huge)));
    all["tiny"].push_back(random.box(random.point(1) * (T(1) / huge), 0.2 / static_cast<double>(huge)));
    Aabb<T> open = random.box(random.point(10), 1);
    if (i % 4 == 0) open.upper[i / 4 % 3] = inf;
    if (i % 5 == 0) open.lower[i / 5 % 3] = -inf;
    if (i % 50 == 0) open = Aabb<T>::everything();
    if (i % 50 == 1) open = point_box<T>(inf, T(0), -inf);
    all["infinite"].push_back(open);
  }
  constexpr T most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::denorm_min();
  for (std::size_t i = 0; i < n / 2; ++i) {
    all["largest numbers"].push_back(point_box<T>(i % 2 == 0 ? most : -most, most / T(i + 1), most));
    all["smallest numbers"].push_back(point_box<T>(least * T(i % 5), least, i % 2 == 0 ? least : -least));
  }
  return all;
}

template <class T>
class EveryBroadPhase : public testing::Test {
 protected:
  static void for_each_method(const std::function<void(Method)>& check) {
    for (const Method method : all_methods) {
      SCOPED_TRACE(static_cast<int>(method));
      check(method);
    }
  }
};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryBroadPhase, Scalars);

TYPED_TEST(EveryBroadPhase, FindsAllPairsOfEveryScene) {
  using T = TypeParam;
  for (const auto& [name, boxes] : scenes<T>(300)) {
    SCOPED_TRACE(name);
    this->for_each_method([&boxes = boxes](Method method) {
      Both<T> both(method);
      both.insert_all(boxes);
      both.expect_right();
    });
  }
}

TYPED_TEST(EveryBroadPhase, AnswersQueriesThatTakeInNothingOrEverything) {
  using T = TypeParam;
  constexpr T inf = std::numeric_limits<T>::infinity();
  for (const auto& [name, boxes] : scenes<T>(100)) {
    SCOPED_TRACE(name);
    this->for_each_method([&boxes = boxes](Method method) {
      Both<T> both(method);
      EXPECT_TRUE(both.same_query({}));  // before anything is there
      both.insert_all(boxes);
      for (const Aabb<T>& box : {Aabb<T>::everything(), Aabb<T>{}, Aabb<T>{{T(-3), -inf, T(0)}, {T(4), T(0), inf}},
                                 point_box<T>(inf, inf, inf), Aabb<T>{{T(-5), T(-5), T(-5)}, {T(5), T(5), T(5)}}})
        EXPECT_TRUE(both.same_query(box));
    });
  }
}

TYPED_TEST(EveryBroadPhase, FollowsWhatMovesComesAndGoes) {
  using T = TypeParam;
  for (const char* name : {"random", "clustered", "uneven", "flat", "identical", "infinite", "outliers"}) {
    SCOPED_TRACE(name);
    const std::vector<Aabb<T>> boxes = scenes<T>(400)[name];
    this->for_each_method([&](Method method) {
      Random<T> random;
      Both<T> both(method);
      both.insert_all(boxes);
      std::uint32_t next_id = 1000;
      for (int frame = 0; frame < 30; ++frame) {
        // From few to all of them, by little or, now and then, to anywhere.
        const std::uint32_t one_in = frame % 3 == 0 ? 1u : frame % 3 == 1 ? 7u : 40u;
        for (const std::uint32_t id : both.reference().ids()) {
          if (random.bits() % one_in == 0)
            both.move(id, shifted(both.reference()[id], random.point(random.bits() % 50 == 0 ? 20 : 0.05)));
          if (random.bits() % 100 == 0) {
            both.remove(id);
            both.insert(random.bits() % 2 == 0 ? id : next_id++, random.box(random.point(10), 1));
          }
        }
        if (frame % 10 == 5) both.remove(both.reference().ids().back());
        ASSERT_TRUE(both.same_pairs(frame % 4 != 3)) << frame;
        ASSERT_TRUE(both.same_query(random.box(random.point(10), 3))) << frame;
      }
      for (const std::uint32_t id : both.reference().ids()) both.remove(id);
      ASSERT_TRUE(both.same_pairs());
      both.insert_all(boxes);
      ASSERT_TRUE(both.same_pairs());
    });
  }
}

/// Few enough changes for sweep and prune to sort in and not anew.
TYPED_TEST(EveryBroadPhase, FollowsOneBoxAmongMany) {
  using T = TypeParam;
  const std::vector<Aabb<T>> boxes = scenes<T>(600)["random"];
  this->for_each_method([&](Method method) {
    Random<T> random;
    Both<T> both(method);
    both.insert_all(boxes);
    ASSERT_TRUE(both.same_pairs());
    ASSERT_TRUE(both.same_pairs(true));  // none: nothing moved
    both.insert(5000, Aabb<T>::everything());
    ASSERT_TRUE(both.same_pairs(true));
    for (std::uint32_t frame = 0; frame < 20; ++frame) {
      both.remove(frame * 3);
      both.insert(frame % 2 == 0 ? frame * 3 : 9000 + frame, random.box(random.point(10), 1));
      both.move(frame * 3 + 1, random.box(random.point(10), 1));
      ASSERT_TRUE(both.same_pairs(frame % 3 != 0)) << frame;
    }
  });
}

/// They stay one and the same function of the boxes, however those came about: here by a way round far places.
TYPED_TEST(EveryBroadPhase, ForgetsWhereBoxesHaveBeen) {
  using T = TypeParam;
  const auto all = scenes<T>(200);
  for (const char* name : {"outliers", "huge", "tiny", "points", "a line", "infinite"}) {
    SCOPED_TRACE(name);
    this->for_each_method([&](Method method) {
      Both<T> both(method);
      both.insert_all(all.at("random"));
      ASSERT_TRUE(both.same_pairs());
      for (std::uint32_t i = 0; i < 200; ++i) both.move(i, all.at(name)[i]);
      ASSERT_TRUE(both.same_pairs());
      for (std::uint32_t i = 0; i < 200; ++i) both.move(i, all.at("clustered")[i]);
      both.expect_right();
    });
  }
}

TYPED_TEST(EveryBroadPhase, SweepsAndCastsRays) {
  using T = TypeParam;
  for (const char* name : {"random", "clustered", "uneven", "all scales", "lattice", "flat", "far away", "infinite"}) {
    SCOPED_TRACE(name);
    const std::vector<Aabb<T>> boxes = scenes<T>(300)[name];
    this->for_each_method([&](Method method) {
      Random<T> random;
      Both<T> both(method);
      both.insert_all(boxes);
      const Vec3<T> around = name == std::string("far away") ? Vec3<T>{T(1e6), T(-1e6), T(1e5)} : Vec3<T>{};
      for (int i = 0; i < 60; ++i) {
        const Aabb<T> box = random.box(around + random.point(10), i % 2 == 0 ? 0.0 : 1.0);
        Vec3<T> motion = random.point(i % 3 == 0 ? 0.5 : i % 3 == 1 ? 20 : 1000);
        if (i % 4 == 1) motion[static_cast<std::size_t>(i / 4 % 3)] = T(0);
        if (i % 20 == 7) motion = {};
        ASSERT_TRUE(both.right_sweep(box, motion)) << i;
      }
      // Along the lattice, where everything only touches.
      ASSERT_TRUE(both.right_sweep({}, {T(5), T(0), T(0)}));
      ASSERT_TRUE(both.right_sweep({{0, 0, 0}, {1, 1, 1}}, {T(-5), T(5), T(5)}));
      ASSERT_TRUE(both.right_sweep(Aabb<T>::everything(), {T(1), T(0), T(0)}));
    });
  }
}

/// All of them report the same, rounding included.
TYPED_TEST(EveryBroadPhase, SweepsAlike) {
  using T = TypeParam;
  for (const auto& [name, boxes] : scenes<T>(200)) {
    SCOPED_TRACE(name);
    std::vector<std::vector<std::uint32_t>> expected;
    this->for_each_method([&expected, &boxes = boxes](Method method) {
      const auto broad = make<T>(method);
      for (std::uint32_t i = 0; i < boxes.size(); ++i) broad->insert(i, boxes[i]);
      std::vector<std::vector<std::uint32_t>> found;
      for (std::size_t i = 0; i + 1 < boxes.size(); i += 3) {
        const Vec3<T> motion = boxes[i + 1].lower - boxes[i].lower;
        if (!(max_abs(motion) <= std::numeric_limits<T>::max())) continue;
        broad->sweep(boxes[i], motion, found.emplace_back());
      }
      if (expected.empty()) expected = found;
      EXPECT_EQ(found, expected);
    });
  }
}

TYPED_TEST(EveryBroadPhase, RefusesWhatIsWrong) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const Aabb<T> unit{{0, 0, 0}, {1, 1, 1}};
  this->for_each_method([&](Method method) {
    Both<T> both(method);
    both.insert(4000000000u, unit);
    EXPECT_THROW(both.tested().insert(4000000000u, unit), InvalidValue);
    EXPECT_THROW(both.tested().remove(2), InvalidValue);
    EXPECT_THROW(both.tested().move(2, unit), InvalidValue);
    for (std::size_t i = 0; i < 3; ++i) {
      Aabb<T> wrong = unit;
      wrong.lower[i] = nan;
      EXPECT_THROW(both.tested().insert(2, wrong), InvalidValue);
      EXPECT_THROW(both.tested().move(4000000000u, wrong), InvalidValue);
    }
    EXPECT_THROW(both.tested().insert(2, Aabb<T>::empty()), InvalidValue);
    // And is as it was.
    both.insert(2, unit);
    both.expect_right();
  });
}

TYPED_TEST(EveryBroadPhase, TellsItsMemory) {
  using T = TypeParam;
  this->for_each_method([&](Method method) {
    for (const auto& [name, boxes] : scenes<T>(200)) {
      Both<T> both(method);
      both.insert_all(boxes);
      EXPECT_TRUE(both.same_pairs());
      EXPECT_GT(both.tested().memory(), boxes.size() * sizeof(Aabb<T>)) << name;
      EXPECT_LT(both.tested().memory(), boxes.size() * 10000) << name;
    }
  });
}

// Whatever the structure, a box meets a part of it, and a part lies in one of the level above.
TYPED_TEST(EveryBroadPhase, ShowsItsParts) {
  using T = TypeParam;
  const auto all = scenes<T>(200);
  this->for_each_method([&](Method method) {
    const bool sorts = method == Method::sort_and_sweep || method == Method::sweep_and_prune;
    std::vector<BroadPhasePart<T>> parts(3);
    make<T>(method)->parts(parts);
    EXPECT_TRUE(parts.empty());
    for (const char* const name : {"random", "clustered", "lattice"}) {
      SCOPED_TRACE(name);
      const std::vector<Aabb<T>>& boxes = all.at(name);
      Both<T> both(method);
      both.insert_all(boxes);
      both.tested().parts(parts);
      EXPECT_EQ(parts.empty(), sorts);
      if (sorts) continue;
      EXPECT_EQ(parts.front().depth, 0u);
      const auto outside = std::count_if(boxes.begin(), boxes.end(), [&](const Aabb<T>& box) {
        return std::none_of(parts.begin(), parts.end(), [&](const auto& p) { return overlap(p.box, box); });
      });
      // The outermost cells of an octree have what lies outside of it, which is little.
      EXPECT_LE(outside, method == Method::loose_octree ? static_cast<long>(boxes.size() / 4) : 0);
      const Aabb<T>& root = parts.front().box;
      const T slack = T(1e-5) * length(root.extent());
      for (std::size_t i = 0; i < parts.size(); ++i)
        EXPECT_TRUE(parts[i].depth == 0 ||
                    std::any_of(parts.begin(), parts.begin() + static_cast<long>(i), [&](auto& p) {
                      const Aabb<T> around = inflated(p.box, slack);
                      return p.depth + 1 == parts[i].depth && merged(around, parts[i].box) == around;
                    }));
      if (method == Method::bsp || method == Method::dynamic_tree) {
        for (const Aabb<T>& box : boxes) EXPECT_EQ(merged(root, box), root);
      }
      both.move(0, shifted(boxes[0], Vec3<T>{T(100), T(0), T(0)}));
      both.tested().parts(parts);
      EXPECT_TRUE(
          std::any_of(parts.begin(), parts.end(), [&](const auto& p) { return overlap(p.box, both.reference()[0]); }) ||
          method == Method::loose_octree);
    }
  });
}

/// Small numbers, so that equal, touching, flat and nested boxes are common; RapidCheck makes a failure small.
/// The slow way compares n (n - 1) / 2 boxes; every structure compares at least what it reports, and few of a line.
TYPED_TEST(EveryBroadPhase, CountsTheBoxesThatItCompares) {
  using T = TypeParam;
  constexpr std::uint64_t n = 300, all = n * (n - 1) / 2;
  this->for_each_method([&](Method method) {
    std::vector<IdPair> found;
    const auto of_line = [&](T step) {
      const auto tested = make<T>(method);
      EXPECT_EQ(tested->tests(), 0u);
      for (std::uint32_t i = 0; i < n; ++i)
        tested->insert(i, {{T(i) * step, T(0), T(0)}, {T(i) * step + T(1), T(1), T(1)}});
      tested->pairs(found);
      return tested->tests();
    };
    // Each touches the next.
    const std::uint64_t touching = of_line(T(1));
    EXPECT_EQ(found.size(), n - 1);
    EXPECT_GE(touching, found.size());
    EXPECT_LT(touching, all / 5);
    EXPECT_LT(of_line(T(100)), all / 5);  // far from each other
    EXPECT_EQ(found.size(), 0u);
    EXPECT_GE(of_line(T(0)), all);  // all in one place
    EXPECT_EQ(found.size(), all);
  });
}

TEST(BroadPhaseTests, OfASortedAxisAreThoseThatOverlapOnIt) {
  const auto sweep = make_sort_and_sweep<double>();
  for (std::uint32_t i = 0; i < 8; ++i) sweep->insert(i, {{10.0 * i, 0, 0}, {10.0 * i + 1, 1, 1}});
  std::vector<IdPair> found;
  sweep->insert(8, {{10.5, 5, 0}, {20.5, 6, 1}});  // with two of them, but for the other axis
  sweep->pairs(found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(sweep->tests(), 2u);
}

/// Pairs are kept by these: where nothing moves, nothing is compared.
TEST(BroadPhaseTests, AreNoneWhereNothingMoved) {
  for (const Method method : {Method::sweep_and_prune, Method::dynamic_tree}) {
    const auto tested = make<double>(method);
    for (std::uint32_t i = 0; i < 100; ++i) tested->insert(i, {{0.5 * i, 0, 0}, {0.5 * i + 1, 1, 1}});
    std::vector<IdPair> found;
    tested->pairs(found);
    const std::uint64_t first = tested->tests();
    EXPECT_GE(first, found.size());
    tested->moved_pairs(found);
    EXPECT_EQ(tested->tests(), 0u);
    tested->move(3, {{1.6, 0, 0}, {2.6, 1, 1}});
    tested->moved_pairs(found);
    EXPECT_GE(tested->tests(), 1u);
    EXPECT_LT(tested->tests(), first / 4);
  }
}

Aabbd box_of(const std::array<int, 6>& n) {
  const auto low = [&](std::size_t i) { return static_cast<double>(n[i] % 20); };
  const auto size = [&](std::size_t i) { return static_cast<double>(std::abs(n[i + 3] % 5)); };
  return {{low(0), low(1), low(2)}, {low(0) + size(0), low(1) + size(1), low(2) + size(2)}};
}

RC_GTEST_PROP(BroadPhases, AgreeAfterAnySteps,
              (const std::vector<std::pair<std::uint8_t, std::array<int, 6>>>& steps)) {
  for (const Method method : all_methods) {
    Both<double> both(method);
    for (const auto& [code, numbers] : steps) {
      const std::uint32_t id = code % 32u;
      const auto ids = both.reference().ids();
      const bool there = std::binary_search(ids.begin(), ids.end(), id);
      if (!there)
        both.insert(id, box_of(numbers));
      else if (code < 64)
        both.remove(id);
      else
        both.move(id, box_of(numbers));
      if (code % 3 == 0) RC_ASSERT(both.same_pairs(code % 2 == 0));
      RC_ASSERT(both.same_query(box_of(numbers)));
    }
    RC_ASSERT(both.same_pairs());
  }
}

RC_GTEST_PROP(BroadPhases, SweepRight,
              (const std::vector<std::array<int, 6>>& numbers, const std::array<int, 6>& mover,
               const std::array<int, 3>& motion)) {
  for (const Method method : all_methods) {
    Both<double> both(method);
    for (std::uint32_t i = 0; i < numbers.size(); ++i) both.insert(i, box_of(numbers[i]));
    const auto v = [&](std::size_t i) { return static_cast<double>(motion[i] % 30); };
    RC_ASSERT(both.right_sweep(box_of(mover), {v(0), v(1), v(2)}));
  }
}

}  // namespace
}  // namespace graze
