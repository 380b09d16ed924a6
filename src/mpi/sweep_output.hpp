// From the records of a journal to the output, in the order of the chunks.
#pragma once

#include <mpi.h>

#include <iosfwd>
#include <string>
#include <vector>

#include "mpi/journal.hpp"

namespace graze::mpi {

/// Where the output is written until it is whole.
std::string partial_name(const std::string& out);

/// Throws `std::system_error` for what the stream does not take.
void write_to_stream(const std::string& directory, const std::vector<Record>& records, std::ostream& stream);

/// Each rank writes a share of the bytes to where they belong in one file (MPI-IO), which then takes its name: `out` is
/// whole or as it was. `records` are rank 0's. Throws `std::system_error`.
void write_together(MPI_Comm comm, const std::string& directory, std::vector<Record> records, const std::string& out);

}  // namespace graze::mpi
