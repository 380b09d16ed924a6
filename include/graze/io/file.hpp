// Files opened and written, with the reason where that fails.
//
// Guarantee: what cannot be read or written throws `InvalidValue` with the file's name and the system's reason ("no
// such file", "a folder", "no space left on device"); nothing is taken for read or written that is not.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

namespace graze::io {

/// A file opened for reading, byte by byte. Throws `InvalidValue` for what is not there, a folder, or not permitted.
std::ifstream open_file(const std::filesystem::path& file);

/// Writes the parts one behind the other as a whole file, and closes it. Throws `InvalidValue` unless every byte of it
/// was taken.
void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts);
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace graze::io
