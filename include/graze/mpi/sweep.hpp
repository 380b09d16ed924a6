// A sweep: many queries, one a line or a fixed number of bytes of a file, answered by all ranks of a communicator.
//
// Guarantee: the answers are in the order of the queries and the same bytes whatever the number of ranks. A rank that
// is done takes more work, so that a slow query delays only its own rank. With a journal, finished work outlives its
// processes: started again, by any number of ranks, the sweep goes on where it was, and its output is that of a run
// that was never stopped. The output appears as a whole or not at all.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "graze/detail/standard.hpp"
#include "graze/detail/visibility.hpp"

namespace graze::mpi {

/// A fault that all ranks are informed of, so that each can end in order; the message names the rank that has it.
struct CommonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws `CommonError` on every rank when the `fault` of any rank is not empty. All ranks must call it.
GRAZE_API void agree(MPI_Comm comm, const std::string& fault);

/// Throws `CommonError` on every rank unless all have the same text: a version, a precision, options. All must call it.
GRAZE_API void agree_on(MPI_Comm comm, const std::string& what, const std::string& text);

/// Settings of a sweep.
struct SweepSettings {
  std::string questions;  ///< a regular file that every rank can read
  std::string out;        ///< file of the answers, written by all ranks; empty: the stream of rank 0
  /// A directory that every rank can write, for the work done so far; removed when the sweep is done. Empty: `out` with
  /// ".journal" after its name, or none where the answers go to a stream.
  std::string journal;
  /// Bytes of each query, of any content; 0 where a query is a line.
  std::uint64_t record_bytes = 0;
  std::string kind;  ///< further inputs of the answers beside the queries: the program's version, the precision
};

/// Appends the answer to a line, which is not blank, or to a record, to `out`; `number` counts them from 1. Returns
/// whether the answer is an error. Called from one thread a rank.
using LineAnswer = std::function<bool(std::string_view line, std::size_t number, std::string& out)>;

/// The work of a sweep.
struct SweepReport {
  std::uint64_t lines = 0;                   ///< lines of the file, blank ones too; or records
  std::uint64_t errors = 0;                  ///< answers that are errors
  std::uint64_t chunks = 0, remembered = 0;  ///< parts of the file, and those that the journal had
  std::vector<std::uint64_t> by_rank;        ///< chunks that each rank answered
  std::vector<double> busy;                  ///< seconds for which each rank answered
};

/// Answers the queries. All ranks of `comm` must call it with the same settings, MPI initialised with at least
/// MPI_THREAD_FUNNELED and from the thread that did so. Rank 0 hands out the work, in one thread, and answers in
/// another. The report is complete on rank 0; on the others only `errors` and `lines` are set.
/// Throws `CommonError` on every rank for faults at the start (a missing file, a journal of another sweep, ranks of
/// different kinds), and `std::system_error` on the rank that cannot read or write later on, after which the caller
/// must end all ranks (MPI_Abort).
GRAZE_API SweepReport sweep_lines(MPI_Comm comm, const SweepSettings& settings, const LineAnswer& answer,
                                  std::ostream& stream);

}  // namespace graze::mpi
