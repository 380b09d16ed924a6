#include "broad/kept_pairs.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "broad/kept_kernels.hpp"
#include "broad/pair_order.hpp"
#include "graze/pairs.hpp"

namespace graze {

namespace {

/// The room on each side of a box as a share of the length that half of the boxes exceed: more makes a list that lasts
/// longer and is longer itself, by the cube of what it adds to the boxes.
constexpr double room_per_length = 0.08;
/// The most room of a box on each side, as a share of its own length along the axis: dust beside large boxes and
/// bundles of needles would else overlap by the thousand.
constexpr double most_room = 0.25;
/// The share of boxes, one in so many, that may have left before a new list is cheaper: looking for the pairs of one
/// takes about twice its share in finding all pairs.
constexpr std::size_t boxes_per_left = 8;
/// The frames for which most boxes would have to stay in their rooms for a list to be tried: making it takes some 1.7
/// times as long as finding all pairs without one.
constexpr int frames_to_last = 3;
/// The frames below which a list was not worth making: the next one waits, each time longer up to a limit.
constexpr std::size_t few_frames = 2, longest_pause = 63;
/// The mean number of pairs of a box above which no list is kept: finding the pairs costs little more than going
/// through a list of them, and the list would take more memory than the boxes.
constexpr std::size_t pairs_per_box = 8;
/// The number of boxes whose motion stands for that of all.
constexpr std::size_t most_samples = 256;
/// Pairs of the list in a task: some microseconds of work.
constexpr std::size_t pairs_per_task = 4096;
/// The number of boxes that overlap much and may still be in the list: going through it costs less for them than
/// comparing them anew.
constexpr std::size_t few_wide = 4;

/// The place of sample `i`: steps of the golden ratio (Knuth 1998, "The Art of Computer Programming", volume 3, section
/// 6.4).
std::size_t sample_place(std::size_t i, std::size_t count) {
  return static_cast<std::size_t>((std::uint64_t{static_cast<std::uint32_t>(i) * 0x9e3779b9u} * count) >> 32);
}

/// The box with `room` on each side, or less along those axes on which it is small. A box that lies at infinity has no
/// length that is a number, and gets `room`, since `least` of that and a NaN is `room`.
template <class T>
Aabb<T> with_room(const Aabb<T>& box, const T& room) {
  const Vec3<T> d = least(Vec3<T>{room, room, room}, box.extent() * T(most_room));
  return {box.lower - d, box.upper + d};
}

std::size_t words_for(std::size_t bits) { return bits / 64 + 1; }

template <class T>
const T* numbers(std::span<const Aabb<T>> boxes) {
  static_assert(sizeof(Aabb<T>) == 6 * sizeof(T));
  return reinterpret_cast<const T*>(boxes.data());
}

}  // namespace

template <class T>
void KeptPairs<T>::find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor) {
  if (!find_by_list(boxes, out, executor)) {
    end_list();
    if (is_worth_a_list(boxes)) make_list(boxes);
    if (has_list_)
      keep_overlapping_ones(boxes, nullptr, not_apart(out), executor);
    else
      find_anew(boxes, out);
  }
  take_samples(boxes);
  last_count_ = not_apart(out).size();
  if (!apart_.empty()) compare_apart(boxes, out);
}

template <class T>
void KeptPairs<T>::find_anew(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out) {
  all_.find(boxes);
  apart_.assign(all_.wide().begin(), all_.wide().end());
  all_.sort_into(not_apart(out));
}

/// Puts the pairs of the boxes apart among the others. Where they overlap far less than they did, other boxes may have
/// taken their part, and the list ends.
template <class T>
void KeptPairs<T>::compare_apart(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out) {
  wide_.merge(isa_, boxes, apart_, inner_, out);
  const std::size_t pairs = out.size() - inner_.size();
  if (frames_ == 0) apart_pairs_ = pairs;
  if (2 * pairs < apart_pairs_) end_list();
}

/// Finds the pairs by the list. Returns false where there is none, or too many boxes have left for it to be of use.
template <class T>
bool KeptPairs<T>::find_by_list(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor) {
  if (!has_list_) return false;
  fit_list(boxes.size());
  const std::size_t most = boxes.size() / boxes_per_left;
  if (left_.size() < most + 1) left_.resize(std::max(most + 1, left_.size()));
  const std::uint32_t left = GRAZE_KERNEL(isa_, find_left<T>)(numbers(boxes), numbers(std::span<const Aabb<T>>(rooms_)),
                                                              static_cast<std::uint32_t>(boxes.size()), left_.data(),
                                                              static_cast<std::uint32_t>(most + 1));
  if (left > most) return false;
  const std::span<const std::uint32_t> places{left_.data(), left};
  if (!std::all_of(places.begin(), places.end(), [&](std::uint32_t i) { return is_bounded(boxes[i]); })) return false;
  ++frames_;
  if (left == 0) {
    keep_overlapping_ones(boxes, nullptr, not_apart(out), executor);
    return true;
  }
  has_left_.assign(words_for(std::max(boxes.size(), rooms_.size())), 0);
  for (const std::uint32_t i : places) has_left_[i / 64] |= std::uint64_t{1} << (i % 64);
  find_pairs_of_left(boxes, places);
  keep_overlapping_ones(boxes, has_left_.data(), not_apart(out), executor);
  merge_found(boxes.size(), not_apart(out));
  return true;
}

