// Steps of a ray's traversal of a tree of triangles: the ray in a node's eight-bit coordinates, the children that it
// enters, and the triangles of a leaf that it may cross. Only for `*.kernel.cpp`.
//
// Guarantee: that of `bvh_traversal.hpp`: no triangle that the ray crosses is left out. Everything is inlined or lives
// in the namespace of the level.
#pragma once

#include "rays/bvh_traversal.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA::tree {

inline constexpr int width = TreeNode<float>::width;

/// Number of registers that hold the children of a node: one or two.
inline constexpr int part_lanes = register_bytes >= 32 ? 8 : 4, parts = width / part_lanes;
using ChildLanes = Wide<float, part_lanes>;
using Quad = Wide<float, 4>;

template <class V>
[[gnu::always_inline]] inline V cast_bits(const auto& from) {
  static_assert(sizeof(V) == sizeof from);
  return reinterpret_cast<V>(from);
}

/// `least` and `greatest`, which select by a mask, in one instruction; the second operand for equal ones, and for NaN.
template <int N>
[[gnu::always_inline]] inline Wide<float, N> lesser(const Wide<float, N>& a, const Wide<float, N>& b) {
  using W [[maybe_unused]] = Wide<float, N>;
#if defined(__AVX2__)
  if constexpr (N == 8)
    return W::of(cast_bits<typename W::Vector>(_mm256_min_ps(cast_bits<__m256>(a.v), cast_bits<__m256>(b.v))));
#endif
#if defined(__SSE2__)
  if constexpr (N == 4)
    return W::of(cast_bits<typename W::Vector>(_mm_min_ps(cast_bits<__m128>(a.v), cast_bits<__m128>(b.v))));
#endif
  return select(a < b, a, b);
}
template <int N>
[[gnu::always_inline]] inline Wide<float, N> larger(const Wide<float, N>& a, const Wide<float, N>& b) {
  using W [[maybe_unused]] = Wide<float, N>;
#if defined(__AVX2__)
  if constexpr (N == 8)
    return W::of(cast_bits<typename W::Vector>(_mm256_max_ps(cast_bits<__m256>(a.v), cast_bits<__m256>(b.v))));
#endif
#if defined(__SSE2__)
  if constexpr (N == 4)
    return W::of(cast_bits<typename W::Vector>(_mm_max_ps(cast_bits<__m128>(a.v), cast_bits<__m128>(b.v))));
#endif
  return select(b < a, a, b);
}

[[gnu::always_inline]] inline std::uint32_t first_bit(std::uint32_t bits) {
  return static_cast<std::uint32_t>(__builtin_ctz(bits));
}

/// Eight bytes as numbers.
[[gnu::always_inline]] inline void load_bytes(const std::uint8_t* from, ChildLanes (&to)[parts]) {
#if defined(__AVX2__)
  const __m256i words = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)));
  to[0].v = cast_bits<ChildLanes::Vector>(_mm256_cvtepi32_ps(words));
#elif defined(__SSE2__)
  const __m128i zero = _mm_setzero_si128();
  const __m128i words = _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)), zero);
  to[0].v = cast_bits<ChildLanes::Vector>(_mm_cvtepi32_ps(_mm_unpacklo_epi16(words, zero)));
  to[1].v = cast_bits<ChildLanes::Vector>(_mm_cvtepi32_ps(_mm_unpackhi_epi16(words, zero)));
#else
  for (int i = 0; i < 8; ++i) to[i / part_lanes].set(i % part_lanes, static_cast<float>(from[i]));
#endif
}

/// Four 16-bit words as numbers.
[[gnu::always_inline]] inline Quad load_words(const std::uint16_t* from) {
#if defined(__SSE2__)
  const __m128i words = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from));
  return Quad::of(cast_bits<Quad::Vector>(_mm_cvtepi32_ps(_mm_unpacklo_epi16(words, _mm_setzero_si128()))));
#else
  Quad q;
  for (int i = 0; i < 4; ++i) q.set(i, static_cast<float>(from[i]));
  return q;
#endif
}

/// A key consists of the bits of a positive number, the last of which are replaced by the child's slot: all keys of a
/// node then differ, and order as integers as they do as numbers.
inline constexpr std::int32_t absent = 0x7f7fffff;

