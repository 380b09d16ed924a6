// The corners of an outline of a single pair: a register of them, without gaps.
//
// Guarantee: the bits of the ring of slots (`box_ring.hpp`) for a lane. No jump depends on how many corners there are.
#pragma once

#include <cstdint>

#include "narrow/pairs/box_ring.hpp"
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace graze {

namespace detail {

/// Which of eight come in what order, a byte each; the bytes behind the last one are 0.
using Places = std::uint64_t;
constexpr std::uint64_t place(Places places, std::size_t i) { return places >> (8 * i) & 0xff; }

/// The corners of a rectangle (bits and places 0 to 3) and of a parallelogram (4 to 7) that there are, in order, by how
/// many of the parallelogram's sides come before the rectangle's second (`LaidOver`); and the lower ones first. Not
/// inline: kernels of different levels share nothing.
struct CornerOrders {
  static constexpr std::size_t low_first = 3;
  Places of[4][256];
  std::uint8_t count[256];
  constexpr CornerOrders() : of{}, count{} {
    constexpr unsigned all[4][8] = {
        {0, 1, 4, 5, 2, 3, 6, 7}, {0, 4, 1, 5, 2, 6, 3, 7}, {0, 4, 5, 1, 2, 6, 7, 3}, {0, 1, 2, 3, 4, 5, 6, 7}};
    for (unsigned bits = 0; bits < 256; ++bits)
      for (unsigned order = 0; order < 4; ++order) {
        unsigned to = 0;
        for (const unsigned corner : all[order])
          if (bits >> corner & 1) of[order][bits] |= Places{corner} << (8 * to++);
        count[bits] = static_cast<std::uint8_t>(to);
      }
  }
};
static constexpr CornerOrders corner_orders;

/// Eight numbers in that order.
template <class S>
[[gnu::always_inline]] inline Several<S, 8> in_order(const Several<S, 8>& all, Places places) {
  Several<S, 8> r;
#if defined(__AVX2__)
  if constexpr (sizeof(S) == 4) {
    const __m256i to = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places)));
    r.part[0].v = _mm256_permutevar8x32_ps(all.part[0].v, to);
    return r;
  }
#endif
#if defined(__AVX512F__)
  if constexpr (sizeof(S) == 8) {
    // With all lanes chosen: g++ takes what the plain forms leave undefined for a mistake.
    const __m512i to = _mm512_maskz_cvtepu8_epi64(0xff, _mm_cvtsi64_si128(static_cast<long long>(places)));
    const __m512d from = __builtin_shufflevector(all.part[0].v, all.part[1].v, 0, 1, 2, 3, 4, 5, 6, 7);
    const __m512d found = _mm512_maskz_permutexvar_pd(0xff, to, from);
    r.part[0].v = __builtin_shufflevector(found, found, 0, 1, 2, 3);
    r.part[1].v = __builtin_shufflevector(found, found, 4, 5, 6, 7);
    return r;
  }
#endif
  S from[8];
  all.store(from);
  return {from[place(places, 0)], from[place(places, 1)], from[place(places, 2)], from[place(places, 3)],
          from[place(places, 4)], from[place(places, 5)], from[place(places, 6)], from[place(places, 7)]};
}

template <class S>
requires std::is_arithmetic_v<S>
class Ring<S> {
 public:
  static constexpr bool single = true;
  static constexpr int step = 8;  ///< all are done at once
  using Mask = bool;
  using Some = Several<S, 8>;
  using Somes = typename Some::Mask;
  using Column = Some;
  using All = S[most_box_points];

  Column x, y, apart;

  Ring(const Corners<S>& rectangle, const Corners<S>& parallelogram, bool p_first, bool q_first)
      : all_x_(joined(rectangle.x, parallelogram.x)),
        all_y_(joined(rectangle.y, parallelogram.y)),
        all_apart_(joined(rectangle.apart, parallelogram.apart)) {
    take(static_cast<std::size_t>(p_first) + static_cast<std::size_t>(q_first),
         rectangle.are.bits() | parallelogram.are.bits() << 4);
  }
  /// From corners in order, each of which may be none.
  Ring(const All& at_x, const All& at_y, const All& how_far, const bool (&are)[most_box_points])
      : all_x_(of(at_x)), all_y_(of(at_y)), all_apart_(of(how_far)) {
    unsigned bits = 0;
    for (unsigned i = 0; i < most_box_points; ++i) bits |= static_cast<unsigned>(are[i]) << i;
    take(CornerOrders::low_first, bits);
  }

  std::size_t size() const { return size_; }
  S count() const { return S(size_); }
  static const Some& some(const Column& column, std::size_t) { return column; }
  static void put(Column& column, std::size_t, const Some& numbers) { column = numbers; }
  Somes are(std::size_t) const { return numbers() < Some(S(size_)); }
  Somes stay(std::size_t) const { return numbers() == Some(deepest_); }
  static Some powers(std::size_t) { return {S(1), S(2), S(4), S(8), S(16), S(32), S(64), S(128)}; }

  S find_deepest() {
    const Some none{S(std::numeric_limits<S>::infinity())}, low = select(are(0) & (apart < none), apart, none);
    const S least_apart = least_of(low);
    deepest_ = least_of(select(low == Some(least_apart), numbers(), none));
    return least_apart;
  }

  void drop(std::size_t, const Somes& corners) { gone_ |= corners.bits(); }
  void drop(std::size_t, const bool (&corners)[step]) {
    for (unsigned i = 0; i < step; ++i) gone_ |= static_cast<unsigned>(corners[i]) << i;
  }
  void close_up() {
    if (gone_ == 0) return;
    Places kept = 0;
    std::size_t count = 0, deepest = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (S(i) == deepest_) deepest = count;
      if (gone_ >> i & 1) continue;
      kept |= place(places_, i) << (8 * count++);
    }
    places_ = kept;
    size_ = count;
    deepest_ = S(deepest);
    gone_ = 0;
    read();
  }

  bool has(std::size_t i) const { return i < size_; }
  FlatPoint<S> at(std::size_t i) const { return {x[static_cast<int>(i)], y[static_cast<int>(i)]}; }
  S apart_at(std::size_t i) const { return apart[static_cast<int>(i)]; }

 private:
  static Some of(const All& all) { return {all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7]}; }
  static Some numbers() { return {S(0), S(1), S(2), S(3), S(4), S(5), S(6), S(7)}; }
  void take(std::size_t order, unsigned bits) {
    places_ = corner_orders.of[order][bits];
    size_ = corner_orders.count[bits];
    read();
  }
  void read() {
    x = in_order(all_x_, places_);
    y = in_order(all_y_, places_);
    apart = in_order(all_apart_, places_);
  }

  Some all_x_, all_y_, all_apart_;
  Places places_ = 0;
  std::size_t size_ = 0;
  S deepest_{};
  unsigned gone_ = 0;  ///< bits of those that `close_up` is to take out
};

template <class S>
requires std::is_arithmetic_v<S>
class Around<S> {
 public:
  using Some = typename Ring<S>::Some;

  /// `column` of a ring with at least one corner.
  Around(const Ring<S>& ring, const Some& column) : column_(column), size_(ring.size()) {}
  Some before(std::size_t) const { return in_order(column_, 0x0605040302010000 | (size_ - 1)); }
  Some after(std::size_t) const {
    return in_order(column_, 0x0007060504030201 & ((Places{1} << (8 * (size_ - 1))) - 1));
  }

 private:
  const Some& column_;
  std::size_t size_;
};

}  // namespace detail

}  // namespace graze
