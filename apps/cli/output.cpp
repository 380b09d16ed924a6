#include "output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <system_error>

namespace graze::cli {

Json json_of(const Vec3d& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

void print(const Json& whole) { fmt::print("{}\n", whole.dump(2, ' ', false, Json::error_handler_t::replace)); }

std::string shown(const Vec3d& v, int width) {
  const auto unsigned_zero = [](double x) { return std::abs(x) < 5e-5 ? 0.0 : x; };
  return fmt::format("{0:{3}.4f} {1:{3}.4f} {2:{3}.4f}", unsigned_zero(v.x), unsigned_zero(v.y), unsigned_zero(v.z),
                     width);
}

std::string counted(std::size_t count, const std::string& noun) {
  if (count == 1) return "1 " + noun;
  const bool y = noun.ends_with('y');
  return fmt::format("{} {}{}", count, y ? noun.substr(0, noun.size() - 1) : noun, y ? "ies" : "s");
}

bool& quiet() {
  static bool asked = false;
  return asked;
}

void print_notes(const std::vector<std::string>& notes) {
  if (quiet()) return;
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
}

void flush_output() {
  // Standard output is written in two ways, which may have buffers of their own.
  const bool stream_wrote = static_cast<bool>(std::cout.flush());
  const bool file_wrote = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (stream_wrote && file_wrote) return;
  throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), unwritten_output);
}

}  // namespace graze::cli
