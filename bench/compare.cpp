// Every pair of shapes and every query, with other libraries on the same pairs: how fast, and how right.
//
// The other libraries are as their packages were built, Graze as this tree is. `bench_headline` has the pairs that
// matter most, more of them.
//
//   bench_compare [--pairs N] [--repetitions N] [--filter REGEX] [--libraries REGEX] [--scale S] [--quick] [--brief]
//                 [--write FILE]
#include <cstdio>
#include <fstream>
#include <regex>

#include "command_line.hpp"
#include "judges.hpp"
#include "report.hpp"

namespace graze::bench {

namespace {

struct Options {
  std::size_t pairs = 500, repetitions = 9;
  std::string filter = ".*", libraries = ".*", write;
  double scale = 1;
  bool brief = false;
};

Options parse(int argc, char** argv) {
  Options options;
  bool quick = false;
  CommandLine("Every pair of shapes and every query, with other libraries on the same pairs: how fast, and how right.")
      .number("--pairs", options.pairs, "pairs for each pair of shapes")
      .number("--repetitions", options.repetitions, "of which the median is taken")
      .expression("--filter", options.filter,
                  "only what matches, e.g. 'distance box,' of the names 'overlap sphere, capsule'")
      .expression("--libraries", options.libraries, "only these, e.g. 'graze|bullet'")
      .real("--scale", options.scale, "multiply all lengths, e.g. 0.01 for shapes of a centimetre")
      .flag("--quick", quick, "100 pairs, 3 repetitions")
      .flag("--brief", options.brief, "only the summary")
      .file("--write", options.write, "write the tables there as well")
      .read(argc, argv);
  if (quick) {
    options.pairs = 100;
    options.repetitions = 3;
  }
  return options;
}

/// As a run with these options was made.
Conditions conditions_with(const Options& options) {
  char scale[32];
  std::snprintf(scale, sizeof scale, "%g", options.scale);
  Conditions all = conditions();
  all.push_back({"pairs", std::to_string(options.pairs) + " for each pair of shapes, lengths times " + scale + ", " +
                              std::to_string(options.repetitions) + " repetitions"});
  return all;
}

std::vector<Row> measure(const Options& options) {
  const std::regex filter(options.filter);
  std::vector<Row> rows;
  constexpr std::size_t all = kind_count * (kind_count + 1) / 2;
  std::size_t done = 0;
  for (std::size_t a = 0; a < kind_count; ++a)
    for (std::size_t b = a; b < kind_count; ++b, ++done) {
      if (a == b && Kind(a) == Kind::half_space) continue;  // their overlap has no depth
      const std::string name = std::string(kind_names[a]) + ", " + kind_names[b];
      std::vector<Row> asked;
      for (const Query query : queries)
        if (std::regex_search(query_names[static_cast<int>(query)] + (" " + name), filter))
          asked.push_back({Kind(a), Kind(b), query, std::vector<Cell>(peers().size())});
      if (asked.empty()) continue;
      progress(done, all, name);
      const std::vector<Pair> pairs = make_pairs(Kind(a), Kind(b), options.pairs, options.scale, make_touching());
      const Reference reference(pairs);
      std::vector<char> prepared;
      for (const auto& peer : peers()) prepared.push_back(peer->prepare(pairs));
      for (Row& row : asked) {
        const Judge judge = distance_judge(reference, row.query);
        for (std::size_t c = 0; c < peers().size(); ++c)
          if (prepared[c] && peers()[c]->has(row.query))
            row.cells[c] = judged(*peers()[c], row.query, pairs.size(), judge);
        time(row.query, options.pairs, {.repetitions = options.repetitions}, row.cells);
        rows.push_back(std::move(row));
      }
    }
  progress(all, all, "");
  return rows;
}

int run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  choose_peers(options.libraries);
  if (peers().empty()) {
    std::fprintf(stderr, "bench_compare: no library matches %s\n", options.libraries.c_str());
    return 2;
  }
  std::vector<Column> columns;
  for (const auto& peer : peers())
    columns.push_back({peer->name(), peer->version(), peer->single_precision(), peer->name() == "graze double"});

  const Quiet quiet;
  const std::vector<Row> rows = measure(options);
  const bool resting = std::regex_search("resting boxes", std::regex(options.filter));
  const auto flickers = resting ? measure_flicker(10000) : std::vector<Flicker>{};
  const std::string text =
      options.brief ? summary(columns, rows, flickers) : report(conditions_with(options), columns, rows, flickers);
  std::fputs(text.c_str(), stdout);
  if (!options.write.empty()) {
    std::ofstream file(options.write);
    file << text << std::flush;
    if (!file) {
      std::fprintf(stderr, "bench_compare: cannot write %s\n", options.write.c_str());
      return 1;
    }
  }
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
