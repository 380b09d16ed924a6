#include "graze/io/file.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "graze/error.hpp"
#include "io/link_target.hpp"

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

[[noreturn]] void cannot_write(const std::filesystem::path& file, int error) {
  // A file that is to be made lacks its folder, not itself.
  throw InvalidValue(file.string(), "",
                     "cannot be written: " + (error == ENOENT ? std::string("no such folder") : reason(error)));
}

/// Opens a file to be written anew; `named`: its name in errors.
void open(std::ofstream& out, const std::filesystem::path& file, const std::filesystem::path& named) {
  errno = 0;
  out.open(file, std::ios::binary);
  if (!out) cannot_write(named, errno);
}

void append(std::ofstream& out, std::string_view bytes, const std::filesystem::path& named) {
  errno = 0;
  if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) cannot_write(named, errno);
}

/// Writes out all that was kept back, which may find no room.
void close_whole(std::ofstream& out, const std::filesystem::path& named) {
  errno = 0;
  out.close();
  if (!out) cannot_write(named, errno);
}

/// The file beside a target that can take its place: none for a target that is no regular file, or stands for an open
/// one.
std::filesystem::path partial_of(const std::filesystem::path& target) {
  std::error_code failed;
  const std::filesystem::file_status there = std::filesystem::status(target, failed);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) return {};
  if (stands_for_open_file(target)) return {};
  return target.string() + ".partial";
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

FileWriter::FileWriter(const std::filesystem::path& file) : file_(file) { open(out_, file, file_); }

void FileWriter::write(std::string_view bytes) { append(out_, bytes, file_); }

void FileWriter::flush() {
  errno = 0;
  if (!out_.flush()) cannot_write(file_, errno);
}

void FileWriter::close() { close_whole(out_, file_); }

WholeFileWriter::WholeFileWriter(const std::filesystem::path& file)
    : file_(file), target_(link_target(file)), written_(partial_of(target_)) {
  check_writable(file);
  // A link of that name would take the place of the file, and its target be written over.
  std::error_code failed;
  if (!written_.empty() && std::filesystem::is_symlink(written_)) std::filesystem::remove(written_, failed);
  if (!written_.empty()) out_.open(written_, std::ios::binary);
  if (out_.is_open()) return;
  // A folder that takes no new files may have one that can be written.
  out_.clear();
  written_ = target_;
  open(out_, written_, file_);
}

WholeFileWriter::~WholeFileWriter() {
  if (!out_.is_open()) return;
  out_.close();
  std::error_code failed;
  if (written_ != target_) std::filesystem::remove(written_, failed);
}

void WholeFileWriter::write(std::string_view bytes) { append(out_, bytes, file_); }

void WholeFileWriter::close() {
  close_whole(out_, file_);
  if (written_ == target_) return;
  std::error_code failed;
  const std::filesystem::file_status before = std::filesystem::status(target_, failed);
  if (std::filesystem::exists(before)) std::filesystem::permissions(written_, before.permissions(), failed);
  std::filesystem::rename(written_, target_, failed);
  if (!failed) return;
  const int error = failed.value();
  std::filesystem::remove(written_, failed);
  cannot_write(file_, error);
}

void check_writable(const std::filesystem::path& file) {
  const std::filesystem::path target = link_target(file);
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(target, failed);
  // To open a pipe waits for its reader, and to close it again tells the reader that all is over.
  if (std::filesystem::is_fifo(status)) return;
  const bool there = std::filesystem::exists(status);
  const std::filesystem::path partial = partial_of(target), tried = there || partial.empty() ? target : partial;
  errno = 0;
  if (!std::ofstream(tried, std::ios::binary | std::ios::app)) cannot_write(file, errno);
  if (!there) std::filesystem::remove(tried, failed);
}

void write_file(const std::filesystem::path& file, std::span<const std::string_view> parts) {
  WholeFileWriter out(file);
  for (const std::string_view part : parts) out.write(part);
  out.close();
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, std::span(&content, 1));
}

}  // namespace graze::io
