#include "mpi/line_chunks.hpp"

#include <algorithm>
#include <cstring>

namespace graze::mpi {

namespace {

constexpr std::uint64_t bytes_per_block = 1 << 20;

}  // namespace

/// The offset behind the end of the line that holds `from`.
std::uint64_t LineChunks::end_of_line(std::uint64_t from) {
  if (record_bytes_ > 0) return from + record_bytes_;
  while (from < size_) {
    if (from < block_offset_ || from >= block_offset_ + block_.size()) {
      block_offset_ = from;
      block_.resize(static_cast<std::size_t>(std::min(bytes_per_block, size_ - from)));
      file_.read(from, block_.data(), block_.size());
    }
    const char* const begin = block_.data() + (from - block_offset_);
    const char* const end = block_.data() + block_.size();
    if (const void* found = std::memchr(begin, '\n', static_cast<std::size_t>(end - begin)))
      return from + static_cast<std::uint64_t>(static_cast<const char*>(found) - begin) + 1;
    from = block_offset_ + block_.size();
  }
  return size_;
}

bool LineChunks::next(Chunk& out) {
  if (offset_ == size_) return false;
  out = {number_++, offset_, 0, line_};
  while (offset_ < size_ && line_ - out.first_line < most_lines && offset_ - out.offset < most_bytes) {
    offset_ = end_of_line(offset_);
    ++line_;
  }
  out.length = offset_ - out.offset;
  return true;
}

}  // namespace graze::mpi
