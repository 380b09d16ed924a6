// Files of a sweep: read and written at an offset by name, where a failure is an error with the name in it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace graze::mpi {

/// An open file. Throws `std::system_error` with its name in it for all that fails, a full disk too.
class File {
 public:
  File() = default;
  static File reading(const std::string& name);
  /// Opens a file to write to, which is made where it is not there; nothing in it is lost.
  static File writing(const std::string& name);
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  ~File();

  bool open() const { return descriptor_ >= 0; }
  bool regular() const;
  std::uint64_t size() const;
  void read(std::uint64_t offset, char* to, std::size_t count) const;  ///< throws when there is less
  std::string read(std::uint64_t offset, std::size_t count) const;
  void append(std::string_view bytes);
  void flush() const;
  /// Takes the file for this process alone until it is closed; false when another has it.
  bool lock() const;
  const std::string& name() const { return name_; }

 private:
  [[noreturn]] void fail(const char* what) const;
  void close();

  std::string name_;
  int descriptor_ = -1;
};

}  // namespace graze::mpi
