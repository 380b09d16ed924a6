// A list that is filled anew in every update.
//
// Guarantee: elements are contiguous. Capacity is kept and not cleared, so that an update that finds about as much as
// the last one neither allocates nor writes anything twice.
#pragma once

#include <span>
#include <vector>

#include "graze/detail/standard.hpp"

namespace graze {

/// An array that is filled anew again and again, and keeps its capacity.
template <class E>
class Refilled {
 public:
  std::size_t size() const { return size_; }
  /// The first element.
  E* data() { return room_.data(); }
  /// All elements.
  std::span<E> filled() { return {room_.data(), size_}; }
  /// All elements.
  std::span<const E> filled() const { return {room_.data(), size_}; }

  /// Removes all elements and keeps the capacity.
  void clear() { size_ = 0; }
  /// Removes the elements from `size` on.
  void shorten(std::size_t size) { size_ = size; }
  /// Appends `count` elements that the caller has yet to write, and returns the address of the first.
  E* extend(std::size_t count) {
    // Growth by a sixteenth at least: capacity left at the end of an update may have to be cleared in the next one.
    if (room_.size() - size_ < count) room_.resize(size_ + count + size_ / 16 + 16);
    E* const first = room_.data() + size_;
    size_ += count;
    return first;
  }
  /// Appends one element.
  void push_back(const E& element) { *extend(1) = element; }

  /// The storage, to be swapped for another together with the elements.
  std::vector<E>& room() { return room_; }
  /// The number of elements there is room for.
  std::size_t capacity() const { return room_.capacity(); }

 private:
  std::vector<E> room_;
  std::size_t size_ = 0;
};

}  // namespace graze