/// Fits the list to the number of boxes. New places are those of boxes that have no room at all.
template <class T>
void KeptPairs<T>::fit_list(std::size_t boxes) {
  if (boxes < rooms_.size()) {
    std::erase_if(list_, [boxes](const IdPair& p) { return p.b >= boxes; });
    std::erase_if(apart_, [boxes](std::uint32_t place) { return place >= boxes; });
  }
  if (boxes != rooms_.size()) rooms_.resize(boxes, Aabb<T>::empty());
}

template <class T>
void KeptPairs<T>::find_pairs_of_left(std::span<const Aabb<T>> boxes, std::span<const std::uint32_t> left) {
  found_.clear();
  left_sweep_.find_among(boxes, left, found_);
  const std::size_t among = found_.first().size();
  all_.find_over(boxes, left, found_);
  // The grid holds all rooms of the list, also those that their boxes have left and those of boxes that are gone.
  const auto is_in_room = [&](std::uint32_t i) { return i < boxes.size() && (has_left_[i / 64] >> (i % 64) & 1) == 0; };
  found_.keep_if(
      among, [&](std::uint32_t a, std::uint32_t b) { return is_in_room(b) && overlap(boxes[a], boxes[b]); },
      [&](std::uint32_t b) { __builtin_prefetch(boxes.data() + b); });
  if (!apart_.empty()) return;
  for (const std::uint32_t b : all_.wide())
    if (is_in_room(b))
      for (const std::uint32_t a : left)
        if (overlap(boxes[a], boxes[b])) found_.add(a, b);
}

/// Adds the pairs of the list that overlap. Room in `out` is made bit by bit: about half of the list overlaps, and room
/// that is not used would have been cleared for nothing.
template <class T>
void KeptPairs<T>::keep_overlapping_ones(std::span<const Aabb<T>> boxes, const std::uint64_t* dropped,
                                         std::vector<IdPair>& out, Executor& executor) {
  if (executor.concurrency() > 1 && list_.size() > pairs_per_task)
    return keep_side_by_side(boxes, dropped, out, executor);
  const auto keep = GRAZE_KERNEL(isa_, keep_overlapping<T>);
  const std::size_t list = list_.size(), step = list / 16 + 1024;
  out.resize(std::min(list, last_count_ + step));
  std::size_t done = 0, kept = 0;
  while (done < list) {
    const std::size_t next = std::min(list - done, std::max(step, out.size() - kept));
    if (out.size() - kept < next) out.resize(std::max(kept + next, std::min(out.capacity(), out.size() + step)));
    kept += keep(numbers(boxes), numbers(std::span<const IdPair>(list_)) + 2 * done, next, dropped,
                 numbers(std::span(out)) + 2 * kept);
    done += next;
  }
  out.resize(kept);
}

/// Adds the pairs of the list that overlap by several threads: each task keeps the pairs of its part of the list where
/// that begins, and they are laid one behind the other when all are done.
template <class T>
void KeptPairs<T>::keep_side_by_side(std::span<const Aabb<T>> boxes, const std::uint64_t* dropped,
                                     std::vector<IdPair>& out, Executor& executor) {
  const auto keep = GRAZE_KERNEL(isa_, keep_overlapping<T>);
  if (kept_.size() < list_.size()) kept_.resize(list_.size());
  kept_counts_.resize((list_.size() + pairs_per_task - 1) / pairs_per_task);
  for_each_chunk(executor, list_.size(), pairs_per_task, [&](std::size_t begin, std::size_t end, std::size_t task) {
    kept_counts_[task] = keep(numbers(boxes), numbers(std::span<const IdPair>(list_)) + 2 * begin, end - begin, dropped,
                              numbers(std::span(kept_)) + 2 * begin);
  });
  kept_places_.resize(kept_counts_.size());
  std::exclusive_scan(kept_counts_.begin(), kept_counts_.end(), kept_places_.begin(), std::size_t{0});
  out.resize(kept_counts_.empty() ? 0 : kept_places_.back() + kept_counts_.back());
  executor.run(kept_counts_.size(), [&](std::size_t task) {
    std::copy_n(kept_.data() + task * pairs_per_task, kept_counts_[task], out.data() + kept_places_[task]);
  });
}

/// Merges the found pairs into the sorted ones of `out`.
template <class T>
void KeptPairs<T>::merge_found(std::size_t boxes, std::vector<IdPair>& out) {
  std::size_t left = found_.first().size(), other = out.size();
  of_left_.resize(left);
  order_.sort(found_.first(), found_.second(), boxes, of_left_.data());
  out.resize(other + left);
  // From behind: pairs after one that is put in move on, and those before all of them stay. A branch on which is next
  // would be mispredicted often, so there is none.
  IdPair* const to = out.data();
  const IdPair* const from = of_left_.data();
  while (left > 0 && other > 0) {
    const std::size_t is_other = order_key(from[left - 1]) < order_key(to[other - 1]) ? 1 : 0;
    const IdPair* const next = is_other != 0 ? to + other : from + left;
    to[left + other - 1] = next[-1];
    other -= is_other, left -= 1 - is_other;
  }
  std::copy(from, from + left, to);
}

