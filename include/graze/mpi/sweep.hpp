// A sweep: many questions, one a line or so many bytes of a file, answered by all ranks of a communicator.
//
// Guarantee: the answers stand in the order of the questions and are the same bytes whatever the number of ranks. Who
// is done asks for more, so that a question that takes long holds up nobody but its own rank. With a journal the work
// that is done outlives its processes: started again, by as many ranks as one likes, the sweep goes on where it was,
// and its output is that of a run that was never stopped. The output appears as a whole or not at all.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "graze/visibility.hpp"

namespace graze::mpi {

/// A fault that all ranks know of, so that each can end in order; the message names the rank that has it.
struct CommonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws `CommonError` on every rank when any rank has a fault, which is one that is not empty. All ranks must call.
GRAZE_API void agree(MPI_Comm comm, const std::string& fault);

/// Throws `CommonError` on every rank unless all have the same text: a version, a precision, options. All must call.
GRAZE_API void agree_on(MPI_Comm comm, const std::string& what, const std::string& text);

/// Settings of a sweep.
struct SweepSettings {
  std::string questions;  ///< a regular file that every rank can read
  std::string out;        ///< where the answers go, written by all ranks; empty: to the stream of rank 0
  /// A directory that every rank can write, for what is done so far; gone when the sweep is. Empty: beside `out`, which
  /// has ".journal" after its name, or none where the answers go to a stream.
  std::string journal;
  /// Bytes of each question, whatever they are; 0 where a question is a line.
  std::uint64_t record_bytes = 0;
  std::string kind;  ///< what the answers depend on beside the questions: the program's version, the precision
};

/// Appends the answer to a line, which is not blank, or to a record, to `out`; `number` counts them from 1. Returns
/// whether the answer is an error. Called from one thread a rank.
using LineAnswer = std::function<bool(std::string_view line, std::size_t number, std::string& out)>;

/// The work of a sweep.
struct SweepReport {
  std::uint64_t lines = 0;                   ///< of the file, blank ones too; or records
  std::uint64_t errors = 0;                  ///< answers that are errors
  std::uint64_t chunks = 0, remembered = 0;  ///< parts of the file, and those that the journal had
  std::vector<std::uint64_t> by_rank;        ///< chunks that each rank answered
  std::vector<double> busy;                  ///< seconds for which each rank answered
};

/// Answers the questions; all ranks of `comm` must call it with the same settings, MPI initialised with at least
/// MPI_THREAD_FUNNELED and from the thread that did so. Rank 0 hands out the work, in one thread, and answers in
/// another. The report stands on rank 0; of the others' only `errors` and `lines` are told.
/// Throws `CommonError` on every rank for what is wrong from the start (a file that is not there, a journal of another
/// sweep, ranks of different kinds), and `std::system_error` on the rank that cannot read or write later on, after
/// which the caller must end all ranks (MPI_Abort).
GRAZE_API SweepReport sweep_lines(MPI_Comm comm, const SweepSettings& settings, const LineAnswer& answer,
                                  std::ostream& stream);

}  // namespace graze::mpi
