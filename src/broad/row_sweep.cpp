#include "broad/row_sweep.hpp"

#include <algorithm>
#include <numeric>

#include "broad/boxes.hpp"
#include "broad/radix_sort.hpp"
#include "broad/wide_boxes.hpp"

namespace graze {

namespace {

/// The multiple of the mean of all longest sides up to which boxes are taken into a level: by Markov's inequality at
/// most half of any boxes are longer and go to the next one.
constexpr double longest_per_mean = 2;

template <class T>
T longest_side(const Aabb<T>& box) {
  const Vec3<T> e = box.extent();
  return greatest(e.x, greatest(e.y, e.z));
}

}  // namespace

template <class T>
std::size_t RowSweep<T>::memory() const {
  std::size_t bytes = (members_.capacity() + larger_.capacity() + wide_.capacity()) * sizeof(std::uint32_t) +
                      found_.memory() + over_.capacity() * sizeof(SweptOver<T>) +
                      (by_row_.capacity() + scratch_.capacity()) * sizeof(std::uint64_t) + order_.memory();
  for (const RowGrid<T>& level : levels_) bytes += level.memory();
  return bytes;
}

/// Finds what the boxes of the first level span, in most scenes all of them: finite and of about one size. One pass
/// without branches. Returns false where some are not so, and `spans` is of no use then.
template <class T>
bool RowSweep<T>::all_alike(std::span<const Aabb<T>> boxes, Spans<T>& spans) {
  spans = {boxes[0].lower, boxes[0].lower, {}};
  Vec3<T> furthest = boxes[0].upper;
  double sum = 0;
  for (const Aabb<T>& box : boxes) {
    const Vec3<T> e = box.extent();
    spans.lowest = least(spans.lowest, box.lower);
    spans.highest = greatest(spans.highest, box.lower);
    furthest = greatest(furthest, box.upper);
    spans.longest = greatest(spans.longest, e);
    sum += static_cast<double>(greatest(e.x, greatest(e.y, e.z)));
  }
  const auto longest = static_cast<double>(greatest(spans.longest.x, greatest(spans.longest.y, spans.longest.z)));
  if (!is_bounded(Aabb<T>{spans.lowest, furthest}) || !is_bounded(Aabb<T>{spans.highest, furthest}) ||
      longest > longest_per_mean * (sum / static_cast<double>(boxes.size())))
    return false;
  if (members_.size() != boxes.size()) members_.resize(boxes.size());
  std::iota(members_.begin(), members_.end(), 0u);
  larger_.clear();
  return true;
}

/// Keeps in `members_` the boxes that belong into the next level, and puts longer ones into `larger_`.
template <class T>
Spans<T> RowSweep<T>::split(std::span<const Aabb<T>> boxes) {
  const double share = 1 / static_cast<double>(members_.size());
  double mean = 0;
  for (const std::uint32_t i : members_) mean += static_cast<double>(longest_side(boxes[i])) * share;
  larger_.clear();
  Spans<T> spans{boxes[members_[0]].lower, boxes[members_[0]].lower, {}};
  std::size_t kept = 0;
  for (const std::uint32_t i : members_) {
    const Aabb<T>& box = boxes[i];
    // The mean is rounded, too: none of several equal boxes may be longer than twice their mean.
    if (static_cast<double>(longest_side(box)) > longest_per_mean * mean) {
      larger_.push_back(i);
      continue;
    }
    members_[kept++] = i;
    spans.lowest = least(spans.lowest, box.lower);
    spans.highest = greatest(spans.highest, box.lower);
    spans.longest = greatest(spans.longest, box.extent());
  }
  members_.resize(kept);
  return spans;
}

/// Sweeps one level with itself and with those below it.
template <class T>
void RowSweep<T>::sweep(std::span<const Aabb<T>> boxes, std::size_t level, PairSink& sink) {
  GRAZE_KERNEL(isa_, sweep_rows<T>)(levels_[level].rows(), sink);
  for (std::size_t below = 0; below < level; ++below) sweep_over_level(boxes, members_, below, sink);
}

template <class T>
void RowSweep<T>::sweep_over_level(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places,
                                   std::size_t level, PairSink& sink) {
  const RowGrid<T>& grid = levels_[level];
  const std::size_t n = places.size();
  if (by_row_.size() < n) by_row_.resize(n + n / 8), scratch_.resize(n + n / 8);
  // Boxes are taken row by row, so that a row is fetched once for all that it is compared with.
  const auto item = [&](std::size_t k) { return std::uint64_t{grid.first_row_of(boxes[places[k]])} << 32 | places[k]; };
  Digits digits;
  digits.add(32, bits_below(grid.row_limit()));
  const std::uint64_t* const sorted = radix_sort(
      n, item, digits, [](std::uint64_t v) { return v; }, by_row_.data(), scratch_.data());
  over_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::uint32_t>(sorted[k]);
    over_.push_back(grid.reach_of(boxes[i], i));
  }
  GRAZE_KERNEL(isa_, sweep_over<T>)(grid.rows(), grid.strips(), over_.data(), over_.size(), sink);
}

template <class T>
bool RowSweep<T>::find(std::span<const Aabb<T>> boxes, std::size_t most) {
  box_count_ = boxes.size();
  found_.clear(most);
  PairSink sink = found_.sink();
  members_.clear();
  wide_.clear();
  Spans<T> spans;
  const bool alike = !boxes.empty() && all_alike(boxes, spans);
  for (std::uint32_t i = 0; !alike && i < boxes.size(); ++i) (is_bounded(boxes[i]) ? members_ : wide_).push_back(i);
  for (level_count_ = 0; !members_.empty(); ++level_count_) {
    const std::size_t level = level_count_;
    if (level == levels_.size()) levels_.emplace_back();
    if (!alike) spans = split(boxes);
    if (level == 0 && !larger_.empty() && WideBoxes<T>::worthwhile(boxes, larger_)) {
      wide_.insert(wide_.end(), larger_.begin(), larger_.end());
      std::sort(wide_.begin(), wide_.end());
      larger_.clear();
    }
    levels_[level].build(boxes, members_, spans);
    if (!larger_.empty()) levels_[level].prepare_to_be_swept();
    sweep(boxes, level, sink);
    members_ = larger_;
  }
  found_.take(sink);
  return !found_.is_full();
}

template <class T>
void RowSweep<T>::sort_into(std::vector<IdPair>& out) {
  out.resize(found_.first().size());
  order_.sort(found_.first(), found_.second(), box_count_, out.data());
}

template <class T>
void RowSweep<T>::find_among(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, FoundPairs& found) {
  PairSink sink = found.sink();
  members_.assign(places.begin(), places.end());
  for (level_count_ = 0; !members_.empty(); ++level_count_) {
    if (level_count_ == levels_.size()) levels_.emplace_back();
    RowGrid<T>& level = levels_[level_count_];
    const Spans<T> spans = split(boxes);
    level.build(boxes, members_, spans);
    if (!larger_.empty()) level.prepare_to_be_swept();
    sweep(boxes, level_count_, sink);
    members_ = larger_;
  }
  found.take(sink);
}

template <class T>
void RowSweep<T>::find_over(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> places, FoundPairs& found) {
  PairSink sink = found.sink();
  for (std::size_t level = 0; level < level_count_; ++level) {
    levels_[level].prepare_to_be_swept();
    sweep_over_level(boxes, places, level, sink);
  }
  found.take(sink);
}

template class RowSweep<float>;
template class RowSweep<double>;

}  // namespace graze
