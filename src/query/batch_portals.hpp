// Batching of the pairs that GJK would answer one by one, for the kernel that decides the overlap of most of them.
//
// Guarantee: every pair taken has its answer, by the kernel or alone, when `finish` has been called. Nothing is
// allocated.
#pragma once

#include <array>
#include <iterator>

#include "graze/batch.hpp"
#include "narrow/gjk/mpr_pairs.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// The form of each kind for the kernel, and the pairs of kinds that use it: those whose `overlap` is GJK's. Other
/// pairs have faster routines.
template <class T>
class PortalKinds {
 public:
  /// Writes the core of a concrete shape to a side's columns; returns its rounding radius.
  using Put = T (*)(const void* concrete, const PortalPlace& to);
  struct Kind {
    PortalSide side = PortalSide::none;
    Put put = nullptr;
  };
  constexpr PortalKinds() { set(std::make_index_sequence<Shape<T>::count>()); }
  constexpr const Kind& operator[](std::size_t kind) const { return kinds_[kind]; }
  constexpr bool asks(std::size_t a, std::size_t b) const {
    if (kinds_[a].side == PortalSide::none || kinds_[b].side == PortalSide::none) return false;
    return smooth(a) || smooth(b) || (a == triangle && flat(b)) || (b == triangle && flat(a));
  }

 private:
  template <std::size_t... I>
  constexpr void set(std::index_sequence<I...>) {
    ((kinds_[I] = kind_of<std::variant_alternative_t<I, ShapeList<T>>>()), ...);
  }
  template <class C>
  static constexpr Kind kind_of() {
    if constexpr (portal_side<C> == PortalSide::none)
      return {};
    else
      return {portal_side<C>, [](const void* concrete, const PortalPlace& to) {
                const C& shape = *static_cast<const C*>(concrete);
                put_core(shape, to);
                return rounding_radius(shape, T(0));
              }};
  }
  static constexpr std::size_t triangle = detail::kind_of<Triangle<T>, T>();
  static constexpr bool smooth(std::size_t kind) {
    return kind == detail::kind_of<Cylinder<T>, T>() || kind == detail::kind_of<Ellipsoid<T>, T>();
  }
  static constexpr bool flat(std::size_t kind) {
    return kind == detail::kind_of<Box<T>, T>() || kind == detail::kind_of<Rectangle<T>, T>() || kind == triangle;
  }
  Kind kinds_[Shape<T>::count];
};

/// Queues pairs for the kernel. `single(i)` answers for one pair alone.
template <class T, class Single>
class Portals {
 public:
  Portals(const Batch<T>& batch, std::uint8_t* touch, const Single& single)
      : batch_(batch), touch_(touch), single_(single) {}

  void add(std::size_t i) {
    static constexpr PortalKinds<T> kinds;
    const IdPair p = batch_[i];
    const std::size_t kind_a = batch_.a().kind(p.a), kind_b = batch_.b().kind(p.b);
    if (!kinds.asks(kind_a, kind_b)) {
      touch_[i] = single_(i);
      return;
    }
    // Sums come first.
    if (kinds[kind_a].side <= kinds[kind_b].side)
      put(kinds[kind_a], batch_.a(), p.a, kinds[kind_b], batch_.b(), p.b, i);
    else
      put(kinds[kind_b], batch_.b(), p.b, kinds[kind_a], batch_.a(), p.a, i);
  }
  void finish() {
    for (std::size_t number = 0; number < std::size(queues_); ++number) ask(number);
  }

 private:
  struct Queue {
    std::size_t count = 0;
    PortalPairs pairs;
    std::array<std::size_t, portal_chunk> places;
  };

  using Kind = typename PortalKinds<T>::Kind;
  void put(const Kind& kind_a, const Bodies<T>& a, std::size_t i, const Kind& kind_b, const Bodies<T>& b, std::size_t j,
           std::size_t pair) {
    const std::size_t number = (kind_a.side == PortalSide::points) + (kind_b.side == PortalSide::points);
    Queue& queue = queues_[number];
    const auto from = [&](std::size_t column) { return PortalPlace{queue.pairs.column + column, queue.count}; };
    const T reach = kind_a.put(a.concrete(i), from(PortalPairs::of_a)) + a.rounding(i) +
                    (kind_b.put(b.concrete(j), from(PortalPairs::of_b)) + b.rounding(j));
    const Pose<T>&pose_a = a.pose(i), &pose_b = b.pose(j);
    from(PortalPairs::turn_a).put(pose_a.rotation);
    from(PortalPairs::turn_b).put(pose_b.rotation);
    from(PortalPairs::way).put(0, pose_b.translation - pose_a.translation);
    from(PortalPairs::reach).put(0, reach);
    queue.places[queue.count++] = pair;
    if (queue.count == portal_chunk) ask(number);
  }
  void ask(std::size_t number) {
    Queue& queue = queues_[number];
    if (queue.count == 0) return;
    std::uint8_t found[portal_chunk];
    queue.pairs.fill_up(queue.count);
    kernels_[number](queue.pairs, queue.count, found);
    for (std::size_t k = 0; k < queue.count; ++k) {
      const std::size_t pair = queue.places[k];
      touch_[pair] = found[k] > 1 ? single_(pair) : found[k];
    }
    queue.count = 0;
  }

  using Kernel = void (*)(const PortalPairs&, std::size_t, std::uint8_t*);
  const Batch<T>& batch_;
  std::uint8_t* const touch_;
  const Single single_;
  Isa level_ = chosen_isa();
  /// Indexed by the number of sides that are points.
  Kernel kernels_[3] = {GRAZE_KERNEL(level_, mpr_overlaps<PortalSide::sum, PortalSide::sum>),
                        GRAZE_KERNEL(level_, mpr_overlaps<PortalSide::sum, PortalSide::points>),
                        GRAZE_KERNEL(level_, mpr_overlaps<PortalSide::points, PortalSide::points>)};
  Queue queues_[3];
};

}  // namespace graze
