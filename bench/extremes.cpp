// How often answers to hard pairs are wrong: of extreme ratios of size, concentric, nearly identical, nearly touching.
//
//   bench_extremes [--pairs N] [--only REGEX] [--seed N] [--cases N]
//
// Writes Markdown: for each two kinds and each precision the largest error of an answer that says it is proven
// (`Status::converged`), how many of those are off by more than their tolerance, how many of shapes that are apart are
// off by more than that of the smaller one and than the error that they tell, how many say `bounded`, how many of these
// are off by more than the bound, and how many have a bound that is a hundred times as large as the error.
// `make extremes` keeps it as bench/EXTREMES.md.
//
// The reference of the tests searches the directions for the best one and may miss it. Nobody has to trust it: what
// separates two shapes along any direction is a lower bound of their signed distance. So the truth is the largest of
// the reference's and of those along the normals of both precisions, in extended precision: an answer that is less deep
// than the reference's is right where its own normal shows it, and wrong only where some direction does.
#include <cmath>
#include <cstdio>
#include <regex>

#include "command_line.hpp"
#include "common/extreme_pair.hpp"
#include "graze/query.hpp"
#include "measure.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

using reference::Real;
using testing::bounded_kinds;
using testing::Kind;
using testing::PlacedSpecimen;

struct Options {
  std::size_t pairs = 2000, seed = 1, cases = 0;
  std::string only = ".*";
};

/// A bound is loose when it is so many times as large as the error, and not a matter of rounding.
constexpr Real loose = 100;

/// Counts of answers of two kinds in one precision.
struct Tally {
  std::size_t asked = 0, beyond = 0, beyond_smaller = 0, bounded = 0, broken = 0, loose_bounds = 0;
  double worst = 0;  ///< of those that are proven
};

