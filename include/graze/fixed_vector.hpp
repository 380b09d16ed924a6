// A vector of bounded length, stored in place.
//
// Guarantee: no allocation, and memory of absent elements is neither written nor copied: an empty vector of thousands
// costs nothing. The caller keeps within N.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "graze/detail/standard.hpp"

namespace graze {

/// A list of up to N elements, stored in place.
template <class T, std::size_t N>
class FixedVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  FixedVector() {}  // NOLINT(modernize-use-equals-default): a union would delete it
  /// Copies only the elements that are there.
  FixedVector(const FixedVector& other) { *this = other; }
  /// Copies only the elements that are there.
  FixedVector& operator=(const FixedVector& other) {
    size_ = other.size_;
    std::copy_n(other.items_, size_, items_);
    return *this;
  }
  ~FixedVector() = default;

  /// The largest number of elements.
  static constexpr std::size_t capacity() { return N; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Whether there is no more room.
  bool full() const { return size_ == N; }
  T& operator[](std::size_t i) { return items_[i]; }
  const T& operator[](std::size_t i) const { return items_[i]; }
  T* data() { return items_; }
  const T* data() const { return items_; }
  T* begin() { return items_; }
  T* end() { return items_ + size_; }
  const T* begin() const { return items_; }
  const T* end() const { return items_ + size_; }
  T& back() { return items_[size_ - 1]; }
  const T& back() const { return items_[size_ - 1]; }
  /// Appends an element; there has to be room.
  void push_back(const T& value) { items_[size_++] = value; }
  /// Appends an element without initialising it.
  T& emplace_back() { return items_[size_++]; }
  /// Removes the last element, which has to exist.
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  /// Drops all elements from position `count` on.
  void truncate(std::size_t count) { size_ = count; }

 private:
  std::size_t size_ = 0;
  union {
    T items_[N];
  };
};

}  // namespace graze
