#include "mpi/file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace graze::mpi {

namespace {

constexpr mode_t readable_by_all = 0666;

}  // namespace

void File::fail(const char* what) const {
  throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), name_ + ": cannot be " + what);
}

File File::reading(const std::string& name) {
  File file;
  file.name_ = name;
  file.descriptor_ = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (!file.open()) file.fail("opened");
  return file;
}

File File::writing(const std::string& name) {
  File file;
  file.name_ = name;
  file.descriptor_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, readable_by_all);
  if (!file.open()) file.fail("written");
  return file;
}

File::File(File&& other) noexcept : name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

File::~File() { close(); }

void File::close() {
  if (open()) ::close(std::exchange(descriptor_, -1));
}

bool File::regular() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
}

std::uint64_t File::size() const {
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) fail("read");
  return static_cast<std::uint64_t>(status.st_size);
}

void File::read(std::uint64_t offset, char* to, std::size_t count) const {
  while (count > 0) {
    const ssize_t got = ::pread(descriptor_, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;
    if (got <= 0) fail("read to its end");
    to += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

std::string File::read(std::uint64_t offset, std::size_t count) const {
  std::string text(count, '\0');
  read(offset, text.data(), count);
  return text;
}

void File::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor_, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) fail("written");
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

void File::flush() const {
  if (::fsync(descriptor_) != 0) fail("written");
}

bool File::lock() const { return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0; }

}  // namespace graze::mpi
