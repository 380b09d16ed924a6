// How far the answers of Graze, in both precisions, and of other libraries are from the truth, for each pair of shapes.
//
//   bench_accuracy [--pairs N] [--only REGEX] [--libraries REGEX]
//
// Writes Markdown: `make accuracy` keeps it as bench/ACCURACY.md. The truth is that of the tests' reference in extended
// precision (tests/reference). Every library is asked about the same pairs by the code that `make bench` times.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <regex>

#include "accuracy_kinds.hpp"
#include "accuracy_plane.hpp"
#include "accuracy_truth.hpp"
#include "command_line.hpp"
#include "judges.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

struct Options {
  std::size_t pairs = 4000;
  std::string only = ".*", libraries = "graze double|graze float|bullet|fcl|ode";
};

/// The answers of one library to one question about one set of pairs.
struct Errors {
  bool asked = false;
  std::size_t without = 0;  ///< no answer, or the opposite of what is so
  std::vector<double> of;   ///< relative to the size

  void add(Real error) { of.push_back(static_cast<double>(error)); }

  std::string text() const {
    if (!asked) return "-";
    const std::size_t all = of.size() + without;
    std::string text = of.empty() ? "none" : error(*std::ranges::max_element(of)) + " / " + error(quantile(of, 0.999));
    if (without > 0 && !of.empty()) text += " (" + percent(without, all) + ")";
    return text;
  }
};

/// A table for each question, a line for each set of pairs, a column for each library.
struct Tables {
  Table distance, overlap, depth, normal, ray, cast;

  static Table one() {
    std::vector<std::string> head{"largest / 99.9 %"};
    for (const auto& peer : peers()) head.push_back(peer->name());
    return Table(std::move(head));
  }
  Tables() : distance(one()), overlap(one()), depth(one()), normal(one()), ray(one()), cast(one()) {}
};

void add_line(Table& table, const std::string& name, const std::vector<Errors>& line) {
  std::vector<std::string> cells{name};
  for (const Errors& errors : line) cells.push_back(errors.text());
  table.add(std::move(cells));
}

using PlacedPair = std::pair<reference::Placed, reference::Placed>;

/// Rotations of unit length to double precision: those of `pairs` were rounded to single precision, and what a library
/// makes of a quaternion that is not unit is not the question here.
void normalize(std::vector<Pair>& pairs) {
  for (Pair& pair : pairs)
    for (Body* body : {&pair.a, &pair.b}) body->pose.rotation = normalized(body->pose.rotation);
}

/// Whether the library answers, of the pairs that it was given; one that answers all at once does so now.
bool answers(Peer& peer, Query query, std::size_t count) {
  if (!peer.has(query)) return false;
  if (peer.answers_at_once()) peer.run(query, count);
  return true;
}

/// The reference's value is a maximum over directions, of which a search may miss the best one. Where no library comes
/// as near as `agreed` to it, that may be what happened: there it searches again from ten, then from a
/// hundred times as many places. More
/// places never make the value wrong.
void search_again(const std::vector<Pair>& pairs, const std::vector<PlacedPair>& placed,
                  std::vector<reference::Signed>& truth) {
  constexpr Real agreed = 1e-6L;
  std::vector<std::vector<Real>> told(pairs.size());
  for (const auto& peer : peers()) {
    if (peer->prepare(pairs) && answers(*peer, Query::distance, pairs.size()))
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (const Answer answer = peer->answer(Query::distance, i); !answer.failed && std::isfinite(answer.distance))
          told[i].push_back(answer.distance);
    peer->forget();
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto agrees = [&](Real d) { return std::abs(d - truth[i].distance) <= agreed * pairs[i].size(); };
    for (const int effort : {10, 100}) {
      if (pairs[i].b.kind == Kind::half_space || std::ranges::any_of(told[i], agrees)) break;
      const reference::Signed again = search_signed_distance(placed[i].first, placed[i].second, effort);
      if (again.distance > truth[i].distance) truth[i] = again;
    }
  }
}

/// Pairs, and what is so of them.
struct Known {
  std::vector<Pair> pairs;
  std::vector<PlacedPair> placed;
  std::vector<reference::Signed> truth;
};

