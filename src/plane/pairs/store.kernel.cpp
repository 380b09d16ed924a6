#include <cstddef>

#include "plane/pairs/pair_answers.hpp"
#include "plane/pairs/store_kernels.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

using Floats = Lanes<float>;
constexpr std::size_t half_lanes = lanes_of<double>;
static_assert(lanes_of<float> == 2 * half_lanes && block_pairs % lanes_of<float> == 0);

template <class V, std::size_t... I>
[[gnu::always_inline]] inline Floats joined(const V& low, const V& high, std::index_sequence<I...>) {
  return Floats::of(__builtin_shufflevector(low, high, I...));
}
/// Numbers of a column rounded to floats, as many as a register of floats holds.
[[gnu::always_inline]] inline Floats rounded(const double* column) {
  typedef float Half __attribute__((vector_size(half_lanes * sizeof(float))));
  const Half low = __builtin_convertvector(Lanes<double>::load(column).v, Half),
             high = __builtin_convertvector(Lanes<double>::load(column + half_lanes).v, Half);
  return joined(low, high, std::make_index_sequence<lanes_of<float>>());
}

template <class V, std::size_t... I>
[[gnu::always_inline]] inline Floats low_words(const V& first, const V& second, std::index_sequence<I...>) {
  typedef std::int32_t Words __attribute__((vector_size(register_bytes)));
  return Floats::of(reinterpret_cast<Floats::Vector>(
      __builtin_shufflevector(reinterpret_cast<Words>(first), reinterpret_cast<Words>(second), (2 * I)...)));
}
/// Whole numbers below 2^32 as integers, in the place of floats; their halves exchanged where that is wanted. The last
/// bits of the sum of 2^52 and a whole number are that number.
[[gnu::always_inline]] inline Floats whole(const double* column, bool turned) {
  const auto bits = [&](const double* from) __attribute__((always_inline)) {
    const Lanes<double> sum = Lanes<double>::load(from) + Lanes<double>(0x1p52);
    const auto number = reinterpret_cast<Lanes<double>::BitVector>(sum.v);
    return turned ? ((number >> 16) & 0xffff) | (number << 16) : number;
  };
  return low_words(bits(column), bits(column + half_lanes), std::make_index_sequence<lanes_of<float>>());
}

[[gnu::flatten]] void store_distances(const DistanceColumns<block_pairs>& found, std::size_t count, bool turned,
                                      plane::Distance<float>* rows) {
  using Row = plane::Distance<float>;
  static_assert(sizeof(Row) == 36 && offsetof(Row, normal) == 4 && offsetof(Row, a) == 12 && offsetof(Row, b) == 20 &&
                offsetof(Row, status) == 28 && static_cast<int>(Status::converged) == 0);
  const auto &a = turned ? found.b : found.a, &b = turned ? found.a : found.b;
  for (std::size_t first = 0; first < count; first += lanes_of<float>) {
    const Floats x = rounded(found.normal[0] + first), y = rounded(found.normal[1] + first), zero(0.0f);
    void* const to = rows + first;
    scatter(rounded(found.distance + first), turned ? -x : x, turned ? -y : y, rounded(a[0] + first), to, sizeof(Row));
    scatter(rounded(a[1] + first), rounded(b[0] + first), rounded(b[1] + first), zero, static_cast<char*>(to) + 16,
            sizeof(Row));
    for (std::size_t k = 0; k < lanes_of<float>; ++k) rows[first + k].error = 0;
  }
}

[[gnu::flatten]] void store_contacts(const ContactColumns<block_pairs>& found, std::size_t count, bool turned,
                                     ContactRow<float>* rows) {
  using Row = ContactRow<float>;
  using Point = plane::ContactPoint<float>;
  static_assert(sizeof(Row) == 64 && sizeof(Point) == 28 && offsetof(Point, b) == 8 &&
                offsetof(Point, distance) == 16 && offsetof(Point, feature) == 20 && offsetof(Point, weight) == 24);
  const std::size_t ax = turned ? 2 : 0, bx = turned ? 0 : 2;
  for (std::size_t first = 0; first < count; first += lanes_of<float>) {
    const auto number = [&](std::size_t point, std::size_t column) __attribute__((always_inline)) {
      return rounded(found.points[point][column] + first);
    };
    const auto weight = [&](std::size_t point) __attribute__((always_inline)) {
      const Floats w = number(point, 6);
      return turned ? Floats(1.0f) - w : w;
    };
    const Floats x = rounded(found.normal[0] + first), y = rounded(found.normal[1] + first);
    char* const to = static_cast<char*>(static_cast<void*>(rows + first));
    scatter(turned ? -x : x, turned ? -y : y, number(0, ax), number(0, ax + 1), to, sizeof(Row));
    scatter(number(0, bx), number(0, bx + 1), number(0, 4), whole(found.points[0][5] + first, turned), to + 16,
            sizeof(Row));
    scatter(weight(0), number(1, ax), number(1, ax + 1), number(1, bx), to + 32, sizeof(Row));
    scatter(number(1, bx + 1), number(1, 4), whole(found.points[1][5] + first, turned), weight(1), to + 48,
            sizeof(Row));
  }
}

[[gnu::flatten]] void store_wide_distances(const DistanceColumns<block_pairs>& found, std::size_t count, bool turned,
                                           plane::Distance<double>* rows) {
  for (std::size_t k = 0; k < count; ++k) rows[k] = distance_at<double>(found, k, turned);
}
[[gnu::flatten]] void store_wide_contacts(const ContactColumns<block_pairs>& found, std::size_t count, bool turned,
                                          ContactRow<double>* rows) {
  for (std::size_t k = 0; k < count; ++k) {
    rows[k].normal = normal_at<double>(found, k, turned);
    for (std::size_t i = 0; i < 2; ++i) rows[k].points[i] = point_at<double>(found, k, i, turned);
  }
}

constexpr AllStoreKernels store_kernels{{store_distances, store_contacts}, {store_wide_distances, store_wide_contacts}};

}  // namespace

const AllStoreKernels& plane_store_kernels() { return store_kernels; }

}  // namespace graze::GRAZE_ISA
