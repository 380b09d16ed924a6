#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/box_triangle_manifold.hpp"

namespace graze::GRAZE_ISA {

namespace {

template <class T>
using Pairs = PairBundle<Box<T>, Triangle<T>, T>;

template <class T>
[[gnu::always_inline]] inline BoxAndTriangle<Lanes<T>> box_and_triangle(const Pairs<T>& p) {
  return {p.a.core, p.pose_a, p.b.core, p.pose_b};
}

/// The same number in all lanes.
template <class S, class T>
[[gnu::always_inline]] inline Vec3<S> in_lanes(const Vec3<T>& v) {
  return {S(v.x), S(v.y), S(v.z)};
}
template <class S, class T>
[[gnu::always_inline]] inline Pose<S> in_lanes(const Pose<T>& p) {
  const Quat<T>& q = p.rotation;
  return {in_lanes<S>(p.translation), {S(q.x), S(q.y), S(q.z), S(q.w)}};
}
template <class S>
[[gnu::always_inline]] inline Vec3<typename S::Lane> first_of(const Vec3<S>& v) {
  return {v.x[0], v.y[0], v.z[0]};
}

}  // namespace

template <class T>
[[gnu::flatten]] void triangle_axes(const PairRef<T>* pairs, std::size_t count, TriangleChoice<T>* axes) {
  for (std::size_t first = 0; first < count; first += Pairs<T>::lanes) {
    const Pairs<T> bundle(pairs + first, count - first);
    TriangleDirections<Lanes<T>> directions;
    const TriangleChoice<Lanes<T>> choice = triangle_choice(box_and_triangle(bundle), bundle.margin, directions);
    const Vec3<Lanes<T>>& n = choice.normal;
    for (std::size_t i = 0; i < bundle.count; ++i) {
      const int lane = static_cast<int>(i);
      axes[first + i] = {choice.distance[lane], {n.x[lane], n.y[lane], n.z[lane]}};
    }
  }
}

template <class T>
[[gnu::flatten]] void triangle_points(const PairRef<T>* pairs, const TriangleChoice<T>* axes, std::size_t count,
                                      BoxPointBlock<T>& points) {
  using S = Lanes<T>;
  for (std::size_t first = 0; first < count; first += Pairs<T>::lanes) {
    const Pairs<T> bundle(pairs + first, count - first);
    TriangleChoice<S> choice;
    for (std::size_t i = 0; i < Pairs<T>::lanes; ++i) {
      const TriangleChoice<T>& of = axes[first + (i < bundle.count ? i : bundle.count - 1)];
      const int lane = static_cast<int>(i);
      choice.distance.set(lane, of.distance);
      for (std::size_t k = 0; k < 3; ++k) choice.normal[k].set(lane, of.normal[k]);
    }
    const BoxAndTriangle<S> p = box_and_triangle(bundle);
    put(triangle_manifold(p, TriangleDirections<S>(p), choice, bundle.margin, bundle.pose_a), first, bundle.count,
        points);
  }
}

// A pair alone fills a small register: as lanes its choices are masks, where as a scalar they are jumps, half of which are
// guessed wrong.
template <class T>
[[gnu::flatten]] T triangle_contact(const PairRef<T>& pair, BoxManifold<T>& manifold) {
  using S = Wide<T, 16 / static_cast<int>(sizeof(T))>;
  const Pose<S> pose_a = in_lanes<S>(*pair.pose_a), pose_b = in_lanes<S>(*pair.pose_b);
  const auto& box = *static_cast<const BoxCore<T>*>(pair.a);
  const auto& corner = static_cast<const TriangleCore<T>*>(pair.b)->point;
  const BoxAndTriangle<S> p({in_lanes<S>(box.half)}, pose_a,
                            {{in_lanes<S>(corner[0]), in_lanes<S>(corner[1]), in_lanes<S>(corner[2])}}, pose_b);
  TriangleDirections<S> directions;
  const TriangleChoice<S> choice = triangle_choice(p, S(pair.margin), directions);
  const T distance = choice.distance[0];
  if (distance > pair.margin) {
    manifold.normal = first_of(p.turn * choice.normal);
    return distance;
  }
  const BoxManifold<S> found = triangle_manifold(p, directions, choice, S(pair.margin), pose_a);
  manifold.normal = first_of(found.normal);
  manifold.filled = found.filled[0];
  manifold.known = found.known[0];
  const auto filled = static_cast<unsigned>(manifold.filled);
  for (unsigned i = 0; i < most_box_points; ++i) {
    const auto& slot = found.slots[i];
    if ((filled >> i & 1) != 0)
      manifold.slots[i] = {first_of(slot.a), first_of(slot.b), slot.distance[0], slot.part_a[0], slot.part_b[0]};
  }
  return distance;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void triangle_axes(const PairRef<T>*, std::size_t, TriangleChoice<T>*);                                     \
  template T triangle_contact(const PairRef<T>&, BoxManifold<T>&);                                                     \
  template void triangle_points(const PairRef<T>*, const TriangleChoice<T>*, std::size_t, BoxPointBlock<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
