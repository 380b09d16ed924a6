#include "narrow/batch/pair_bundle.hpp"
#include "narrow/batch/point_rows.hpp"
#include "narrow/batch/row_bundle.hpp"
#include "narrow/pairs/box_box/clip_box_faces.hpp"

namespace graze::GRAZE_ISA {

namespace {

template <class T>
using Boxes = PairBundle<Box<T>, Box<T>, T>;

/// Moves the waiting pairs, fewer than a block, to the front.
template <class T>
[[gnu::always_inline]] inline void move_up(MetBoxes<T>& met) {
  if (met.first == 0) return;
  for (auto& column : met.number)
    for (std::size_t i = 0; i < block_pairs; i += lanes_of<T>)
      Lanes<T>::load(column + (met.first + i)).store(column + i);
  std::memmove(met.place, met.place + met.first, block_pairs * sizeof met.place[0]);
  met.count -= met.first;
  met.first = 0;
}

/// Sorts the pairs of a bundle, of which `filled` lanes hold one, with places counted from `place` on: pairs within
/// their margins go to `met`, the places of the others to `apart`, whose number is added to `apart_count`.
template <class T, class S, class M>
void sort_out(const BoxesInPlace<S>& boxes, const PoseRows<S>& pose_a, const PoseRows<S>& pose_b, const S& margin,
              const M& regular, std::uint32_t filled, std::uint32_t place, MetBoxes<T>& met, std::uint32_t* apart,
              std::size_t& apart_count) {
  using To = MetBoxes<T>;
  using Numbers = Packed<S, 1>;
  const BoxReferenceAxis<S> choice = box_reference_axis(boxes, margin);
  const std::uint32_t meet = bits_of((!(choice.distance > margin)) | !regular) & filled, others = filled & ~meet;
  std::uint32_t places[chosen_room];
  for (std::uint32_t i = 0; i < chosen_room; ++i) places[i] = place + i;
  store_chosen(apart + apart_count, places, others);
  apart_count += static_cast<std::size_t>(count_bits(others));
  if (meet == 0) return;
  const std::size_t at = met.count;
  store_chosen(met.place + at, places, meet);
  const auto put = [&](std::size_t column, const auto& numbers) __attribute__((always_inline)) {
    constexpr std::size_t parts = std::extent_v<decltype(numbers.part)>;
    for (std::size_t k = 0; k < parts; ++k) store_chosen<T>(numbers.part[k], meet, met.number[column + k] + at);
  };
  const auto by_b = Packed<S, 3>::Mask::of(b_clips(Numbers(choice.axis)).part[0]);
  const BoxRows<S> p = seen_from_clipping(boxes, by_b);
  put(To::half_a, p.half_a);
  put(To::half_b, p.half_b);
  put(To::translation, p.translation);
  for (std::size_t k = 0; k < 3; ++k) put(To::rotation + 3 * k, p.rotation.row[k]);
  const PoseRows<S> clipping = select(by_b, pose_b, pose_a);
  put(To::clipping, clipping.translation);
  put(To::clipping + 3, clipping.vector);
  put(To::clipping + 6, Numbers(clipping.w.part[0]));
  const BoxLimits<S> limits = box_limits(boxes, choice, margin);
  // Nothing is known about irregular boxes, whatever the numbers are.
  const S nearest = select(regular, limits.nearest, S(std::numeric_limits<T>::quiet_NaN()));
  put(To::limits, Packed<S, 4>(limits.axis, limits.noise, limits.margin, nearest));
  put(To::distance, Numbers(choice.distance));
  met.count += static_cast<std::size_t>(count_bits(meet));
}

/// Writes the points of a bundle whose first pair is the `first`-th.
template <class T, class S, class Form>
[[gnu::always_inline]] inline void put_meeting(const BoxMeeting<S>& found, std::size_t first, std::size_t count,
                                               PointBlock<T, Form>& block) {
  using Some = Packed<S, 1>;
  const auto& corners = found.corners;
  S filled(0);
  for (std::size_t i = 0; i < most_contact_slots; ++i)
    filled = filled + corners.as_bits(i, corners.are(i) & (Some(corners.apart[i]) <= Some(found.limit)));
  put_pairs(found.normal, select((filled > S(0)) & found.near, S(1), S(0)), first, count, filled, block);
  PointColumns<T, 3> columns;
  put_together<T, 3>({corners.x, corners.y, corners.apart}, filled, columns);
  append_points<T>(
      columns, box_features.of, box_features.of,
      [&](std::size_t from, LanePoints<T> & points, S & part_a, S & part_b) __attribute__((always_inline)) {
        const auto lanes = columns.lanes_from(from);
        const auto of_lanes = [&](const S& number) __attribute__((always_inline)) {
          return lanes_at<T>(number, lanes);
        };
        points.distance = columns(2, from);
        const auto made =
            found.faces.each(of_lanes).at(Some(columns(0, from)), Some(columns(1, from)), Some(points.distance));
        for (int k = 0; k < 3; ++k) points.a[k] = made.a[k][0], points.b[k] = made.b[k][0];
        part_a = made.part_a[0];
        part_b = made.part_b[0];
      },
      block);
}

/// Writes the points of the next `count` waiting pairs.
template <class T, class Form>
[[gnu::always_inline]] inline void put_points_of(const MetBoxes<T>& met, std::size_t count,
                                                 PointBlock<T, Form>& block) {
  using S = Lanes<T>;
  using Row = Packed<S, 3>;
  using From = MetBoxes<T>;
  clear(block);
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    const auto number = [&](std::size_t column) __attribute__((always_inline)) {
      return S::load(met.number[column] + (met.first + first));
    };
    const auto row = [&](std::size_t column) __attribute__((always_inline)) {
      return Row(number(column), number(column + 1), number(column + 2));
    };
    const BoxRows<S> boxes(row(From::half_a), row(From::half_b), row(From::translation),
                           {row(From::rotation), row(From::rotation + 3), row(From::rotation + 6)});
    const BoxLimits<S> limits{number(From::limits), number(From::limits + 1), number(From::limits + 2),
                              number(From::limits + 3)};
    const PoseRows<S> clipping(row(From::clipping), row(From::clipping + 3), Row(number(From::clipping + 6)));
    const std::size_t left = count - first, lanes = lanes_of<T>;
    with_box_meeting(
        boxes, limits, clipping.translation, [&]() __attribute__((always_inline)) { return clipping.rotation(); },
        [&](const BoxMeeting<S>& found)
            __attribute__((always_inline)) { put_meeting(found, first, left < lanes ? left : lanes, block); });
  }
}

}  // namespace