[[gnu::always_inline]] inline std::int32_t number_bits(float number) {
  std::int32_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

/// The keys of `count` children.
template <int count>
struct KeysOf {
  static constexpr int parts = count / part_lanes;
  static constexpr std::int32_t place_bits = count - 1;
  ChildLanes part[parts];

  /// The children's slots, from the part's first on.
  [[gnu::always_inline]] static ChildLanes::BitVector places(int k) {
    ChildLanes::BitVector place{};
    for (int i = 0; i < part_lanes; ++i) place[i] = k * part_lanes + i;
    return place;
  }
  [[gnu::always_inline]] void set(int k, const ChildLanes& enter, const ChildLanes::BitVector& met) {
    const auto key = (cast_bits<ChildLanes::BitVector>(enter.v) & ~place_bits) | places(k);
    part[k].v = cast_bits<ChildLanes::Vector>((key & met) | (absent & ~met));
  }
  [[gnu::always_inline]] std::int32_t least() const {
    ChildLanes all = part[0];
    for (int k = 1; k < parts; ++k) all = lesser(all, part[k]);
    Quad q;
#if defined(__AVX2__)
    const auto eight = cast_bits<__m256>(all.v);
    q.v = cast_bits<Quad::Vector>(_mm_min_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1)));
#else
    q = all;
#endif
    q = lesser(q, Quad::of(__builtin_shufflevector(q.v, q.v, 2, 3, 0, 1)));
    q = lesser(q, Quad::of(__builtin_shufflevector(q.v, q.v, 1, 0, 3, 2)));
    return number_bits(q[0]);
  }
  /// A bit for each key up to `limit`.
  [[gnu::always_inline]] std::uint32_t up_to(std::int32_t limit) const {
    std::uint32_t bits = 0;
    for (int k = 0; k < parts; ++k)
      bits |= bits_of(typename ChildLanes::Mask{cast_bits<ChildLanes::BitVector>(part[k].v) <= limit})
              << (k * part_lanes);
    return bits;
  }
  [[gnu::always_inline]] void remove(std::int32_t key) {
    for (ChildLanes& p : part) {
      const auto bits = cast_bits<ChildLanes::BitVector>(p.v), gone = cast_bits<ChildLanes::BitVector>(bits == key);
      p.v = cast_bits<ChildLanes::Vector>((bits & ~gone) | (absent & gone));
    }
  }
  [[gnu::always_inline]] void store(float (&to)[count]) const {
    for (int k = 0; k < parts; ++k) part[k].store(to + k * part_lanes);
  }
  [[gnu::always_inline]] void load(const float (&from)[count]) {
    for (int k = 0; k < parts; ++k) part[k] = ChildLanes::load(from + k * part_lanes);
  }
};
using Keys = KeysOf<width>;

template <class T>
inline constexpr double rounding_of = sizeof(T) == 4 ? 0x1p-23 : 0x1p-52;
inline constexpr double single = rounding_of<float>;
inline constexpr float least_float = 1.17549435e-38f;

using Doubles = Wide<double, 4>;

[[gnu::always_inline]] inline Doubles doubles(double x, double y, double z) {
  return Doubles::of(Doubles::Vector{x, y, z, 1});
}
template <class T>
[[gnu::always_inline]] inline Wide<T, 4> narrowed(const Doubles& d) {
  return Wide<T, 4>::of(__builtin_convertvector(d.v, typename Wide<T, 4>::Vector));
}

/// The ray in numbers of the tree's type, and in single precision in units of `unit`, so that none over- or underflows.
/// Keys measure positions along the ray from 2 radii before its origin, so that all hits have positive ones.
template <class T>
struct BvhRay {
  // For the boxes, an axis a lane: a step of the node's frame is `inverse` times it along the ray, and the frame's
  // origin `inverse` times it less `first` at the earliest, less `last` at the latest.
  Wide<T, 4> inverse, first, last;
  std::uint32_t enter[3], leave[3];  ///< offsets in a node of the sides that the ray comes to first and last
  float begin;                       ///< a key

  std::uint32_t axis[3];  ///< for the triangles: the coordinate that is x, y and z of a frame along the ray
  T sheared_origin[3];    ///< origin of that frame, in its own order
  T scale, part_scale;    ///< 1 / unit, and that for a part of a step
  float shear_x, shear_y;
  float off;  ///< displacement of a corner in the frame by rounding

  double start, per_length, around;

  /// An upper bound of the keys of all that the ray meets by `t`; not above zero if it meets nothing.
  [[gnu::always_inline]] float key(double t) const {
    const double number = (t - start) * per_length + around;
    return static_cast<float>(number < 0x1p100 ? number : 0x1p100) * (1 + 4 * static_cast<float>(single));
  }

