// Contacts of many pairs that touch in one point, or in two for capsules on their sides, by a kernel for them.
//
// Guarantee: for each pair the answer of `convex_contacts`, bit for bit.
#pragma once

#include "narrow/batch/contact_sink.hpp"
#include "narrow/pairs/segment_contact.hpp"

namespace graze {

template <class T>
PointContact<T> mirrored(const PointContact<T>& c) {
  return {mirrored(c.point), -c.normal};
}

/// Passes on the contact of a capsule on its side.
template <class T, class Sink>
void visit_segment(const SegmentContact<T>& found, const std::uint32_t* features, bool turned, std::size_t i,
                   Sink& sink) {
  if (found.filled == T(0)) return sink.unknown(i);
  const SegmentPoints<T> points{found, features, turned};
  sink.several(i, found.distance, points.normal(), points, 2);
}

/// A kernel that finds the contacts of pairs with one point at most; capsules on their sides go to a list of their own.
template <class T>
using OneContactKernel = void (*)(const PairRef<T>*, std::size_t, PointContact<T>*, Meeting*, SegmentContact<T>*);

/// Finds the contacts of up to `Sink::most` pairs by the kernel and passes them to the sink, in order. `turned`: A is
/// the caller's second shape. `features`: the features of both shapes, by `feature_place`.
template <class T, class Sink>
void visit_one_contacts(OneContactKernel<T> kernel, const std::uint32_t* features, const PairRef<T>* pairs,
                        std::size_t count, bool turned, Sink& sink) {
  RoomFor<PointContact<T>, bundled(Sink::most)> contacts;
  Meeting meetings[bundled(Sink::most)];
  RoomFor<SegmentContact<T>, Sink::most> segments;
  kernel(pairs, count, contacts.records, meetings, segments.records);
  const SegmentContact<T>* segment = segments.records;
  const auto visit_other = [&](std::size_t i) {
    if (meetings[i] == Meeting::unknown)
      sink.unknown(i);
    else
      visit_segment(*segment++, features, turned, i, sink);
  };
  if constexpr (requires { sink.one_each(contacts.records, meetings, count); }) {
    for (std::size_t k = 0; turned && k < count; ++k) contacts.records[k] = mirrored(contacts.records[k]);
    std::size_t others = sink.one_each(contacts.records, meetings, count);
    for (std::size_t i = 0; others > 0; ++i) {
      if (!is_elsewhere(meetings[i])) continue;
      --others;
      visit_other(i);
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      if (meetings[i] == Meeting::touching)
        sink.one(i, turned ? mirrored(contacts.records[i]) : contacts.records[i]);
      else if (meetings[i] == Meeting::apart)
        sink.apart(i);
      else
        visit_other(i);
    }
  }
}

}  // namespace graze