template <class T>
[[gnu::flatten]] std::size_t box_axes(const PairRef<T>* pairs, std::size_t count, std::uint32_t place, MetBoxes<T>& met,
                                      std::uint32_t* apart) {
  using S = Lanes<T>;
  using Row = Packed<S, 3>;
  move_up(met);
  std::size_t apart_count = 0;
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    const Boxes<T> bundle(pairs + first, count - first);
    const PoseRows<S> pose_a(bundle.pose_a), pose_b(bundle.pose_b);
    const Vec3<S>&half_a = bundle.a.core.half, &half_b = bundle.b.core.half;
    sort_out<T>(BoxesInPlace<S>(Row(half_a), pose_a, Row(half_b), pose_b), pose_a, pose_b, bundle.margin,
                regular_box(half_a) & regular_box(half_b), filled_lanes<T>(count - first),
                place + static_cast<std::uint32_t>(first), met, apart, apart_count);
  }
  return apart_count;
}

template <class T>
[[gnu::flatten]] std::size_t box_row_axes(const PairRows<T>& rows, std::size_t count, T margin, std::uint32_t place,
                                          MetBoxes<T>& met, std::uint32_t* apart) {
  using S = Lanes<T>;
  using Row = Packed<S, 3>;
  move_up(met);
  std::size_t apart_count = 0;
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    const RowBundle<Box<T>, Box<T>, T> bundle(rows, first);
    fetch_rows<Box<T>, Box<T>>(rows, first + rows_ahead);
    const PoseRows<S> pose_a(bundle.pose_a), pose_b(bundle.pose_b);
    sort_out<T>(BoxesInPlace<S>(Row(bundle.a.shapes.core.half), pose_a, Row(bundle.b.shapes.core.half), pose_b), pose_a,
                pose_b, S(margin), bundle.regular(), filled_lanes<T>(count - first),
                place + static_cast<std::uint32_t>(first), met, apart, apart_count);
  }
  return apart_count;
}

template <class T>
[[gnu::flatten]] void box_points(const MetBoxes<T>& met, std::size_t count, PointBlock<T>& block) {
  put_points_of(met, count, block);
}

template <class T>
[[gnu::flatten]] void box_compact_points(const MetBoxes<T>& met, std::size_t count, CompactBlock<T>& block) {
  put_points_of(met, count, block);
}

template <class T>
[[gnu::flatten]] bool box_contact(const PairRef<T>& pair, BoxReferenceAxis<T>& choice, ContactSlots<T>& found) {
  const Box<T>&a = *static_cast<const Box<T>*>(pair.a), &b = *static_cast<const Box<T>*>(pair.b);
  const PoseRows<T> pose_a(*pair.pose_a), pose_b(*pair.pose_b);
  const BoxesInPlace<T> boxes(Packed<T, 3>(a.half_extents()), pose_a, Packed<T, 3>(b.half_extents()), pose_b);
  if (!regular_boxes(boxes.rows.half_a, boxes.rows.half_b)) {
    found.known = T(0);
    return true;
  }
  choice = box_reference_axis(boxes, pair.margin);
  if (choice.distance > pair.margin) return false;
  const auto by_b = b_clips(Packed<T, 3>(choice.axis));
  with_box_meeting(
      seen_from_clipping(boxes, by_b), box_limits(boxes, choice, pair.margin),
      select(by_b, pose_b.translation, pose_a.translation),
      [&] {
        const auto &of_a = boxes.turn_a.row, &of_b = boxes.turn_b.row;
        return Rows<T>{select(by_b, of_b[0], of_a[0]), select(by_b, of_b[1], of_a[1]), select(by_b, of_b[2], of_a[2])};
      },
      [&](const BoxMeeting<T>& meeting) { put_points(meeting, found); });
  return true;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::size_t box_axes(const PairRef<T>*, std::size_t, std::uint32_t, MetBoxes<T>&, std::uint32_t*);          \
  template std::size_t box_row_axes(const PairRows<T>&, std::size_t, T, std::uint32_t, MetBoxes<T>&, std::uint32_t*);  \
  template void box_points(const MetBoxes<T>&, std::size_t, PointBlock<T>&);                                           \
  template void box_compact_points(const MetBoxes<T>&, std::size_t, CompactBlock<T>&);                                 \
  template bool box_contact(const PairRef<T>&, BoxReferenceAxis<T>&, ContactSlots<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
