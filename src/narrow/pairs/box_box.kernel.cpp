#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/box_manifold.hpp"
#include "narrow/point_rows.hpp"
#include "narrow/row_bundle.hpp"

namespace graze::GRAZE_ISA {

namespace {

template <class T>
using Boxes = PairBundle<Box<T>, Box<T>, T>;

template <class T>
[[gnu::always_inline]] inline auto regular(const Boxes<T>& bundle) {
  return regular_box(bundle.a.core.half) & regular_box(bundle.b.core.half);
}

template <class T>
[[gnu::always_inline]] inline BoxRows<Lanes<T>> box_rows(const Boxes<T>& bundle) {
  using S = Lanes<T>;
  return {Several<S, 3>(bundle.a.core.half), PoseRows<S>(bundle.pose_a), Several<S, 3>(bundle.b.core.half),
          PoseRows<S>(bundle.pose_b)};
}

/// Writes the axes of a bundle.
template <class T, class S, class M>
[[gnu::always_inline]] inline void put_choice(const BoxChoice<S>& choice, const M& regular, std::size_t count,
                                              BoxChoice<T>* axes) {
  // Of others it is left to `box_points` to say that they are not known.
  const S distance = select(regular, choice.distance, S(-std::numeric_limits<T>::infinity()));
  for (std::size_t i = 0; i < count; ++i) axes[i] = {distance[static_cast<int>(i)], choice.axis[static_cast<int>(i)]};
}

/// Writes the points of a bundle whose first pair is the `first`-th.
template <class T, class S, class M>
[[gnu::always_inline]] inline void put_meeting(const BoxMeeting<S>& found, const M& regular, std::size_t first,
                                               std::size_t count, PointBlock<T>& block) {
  using Some = Several<S, 1>;
  const auto& corners = found.corners;
  S filled(0);
  for (std::size_t i = 0; i < most_box_points; ++i)
    filled = filled + corners.as_bits(i, corners.are(i) & (Some(corners.apart[i]) <= Some(found.limit)));
  put_pairs(found.normal, select(regular & (filled > S(0)) & found.near, S(1), S(0)), first, count, filled, block);
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

}  // namespace

template <class T>
[[gnu::flatten]] void box_axes(const PairRef<T>* pairs, std::size_t count, BoxChoice<T>* axes) {
  for (std::size_t first = 0; first < count; first += Boxes<T>::lanes) {
    const Boxes<T> bundle(pairs + first, count - first);
    put_choice(box_choice(box_rows(bundle), bundle.margin), regular(bundle), bundle.count, axes + first);
  }
}

template <class T>
[[gnu::flatten]] void box_row_axes(const PairRows<T>& rows, std::size_t count, T margin, BoxChoice<T>* axes) {
  using S = Lanes<T>;
  constexpr std::size_t lanes = lanes_of<T>;
  for (std::size_t first = 0; first < count; first += lanes) {
    const RowBundle<Box<T>, Box<T>, T> bundle(rows, first);
    const BoxRows<S> boxes(Several<S, 3>(bundle.a.shapes.core.half), PoseRows<S>(bundle.pose_a),
                           Several<S, 3>(bundle.b.shapes.core.half), PoseRows<S>(bundle.pose_b));
    const std::size_t left = count - first;
    put_choice(box_choice(boxes, S(margin)), bundle.regular(), left < lanes ? left : lanes, axes + first);
  }
}

template <class T>
[[gnu::flatten]] void box_points(const PairRef<T>* pairs, const BoxChoice<T>* axes, std::size_t count,
                                 PointBlock<T>& block) {
  using S = Lanes<T>;
  block.point_count = 0;
  block.any_twice = false;
  for (std::size_t first = 0; first < count; first += Boxes<T>::lanes) {
    const Boxes<T> bundle(pairs + first, count - first);
    BoxChoice<S> choice;
    for (std::size_t i = 0; i < Boxes<T>::lanes; ++i) {
      const BoxChoice<T>& of = axes[first + (i < bundle.count ? i : bundle.count - 1)];
      const int lane = static_cast<int>(i);
      choice.distance.set(lane, of.distance);
      choice.axis.set(lane, of.axis);
    }
    const auto use = [&](const BoxMeeting<S>& found) __attribute__((always_inline)) {
      put_meeting(found, regular(bundle), first, bundle.count, block);
    };
    with_box_meeting(box_rows(bundle), choice, bundle.margin, PoseRows<S>(bundle.pose_a), PoseRows<S>(bundle.pose_b),
                     use);
  }
}

template <class T>
[[gnu::flatten]] bool box_contact(const PairRef<T>& pair, BoxChoice<T>& choice, BoxManifold<T>& found) {
  const Box<T>&a = *static_cast<const Box<T>*>(pair.a), &b = *static_cast<const Box<T>*>(pair.b);
  const PoseRows<T> pose_a(*pair.pose_a), pose_b(*pair.pose_b);
  const BoxRows<T> boxes(Several<T, 3>(a.half_extents()), pose_a, Several<T, 3>(b.half_extents()), pose_b);
  if (!regular_boxes(boxes)) {
    found.known = T(0);
    return true;
  }
  choice = box_choice(boxes, pair.margin);
  if (choice.distance > pair.margin) return false;
  with_box_meeting(boxes, choice, pair.margin, pose_a, pose_b,
                   [&](const BoxMeeting<T>& meeting) { put_points(meeting, found); });
  return true;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void box_axes(const PairRef<T>*, std::size_t, BoxChoice<T>*);                                               \
  template void box_row_axes(const PairRows<T>&, std::size_t, T, BoxChoice<T>*);                                       \
  template void box_points(const PairRef<T>*, const BoxChoice<T>*, std::size_t, PointBlock<T>&);                       \
  template bool box_contact(const PairRef<T>&, BoxChoice<T>&, BoxManifold<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
