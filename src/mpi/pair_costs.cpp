#include "mpi/pair_costs.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <limits>

namespace graze::mpi {

namespace {

/// The cost of a body in an update besides its pairs: the median of balls and boxes of a lattice. On a machine that is
/// twice as slow pairs weigh twice as much; they are where bodies are anyway.
constexpr double seconds_of_body = 50e-9;
/// The seconds of a pair of a kind that was never measured: those of balls or of boxes.
constexpr double seconds_of_usual_pair = 100e-9;
/// The costs of a pair that is nothing beside a body, and of one that is an update by itself: bounds for clocks
/// that stand still or jump.
constexpr double least_cost = 0.1, most_cost = 1e6;

/// The pairs of a kind that are measured: as many as a kernel takes at a time.
constexpr std::size_t pairs_of_sample = 256;
/// Updates after which a kind is measured anew: costs follow what bodies do, by and by.
constexpr std::uint64_t updates_per_measurement = 64;

/// A number above all numbers of types in `ShapeList`.
constexpr std::size_t types = 32;
static_assert(Shape<float>::count <= types);

template <class T>
PairCosts::Kind kind_of(const Shape<T>& shape) {
  const std::size_t corners = shape.visit([](const auto& c) -> std::size_t {
    if constexpr (std::is_same_v<std::decay_t<decltype(c)>, ConvexHull<T>>) return c.data().vertices.size();
    return 0;
  });
  return static_cast<PairCosts::Kind>(shape.index() + types * static_cast<std::size_t>(std::bit_width(corners)));
}

/// Some of the pairs with bodies of their own.
template <class T>
struct Sample {
  Sample(const BodyArrays<T>& all, std::span<const IdPair> some) {
    std::vector<std::uint32_t> used;
    for (const IdPair& p : some) {
      used.push_back(p.a);
      used.push_back(p.b);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t i : used) bodies.add(all.body(all.id(i)));
    const auto place = [&](std::uint32_t i) {
      return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), i) - used.begin());
    };
    for (const IdPair& p : some) pairs.push_back({place(p.a), place(p.b)});
    std::sort(pairs.begin(), pairs.end());
  }

  /// The seconds of a pair: the better of two times, since the first also fetches memory that was not used for long.
  double seconds() const {
    using Clock = std::chrono::steady_clock;
    double best = std::numeric_limits<double>::infinity();
    SerialExecutor serial;
    for (int i = 0; i < 2; ++i) {
      ManifoldFinder<T> finder;
      const Clock::time_point begin = Clock::now();
      finder.find(bodies, pairs, serial);
      best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    return best / static_cast<double>(pairs.size());
  }

  BodyArrays<T> bodies;
  std::vector<IdPair> pairs;
};

}  // namespace

template <class T>
PairCosts::Bodies PairCosts::kinds_of(const BodyArrays<T>& bodies, std::span<const IdPair> pairs) {
  constexpr std::uint8_t none = std::numeric_limits<std::uint8_t>::max();
  Bodies out;
  out.of.assign(bodies.size(), none);
  const auto look_at = [&](std::uint32_t i) {
    if (out.of[i] != none) return;
    const Kind kind = kind_of(bodies.shapes()[i]);
    auto found = std::find(out.kinds.begin(), out.kinds.end(), kind);
    if (found == out.kinds.end() && out.kinds.size() < none) found = out.kinds.insert(found, kind);
    // Kinds beyond the largest number, if there ever are so many, count as the last one.
    out.of[i] = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(found - out.kinds.begin(), none - 1));
  };
  for (const IdPair& p : pairs) {
    look_at(p.a);
    look_at(p.b);
  }
  return out;
}

template <class T>
void PairCosts::measure(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, const Bodies& kinds) {
  const std::size_t n = kinds.kinds.size();
  const std::vector<std::uint8_t> due = due_of(kinds.kinds);
  if (std::find(due.begin(), due.end(), 1) == due.end()) return;
  std::vector<std::size_t> counts(n * n), seen(n * n);
  for (const IdPair& p : pairs) ++counts[kinds.of_pair(p)];
  std::map<Pair, std::vector<IdPair>> samples;
  for (const IdPair& p : pairs) {
    const std::size_t kind = kinds.of_pair(p);
    if (due[kind] == 0 || seen[kind]++ % (counts[kind] / pairs_of_sample + 1) != 0) continue;
    samples[ordered(kinds.kinds[kinds.of[p.a]], kinds.kinds[kinds.of[p.b]])].push_back(p);
  }
  for (const auto& [pair, some] : samples) note(pair.first, pair.second, Sample<T>(bodies, some).seconds());
}

bool PairCosts::is_due(Kind a, Kind b) const {
  if (news_.contains(ordered(a, b))) return false;
  const auto known = known_.find(ordered(a, b));
  return known == known_.end() || updates_ >= known->second.update + updates_per_measurement;
}

std::vector<std::uint8_t> PairCosts::due_of(const std::vector<Kind>& kinds) const {
  std::vector<std::uint8_t> due;
  for (const Kind a : kinds)
    for (const Kind b : kinds) due.push_back(is_due(a, b) ? 1 : 0);
  return due;
}

float PairCosts::of(Kind a, Kind b) const {
  double seconds = seconds_of_usual_pair;
  if (const auto known = known_.find(ordered(a, b)); known != known_.end()) seconds = known->second.seconds;
  return static_cast<float>(std::clamp(seconds / seconds_of_body, least_cost, most_cost));
}

std::vector<float> PairCosts::table_of(const std::vector<Kind>& kinds) const {
  std::vector<float> table;
  for (const Kind a : kinds)
    for (const Kind b : kinds) table.push_back(of(a, b));
  return table;
}

void PairCosts::share(Together& together) {
  ++updates_;
  int news = news_.empty() ? 0 : 1;
  MPI_Allreduce(MPI_IN_PLACE, &news, 1, MPI_INT, MPI_MAX, together.comm());
  if (news == 0) return;
  struct Told {
    Kind a, b;
    double seconds;
  };
  ByRank<Told> to = together.nothing<Told>();
  together.alone([&] {
    for (const auto& [pair, seconds] : news_)
      for (std::vector<Told>& mine : to) mine.push_back({pair.first, pair.second, seconds});
  });
  const ByRank<Told> from = together.exchange(to);
  together.alone([&] {
    std::map<Pair, std::vector<double>> told;
    for (const std::vector<Told>& some : from)
      for (const Told& t : some) told[{t.a, t.b}].push_back(t.seconds);
    // The median: one rank that was held up while it measured changes nothing where there are three.
    for (auto& [pair, seconds] : told) {
      const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>((seconds.size() - 1) / 2);
      std::nth_element(seconds.begin(), middle, seconds.end());
      known_[pair] = {*middle, updates_};
    }
    news_.clear();
  });
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template PairCosts::Bodies PairCosts::kinds_of(const BodyArrays<T>&, std::span<const IdPair>);                       \
  template void PairCosts::measure(const BodyArrays<T>&, std::span<const IdPair>, const PairCosts::Bodies&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::mpi
