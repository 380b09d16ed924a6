#include "broad/row_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "broad/boxes.hpp"
#include "graze/pairs.hpp"

namespace graze {

namespace {

/// A level's cells are this many times the mean of its boxes' longest sides: by Markov's inequality at most half of any
/// boxes are longer and go to the next level.
constexpr int cells_per_mean = 2;
/// What belongs into a level is shorter than its cell by this share: more than rounding can move a box within the grid,
/// so that two boxes that touch are never two rows apart.
constexpr double rounding_share = 1e-6;
/// Cells are numbered within this. What lies further out shares the outermost row, which costs time and no pair.
constexpr double furthest_cell = 1 << 30;

template <class T>
T longest_side(const Aabb<T>& box) {
  const Vec3<T> e = box.extent();
  return greatest(e.x, greatest(e.y, e.z));
}

template <class T>
std::int32_t cell_of(T coordinate, T origin, T cell) {
  const double c =
      std::floor((static_cast<double>(coordinate) - static_cast<double>(origin)) / static_cast<double>(cell));
  return static_cast<std::int32_t>(clamp(c, -furthest_cell, furthest_cell));
}

int bits_for(std::uint64_t values) { return values <= 1 ? 0 : static_cast<int>(std::bit_width(values - 1)); }

}  // namespace

template <class T>
std::size_t RowSweep<T>::Level::memory() const {
  return (lower_x.capacity() * 6) * sizeof(T) + place.capacity() * sizeof(place[0]) + rows.capacity() * sizeof(Row);
}

template <class T>
std::size_t RowSweep<T>::memory() const {
  std::size_t bytes = (small_.capacity() + large_.capacity() + unbounded_.capacity() + begins_.capacity()) * 4 +
                      (items_.capacity() + scratch_.capacity()) * sizeof(KeyedPlace) +
                      found_.capacity() * sizeof(IdPair);
  for (const Level& level : levels_) bytes += level.memory();
  return bytes;
}

template <class T>
void RowSweep<T>::sort_into_rows(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, Level& level) {
  std::int32_t low_y = std::numeric_limits<std::int32_t>::max(), low_z = low_y, high_y = -low_y, high_z = -low_y;
  const auto row_y = [&](const Aabb<T>& b) { return cell_of(b.lower.y, level.origin.y, level.cell); };
  const auto row_z = [&](const Aabb<T>& b) { return cell_of(b.lower.z, level.origin.z, level.cell); };
  for (const std::uint32_t p : places) {
    const std::int32_t y = row_y(boxes[p]), z = row_z(boxes[p]);
    low_y = std::min(low_y, y), high_y = std::max(high_y, y);
    low_z = std::min(low_z, z), high_z = std::max(high_z, z);
  }
  const auto wide = static_cast<std::uint64_t>(std::int64_t{high_z} - low_z + 1);
  const auto tall = static_cast<std::uint64_t>(std::int64_t{high_y} - low_y + 1);
  // The key: row, then the place along X; in as few bits as the grid takes. Where rows leave less than 32 bits for X,
  // its low ones go: the sort below puts right what they leave equal.
  const int bits_z = bits_for(wide), bits_y = bits_for(tall), bits_x = std::min(32, 64 - bits_y - bits_z);
  items_.clear();
  for (const std::uint32_t p : places) {
    const Aabb<T>& b = boxes[p];
    const auto y = static_cast<std::uint64_t>(std::int64_t{row_y(b)} - low_y);
    const auto z = static_cast<std::uint64_t>(std::int64_t{row_z(b)} - low_z);
    const std::uint64_t x = std::uint64_t{order_key(b.lower.x)} >> (32 - bits_x);
    items_.push_back({(((y << bits_z) | z) << bits_x) | x, p});
  }
  radix_sort(items_, scratch_, bits_x + bits_y + bits_z);
  level.rows.clear();
  for (std::uint32_t i = 0; i < items_.size(); ++i) {
    const std::uint64_t row = items_[i].key >> bits_x;
    if (i > 0 && row == items_[i - 1].key >> bits_x) {
      level.rows.back().end = i + 1;
      continue;
    }
    const std::uint64_t mask = (std::uint64_t{1} << bits_z) - 1;
    level.rows.push_back({static_cast<std::int32_t>(static_cast<std::int64_t>(row >> bits_z) + low_y),
                          static_cast<std::int32_t>(static_cast<std::int64_t>(row & mask) + low_z), i, i + 1});
  }
  // The keys' order is that of the coordinates but for the digits that were cut off; in float none were.
  if (sizeof(T) == sizeof(float) && bits_x == 32) return;
  const auto before = [&](const KeyedPlace& p, const KeyedPlace& q) {
    return boxes[p.place].lower.x < boxes[q.place].lower.x;
  };
  for (const auto& row : level.rows) {
    const auto begin = items_.begin() + row.begin, end = items_.begin() + row.end;
    if (!std::is_sorted(begin, end, before)) std::stable_sort(begin, end, before);
  }
}

template <class T>
void RowSweep<T>::build(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, Level& level) {
  sort_into_rows(boxes, places, level);
  const std::size_t n = items_.size();
  for (auto* column : {&level.lower_x, &level.upper_x, &level.lower_y, &level.upper_y, &level.lower_z, &level.upper_z})
    column->resize(n);
  level.place.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Aabb<T>& b = boxes[items_[i].place];
    level.lower_x[i] = b.lower.x, level.upper_x[i] = b.upper.x;
    level.lower_y[i] = b.lower.y, level.upper_y[i] = b.upper.y;
    level.lower_z[i] = b.lower.z, level.upper_z[i] = b.upper.z;
    level.place[i] = items_[i].place;
  }
}

