// Sorting by the bits of a key: linear in the number of items, and stable.
//
// Guarantee: items with equal keys keep their order; key bits outside the digits are not looked at. Fewer than 2^32
// items.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace graze {

/// Some bits of a key: `bits` of them from `shift` on.
struct Digit {
  int shift, bits;
};

/// The digits that a sort looks at, the least significant first.
class Digits {
 public:
  /// The most bits in a digit: its counters fit into the first cache.
  static constexpr int most_bits = 11;
  static constexpr int most = 6;  ///< as many as 64 bits need

  /// Adds `bits` from `shift` on, as the fewest digits of about one size.
  void add(int shift, int bits) {
    for (int left = (bits + most_bits - 1) / most_bits; left > 0; --left) {
      const int size = (bits + left - 1) / left;
      digits_[count_++] = {shift, size};
      shift += size;
      bits -= size;
    }
  }
  std::size_t size() const { return count_; }
  /// The bucket of `key` in digit `i`.
  std::size_t bucket(std::uint64_t key, std::size_t i) const {
    return static_cast<std::size_t>(key >> digits_[i].shift) & ((std::size_t{1} << digits_[i].bits) - 1);
  }

 private:
  std::array<Digit, most> digits_{};
  std::size_t count_ = 0;
};

/// Sorts by radix, the least significant digit first (Knuth 1998, "The Art of Computer Programming", volume
/// 3, section 5.2.5); the buckets of all digits are counted in one go. Item i is `source(i)`, which is called
/// twice, and `key(item)` its key. `to` and `scratch` have room for `size` items each; returns the one of
/// them that holds the result.
template <class Item, class Source, class Key>
Item* radix_sort(std::size_t size, const Source& source, const Digits& digits, const Key& key, Item* to,
                 Item* scratch) {
  std::array<std::array<std::uint32_t, std::size_t{1} << Digits::most_bits>, Digits::most> begins;
  for (std::size_t d = 0; d < digits.size(); ++d) begins[d].fill(0);
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint64_t k = key(source(i));
    for (std::size_t d = 0; d < digits.size(); ++d) ++begins[d][digits.bucket(k, d)];
  }
  for (std::size_t d = 0; d < digits.size(); ++d) {
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begins[d]) sum += std::exchange(begin, sum);
  }
  const auto distribute = [&](std::size_t d, const auto& items) {
    for (std::size_t i = 0; i < size; ++i) {
      const Item item = items(i);
      to[begins[d][digits.bucket(key(item), d)]++] = item;
    }
  };
  if (digits.size() == 0)
    for (std::size_t i = 0; i < size; ++i) to[i] = source(i);
  for (std::size_t d = 0; d < digits.size(); ++d) {
    if (d == 0) {
      distribute(d, source);
      continue;
    }
    std::swap(to, scratch);
    distribute(d, [scratch](std::size_t i) { return scratch[i]; });
  }
  return to;
}

/// The number of bits that the numbers below `count` take.
inline int bits_below(std::uint64_t count) { return count <= 1 ? 0 : static_cast<int>(std::bit_width(count - 1)); }

}  // namespace graze
