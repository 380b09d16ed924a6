// From the pairs of a batch to their contacts, in any form of answer.
//
// Guarantee: every pair is passed to the writer once, with the bits of `contacts` for it alone, in an order that is a
// function of the batch alone.
//
// A writer has these functions, for pairs by their indices in the batch:
//
//     begin(pair, overlap)                            a pair without manifolds, unless `add` follows
//     add(pair, normal, piece_a, piece_b, most, append)
//                                                     one more manifold of the pair begun last; `append(points)`
//                                                     appends its points, `most` at most, and returns their number
//     touching(pair, distance, normal, most, points)  both, for convex shapes; `points.append(to)` appends
//     write(place, contacts, meetings, count)         pairs with one point at most, of which the k-th is `place(k)`;
//                                                     returns how many are on their sides or unknown, which count as
//                                                     apart
//     write(met, turned, place)                       pairs that meet (`MetPairs`); `turned`: given from B to A
//     write_rows(first, others, ask)                  pairs in rows from the `first`-th on: `ask(rows)` lets a kernel
//                                                     write their contacts, with at most one point each, and returns
//                                                     the numbers of these
//     offer(block), settle(block, count)              storage of the kernels' blocks, as in `BlockRoom`
//
// Optional is `write_boxes(met, size, single)`, for the next `size` of boxes in rows: it returns whether it wrote them
// itself, or had `single` answer for them.
#pragma once

#include <algorithm>

#include "query/batch_rows.hpp"

namespace graze {

/// Makes an array at least this long. Memory is reserved for twice as many, but records are made only shortly before
/// they are written, so that they are in the cache.
template <class Array>
void make_room(Array& array, std::size_t size) {
  if (array.size() >= size) return;
  if (array.capacity() < size) array.reserve(std::max(size, 2 * array.capacity()));
  array.resize(size);
}

/// The pairs in rows that are not answered in order.
template <class T>
struct OtherRows {
  std::uint8_t unknown[row_chunk], side_places[row_chunk];
  RoomFor<SegmentContact<T>, row_chunk> sides;
};

/// Answers for one pair after the other.
template <class T, class Writer>
class OneByOne {
 public:
  OneByOne(const Batch<T>& batch, T margin, Writer& writer) : batch_(batch), margin_(margin), writer_(writer) {}

  void operator()(std::size_t i) {
    const IdPair p = batch_[i];
    manifolds_.clear();
    const bool overlap = batch_.a().visit(p.a, [&](const Shape<T>& a) {
      return batch_.b().visit(p.b, [&](const Shape<T>& b) {
        return contacts(a, batch_.a().pose(p.a), b, batch_.b().pose(p.b), margin_, manifolds_);
      });
    });
    writer_.begin(i, overlap);
    for (const Manifold<T>& m : manifolds_)
      writer_.add(i, m.normal, m.piece_a, m.piece_b, m.points.size(), [&](auto& points) {
        for (const ContactPoint<T>& point : m.points) points.push_back(point);
        return m.points.size();
      });
  }

 private:
  const Batch<T>& batch_;
  T margin_;
  Writer& writer_;
  Manifolds<T> manifolds_;
};

/// The sink (`narrow/batch/contact_sink.hpp`) that passes a batch's contacts to a writer; `place(i)` is the index in
/// the batch of the kernels' i-th pair.
template <class T, class Writer, class Place>
class BatchSink {
 public:
  using Scalar = T;
  static constexpr std::size_t most = batch_chunk;

  BatchSink(Writer& writer, OneByOne<T, Writer>& single, const Place& place)
      : writer_(writer), single_(single), place_(place) {}

  void apart(std::size_t i) { writer_.begin(place_(i), false); }
  void unknown(std::size_t i) { single_(place_(i)); }
  std::size_t one_each(const PointContact<T>* contacts, const Meeting* meetings, std::size_t count) {
    return writer_.write(place_, contacts, meetings, count);
  }
  template <class Points>
  void several(std::size_t i, T distance, const Vec3<T>& normal, const Points& points, std::size_t most_points) {
    writer_.touching(place_(i), distance, normal, most_points, points);
  }
  void met(const MetPairs<T>& some, bool turned) {
    writer_.write(some, turned, [&](std::size_t k) { return place_(some.place(k)); });
  }
  /// Writes boxes in rows, whose indices are those in the batch.
  bool boxes(const MetBoxes<T>& met, std::size_t size) {
    if constexpr (requires { writer_.write_boxes(met, size, single_); })
      return writer_.write_boxes(met, size, single_);
    else
      return false;
  }
  Writer& room() { return writer_; }

 private:
  Writer& writer_;
  OneByOne<T, Writer>& single_;
  Place place_;
};

/// Contacts of pairs in rows that touch in one point each, or in two for capsules on their sides.
template <class P, class T, class Writer, class Sink>
void visit_contact_rows(const Batch<T>& batch, bool turned, T margin, Writer& writer, Sink& sink) {
  const auto kernel = P::template contact_rows<T>();
  const auto ask = [&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
    OtherRows<T> others;
    const RowCounts found = writer.write_rows(first, others, [&](const ContactRows<T>& to) {
      RowCounts all{};
      kernel(rows, count, margin, turned, to, all);
      return all;
    });
    for (std::size_t k = 0; k < found.sides; ++k)
      visit_segment(others.sides.records[k], P::template features<T>(), turned, first + others.side_places[k], sink);
    for (std::size_t k = 0; k < found.unknown; ++k) sink.unknown(first + others.unknown[k]);
  };
  visit_rows<typename P::template A<T>, typename P::template B<T>>(batch, turned, ask);
}

/// The contacts of a batch whose sides are of one kind each, read and written in place. Returns whether the two kinds
/// have kernels for that.
template <class T, class Writer>
bool contacts_of_rows(const Batch<T>& batch, const LanesFor& lanes, T margin, Writer& writer,
                      OneByOne<T, Writer>& single) {
  const auto in_order = [](std::size_t i) { return i; };
  BatchSink sink(writer, single, in_order);
  bool done = false;
  with_lane_pair(lanes.pair, [&]<class P>() {
    using A = typename P::template A<T>;
    using B = typename P::template B<T>;
    const auto each_rows = [&](const auto& ask) { visit_rows<A, B>(batch, lanes.turned, ask); };
    if constexpr (HasContactRows<P>)
      visit_contact_rows<P>(batch, lanes.turned, margin, writer, sink);
    else if constexpr (requires { P::visit_row_contacts(each_rows, margin, sink); })
      P::visit_row_contacts(each_rows, margin, sink);
    else
      return;
    done = true;
  });
  return done;
}

/// Writes all contacts of a batch.
template <class T, class Writer>
void write_contacts(const Batch<T>& batch, T margin, Writer& writer) {
  OneByOne<T, Writer> single(batch, margin, writer);
  if (contacts_of_rows(batch, lanes_of_batch(batch), margin, writer, single)) return;
  visit_batch(
      batch, margin, with_contact_lanes, with_all_shapes,
      [&](const LanesFor& lanes, const Queue<T>& queue) {
        const auto place = [&](std::size_t k) { return queue.places[k]; };
        BatchSink sink(writer, single, place);
        visit_lane_contacts(lanes, queue.pairs.data(), queue.count, sink);
      },
      single);
}

}  // namespace graze
