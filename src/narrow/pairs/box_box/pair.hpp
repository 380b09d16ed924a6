// Box against box.
#pragma once

#include "narrow/batch/contact_sink.hpp"
#include "narrow/pairs/box_box/any_boxes_overlap.hpp"
#include "narrow/pairs/box_box/box_like_pair.hpp"
#include "simd/flatten.hpp"

namespace graze {

struct BoxBox : BoxLikePair<Box, Box> {
  template <class T>
  static std::optional<bool> overlap(const InPlace<Box<T>, T>& a, const InPlace<Box<T>, T>& b) {
    return overlap(a, b, false);
  }
  /// A first test, by the axes of the faces alone.
  template <class T>
  static bool may_overlap(const InPlace<Box<T>, T>& a, const InPlace<Box<T>, T>& b) {
    return *overlap(a, b, true);
  }
  /// The points of two boxes, equal to those of the kernels for many pairs; nothing where one is rounded or irregular,
  /// or where the nearest points are nearer than those of the faces by `face_preference`. They agree with the
  /// separating axes of polyhedra, but are computed in T and also where the gap between the faces hardly exceeds the
  /// distance.
  template <class T, class M>
  static std::optional<T> contacts(const InPlace<Box<T>, T>& a, const InPlace<Box<T>, T>& b, T margin, M& manifold) {
    if (a.rounding() != T(0) || b.rounding() != T(0)) return std::nullopt;
    BoxReferenceAxis<T> choice;
    ContactSlots<T> found;
    if (!GRAZE_KERNEL(chosen_isa(), box_contact<T>)({&a.shape, &b.shape, &a.pose, &b.pose, margin}, choice, found))
      return choice.distance;
    if (found.known == T(0)) return std::nullopt;
    take_points<T>(
        static_cast<unsigned>(found.filled), [&](std::size_t i) { return found.slot(i); }, box_features.of,
        box_features.of, manifold.points);
    manifold.normal = found.normal;
    return choice.distance;
  }

  static constexpr bool takes_all_shapes = true;
  template <class T>
  static auto overlap_rows() {
    return GRAZE_KERNEL(chosen_isa(), row_overlaps<Box<T>, Box<T>, T>);
  }
  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), box_row_distances<Box<T>, Box<T>, T>);
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool, Sink& sink) {
    visit_box_contacts(
        pairs, count, [&](std::size_t i) { sink.apart(i); }, [&](const MetPairs<T>& met) { sink.met(met, false); },
        [&](std::size_t i) { sink.unknown(i); }, room_of(sink));
  }
  /// Answers pairs in rows, which `each_rows(ask)` passes to `ask(rows, first, count)`; the sink identifies them by
  /// their indices among all. Its `boxes(met, size)` may write the next `size` of them itself and returns whether it
  /// did.
  template <class T, class EachRows, class Sink>
  static void visit_row_contacts(const EachRows& each_rows, T margin, Sink& sink) {
    const auto apart = [&](std::size_t i) { sink.apart(i); };
    const auto met = [&](const MetPairs<T>& some) { sink.met(some, false); };
    const auto unknown = [&](std::size_t i) { sink.unknown(i); };
    const auto write = [&](const MetBoxes<T>& some, std::size_t size) { return sink.boxes(some, size); };
    MetBoxes<T> boxes;
    each_rows([&](const PairRows<T>& rows, std::size_t first, std::size_t count) {
      visit_box_axes(rows, count, margin, static_cast<std::uint32_t>(first), boxes, apart);
      visit_met_boxes(boxes, false, room_of(sink), met, unknown, write);
    });
    visit_met_boxes(boxes, true, room_of(sink), met, unknown, write);
  }

 private:
  template <class T>
  static std::optional<bool> overlap(const InPlace<Box<T>, T>& a, const InPlace<Box<T>, T>& b, bool faces_only) {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), boxes_touch<T>);
    if (a.rounding() == T(0) && b.rounding() == T(0))
      if (const auto touch = kernel(a.shape, a.pose, b.shape, b.pose, faces_only)) return touch;
    return detail::any_boxes_overlap(a, b, faces_only);
  }
};

}  // namespace graze
