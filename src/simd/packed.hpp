// A few numbers that undergo the same operations. Those of a single pair share registers of sixteen bytes, which every
// machine has; of many pairs each number is a register of its own already, one pair a lane. Code written once over
// these is quick for both.
//
// Guarantee: every operation is number by number the IEEE operation of the scalar, as in `graze/wide.hpp`: a pair has
// the same bits by itself and in a lane. All of it is inlined.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "graze/vec3.hpp"
#include "graze/wide.hpp"

namespace graze {

namespace detail {

typedef float Floats16 __attribute__((vector_size(16)));
typedef double Doubles16 __attribute__((vector_size(16)));
typedef float Floats32 __attribute__((vector_size(32)));
typedef double Doubles32 __attribute__((vector_size(32)));

/// The lanes of S, each of which has all bits set or none, as bits: the i-th is bit i.
template <class S, class V>
[[gnu::always_inline]] inline unsigned lane_bits(const V& lanes) {
#if defined(__AVX2__)
  if constexpr (sizeof(V) == 32 && sizeof(S) == 4)
    return static_cast<unsigned>(__builtin_ia32_movmskps256(reinterpret_cast<Floats32>(lanes)));
  else if constexpr (sizeof(V) == 32)
    return static_cast<unsigned>(__builtin_ia32_movmskpd256(reinterpret_cast<Doubles32>(lanes)));
  else  // NOLINT(readability-misleading-indentation): its statement depends on the processor
#endif
#if defined(__SSE2__)
      if constexpr (sizeof(S) == 4)
    return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Floats16>(lanes)));
  else  // NOLINT(readability-misleading-indentation): its statement depends on the processor, too
    return static_cast<unsigned>(__builtin_ia32_movmskpd(reinterpret_cast<Doubles16>(lanes)));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < sizeof(V) / sizeof(S); ++i) bits |= static_cast<unsigned>(lanes[i] & 1) << i;
  return bits;
#endif
}

}  // namespace detail

/// N numbers of S, a scalar or a lane type. Comparisons give a `Mask`; `select` chooses by it. The numbers that fill up
/// the last register may be anything.
template <class S, int N>
struct Packed {
  static constexpr bool joined = std::is_arithmetic_v<S>;
#if defined(__AVX2__)
  static constexpr std::size_t part_bytes = N == 8 ? 32 : 16;
#else
  static constexpr std::size_t part_bytes = 16;
#endif
  static constexpr int per = joined ? static_cast<int>(part_bytes / sizeof(S)) : 1;  ///< numbers in a part
  static constexpr int parts = (N + per - 1) / per;
  using Part = typename std::conditional_t<joined, std::type_identity<Wide<S, per>>, std::type_identity<S>>::type;
  using Condition = decltype(S() < S());
  using Parts = std::make_index_sequence<static_cast<std::size_t>(parts)>;

  struct Mask {
    typename Part::Mask part[parts];

    /// A mask with one condition for all numbers.
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
    /// Whether any of the N is set, for any pair.
    [[gnu::always_inline]] friend bool any(const Mask& mask) {
      constexpr int last = (N - (parts - 1) * per) * static_cast<int>(sizeof(S));
      if constexpr (joined && last < static_cast<int>(part_bytes)) {
        // The numbers that fill up the last part do not count.
        std::uint64_t two[2];
        std::memcpy(two, &mask.part[parts - 1].bits, sizeof two);
        std::uint64_t joint = last == 4 ? static_cast<std::uint32_t>(two[0]) : two[0];
        if constexpr (last == 12) joint |= static_cast<std::uint32_t>(two[1]);
        static_assert(parts < 3);
        if constexpr (parts == 2) joint |= static_cast<std::uint64_t>(any(mask.part[0]));
        return joint != 0;
      } else {
        auto joint = mask.part[0];
        for (int i = 1; i < parts; ++i) joint = joint | mask.part[i];
        return any(joint);
      }
    }
    /// The mask of a single pair: the i-th number is bit i.
    [[gnu::always_inline]] unsigned bits() const requires(joined) {
      unsigned found = 0;
      for (int i = 0; i < parts; ++i) found |= detail::lane_bits<S>(part[i].bits) << (i * per);
      return found & ((1u << N) - 1);
    }