/// Box i of the level against those of one row from `from` on that begin, along X, before it ends. Whether a pair
/// overlaps is hard to foresee, so every pair is written and only the count depends on it.
template <class T>
void RowSweep<T>::test_range(const Level& level, std::uint32_t i, std::uint32_t from, std::uint32_t end) {
  const T upper_x = level.upper_x[i], lower_y = level.lower_y[i], upper_y = level.upper_y[i],
          lower_z = level.lower_z[i], upper_z = level.upper_z[i];
  const std::uint32_t place = level.place[i];
  std::uint32_t last = from;
  while (last < end && level.lower_x[last] <= upper_x) ++last;
  if (last == from) return;
  const std::size_t count = found_.size();
  found_.resize(count + (last - from));
  IdPair* out = found_.data() + count;
  for (std::uint32_t k = from; k < last; ++k) {
    *out = ordered(place, level.place[k]);
    out += static_cast<int>(level.lower_y[k] <= upper_y) & static_cast<int>(lower_y <= level.upper_y[k]) &
           static_cast<int>(level.lower_z[k] <= upper_z) & static_cast<int>(lower_z <= level.upper_z[k]);
  }
  found_.resize(static_cast<std::size_t>(out - found_.data()));
}

template <class T>
void RowSweep<T>::sweep_row(const Level& level, std::uint32_t begin, std::uint32_t end) {
  for (std::uint32_t i = begin; i + 1 < end; ++i) test_range(level, i, i + 1, end);
}

template <class T>
void RowSweep<T>::sweep_rows(const Level& level, const typename Level::Row& r, const typename Level::Row& s) {
  std::uint32_t i = r.begin, k = s.begin;
  while (i < r.end && k < s.end) {
    if (level.lower_x[i] <= level.lower_x[k])
      test_range(level, i++, k, s.end);
    else
      test_range(level, k++, i, r.end);
  }
}

template <class T>
void RowSweep<T>::sweep_level(const Level& level) {
  const auto& rows = level.rows;
  std::size_t above = 0;  // the first row of the next Y that is not behind (y + 1, z - 1)
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    sweep_row(level, row.begin, row.end);
    if (i + 1 < rows.size() && rows[i + 1].y == row.y && rows[i + 1].z == row.z + 1)
      sweep_rows(level, row, rows[i + 1]);
    const auto behind = [&](const auto& other) {
      return other.y < row.y + 1 || (other.y == row.y + 1 && other.z < row.z - 1);
    };
    while (above < rows.size() && behind(rows[above])) ++above;
    for (std::size_t k = above; k < rows.size() && rows[k].y == row.y + 1 && rows[k].z <= row.z + 1; ++k)
      sweep_rows(level, row, rows[k]);
  }
}

/// A box of a higher level against all of this one.
template <class T>
void RowSweep<T>::sweep_over(const Level& level, const Aabb<T>& box, std::uint32_t place) {
  const std::int32_t low_y = cell_of(box.lower.y, level.origin.y, level.cell) - 1,
                     high_y = cell_of(box.upper.y, level.origin.y, level.cell),
                     low_z = cell_of(box.lower.z, level.origin.z, level.cell) - 1,
                     high_z = cell_of(box.upper.z, level.origin.z, level.cell);
  const auto before = [](const typename Level::Row& row, const std::pair<std::int32_t, std::int32_t>& at) {
    return row.y != at.first ? row.y < at.first : row.z < at.second;
  };
  auto row = std::lower_bound(level.rows.begin(), level.rows.end(), std::pair{low_y, low_z}, before);
  while (row != level.rows.end() && row->y <= high_y) {
    if (row->z < low_z || row->z > high_z) {
      const std::int32_t y = row->z < low_z ? row->y : row->y + 1;
      row = std::lower_bound(row, level.rows.end(), std::pair{y, low_z}, before);
      continue;
    }
    // None of them is longer than a cell: those that begin further before this box do not reach it.
    const auto column = level.lower_x.begin();
    const T first = box.lower.x - level.cell - T(4) * std::numeric_limits<T>::epsilon() * std::abs(box.lower.x);
    auto k = static_cast<std::uint32_t>(std::lower_bound(column + row->begin, column + row->end, first) - column);
    for (; k < row->end && level.lower_x[k] <= box.upper.x; ++k)
      if (level.upper_x[k] >= box.lower.x && level.lower_y[k] <= box.upper.y && level.upper_y[k] >= box.lower.y &&
          level.lower_z[k] <= box.upper.z && level.upper_z[k] >= box.lower.z)
        found_.push_back(ordered(place, level.place[k]));
    ++row;
  }
}

