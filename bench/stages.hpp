// The stages of a world's update, each by itself, in the order in which `World` runs them.
#pragma once

#include <array>
#include <vector>

#include "graze/world.hpp"

namespace graze::bench {

template <class T>
class Stages {
 public:
  /// Sorting pairs into bins is a part of the manifolds' stage: it is run once more by itself.
  static constexpr const char* names[] = {"bounds",    "candidates", "filter", "bins (in manifolds)",
                                          "manifolds", "events"};
  static constexpr std::size_t count = 6;
  /// In milliseconds, by the clock it was given.
  using Times = std::array<double, count>;

  /// `clock` tells the time in seconds.
  Stages(Executor& executor, double (*clock)(), std::optional<T> margin = {})
      : executor_(executor), clock_(clock), bodies_(margin) {}

  BodyId add(graze::Body<T> body) { return bodies_.add(std::move(body)); }
  void move(BodyId id, const Pose<T>& pose) { bodies_.move(id, pose, {}, {}); }

  /// Finds what touches now and returns how long each stage took.
  Times update() {
    Times times{};
    std::size_t stage = 0;
    const auto timed = [&](const auto& work) {
      const double begin = clock_();
      work();
      times[stage++] = 1e3 * (clock_() - begin);
    };
    const auto changes = bodies_.changes();
    boxes_.resize(bodies_.size());
    std::span<const IdPair> found;
    timed([&] { find_bounds<T>(bodies_.shapes(), bodies_.poses(), bodies_.margins(), changes, boxes_, executor_); });
    timed([&] { found = candidates_.find(boxes_, bodies_.alive(), bodies_.fixed(), changes, executor_); });
    timed([&] {
      allowed_.assign(found.begin(), found.end());
      keep_allowed(allowed_, bodies_.filters(), [&](std::uint32_t a, std::uint32_t b) {
        return bodies_.fixed()[a] == 0 || bodies_.fixed()[b] == 0;
      });
    });
    timed([&] { bin_pairs<T>(allowed_, bodies_.shapes(), bins_); });
    timed([&] { manifolds_.find(bodies_, allowed_, executor_); });
    timed([&] { tracker_.update<T>(bodies_, manifolds_.contacts().pairs); });
    bodies_.settle();
    return times;
  }
  std::size_t pairs() const { return allowed_.size(); }

 private:
  Executor& executor_;
  double (*clock_)();
  BodyArrays<T> bodies_;
  std::vector<Aabb<T>> boxes_;
  CandidateFinder<T> candidates_;
  std::vector<IdPair> allowed_;
  Bins bins_;
  ManifoldFinder<T> manifolds_;
  EventTracker tracker_;
};

}  // namespace graze::bench
