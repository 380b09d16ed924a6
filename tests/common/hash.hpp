// The bits of many numbers as one.
#pragma once

#include <cstdint>
#include <cstring>

#include "graze/plane/vec2.hpp"
#include "graze/vec3.hpp"

namespace graze::testing {

/// Fowler, Noll and Vo's hash (FNV-1a, 64 bits) of the bytes of numbers.
class Hash {
 public:
  template <class N>
  void add(const N& value) {
    unsigned char bytes[sizeof(N)];
    std::memcpy(bytes, &value, sizeof(N));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 0x100000001b3u;
  }
  template <class T>
  void add(const Vec3<T>& v) {
    add(v.x), add(v.y), add(v.z);
  }
  template <class T>
  void add(const plane::Vec2<T>& v) {
    add(v.x), add(v.y);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace graze::testing