/// By the smaller place through counting, then the few of each by the larger.
template <class T>
void RowSweep<T>::sort_pairs(std::size_t boxes, std::vector<IdPair>& out) {
  begins_.assign(boxes + 1, 0);
  for (const IdPair& p : found_) ++begins_[p.a + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  out.resize(found_.size());
  for (const IdPair& p : found_) out[begins_[p.a]++] = p;
  // `begins_[a]` is now where the pairs of a end.
  std::size_t begin = 0;
  for (std::size_t a = 0; a < boxes; ++a) {
    const std::size_t end = begins_[a];
    const auto at = [&](std::size_t i) { return out.begin() + static_cast<std::ptrdiff_t>(i); };
    if (end - begin > 1) std::sort(at(begin), at(end), [](const IdPair& p, const IdPair& q) { return p.b < q.b; });
    begin = end;
  }
}

/// What no grid can hold, against everything.
template <class T>
void RowSweep<T>::sweep_unbounded(std::span<const Aabb<T>> boxes) {
  std::vector<char> is_unbounded(unbounded_.empty() ? 0 : boxes.size(), 0);
  for (const std::uint32_t u : unbounded_) {
    is_unbounded[u] = 1;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (is_unbounded[i] == 0 && overlap(boxes[u], boxes[i])) found_.push_back(ordered(u, i));
  }
}

template <class T>
void RowSweep<T>::find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out) {
  found_.clear();
  small_.clear();
  unbounded_.clear();
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    (longest_side(boxes[i]) < std::numeric_limits<T>::infinity() ? small_ : unbounded_).push_back(i);

  std::size_t count = 0;
  while (!small_.empty()) {
    if (count == levels_.size()) levels_.emplace_back();
    Level& level = levels_[count];
    double sum = 0;
    for (const std::uint32_t i : small_)
      sum += static_cast<double>(longest_side(boxes[i])) / static_cast<double>(small_.size());
    level.origin = boxes[small_[0]].lower;
    // A level of points needs some size of cell: any will do.
    constexpr double huge = static_cast<double>(std::numeric_limits<T>::max()) / 4;
    const T some = std::numeric_limits<T>::min() + std::numeric_limits<T>::epsilon() * max_abs(level.origin);
    level.cell = greatest(static_cast<T>(std::min(cells_per_mean * sum, huge)), some);
    const T longest = static_cast<T>(static_cast<double>(level.cell) * (1 - rounding_share));
    large_.clear();
    std::erase_if(small_, [&](std::uint32_t i) {
      if (longest_side(boxes[i]) <= longest) return false;
      large_.push_back(i);
      return true;
    });
    if (small_.empty()) {  // too long for any cell to be counted
      unbounded_.insert(unbounded_.end(), large_.begin(), large_.end());
      break;
    }
    build(boxes, small_, level);
    sweep_level(level);
    for (std::size_t below = 0; below < count; ++below)
      for (const std::uint32_t i : small_) sweep_over(levels_[below], boxes[i], i);
    small_.swap(large_);
    ++count;
  }
  sweep_unbounded(boxes);
  sort_pairs(boxes.size(), out);
}

template <class T>
PairFinder<T>::PairFinder() : sweep_(std::make_unique<RowSweep<T>>()) {}
template <class T>
PairFinder<T>::~PairFinder() = default;
template <class T>
PairFinder<T>::PairFinder(PairFinder&&) noexcept = default;
template <class T>
PairFinder<T>& PairFinder<T>::operator=(PairFinder&&) noexcept = default;
template <class T>
void PairFinder<T>::find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out) {
  sweep_->find(boxes, out);
}
template <class T>
std::size_t PairFinder<T>::memory() const {
  return sweep_->memory();
}

template class RowSweep<float>;
template class RowSweep<double>;
template class PairFinder<float>;
template class PairFinder<double>;

}  // namespace graze
