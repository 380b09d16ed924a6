#include "broad/kept_kernels.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// The number of pairs by which boxes are fetched ahead: places that are close in space may be anywhere in memory.
constexpr std::size_t ahead = 32;

/// Six numbers a box fill three registers in turn with those of `lanes / 2` boxes.
template <class T>
struct Group {
  static constexpr int registers = 3;
  static constexpr std::uint32_t boxes = lanes_of<T> / 2;
  static constexpr std::uint64_t all = (std::uint64_t{1} << (6 * boxes)) - 1;

  /// The bits of lower corners.
  static constexpr std::uint64_t lowers() {
    std::uint64_t bits = 0;
    for (std::uint32_t box = 0; box < boxes; ++box) bits |= std::uint64_t{7} << (6 * box);
    return bits;
  }
};

template <class T>
[[gnu::always_inline]] inline bool is_inside(const T* box, const T* room) {
  return static_cast<int>(room[0] <= box[0]) & static_cast<int>(room[1] <= box[1]) &
         static_cast<int>(room[2] <= box[2]) & static_cast<int>(box[3] <= room[3]) &
         static_cast<int>(box[4] <= room[4]) & static_cast<int>(box[5] <= room[5]);
}

/// Whether two boxes overlap. Four numbers from the first on are the lower corner and one more, four from the third on
/// one more and the upper corner: one comparison covers each corner, and its surplus number is left out.
template <class T>
[[gnu::always_inline]] inline std::uint32_t do_overlap(const T* a, const T* b) {
#if defined(__x86_64__)
  if constexpr (sizeof(T) == 4) {
    const __m128 low_a = _mm_loadu_ps(a), low_b = _mm_loadu_ps(b), high_a = _mm_loadu_ps(a + 2),
                 high_b = _mm_loadu_ps(b + 2);
    const __m128 up_a = _mm_shuffle_ps(high_a, high_a, _MM_SHUFFLE(0, 3, 2, 1)),
                 up_b = _mm_shuffle_ps(high_b, high_b, _MM_SHUFFLE(0, 3, 2, 1));
    const __m128 both = _mm_and_ps(_mm_cmple_ps(low_a, up_b), _mm_cmple_ps(low_b, up_a));
    return (_mm_movemask_ps(both) & 7) == 7 ? 1 : 0;
  }
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 8) {
    const __m256d low_a = _mm256_loadu_pd(a), low_b = _mm256_loadu_pd(b), high_a = _mm256_loadu_pd(a + 2),
                  high_b = _mm256_loadu_pd(b + 2);
    const __m256d up_a = _mm256_permute4x64_pd(high_a, _MM_SHUFFLE(0, 3, 2, 1)),
                  up_b = _mm256_permute4x64_pd(high_b, _MM_SHUFFLE(0, 3, 2, 1));
    const __m256d both = _mm256_and_pd(_mm256_cmp_pd(low_a, up_b, _CMP_LE_OQ), _mm256_cmp_pd(low_b, up_a, _CMP_LE_OQ));
    return (_mm256_movemask_pd(both) & 7) == 7 ? 1 : 0;
  }
#endif
  return static_cast<std::uint32_t>(a[0] <= b[3]) & static_cast<std::uint32_t>(b[0] <= a[3]) &
         static_cast<std::uint32_t>(a[1] <= b[4]) & static_cast<std::uint32_t>(b[1] <= a[4]) &
         static_cast<std::uint32_t>(a[2] <= b[5]) & static_cast<std::uint32_t>(b[2] <= a[5]);
}

[[gnu::always_inline]] inline std::uint32_t bit(const std::uint64_t* bits, std::uint32_t place) {
  return static_cast<std::uint32_t>(bits[place / 64] >> (place % 64)) & 1;
}

template <bool drops, class T>
[[gnu::always_inline]] inline std::size_t keep(const T* boxes, const std::uint32_t* pairs, std::size_t count,
                                               const std::uint64_t* dropped, std::uint32_t* out) {
  std::uint32_t* to = out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t a = pairs[2 * i], b = pairs[2 * i + 1];
    const std::size_t next = i + ahead < count ? i + ahead : count - 1;
    const T* const later = boxes + std::size_t{6} * pairs[2 * next + 1];
    __builtin_prefetch(later), __builtin_prefetch(later + 5);  // a box may lie across two lines of the cache
    std::uint32_t hit = do_overlap(boxes + std::size_t{6} * a, boxes + std::size_t{6} * b);
    if (drops) hit &= ~(bit(dropped, a) | bit(dropped, b));
    to[0] = a, to[1] = b;
    to += 2 * hit;
  }
  return static_cast<std::size_t>(to - out) / 2;
}

}  // namespace

template <class T>
std::uint32_t find_left(const T* boxes, const T* rooms, std::uint32_t count, std::uint32_t* left, std::uint32_t most) {
  using G = Group<T>;
  constexpr std::uint64_t lowers = G::lowers();
  std::uint32_t found = 0, i = 0;
  for (; i + G::boxes <= count; i += G::boxes) {
    const T *const box = boxes + std::size_t{6} * i, *const room = rooms + std::size_t{6} * i;
    std::uint64_t inside = 0;
    for (int r = 0; r < G::registers; ++r) {
      const Lanes<T> b = Lanes<T>::load(box + r * lanes_of<T>), m = Lanes<T>::load(room + r * lanes_of<T>);
      const std::uint64_t low = Chosen<T>::at_most(m, b).bits(), high = Chosen<T>::at_most(b, m).bits();
      const std::uint64_t is_lower = lowers >> (r * lanes_of<T>);
      inside |= ((low & is_lower) | (high & ~is_lower)) << (r * lanes_of<T>);
    }
    if (inside == G::all) continue;
    for (std::uint32_t k = 0; k < G::boxes; ++k) {
      if ((inside >> (6 * k) & 63) == 63) continue;
      if (found == most) return found;
      left[found++] = i + k;
    }
  }
  for (; i < count && found < most; ++i)
    if (!is_inside(boxes + std::size_t{6} * i, rooms + std::size_t{6} * i)) left[found++] = i;
  return found;
}

template <class T>
std::size_t keep_overlapping(const T* boxes, const std::uint32_t* pairs, std::size_t count,
                             const std::uint64_t* dropped, std::uint32_t* out) {
  return dropped == nullptr ? keep<false>(boxes, pairs, count, dropped, out)
                            : keep<true>(boxes, pairs, count, dropped, out);
}

template std::uint32_t find_left(const float*, const float*, std::uint32_t, std::uint32_t*, std::uint32_t);
template std::uint32_t find_left(const double*, const double*, std::uint32_t, std::uint32_t*, std::uint32_t);
template std::size_t keep_overlapping(const float*, const std::uint32_t*, std::size_t, const std::uint64_t*,
                                      std::uint32_t*);
template std::size_t keep_overlapping(const double*, const std::uint32_t*, std::size_t, const std::uint64_t*,
                                      std::uint32_t*);

}  // namespace graze::GRAZE_ISA
