// A vector that keeps its first elements in place.
//
// Guarantee: no allocation up to N elements; no limit beyond. Elements are trivially copyable; a new vector touches
// none of the memory kept for them, and a copy costs the elements that are there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "graze/detail/standard.hpp"

namespace graze {

/// A list that stores its first N elements in place, and a longer list on the heap.
template <class T, std::size_t N>
class SmallVector {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  SmallVector() {}  // NOLINT(modernize-use-equals-default): a union would delete it
  /// Copies the elements, as `std::vector` does.
  SmallVector(const SmallVector& other) { *this = other; }
  /// Takes over the elements, as `std::vector` does.
  SmallVector(SmallVector&& other) noexcept { *this = std::move(other); }
  /// Copies the elements, as `std::vector` does.
  SmallVector& operator=(const SmallVector& other) {
    if (this == &other) return *this;
    outside_ = other.outside_;
    take_inside(other);
    return *this;
  }
  /// Takes over the elements, as `std::vector` does.
  SmallVector& operator=(SmallVector&& other) noexcept {
    if (this == &other) return *this;
    outside_ = std::move(other.outside_);
    take_inside(other);
    other.clear();
    return *this;
  }
  ~SmallVector() = default;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return size_ <= N ? inside_ : outside_.data(); }
  const T* data() const { return size_ <= N ? inside_ : outside_.data(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& back() { return data()[size_ - 1]; }
  const T& back() const { return data()[size_ - 1]; }
  void clear() { size_ = 0; }

  /// Appends an element, as `std::vector` does.
  void push_back(const T& value) {
    if (size_ < N) [[likely]]
      inside_[size_] = value;
    else
      push_outside(value);
    ++size_;
  }
  /// Appends an element without initialising it.
  T& emplace_back() {
    if (size_ < N) [[likely]]
      return inside_[size_++];
    push_outside(T());
    return outside_[size_++];
  }
  /// Drops all elements from position `count` on.
  void truncate(std::size_t count) {
    if (size_ > N && count <= N) std::copy_n(outside_.begin(), count, inside_);
    size_ = count;
  }

 private:
  /// Out of line, so that the usual path is short enough to be inlined.
  [[gnu::noinline]] void push_outside(const T& value) {
    const T kept = value;  // `value` may be one of these elements
    if (size_ == N) outside_.assign(inside_, inside_ + N);
    outside_.resize(size_);
    outside_.push_back(kept);
  }
  void take_inside(const SmallVector& other) {
    size_ = other.size_;
    if (size_ <= N) std::copy_n(other.inside_, size_, inside_);
  }

  union {
    T inside_[N];
  };
  std::vector<T> outside_;
  std::size_t size_ = 0;
};

}  // namespace graze
