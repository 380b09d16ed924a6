#include "rays/box_rays.hpp"

#include "rays/box_crossing.hpp"
#include "rays/local_ray.hpp"
#include "rays/ray_rows.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
using V = Vec3<S>;
using rays::BoxCrossing;

/// The crossing of rays with a box.
template <class N>
[[gnu::always_inline]] inline BoxCrossing<N> crossing_of(const rays::TurnedBox& box, const Vec3<N>& origin,
                                                         const Vec3<N>& direction) {
  const Mat3<N> turn = converted<N>(box.turn.matrix);
  return {transposed_times(turn, origin - converted<N>(box.translation)), transposed_times(turn, direction),
          converted<N>(box.half)};
}
template <class N>
[[gnu::always_inline]] inline Vec3<N> normal_of(const rays::TurnedBox& box, const BoxCrossing<N>& crossing) {
  return converted<N>(box.turn.matrix) * crossing.normal() * N(box.per_scale);
}

/// A direction whose square neither over- nor underflows: those of float are unchanged, those of double scaled. Zeros
/// and infinities become NaN.
template <class T, class N>
[[gnu::always_inline]] inline Vec3<N> squarable(const Vec3<N>& direction) {
  if constexpr (sizeof(T) == 4) return direction;
  return direction / max_abs(direction);
}

template <class T>
[[gnu::always_inline]] inline void store(const S& numbers, T* to) {
  typedef T Few __attribute__((vector_size(S::lanes * sizeof(T))));
  const Few few = __builtin_convertvector(numbers.v, Few);
  std::memcpy(to, &few, sizeof few);
}
template <class T>
[[gnu::always_inline]] inline void store(const V& v, T (&to)[3][rays::RayBlock::size], std::size_t i) {
  store(v.x, to[0] + i);
  store(v.y, to[1] + i);
  store(v.z, to[2] + i);
}

}  // namespace

template <class T>
[[gnu::flatten]] bool ray_at_box(const Vec3<T>& half, const Pose<T>& pose, const Ray<T>& ray, T length,
                                 RayHit<T>& hit) {
  const Vec3d origin = converted<double>(ray.origin), direction = squarable<T>(converted<double>(ray.direction));
  const double end = rays::end_of(ray, direction, length);
  if (end < 0) return false;
  const rays::TurnedBox box(half, pose);
  const BoxCrossing<double> crossing = crossing_of(box, origin, direction);
  const double size = graze::length(direction), t = crossing.enter() * size;
  if (!(crossing.met() & (crossing.leave() >= 0) & (t <= end))) return false;
  if (crossing.enter() <= 0) {
    hit = {T(0), ray.origin, converted<T>(-direction * (1 / size)), 0};
    return true;
  }
  const Vec3d normal = rays::opposing(normal_of(box, crossing), direction);
  hit = {least(static_cast<T>(t), length), converted<T>(origin + direction * crossing.enter()), converted<T>(normal),
         0};
  return true;
}

template <class T>
void rays_at_box(rays::RayBlock& block, const T* rays, std::size_t count, T length, const rays::TurnedBox& box,
                 rays::BlockHits<T>& hits) {
  const double end = rays::end_of(length);
  read_rays(rays, count, block);
  for (std::size_t i = 0; i < filled(count); i += static_cast<std::size_t>(S::lanes)) {
    const V origin = load_vec3<S>(block.origin, i), direction = squarable<T>(load_vec3<S>(block.along, i));
    const BoxCrossing<S> crossing = crossing_of(box, origin, direction);
    const S size = graze::length(direction), t = crossing.enter() * size, zero(0);
    const auto inside = crossing.enter() <= zero;
    const auto followed = (S(end) >= zero) & rays::usable<T>(origin, dot(direction, direction));
    const auto hit = followed & crossing.met() & (crossing.leave() >= zero) & (t <= S(end));
    V normal = normal_of(box, crossing);
    const auto turned = hit & (!inside) & (dot(normal, direction) > zero);
    if (any(hit & inside)) normal = select(inside, -direction * (S(1) / size), normal);
    store(least(select(inside, zero, t), S(static_cast<double>(length))), hits.t + i);
    store(select(inside, origin, origin + direction * crossing.enter()), hits.point, i);
    store(normal, hits.normal, i);
    select(turned, S(rays::ray_again), select(hit, S(rays::ray_hit), S(rays::ray_missed))).store(block.state + i);
  }
}

template bool ray_at_box(const Vec3<float>&, const Pose<float>&, const Ray<float>&, float, RayHit<float>&);
template bool ray_at_box(const Vec3<double>&, const Pose<double>&, const Ray<double>&, double, RayHit<double>&);
template void rays_at_box(rays::RayBlock&, const float*, std::size_t, float, const rays::TurnedBox&,
                          rays::BlockHits<float>&);
template void rays_at_box(rays::RayBlock&, const double*, std::size_t, double, const rays::TurnedBox&,
                          rays::BlockHits<double>&);

}  // namespace graze::GRAZE_ISA
