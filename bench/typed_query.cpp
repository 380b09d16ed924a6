// One pair at a time, asked as shapes of any kind and by callers who know their kinds, on one thread.
//
//   bench_typed_query [--pairs N] [--rounds N] [--only REGEX]
//
// Pairs of sizes from 0.2 to 1, about half of which overlap, at poses of their own. Each round asks all pairs as shapes
// and then by their kinds: told are nanoseconds of the processor's time for a pair, by the median round, and how many
// times as long the general question takes.
#include <cstdio>
#include <regex>
#include <string>
#include <type_traits>
#include <vector>

#include "command_line.hpp"
#include "graze/query.hpp"
#include "graze/typed_query.hpp"
#include "graze_shape.hpp"
#include "judges.hpp"
#include "measure.hpp"
#include "pairs.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

struct Options {
  std::size_t pairs = 10'000, rounds = 25;
  std::string only = ".*";
};

/// A pair as its user holds it who knows its kinds.
template <class A, class B, class T>
struct Known {
  A a;
  Pose<T> pose_a;
  B b;
  Pose<T> pose_b;
};

/// Nanoseconds a pair; the sum of the answers keeps the compiler from leaving any out.
template <class Ask>
double nanoseconds_of(std::size_t count, double& sum, const Ask& ask) {
  const double start = processor_seconds();
  for (std::size_t i = 0; i < count; ++i) sum += ask(i);
  return (processor_seconds() - start) * 1e9 / static_cast<double>(count);
}

template <class T>
double deepest(const Vec3<T>& normal, const auto& points) {
  double least = static_cast<double>(normal.x);
  for (const ContactPoint<T>& point : points) least = std::min(least, static_cast<double>(point.distance));
  return least;
}

template <class A, class B, class T>
class Race {
 public:
  Race(const std::vector<Pair>& pairs, std::size_t rounds) : rounds_(rounds) {
    for (const Pair& pair : pairs) {
      shapes_.push_back({graze_shape<T>(pair.a), converted<T>(pair.a.pose)});
      shapes_.push_back({graze_shape<T>(pair.b), converted<T>(pair.b.pose)});
      const Placed<T>&a = shapes_[shapes_.size() - 2], &b = shapes_.back();
      known_.push_back({*a.shape.template as<A>(), a.pose, *b.shape.template as<B>(), b.pose});
    }
  }

  void run(Table& table) {
    tell(
        table, "overlap",
        [](const Placed<T>& a, const Placed<T>& b) { return overlap(a.shape, a.pose, b.shape, b.pose) ? 1.0 : 0.0; },
        [](const auto& k) { return overlap(k.a, k.pose_a, k.b, k.pose_b) ? 1.0 : 0.0; });
    tell(
        table, "distance",
        [](const Placed<T>& a, const Placed<T>& b) {
          return static_cast<double>(distance(a.shape, a.pose, b.shape, b.pose).distance);
        },
        [](const auto& k) { return static_cast<double>(distance(k.a, k.pose_a, k.b, k.pose_b).distance); });
    Manifolds<T> manifolds;
    tell(
        table, "contacts",
        [&](const Placed<T>& a, const Placed<T>& b) {
          manifolds.clear();
          contacts(a.shape, a.pose, b.shape, b.pose, margin, manifolds);
          return manifolds.empty() ? 0.0 : deepest(manifolds[0].normal, manifolds[0].points);
        },
        [](const auto& k) {
          const auto found = contacts(k.a, k.pose_a, k.b, k.pose_b, margin);
          return found.points.empty() ? 0.0 : deepest(found.normal, found.points);
        });
  }

 private:
  static constexpr T margin = T(0.02);

  template <class AskShapes, class AskKinds>
  void tell(Table& table, const char* query, const AskShapes& ask_shapes, const AskKinds& ask_kinds) {
    std::vector<double> general, typed, ratio;
    for (std::size_t round = 0; round < rounds_; ++round) {
      general.push_back(nanoseconds_of(known_.size(), sum_,
                                       [&](std::size_t i) { return ask_shapes(shapes_[2 * i], shapes_[2 * i + 1]); }));
      typed.push_back(nanoseconds_of(known_.size(), sum_, [&](std::size_t i) { return ask_kinds(known_[i]); }));
      ratio.push_back(general.back() / typed.back());
    }
    table.add({std::string(A::name) + "-" + B::name + " " + query, std::is_same_v<T, float> ? "float" : "double",
               nanoseconds(quantile(general, 0.5)), nanoseconds(quantile(typed, 0.5)),
               printed("%.2f", quantile(ratio, 0.5))});
  }

  std::size_t rounds_;
  std::vector<Placed<T>> shapes_;
  std::vector<Known<A, B, T>> known_;
  double sum_ = 0;
};

template <template <class> class A, template <class> class B>
void race(Kind a, Kind b, const Options& options, Table& table) {
  const std::string name = std::string(A<float>::name) + "-" + B<float>::name;
  if (!std::regex_search(name, std::regex(options.only))) return;
  const std::vector<Pair> pairs = make_pairs(a, b, options.pairs, 1, make_touching());
  Race<A<float>, B<float>, float>(pairs, options.rounds).run(table);
  Race<A<double>, B<double>, double>(pairs, options.rounds).run(table);
}

int run(int argc, char** argv) {
  Options options;
  CommandLine("One pair at a time, asked as shapes of any kind and by callers who know their kinds, on one thread.")
      .number("--pairs", options.pairs, "pairs of two kinds")
      .number("--rounds", options.rounds, "of which the median is taken")
      .expression("--only", options.only, "only pairs whose names match, e.g. 'sphere-box'")
      .read(argc, argv);
  Table table({"ns a pair", "scalar", "as shapes", "by kind", "shapes / kind"}, 2);
  race<Sphere, Sphere>(Kind::sphere, Kind::sphere, options, table);
  race<Sphere, Capsule>(Kind::sphere, Kind::capsule, options, table);
  race<Sphere, Box>(Kind::sphere, Kind::box, options, table);
  race<Sphere, Triangle>(Kind::sphere, Kind::triangle, options, table);
  race<Capsule, Capsule>(Kind::capsule, Kind::capsule, options, table);
  race<Capsule, Box>(Kind::capsule, Kind::box, options, table);
  race<Capsule, Triangle>(Kind::capsule, Kind::triangle, options, table);
  race<Box, Box>(Kind::box, Kind::box, options, table);
  std::fputs(table.text().c_str(), stdout);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
