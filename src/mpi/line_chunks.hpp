// A file of lines or of records in parts that are handed out. The parts depend on the file alone, so that a journal can
// name them by number.
#pragma once

#include <cstdint>
#include <vector>

#include "mpi/file.hpp"

namespace graze::mpi {

/// Some whole lines or records of a file.
struct Chunk {
  std::uint64_t number = 0;
  std::uint64_t offset = 0, length = 0;  ///< in bytes
  std::uint64_t first_line = 1;          ///< counted from 1
};

/// Finds the chunks one after the other, so that the first is answered before the last has been looked for.
class LineChunks {
 public:
  /// The lines and bytes with which a chunk ends, at the end of a line: work of some milliseconds, beside which a
  /// message costs nothing, and little to wait for at the end.
  static constexpr std::uint64_t most_lines = 64, most_bytes = 1 << 16;

  /// Begins with a file. With `record_bytes` a "line" has so many bytes, whatever they are; the file has a multiple of
  /// them.
  explicit LineChunks(const File& file, std::uint64_t record_bytes = 0)
      : file_(file), size_(file.size()), record_bytes_(record_bytes) {}

  /// The next chunk; false at the end.
  bool next(Chunk& out);
  std::uint64_t lines() const { return line_ - 1; }  ///< so far

 private:
  std::uint64_t end_of_line(std::uint64_t from);

  const File& file_;
  std::uint64_t size_, record_bytes_, offset_ = 0, line_ = 1, number_ = 0;
  std::vector<char> block_;
  std::uint64_t block_offset_ = 0;
};

}  // namespace graze::mpi
