// Every pair of shapes and every query, with other libraries on the same pairs: how fast, and how right.
//
// All libraries are in one process and take turns in every repetition, so that what slows the machine down slows all of
// them; of the repetitions the median is told. What is right is what Graze answers in double precision: its tests hold
// that against an independent reference. The other libraries are as their packages were built, Graze as this tree is.
//
//   bench_compare [--pairs N] [--repetitions N] [--filter REGEX] [--libraries REGEX] [--scale S] [--quick] [--write FILE]
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <regex>
#include <thread>

#include "graze/query.hpp"
#include "graze_shape.hpp"
#include "report.hpp"

namespace graze::bench {

std::vector<std::unique_ptr<Peer>>& peers() {
  static std::vector<std::unique_ptr<Peer>> all;
  return all;
}

namespace {

/// Within this of touching, relative to the size, either answer is right: single precision resolves about a hundredth.
constexpr double band = 1e-4;
/// A repetition lasts at least so long, in as many turns through the pairs as it takes.
constexpr double least_seconds = 1e-3;

struct Options {
  std::size_t pairs = 500, repetitions = 9;
  std::string filter = ".*", libraries = ".*", write;
  double scale = 1;
};

constexpr const char* usage =
    "usage: bench_compare [options]\n"
    "  --pairs N          pairs for each pair of shapes (500)\n"
    "  --repetitions N    of which the median is taken (9)\n"
    "  --filter REGEX     only what matches, e.g. 'distance box,' of the names 'overlap sphere, capsule'\n"
    "  --libraries REGEX  only these, e.g. 'graze|bullet'\n"
    "  --scale S          multiply all lengths, e.g. 0.01 for shapes of a centimetre\n"
    "  --quick            100 pairs, 3 repetitions\n"
    "  --write FILE       write the tables to FILE as well\n";

[[noreturn]] void refuse(const std::string& why) {
  std::fprintf(stderr, "bench_compare: %s\n%s", why.c_str(), usage);
  std::exit(2);
}

double positive(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double v = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !(v > 0) || !(v <= 1e9)) refuse(option + " takes a positive number, not '" + text + "'");
  return v;
}
std::size_t count(const std::string& option, const std::string& text) {
  const double v = positive(option, text);
  if (v != std::floor(v)) refuse(option + " takes a whole number, not '" + text + "'");
  return static_cast<std::size_t>(v);
}

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    }
    if (option == "--quick") {
      options.pairs = 100;
      options.repetitions = 3;
      continue;
    }
    if (i + 1 == argc) refuse("unknown option, or nothing behind it: " + option);
    const std::string value = argv[++i];
    if (option == "--pairs")
      options.pairs = count(option, value);
    else if (option == "--repetitions")
      options.repetitions = count(option, value);
    else if (option == "--scale")
      options.scale = positive(option, value);
    else if (option == "--filter")
      options.filter = value;
    else if (option == "--libraries")
      options.libraries = value;
    else if (option == "--write")
      options.write = value;
    else
      refuse("unknown option: " + option);
  }
  return options;
}

std::regex expression(const std::string& option, const std::string& text) {
  try {
    return std::regex(text);
  } catch (const std::regex_error&) {
    refuse(option + " takes a regular expression, not '" + text + "'");
  }
}

Touching touching(const Body& a, const Body& b) {
  return [a = graze_shape<double>(a), b = graze_shape<double>(b)](const Posed& pose_a, const Posed& pose_b) {
    return overlap(a, pose_a, b, pose_b);
  };
}

/// What is right: the signed distance over the size.
std::vector<double> truths(const std::vector<Pair>& pairs) {
  std::vector<double> distances;
  for (const Pair& p : pairs)
    distances.push_back(distance(graze_shape<double>(p.a), p.a.pose, graze_shape<double>(p.b), p.b.pose).distance /
                        p.size());
  return distances;
}

/// Asks once about every pair and judges the answers.
Cell judged(Peer& peer, Query query, const std::vector<Pair>& pairs, const std::vector<double>& truth) {
  Cell cell;
  std::size_t found = 0, overlapping = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Answer answer = peer.answer(query, i);
    cell.points += answer.points;
    cell.overlapping += answer.overlap;
    if (!answer.failed && std::isfinite(answer.distance) && (query == Query::distance || truth[i] < -band))
      cell.errors.push_back(std::abs(answer.distance / pairs[i].size() - truth[i]));
    if (std::abs(truth[i]) <= band) continue;
    const bool overlaps = truth[i] < 0;
    ++cell.asked;
    cell.failed += answer.failed;
    cell.wrong += answer.failed || answer.overlap != overlaps;
    overlapping += overlaps;
    found += overlaps && answer.overlap;
  }
  cell.state = overlapping > 0 && found == 0 ? Cell::State::silent : Cell::State::measured;
  return cell;
}

