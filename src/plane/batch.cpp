#include "graze/plane/batch.hpp"

#include <algorithm>

#include "plane/batch_parts.hpp"
#include "plane/pairs/pair_queues.hpp"
#include "plane/pairs/store_kernels.hpp"

namespace graze::plane {

namespace {

/// Appends the contacts of one pair that is computed by itself. `manifolds`: memory for that.
template <class T>
void append_alone(const Batch<T>& batch, std::size_t i, T margin, Manifolds<T>& manifolds, BatchContacts<T>& found,
                  typename BatchContacts<T>::Pair& pair) {
  manifolds.clear();
  pair.overlap = batch.visit(i, [&](const auto&... shapes) { return contacts(shapes..., margin, manifolds); });
  pair.first_manifold = static_cast<std::uint32_t>(found.manifolds.size());
  pair.manifold_count = static_cast<std::uint32_t>(manifolds.size());
  for (const Manifold<T>& m : manifolds) {
    found.manifolds.push_back({m.normal, m.piece_a, m.piece_b, static_cast<std::uint32_t>(found.points.size()),
                               static_cast<std::uint32_t>(m.points.size())});
    found.points.insert(found.points.end(), m.points.begin(), m.points.end());
  }
}

/// Appends the contacts of a block's pairs, given as rows; `pairs` are those of the batch. A branch on whether a point
/// exists would be mispredicted often, so every point is written, and the next one overwrites one that does not exist.
template <class T>
void append_block(const PairBlock& block, const ContactColumns<block_pairs>& found, const ContactRow<T>* rows,
                  BatchContacts<T>& to, typename BatchContacts<T>::Pair* pairs) {
  std::size_t manifolds = to.manifolds.size(), points = to.points.size();
  // Room for all points; the unused rest is given back.
  to.manifolds.resize(manifolds + block.count + 1);
  to.points.resize(points + 2 * block.count + 1);
  for (std::size_t k = 0; k < block.count; ++k) {
    const auto filled = static_cast<unsigned>(found.known[k] * found.filled[k]);
    const auto first = static_cast<std::uint32_t>(points);
    const std::uint32_t any = filled != 0 ? 1 : 0;
    to.points[points] = rows[k].points[0];
    points += filled & 1;
    to.points[points] = rows[k].points[1];
    points += filled >> 1;
    to.manifolds[manifolds] = {rows[k].normal, 0, 0, first, static_cast<std::uint32_t>(points) - first};
    pairs[block.place[k]] = {found.overlap[k] != 0, static_cast<std::uint32_t>(manifolds), any};
    manifolds += any;
  }
  to.manifolds.resize(manifolds);
  to.points.resize(points);
}

/// The contacts of the pairs of a chunk, appended to `to`.
template <class T>
void append_chunk(const Batch<T>& batch, std::size_t begin, std::size_t end, T margin, BatchContacts<T>& to,
                  typename BatchContacts<T>::Pair* pairs) {
  PairQueues<T> queues;
  const StoreKernels<T>& store = GRAZE_KERNEL(chosen_isa(), plane_store_kernels)().template of<T>();
  ContactColumns<block_pairs> found{};
  ContactRow<T> rows[block_pairs];
  double margins[block_pairs];
  std::fill_n(margins, block_pairs, double(margin));
  Manifolds<T> manifolds;
  const auto alone = [&](std::size_t i) { append_alone(batch, i, margin, manifolds, to, pairs[i]); };
  queues.visit(
      batch, begin, end, polygon_kernels().contacts_pay,
      [&](const PairBlock& block) {
        block.contacts(margins, found);
        store.contacts(found, block.count, block.entry.turned, rows);
        append_block(block, found, rows, to, pairs);
        for (std::size_t k = 0; k < block.count; ++k)
          if (found.known[k] == 0) alone(block.place[k]);
      },
      alone);
}

}  // namespace

template <class T>
void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch, Executor* executor) {
  touch.resize(batch.size());
  const auto alone = [&](std::size_t i) {
    touch[i] = batch.visit(i, [](const auto&... pair) { return overlap(pair...); }) ? 1 : 0;
  };
  for_chunks(executor, batch.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    PairQueues<T> queues;
    OverlapColumns<block_pairs> found;
    queues.visit(
        batch, begin, end, false,
        [&](const PairBlock& block) {
          block.overlaps(found);
          for (std::size_t k = 0; k < block.count; ++k)
            if (found.known[k] != 0)
              touch[block.place[k]] = found.overlap[k] != 0 ? 1 : 0;
            else
              alone(block.place[k]);
        },
        alone);
  });
}

template <class T>
void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances, Executor* executor) {
  distances.resize(batch.size());
  const StoreKernels<T>& store = GRAZE_KERNEL(chosen_isa(), plane_store_kernels)().template of<T>();
  const auto alone = [&](std::size_t i) {
    distances[i] = batch.visit(i, [](const auto&... pair) { return distance(pair...); });
  };
  for_chunks(executor, batch.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    PairQueues<T> queues;
    DistanceColumns<block_pairs> found;
    Distance<T> rows[block_pairs];
    queues.visit(
        batch, begin, end, polygon_kernels().distances_pay,
        [&](const PairBlock& block) {
          block.distances(found);
          store.distances(found, block.count, block.entry.turned, rows);
          for (std::size_t k = 0; k < block.count; ++k)
            if (found.known[k] != 0)
              distances[block.place[k]] = rows[k];
            else
              alone(block.place[k]);
        },
        alone);
  });
}

template <class T>
void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found, Executor* executor) {
  found.pairs.clear(), found.manifolds.clear(), found.points.clear();
  if (!executor) {
    found.pairs.resize(batch.size());
    for_chunks(executor, batch.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
      append_chunk(batch, begin, end, margin, found, found.pairs.data());
    });
    return;
  }
  // Each chunk into arrays of its own, which are then put one behind the other.
  std::vector<BatchContacts<T>> parts((batch.size() + chunk_pairs - 1) / chunk_pairs);
  for_chunks(executor, batch.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    parts[chunk].pairs.resize(end - begin);
    append_chunk(batch.part(begin, end), 0, end - begin, margin, parts[chunk], parts[chunk].pairs.data());
  });
  for (const BatchContacts<T>& part : parts) found.append(part);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void overlap(const Batch<T>&, std::vector<std::uint8_t>&, Executor*);                                       \
  template void distance(const Batch<T>&, std::vector<Distance<T>>&, Executor*);                                       \
  template void contacts(const Batch<T>&, T, BatchContacts<T>&, Executor*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::plane
