// A few numbers that the same is done to. Of a single pair they share registers of sixteen bytes, which every machine
// has; of many pairs each is a register of its own already, one pair a lane. What is written once over these is quick
// for both.
//
// Guarantee: every operation is number by number the IEEE operation of the scalar, as in `graze/wide.hpp`: the same
// bits of a pair by itself and in a lane. All of it is inlined.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "graze/vec3.hpp"
#include "graze/wide.hpp"

namespace graze {

/// N numbers of S, a scalar or a lane type. Comparisons give a `Mask`; `select` chooses by it. Numbers that fill the
/// last register up are zero at first.
template <class S, int N>
struct Several {
  static constexpr bool joined = std::is_arithmetic_v<S>;
  static constexpr int per = joined ? static_cast<int>(16 / sizeof(S)) : 1;  ///< numbers in a part
  static constexpr int parts = (N + per - 1) / per;
  using Part = typename std::conditional_t<joined, std::type_identity<Wide<S, per>>, std::type_identity<S>>::type;
  using Condition = decltype(S() < S());
  using Parts = std::make_index_sequence<static_cast<std::size_t>(parts)>;

  struct Mask {
    typename Part::Mask part[parts];

    /// The same for all.
    [[gnu::always_inline]] static Mask of(const Condition& all) {
      return each(Parts{}, [&](auto) {
        if constexpr (joined)
          return typename Part::Mask{typename Part::BitVector{} - static_cast<typename Part::Bits>(all)};
        else
          return all;
      });
    }

    [[gnu::always_inline]] friend Mask operator&(const Mask& a, const Mask& b) {
      return each(Parts{}, [&](auto i) { return a.part[i] & b.part[i]; });
    }
    [[gnu::always_inline]] friend Mask operator|(const Mask& a, const Mask& b) {
      return each(Parts{}, [&](auto i) { return a.part[i] | b.part[i]; });
    }
    [[gnu::always_inline]] friend Mask operator!(const Mask& a) {
      return each(Parts{}, [&](auto i) { return !a.part[i]; });
    }
    [[gnu::always_inline]] Condition operator[](int i) const {
      if constexpr (joined)
        return part[i / per][i % per];
      else
        return part[i];
    }
    [[gnu::always_inline]] void store(decltype(S() < S())* to) const {
      for (int i = 0; i < N; ++i) to[i] = (*this)[i];
    }
    /// Whether any is set, of any pair.
    [[gnu::always_inline]] friend bool any(const Mask& mask) {
      auto joint = mask.part[0];
      for (int i = 1; i < parts; ++i) joint = joint | mask.part[i];
      if constexpr (joined) {
        std::uint64_t halves[2];
        std::memcpy(halves, &joint.bits, sizeof halves);
        return (halves[0] | halves[1]) != 0;
      } else {
        return any(joint);
      }
    }

    template <std::size_t... I, class F>
    [[gnu::always_inline]] static Mask each(std::index_sequence<I...>, const F& f) {
      return {{f(std::integral_constant<int, static_cast<int>(I)>{})...}};
    }
  };

  Part part[parts];

  [[gnu::always_inline]] Several() : part{} {}
  /// All the same.
  [[gnu::always_inline]] explicit Several(const S& all) : Several(Parts{}, [&](auto) { return Part(all); }) {}
  template <class... V>
  requires(sizeof...(V) + 1 == N && N > 1) [[gnu::always_inline]] Several(const S& first, const V&... others)
      : Several(Parts{}, [&](auto i) {
          const S all[parts * per] = {first, others...};
          return [&]<std::size_t... K>(std::index_sequence<K...>) {
            if constexpr (joined)
              return Part::of(typename Part::Vector{all[i * per + static_cast<int>(K)]...});
            else
              return all[i];
          }
          (std::make_index_sequence<static_cast<std::size_t>(per)>{});
        }) {}
  [[gnu::always_inline]] explicit Several(const Vec3<S>& v) requires(N == 3) : Several(v.x, v.y, v.z) {}

  [[gnu::always_inline]] static Several load(const S* from) requires(N == parts * per) {
    return Several(Parts{}, [&](auto i) {
      if constexpr (joined)
        return Part::load(from + i * per);
      else
        return from[i];
    });
  }

  [[gnu::always_inline]] S operator[](int i) const {
    if constexpr (joined)
      return part[i / per][i % per];
    else
      return part[i];
  }
  /// Writes the N numbers, and those that fill the last register up.
  [[gnu::always_inline]] void store(S* to) const {
    if constexpr (joined)
      for (int i = 0; i < parts; ++i) part[i].store(to + i * per);
    else
      for (int i = 0; i < parts; ++i) to[i] = part[i];
  }

#define GRAZE_EACH(result, expression) return result(Parts{}, [&](auto i) { return expression; })
  [[gnu::always_inline]] friend Several operator+(const Several& a, const Several& b) {
    GRAZE_EACH(Several, a.part[i] + b.part[i]);
  }
  [[gnu::always_inline]] friend Several operator-(const Several& a, const Several& b) {
    GRAZE_EACH(Several, a.part[i] - b.part[i]);
  }
  [[gnu::always_inline]] friend Several operator*(const Several& a, const Several& b) {
    GRAZE_EACH(Several, a.part[i] * b.part[i]);
  }
  [[gnu::always_inline]] friend Several operator/(const Several& a, const Several& b) {
    GRAZE_EACH(Several, a.part[i] / b.part[i]);
  }
  [[gnu::always_inline]] friend Several operator-(const Several& a) { GRAZE_EACH(Several, -a.part[i]); }
  [[gnu::always_inline]] friend Mask operator<(const Several& a, const Several& b) {
    GRAZE_EACH(Mask::each, a.part[i] < b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator<=(const Several& a, const Several& b) {
    GRAZE_EACH(Mask::each, a.part[i] <= b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator>(const Several& a, const Several& b) {
    GRAZE_EACH(Mask::each, a.part[i] > b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator>=(const Several& a, const Several& b) {
    GRAZE_EACH(Mask::each, a.part[i] >= b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator==(const Several& a, const Several& b) {
    GRAZE_EACH(Mask::each, a.part[i] == b.part[i]);
  }
  [[gnu::always_inline]] friend Several select(const Mask& condition, const Several& yes, const Several& no) {
    GRAZE_EACH(Several, select(condition.part[i], yes.part[i], no.part[i]));
  }
  [[gnu::always_inline]] friend Several least(const Several& a, const Several& b) {
    GRAZE_EACH(Several, least(a.part[i], b.part[i]));
  }
  [[gnu::always_inline]] friend Several greatest(const Several& a, const Several& b) {
    GRAZE_EACH(Several, greatest(a.part[i], b.part[i]));
  }
  [[gnu::always_inline]] friend Several abs(const Several& a) { GRAZE_EACH(Several, abs(a.part[i])); }
  [[gnu::always_inline]] friend Several sqrt(const Several& a) {
    using std::sqrt;
    GRAZE_EACH(Several, sqrt(a.part[i]));
  }
#undef GRAZE_EACH

  /// In the place of each of three the one that follows it in a ring, or precedes it.
  [[gnu::always_inline]] friend Several following(const Several& a) requires(N == 3) { return {a[1], a[2], a[0]}; }
  [[gnu::always_inline]] friend Several preceding(const Several& a) requires(N == 3) { return {a[2], a[0], a[1]}; }

 private:
  template <std::size_t... I, class F>
  [[gnu::always_inline]] Several(std::index_sequence<I...>, const F& f)
      : part{f(std::integral_constant<int, static_cast<int>(I)>{})...} {}
};

}  // namespace graze