/// Times those of the row's cells that answer.
void time(Row& row, std::size_t pair_count, std::size_t repetitions) {
  using Clock = std::chrono::steady_clock;
  struct Runner {
    Peer& peer;
    Cell& cell;
    std::size_t turns;
    std::vector<double> times;
  };
  volatile double sink = 0;
  const auto seconds = [&](Peer& peer, std::size_t turns) {
    const auto begin = Clock::now();
    for (std::size_t t = 0; t < turns; ++t) sink = sink + peer.run(row.query, pair_count);
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  std::vector<Runner> runners;
  for (std::size_t c = 0; c < row.cells.size(); ++c) {
    if (row.cells[c].state != Cell::State::measured) continue;
    Peer& peer = *peers()[c];
    seconds(peer, 1);  // warm
    runners.push_back({peer, row.cells[c], 1 + static_cast<std::size_t>(least_seconds / seconds(peer, 1)), {}});
  }
  for (std::size_t r = 0; r < repetitions; ++r)
    for (std::size_t k = 0; k < runners.size(); ++k) {
      Runner& runner = runners[(k + r) % runners.size()];  // nobody is always behind the same one
      runner.times.push_back(seconds(runner.peer, runner.turns) * 1e9 / static_cast<double>(runner.turns * pair_count));
    }
  for (Runner& runner : runners) {
    runner.cell.nanoseconds = quantile(runner.times, 0.5);
    runner.cell.spread = (quantile(runner.times, 0.75) - quantile(runner.times, 0.25)) / 2 / runner.cell.nanoseconds;
  }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

Conditions conditions(const Options& options) {
  char day[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(day, sizeof day, "%Y-%m-%d", std::gmtime(&now));
  char scale[32];
  std::snprintf(scale, sizeof scale, "%g", options.scale);
#ifdef __clang__
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return {{"date", day},
          {"processor", processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads, 1 used"},
          {"compiler", compiler + ", flags of Graze:" GRAZE_BENCH_FLAGS + "; the other libraries as packaged"},
          {"pairs", std::to_string(options.pairs) + " for each pair of shapes, lengths times " + scale + ", " +
                        std::to_string(options.repetitions) + " repetitions"}};
}

/// Where the run is, on a terminal.
void progress(std::size_t done, std::size_t all, const std::string& what) {
  static const bool shown = isatty(STDERR_FILENO) != 0;
  if (!shown) return;
  std::fprintf(stderr, "\r\033[K%zu/%zu %s", done, all, what.c_str());
  if (done == all) std::fputs("\r\033[K", stderr);
}

std::vector<Row> measure(const Options& options) {
  const std::regex filter = expression("--filter", options.filter);
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
      const std::vector<Pair> pairs = make_pairs(Kind(a), Kind(b), options.pairs, options.scale, touching);
      const std::vector<double> truth = truths(pairs);
      std::vector<char> prepared;
      for (const auto& peer : peers()) prepared.push_back(peer->prepare(pairs));
      for (Row& row : asked) {
        for (std::size_t c = 0; c < peers().size(); ++c)
          if (prepared[c] && peers()[c]->has(row.query)) row.cells[c] = judged(*peers()[c], row.query, pairs, truth);
        time(row, options.pairs, options.repetitions);
        rows.push_back(std::move(row));
      }
    }
  progress(all, all, "");
  return rows;
}

/// Swallows what the libraries write: FCL writes a line for each pair that it cannot answer.
class Quiet : public std::streambuf {
 public:
  Quiet() : kept_(std::cerr.rdbuf(this)) {}
  ~Quiet() override { std::cerr.rdbuf(kept_); }

 private:
  int overflow(int c) override { return c == traits_type::eof() ? 0 : c; }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
  std::streambuf* kept_;
};

int run(int argc, char** argv) {
  const Options options = parse(argc, argv);
  const std::regex wanted = expression("--libraries", options.libraries);
  std::erase_if(peers(), [&](const auto& peer) { return !std::regex_search(peer->name(), wanted); });
  if (peers().empty()) refuse("no library matches " + options.libraries);
  // Graze first: the order in which they registered is the linker's.
  std::sort(peers().begin(), peers().end(), [](const auto& p, const auto& q) {
    const bool ours = p->name().starts_with("graze"), others = q->name().starts_with("graze");
    return ours != others ? ours : p->name() < q->name();
  });
  std::vector<Column> columns;
  for (const auto& peer : peers())
    columns.push_back({peer->name(), peer->version(), peer->single_precision(), peer->name() == "graze double"});

  const Quiet quiet;
  const std::vector<Row> rows = measure(options);
  const bool resting = std::regex_search("resting boxes", expression("--filter", options.filter));
  const std::string text =
      report(conditions(options), columns, rows, resting ? measure_flicker(10000) : std::vector<Flicker>{});
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
