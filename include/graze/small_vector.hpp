// A vector that keeps its first elements in place.
//
// Guarantee: no allocation up to N elements; no limit beyond. Elements are trivially copyable.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace graze {

template <class T, std::size_t N>
class SmallVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return size_ <= N ? inside_.data() : outside_.data(); }
  const T* data() const { return size_ <= N ? inside_.data() : outside_.data(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& back() { return data()[size_ - 1]; }
  const T& back() const { return data()[size_ - 1]; }

  void clear() { size_ = 0; }
  void push_back(const T& value) {
    if (size_ < N) {
      inside_[size_] = value;
    } else {
      if (size_ == N) outside_.assign(inside_.begin(), inside_.end());
      outside_.resize(size_);
      outside_.push_back(value);
    }
    ++size_;
  }
  /// Drops all elements from position `count` on.
  void truncate(std::size_t count) {
    if (size_ > N && count <= N)
      for (std::size_t i = 0; i < count; ++i) inside_[i] = outside_[i];
    size_ = count;
  }

 private:
  std::array<T, N> inside_{};
  std::vector<T> outside_;
  std::size_t size_ = 0;
};

}  // namespace graze