/// Signed distances of those that are apart, and of those that overlap.
void ask_distances(Peer& peer, const Known& known, Errors& apart, Errors& overlapping) {
  if (!answers(peer, Query::distance, known.pairs.size())) return;
  apart.asked = overlapping.asked = true;
  for (std::size_t i = 0; i < known.pairs.size(); ++i) {
    const Real so = known.truth[i].distance;
    Errors& errors = so > 0 ? apart : overlapping;
    const Answer answer = peer.answer(Query::distance, i);
    if (answer.failed || !std::isfinite(answer.distance))
      ++errors.without;
    else
      errors.add(std::abs(answer.distance - so) / known.pairs[i].size());
  }
}

/// The deepest contact of those that overlap, and the normal: how much further than necessary the two have to be moved
/// along it, either way round, to come apart.
void ask_contacts(Peer& peer, const Known& known, Errors& depth, Errors& normal) {
  if (!answers(peer, Query::contacts, known.pairs.size())) return;
  depth.asked = normal.asked = true;
  for (std::size_t i = 0; i < known.pairs.size(); ++i) {
    const Real so = known.truth[i].distance, size = known.pairs[i].size();
    if (so >= 0) continue;
    const Answer answer = peer.answer(Query::contacts, i);
    if (answer.failed || answer.points == 0 || !std::isfinite(answer.distance)) {
      ++depth.without;
      ++normal.without;
      continue;
    }
    depth.add(std::abs(answer.distance - so) / size);
    const reference::Vector n{answer.normal.x, answer.normal.y, answer.normal.z};
    const auto& [a, b] = known.placed[i];
    normal.add(std::max<Real>(0, so - std::max(separation(a, b, n), separation(a, b, -n))) / size);
  }
}

void ask_pairs(const std::string& name, std::vector<Pair> pairs, Tables& tables) {
  normalize(pairs);
  Known known{std::move(pairs), {}, {}};
  for (const Pair& pair : known.pairs) {
    known.placed.emplace_back(referenced(pair.a), referenced(pair.b));
    known.truth.push_back(signed_distance(known.placed.back().first, known.placed.back().second));
  }
  search_again(known.pairs, known.placed, known.truth);
  std::vector<Errors> distances, overlaps, depths, normals;
  for (const auto& peer : peers()) {
    Errors distance, overlap, depth, normal;
    if (peer->prepare(known.pairs)) {
      ask_distances(*peer, known, distance, overlap);
      ask_contacts(*peer, known, depth, normal);
    }
    peer->forget();
    distances.push_back(std::move(distance));
    overlaps.push_back(std::move(overlap));
    depths.push_back(std::move(depth));
    normals.push_back(std::move(normal));
  }
  add_line(tables.distance, name, distances);
  add_line(tables.overlap, name, overlaps);
  add_line(tables.depth, name, depths);
  add_line(tables.normal, name, normals);
}

using Meet = std::optional<Meeting> (*)(const Pair&);

/// The error is along the normal: between the place at the answer's time and where they meet, the tangent planes are so
/// far apart.
void ask_meetings(const std::string& name, std::vector<Pair> pairs, Query query, Meet meet, Table& table) {
  normalize(pairs);
  std::vector<std::optional<Meeting>> truth;
  for (const Pair& pair : pairs) truth.push_back(meet(pair));
  std::vector<Errors> line;
  for (const auto& peer : peers()) {
    Errors errors;
    if (peer->prepare(pairs) && answers(*peer, query, pairs.size())) {
      errors.asked = true;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Answer answer = peer->answer(query, i);
        if (answer.failed || answer.overlap != truth[i].has_value())
          ++errors.without;
        else if (truth[i])
          errors.add(std::abs(answer.time - truth[i]->t) * truth[i]->closing / pairs[i].size());
      }
    }
    peer->forget();
    line.push_back(std::move(errors));
  }
  add_line(table, name, line);
}

void print(const char* heading, const char* words, const Table& table) {
  std::string text = table.text();
  while (text.ends_with("\n\n")) text.pop_back();
  std::printf("\n## %s\n\n%s\n\n%s", heading, words, text.c_str());
}

