#include "narrow/closed_form.hpp"
#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/capsule_capsule.hpp"
#include "narrow/pairs/sphere_box.hpp"
#include "narrow/pairs/sphere_capsule.hpp"
#include "narrow/pairs/sphere_sphere.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Writes the lanes that hold a pair.
template <class T>
[[gnu::always_inline]] inline void put(const Distance<Lanes<T>>& d, std::size_t count, Distance<T>* to) {
  for (std::size_t i = 0; i < count; ++i) {
    const int lane = static_cast<int>(i);
    const auto of = [&](const Vec3<Lanes<T>>& v) { return Vec3<T>{v.x[lane], v.y[lane], v.z[lane]}; };
    to[i] = {d.distance[lane], of(d.normal), of(d.a), of(d.b)};
  }
}

template <class T>
BallCores<Lanes<T>> balls_of(const PairBundle<Sphere<T>, Sphere<T>, T>& p) {
  return {p.a.core.point, p.pose_a, p.b.core.point, p.pose_b};
}

template <class A, class B, class T>
Distance<Lanes<T>> distance_of(const PairBundle<A, B, T>& p) {
  if constexpr (std::is_same_v<A, Sphere<T>> && std::is_same_v<B, Sphere<T>>) {
    const BallCores<Lanes<T>> balls = balls_of(p);
    return balls.distance(core_distance(balls.a, balls.b), p.a.radius, p.b.radius);
  } else {
    return finished(core_distance(p.a.core, moved(p.b.core, relative(p.pose_a, p.pose_b))), p.a.radius, p.b.radius,
                    p.pose_a);
  }
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] void closed_distances(const PairRef<T>* pairs, std::size_t count, Distance<T>* distances) {
  using S = Lanes<T>;
  using Pairs = PairBundle<A, B, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const Distance<S> d = distance_of(p);
    put(d, p.count, distances + first);
  }
}

template <class T>
[[gnu::flatten]] void sphere_overlaps(const PairRef<T>* pairs, std::size_t count, std::uint8_t* touch) {
  using Pairs = PairBundle<Sphere<T>, Sphere<T>, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const BallCores<Lanes<T>> balls = balls_of(p);
    const auto touching = spheres_overlap(balls.a.point, p.a.radius, balls.b.point, p.b.radius);
    for (std::size_t i = 0; i < p.count; ++i) touch[first + i] = touching[static_cast<int>(i)];
  }
}

template void sphere_overlaps(const PairRef<float>*, std::size_t, std::uint8_t*);
template void sphere_overlaps(const PairRef<double>*, std::size_t, std::uint8_t*);
#define GRAZE_INSTANTIATE(A, B)                                                                                        \
  template void closed_distances<A<float>, B<float>>(const PairRef<float>*, std::size_t, Distance<float>*);            \
  template void closed_distances<A<double>, B<double>>(const PairRef<double>*, std::size_t, Distance<double>*);
GRAZE_INSTANTIATE(Sphere, Sphere)
GRAZE_INSTANTIATE(Sphere, Capsule)
GRAZE_INSTANTIATE(Box, Sphere)
GRAZE_INSTANTIATE(Capsule, Capsule)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
