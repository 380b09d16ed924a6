// Contacts of a batch whole and in few bytes, on one thread.
//
//   bench_compact_contacts [--pairs N] [--rounds N] [--only REGEX]
//
// Pairs of sizes from 0.2 to 1, about half of which overlap, in arrays of one kind. Each round asks about all pairs in
// either form: told are nanoseconds of the processor's time for a pair, by the median round, how many times as long
// whole contacts take, and the bytes that a pair has on average in either form.
#include <cstdio>
#include <regex>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "graze/batch.hpp"
#include "graze_shape.hpp"
#include "judges.hpp"
#include "measure.hpp"
#include "pairs.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

struct Options {
  std::size_t pairs = 40'000, rounds = 25;
  std::string only = ".*";
};

/// The `i`-th bodies of both sides are a pair.
template <class A, class B, class T>
struct Sides {
  std::vector<A> a;
  std::vector<B> b;
  std::vector<Pose<T>> poses_a, poses_b;

  explicit Sides(const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) {
      a.push_back(*graze_shape<T>(pair.a).template as<A>());
      b.push_back(*graze_shape<T>(pair.b).template as<B>());
      poses_a.push_back(converted<T>(pair.a.pose));
      poses_b.push_back(converted<T>(pair.b.pose));
    }
  }
  Batch<T> batch() const { return {Bodies<T>(a, poses_a), Bodies<T>(b, poses_b)}; }
};

/// Nanoseconds a pair. The answers are gone through once: a sum keeps the compiler from leaving any out.
template <class T, class Found>
double nanoseconds_of(const Batch<T>& batch, T margin, Found& found, double& sum) {
  const double start = processor_seconds();
  contacts(batch, margin, found);
  for (const auto& point : found.points) sum += static_cast<double>(point.distance);
  return (processor_seconds() - start) * 1e9 / static_cast<double>(batch.size());
}

template <class Record>
std::size_t bytes(const std::vector<Record>& array) {
  return array.size() * sizeof(Record);
}

template <class A, class B, class T>
void race(const std::string& name, const std::vector<Pair>& pairs, T margin, std::size_t rounds, Table& table) {
  const Sides<A, B, T> sides(pairs);
  const Batch<T> batch = sides.batch();
  BatchContacts<T> whole;
  CompactContacts<T> compact;
  double sum = 0;
  std::vector<double> of_whole, of_compact, ratio;
  nanoseconds_of(batch, margin, whole, sum);
  nanoseconds_of(batch, margin, compact, sum);
  for (std::size_t round = 0; round < rounds; ++round) {
    of_whole.push_back(nanoseconds_of(batch, margin, whole, sum));
    of_compact.push_back(nanoseconds_of(batch, margin, compact, sum));
    ratio.push_back(of_whole.back() / of_compact.back());
  }
  const auto a_pair = [&](std::size_t all) {
    return printed("%.0f", static_cast<double>(all) / static_cast<double>(batch.size()));
  };
  table.add({name, std::is_same_v<T, float> ? "float" : "double", nanoseconds(quantile(of_whole, 0.5)),
             nanoseconds(quantile(of_compact, 0.5)), printed("%.2f", quantile(ratio, 0.5)),
             a_pair(bytes(whole.pairs) + bytes(whole.manifolds) + bytes(whole.points)),
             a_pair(bytes(compact.manifolds) + bytes(compact.points))});
}

template <template <class> class A, template <class> class B, class Make>
void race(const std::string& name, const Make& make, const Options& options, Table& table) {
  if (!std::regex_search(name, std::regex(options.only))) return;
  const std::vector<Pair> pairs = make(options.pairs);
  constexpr double margin = 0.02;
  race<A<float>, B<float>, float>(name, pairs, static_cast<float>(margin), options.rounds, table);
  race<A<double>, B<double>, double>(name, pairs, margin, options.rounds, table);
}

int run(int argc, char** argv) {
  Options options;
  CommandLine("Contacts of a batch whole and in few bytes, on one thread.")
      .number("--pairs", options.pairs, "pairs of two kinds")
      .number("--rounds", options.rounds, "of which the median is taken")
      .expression("--only", options.only, "only rows whose names match, e.g. 'box-box'")
      .read(argc, argv);
  Table table({"ns a pair", "scalar", "whole", "compact", "whole / compact", "bytes whole", "bytes compact"}, 2);
  const auto random = [](Kind a, Kind b) {
    return [a, b](std::size_t count) { return make_pairs(a, b, count, 1, make_touching()); };
  };
  race<Sphere, Sphere>("sphere-sphere", random(Kind::sphere, Kind::sphere), options, table);
  race<Sphere, Box>("sphere-box", random(Kind::sphere, Kind::box), options, table);
  race<Capsule, Capsule>("capsule-capsule", random(Kind::capsule, Kind::capsule), options, table);
  race<Box, Box>("box-box", random(Kind::box, Kind::box), options, table);
  race<Box, Box>("box-box stacked", make_stacked, options, table);
  race<Box, Triangle>("box-triangle", random(Kind::box, Kind::triangle), options, table);
  std::fputs(table.text().c_str(), stdout);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
