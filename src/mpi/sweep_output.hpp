// The output of a sweep from the records of a journal, in the order of the chunks.
#pragma once

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "mpi/journal.hpp"

namespace graze::mpi {

/// The name of the output until it is whole.
std::string partial_name(const std::string& out);

/// Writes the output to a stream. Throws `std::system_error` when it takes no more.
void write_to_stream(const std::string& directory, const std::vector<Record>& records, std::ostream& stream);

/// Writes the output to one file, each rank a share of the bytes at their places (MPI-IO); then the file takes its
/// name: `out` is whole or as it was. `records` are rank 0's. Throws `std::system_error`.
void write_together(MPI_Comm comm, const std::string& directory, std::vector<Record> records, const std::string& out);

}  // namespace graze::mpi
