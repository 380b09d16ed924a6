#include "shown_file.hpp"

#include <fmt/format.h>

#include <iterator>

#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/gltf_files.hpp"

namespace graze::cli {

namespace {

namespace fs = std::filesystem;

/// The version of a file, by its time of writing and its size: a large file is not read to find out whether it changed.
std::string version_of(const fs::path& file) {
  return fmt::format("{:x}-{:x}", fs::last_write_time(file).time_since_epoch().count(), fs::file_size(file));
}

}  // namespace

std::string bytes_of(const fs::path& file) {
  std::ifstream in = io::open_file(file);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InvalidValue(file.string(), "", "cannot be read to its end");
  return bytes;
}

ShownFile::ShownFile(fs::path file) : file_(std::move(file)) {
  io::open_file(file_);
  if (!is_there()) throw InvalidValue(file_.string(), "a regular file", "something else");
}

bool ShownFile::is_there() const { return fs::is_regular_file(file_); }

std::vector<fs::path> ShownFile::buffers(const std::string& own) const {
  if (file_.extension() != ".gltf") return {};
  const std::lock_guard lock(guard_);
  if (known_version_ != own) {
    known_buffers_ = io::buffer_files(file_);
    known_version_ = own;
  }
  return known_buffers_;
}

std::string ShownFile::version() const {
  const std::string own = version_of(file_);
  std::string all = own;
  for (const fs::path& buffer : buffers(own)) all += "." + (fs::is_regular_file(buffer) ? version_of(buffer) : "none");
  return all;
}

std::string ShownFile::content() const {
  if (buffers(version_of(file_)).empty()) return bytes_of(file_);
  try {
    return io::whole_gltf(file_);
  } catch (const InvalidValue&) {
    return bytes_of(file_);  // the page reports what is wrong with it
  }
}

}  // namespace graze::cli
