// Sorting by the bits of a key: linear in the number of items, and stable.
//
// Guarantee: items with equal keys keep their order; key bits above `bits` are not looked at.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze {

/// A key with the place of what it belongs to.
struct KeyedPlace {
  std::uint64_t key;
  std::uint32_t place;
};

/// Least significant digit first, eleven bits at a time: a digit's counters fit into the first cache.
inline void radix_sort(std::vector<KeyedPlace>& items, std::vector<KeyedPlace>& scratch, int bits) {
  constexpr int digit = 11;
  constexpr std::size_t buckets = std::size_t{1} << digit;
  scratch.resize(items.size());
  for (int shift = 0; shift < bits; shift += digit) {
    std::array<std::uint32_t, buckets> begin{};
    const auto bucket = [shift](const KeyedPlace& item) { return (item.key >> shift) & (buckets - 1); };
    for (const KeyedPlace& item : items) ++begin[bucket(item)];
    std::uint32_t sum = 0;
    for (std::uint32_t& count : begin) sum += std::exchange(count, sum);
    for (const KeyedPlace& item : items) scratch[begin[bucket(item)]++] = item;
    items.swap(scratch);
  }
}

/// Unsigned numbers of 32 bits in the order of the finite numbers they are made of; the low digits of a `double` are
/// lost, so equal keys do not mean equal numbers.
inline std::uint32_t order_key(float v) {
  const auto bits = std::bit_cast<std::uint32_t>(v + 0.0f);
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}
inline std::uint32_t order_key(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v + 0.0);
  return static_cast<std::uint32_t>((bits & 0x8000000000000000u ? ~bits : bits | 0x8000000000000000u) >> 32);
}

}  // namespace graze
