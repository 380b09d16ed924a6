// The targets of links: where a file's name is given to another file, the link stays, and its target is replaced.
#pragma once

#include <filesystem>
#include <string>

namespace graze::io {

/// Whether a name stands for a file that is open already, as below /dev and /proc: nothing else may take its place.
inline bool stands_for_open_file(const std::filesystem::path& file) {
  std::error_code failed;
  const std::string name = std::filesystem::absolute(file, failed).lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/");
}

/// The end of the links that begin with a name, whether anything is there or not; no further than to an open file.
inline std::filesystem::path link_target(std::filesystem::path file) {
  constexpr int most_links = 40;  // Linux follows so many (path_resolution(7))
  for (int i = 0; i < most_links && !stands_for_open_file(file); ++i) {
    std::error_code failed;
    const std::filesystem::path next = std::filesystem::read_symlink(file, failed);
    if (failed) break;
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  return file;
}

}  // namespace graze::io
