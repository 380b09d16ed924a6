#include "graze/io/file.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "graze/error.hpp"

namespace graze::io {

namespace {

/// The system's words for an error, in small letters as within a sentence.
std::string reason(int error) {
  if (error == 0) return "an error";
  if (error == ENOENT) return "no such file";
  std::string words = std::strerror(error);
  words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return words;
}

}  // namespace

std::ifstream open_file(const std::filesystem::path& file) {
  std::error_code failed;
  // A folder opens and then reads as if it were empty.
  if (std::filesystem::is_directory(file, failed)) throw InvalidValue(file.string(), "", "a folder, not a file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InvalidValue(file.string(), "", reason(errno));
  return in;
}

void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  // What the folder is that is missing, a file to be made does not tell.
  const auto fail = [&](const std::string& why) { throw InvalidValue(file.string(), "", "cannot be written: " + why); };
  if (!out) fail(errno == ENOENT ? "no such folder" : reason(errno));
  for (const std::string_view part : parts) out.write(part.data(), static_cast<std::streamsize>(part.size()));
  out.close();  // what was kept back is written now, and may find no room
  if (!out) fail(reason(errno));
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, std::span(&content, 1));
}

}  // namespace graze::io
