// The report of `graze-mpi collide`: the shares of the ranks in the work.
#pragma once

#include <string>

#include "graze/mpi/world.hpp"

namespace graze::cli {

/// One rank's numbers.
struct RankReport {
  mpi::WorldReport world;
  std::uint64_t memory = 0;  ///< bytes that the world holds
  double reading = 0;        ///< seconds
};

/// Prints all ranks' reports as a table, on the first. All ranks.
void print_report(MPI_Comm comm, const std::string& title, const RankReport& mine);

}  // namespace graze::cli
