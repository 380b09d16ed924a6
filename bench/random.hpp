// Random numbers that are the same everywhere, and numbers that single precision holds.
#pragma once

#include <cstdint>

#include "pairs.hpp"

namespace graze::bench {

/// SplitMix64 (Steele, Lea, Flood 2014). The distributions of <random> differ between standard libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double number(double low, double high) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  Vec3d in_cube(double reach) {
    const double x = number(-reach, reach), y = number(-reach, reach);
    return {x, y, number(-reach, reach)};
  }
  /// Uniform, by throwing away what falls outside the ball.
  Vec3d direction() {
    for (;;) {
      const Vec3d v = in_cube(1);
      const double l = length(v);
      if (l > 0.1 && l <= 1) return v / l;
    }
  }
  Quatd rotation() {
    for (;;) {
      const Vec3d v = in_cube(1);
      const double w = number(-1, 1), l2 = dot(v, v) + w * w;
      if (l2 > 0.01 && l2 <= 1) return normalized(Quatd{v.x, v.y, v.z, w});
    }
  }

 private:
  std::uint64_t state_;
};

inline double as_float(double v) { return static_cast<double>(static_cast<float>(v)); }
inline Vec3d as_float(const Vec3d& v) { return {as_float(v.x), as_float(v.y), as_float(v.z)}; }
inline Posed as_float(const Posed& p) {
  const Quatd& q = p.rotation;
  return {as_float(p.translation), {as_float(q.x), as_float(q.y), as_float(q.z), as_float(q.w)}};
}
inline Body as_float(Body body) {
  body.pose = as_float(body.pose);
  return body;
}

}  // namespace graze::bench
