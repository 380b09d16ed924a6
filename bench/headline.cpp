// The pairs that programs ask about most, 100,000 different ones of each kind, in single precision, with other
// libraries on the same pairs: how fast, and how right.
//
//   bench_headline [--pairs N] [--repetitions N] [--only REGEX] [--libraries REGEX] [--seconds S] [--chart FILE.svg]
//                  [--short FILE.md] [--memory FILE.md]
//
// About half of the pairs overlap or hit. So many do not fit in a cache: what a library reads and writes for a pair is
// part of its time. All get the same pairs and make of them, untimed, the objects that their users hold: each its own,
// but for hulls and triangles, of which there are `different` that the pairs share at poses of their own. A library
// that takes longer than S seconds (0.3) over all pairs is asked about the first ones only.
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <regex>

#include "command_line.hpp"
#include "headline_report.hpp"
#include "judges.hpp"

namespace graze::bench {

namespace {

constexpr std::size_t different = 256;

struct Options {
  std::size_t pairs = 100'000;
  TimingOptions timing{.repetitions = 9, .most_seconds = 0.3};
  std::string only = ".*", libraries = ".*", chart, brief, memory;
};

/// Pairs of a kind and what is asked about them.
struct Set {
  std::string name;
  std::function<std::vector<Pair>(std::size_t)> make;
  std::vector<Query> asked;
};

Set random_set(const char* name, Kind a, Kind b, std::vector<Query> asked) {
  return {name, [a, b](std::size_t count) { return make_pairs(a, b, count, 1, make_touching(), different); }, asked};
}

Set hull_set(const char* name, std::size_t vertices, std::vector<Query> asked) {
  const auto make = [vertices](std::size_t count) {
    return make_hull_pairs(vertices, count, make_touching(), different);
  };
  return {name, make, asked};
}

/// A tenth of the pairs: each of them is hundreds of others.
Set mesh_set(const char* name, Kind kind, std::vector<Query> asked) {
  return {name, [kind](std::size_t count) { return make_on_mesh(kind, 1 + count / 10, different); }, asked};
}

std::vector<Set> all_sets() {
  constexpr Query overlap = Query::overlap, distance = Query::distance, contacts = Query::contacts;
  const auto rays_at = [](Kind kind) {
    return [kind](std::size_t count) { return make_rays(kind, count, different); };
  };
  const auto ways_of = [](Kind kind) {
    return [kind](std::size_t count) { return make_ways(kind, count, different); };
  };
  return {random_set("sphere-sphere", Kind::sphere, Kind::sphere, {contacts}),
          random_set("sphere-box", Kind::sphere, Kind::box, {contacts}),
          random_set("capsule-capsule", Kind::capsule, Kind::capsule, {contacts}),
          random_set("box-box", Kind::box, Kind::box, {overlap, distance, contacts}),
          {"box-box stacked", make_stacked, {contacts}},
          random_set("box-triangle", Kind::box, Kind::triangle, {contacts}),
          random_set("cylinder-cylinder", Kind::cylinder, Kind::cylinder, {contacts}),
          random_set("hull-hull", Kind::hull, Kind::hull, {overlap, distance, contacts}),
          hull_set("hull8-hull8", 8, {overlap, distance, contacts}),
          hull_set("hull64-hull64", 64, {overlap, distance, contacts}),
          mesh_set("sphere-mesh", Kind::sphere, {overlap, contacts}),
          mesh_set("capsule-mesh", Kind::capsule, {overlap, contacts}),
          mesh_set("box-mesh", Kind::box, {overlap, contacts}),
          mesh_set("hull-mesh", Kind::hull, {overlap, contacts}),
          {"ray-box", rays_at(Kind::box), {Query::raycast}},
          {"ray-hull", rays_at(Kind::hull), {Query::raycast}},
          {"box-box", ways_of(Kind::box), {Query::cast}},
          {"hull-hull", ways_of(Kind::hull), {Query::cast}}};
}

std::string row_name(const Set& set, Query query) {
  return query == Query::raycast ? set.name : set.name + " " + query_names[static_cast<int>(query)];
}

Judge judge_of(const Reference& reference, Query query) {
  if (query == Query::raycast) return ray_judge(reference);
  if (query == Query::cast) return cast_judge(reference);
  return distance_judge(reference, query);
}

std::size_t heap() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Which of the rows of a set are wanted.
std::vector<Query> wanted(const Set& set, const std::regex& only) {
  std::vector<Query> queries;
  for (const Query query : set.asked)
    if (std::regex_search(row_name(set, query), only)) queries.push_back(query);
  return queries;
}

void measure(const Set& set, const std::vector<Query>& asked, const Options& options, std::vector<HeadlineRow>& rows) {
  const std::vector<Pair> pairs = set.make(options.pairs);
  const Reference reference(pairs);
  std::vector<char> prepared;
  std::vector<std::size_t> held;
  for (const auto& peer : peers()) {
    const std::size_t before = heap();
    prepared.push_back(peer->prepare(pairs));
    held.push_back((heap() - before) / pairs.size());
  }
  for (const Query query : asked) {
    HeadlineRow row{row_name(set, query), query, 0, std::vector<Cell>(peers().size()), held, {}};
    const Judge judge = judge_of(reference, query);
    Answer none;
    for (std::size_t i = 0; i < pairs.size(); ++i) row.meeting += judge(i, none).meets;
    row.meeting /= static_cast<double>(pairs.size());
    for (std::size_t c = 0; c < peers().size(); ++c) {
      Peer& peer = *peers()[c];
      row.touched.push_back(peer.touched(query));
      if (prepared[c] && peer.has(query))
        row.cells[c] = judged(peer, query, pairs.size(), judge, 10 * options.timing.most_seconds);
    }
    time(query, pairs.size(), options.timing, row.cells);
    rows.push_back(std::move(row));
  }
  for (const auto& peer : peers()) peer->forget();
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) std::fprintf(stderr, "bench_headline: cannot write %s\n", path.c_str());
  return static_cast<bool>(file);
}

Options parse(int argc, char** argv) {
  Options options;
  CommandLine(
      "The pairs that programs ask about most, with other libraries on the same pairs: how fast, and how right.")
      .number("--pairs", options.pairs, "pairs of a kind")
      .number("--repetitions", options.timing.repetitions, "of which the median is taken")
      .real("--seconds", options.timing.most_seconds, "a library that takes longer over all pairs is asked about fewer")
      .expression("--only", options.only, "only rows whose names match, e.g. 'box-box.*contacts'")
      .expression("--libraries", options.libraries, "only these, e.g. 'graze|ode'")
      .file("--chart", options.chart, "draw the rows (SVG)")
      .file("--short", options.brief, "write the short table (Markdown)")
      .file("--memory", options.memory, "write what a pair holds and touches (Markdown)")
      .read(argc, argv);
  return options;
}

int run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  choose_peers(options.libraries);
  const std::regex only(options.only);
  std::vector<HeadlineRow> rows;
  const std::vector<Set> sets = all_sets();
  const Quiet quiet;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::vector<Query> asked = wanted(sets[s], only);
    progress(s, sets.size(), sets[s].name);
    if (!asked.empty()) measure(sets[s], asked, options, rows);
  }
  progress(sets.size(), sets.size(), "");
  for (const auto& [what, how] : conditions()) std::printf("- %s: %s\n", what.c_str(), how.c_str());
  std::printf("- pairs: %zu a row, %zu repetitions\n\n", options.pairs, options.timing.repetitions);
  std::fputs(headline_report(rows).c_str(), stdout);
  if (!options.chart.empty() && !write(options.chart, headline_chart(rows, options.pairs))) return 1;
  if (!options.brief.empty() && !write(options.brief, headline_short(rows))) return 1;
  if (!options.memory.empty() && !write(options.memory, headline_memory(rows))) return 1;
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
