// The contact polygon of a single pair: its corners packed in a register, without gaps.
//
// Guarantee: the bits that the ring of slots (`contact_polygon.hpp`) gives in a lane. No branch depends on the number
// of corners, except where some are removed.
#pragma once

#include <cstdint>

#include "narrow/pairs/box_box/contact_polygon.hpp"
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace graze::detail {

/// The order of up to eight corners: their indices, a byte each; the bytes behind the last one are 0.
using Places = std::uint64_t;
constexpr std::uint64_t place(Places places, std::size_t i) { return places >> (8 * i) & 0xff; }

/// Orders of the corners that exist, of a rectangle (bits and indices 0 to 3) and of a parallelogram (4 to 7), by the
/// number of the parallelogram's sides that come before the rectangle's second (`ClippedFaces`); the last one in
/// ascending order. Not inline: kernels of different instruction sets share nothing.
struct CornerOrders {
  static constexpr std::size_t low_first = 3;
  Places of[4][256]{};
  std::uint8_t count[256]{};
  constexpr CornerOrders() {
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

/// Numbers of a single pair, out of its eight, that are processed at a time: as many as two registers hold.
template <class S>
inline constexpr int ring_step = Packed<S, 8>::parts > 2 ? 4 : 8;
/// Eight numbers of a single pair.
template <class S>
struct EightNumbers {
  static constexpr int step = ring_step<S>;
  Packed<S, step> some[8 / step];
};

/// The first numbers in a given order.
template <class S>
[[gnu::always_inline]] inline Packed<S, ring_step<S>> in_order(const EightNumbers<S>& all, Places places) {
  using Some = Packed<S, ring_step<S>>;
  Some r;
#if defined(__AVX2__)
  if constexpr (sizeof(S) == 4) {
    const __m256i to = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(places)));
    r.part[0].v = _mm256_permutevar8x32_ps(all.some[0].part[0].v, to);
    return r;
  }
#endif
#if defined(__AVX512F__)
  if constexpr (sizeof(S) == 8) {
    // All lanes chosen by a mask: g++ warns of the undefined values of the plain forms.
    const __m512i to = _mm512_maskz_cvtepu8_epi64(0xff, _mm_cvtsi64_si128(static_cast<long long>(places)));
    const __m512d from = __builtin_shufflevector(all.some[0].part[0].v, all.some[0].part[1].v, 0, 1, 2, 3, 4, 5, 6, 7);
    const __m512d found = _mm512_maskz_permutexvar_pd(0xff, to, from);
    r.part[0].v = __builtin_shufflevector(found, found, 0, 1, 2, 3);
    r.part[1].v = __builtin_shufflevector(found, found, 4, 5, 6, 7);
    return r;
  }
#endif
  S from[8];
  for (int i = 0; i < 8; i += ring_step<S>) all.some[i / ring_step<S>].store(from + i);
  using Part = typename Some::Part;
  constexpr auto per = static_cast<std::size_t>(Some::per);
  for (std::size_t i = 0; i < Some::parts; ++i) {
    const auto at = [&](std::size_t k) { return from[place(places, i * per + k)]; };
    if constexpr (per == 2)
      r.part[i].v = typename Part::Vector{at(0), at(1)};
    else if constexpr (per == 4)
      r.part[i].v = typename Part::Vector{at(0), at(1), at(2), at(3)};
  }
  return r;
}

template <class S>
requires std::is_arithmetic_v<S>
class ContactPolygon<S> {
 public:
  static constexpr bool single = true;
  static constexpr int step = ring_step<S>;
  using Mask = bool;
  using Some = Packed<S, step>;
  using Somes = typename Some::Mask;
  using Column = EightNumbers<S>;
  using All = S[most_contact_slots];

  Column x, y, apart;

  ContactPolygon(const Corners<S>& rectangle, const Corners<S>& parallelogram, bool p_first, bool q_first)
      : all_x_(column_of(rectangle.x, parallelogram.x)),
        all_y_(column_of(rectangle.y, parallelogram.y)),
        all_apart_(column_of(rectangle.apart, parallelogram.apart)) {
    take(static_cast<std::size_t>(p_first) + static_cast<std::size_t>(q_first),
         rectangle.are.bits() | parallelogram.are.bits() << 4);
  }
  /// Takes corners in order, each of which may be absent.
  ContactPolygon(const All& at_x, const All& at_y, const All& how_far, const bool (&are)[most_contact_slots])
      : all_x_(of(at_x)), all_y_(of(at_y)), all_apart_(of(how_far)) {
    unsigned bits = 0;
    for (unsigned i = 0; i < most_contact_slots; ++i) bits |= static_cast<unsigned>(are[i]) << i;
    take(CornerOrders::low_first, bits);
  }

  std::size_t size() const { return size_; }
  S count() const { return S(size_); }
  static const Some& some(const Column& column, std::size_t i) { return column.some[i / step]; }
  static void put(Column& column, std::size_t i, const Some& numbers) { column.some[i / step] = numbers; }
  Somes are(std::size_t i) const { return numbers(i) < Some(S(size_)); }
  Somes stay(std::size_t i) const { return numbers(i) == Some(deepest_); }
  static S as_bits(std::size_t i, const Somes& set) { return static_cast<S>(static_cast<int>(set.bits() << i)); }

  S find_deepest() {
    const Some none{S(std::numeric_limits<S>::infinity())};
    Some low = none, first = none;
    for (std::size_t i = 0; i < most_contact_slots; i += step) {
      const Somes deeper = are(i) & (some(apart, i) < low);
      low = select(deeper, some(apart, i), low);
      first = select(deeper, numbers(i), first);
    }
    const S least_apart = least_of(low);
    deepest_ = least_of(select(low == Some(least_apart), first, none));
    return least_apart;
  }

  S find_deepest_tilted(const FlatPoint<S>& tilt) {
    const Some none{S(std::numeric_limits<S>::infinity())}, tilt_x(tilt.x), tilt_y(tilt.y);
    Some low = none, low_tilted = none, first = none;
    for (std::size_t i = 0; i < most_contact_slots; i += step) {
      const Some tilted = some(apart, i) - (some(x, i) * tilt_x + some(y, i) * tilt_y);
      const Somes corners = are(i), deeper = corners & (tilted < low_tilted);
      low = select(corners, least(low, some(apart, i)), low);
      low_tilted = select(deeper, tilted, low_tilted);
      first = select(deeper, numbers(i), first);
    }
    deepest_ = least_of(select(low_tilted == Some(least_of(low_tilted)), first, none));
    return least_of(low);
  }

  void drop(std::size_t i, const Somes& corners) { gone_ |= corners.bits() << i; }
  void drop(std::size_t i, const bool (&corners)[step]) {
    for (unsigned k = 0; k < step; ++k) gone_ |= static_cast<unsigned>(corners[k]) << (i + k);
  }
  bool close_up() {
    if (gone_ == 0) return false;
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
    return true;
  }

  bool has(std::size_t i) const { return i < size_; }
  FlatPoint<S> at(std::size_t i) const { return {number(x, i), number(y, i)}; }
  S apart_at(std::size_t i) const { return number(apart, i); }

 private:
  static S number(const Column& column, std::size_t i) { return some(column, i)[static_cast<int>(i) % step]; }
  static Column column_of(const Packed<S, 4>& a, const Packed<S, 4>& b) {
    if constexpr (step == 4)
      return {a, b};
    else
      return {joined(a, b)};
  }
  static Column of(const All& all) {
    return column_of({all[0], all[1], all[2], all[3]}, {all[4], all[5], all[6], all[7]});
  }
  /// The slot numbers from `i` on.
  static Some numbers(std::size_t i) {
    if constexpr (step == 4)
      return Some(S(0), S(1), S(2), S(3)) + Some(S(i));
    else
      return Some(S(0), S(1), S(2), S(3), S(4), S(5), S(6), S(7));
  }
  void take(std::size_t order, unsigned bits) {
    places_ = corner_orders.of[order][bits];
    size_ = corner_orders.count[bits];
    read();
  }
  void read() {
    for (std::size_t i = 0; i < most_contact_slots; i += step) {
      put(x, i, in_order(all_x_, places_ >> (8 * i)));
      put(y, i, in_order(all_y_, places_ >> (8 * i)));
      put(apart, i, in_order(all_apart_, places_ >> (8 * i)));
    }
  }

  Column all_x_, all_y_, all_apart_;
  Places places_ = 0;
  std::size_t size_ = 0;
  S deepest_{};
  unsigned gone_ = 0;  ///< bits of the corners that `close_up` is to remove
};

template <class S>
requires std::is_arithmetic_v<S>
class Around<S> {
 public:
  using Some = typename ContactPolygon<S>::Some;
  using Column = typename ContactPolygon<S>::Column;

  /// The neighbours in a polygon with at least one corner.
  Around(const ContactPolygon<S>& ring, const Column& column) : column_(&column), size_(ring.size()) {}
  Some before(std::size_t i) const { return in_order(*column_, (0x0605040302010000 | (size_ - 1)) >> (8 * i)); }
  Some after(std::size_t i) const {
    return in_order(*column_, (0x0007060504030201 & ((Places{1} << (8 * (size_ - 1))) - 1)) >> (8 * i));
  }

 private:
  const Column* column_;
  std::size_t size_;
};

}  // namespace graze::detail
