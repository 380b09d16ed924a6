#include "broad/row_grid.hpp"

#include <algorithm>
#include <limits>

#include "broad/radix_sort.hpp"

namespace graze {

namespace {

/// The most bits by which items are sorted, three digits: rows take up to 24 of them, X the rest.
constexpr int most_key_bits = 3 * Digits::most_bits;
/// The bits of `began`.
constexpr int began_bits = 2;
/// The bits by which X is cut finer than boxes in a row are many, so that few share a place and need another look.
constexpr int spare_bits = 3;
/// The least number of places along X in the length of a box: in heaps far apart the boxes of a row share few of them.
constexpr int places_per_longest = 16;
/// The most boxes with the same place along X that are put in order one by one as they are filled in.
constexpr std::size_t few_ties = 12;
/// The number of boxes by which those of the caller's array are fetched ahead.
constexpr std::size_t ahead = 16;
/// The width of a strip in lengths of the longest box: wider ones hold fewer boxes twice, narrower ones compare fewer.
constexpr int strip_per_longest = 2;

/// Makes a vector at least so long. Vectors only grow: memory past the end of one frame is there for the next.
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
  is_prepared_ = false;
  cut(boxes, places, spans);
  const std::size_t n = places.size();
  const std::uint64_t grid = std::uint64_t{y_.count()} * z_.count();
  const int bits_row = bits_below(grid);
  const T range = spans.highest.x - spans.lowest.x;
  layout_.place_bits = bits_below(boxes.size());
  const int key_shift = layout_.place_bits + began_bits, key_bits = std::min(most_key_bits, 63 - key_shift);
  // X gets as many bits as the digits have room for that are looked at anyway.
  const int by_number = bits_below(2 * n / std::min<std::uint64_t>(grid, n) + 1) + spare_bits;
  const T lengths = range / spans.longest.x * T(places_per_longest);  // infinite for points, and not a number for one
  const int by_length = lengths < T(1 << 15) ? bits_below(static_cast<std::uint64_t>(lengths) + 1) : by_number;
  const int wanted = std::clamp(bits_row + std::max(by_number, by_length), 1, key_bits);
  const int bits_x =
      std::min(key_bits, (wanted + Digits::most_bits - 1) / Digits::most_bits * Digits::most_bits) - bits_row;

  // Rounding is monotonic, so that the places along X never descend either; the clamp is for the last.
  const T most = static_cast<T>((std::uint32_t{1} << std::min(bits_x, 20)) - 1);
  T scale = range > T(0) ? most / range : T(0);
  if (!(scale <= std::numeric_limits<T>::max())) scale = T(0);
  layout_.bits_x = bits_x;
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
    const auto item = [&](std::uint32_t row_y, std::uint32_t row_z, int began) {
      return (std::uint64_t{row_y * along_z + row_z} << bits_x | x) << key_shift |
             static_cast<std::uint64_t>(began) << layout_.place_bits | places[i];
    };
    // All four items are written, each over the one before it where the box does not reach that row.
    const std::size_t more_y = last_y > y ? 1 : 0, more_z = last_z > z ? 1 : 0;
    keys[count++] = item(y, z, 0);
    keys[count] = item(y, last_z, began_before_z);
    count += more_z;
    keys[count] = item(last_y, z, began_before_y);
    count += more_y;
    keys[count] = item(last_y, last_z, began_before_y | began_before_z);
    count += more_y & more_z;
  }
  make_room(items_, count);
  make_room(scratch_, count);
  Digits digits;
  digits.add(key_shift, bits_row + bits_x);
  std::uint64_t* sorted = radix_sort(
      count, [keys](std::size_t i) { return keys[i]; }, digits, [](std::uint64_t item) { return item; }, items_.data(),
      scratch_.data());
  sort_ties(boxes, sorted, count);
  fill(boxes, sorted, count);
}

