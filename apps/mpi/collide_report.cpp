#include "mpi/collide_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mpi/messages.hpp"

namespace graze::cli {

namespace {

/// The largest over the mean of a number that `number` gives for each rank.
template <class F>
double balance(const std::vector<RankReport>& reports, F&& number) {
  double most = 0, sum = 0;
  for (const RankReport& r : reports) {
    most = std::max(most, static_cast<double>(number(r)));
    sum += static_cast<double>(number(r));
  }
  return sum > 0 ? most / sum * static_cast<double>(reports.size()) : 1;
}

/// The longest time of all ranks, in milliseconds.
template <class F>
double longest(const std::vector<RankReport>& reports, F&& seconds) {
  double most = 0;
  for (const RankReport& r : reports) most = std::max(most, seconds(r));
  return 1e3 * most;
}

}  // namespace

void print_report(MPI_Comm comm, const std::string& title, const RankReport& mine) {
  static_assert(std::is_trivially_copyable_v<RankReport>);
  std::vector<RankReport> reports(static_cast<std::size_t>(mpi::size_of(comm)));
  MPI_Gather(&mine, sizeof mine, MPI_BYTE, reports.data(), sizeof mine, MPI_BYTE, 0, comm);
  if (mpi::rank_of(comm) != 0) return;
  fmt::print("{}\n\n{:>6}  {:>10}  {:>10}  {:>10}  {:>12}  {:>12}\n", title, "rank", "bodies", "ghosts", "pairs",
             "bytes sent", "memory");
  RankReport sum{};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const RankReport& r = reports[i];
    fmt::print("{:>6}  {:>10}  {:>10}  {:>10}  {:>12}  {:>12}\n", i, r.world.bodies, r.world.ghosts, r.world.pairs,
               r.world.bytes, r.memory);
    sum.world.bodies += r.world.bodies;
    sum.world.ghosts += r.world.ghosts;
    sum.world.pairs += r.world.pairs;
    sum.world.bytes += r.world.bytes;
    sum.memory += r.memory;
  }
  fmt::print("{:>6}  {:>10}  {:>10}  {:>10}  {:>12}  {:>12}\n\n", "all", sum.world.bodies, sum.world.ghosts,
             sum.world.pairs, sum.world.bytes, sum.memory);
  fmt::print(
      "balance (largest over mean): bodies {:.3f}, pairs {:.3f}, processor time {:.3f}; borders drawn {} times\n",
      balance(reports, [](const RankReport& r) { return r.world.bodies; }),
      balance(reports, [](const RankReport& r) { return r.world.pairs; }),
      balance(reports, [](const RankReport& r) { return r.world.work; }), reports[0].world.partitions);
  fmt::print("milliseconds (of the slowest rank): reading {:.3f}, partition {:.3f}, exchange {:.3f}, pairs {:.3f}, "
             "contacts {:.3f}, events {:.3f}\n",
             longest(reports, [](const RankReport& r) { return r.reading; }),
             longest(reports, [](const RankReport& r) { return r.world.partition; }),
             longest(reports, [](const RankReport& r) { return r.world.exchange; }),
             longest(reports, [](const RankReport& r) { return r.world.broad; }),
             longest(reports, [](const RankReport& r) { return r.world.contacts; }),
             longest(reports, [](const RankReport& r) { return r.world.events; }));
}

}  // namespace graze::cli
