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

[[noreturn]] void cannot_write(const std::filesystem::path& file) {
  // What the folder is that is missing, a file to be made does not tell.
  throw InvalidValue(file.string(), "",
                     "cannot be written: " + (errno == ENOENT ? std::string("no such folder") : reason(errno)));
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

FileWriter::FileWriter(const std::filesystem::path& file) : file_(file) {
  errno = 0;
  out_.open(file, std::ios::binary);
  if (!out_) fail();
}

void FileWriter::write(std::string_view bytes) {
  errno = 0;
  if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail();
}

void FileWriter::close() {
  errno = 0;
  out_.close();
  if (!out_) fail();
}

void FileWriter::fail() { cannot_write(file_); }

void check_writable(const std::filesystem::path& file) {
  errno = 0;
  if (!std::ofstream(file, std::ios::binary | std::ios::app)) cannot_write(file);
}

void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts) {
  FileWriter out(file);
  for (const std::string_view part : parts) out.write(part);
  out.close();
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, std::span(&content, 1));
}

}  // namespace graze::io