/// Sorts boxes of which many share a place along X, by X itself.
template <class T>
void RowGrid<T>::sort_ties(std::span<const Aabb<T>> boxes, std::uint64_t* items, std::size_t count) {
  const std::uint64_t place = (std::uint64_t{1} << layout_.place_bits) - 1;
  const auto box_of = [&](std::uint64_t item) -> const Aabb<T>& {
    return boxes[static_cast<std::size_t>(item & place)];
  };
  const int key_shift = layout_.place_bits + began_bits;
  for (std::size_t end = few_ties; end < count; ++end) {
    if (items[end] >> key_shift != items[end - few_ties] >> key_shift) continue;
    const std::uint64_t key = items[end] >> key_shift;
    const std::size_t begin = end - few_ties;
    while (end < count && items[end] >> key_shift == key) ++end;
    std::sort(items + begin, items + end,
              [&](std::uint64_t p, std::uint64_t q) { return box_of(p).lower.x < box_of(q).lower.x; });
  }
}

template <class T>
void RowGrid<T>::fill(std::span<const Aabb<T>> boxes, const std::uint64_t* items, std::size_t n) {
  const auto column = [n](auto& vector) {
    make_room(vector, n + row_padding);
    return vector.data();
  };
  T *const lower_x = column(lower_x_), *const upper_x = column(upper_x_), *const lower_y = column(lower_y_),
           *const upper_y = column(upper_y_), *const lower_z = column(lower_z_), *const upper_z = column(upper_z_);
  auto* const began = column(began_);
  std::uint32_t* const places = column(place_);
  rows_.clear();
  const std::uint64_t place_mask = (std::uint64_t{1} << layout_.place_bits) - 1;
  const int began_shift = layout_.place_bits, row_shift = began_shift + began_bits + layout_.bits_x;
  std::uint64_t last_row = ~std::uint64_t{0};
  std::size_t row_begin = 0;
  for (std::size_t i = 0; i < n; ++i) {
    __builtin_prefetch(&boxes[static_cast<std::size_t>(items[std::min(i + ahead, n - 1)] & place_mask)]);
    const std::uint64_t item = items[i], row = item >> row_shift;
    if (row != last_row) {
      const auto at = static_cast<std::uint32_t>(i);
      if (!rows_.empty()) rows_.back().end = at;
      rows_.push_back({static_cast<std::uint32_t>(row), at, at});
      last_row = row;
      row_begin = i;
    }
    const auto place = static_cast<std::uint32_t>(item & place_mask);
    const Aabb<T>& b = boxes[place];
    // Boxes that share a place along X come in any order.
    std::size_t to = i;
    while (to > row_begin && b.lower.x < lower_x[to - 1]) --to;
    if (to != i) [[unlikely]] {
      const auto make_way = [to, i](auto* numbers) { std::copy_backward(numbers + to, numbers + i, numbers + i + 1); };
      make_way(lower_x), make_way(upper_x), make_way(lower_y), make_way(upper_y), make_way(lower_z), make_way(upper_z);
      make_way(began), make_way(places);
    }
    lower_x[to] = b.lower.x, upper_x[to] = b.upper.x;
    lower_y[to] = b.lower.y, upper_y[to] = b.upper.y;
    lower_z[to] = b.lower.z, upper_z[to] = b.upper.z;
    began[to] = static_cast<int>(item >> began_shift & 3);
    places[to] = place;
  }
  rows_.back().end = static_cast<std::uint32_t>(n);
}

template <class T>
Rows<T> RowGrid<T>::rows() const {
  return {lower_x_.data(), upper_x_.data(), lower_y_.data(), upper_y_.data(), lower_z_.data(), upper_z_.data(),
          reach_x_.data(), began_.data(),   place_.data(),   rows_.data(),    rows_.size(),    z_.count()};
}

template <class T>
void RowGrid<T>::prepare_to_be_swept() {
  if (is_prepared_) return;
  is_prepared_ = true;
  first_row_.assign(y_.count() + 1, 0);
  std::uint32_t y = 0;
  for (std::uint32_t i = 0; i < rows_.size(); ++i)
    for (; y <= rows_[i].index / z_.count(); ++y) first_row_[y] = i;
  for (; y <= y_.count(); ++y) first_row_[y] = static_cast<std::uint32_t>(rows_.size());
  make_room(reach_x_, lower_x_.size());
  for (const Row& row : rows_) {
    T reach = upper_x_[row.begin];
    for (std::uint32_t i = row.begin; i < row.end; ++i) reach_x_[i] = reach = std::max(reach, upper_x_[i]);
  }
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