template <class T>
reference::Vector vector_of(const Vec3<T>& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

/// One of the pairs, and what is so of it.
struct Case {
  PlacedSpecimen a, b;
  reference::Placed ra, rb;
  Real size, smaller, truth;

  /// The length that an error is relative to: of shapes that overlap the larger one's size, of others the smaller
  /// one's, unless that one is a point.
  Real scale() const { return truth > 0 && smaller > 0 ? smaller : size; }
};

/// The signed distance as near as anybody comes to it from below.
Real truth_of(const reference::Placed& a, const reference::Placed& b, const Vec3d& normal, const Vec3f& other) {
  return std::max({reference::signed_distance(a, b).distance, reference::separation(a, b, vector_of(normal)),
                   reference::separation(a, b, vector_of(other))});
}

/// The error that an answer about two that are apart may have: the tolerance of the smaller one, and the rounding of
/// the coordinates of both.
template <class T>
Real allowed_of_smaller(const Case& c) {
  return static_cast<Real>(tolerance<T>) * c.smaller +
         16 * static_cast<Real>(std::numeric_limits<T>::epsilon()) *
             (c.size + static_cast<Real>(max_abs(c.a.translation - c.b.translation)));
}

template <class T>
void judge(const Case& c, const Distance<T>& d, Tally& tally, const Options& options, const char* name) {
  ++tally.asked;
  const Real error = std::abs(static_cast<Real>(d.distance) - c.truth),
             allowed = testing::allowed_error<T>(c.a, c.b, c.size);
  const auto tell = [&](const char* what) {
    if (options.cases == 0) return;
    std::fprintf(stderr, "%s %s: %.17g for %.20Lg, error %.3Lg of allowed %.3Lg, bound %.3g\n  %s\n  %s\n", name, what,
                 static_cast<double>(d.distance), c.truth, error, allowed, static_cast<double>(d.error),
                 describe(c.a).c_str(), describe(c.b).c_str());
  };
  if (d.status == Status::converged) {
    tally.worst = std::max(tally.worst, static_cast<double>(error / c.scale()));
    if (c.truth > 0 && error > allowed_of_smaller<T>(c) + static_cast<Real>(d.error) &&
        ++tally.beyond_smaller <= options.cases)
      tell("beyond the smaller one's tolerance");
    if (error <= allowed) return;
    if (++tally.beyond <= options.cases) tell("proven wrongly");
    return;
  }
  ++tally.bounded;
  const auto bound = static_cast<Real>(d.error);
  if (error > allowed + bound && ++tally.broken <= options.cases) tell("beyond its bound");
  if (bound > loose * std::max(error, allowed) && ++tally.loose_bounds <= options.cases) tell("loosely bounded");
}

std::vector<std::string> line_of(const std::string& name, const Tally& in_double, const Tally& in_float) {
  std::vector<std::string> line{name, std::to_string(in_double.asked)};
  for (const Tally* t : {&in_double, &in_float}) {
    line.push_back(error(t->worst));
    for (const std::size_t count : {t->beyond, t->beyond_smaller, t->bounded, t->broken, t->loose_bounds})
      line.push_back(count == 0 ? "" : std::to_string(count));
  }
  return line;
}

/// Pairs of one and another kind.
void measure(Kind kind_a, Kind kind_b, const Options& options, const std::string& name, Tally& in_double,
             Tally& in_float) {
  testing::Random random(options.seed * 10000 + static_cast<std::uint64_t>(kind_a) * 100 +
                         static_cast<std::uint64_t>(kind_b));
  for (std::size_t i = 0; i < options.pairs; ++i) {
    const auto [a, b] = testing::extreme_pair(kind_a, kind_b, random, static_cast<int>(i));
    Case c{a, b, reference_of(a), reference_of(b), 0, 0, 0};
    c.smaller = std::min(reference::bounding_radius(c.ra.shape), reference::bounding_radius(c.rb.shape));
    c.size = reference::size(c.ra, c.rb);
    if (!(c.size > 0)) continue;
    const Distance<double> d = distance(testing::build<double>(a.specimen), testing::pose_of<double>(a),
                                        testing::build<double>(b.specimen), testing::pose_of<double>(b));
    const Distance<float> f = distance(testing::build<float>(a.specimen), testing::pose_of<float>(a),
                                       testing::build<float>(b.specimen), testing::pose_of<float>(b));
    c.truth = truth_of(c.ra, c.rb, d.normal, f.normal);
    judge(c, d, in_double, options, (name + ", double,").c_str());
    judge(c, f, in_float, options, (name + ", float,").c_str());
  }
}

void run(const Options& options) {
  const std::regex only(options.only);
  Table table({"pair", "asked", "double: worst", "beyond", "apart", "bounded", "broken", "loose", "float: worst",
               "beyond", "apart", "bounded", "broken", "loose"});
  Tally all_double, all_float;
  const auto add = [](Tally& to, const Tally& t) {
    to.asked += t.asked, to.beyond += t.beyond, to.beyond_smaller += t.beyond_smaller, to.bounded += t.bounded,
        to.broken += t.broken;
    to.loose_bounds += t.loose_bounds;
    to.worst = std::max(to.worst, t.worst);
  };
  std::size_t done = 0;
  for (int i = 0; i < bounded_kinds; ++i)
    for (int j = i; j < bounded_kinds; ++j) {
      const Kind a = static_cast<Kind>(i), b = static_cast<Kind>(j);
      const std::string name = std::string(name_of(a)) + "-" + name_of(b);
      progress(done++, bounded_kinds * (bounded_kinds + 1) / 2, name);
      if (!std::regex_search(name, only)) continue;
      Tally in_double, in_float;
      measure(a, b, options, name, in_double, in_float);
      table.add(line_of(name, in_double, in_float));
      add(all_double, in_double);
      add(all_float, in_float);
    }
  progress(done, done, "");
  table.add(line_of("all", all_double, all_float));
  std::string text = table.text();
  while (text.ends_with("\n\n")) text.pop_back();
  std::printf(R"(# Hard pairs

Written by `make extremes`. %zu pairs of each two kinds, of seed %zu: up to ten thousand times as large as each other,
concentric, nearly identical, nearly parallel, flat or thin (`tests/common/extreme_pair.hpp`). The truth is the largest
signed distance that any direction shows in extended precision: of those that the reference of the tests finds, and of
the normals of the answers themselves.

- worst: the largest error of an answer that says it is proven, over the smaller shape's size where the two are apart
  and over the larger one's where they overlap. The library's tolerance is relative to the larger one.
- beyond: answers that say they are proven and are off by more than the tolerance.
- apart: answers about shapes that are apart that say they are proven and are off by more than the error that they
  tell, the tolerance of the smaller one and sixteen roundings of the coordinates together.
- bounded: answers that say that they are not proven; broken: those of them that are off by more than their bound;
  loose: those whose bound is more than %.0Lf times as large as the error and as the tolerance.

%s)",
              options.pairs, options.seed, loose, text.c_str());
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) {
  graze::bench::Options options;
  graze::bench::CommandLine("How often answers to hard pairs are wrong, for every two kinds of shapes.")
      .number("--pairs", options.pairs, "pairs of each two kinds")
      .number("--seed", options.seed, "another one, other pairs")
      .number("--cases", options.cases, "describe so many of each fault of each two kinds on standard error")
      .expression("--only", options.only, "pairs whose names match, e.g. 'cone-hull'")
      .read(argc, argv);
  graze::bench::run(options);
}