void run(const Options& options) {
  choose_peers("^(" + options.libraries + ")$");
  const Quiet quiet;
  const std::regex only(options.only);
  const auto wanted = [&](const std::string& name) { return std::regex_search(name, only); };
  Tables tables;
  for (std::size_t a = 0; a < kind_count; ++a)
    for (std::size_t b = a; b < kind_count; ++b) {
      const Kind of_a = static_cast<Kind>(a), of_b = static_cast<Kind>(b);
      const std::string name = std::string(kind_names[a]) + "-" + kind_names[b];
      if (of_a == Kind::half_space || !wanted(name)) continue;
      progress(a * kind_count + b, kind_count * kind_count, name);
      ask_pairs(name, make_pairs(of_a, of_b, options.pairs, 1, make_touching()), tables);
    }
  for (std::size_t a = 0; a < kind_count; ++a)
    if (const std::string name = std::string("ray-") + kind_names[a];
        static_cast<Kind>(a) != Kind::half_space && wanted(name))
      ask_meetings(name, make_rays(static_cast<Kind>(a), options.pairs), Query::raycast, ray_meeting, tables.ray);
  for (const Kind kind : {Kind::box, Kind::hull})
    if (const std::string name =
            std::string(kind_names[static_cast<int>(kind)]) + "-" + kind_names[static_cast<int>(kind)] + " cast";
        wanted(name))
      ask_meetings(name, make_ways(kind, options.pairs), Query::cast, cast_meeting, tables.cast);

  std::printf(R"(# Accuracy

Written by `make accuracy`. Of %zu pairs of each two kinds of shapes every other one overlaps, by up to a quarter of its
size, and the others are as far apart; the same pairs on every machine. A size, radius or coordinate is a float, edges
and radii are between 0.25 and 2. The rotation is a unit quaternion in double precision: a library in single precision
gets it rounded, and what that changes is part of its error, as it is for its users. The truth is found in extended
precision (a significand of %d bits) by the reference of the tests (`tests/reference`), which shares nothing with Graze:
it enumerates the directions of two polytopes, and searches the sphere of directions for everything else, again from up
to a hundred times as many places where no library agrees with it to a millionth. It is right within about 2e-17 of the
size where the search missed nothing.

Each cell has the largest error and the 99.9th percentile, over the size of the pair: the larger of the two radii about
the shapes' own origins. In brackets: the share of pairs without an answer, or with the opposite one (no contact where
there is one, a hit for a miss); these have no error. `-`: the library has no such shape or query; `none`: it has it and
answered for no pair. The other libraries are the distribution's packages, with the tolerances that they come with;
margins of Bullet are 0, so that its shapes are those of everybody else.

)",
              options.pairs, std::numeric_limits<Real>::digits);
  for (const auto& [what, value] : conditions()) std::printf("- %s: %s\n", what.c_str(), value.c_str());
  print("Distance", "Of pairs that are apart.", tables.distance);
  print("Signed distance",
        "The same question about pairs that overlap: minus the least translation that separates them.", tables.overlap);
  print(
      "Depth",
      "Of the deepest contact of pairs that overlap, against the least translation that separates them. Contacts of\n"
      "Graze take the normal of a face while it is deeper than another one by at most half a percent of the smaller\n"
      "shape, so that what rests on a face does not jump to an edge; the signed distance above does not. Triangles of\n"
      "ODE have one side.",
      tables.depth);
  print("Normal",
        "Of contacts of pairs that overlap: by how much further than necessary the two have to be moved along it to\n"
        "come apart.",
        tables.normal);
  print("Rays",
        "Where a ray enters: the distance between the point that is told and the tangent plane of where it does.",
        tables.ray);
  print("Time of impact",
        "Of a shape that moves without turning: how far the two are apart, or deep, at the time told.", tables.cast);
  print_accuracy_of_kinds(options.pairs / 10, options.pairs / 200, only);
  plane::print_accuracy(options.pairs / 100, only);
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) {
  graze::bench::Options options;
  graze::bench::CommandLine("How far answers are from the truth, for every pair of shapes.")
      .number("--pairs", options.pairs, "pairs of each two kinds")
      .expression("--only", options.only, "pairs whose names match")
      .expression("--libraries", options.libraries, "libraries whose whole names match")
      .read(argc, argv);
  graze::bench::run(options);
}
