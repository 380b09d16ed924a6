// Grouping of a batch's pairs by their two kinds, for kernels.
//
// Guarantee: every pair is passed on once, to a kernel or alone. Nothing is allocated.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "graze/batch.hpp"
#include "narrow/batch/lane_pairs.hpp"

namespace graze {

/// A pair of the list and whether a batch's two shapes have to be swapped for it, as one number.
constexpr std::uint8_t queue_of(const LanesFor& lanes) {
  return static_cast<std::uint8_t>(2 * lanes.pair + lanes.turned);
}
constexpr LanesFor lanes_of_queue(std::uint8_t queue) { return {static_cast<LanePair>(queue / 2), queue % 2 != 0}; }

/// Pairs that wait for a kernel, with their indices in the batch: data loaded for one kernel are in the cache when the
/// next one needs them.
template <class T>
struct Queue {
  std::array<PairRef<T>, batch_chunk> pairs;
  std::array<std::size_t, batch_chunk> places;
  std::size_t count = 0;
};

/// The bodies of a side of one kind: each shape at a constant stride in bytes and each pose at a constant stride in
/// poses, zero for a single one. A pair takes few instructions this way, unlike by the general `Bodies`.
template <class T>
struct EvenRow {
  const char* shapes;
  const Pose<T>* poses;
  std::ptrdiff_t shape_stride = 0, pose_stride = 0;

  explicit EvenRow(const Bodies<T>& bodies)
      : shapes(static_cast<const char*>(bodies.concrete(0))), poses(&bodies.pose(0)) {
    if (bodies.size() < 2) return;
    shape_stride = static_cast<const char*>(bodies.concrete(1)) - shapes;
    pose_stride = &bodies.pose(1) - poses;
  }
  const void* shape(std::uint32_t i) const { return shapes + i * shape_stride; }
  const Pose<T>* pose(std::uint32_t i) const { return poses + i * pose_stride; }
};

/// Prefetches the data that kernels load for a pair: kernels run when the queue is full, and the first lines arrive
/// while it is filled.
template <class T>
void fetch(const PairRef<T>& pair) {
  __builtin_prefetch(pair.pose_a);
  __builtin_prefetch(pair.pose_b);
  __builtin_prefetch(pair.a);
  __builtin_prefetch(pair.b);
}

/// Appends to the queue pairs of one pair of kinds, from `first` on, as many as there is room for; returns their
/// number.
template <class T>
std::size_t append_even(const Batch<T>& batch, const EvenRow<T>& a, const EvenRow<T>& b, std::size_t first, bool turned,
                        T margin, Queue<T>& queue) {
  const std::size_t begin = queue.count, count = std::min(batch_chunk - begin, batch.size() - first);
  for (std::size_t k = 0; k < count; ++k) {
    IdPair p = batch[first + k];
    if (turned) std::swap(p.a, p.b);
    queue.pairs[begin + k] = {a.shape(p.a), b.shape(p.b), a.pose(p.a), b.pose(p.b), margin};
    queue.places[begin + k] = first + k;
    fetch(queue.pairs[begin + k]);
  }
  queue.count += count;
  return count;
}

/// Removes pairs that lanes do not take from the queue, from the `begin`-th on, and passes them to `single(i)`.
template <class T, class Single>
void drop_not_taken(std::size_t kind_a, std::size_t kind_b, std::size_t begin, Queue<T>& queue, Single&& single) {
  std::size_t kept = begin;
  for (std::size_t k = begin; k < queue.count; ++k) {
    if (!taken_by_lanes<T>(kind_a, queue.pairs[k].a) || !taken_by_lanes<T>(kind_b, queue.pairs[k].b)) {
      single(queue.places[k]);
      continue;
    }
    queue.pairs[kept] = queue.pairs[k];
    queue.places[kept++] = queue.places[k];
  }
  queue.count = kept;
}

/// `visit_batch` for sides of one kind each, known at compile time: no pair's kinds are looked up.
template <class T, class Run, class Single>
void visit_even_batch(const Batch<T>& batch, T margin, const LanesFor& lanes, Run&& run, Single&& single) {
  const Bodies<T>&first = lanes.turned ? batch.b() : batch.a(), &second = lanes.turned ? batch.a() : batch.b();
  const std::size_t kind_a = first.kind(0), kind_b = second.kind(0);
  const EvenRow<T> a(first), b(second);
  Queue<T> queue;
  for (std::size_t i = 0; i < batch.size();) {
    const std::size_t begin = queue.count;
    i += append_even(batch, a, b, i, lanes.turned, margin, queue);
    const std::size_t added = queue.count - begin;
    if (!all_taken_by_lanes<T>(kind_a, added, [&](std::size_t k) { return queue.pairs[begin + k].a; }) ||
        !all_taken_by_lanes<T>(kind_b, added, [&](std::size_t k) { return queue.pairs[begin + k].b; }))
      drop_not_taken(kind_a, kind_b, begin, queue, single);
    if (queue.count < batch_chunk && i < batch.size()) continue;
    if (queue.count > 0) run(lanes, queue);
    queue.count = 0;
  }
}

/// Visits all pairs of the batch: `run(lanes, queue)` calls the kernel of a pair in `wanted`, `single(i)` answers for
/// one pair of the batch. The kernel of a pair in `judging` also gets shapes that lanes do not take, and rejects these
/// itself.
template <class T, class Run, class Single>
void visit_batch(const Batch<T>& batch, T margin, const LanePairSet& wanted, const LanePairSet& judging, Run&& run,
                 Single&& single) {
  const Bodies<T>&a = batch.a(), &b = batch.b();
  if (batch.size() > 0 && a.one_kind() && b.one_kind()) {
    const LanesFor lanes = lane_table<T>(a.kind(0), b.kind(0));
    if (wanted(lanes.pair)) return visit_even_batch(batch, margin, lanes, run, single);
    for (std::size_t i = 0; i < batch.size(); ++i) single(i);
    return;
  }
  std::array<Queue<T>, 2 * PairList::count> queues;
  const auto flush = [&](std::uint8_t number) {
    run(lanes_of_queue(number), queues[number]);
    queues[number].count = 0;
  };
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const std::size_t kind_a = a.kind(p.a), kind_b = b.kind(p.b);
    const LanesFor lanes = lane_table<T>(kind_a, kind_b);
    if (!wanted(lanes.pair) || a.rounding(p.a) != T(0) || b.rounding(p.b) != T(0)) {
      single(i);
      continue;
    }
    const void *shape_a = a.concrete(p.a), *shape_b = b.concrete(p.b);
    if (!judging(lanes.pair) && (!taken_by_lanes<T>(kind_a, shape_a) || !taken_by_lanes<T>(kind_b, shape_b))) {
      single(i);
      continue;
    }
    const std::uint8_t number = queue_of(lanes);
    Queue<T>& queue = queues[number];
    queue.pairs[queue.count] = lanes.turned ? PairRef<T>{shape_b, shape_a, &b.pose(p.b), &a.pose(p.a), margin}
                                            : PairRef<T>{shape_a, shape_b, &a.pose(p.a), &b.pose(p.b), margin};
    queue.places[queue.count++] = i;
    if (queue.count == batch_chunk) flush(number);
  }
  for (std::size_t number = 0; number < queues.size(); ++number)
    if (queues[number].count > 0) flush(static_cast<std::uint8_t>(number));
}

}  // namespace graze
