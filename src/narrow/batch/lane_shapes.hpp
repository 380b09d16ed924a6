// The shapes of a kind that lanes take: an untapered capsule with a side, a box or rectangle whose lengths along every
// side have products that neither overflow nor vanish, any shape of other kinds.
//
// Guarantee: one overload a kind, and nothing else, says so.
#pragma once

#include <concepts>
#include <utility>

#include "graze/shape.hpp"
#include "narrow/core/core.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"

namespace graze {

/// Whether lanes take a shape. Of type `std::true_type` for kinds that they take whole.
template <class C>
std::true_type taken_by_lanes(const C&) {
  return {};
}
template <class T>
bool taken_by_lanes(const Box<T>& box) {
  return regular_box(box.half_extents());
}
template <class T>
bool taken_by_lanes(const Rectangle<T>& rectangle) {
  const Vec3<T>& half = rectangle.as_box().half_extents();
  return regular_rectangle(half.x, half.z);
}
template <class T>
bool taken_by_lanes(const Capsule<T>& capsule) {
  return has_untapered_side(capsule);
}

/// Whether lanes take all of `count` >= 1 shapes of one kind; `at(k)` is the k-th.
template <class C, class At>
bool all_taken_by_lanes(const C*, std::size_t count, const At& at) {
  bool all = true;
  for (std::size_t k = 0; k < count; ++k) all &= taken_by_lanes(*static_cast<const C*>(at(k)));
  return all;
}
/// If the smallest and the largest sides are in range, all are.
template <class T, class At>
bool all_taken_by_lanes(const Box<T>*, std::size_t count, const At& at) {
  Vec3<T> low = static_cast<const Box<T>*>(at(0))->half_extents(), high = low;
  for (std::size_t k = 1; k < count; ++k) {
    const Vec3<T>& half = static_cast<const Box<T>*>(at(k))->half_extents();
    low = least(half, low);
    high = greatest(half, high);
  }
  return regular_box(low) && regular_box(high);
}

namespace detail {

/// `f.operator()<C>()` for the kind with that index, if lanes refuse some of its shapes; else true.
template <class T, class F, std::size_t... I>
bool of_refused_kind(std::size_t kind, const F& f, std::index_sequence<I...>) {
  bool taken = true;
  const auto ask = [&]<class C>(std::size_t place) {
    if constexpr (std::same_as<decltype(taken_by_lanes(std::declval<const C&>())), bool>)
      return place == kind && (taken = f.template operator()<C>(), true);
    else
      return false;
  };
  (void)(ask.template operator()<std::variant_alternative_t<I, ShapeList<T>>>(I) || ...);
  return taken;
}

}  // namespace detail

/// Whether lanes take a concrete shape whose kind is given by its index.
template <class T>
bool taken_by_lanes(std::size_t kind, const void* concrete) {
  return detail::of_refused_kind<T>(
      kind, [&]<class C>() -> bool { return taken_by_lanes(*static_cast<const C*>(concrete)); },
      std::make_index_sequence<Shape<T>::count>());
}

/// Whether lanes take all of `count` >= 1 concrete shapes of the kind with that index.
template <class T, class At>
bool all_taken_by_lanes(std::size_t kind, std::size_t count, const At& at) {
  return detail::of_refused_kind<T>(
      kind, [&]<class C>() { return all_taken_by_lanes(static_cast<const C*>(nullptr), count, at); },
      std::make_index_sequence<Shape<T>::count>());
}

}  // namespace graze
