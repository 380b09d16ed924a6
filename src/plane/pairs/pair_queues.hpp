// The pairs of a batch, gathered by the entry of the list that answers for them.
//
// Guarantee: visits every pair once, in blocks of one entry and two kinds of shapes, or of polygons of few vertices,
// loaded as columns; pairs that no kernel takes are visited one by one.
#pragma once

#include <algorithm>

#include "graze/plane/batch.hpp"
#include "plane/pairs/load_kernels.hpp"
#include "plane/pairs/polygon_queue.hpp"

namespace graze::plane {

/// Pairs of two kinds that wait for a block to fill.
template <class T>
struct PairQueue {
  std::size_t count = 0;
  const void *a[block_pairs], *b[block_pairs];
  const Pose2<T>*pose_a[block_pairs], *pose_b[block_pairs];
  T rounding_a[block_pairs], rounding_b[block_pairs];
  std::uint32_t place[block_pairs];
  bool rounded = false;  ///< whether any shape has a rounding
};

/// A block of pairs of one entry, or of polygons without one.
struct PairBlock {
  std::size_t count;
  const std::uint32_t* place;  ///< of each in the batch
  PairEntry entry;             ///< of all of them
  const PairKernels* kernels;  ///< of that entry
  const PairColumns<block_pairs>* columns;
  const PolygonBlock* polygons;

  /// The overlaps of an entry's pairs; polygons have no kernel for them.
  void overlaps(OverlapColumns<block_pairs>& found) const { kernels->overlaps(*columns, count, found); }
  void distances(DistanceColumns<block_pairs>& found) const {
    polygons ? polygon_kernels().distances(*polygons, count, found) : kernels->distances(*columns, count, found);
  }
  void contacts(const double (&margins)[block_pairs], ContactColumns<block_pairs>& found) const {
    polygons ? polygon_kernels().contacts(*polygons, count, margins, found)
             : kernels->contacts(*columns, count, margins, found);
  }
};

template <class T>
class PairQueues {
 public:
  PairQueues()
      : kernels_(GRAZE_KERNEL(chosen_isa(), plane_pair_kernels)()),
        load_(GRAZE_KERNEL(chosen_isa(), plane_load_kernels)().template of<T>()) {}

  /// Calls `block(PairBlock)` and `alone(i)` for the pairs from `begin` to `end`. With `polygons`, polygons without an
  /// entry stand in blocks too.
  template <class Block, class Alone>
  void visit(const Batch<T>& batch, std::size_t begin, std::size_t end, bool polygons, const Block& block,
             const Alone& alone) {
    for (std::size_t i = begin; i < end; ++i)
      if (!add(batch, i, polygons, block)) alone(i);
    finish(block);
  }
  /// Takes the i-th pair into a block, which is visited when it is full, and returns whether one takes it.
  template <class Block>
  bool add(const Batch<T>& batch, std::size_t i, bool polygons, const Block& block) {
    const Bodies<T>&a = batch.a(), &b = batch.b();
    const IdPair p = batch[i];
    const std::size_t kind_a = a.kind(p.a), kind_b = b.kind(p.b);
    const std::optional<PairEntry>& entry = KindTable<T>::at(kind_a, kind_b);
    if (!entry || !accepts(a, p.a, kind_a) || !accepts(b, p.b, kind_b)) {
      if (entry || !polygons || !polygons_.take(batch, i)) return false;
      if (polygons_.count() == block_pairs) run_polygons(block);
      return true;
    }
    PairQueue<T>& queue = queues_[queue_of(kind_a, kind_b)];
    const std::size_t k = queue.count++;
    queue.a[k] = a.concrete(p.a);
    queue.b[k] = b.concrete(p.b);
    queue.pose_a[k] = &a.pose(p.a);
    queue.pose_b[k] = &b.pose(p.b);
    queue.rounding_a[k] = a.rounding(p.a);
    queue.rounding_b[k] = b.rounding(p.b);
    queue.rounded = queue.rounded || queue.rounding_a[k] != T(0) || queue.rounding_b[k] != T(0);
    queue.place[k] = static_cast<std::uint32_t>(i);
    if (queue.count == block_pairs) run(kind_a, kind_b, queue, block);
    return true;
  }
  /// Visits the blocks that are not full.
  template <class Block>
  void finish(const Block& block) {
    for (std::size_t ka = 0; ka < kinds; ++ka)
      for (std::size_t kb = 0; kb < kinds; ++kb)
        if (slot_of[ka] < slots && slot_of[kb] < slots)
          if (PairQueue<T>& queue = queues_[queue_of(ka, kb)]; queue.count > 0) run(ka, kb, queue, block);
    if (polygons_.count() > 0) run_polygons(block);
  }
  const LoadKernels<T>& load() const { return load_; }

