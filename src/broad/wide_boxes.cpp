#include "broad/wide_boxes.hpp"

#include <algorithm>
#include <numeric>

#include "broad/found_pairs.hpp"

namespace graze {

namespace {

/// The share of overlapping pairs, one in so many, from which on all pairs are compared: a comparison takes a hundredth
/// of what it takes to find a pair and to sort it, and the guess may be off by some.
constexpr std::size_t pairs_per_hit = 32;
/// The number of pairs that are compared for the guess.
constexpr std::size_t samples = 1024;
/// The number of boxes above which they leave the caches, and would be fetched anew for each of the wide ones.
constexpr std::size_t most_boxes = 400000;

/// Sets the rank of each place to the number of those at `wide` that are less.
void count_below(std::span<const std::uint32_t> wide, std::size_t places, std::vector<std::uint32_t>& ranks) {
  if (ranks.size() < places) ranks.resize(places);
  std::uint32_t rank = 0;
  for (std::uint32_t i = 0; i < places; ++i) {
    ranks[i] = rank;
    rank += rank < wide.size() && wide[rank] == i ? 1 : 0;
  }
}

}  // namespace

template <class T>
bool WideBoxes<T>::worthwhile(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> some) {
  if (boxes.size() > most_boxes) return false;
  // Pairs are picked by steps of the golden ratio (Knuth 1998, "The Art of Computer Programming", volume 3, section
  // 6.4): evenly spread, and in step with no pattern that the boxes may follow.
  std::size_t hits = 0;
  std::uint32_t at = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    at += 0x9e3779b9u;
    const Aabb<T>& one = boxes[some[i % some.size()]];
    const Aabb<T>& other = boxes[static_cast<std::size_t>((std::uint64_t{at} * boxes.size()) >> 32)];
    hits += overlap(one, other) ? 1 : 0;
  }
  return hits * pairs_per_hit >= samples;
}

template <class T>
void WideBoxes<T>::Columns::fill(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places) {
  const std::size_t n = places.size();
  for (auto& column : bounds)
    if (column.size() < n + row_padding) column.resize(n + row_padding);
  place.resize(std::max(place.size(), n + row_padding));
  for (std::size_t i = 0; i < n; ++i) {
    const Aabb<T>& b = boxes[places[i]];
    bounds[0][i] = b.lower.x, bounds[1][i] = b.upper.x;
    bounds[2][i] = b.lower.y, bounds[3][i] = b.upper.y;
    bounds[4][i] = b.lower.z, bounds[5][i] = b.upper.z;
    place[i] = places[i];
  }
}

template <class T>
Rows<T> WideBoxes<T>::Columns::rows() const {
  return {bounds[0].data(),
          bounds[1].data(),
          bounds[2].data(),
          bounds[3].data(),
          bounds[4].data(),
          bounds[5].data(),
          nullptr,
          nullptr,
          place.data(),
          nullptr,
          0,
          0};
}

template <class T>
void WideBoxes<T>::merge(Isa level, std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> wide,
                         std::span<const IdPair> others, std::vector<IdPair>& out) {
  const auto n = static_cast<std::uint32_t>(boxes.size()), wide_count = static_cast<std::uint32_t>(wide.size());
  if (places_.size() < n) {
    places_.resize(n);
    std::iota(places_.begin(), places_.end(), 0u);
  }
  all_.fill(boxes, {places_.data(), n});
  wide_.fill(boxes, wide);
  count_below(wide, n, ranks_);
  const Rows<T> all = all_.rows(), them = wide_.rows();
  const auto test = GRAZE_KERNEL(level, test_all<T>);

  std::size_t written = 0, other = 0;
  for (std::uint32_t a = 0; a < n; ++a) {
    const std::uint32_t rank = ranks_[a];
    const bool is_wide = rank < wide_count && wide[rank] == a;
    const std::uint32_t from = is_wide ? a + 1 : rank, end = is_wide ? n : wide_count;
    const std::size_t first_other = other;
    while (other < others.size() && others[other].a == a) ++other;
    const std::size_t most = written + (end - from) + (other - first_other) + row_padding;
    if (most > out.size()) out.resize(std::max(most, out.size() + out.size() / 4));
    const SweptOver<T> box{
        {all.lower_x[a], all.upper_x[a], all.lower_y[a], all.upper_y[a], all.lower_z[a], all.upper_z[a]},
        a,
        0,
        0,
        0,
        0};
    const KnownPairs known{numbers(others) + 2 * first_other, other - first_other, ranks_.data()};
    std::uint32_t* const to = numbers(std::span(out)) + 2 * written;
    written += static_cast<std::size_t>(test(is_wide ? all : them, from, end, box, known, to) - to) / 2;
  }
  out.resize(written);
}

template <class T>
std::size_t WideBoxes<T>::Columns::memory() const {
  return bounds[0].capacity() * 6 * sizeof(T) + place.capacity() * sizeof(std::uint32_t);
}

template <class T>
std::size_t WideBoxes<T>::memory() const {
  return all_.memory() + wide_.memory() + (places_.capacity() + ranks_.capacity()) * sizeof(std::uint32_t);
}

template class WideBoxes<float>;
template class WideBoxes<double>;

}  // namespace graze
