// The file that `graze view` shows, as one file whatever it refers to, and its versions.
//
// Guarantee: reads that file and, for a .gltf, the files below its own folder that its buffers and pictures name;
// nothing else. Safe from any thread.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace graze::cli {

class ShownFile {
 public:
  /// Names the file. Throws `InvalidValue` if it cannot be read.
  explicit ShownFile(std::filesystem::path file);

  const std::filesystem::path& path() const { return file_; }
  bool is_there() const;
  /// A version that is another one whenever the file, or one with a buffer of it, was written anew. Throws where it is
  /// gone.
  std::string version() const;
  /// The bytes of the file; for a .gltf that refers to other files, with those inside. Throws where it is gone.
  std::string content() const;

 private:
  /// The files with buffers, of the version `own`.
  std::vector<std::filesystem::path> buffers(const std::string& own) const;

  std::filesystem::path file_;
  // The names in a scene are read when it was written anew, not at each request.
  mutable std::mutex guard_;
  mutable std::string known_version_;
  mutable std::vector<std::filesystem::path> known_buffers_;
};

/// All bytes of a file. Throws `InvalidValue`.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace graze::cli
