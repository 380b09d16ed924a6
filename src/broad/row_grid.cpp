#include "broad/row_grid.hpp"

#include <algorithm>
#include <limits>

#include "broad/radix_sort.hpp"

namespace graze {

namespace {

/// Keys are sorted by this many bits at the most: three digits. Rows take up to 24 of them, X what is left.
constexpr int key_bits = 32;
/// X is cut finer than there are boxes in a row by this many bits, so that few share a place and need another look.
constexpr int spare_bits = 3;
/// Boxes are fetched from the caller's array this far ahead.
constexpr std::size_t ahead = 16;
/// A strip is so many times as wide as the longest box: wider ones hold fewer boxes twice, narrower ones compare fewer.
constexpr int strip_per_longest = 2;

/// Vectors only grow: what is past the end of one frame is there for the next.
template <class V>
void make_room(V& vector, std::size_t size) {
  if (vector.size() < size) vector.resize(size + size / 8);
}

}  // namespace

template <class T>
void RowGrid<T>::cut(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, const Spans<T>& spans) {
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
    Strips<T>& strips = axis == 1 ? y_ : z_;
    const T width = spans.longest[axis] * T(strip_per_longest);
    if (strips.set(spans.lowest[axis], spans.highest[axis], width)) continue;
    begins_.clear();
    for (const std::uint32_t p : places) begins_.push_back(boxes[p].lower[axis]);
    strips.adapt(begins_, width);
  }
}

template <class T>
void RowGrid<T>::build(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, const Spans<T>& spans) {
  cut(boxes, places, spans);
  const std::size_t n = places.size();
  const std::uint64_t grid = std::uint64_t{y_.count()} * z_.count();
  const int bits_row = bits_below(grid);
  // As many for X as the digits that are looked at anyway have room for.
  const int wanted =
      std::clamp(bits_row + bits_below(2 * n / std::min<std::uint64_t>(grid, n) + 1) + spare_bits, 1, key_bits);
  const int bits_x =
      std::min(key_bits, (wanted + Digits::most_bits - 1) / Digits::most_bits * Digits::most_bits) - bits_row;

  // Rounding keeps the order of what it rounds, so the places along X never descend either; the clamp is for the last.
  const T range = spans.highest.x - spans.lowest.x;
  const T most = static_cast<T>((std::uint32_t{1} << std::min(bits_x, 20)) - 1);
  T scale = range > T(0) ? most / range : T(0);
  if (!(scale <= std::numeric_limits<T>::max())) scale = T(0);
  make_room(keys_, 4 * n + 1);
  std::size_t count = 0;
  std::uint64_t* const keys = keys_.data();
  const std::uint32_t along_z = z_.count();
  for (std::size_t i = 0; i < n; ++i) {
    const Aabb<T>& b = boxes[places[i]];
    const std::uint32_t y = y_.strip(b.lower.y), last_y = y_.nearest(b.upper.y);
    const std::uint32_t z = z_.strip(b.lower.z), last_z = z_.nearest(b.upper.z);
    const T at = std::min((b.lower.x - spans.lowest.x) * scale, most);
    const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(at));
    const auto key = [&](std::uint32_t row_y, std::uint32_t row_z) {
      return std::uint64_t{(row_y * along_z + row_z) << bits_x | x} << 32 | places[i];
    };
    // Each of the four is written, and the next one over it where the box does not reach that row.
    const std::size_t more_y = last_y > y ? 1 : 0, more_z = last_z > z ? 1 : 0;
    keys[count++] = key(y, z);
    keys[count] = key(y, last_z);
    count += more_z;
    keys[count] = key(last_y, z);
    count += more_y;
    keys[count] = key(last_y, last_z);
    count += more_y & more_z;
  }
  make_room(items_, count);
  make_room(scratch_, count);
  Digits digits;
  digits.add(32, bits_row + bits_x);
  std::uint64_t* sorted = radix_sort(
      count, [keys](std::size_t i) { return keys[i]; }, digits, [](std::uint64_t item) { return item; }, items_.data(),
      scratch_.data());
  sort_ties(boxes, sorted, count);
  fill(boxes, sorted, count, bits_x);
}

