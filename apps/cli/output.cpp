#include "output.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graze::cli {

Json json_of(const Vec3d& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

void print(const Json& whole) { fmt::print("{}\n", whole.dump(2, ' ', false, Json::error_handler_t::replace)); }

std::string shown(const Vec3d& v, int width) {
  const auto unsigned_zero = [](double x) { return std::abs(x) < 5e-5 ? 0.0 : x; };
  return fmt::format("{0:{3}.4f} {1:{3}.4f} {2:{3}.4f}", unsigned_zero(v.x), unsigned_zero(v.y), unsigned_zero(v.z),
                     width);
}

}  // namespace graze::cli