  [[gnu::always_inline]] BvhRay() {}  // NOLINT(modernize-use-equals-default): leaves the lanes uninitialised
  template <class Question>
  [[gnu::always_inline]] explicit BvhRay(const Question& q) {
    // Any multiple of the radius whose inverse, times 2^33, is a number in T.
    constexpr double greatest_unit = sizeof(T) == 4 ? 0x1p80 : 0x1p900;
    double unit = 8 * q.radius;
    unit = unit < greatest_unit ? unit : greatest_unit;
    unit = unit > 1 / greatest_unit ? unit : 1 / greatest_unit;
    per_length = 1 / unit;
    start = -2 * q.radius;
    // Coordinates are up to M = 2 (extent + 2 radii). Rounding in T moves a crossing, times the direction, by less than
    // 2 epsilon of M (half a one for the bounds themselves, a product, the constants and their difference) and 4 of the
    // radius, rounding in float by 9 epsilon of the radius, and rounding of the ray itself by some ten of double's.
    const double most = 2 * (q.extent + 2 * q.radius);
    const double blur = (4 * rounding_of<T> + 16 * rounding_of<double>)*most + 32 * single * q.radius;
    around = 2 * blur * per_length + static_cast<double>(least_float);
    // Error of a coordinate of the frame along the ray: in T half an epsilon of each number, in float less than 28 of
    // the radius.
    off = static_cast<float>((8 * rounding_of<T> * most + 32 * single * q.radius) * per_length);
    scale = static_cast<T>(per_length);
    part_scale = static_cast<T>(per_length * (1.0 / PackedLeaf::parts));

    // No branch on a sign, which would cost callers who cast rays in all directions.
    const double x = q.direction[0], y = q.direction[1], z = q.direction[2];
    const Doubles d = doubles(x, y, z), from = doubles(q.origin[0], q.origin[1], q.origin[2]) + d * Doubles(start);
    // Slower components cross less than a rounding of the radius in single precision.
    constexpr double slowest = 0x1p-32;
    const Doubles inverse_size = Doubles(1.0) / (greatest(abs(d), Doubles(slowest)) * Doubles(unit));
    inverse = narrowed<T>(select(d < Doubles(0.0), -inverse_size, inverse_size));
    // With the rounded inverse: its error then grows with the distance and not with the coordinates.
    const Doubles at = from * Doubles::of(__builtin_convertvector(inverse.v, Doubles::Vector));
    const Doubles widening = inverse_size * Doubles(blur) + Doubles(static_cast<double>(least_float));
    first = narrowed<T>(at + widening);
    last = narrowed<T>(at - widening);
    for (std::uint32_t i = 0; i < 3; ++i) {
      constexpr std::uint32_t lower = offsetof(TreeNode<T>, lower), upper = offsetof(TreeNode<T>, upper),
                              side = static_cast<std::uint32_t>(width);
      const std::uint32_t back = (upper - lower) * static_cast<std::uint32_t>(q.direction[i] < 0);
      enter[i] = lower + side * i + back;
      leave[i] = upper + side * i - back;
    }
    begin = larger(Quad(static_cast<float>(((q.begin - start) * per_length - around) * (1 - 4 * single))),
                   Quad(least_float))[0];

    const double size_x = x < 0 ? -x : x, size_y = y < 0 ? -y : y, size_z = z < 0 ? -z : z;
    const double x_or_y = size_y > size_x ? size_y : size_x;
    axis[2] = size_z > x_or_y ? 2 : static_cast<std::uint32_t>(size_y > size_x);
    axis[0] = axis[2] == 2 ? 0 : axis[2] + 1;
    axis[1] = axis[2] == 0 ? 2 : axis[2] - 1;
    const double along = 1 / q.direction[axis[2]];
    shear_x = static_cast<float>(q.direction[axis[0]] * along);
    shear_y = static_cast<float>(q.direction[axis[1]] * along);
    for (int i = 0; i < 3; ++i) sheared_origin[i] = static_cast<T>(q.origin[axis[i]]);
  }
};

/// The frame of a node along the ray, an axis a lane; differences are taken before they are rounded to float.
struct Frame {
  Quad scale, first, last;
  [[gnu::always_inline]] Frame(const BvhRay<float>& bvh_ray, const TreeNode<float>& node) {
    const Quad from = Quad::load(node.origin) * bvh_ray.inverse;
    first = from - bvh_ray.first;
    last = from - bvh_ray.last;
    // Not from `step` on: behind it are NaNs, which some processors are slow at.
    const Quad steps = Quad::load(node.origin + 2);
    scale = Quad::of(__builtin_shufflevector(steps.v, steps.v, 1, 2, 3, 3)) * bvh_ray.inverse;
  }
  [[gnu::always_inline]] Frame(const BvhRay<double>& bvh_ray, const TreeNode<double>& node) {
    for (int i = 0; i < 3; ++i) {
      const double from = node.origin[i] * bvh_ray.inverse[i];
      first.set(i, static_cast<float>(from - bvh_ray.first[i]));
      last.set(i, static_cast<float>(from - bvh_ray.last[i]));
      scale.set(i, static_cast<float>(node.step[i] * bvh_ray.inverse[i]));
    }
  }
};

