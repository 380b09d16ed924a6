// From the pairs of a batch to kernels: which kernel answers for two kinds of shapes, and pairs put together for it.
//
// Guarantee: every pair comes out once, at a kernel or by itself. Nothing is allocated.
#pragma once

#include <array>

#include "graze/batch.hpp"
#include "narrow/box_batch.hpp"
#include "narrow/pair_kernels.hpp"

namespace graze {

/// The kernels for two kinds. Those for round shapes come first.
enum class Route : std::uint8_t {
  sphere_sphere,
  sphere_capsule,
  sphere_box,
  capsule_capsule,
  capsule_box,
  box_box,
  sphere_half_space,
  capsule_half_space,
  box_half_space,
  box_triangle,
  none
};
inline constexpr std::size_t route_count = static_cast<std::size_t>(Route::none), round_route_count = 5;

/// A route, and whether a pair has to be turned round for it, as one number.
constexpr std::uint8_t queue_of(Route route, bool turned) {
  return static_cast<std::uint8_t>(2 * static_cast<int>(route) + turned);
}

constexpr Route route_of(std::uint8_t queue) { return static_cast<Route>(queue / 2); }
constexpr bool is_turned(std::uint8_t queue) { return queue % 2 != 0; }

/// The queues for two kinds.
template <class T>
class Routes {
 public:
  constexpr Routes() {
    for (std::uint8_t& queue : queues_) queue = queue_of(Route::none, false);
    add<Sphere<T>, Sphere<T>>(Route::sphere_sphere);
    add<Sphere<T>, Capsule<T>>(Route::sphere_capsule);
    add<Sphere<T>, Box<T>>(Route::sphere_box);
    add<Capsule<T>, Capsule<T>>(Route::capsule_capsule);
    add<Capsule<T>, Box<T>>(Route::capsule_box);
    add<Box<T>, Box<T>>(Route::box_box);
    add<Sphere<T>, HalfSpace<T>>(Route::sphere_half_space);
    add<Capsule<T>, HalfSpace<T>>(Route::capsule_half_space);
    add<Box<T>, HalfSpace<T>>(Route::box_half_space);
    add<Box<T>, Triangle<T>>(Route::box_triangle);
  }
  constexpr std::uint8_t operator()(std::size_t kind_a, std::size_t kind_b) const {
    return queues_[kind_a * Shape<T>::count + kind_b];
  }

 private:
  template <class A, class B>
  constexpr void add(Route route) {
    constexpr std::size_t a = detail::kind_of<A, T>(), b = detail::kind_of<B, T>();
    queues_[b * Shape<T>::count + a] = queue_of(route, true);
    queues_[a * Shape<T>::count + b] = queue_of(route, false);
  }
  std::uint8_t queues_[Shape<T>::count * Shape<T>::count]{};
};

/// Calls `f` with the two kinds of a route for round shapes as its template's arguments.
template <class T, class F>
void with_round_kinds(Route route, const F& f) {
  switch (route) {
  case Route::sphere_sphere: return f.template operator()<Sphere<T>, Sphere<T>>();
  case Route::sphere_capsule: return f.template operator()<Sphere<T>, Capsule<T>>();
  case Route::sphere_box: return f.template operator()<Sphere<T>, Box<T>>();
  case Route::capsule_capsule: return f.template operator()<Capsule<T>, Capsule<T>>();
  case Route::capsule_box: return f.template operator()<Capsule<T>, Box<T>>();
  case Route::box_box:
  case Route::sphere_half_space:
  case Route::capsule_half_space:
  case Route::box_half_space:
  case Route::box_triangle:
  case Route::none: break;
  }
}

/// Whether a route is one for what rests on half-spaces.
constexpr bool is_rest(Route route) { return route >= Route::sphere_half_space && route <= Route::box_half_space; }

/// Calls `f` with the kind of what rests as its template's argument.
template <class T, class F>
void with_resting_kind(Route route, const F& f) {
  if (route == Route::sphere_half_space) return f.template operator()<Sphere<T>>();
  if (route == Route::capsule_half_space) return f.template operator()<Capsule<T>>();
  if (route == Route::box_half_space) return f.template operator()<Box<T>>();
}

/// Pairs that wait for a kernel, with their places in the batch: what is loaded for one kernel is near when the next
/// one wants it.
template <class T>
struct Queue {
  std::array<PairRef<T>, box_chunk> pairs;
  std::array<std::size_t, box_chunk> places;
  std::size_t count = 0;
};

/// The kinds whose pairs a world puts together for kernels.
template <class C, class T>
inline constexpr bool has_route = std::is_same_v<C, Sphere<T>> || std::is_same_v<C, Capsule<T>> ||
                                  std::is_same_v<C, Box<T>> || std::is_same_v<C, HalfSpace<T>>;

/// Whether a concrete shape is what kernels take for its kind: a capsule even and with a length, a box with a length
/// along every side.
template <class T>
bool regular(std::size_t kind, const void* concrete) {
  if (kind == detail::kind_of<Sphere<T>, T>() || kind == detail::kind_of<HalfSpace<T>, T>() ||
      kind == detail::kind_of<Triangle<T>, T>())
    return true;
  if (kind == detail::kind_of<Box<T>, T>()) return regular_box(static_cast<const Box<T>*>(concrete)->half_extents());
  const auto& capsule = *static_cast<const Capsule<T>*>(concrete);
  return !capsule.tapered() && capsule.half_height() > T(0);
}

/// The concrete shape, if it is of such a kind, regular and without a margin, else null.
template <class T>
const void* regular_concrete(const Shape<T>& shape) {
  if (shape.margin() != T(0)) return nullptr;
  return shape.visit([&](const auto& concrete) -> const void* {
    using C = std::decay_t<decltype(concrete)>;
    if constexpr (has_route<C, T>)
      return regular<T>(shape.index(), &concrete) ? &concrete : nullptr;
    else
      return nullptr;
  });
}

/// Goes through the batch: `run(route, turned, queue)` asks a kernel that `wanted` names, `single(i)` about one pair.
template <class T, class Wanted, class Run, class Single>
void visit_batch(const Batch<T>& batch, T margin, const Wanted& wanted, Run&& run, Single&& single) {
  static constexpr Routes<T> routes;
  const Bodies<T>&a = batch.a(), &b = batch.b();
  std::array<Queue<T>, 2 * route_count> queues;
  const auto flush = [&](std::uint8_t number) {
    run(route_of(number), is_turned(number), queues[number]);
    queues[number].count = 0;
  };
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const std::size_t kind_a = a.kind(p.a), kind_b = b.kind(p.b);
    const std::uint8_t number = routes(kind_a, kind_b);
    if (route_of(number) == Route::none || !wanted(route_of(number)) || a.margin(p.a) != T(0) ||
        b.margin(p.b) != T(0)) {
      single(i);
      continue;
    }
    const void *shape_a = a.concrete(p.a), *shape_b = b.concrete(p.b);
    if (!regular<T>(kind_a, shape_a) || !regular<T>(kind_b, shape_b)) {
      single(i);
      continue;
    }
    Queue<T>& queue = queues[number];
    queue.pairs[queue.count] = is_turned(number) ? PairRef<T>{shape_b, shape_a, &b.pose(p.b), &a.pose(p.a), margin}
                                                 : PairRef<T>{shape_a, shape_b, &a.pose(p.a), &b.pose(p.b), margin};
    queue.places[queue.count++] = i;
    if (queue.count == box_chunk) flush(number);
  }
  for (std::uint8_t number = 0; number < queues.size(); ++number)
    if (queues[number].count > 0) flush(number);
}

}  // namespace graze
