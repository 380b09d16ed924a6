// The file that `graze view` shows, as one file whatever it refers to, and its versions.
//
// Guarantee: reads that file and, for a .gltf, what its buffers and pictures name below its own folder; nothing else.
// Safe from any thread.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace graze::cli {

class ShownFile {
 public:
  /// Throws `InvalidValue` for what is no file that can be read.
  explicit ShownFile(std::filesystem::path file);

  const std::filesystem::path& path() const { return file_; }
  bool is_there() const;
  /// Another one whenever it, or a file with a buffer of it, was written anew. Throws where it is gone.
  std::string version() const;
  /// Its bytes; a .gltf that refers to other files with them inside. Throws where it is gone.
  std::string content() const;

 private:
  /// The files with buffers, of the version `own`.
  std::vector<std::filesystem::path> buffers(const std::string& own) const;

  std::filesystem::path file_;
  // A scene is read to see what it names when it was written anew, not each time that somebody asks.
  mutable std::mutex guard_;
  mutable std::string known_version_;
  mutable std::vector<std::filesystem::path> known_buffers_;
};

/// All bytes of a file. Throws `InvalidValue`.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace graze::cli
