#include "measure.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <regex>
#include <thread>

namespace graze::bench {

std::vector<std::unique_ptr<Peer>>& peers() {
  static std::vector<std::unique_ptr<Peer>> all;
  return all;
}

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

class Nothing : public std::streambuf {
  int overflow(int c) override { return c == traits_type::eof() ? 0 : c; }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

}  // namespace

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Cell judged(Peer& peer, Query query, std::size_t pairs, const Judge& judge, double patience) {
  constexpr std::size_t between = 1000;  // looks at the clock
  Cell cell;
  std::size_t found = 0, meeting = 0;
  if (peer.answers_at_once()) peer.run(query, pairs);
  const double begin = processor_seconds();
  for (std::size_t i = 0; i < pairs; ++i) {
    if (i > 0 && i % between == 0 && processor_seconds() - begin > patience) break;
    const Answer answer = peer.answer(query, i);
    const Verdict verdict = judge(i, answer);
    cell.points += answer.points;
    cell.overlapping += answer.overlap;
    if (!answer.failed && std::isfinite(verdict.error)) cell.errors.push_back(verdict.error);
    if (!verdict.counts) continue;
    ++cell.asked;
    cell.failed += answer.failed;
    cell.wrong += answer.failed || verdict.wrong;
    meeting += verdict.meets;
    found += verdict.meets && answer.overlap;
  }
  cell.state = meeting > 0 && found == 0 ? Cell::State::silent : Cell::State::measured;
  return cell;
}

void time(Query query, std::size_t pairs, const TimingOptions& options, std::vector<Cell>& cells) {
  struct Runner {
    Peer& peer;
    Cell& cell;
    std::size_t turns;
    std::vector<double> times;
  };
  volatile double sink = 0;
  const auto seconds = [&](Peer& peer, std::size_t turns, std::size_t count) {
    const double begin = processor_seconds();
    for (std::size_t t = 0; t < turns; ++t) sink = sink + peer.run(query, count);
    return processor_seconds() - begin;
  };
  std::vector<Runner> runners;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].state != Cell::State::measured) continue;
    Peer& peer = *peers()[c];
    std::size_t count = pairs;
    const std::size_t few = std::min<std::size_t>(pairs, 1000);
    const double of_few = seconds(peer, 1, few) / static_cast<double>(few);
    if (of_few * static_cast<double>(pairs) > options.most_seconds)
      count = std::max(few, static_cast<std::size_t>(options.most_seconds / of_few));
    seconds(peer, 1, count);  // warm
    cells[c].timed = count;
    const double once = std::max(1e-9, seconds(peer, 1, count));
    runners.push_back({peer, cells[c], 1 + static_cast<std::size_t>(options.least_seconds / once), {}});
  }
  for (std::size_t r = 0; r < options.repetitions; ++r)
    for (std::size_t k = 0; k < runners.size(); ++k) {
      Runner& runner = runners[(k + r) % runners.size()];  // nobody is always behind the same one
      const std::size_t count = runner.cell.timed;
      runner.times.push_back(seconds(runner.peer, runner.turns, count) * 1e9 /
                             static_cast<double>(runner.turns * count));
    }
  for (Runner& runner : runners) {
    runner.cell.nanoseconds = quantile(runner.times, 0.5);
    runner.cell.spread = (quantile(runner.times, 0.75) - quantile(runner.times, 0.25)) / 2 / runner.cell.nanoseconds;
  }
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Conditions conditions() {
  char day[32];
  const std::time_t now = std::time(nullptr);
  std::strftime(day, sizeof day, "%Y-%m-%d", std::gmtime(&now));
#ifdef __clang__
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  Conditions all{
      {"date", day},
      {"processor", processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads, 1 used"},
      {"compiler", compiler + ", flags of Graze:" GRAZE_BENCH_FLAGS + "; the other libraries as packaged"}};
  for (const auto& peer : peers())
    all.push_back(
        {peer->name(), peer->version() + (peer->single_precision() ? ", single" : ", double") + " precision"});
  return all;
}

void choose_peers(const std::string& libraries) {
  const std::regex wanted(libraries);
  std::erase_if(peers(), [&](const auto& peer) { return !std::regex_search(peer->name(), wanted); });
  // The order in which they registered is the linker's.
  std::sort(peers().begin(), peers().end(), [](const auto& p, const auto& q) {
    const bool ours = p->name().starts_with("graze"), others = q->name().starts_with("graze");
    return ours != others ? ours : p->name() < q->name();
  });
}

void progress(std::size_t done, std::size_t all, const std::string& what) {
  static const bool shown = isatty(STDERR_FILENO) != 0;
  if (!shown) return;
  std::fprintf(stderr, "\r\033[K%zu/%zu %s", done, all, what.c_str());
  if (done == all) std::fputs("\r\033[K", stderr);
}

Quiet::Quiet() : nothing_(std::make_unique<Nothing>()), kept_(std::cerr.rdbuf(nothing_.get())) {}
Quiet::~Quiet() { std::cerr.rdbuf(kept_); }

}  // namespace graze::bench
