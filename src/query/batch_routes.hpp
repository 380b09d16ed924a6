// From the pairs of a batch to kernels: which kernel answers for two kinds of shapes, and pairs put together for it.
//
// Guarantee: every pair comes out once, at a kernel or by itself. Nothing is allocated.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "graze/batch.hpp"
#include "narrow/batch/box_batch.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/pairs/closed_form.hpp"

namespace graze {

/// The kernels for two kinds. Those for round shapes come first.
enum class Route : std::uint8_t {
  sphere_sphere,
  sphere_capsule,
  sphere_box,
  capsule_capsule,
  capsule_box,
  sphere_triangle,
  capsule_triangle,
  box_box,
  sphere_half_space,
  capsule_half_space,
  box_half_space,
  triangle_half_space,
  box_triangle,
  triangle_triangle,
  none
};
inline constexpr std::size_t route_count = static_cast<std::size_t>(Route::none);

/// A route, and whether a pair has to be turned round for it, as one number.
constexpr std::uint8_t queue_of(Route route, bool turned) {
  return static_cast<std::uint8_t>(2 * static_cast<int>(route) + turned);
}

constexpr Route route_of(std::uint8_t queue) { return static_cast<Route>(queue / 2); }
constexpr bool is_turned(std::uint8_t queue) { return queue % 2 != 0; }

/// Calls `f` with the two kinds of a route as its template's arguments.
template <class T, class F>
constexpr void with_kinds(Route route, const F& f) {
  switch (route) {
  case Route::sphere_sphere: return f.template operator()<Sphere<T>, Sphere<T>>();
  case Route::sphere_capsule: return f.template operator()<Sphere<T>, Capsule<T>>();
  case Route::sphere_box: return f.template operator()<Sphere<T>, Box<T>>();
  case Route::capsule_capsule: return f.template operator()<Capsule<T>, Capsule<T>>();
  case Route::capsule_box: return f.template operator()<Capsule<T>, Box<T>>();
  case Route::sphere_triangle: return f.template operator()<Sphere<T>, Triangle<T>>();
  case Route::capsule_triangle: return f.template operator()<Capsule<T>, Triangle<T>>();
  case Route::box_box: return f.template operator()<Box<T>, Box<T>>();
  case Route::sphere_half_space: return f.template operator()<Sphere<T>, HalfSpace<T>>();
  case Route::capsule_half_space: return f.template operator()<Capsule<T>, HalfSpace<T>>();
  case Route::box_half_space: return f.template operator()<Box<T>, HalfSpace<T>>();
  case Route::triangle_half_space: return f.template operator()<Triangle<T>, HalfSpace<T>>();
  case Route::box_triangle: return f.template operator()<Box<T>, Triangle<T>>();
  case Route::triangle_triangle: return f.template operator()<Triangle<T>, Triangle<T>>();
  case Route::none: break;
  }
}

/// The queues for two kinds.
template <class T>
class Routes {
 public:
  constexpr Routes() {
    for (std::uint8_t& queue : queues_) queue = queue_of(Route::none, false);
    for (std::size_t i = 0; i < route_count; ++i) {
      const auto route = static_cast<Route>(i);
      with_kinds<T>(route, [this, route]<class A, class B>() { this->template add<A, B>(route); });
    }
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

/// The same of a route for round shapes.
template <class T, class F>
void with_sphere_capsule_kinds(Route route, const F& f) {
  with_kinds<T>(route, [&]<class A, class B>() {
    if constexpr (is_sphere_capsule_pair<A, B> || (std::is_same_v<A, Capsule<T>> && std::is_same_v<B, Box<T>>) ||
                  is_sphere_capsule_and_triangle<A, B>)
      f.template operator()<A, B>();
  });
}

/// Whether a route is one for what rests on half-spaces.
constexpr bool is_rest(Route route) { return route >= Route::sphere_half_space && route <= Route::triangle_half_space; }

/// Calls `f` with the kind of what rests as its template's argument.
template <class T, class F>
void with_resting_kind(Route route, const F& f) {
  with_kinds<T>(route, [&]<class A, class B>() {
    if constexpr (std::is_same_v<B, HalfSpace<T>>) f.template operator()<A>();
  });
}

/// Pairs that wait for a kernel, with their places in the batch: what is loaded for one kernel is near when the next
/// one wants it.
template <class T>
struct Queue {
  std::array<PairRef<T>, batch_chunk> pairs;
  std::array<std::size_t, batch_chunk> places;
  std::size_t count = 0;
};

/// The kinds whose pairs a world puts together for kernels.
template <class C, class T>
inline constexpr bool has_route =
    std::is_same_v<C, Sphere<T>> || std::is_same_v<C, Capsule<T>> || std::is_same_v<C, Box<T>> ||
    std::is_same_v<C, HalfSpace<T>> || std::is_same_v<C, Triangle<T>>;

/// Whether a concrete shape is what kernels take for its kind: a capsule even and with a length, a box with a length
/// along every side.
template <class T>
bool regular(std::size_t kind, const void* concrete) {
  if (kind == detail::kind_of<Sphere<T>, T>() || kind == detail::kind_of<HalfSpace<T>, T>() ||
      kind == detail::kind_of<Triangle<T>, T>())
    return true;
  if (kind == detail::kind_of<Box<T>, T>()) return regular_box(static_cast<const Box<T>*>(concrete)->half_extents());
  return has_untapered_side(*static_cast<const Capsule<T>*>(concrete));
}

/// Whether so many concrete shapes of one kind, at least one, all are; `at(k)` is the k-th.
template <class T, class At>
bool all_regular(std::size_t kind, std::size_t count, const At& at) {
  bool all = true;
  if (kind == detail::kind_of<Box<T>, T>()) {
    // If the least and the greatest sides are such a box's, all are.
    Vec3<T> low = static_cast<const Box<T>*>(at(0))->half_extents(), high = low;
    for (std::size_t k = 1; k < count; ++k) {
      const Vec3<T>& half = static_cast<const Box<T>*>(at(k))->half_extents();
      low = least(half, low);
      high = greatest(half, high);
    }
    all = regular_box(low) && regular_box(high);
  } else if (kind == detail::kind_of<Capsule<T>, T>()) {
    for (std::size_t k = 0; k < count; ++k) all &= has_untapered_side(*static_cast<const Capsule<T>*>(at(k)));
  }
  return all;
}

/// The concrete shape, if it is of such a kind, regular and without a margin, else null.
template <class T>
const void* regular_concrete(const Shape<T>& shape) {
  if (shape.rounding() != T(0)) return nullptr;
  return shape.visit([&](const auto& concrete) -> const void* {
    using C = std::decay_t<decltype(concrete)>;
    if constexpr (has_route<C, T>)
      return regular<T>(shape.index(), &concrete) ? &concrete : nullptr;
    else
      return nullptr;
  });
}

/// The bodies of a side that are all of one kind: each shape so many bytes behind the one before and each pose so many
/// poses, or all in one place. A pair takes a few instructions so, which with all that `Bodies` can be it does not.
template <class T>
struct EvenRow {
  const char* shapes;
  const Pose<T>* poses;
  std::ptrdiff_t shape_stride = 0, pose_stride = 0;

  explicit EvenRow(const Bodies<T>& bodies)
      : shapes(static_cast<const char*>(bodies.concrete(0))), poses(&bodies.pose(0)) {
    if (bodies.size() < 2) return;
    shape_stride = static_cast<const char*>(bodies.concrete(1)) - shapes;
    pose_stride = &bodies.pose(1) - poses;
  }
  const void* shape(std::uint32_t i) const { return shapes + i * shape_stride; }
  const Pose<T>* pose(std::uint32_t i) const { return poses + i * pose_stride; }
};

/// Has what kernels load of a pair brought near: they are asked when the queue is full, and the first lines come while
/// it is filled.
template <class T>
void fetch(const PairRef<T>& pair) {
  __builtin_prefetch(pair.pose_a);
  __builtin_prefetch(pair.pose_b);
  __builtin_prefetch(pair.a);
  __builtin_prefetch(pair.b);
}

/// Of pairs whose kinds are the same throughout, those from `first` on, at most as many as there is room for, behind
/// those that wait in the queue; how many.
template <class T>
std::size_t append_even(const Batch<T>& batch, const EvenRow<T>& a, const EvenRow<T>& b, std::size_t first, bool turned,
                        T margin, Queue<T>& queue) {
  const std::size_t begin = queue.count, count = std::min(batch_chunk - begin, batch.size() - first);
  for (std::size_t k = 0; k < count; ++k) {
    IdPair p = batch[first + k];
    if (turned) std::swap(p.a, p.b);
    queue.pairs[begin + k] = {a.shape(p.a), b.shape(p.b), a.pose(p.a), b.pose(p.b), margin};
    queue.places[begin + k] = first + k;
    fetch(queue.pairs[begin + k]);
  }
  queue.count += count;
  return count;
}

/// Of the pairs in the queue from the `begin`-th on those that are not regular; they leave it, for `single(i)`.
template <class T, class Single>
void drop_irregular(std::size_t kind_a, std::size_t kind_b, std::size_t begin, Queue<T>& queue, Single&& single) {
  std::size_t kept = begin;
  for (std::size_t k = begin; k < queue.count; ++k) {
    if (!regular<T>(kind_a, queue.pairs[k].a) || !regular<T>(kind_b, queue.pairs[k].b)) {
      single(queue.places[k]);
      continue;
    }
    queue.pairs[kept] = queue.pairs[k];
    queue.places[kept++] = queue.places[k];
  }
  queue.count = kept;
}

/// `visit_batch` where each side is of one kind known to the compiler: nothing about kinds is asked of a pair.
template <class T, class Run, class Single>
void visit_even_batch(const Batch<T>& batch, T margin, std::uint8_t number, Run&& run, Single&& single) {
  const bool turned = is_turned(number);
  const Bodies<T>&first = turned ? batch.b() : batch.a(), &second = turned ? batch.a() : batch.b();
  const std::size_t kind_a = first.kind(0), kind_b = second.kind(0);
  const EvenRow<T> a(first), b(second);
  Queue<T> queue;
  for (std::size_t i = 0; i < batch.size();) {
    const std::size_t begin = queue.count;
    i += append_even(batch, a, b, i, turned, margin, queue);
    const std::size_t added = queue.count - begin;
    if (!all_regular<T>(kind_a, added, [&](std::size_t k) { return queue.pairs[begin + k].a; }) ||
        !all_regular<T>(kind_b, added, [&](std::size_t k) { return queue.pairs[begin + k].b; }))
      drop_irregular(kind_a, kind_b, begin, queue, single);
    if (queue.count < batch_chunk && i < batch.size()) continue;
    if (queue.count > 0) run(route_of(number), turned, queue);
    queue.count = 0;
  }
}

/// Goes through the batch: `run(route, turned, queue)` asks a kernel that `wanted` names, `single(i)` about one pair.
/// The kernel for a route that `told` names is given pairs that are not regular too, and tells which these are.
template <class T, class Wanted, class Told, class Run, class Single>
void visit_batch(const Batch<T>& batch, T margin, const Wanted& wanted, const Told& told, Run&& run, Single&& single) {
  static constexpr Routes<T> routes;
  const Bodies<T>&a = batch.a(), &b = batch.b();
  if (batch.size() > 0 && a.one_kind() && b.one_kind()) {
    const std::uint8_t number = routes(a.kind(0), b.kind(0));
    if (route_of(number) != Route::none && wanted(route_of(number)))
      return visit_even_batch(batch, margin, number, run, single);
    for (std::size_t i = 0; i < batch.size(); ++i) single(i);
    return;
  }
  std::array<Queue<T>, 2 * route_count> queues;
  const auto flush = [&](std::uint8_t number) {
    run(route_of(number), is_turned(number), queues[number]);
    queues[number].count = 0;
  };
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const std::size_t kind_a = a.kind(p.a), kind_b = b.kind(p.b);
    const std::uint8_t number = routes(kind_a, kind_b);
    const Route route = route_of(number);
    if (route == Route::none || !wanted(route) || a.rounding(p.a) != T(0) || b.rounding(p.b) != T(0)) {
      single(i);
      continue;
    }
    const void *shape_a = a.concrete(p.a), *shape_b = b.concrete(p.b);
    if (!told(route) && (!regular<T>(kind_a, shape_a) || !regular<T>(kind_b, shape_b))) {
      single(i);
      continue;
    }
    Queue<T>& queue = queues[number];
    queue.pairs[queue.count] = is_turned(number) ? PairRef<T>{shape_b, shape_a, &b.pose(p.b), &a.pose(p.a), margin}
                                                 : PairRef<T>{shape_a, shape_b, &a.pose(p.a), &b.pose(p.b), margin};
    queue.places[queue.count++] = i;
    if (queue.count == batch_chunk) flush(number);
  }
  for (std::uint8_t number = 0; number < queues.size(); ++number)
    if (queues[number].count > 0) flush(number);
}

}  // namespace graze
