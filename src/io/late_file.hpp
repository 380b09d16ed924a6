// A file that is left as it was until there is something to write.
//
// Guarantee: a run that is refused before its first result neither makes nor empties the file, and a file that cannot
// be written is refused before the run begins.
#pragma once

#include <optional>

#include "graze/io/file.hpp"

namespace graze::io {

/// A file that is opened, and emptied, with its first piece, and can be read while it is written.
class LateFile {
 public:
  /// Checks that the file can be written, and changes nothing. Throws `InvalidValue`, as all functions of the class do.
  explicit LateFile(std::filesystem::path file) : file_(std::move(file)) { check_writable(file_); }

  void write(std::string_view bytes) { opened().write(bytes); }
  /// Writes out buffered bytes. A file without any piece is then there, and empty.
  void close() { opened().close(); }

 private:
  FileWriter& opened() { return out_ ? *out_ : out_.emplace(file_); }

  std::filesystem::path file_;
  std::optional<FileWriter> out_;
};

}  // namespace graze::io
