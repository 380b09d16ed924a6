#include "broad/pair_order.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "broad/boxes.hpp"
#include "broad/radix_sort.hpp"

namespace graze {

namespace {

/// The number of pairs that a bucket is to have; pairs are dealt by their smaller place. Sorting so many stays in the
/// second cache. More buckets than the most would outgrow the caches' own tables.
constexpr std::size_t pairs_per_bucket = 32768;
constexpr int most_bucket_bits = 11;
/// The most pairs of one place that are sorted by insertion.
constexpr std::uint32_t few = 24;
/// The share of places, one in so many, from which on marking places and looking through all of them is faster than
/// comparing.
constexpr std::size_t sparse = 256;

/// Sorts pairs that are nearly in order.
void insertion_sort(IdPair* pairs, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    const IdPair p = pairs[i];
    if (order_key(pairs[i - 1]) <= order_key(p)) continue;
    std::size_t k = i;
    do {
      pairs[k] = pairs[k - 1];
      --k;
    } while (k > 0 && order_key(pairs[k - 1]) > order_key(p));
    pairs[k] = p;
  }
}

}  // namespace

std::size_t PairOrder::memory() const {
  return scratch_.capacity() * sizeof(IdPair) + begins_.capacity() * sizeof(std::size_t) +
         counts_.capacity() * sizeof(std::uint32_t) + is_there_.capacity() * sizeof(std::uint64_t);
}

void PairOrder::sort(std::span<const std::uint32_t> first, std::span<const std::uint32_t> second, std::size_t boxes,
                     IdPair* to) {
  const std::size_t count = first.size();
  const std::uint32_t *const f = first.data(), *const s = second.data();
  const auto found = [=](std::size_t i) { return ordered(f[i], s[i]); };
  const int bits = bits_below(boxes);
  const int bucket_bits = std::min({bits_below(count / pairs_per_bucket + 1), most_bucket_bits, bits});
  const int shift = bits - bucket_bits;
  if (bucket_bits == 0) {
    sort_bucket(found, count, 0, static_cast<std::uint32_t>(boxes), to, boxes);
    return;
  }
  if (scratch_.size() < count) scratch_.resize(count + count / 8);
  const std::size_t buckets = std::size_t{1} << bucket_bits;
  begins_.assign(buckets + 1, 0);
  std::size_t* const begins = begins_.data();
  IdPair* const dealt = scratch_.data();
  for (std::size_t i = 0; i < count; ++i) ++begins[(std::min(f[i], s[i]) >> shift) + 1];
  for (std::size_t b = 0; b < buckets; ++b) begins[b + 1] += begins[b];
  for (std::size_t i = 0; i < count; ++i) {
    const IdPair p = found(i);
    dealt[begins[p.a >> shift]++] = p;
  }
  // `begins[b]` is now where bucket b ends.
  std::size_t begin = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    const std::size_t end = begins[b];
    if (end > begin)
      sort_bucket([=](std::size_t i) { return dealt[begin + i]; }, end - begin, static_cast<std::uint32_t>(b << shift),
                  std::uint32_t{1} << shift, to + begin, boxes);
    begin = end;
  }
}

/// Sorts a bucket by counting, then the few pairs of each place by insertion: one pass over all of them, nearly in
/// order.
template <class Source>
void PairOrder::sort_bucket(const Source& source, std::size_t count, std::uint32_t lowest, std::uint32_t places,
                            IdPair* to, std::size_t boxes) {
  counts_.assign(places, 0);
  std::uint32_t* const counts = counts_.data();
  for (std::size_t i = 0; i < count; ++i) ++counts[source(i).a - lowest];
  std::uint32_t sum = 0, greatest_count = 0;
  for (std::uint32_t a = 0; a < places; ++a) {
    greatest_count = std::max(greatest_count, counts[a]);
    sum += std::exchange(counts[a], sum);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const IdPair p = source(i);
    to[counts[p.a - lowest]++] = p;
  }
  if (greatest_count > few) {
    std::uint32_t begin = 0;
    for (std::uint32_t a = 0; a < places; ++a) {
      if (counts[a] - begin > few) sort_many(to + begin, counts[a] - begin, boxes);
      begin = counts[a];
    }
  }
  insertion_sort(to, count);
}

/// Sorts the many pairs of one place.
void PairOrder::sort_many(IdPair* pairs, std::size_t count, std::size_t boxes) {
  if (count < boxes / sparse) {
    std::sort(pairs, pairs + count, [](const IdPair& p, const IdPair& q) { return p.b < q.b; });
    return;
  }
  is_there_.resize((boxes + 63) / 64);
  for (std::size_t i = 0; i < count; ++i) is_there_[pairs[i].b / 64] |= std::uint64_t{1} << (pairs[i].b % 64);
  for (std::size_t w = pairs[0].a / 64; w < is_there_.size(); ++w)
    for (std::uint64_t word = std::exchange(is_there_[w], 0); word != 0; word &= word - 1)
      (pairs++)->b = static_cast<std::uint32_t>(w * 64) + static_cast<std::uint32_t>(std::countr_zero(word));
}

}  // namespace graze
