#include "broad/wide_boxes.hpp"

#include <algorithm>
#include <numeric>

namespace graze {

namespace {

/// From one overlapping pair in so many on, all pairs are compared: a comparison takes a hundredth of what it takes to
/// find a pair and to sort it, and the guess may be off by some.
constexpr std::size_t pairs_per_hit = 32;
/// So many pairs are looked at for that.
constexpr std::size_t samples = 1024;
/// More boxes than that leave the caches, and would be fetched anew for each of the wide ones.
constexpr std::size_t most_boxes = 400000;

}  // namespace

template <class T>
bool WideBoxes<T>::worthwhile(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> some) {
  if (boxes.size() > most_boxes) return false;
  // Steps of the golden ratio (Knuth 1998, "The Art of Computer Programming", volume 3, section 6.4): evenly spread, and
  // in step with no pattern that the boxes may follow.
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
  const std::size_t n = boxes.size();
  if (places_.size() < n) {
    places_.resize(n);
    std::iota(places_.begin(), places_.end(), 0u);
  }
  all_.fill(boxes, {places_.data(), n});
  wide_.fill(boxes, wide);
  if (second_.size() < n + row_padding) first_.resize(n + row_padding), second_.resize(n + row_padding);
  const Rows<T> all = all_.rows(), them = wide_.rows();
  const auto test = GRAZE_KERNEL(level, test_all<T>);

  out.resize(out.capacity());
  std::size_t written = 0, other = 0, next = 0;
  for (std::uint32_t a = 0; a < n; ++a) {
    // No more pairs than boxes, for which there is room.
    PairSink sink{first_.data(), second_.data(), 0, second_.size() + row_padding, nullptr, nullptr};
    const SweptOver<T> box{
        {all.lower_x[a], all.upper_x[a], all.lower_y[a], all.upper_y[a], all.lower_z[a], all.upper_z[a]},
        a,
        0,
        0,
        0,
        0};
    if (next < wide.size() && wide[next] == a) {
      test(all, a + 1, n, box, sink);
      ++next;
    } else {
      test(them, next, wide.size(), box, sink);
    }
    std::size_t end = other;
    while (end < others.size() && others[end].a == a) ++end;
    const std::size_t total = sink.count + (end - other);
    if (written + total > out.size()) out.resize(std::max(written + total, out.size() * 2));
    IdPair* const to = out.data() + written;
    for (std::size_t i = 0; i < sink.count; ++i) to[i] = {a, second_[i]};
    // Both are sorted: from behind, the others take their places and those after them move on.
    for (std::size_t left = sink.count, at = total; end > other;) {
      if (left > 0 && to[left - 1].b > others[end - 1].b)
        to[--at] = to[--left];
      else
        to[--at] = others[--end];
    }
    other += total - sink.count;
    written += total;
  }
  out.resize(written);
}

template <class T>
std::size_t WideBoxes<T>::Columns::memory() const {
  return bounds[0].capacity() * 6 * sizeof(T) + place.capacity() * sizeof(std::uint32_t);
}

template <class T>
std::size_t WideBoxes<T>::memory() const {
  return all_.memory() + wide_.memory() +
         (places_.capacity() + first_.capacity() + second_.capacity()) * sizeof(std::uint32_t);
}

template class WideBoxes<float>;
template class WideBoxes<double>;

}  // namespace graze