/// The keys at which the ray enters each of a node's children by `limit`.
template <class T>
[[gnu::always_inline]] inline Keys crossed(const BvhRay<T>& bvh_ray, const TreeNode<T>& node, float limit) {
  const Frame frame(bvh_ray, node);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&node);
  ChildLanes in[3][parts], out[3][parts];
  for (int axis = 0; axis < 3; ++axis) {
    const ChildLanes scale(frame.scale[axis]), first(frame.first[axis]), last(frame.last[axis]);
    ChildLanes near[parts], far[parts];
    load_bytes(bytes + bvh_ray.enter[axis], near);
    load_bytes(bytes + bvh_ray.leave[axis], far);
    for (int k = 0; k < parts; ++k) {
      in[axis][k] = near[k] * scale + first;
      out[axis][k] = far[k] * scale + last;
    }
  }
  Keys keys;
  for (int k = 0; k < parts; ++k) {
    const ChildLanes enter = larger(larger(in[0][k], in[1][k]), larger(in[2][k], ChildLanes(bvh_ray.begin)));
    const ChildLanes leave = lesser(lesser(out[0][k], out[1][k]), lesser(out[2][k], ChildLanes(limit)));
    keys.set(k, enter, (enter <= leave).bits & (Keys::places(k) < static_cast<std::int32_t>(node.count)));
  }
  return keys;
}

/// Prefetches a child that may be needed soon.
template <class T>
[[gnu::always_inline]] inline void fetch(const TreeNode<T>* nodes, const PackedLeaf* leaves, const TreeNode<T>& node,
                                         std::uint32_t place) {
  const auto inner = reinterpret_cast<std::uintptr_t>(nodes) + sizeof node * (node.first_child + place);
  const auto leaf = reinterpret_cast<std::uintptr_t>(leaves) + sizeof *leaves * (node.first_leaf + place - node.inner);
  // Unpredictable which of the two it is: no branch.
  const std::uintptr_t if_inner = -static_cast<std::uintptr_t>(place < node.inner);
  const auto* child = reinterpret_cast<const char*>(leaf ^ ((inner ^ leaf) & if_inner));
  __builtin_prefetch(child);
  __builtin_prefetch(child + 64);
}

/// A bit for each triangle of a leaf that the ray may cross.
template <class T>
[[gnu::always_inline]] inline std::uint32_t left(const BvhRay<T>& bvh_ray, const TreeNode<T>& node,
                                                 const PackedLeaf& leaf) {
  float part[3], base[3];
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t axis = bvh_ray.axis[i];
    part[i] = static_cast<float>(node.step[axis] * bvh_ray.part_scale);
    base[i] = static_cast<float>((node.origin[axis] - bvh_ray.sheared_origin[i]) * bvh_ray.scale);
  }
  const Quad along_x(part[0]), along_y(part[1]), x_along_z(-(bvh_ray.shear_x * part[2])),
      y_along_z(-(bvh_ray.shear_y * part[2])), base_x(base[0] - bvh_ray.shear_x * base[2]),
      base_y(base[1] - bvh_ray.shear_y * base[2]);
  Quad x[3], y[3], size(0.0f);
  for (int k = 0; k < 3; ++k) {
    const Quad z = load_words(leaf.at[bvh_ray.axis[2]][k]);
    x[k] = load_words(leaf.at[bvh_ray.axis[0]][k]) * along_x + z * x_along_z + base_x;
    y[k] = load_words(leaf.at[bvh_ray.axis[1]][k]) * along_y + z * y_along_z + base_y;
    size = larger(size, larger(abs(x[k]), abs(y[k])));
  }
  const auto side = [&](int p, int q) __attribute__((always_inline)) { return x[q] * y[p] - y[q] * x[p]; };
  const Quad u = side(1, 2), v = side(2, 0), w = side(0, 1);
  // With coordinates off by e and of size s, a difference of two products is off by 4 e s + 2 e e, and by its own
  // roundings, 2 epsilon s s <= e s since e is more than 4 epsilon s; where they underflow, by less than the least
  // normal number.
  const Quad e(bvh_ray.off + static_cast<float>(PackedLeaf::off) * (part[0] + part[1] + part[2]));
  const Quad off = Quad(8.0f) * e * (size + e) + Quad(least_float);
  const Quad lowest = lesser(u, lesser(v, w)), highest = larger(u, larger(v, w));
  return bits_of(!((lowest < -off) & (highest > off)));
}

}  // namespace graze::GRAZE_ISA::tree
