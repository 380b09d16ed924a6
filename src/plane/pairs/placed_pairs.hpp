// Contacts of many pairs of the same two kinds of shapes, given by where their shapes and poses stand.
//
// Guarantee: each pair has the answer of `contacts`, bit for bit.
#pragma once

#include <algorithm>
#include <optional>

#include "plane/pairs/load_kernels.hpp"
#include "plane/pairs/store_kernels.hpp"

namespace graze::plane {

/// A pair as the entry of its kinds takes it: turned where the entry is.
template <class T>
struct PlacedPair {
  const void *a, *b;  ///< the concrete shapes
  const Pose2<T>*pose_a, *pose_b;
  T margin;
};

/// Two kinds of shapes by their places in `ShapeList`, in the order of the entry that answers for them, if any does.
struct PairKinds {
  std::size_t a = 0, b = 0;
  std::optional<PairEntry> entry{};
};

template <class T>
PairKinds pair_kinds(std::size_t a, std::size_t b) {
  const std::optional<PairEntry> entry = KindTable<T>::at(a, b);
  return entry && entry->turned ? PairKinds{b, a, entry} : PairKinds{a, b, entry};
}

/// The concrete shape as kernels take it, or null where none does, as for a shape with a rounding: its pairs are
/// answered one by one.
template <class T>
const void* concrete_for_lanes(const Shape<T>& shape) {
  if (shape.rounding() != T(0)) return nullptr;
  return shape.visit([](const auto& c) -> const void* {
    using C = std::decay_t<decltype(c)>;
    if constexpr (lane_core<C>.has_value())
      return accepted(c) ? &c : nullptr;
    else
      return nullptr;
  });
}

/// Calls a sink for each pair: `unknown(i)` where no kernel answers, `apart(i)`, or `row(i, overlap, row, filled)` with
/// a `ContactRow` and a bit for each of its points that is there.
template <class T, class Sink>
void visit_contacts(const PairKinds& kinds, const PlacedPair<T>* pairs, std::size_t count, Sink& sink) {
  const LoadKernels<T>& load = GRAZE_KERNEL(chosen_isa(), plane_load_kernels)().template of<T>();
  const PairKernels& kernels = GRAZE_KERNEL(chosen_isa(), plane_pair_kernels)()[kinds.entry->place];
  const StoreKernels<T>& store = GRAZE_KERNEL(chosen_isa(), plane_store_kernels)().template of<T>();
  PairColumns<block_pairs> columns{};
  ContactColumns<block_pairs> found{};
  ContactRow<T> rows[block_pairs];
  const void *a[block_pairs], *b[block_pairs];
  const Pose2<T>*pose_a[block_pairs], *pose_b[block_pairs];
  double margins[block_pairs];
  for (std::size_t first = 0; first < count; first += block_pairs) {
    const std::size_t size = std::min(block_pairs, count - first);
    // Up to the end of a register the last pair is repeated: whole blocks are cheap to fill.
    for (std::size_t k = 0; k < block_pairs; ++k) {
      const PlacedPair<T>& pair = pairs[first + std::min(k, size - 1)];
      a[k] = pair.a;
      b[k] = pair.b;
      pose_a[k] = pair.pose_a;
      pose_b[k] = pair.pose_b;
      margins[k] = double(pair.margin);
    }
    load.poses(pose_a, size, columns.a);
    load.poses(pose_b, size, columns.b);
    load.shapes[kinds.a](a, size, columns.a);
    load.shapes[kinds.b](b, size, columns.b);
    kernels.contacts(columns, size, margins, found);
    store.contacts(found, size, kinds.entry->turned, rows);
    for (std::size_t k = 0; k < size; ++k) {
      const auto filled = static_cast<unsigned>(found.filled[k]);
      const bool overlap = found.overlap[k] != 0;
      if (found.known[k] == 0)
        sink.unknown(first + k);
      else if (filled == 0 && !overlap)
        sink.apart(first + k);
      else
        sink.row(first + k, overlap, rows[k], filled);
    }
  }
}

}  // namespace graze::plane
