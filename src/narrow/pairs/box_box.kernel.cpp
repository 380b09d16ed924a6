#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/box_manifold.hpp"

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

}  // namespace

template <class T>
[[gnu::flatten]] void box_axes(const PairRef<T>* pairs, std::size_t count, BoxChoice<T>* axes) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Boxes<T>::lanes) {
    const Boxes<T> bundle(pairs + first, count - first);
    BoxChoice<S> choice = box_choice(box_rows(bundle), bundle.margin);
    // Of others it is left to `box_points` to say that they are not known.
    choice.distance = select(regular(bundle), choice.distance, S(-std::numeric_limits<T>::infinity()));
    for (std::size_t i = 0; i < bundle.count; ++i) {
      const int lane = static_cast<int>(i);
      axes[first + i] = {choice.distance[lane], choice.axis[lane]};
    }
  }
}

template <class T>
[[gnu::flatten]] void box_points(const PairRef<T>* pairs, const BoxChoice<T>* axes, std::size_t count,
                                 BoxPointBlock<T>& points) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Boxes<T>::lanes) {
    const Boxes<T> bundle(pairs + first, count - first);
    BoxChoice<S> choice;
    for (std::size_t i = 0; i < Boxes<T>::lanes; ++i) {
      const BoxChoice<T>& of = axes[first + (i < bundle.count ? i : bundle.count - 1)];
      const int lane = static_cast<int>(i);
      choice.distance.set(lane, of.distance);
      choice.axis.set(lane, of.axis);
    }
    BoxManifold<S> found;
    box_manifold(box_rows(bundle), choice, bundle.margin, PoseRows<S>(bundle.pose_a), PoseRows<S>(bundle.pose_b),
                 found);
    found.known = select(regular(bundle), found.known, S(0));
    put(found, first, bundle.count, points);
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
  box_manifold(boxes, choice, pair.margin, pose_a, pose_b, found);
  return true;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void box_axes(const PairRef<T>*, std::size_t, BoxChoice<T>*);                                               \
  template void box_points(const PairRef<T>*, const BoxChoice<T>*, std::size_t, BoxPointBlock<T>&);                    \
  template bool box_contact(const PairRef<T>&, BoxChoice<T>&, BoxManifold<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