 private:
  static constexpr std::size_t kinds = Shape<T>::count;
  template <std::size_t... I>
  static constexpr std::array<std::size_t, kinds> slots_of(std::index_sequence<I...>) {
    std::array<std::size_t, kinds> slot{};
    std::size_t next = 0;
    static_cast<void>(
        ((slot[I] = lane_core<std::variant_alternative_t<I, ShapeList<T>>>.has_value() ? next++ : kinds), ...));
    return slot;
  }
  /// The kinds that have a core, counted.
  static constexpr std::array<std::size_t, kinds> slot_of = slots_of(std::make_index_sequence<kinds>());
  static constexpr std::size_t slots =
      static_cast<std::size_t>(std::count_if(slot_of.begin(), slot_of.end(), [](std::size_t s) { return s < kinds; }));
  static constexpr std::size_t queue_of(std::size_t a, std::size_t b) { return slot_of[a] * slots + slot_of[b]; }

  /// Whether an entry takes a body of a kind that has a core; only capsules may be refused.
  static bool accepts(const Bodies<T>& bodies, std::size_t i, std::size_t kind) {
    return kind != detail::kind_of<Capsule<T>, T>() || accepted(*static_cast<const Capsule<T>*>(bodies.concrete(i)));
  }

  template <class Rows>
  static void fill_register(Rows& rows, std::size_t count) {
    for (std::size_t k = count; k < std::min(block_pairs, (count + most_lanes - 1) / most_lanes * most_lanes); ++k)
      rows[k] = rows[count - 1];
  }
  static void add_rounding(const T* rounding, std::size_t count, BlockColumns& to) {
    for (std::size_t k = 0; k < count; ++k) to[shape_columns - 1][k] += double(rounding[k]);
  }

  template <class Block>
  void run(std::size_t kind_a, std::size_t kind_b, PairQueue<T>& queue, const Block& block) {
    const std::size_t count = queue.count;
    if (count < block_pairs) {
      fill_register(queue.a, count);
      fill_register(queue.b, count);
      fill_register(queue.pose_a, count);
      fill_register(queue.pose_b, count);
      fill_register(queue.rounding_a, count);
      fill_register(queue.rounding_b, count);
    }
    const PairEntry entry = *KindTable<T>::at(kind_a, kind_b);
    BlockColumns &a = entry.turned ? columns_.b : columns_.a, &b = entry.turned ? columns_.a : columns_.b;
    load_.poses(queue.pose_a, count, a);
    load_.poses(queue.pose_b, count, b);
    load_.shapes[kind_a](queue.a, count, a);
    load_.shapes[kind_b](queue.b, count, b);
    if (queue.rounded) {
      add_rounding(queue.rounding_a, count, a);
      add_rounding(queue.rounding_b, count, b);
    }
    block(PairBlock{count, queue.place, entry, &kernels_[entry.place], &columns_, nullptr});
    queue.count = 0;
    queue.rounded = false;
  }

  template <class Block>
  void run_polygons(const Block& block) {
    const std::size_t count = polygons_.count();
    block(PairBlock{count, polygons_.place(), {}, nullptr, nullptr, &polygons_.load(load_)});
  }

  /// The most lanes of a register on any machine.
  static constexpr std::size_t most_lanes = 16;

  const PairKernels* const kernels_;
  const LoadKernels<T>& load_;
  PolygonQueue<T> polygons_;
  PairQueue<T> queues_[slots * slots];
  PairColumns<block_pairs> columns_{};
};

}  // namespace graze::plane