/// Boxes that share a place along X, by X itself.
template <class T>
void RowGrid<T>::sort_ties(std::span<const Aabb<T>> boxes, std::uint64_t* items, std::size_t count) {
  const auto x = [&](std::uint64_t item) { return boxes[static_cast<std::uint32_t>(item)].lower.x; };
  for (std::size_t i = 1; i < count; ++i) {
    if (items[i] >> 32 != items[i - 1] >> 32) continue;
    const std::size_t begin = i - 1;
    while (i < count && items[i] >> 32 == items[begin] >> 32) ++i;
    std::sort(items + begin, items + i, [&](std::uint64_t p, std::uint64_t q) { return x(p) < x(q); });
  }
}

template <class T>
void RowGrid<T>::fill(std::span<const Aabb<T>> boxes, const std::uint64_t* items, std::size_t n, int bits_x) {
  for (auto* column : {&lower_x_, &upper_x_, &lower_y_, &upper_y_, &lower_z_, &upper_z_, &reach_x_})
    make_room(*column, n + row_padding);
  make_room(place_, n + row_padding);
  make_room(began_, n + row_padding);
  rows_.clear();
  T reach{};
  std::uint32_t y = 0, z = 0;
  for (std::size_t i = 0; i < n; ++i) {
    __builtin_prefetch(&boxes[static_cast<std::uint32_t>(items[std::min(i + ahead, n - 1)])]);
    const auto place = static_cast<std::uint32_t>(items[i]);
    const auto row = static_cast<std::uint32_t>(items[i] >> 32 >> bits_x);
    const Aabb<T>& b = boxes[place];
    if (rows_.empty() || rows_.back().index != row) {
      const auto at = static_cast<std::uint32_t>(i);
      if (!rows_.empty()) rows_.back().end = at;
      rows_.push_back({row, at, at});
      reach = b.upper.x;
      y = row / z_.count(), z = row % z_.count();
    }
    reach = std::max(reach, b.upper.x);
    lower_x_[i] = b.lower.x, upper_x_[i] = b.upper.x;
    lower_y_[i] = b.lower.y, upper_y_[i] = b.upper.y;
    lower_z_[i] = b.lower.z, upper_z_[i] = b.upper.z;
    reach_x_[i] = reach;
    place_[i] = place;
    began_[i] = (y_.strip(b.lower.y) < y ? began_before_y : 0) | (z_.strip(b.lower.z) < z ? began_before_z : 0);
  }
  rows_.back().end = static_cast<std::uint32_t>(n);
}

template <class T>
Rows<T> RowGrid<T>::rows() const {
  return {lower_x_.data(), upper_x_.data(), lower_y_.data(), upper_y_.data(), lower_z_.data(), upper_z_.data(),
          reach_x_.data(), began_.data(),   place_.data(),   rows_.data(),    rows_.size(),    z_.count()};
}

template <class T>
void RowGrid<T>::index_strips() {
  first_row_.assign(y_.count() + 1, 0);
  std::uint32_t y = 0;
  for (std::uint32_t i = 0; i < rows_.size(); ++i)
    for (; y <= rows_[i].index / z_.count(); ++y) first_row_[y] = i;
  for (; y <= y_.count(); ++y) first_row_[y] = static_cast<std::uint32_t>(rows_.size());
}

template <class T>
SweptOver<T> RowGrid<T>::reach_of(const Aabb<T>& b, std::uint32_t place) const {
  return {{b.lower.x, b.upper.x, b.lower.y, b.upper.y, b.lower.z, b.upper.z},
          place,
          y_.nearest(b.lower.y),
          y_.nearest(b.upper.y),
          z_.nearest(b.lower.z),
          z_.nearest(b.upper.z)};
}

template <class T>
std::size_t RowGrid<T>::memory() const {
  return (lower_x_.capacity() * 8 + begins_.capacity()) * sizeof(T) + y_.memory() + z_.memory() +
         (place_.capacity() + first_row_.capacity()) * sizeof(std::uint32_t) + rows_.capacity() * sizeof(Row) +
         (items_.capacity() + scratch_.capacity() + keys_.capacity()) * sizeof(std::uint64_t);
}

template class RowGrid<float>;
template class RowGrid<double>;

}  // namespace graze
