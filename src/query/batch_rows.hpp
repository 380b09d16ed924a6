// Pairs in rows for kernels: those of a batch whose sides are of one kind each, in chunks, and those of a queue.
//
// Guarantee: there are always as many rows to read as lanes take. The bodies' own are read where pairs are in order,
// except for the last few; copies are in the cache when they are read. Nothing is allocated.
#pragma once

#include <algorithm>
#include <cstring>

#include "query/batch_routes.hpp"

namespace graze {

/// Largest number of pairs in rows at a time.
inline constexpr std::size_t row_chunk = batch_chunk;

/// Rows of C, shapes of one kind or poses, of one side: the bodies' own, or copies of them.
template <class C>
class SideRows {
 public:
  /// Makes the copies for all pairs here if the side has a single body.
  SideRows(const void* own, bool single, std::size_t pairs) : own_(static_cast<const C*>(own)), single_(single) {
    if (single_)
      for (std::size_t k = 0; k < bundled(std::min(pairs, row_chunk)); ++k) copy(0, k);
  }
  /// The rows of some pairs from the `first`-th on; `places` holds their indices, null for the bodies' own rows.
  const C* operator()(std::size_t first, std::size_t count, const std::uint32_t* places) {
    if (single_) return reinterpret_cast<const C*>(copies_);
    if (!places) return own_ + first;
    for (std::size_t k = 0; k < count; ++k) copy(places[k], k);
    for (std::size_t k = count; k < bundled(count); ++k) copy(places[count - 1], k);
    return reinterpret_cast<const C*>(copies_);
  }

 private:
  void copy(std::size_t from, std::size_t to) { std::memcpy(copies_ + to * sizeof(C), own_ + from, sizeof(C)); }

  const C* own_;
  bool single_;
  alignas(C) std::byte copies_[row_chunk * sizeof(C)];
};

/// The rows of a side whose shapes are all of the kind C.
template <class C, class T>
class RowsOf {
 public:
  RowsOf(const Bodies<T>& bodies, std::size_t pairs)
      : row_(bodies),
        shapes_(row_.shapes, row_.shape_stride == 0, pairs),
        poses_(row_.poses, row_.pose_stride == 0, pairs) {}
  const C* shapes(std::size_t first, std::size_t count, const std::uint32_t* places) {
    return shapes_(first, count, places);
  }
  const Pose<T>* poses(std::size_t first, std::size_t count, const std::uint32_t* places) {
    return poses_(first, count, places);
  }

 private:
  EvenRow<T> row_;
  SideRows<C> shapes_;
  SideRows<Pose<T>> poses_;
};

/// Calls `ask(rows, first, count)` for all pairs of a batch whose shapes are of the kinds A and B; `turned`: the
/// batch's A is of kind B, and its B of kind A.
template <class A, class B, class T, class Ask>
void visit_rows(const Batch<T>& batch, bool turned, const Ask& ask) {
  RowsOf<A, T> a(turned ? batch.b() : batch.a(), batch.size());
  RowsOf<B, T> b(turned ? batch.a() : batch.b(), batch.size());
  std::uint32_t places_a[row_chunk], places_b[row_chunk];
  for (std::size_t first = 0, count; first < batch.size(); first += count) {
    count = std::min(row_chunk, batch.size() - first);
    // With the bodies' own rows, only the remainder beyond full registers is copied.
    if (batch.in_order() && count >= bundled(1)) count -= count % bundled(1);
    const bool own = batch.in_order() && count == bundled(count);
    for (std::size_t k = 0; !own && k < count; ++k) {
      const IdPair pair = batch[first + k];
      places_a[k] = turned ? pair.b : pair.a;
      places_b[k] = turned ? pair.a : pair.b;
    }
    const std::uint32_t *const at_a = own ? nullptr : places_a, *const at_b = own ? nullptr : places_b;
    ask(PairRows<T>{a.shapes(first, count, at_a), b.shapes(first, count, at_b), a.poses(first, count, at_a),
                    b.poses(first, count, at_b)},
        first, count);
  }
}

/// The shapes and poses of a queue, copied.
template <class A, class B, class T>
class QueueRows {
 public:
  explicit QueueRows(const Queue<T>& queue) {
    copy<sizeof(A)>(queue, &PairRef<T>::a, a_);
    copy<sizeof(B)>(queue, &PairRef<T>::b, b_);
    copy<sizeof(Pose<T>)>(queue, &PairRef<T>::pose_a, poses_a_);
    copy<sizeof(Pose<T>)>(queue, &PairRef<T>::pose_b, poses_b_);
  }
  PairRows<T> rows() const {
    return {a_, b_, reinterpret_cast<const Pose<T>*>(poses_a_), reinterpret_cast<const Pose<T>*>(poses_b_)};
  }

 private:
  /// Copies the objects of one pointer member of all pairs; remaining rows repeat the last.
  template <std::size_t size, class Member>
  static void copy(const Queue<T>& queue, Member member, std::byte* to) {
    const std::size_t count = queue.count, all = bundled(count);
    for (std::size_t k = 0; k < count; ++k) std::memcpy(to + k * size, queue.pairs[k].*member, size);
    for (std::size_t k = count; k < all; ++k) std::memcpy(to + k * size, queue.pairs[count - 1].*member, size);
  }

  alignas(A) std::byte a_[row_chunk * sizeof(A)];
  alignas(B) std::byte b_[row_chunk * sizeof(B)];
  alignas(Pose<T>) std::byte poses_a_[row_chunk * sizeof(Pose<T>)], poses_b_[row_chunk * sizeof(Pose<T>)];
};

/// The lanes for a batch whose sides are of one kind each; none for other batches.
template <class T>
LanesFor lanes_of_batch(const Batch<T>& batch) {
  if (batch.size() == 0 || !batch.a().one_kind() || !batch.b().one_kind()) return {};
  return lane_table<T>(batch.a().kind(0), batch.b().kind(0));
}

}  // namespace graze
