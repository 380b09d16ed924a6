// A hash of the bits of many numbers.
#pragma once

#include <cstdint>
#include <cstring>

#include "graze/plane/pose2.hpp"
#include "graze/pose.hpp"

namespace graze {

/// The hash of the bits of a sequence of numbers, on whose order it depends.
class BitHash {
 public:
  template <class T>
  void add(T value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    value_ = (value_ ^ bits) * 0x100000001b3u;
    value_ ^= value_ >> 29;
  }
  template <class T>
  void add(const Vec3<T>& v) {
    add(v.x), add(v.y), add(v.z);
  }
  template <class T>
  void add(const plane::Vec2<T>& v) {
    add(v.x), add(v.y);
  }
  template <class T>
  void add(const Quat<T>& q) {
    add(q.x), add(q.y), add(q.z), add(q.w);
  }
  template <class T>
  void add(const plane::Rot2<T>& q) {
    add(q.cosine), add(q.sine);
  }
  template <class T>
  void add(const Pose<T>& pose) {
    add(pose.translation);
    add(pose.rotation);
  }
  template <class T>
  void add(const plane::Pose2<T>& pose) {
    add(pose.translation);
    add(pose.rotation);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace graze
