// Files opened and written, with the reason where that fails.
//
// Guarantee: what cannot be read or written throws `InvalidValue` with the file's name and the system's reason ("no
// such file", "a folder", "no space left on device"); nothing is taken for read or written that is not. A file that is
// written as a whole has its old bytes or all of its new ones, whenever the program is killed or the disk is full.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "graze/standard.hpp"

namespace graze::io {

/// A file opened for reading, byte by byte. Throws `InvalidValue` for what is not there, a folder, or not permitted.
GRAZE_API std::ifstream open_file(const std::filesystem::path& file);

/// A file that is written piece by piece, and can be read meanwhile.
class GRAZE_API FileWriter {
 public:
  /// Makes the file, or empties it. Throws `InvalidValue`, as everything here does.
  explicit FileWriter(const std::filesystem::path& file);
  void write(std::string_view bytes);  ///< appends
  /// Writes out what was kept back, which may find no room: without this nothing is known to be written.
  void close();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

/// A file that is written piece by piece and takes its name when it is closed: until then its bytes stand beside it, in
/// NAME.partial, which goes when the writer does. A link stays one, and what it leads to is written; the permissions of
/// a file that was there are kept. Devices, pipes and what is named below /dev or /proc are written as the bytes come,
/// and so is a file in a folder that takes no new ones.
class GRAZE_API WholeFileWriter {
 public:
  /// Throws `InvalidValue`, as everything here does.
  explicit WholeFileWriter(const std::filesystem::path& file);
  ~WholeFileWriter();
  WholeFileWriter(const WholeFileWriter&) = delete;
  WholeFileWriter& operator=(const WholeFileWriter&) = delete;
  void write(std::string_view bytes);  ///< appends
  void close();                        ///< gives the file its name: without this nothing is written

 private:
  std::filesystem::path file_, target_, written_;  ///< as named, where links lead, and where the bytes go
  std::ofstream out_;
};

/// Throws `InvalidValue` if a file cannot be written, before the work that fills it begins; leaves everything as it
/// was.
GRAZE_API void check_writable(const std::filesystem::path& file);

/// Writes the parts one behind the other as a whole file, by a `WholeFileWriter`.
GRAZE_API void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts);
/// Writes one part as a whole file.
GRAZE_API void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace graze::io
