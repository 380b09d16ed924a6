#include "narrow/batch/pair_bundle.hpp"
#include "narrow/batch/point_rows.hpp"
#include "narrow/pairs/box_triangle/clip_over_box.hpp"

namespace graze::GRAZE_ISA {

namespace {

template <class T>
using Pairs = PairBundle<Box<T>, Triangle<T>, T>;

template <class T>
[[gnu::always_inline]] inline BoxAndTriangle<Lanes<T>> box_and_triangle(const Pairs<T>& p) {
  return {p.a.core, p.pose_a, p.b.core, p.pose_b};
}

}  // namespace

template <class T>
[[gnu::flatten]] void triangle_axes(const PairRef<T>* pairs, std::size_t count, TriangleReferenceAxis<T>* axes) {
  for (std::size_t first = 0; first < count; first += Pairs<T>::lanes) {
    const Pairs<T> bundle(pairs + first, count - first);
    TriangleDirections<Lanes<T>> directions;
    const TriangleReferenceAxis<Lanes<T>> choice =
        triangle_reference_axis(box_and_triangle(bundle), bundle.margin, directions);
    const Vec3<Lanes<T>>& n = choice.normal;
    for (std::size_t i = 0; i < bundle.count; ++i) {
      const int lane = static_cast<int>(i);
      axes[first + i] = {choice.distance[lane], {n.x[lane], n.y[lane], n.z[lane]}};
    }
  }
}

template <class T>
[[gnu::flatten]] void triangle_points(const PairRef<T>* pairs, const TriangleReferenceAxis<T>* axes, std::size_t count,
                                      PointBlock<T>& block) {
  using S = Lanes<T>;
  clear(block);
  for (std::size_t first = 0; first < count; first += Pairs<T>::lanes) {
    const Pairs<T> bundle(pairs + first, count - first);
    TriangleReferenceAxis<S> choice;
    for (std::size_t i = 0; i < Pairs<T>::lanes; ++i) {
      const TriangleReferenceAxis<T>& of = axes[first + (i < bundle.count ? i : bundle.count - 1)];
      const int lane = static_cast<int>(i);
      choice.distance.set(lane, of.distance);
      for (std::size_t k = 0; k < 3; ++k) choice.normal[k].set(lane, of.normal[k]);
    }
    const BoxAndTriangle<S> p = box_and_triangle(bundle);
    ContactSlots<S> found;
    triangle_manifold(p, TriangleDirections<S>(p), choice, bundle.margin, bundle.pose_a, found);
    put_pairs(found.normal, found.known, first, bundle.count, found.filled, block);
    PointColumns<T, 9> columns;
    put_together<T, 9>({found.a[0], found.a[1], found.a[2], found.b[0], found.b[1], found.b[2], found.distance,
                        found.part_a, found.part_b},
                       found.filled, columns);
    append_points<T>(
        columns, box_features.of, triangle_features,
        [&](std::size_t from, LanePoints<T> & points, S & part_a, S & part_b) __attribute__((always_inline)) {
          for (std::size_t k = 0; k < 3; ++k) points.a[k] = columns(k, from), points.b[k] = columns(3 + k, from);
          points.distance = columns(6, from);
          part_a = columns(7, from);
          part_b = columns(8, from);
        },
        block);
  }
}

template <class T>
[[gnu::flatten]] T triangle_contact(const PairRef<T>& pair, ContactSlots<T>& manifold) {
  const BoxAndTriangle<T> p(*static_cast<const BoxCore<T>*>(pair.a), *pair.pose_a,
                            *static_cast<const TriangleCore<T>*>(pair.b), *pair.pose_b);
  TriangleDirections<T> directions;
  const TriangleReferenceAxis<T> choice = triangle_reference_axis(p, pair.margin, directions);
  if (choice.distance > pair.margin)
    manifold.normal = p.turn * choice.normal;
  else
    triangle_manifold(p, directions, choice, pair.margin, *pair.pose_a, manifold);
  return choice.distance;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void triangle_axes(const PairRef<T>*, std::size_t, TriangleReferenceAxis<T>*);                              \
  template T triangle_contact(const PairRef<T>&, ContactSlots<T>&);                                                    \
  template void triangle_points(const PairRef<T>*, const TriangleReferenceAxis<T>*, std::size_t, PointBlock<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