/// Whether most boxes have moved so little since the last frame that a list would last.
template <class T>
bool KeptPairs<T>::is_worth_a_list(std::span<const Aabb<T>> boxes) {
  if (samples_.empty() || boxes.empty() || last_count_ > boxes.size() * pairs_per_box) return false;
  if (wait_ > 0) {
    --wait_;
    return false;
  }
  const T step = room_of_most(boxes) / T(frames_to_last);
  std::size_t stay = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const std::size_t place = sample_place(i, sampled_);
    stay += place < boxes.size() && contains(with_room(samples_[i], step), boxes[place]) ? 1 : 0;
  }
  return (samples_.size() - stay) * boxes_per_left <= samples_.size();
}

/// The room on each side of most boxes, by the length that half of them exceed.
template <class T>
T KeptPairs<T>::room_of_most(std::span<const Aabb<T>> boxes) {
  lengths_.clear();
  for (std::size_t i = 0; i < std::min(boxes.size(), most_samples); ++i) {
    const Vec3<T> e = boxes[sample_place(i, boxes.size())].extent();
    lengths_.push_back(greatest(e.x, greatest(e.y, e.z)));
  }
  const auto middle = lengths_.begin() + static_cast<std::ptrdiff_t>(lengths_.size() / 2);
  std::nth_element(lengths_.begin(), middle, lengths_.end());
  return *middle <= std::numeric_limits<T>::max() ? *middle * T(room_per_length) : T(0);
}

template <class T>
void KeptPairs<T>::make_list(std::span<const Aabb<T>> boxes) {
  const T room = room_of_most(boxes);
  rooms_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) rooms_[i] = with_room(boxes[i], room);
  frames_ = 0;
  has_list_ = all_.find(rooms_, boxes.size() * pairs_per_box);
  if (!has_list_) {
    pause();
    return;
  }
  all_.sort_into(list_);
  apart_.clear();
  const std::span<const std::uint32_t> wide = all_.wide();
  if (wide.size() > few_wide) {
    apart_.assign(wide.begin(), wide.end());
    for (const std::uint32_t i : wide) rooms_[i] = Aabb<T>::everything();
  } else if (!wide.empty()) {
    inner_.swap(list_);
    wide_.merge(isa_, rooms_, wide, inner_, list_);
  }
}

template <class T>
void KeptPairs<T>::end_list() {
  if (!has_list_) return;
  has_list_ = false;
  pause();
}

template <class T>
void KeptPairs<T>::pause() {
  pause_ = frames_ < few_frames ? std::min(2 * pause_ + 1, longest_pause) : 0;
  wait_ = pause_;
}

template <class T>
void KeptPairs<T>::take_samples(std::span<const Aabb<T>> boxes) {
  sampled_ = boxes.size();
  samples_.clear();
  for (std::size_t i = 0; i < std::min(boxes.size(), most_samples); ++i)
    samples_.push_back(boxes[sample_place(i, boxes.size())]);
}

template <class T>
std::size_t KeptPairs<T>::memory() const {
  return all_.memory() + left_sweep_.memory() + found_.memory() + order_.memory() + wide_.memory() +
         (rooms_.capacity() + samples_.capacity()) * sizeof(Aabb<T>) +
         (list_.capacity() + of_left_.capacity() + inner_.capacity() + kept_.capacity()) * sizeof(IdPair) +
         (kept_counts_.capacity() + kept_places_.capacity()) * sizeof(std::size_t) + lengths_.capacity() * sizeof(T) +
         (left_.capacity() + apart_.capacity()) * sizeof(std::uint32_t) + has_left_.capacity() * sizeof(std::uint64_t);
}

template <class T>
PairFinder<T>::PairFinder() : kept_(std::make_unique<KeptPairs<T>>()) {}
template <class T>
PairFinder<T>::~PairFinder() = default;
template <class T>
PairFinder<T>::PairFinder(PairFinder&&) noexcept = default;
template <class T>
PairFinder<T>& PairFinder<T>::operator=(PairFinder&&) noexcept = default;
template <class T>
void PairFinder<T>::find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out) {
  SerialExecutor serial;
  kept_->find(boxes, out, serial);
}
template <class T>
void PairFinder<T>::find(std::span<const Aabb<T>> boxes, std::vector<IdPair>& out, Executor& executor) {
  kept_->find(boxes, out, executor);
}
template <class T>
std::size_t PairFinder<T>::memory() const {
  return kept_->memory();
}

template class KeptPairs<float>;
template class KeptPairs<double>;
template class PairFinder<float>;
template class PairFinder<double>;

}  // namespace graze
