// Input of the fuzzer of the C interface: bytes read as numbers, poses, enumerators and pointers.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "graze/graze.h"

inline void require(bool holds) {
  if (!holds) __builtin_trap();
}

/// The input, read from its front; zeros where it has ended.
class Bytes {
 public:
  Bytes(const std::uint8_t* bytes, std::size_t size) : at_(bytes), left_(size) {}
  bool empty() const { return left_ == 0; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *at_++;
  }
  /// Mostly small lengths, now and then what a program gets wrong.
  double number() {
    const std::uint8_t kind = byte();
    const double small = (byte() - 128) / 32.0;
    switch (kind) {
    case 0: return std::numeric_limits<double>::quiet_NaN();
    case 1: return std::numeric_limits<double>::infinity();
    case 2: return -std::numeric_limits<double>::infinity();
    case 3: return 1e300;
    case 4: return 1e-310;
    case 5: return 0;
    case 6: return small * 1e9;
    case 7: return small * 1e-9;
    default: return kind < 128 ? (small < 0 ? -small : small) : small;
    }
  }
  double length() {
    const double v = number();
    return byte() < 8 ? v : v < 0 ? -v : v;
  }
  GrazeVec3d vector() { return {number(), number(), number()}; }
  GrazeVec2d vector2() { return {number(), number()}; }
  GrazePosed pose() {
    GrazePosed p = graze_pose_turned_d(vector(), {0.6, 0, 0.8}, number());
    if (byte() < 4) p.rotation = {number(), number(), number(), number()};
    return p;
  }
  GrazePose2d pose2() {
    GrazePose2d p = graze_plane_pose_d(number(), number(), number());
    if (byte() < 4) p.rotation = {number(), number()};
    return p;
  }
  /// An enumerator that is nearly always one.
  template <class E>
  E choice(unsigned count) {
    const unsigned b = byte();
    const unsigned value = b > 250 ? b : b % count;
    E chosen;
    static_assert(sizeof chosen == sizeof value);
    std::memcpy(&chosen, &value, sizeof value);
    return chosen;
  }
  /// The pointer, or now and then none.
  template <class P>
  P* maybe(P* pointer) {
    return byte() < 5 ? nullptr : pointer;
  }

 private:
  const std::uint8_t* at_;
  std::size_t left_;
};
