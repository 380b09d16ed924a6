// Files opened and written, with the reason where that fails.
//
// Guarantee: what cannot be read or written throws `InvalidValue` with the file's name and the system's reason ("no
// such file", "a folder", "no space left on device"); nothing is taken for read or written that is not.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "graze/standard.hpp"

namespace graze::io {

/// A file opened for reading, byte by byte. Throws `InvalidValue` for what is not there, a folder, or not permitted.
GRAZE_API std::ifstream open_file(const std::filesystem::path& file);

/// A file that is written piece by piece.
class GRAZE_API FileWriter {
 public:
  /// Makes the file, or empties it. Throws `InvalidValue`, as everything here does.
  explicit FileWriter(const std::filesystem::path& file);
  void write(std::string_view bytes);  ///< appends
  /// Writes out what was kept back, which may find no room: without this nothing is known to be written.
  void close();

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_;
  std::ofstream out_;
};

/// Throws `InvalidValue` if a file cannot be written, before the work that fills it begins. One that is there keeps its
/// bytes, one that is not there is made.
GRAZE_API void check_writable(const std::filesystem::path& file);

/// Writes the parts one behind the other as a whole file, and closes it. Throws `InvalidValue` unless every byte of it
/// was taken.
GRAZE_API void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts);
/// Writes the whole file or nothing.
GRAZE_API void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace graze::io
