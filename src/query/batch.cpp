#include "graze/batch.hpp"

#include <algorithm>
#include <array>

#include "query/batch_mpr.hpp"
#include "query/batch_parts.hpp"
#include "query/batch_rows.hpp"

namespace graze {

namespace {

/// A query with one answer for each pair, by the kernels of the pairs in `kernels`.
template <class T>
struct Overlaps {
  using Answer = std::uint8_t;
  const Batch<T>& batch;

  static constexpr const LanePairSet& kernels = with_overlap_rows;
  Answer single(std::size_t i) const {
    return batch.visit(i, [](const auto&... pair) { return overlap(pair...); }) ? 1 : 0;
  }
  template <HasOverlapRows P>
  static std::uint32_t many(const PairRows<T>& rows, std::size_t count, bool, Answer* to, std::uint8_t* unknown) {
    return P::template overlap_rows<T>()(rows, count, to, unknown);
  }
};
template <class T>
struct Distances {
  using Answer = Distance<T>;
  const Batch<T>& batch;

  static constexpr const LanePairSet& kernels = with_distance_rows;
  Answer single(std::size_t i) const {
    return batch.visit(i, [](const auto&... pair) { return distance(pair...); });
  }
  template <HasDistanceRows P>
  static std::uint32_t many(const PairRows<T>& rows, std::size_t count, bool turned, Answer* to,
                            std::uint8_t* unknown) {
    return P::template distance_rows<T>()(rows, count, turned, to, unknown);
  }
};

/// Calls `f` with the pair if the query has a kernel for it.
template <class Query, class T, class F>
void with_kernel(LanePair pair, const F& f) {
  with_lane_pair(pair, [&]<class P>() {
    if constexpr (requires { &Query::template many<P>; }) f.template operator()<P>();
  });
}

/// The answers of a batch whose sides are of one kind each, written by kernels in place.
template <class Query, class T>
void answer_rows(const Query& query, const LanesFor& lanes, typename Query::Answer* answers) {
  with_kernel<Query, T>(lanes.pair, [&]<class P>() {
    using A = typename P::template A<T>;
    using B = typename P::template B<T>;
    visit_rows<A, B>(query.batch, lanes.turned, [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
      std::uint8_t unknown[row_chunk];
      const std::uint32_t left = query.template many<P>(rows, count, lanes.turned, answers + first, unknown);
      for (std::uint32_t k = 0; k < left; ++k) answers[first + unknown[k]] = query.single(first + unknown[k]);
    });
  });
}

/// The answers for the pairs of a queue.
template <class Query, class T>
void answer_queue(const Query& query, const LanesFor& lanes, const Queue<T>& queue, typename Query::Answer* answers) {
  with_kernel<Query, T>(lanes.pair, [&]<class P>() {
    const QueueRows<typename P::template A<T>, typename P::template B<T>, T> copies(queue);
    std::array<typename Query::Answer, row_chunk> found;
    std::uint8_t unknown[row_chunk];
    const std::uint32_t left = query.template many<P>(copies.rows(), queue.count, lanes.turned, found.data(), unknown);
    for (std::size_t k = 0; k < queue.count; ++k) answers[queue.places[k]] = found[k];
    for (std::uint32_t k = 0; k < left; ++k) answers[queue.places[unknown[k]]] = query.single(queue.places[unknown[k]]);
  });
}

/// Writes the answers for all pairs of a batch. Kernels list the pairs that they do not answer; `other(i)` answers for
/// a pair of kinds without a kernel.
template <class Query, class T, class Other>
void answer(const Query& query, const Batch<T>& batch, typename Query::Answer* answers, const Other& other) {
  const LanesFor lanes = lanes_of_batch(batch);
  if (Query::kernels(lanes.pair)) return answer_rows<Query, T>(query, lanes, answers);
  visit_batch(
      batch, T(0), Query::kernels, Query::kernels,
      [&](const LanesFor& waiting, const Queue<T>& queue) { answer_queue<Query, T>(query, waiting, queue, answers); },
      other);
}

}  // namespace

template <class T>
void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch, Executor* executor) {
  touch.resize(batch.size());
  for_parts(executor, batch, [&](const Batch<T>& some, std::size_t first) {
    const Overlaps<T> query{some};
    std::uint8_t* const answers = touch.data() + first;
    MprQueues mpr(some, answers, [&](std::size_t i) { return query.single(i); });
    answer(query, some, answers, [&](std::size_t i) { mpr.add(i); });
    mpr.finish();
  });
}

template <class T>
void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances, Executor* executor) {
  distances.resize(batch.size());
  for_parts(executor, batch, [&](const Batch<T>& some, std::size_t first) {
    const Distances<T> query{some};
    Distance<T>* const answers = distances.data() + first;
    answer(query, some, answers, [&](std::size_t i) { answers[i] = query.single(i); });
  });
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void overlap(const Batch<T>&, std::vector<std::uint8_t>&, Executor*);                                       \
  template void distance(const Batch<T>&, std::vector<Distance<T>>&, Executor*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
