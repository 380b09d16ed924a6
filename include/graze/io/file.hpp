// Files opened and written, with the reason of any failure.
//
// Guarantee: a file that cannot be read or written throws `InvalidValue` with its name and the system's reason ("no
// such file", "a folder", "no space left on device"); no failure goes unnoticed. A file that is written as a whole has
// its old bytes or all of its new ones, whenever the program is killed or the disk is full.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "graze/detail/standard.hpp"

namespace graze::io {

/// Opens a file for reading, byte by byte. Throws `InvalidValue` if it does not exist, is a folder, or may not be read.
GRAZE_API std::ifstream open_file(const std::filesystem::path& file);

/// A file that is written piece by piece, and can be read meanwhile.
class GRAZE_API FileWriter {
 public:
  /// Creates the file, or empties it. Throws `InvalidValue`, as all functions of the class do.
  explicit FileWriter(const std::filesystem::path& file);
  void write(std::string_view bytes);  ///< appends
  void flush();                        ///< writes out buffered bytes, for who reads meanwhile
  /// Writes out buffered bytes, which may fail for lack of room: without this call nothing is known to be written.
  void close();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

/// A file that is written piece by piece and takes its name when it is closed: until then its bytes are beside it, in
/// NAME.partial, which the destructor removes. A link stays one, and its target is written; the permissions of an
/// existing file are kept. Devices, pipes and files named below /dev or /proc are written as the bytes come, and so is
/// a file in a folder that takes no new ones.
class GRAZE_API WholeFileWriter {
 public:
  /// Opens NAME.partial. Throws `InvalidValue`, as all functions of the class do.
  explicit WholeFileWriter(const std::filesystem::path& file);
  ~WholeFileWriter();
  WholeFileWriter(const WholeFileWriter&) = delete;
  WholeFileWriter& operator=(const WholeFileWriter&) = delete;
  void write(std::string_view bytes);  ///< appends
  void close();                        ///< gives the file its name: without this call nothing is written

 private:
  std::filesystem::path file_, target_, written_;  ///< file as named, target of links, file that takes the bytes
  std::ofstream out_;
};

/// Throws `InvalidValue` if a file cannot be written, to be called before the work that fills it; changes nothing.
GRAZE_API void check_writable(const std::filesystem::path& file);

/// Writes the parts one behind the other as a whole file, by a `WholeFileWriter`.
GRAZE_API void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts);
/// Writes one part as a whole file.
GRAZE_API void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace graze::io
