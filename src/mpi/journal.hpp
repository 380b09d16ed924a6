// The journal of a sweep: a directory with a head, which identifies the sweep, and the answers that are there.
//
// Guarantee: all that was written when a process was killed is found again, except for a last record that is not whole:
// that one is recognised by its checksums and its chunk answered anew. Every rank of every run writes a file of its
// own, so that nothing is ever written behind a torn end.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mpi/file.hpp"

namespace graze::mpi {

/// The checksum FNV-1a (Fowler, Noll, Vo 1991) of 64 bits.
std::uint64_t checksum(std::string_view bytes);

/// The answers to a chunk: their number, and where they stand.
struct Record {
  std::uint64_t chunk = 0;
  std::uint64_t questions = 0;  ///< checksum of the chunk's own bytes
  std::uint64_t errors = 0;
  std::uint64_t part = 0, offset = 0, length = 0;  ///< of the answers' text in a file of the journal
};

class Journal {
 public:
  Journal() = default;
  /// Opens or makes the journal of the sweep that `head` describes, on one rank. Throws `InvalidValue` for a journal of
  /// another sweep or one that is in use, and `std::system_error` where reading or writing fails.
  static Journal open(const std::string& directory, const std::string& head);

  /// All that is known from earlier runs, in no order.
  const std::vector<Record>& known() const { return known_; }
  /// The number of this run, which no earlier one had.
  std::uint64_t run() const { return run_; }
  /// Removes the journal, the head first: a rest after an interruption is of no sweep, and goes with the next one.
  void remove();

  static std::string part_name(const std::string& directory, std::uint64_t part);
  static std::uint64_t part_of(std::uint64_t run, int rank) { return run << 32 | static_cast<std::uint32_t>(rank); }

 private:
  std::string directory_;
  File head_;
  std::vector<Record> known_;
  std::uint64_t run_ = 0;
};

/// The file that one rank writes in one run.
class JournalPart {
 public:
  JournalPart() = default;
  JournalPart(const std::string& directory, std::uint64_t part);
  /// Appends a record and sets in it where its text stands.
  void append(Record& record, std::string_view text);

 private:
  File file_;
  std::uint64_t part_ = 0, end_ = 0;
};

}  // namespace graze::mpi