    template <std::size_t... I, class F>
    [[gnu::always_inline]] static Mask each(std::index_sequence<I...>, const F& f) {
      return {{f(std::integral_constant<int, static_cast<int>(I)>{})...}};
    }
  };

  Part part[parts];

  [[gnu::always_inline]] Packed() : part{} {}
  /// N equal numbers.
  [[gnu::always_inline]] explicit Packed(const S& all) : Packed(Parts{}, [&](auto) { return Part(all); }) {}
  template <class... V>
  requires(sizeof...(V) + 1 == N && N > 1) [[gnu::always_inline]] Packed(const S& first, const V&... others)
      : Packed(Parts{}, [&](auto i) {
          const S all[parts * per] = {first, others...};
          return [&]<std::size_t... K>(std::index_sequence<K...>) {
            if constexpr (joined)
              return Part::of(typename Part::Vector{all[i * per + static_cast<int>(K)]...});
            else
              return all[i];
          }
          (std::make_index_sequence<static_cast<std::size_t>(per)>{});
        }) {}
  [[gnu::always_inline]] explicit Packed(const Vec3<S>& v) requires(N == 3) : Packed(v.x, v.y, v.z) {}

  /// Reads the N numbers, and those that fill up the last register.
  [[gnu::always_inline]] static Packed load(const S* from) {
    return Packed(Parts{}, [&](auto i) {
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
  /// Writes the N numbers, and those that fill up the last register.
  [[gnu::always_inline]] void store(S* to) const {
    if constexpr (joined)
      for (int i = 0; i < parts; ++i) part[i].store(to + i * per);
    else
      for (int i = 0; i < parts; ++i) to[i] = part[i];
  }

#define GRAZE_EACH(result, expression) return result(Parts{}, [&](auto i) { return expression; })
  [[gnu::always_inline]] friend Packed operator+(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, a.part[i] + b.part[i]);
  }
  [[gnu::always_inline]] friend Packed operator-(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, a.part[i] - b.part[i]);
  }
  [[gnu::always_inline]] friend Packed operator*(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, a.part[i] * b.part[i]);
  }
  [[gnu::always_inline]] friend Packed operator/(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, a.part[i] / b.part[i]);
  }
  [[gnu::always_inline]] friend Packed operator-(const Packed& a) { GRAZE_EACH(Packed, -a.part[i]); }
  [[gnu::always_inline]] friend Mask operator<(const Packed& a, const Packed& b) {
    GRAZE_EACH(Mask::each, a.part[i] < b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator<=(const Packed& a, const Packed& b) {
    GRAZE_EACH(Mask::each, a.part[i] <= b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator>(const Packed& a, const Packed& b) {
    GRAZE_EACH(Mask::each, a.part[i] > b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator>=(const Packed& a, const Packed& b) {
    GRAZE_EACH(Mask::each, a.part[i] >= b.part[i]);
  }
  [[gnu::always_inline]] friend Mask operator==(const Packed& a, const Packed& b) {
    GRAZE_EACH(Mask::each, a.part[i] == b.part[i]);
  }
  [[gnu::always_inline]] friend Packed select(const Mask& condition, const Packed& yes, const Packed& no) {
    GRAZE_EACH(Packed, select(condition.part[i], yes.part[i], no.part[i]));
  }
  [[gnu::always_inline]] friend Packed least(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, least(a.part[i], b.part[i]));
  }
  [[gnu::always_inline]] friend Packed greatest(const Packed& a, const Packed& b) {
    GRAZE_EACH(Packed, greatest(a.part[i], b.part[i]));
  }
  [[gnu::always_inline]] friend Packed abs(const Packed& a) { GRAZE_EACH(Packed, abs(a.part[i])); }
  [[gnu::always_inline]] friend Packed sqrt(const Packed& a) {
    using std::sqrt;
    GRAZE_EACH(Packed, sqrt(a.part[i]));
  }
#undef GRAZE_EACH

 private:
  template <std::size_t... I, class F>
  [[gnu::always_inline]] Packed(std::index_sequence<I...>, const F& f)
      : part{f(std::integral_constant<int, static_cast<int>(I)>{})...} {}
};

/// The I-th of three numbers, the J-th of three others and the K-th of further three.
template <int I, int J, int K, class S>
[[gnu::always_inline]] inline Packed<S, 3> gathered(const Packed<S, 3>& a, const Packed<S, 3>& b,
                                                    const Packed<S, 3>& c) {
  Packed<S, 3> r;
  if constexpr (!Packed<S, 3>::joined) {
    r.part[0] = a.part[I], r.part[1] = b.part[J], r.part[2] = c.part[K];
  } else if constexpr (Packed<S, 3>::per == 4) {
    r.part[0].v = __builtin_shufflevector(__builtin_shufflevector(a.part[0].v, b.part[0].v, I, 4 + J, I, 4 + J),
                                          c.part[0].v, 0, 1, 4 + K, 4 + K);
  } else {
    r.part[0].v = __builtin_shufflevector(a.part[I / 2].v, b.part[J / 2].v, I % 2, 2 + J % 2);
    r.part[1].v = __builtin_shufflevector(c.part[K / 2].v, c.part[K / 2].v, K % 2, K % 2);
  }
  return r;
}
/// Three numbers in another order, or some of them several times.
template <int I, int J, int K, class S>
[[gnu::always_inline]] inline Packed<S, 3> permuted(const Packed<S, 3>& a) {
  if constexpr (Packed<S, 3>::joined && Packed<S, 3>::per == 4) {
    Packed<S, 3> r;
    r.part[0].v = __builtin_shufflevector(a.part[0].v, a.part[0].v, I, J, K, K);
    return r;
  } else {
    return gathered<I, J, K>(a, a, a);
  }
}
/// Three numbers in a ring, each replaced by the one that follows it; `preceding` by the one before it.
template <class S>
[[gnu::always_inline]] inline Packed<S, 3> following(const Packed<S, 3>& a) {
  return permuted<1, 2, 0>(a);
}
template <class S>
[[gnu::always_inline]] inline Packed<S, 3> preceding(const Packed<S, 3>& a) {
  return permuted<2, 0, 1>(a);
}
/// One of N numbers, three times.
template <int I, class S, int N>
[[gnu::always_inline]] inline Packed<S, 3> spread(const Packed<S, N>& a) {
  using From = Packed<S, N>;
  if constexpr (!From::joined) {
    return Packed<S, 3>(a.part[I]);
  } else {
    constexpr int place = I % From::per;
    Packed<S, 3> r;
    for (auto& part : r.part) {
      if constexpr (From::per == 4)
        part.v = __builtin_shufflevector(a.part[0].v, a.part[0].v, place, place, place, place);
      else
        part.v = __builtin_shufflevector(a.part[I / 2].v, a.part[I / 2].v, place, place);
    }
    return r;
  }
}
/// The first three of four.
template <class S>
[[gnu::always_inline]] inline Packed<S, 3> first_three(const Packed<S, 4>& a) {
  Packed<S, 3> r;
  for (int i = 0; i < Packed<S, 3>::parts; ++i) r.part[i] = a.part[i];
  return r;
}
template <class S>
[[gnu::always_inline]] inline S sum(const Packed<S, 3>& a) {
  return a[0] + a[1] + a[2];
}
template <class S>
[[gnu::always_inline]] inline S greatest_of(const Packed<S, 3>& a) {
  return greatest(greatest(a[0], a[1]), a[2]);
}
template <class S>
[[gnu::always_inline]] inline S least_of(const Packed<S, 3>& a) {
  return least(least(a[0], a[1]), a[2]);
}

/// Four numbers of a single pair and four more.
template <class S>
[[gnu::always_inline]] inline Packed<S, 8> joined(const Packed<S, 4>& a, const Packed<S, 4>& b) {
  using Four = Packed<S, 4>;
  using Eight = Packed<S, 8>;
  Eight r;
  if constexpr (Eight::per == Four::per) {
    for (int i = 0; i < Four::parts; ++i) r.part[i] = a.part[i], r.part[Four::parts + i] = b.part[i];
  } else if constexpr (sizeof(S) == 4) {
    r.part[0].v = __builtin_shufflevector(a.part[0].v, b.part[0].v, 0, 1, 2, 3, 4, 5, 6, 7);
  } else {
    r.part[0].v = __builtin_shufflevector(a.part[0].v, a.part[1].v, 0, 1, 2, 3);
    r.part[1].v = __builtin_shufflevector(b.part[0].v, b.part[1].v, 0, 1, 2, 3);
  }
  return r;
}
/// The least of four or eight numbers of a single pair.
template <class S, int N>
requires(N % 4 == 0) [[gnu::always_inline]] inline S least_of(const Packed<S, N>& a) {
  auto low = a.part[0];
  for (int i = 1; i < Packed<S, N>::parts; ++i) low = least(low, a.part[i]);
  if constexpr (Packed<S, N>::per == 8) {
    const auto four = least(Wide<S, 4>::of(__builtin_shufflevector(low.v, low.v, 0, 1, 2, 3)),
                            Wide<S, 4>::of(__builtin_shufflevector(low.v, low.v, 4, 5, 6, 7)));
    const auto two = least(four, Wide<S, 4>::of(__builtin_shufflevector(four.v, four.v, 2, 3, 2, 3)));
    return least(two[0], two[1]);
  } else {
    S one = low[0];
    for (int i = 1; i < Packed<S, N>::per; ++i) one = least(one, low[i]);
    return one;
  }
}

/// The numbers at these places of four numbers and four more, which are counted on from 4.
template <int I, int J, int K, int L, class S>
[[gnu::always_inline]] inline Packed<S, 4> mixed(const Packed<S, 4>& a, const Packed<S, 4>& b) {
  using Four = Packed<S, 4>;
  const auto part = [&](auto i) -> const auto& { return (i < 4 ? a : b).part[i % 4 / Four::per]; };
  Four r;
  if constexpr (!Four::joined) {
    r.part[0] = part(I), r.part[1] = part(J), r.part[2] = part(K), r.part[3] = part(L);
  } else if constexpr (Four::per == 4) {
    r.part[0].v = __builtin_shufflevector(a.part[0].v, b.part[0].v, I, J, K, L);
  } else {
    r.part[0].v = __builtin_shufflevector(part(I).v, part(J).v, I % 2, 2 + J % 2);
    r.part[1].v = __builtin_shufflevector(part(K).v, part(L).v, K % 2, 2 + L % 2);
  }
  return r;
}
template <int I, int J, int K, int L, class S>
[[gnu::always_inline]] inline Packed<S, 4> permuted(const Packed<S, 4>& a) {
  return mixed<I, J, K, L>(a, a);
}
/// The first two of three numbers and of three others.
template <class S>
[[gnu::always_inline]] inline Packed<S, 4> pairs(const Packed<S, 3>& a, const Packed<S, 3>& b) {
  Packed<S, 4> r;
  if constexpr (!Packed<S, 3>::joined) {
    r.part[0] = a.part[0], r.part[1] = a.part[1], r.part[2] = b.part[0], r.part[3] = b.part[1];
  } else if constexpr (Packed<S, 3>::per == 4) {
    r.part[0].v = __builtin_shufflevector(a.part[0].v, b.part[0].v, 0, 1, 4, 5);
  } else {
    r.part[0] = a.part[0], r.part[1] = b.part[0];
  }
  return r;
}

}  // namespace graze
