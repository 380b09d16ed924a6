// Batching of the pairs that GJK would answer one by one, for the kernel that decides the overlap of most of them.
//
// Guarantee: every pair taken has its answer, by the kernel or alone, when `finish` has been called. Queues are
// allocated as the first pair comes that needs them, one for each two forms.
#pragma once

#include <array>
#include <iterator>
#include <memory>

#include "graze/batch.hpp"
#include "narrow/gjk/mpr_pairs.hpp"
#include "narrow/pair_list.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// The form of each kind for the kernel, and the pairs of kinds that use it: those whose `overlap` is GJK's, and the
/// special ones that say so. Other special pairs have faster routines.
template <class T>
class MprKinds {
 public:
  struct Kind {
    MprShape side = MprShape::none;
    /// Writes the core of a concrete shape to a side's columns; returns its rounding radius.
    T (*put)(const void* concrete, const MprPlace& to) = nullptr;
    /// The number of a hull's vertices; null for other kinds.
    std::size_t (*vertices)(const void* concrete) = nullptr;
  };
  constexpr MprKinds() {
    set(std::make_index_sequence<Shape<T>::count>());
    PairList::each([this]<class P>() {
      constexpr std::size_t a = detail::kind_of<typename P::template A<T>, T>(),
                            b = detail::kind_of<typename P::template B<T>, T>();
      constexpr bool alone = !requires { P::overlaps_by_mpr; };
      faster_alone_[a][b] = alone;
      faster_alone_[b][a] = alone;
    });
  }
  constexpr const Kind& operator[](std::size_t kind) const { return kinds_[kind]; }
  constexpr bool asks(std::size_t a, std::size_t b) const {
    return kinds_[a].side != MprShape::none && kinds_[b].side != MprShape::none && !faster_alone_[a][b];
  }

 private:
  template <std::size_t... I>
  constexpr void set(std::index_sequence<I...>) {
    ((kinds_[I] = kind_of<std::variant_alternative_t<I, ShapeList<T>>>()), ...);
  }
  template <class C>
  static constexpr Kind kind_of() {
    Kind kind;
    if constexpr (mpr_shape<C> != MprShape::none) {
      kind.side = mpr_shape<C>;
      kind.put = [](const void* concrete, const MprPlace& to) {
        const C& shape = *static_cast<const C*>(concrete);
        put_core(shape, to);
        return rounding_radius(shape, T(0));
      };
    }
    if constexpr (mpr_shape<C> == MprShape::hull)
      kind.vertices = [](const void* concrete) { return static_cast<const C*>(concrete)->data().vertices.size(); };
    return kind;
  }
  Kind kinds_[Shape<T>::count];
  bool faster_alone_[Shape<T>::count][Shape<T>::count]{};
};

/// Queues pairs for the kernel. `single(i)` answers for one pair alone.
template <class T, class Single>
class MprQueues {
 public:
  MprQueues(const Batch<T>& batch, std::uint8_t* touch, const Single& single)
      : batch_(batch), touch_(touch), single_(single) {}

  void add(std::size_t i) {
    static constexpr MprKinds<T> kinds;
    const IdPair p = batch_[i];
    const Bodies<T>&a = batch_.a(), &b = batch_.b();
    const std::size_t kind_a = a.kind(p.a), kind_b = b.kind(p.b);
    if (!kinds.asks(kind_a, kind_b)) {
      touch_[i] = single_(i);
      return;
    }
    const Kind &first = kinds[kind_a], &second = kinds[kind_b];
    if (first.vertices || second.vertices) return add_hulls(i, first, second);
    if (in_mpr_order(first.side, second.side))
      put(first, a, p.a, second, b, p.b, i);
    else
      put(second, b, p.b, first, a, p.a, i);
  }
  void finish() {
    for (std::size_t number = 0; number < forms; ++number)
      if (queues_[number] && queues_[number]->count > 0) ask(number);
  }

 private:
  using Kind = typename MprKinds<T>::Kind;
  struct Queue {
    std::size_t count = 0;
    MprPairs pairs;
    std::array<std::size_t, mpr_chunk> places;
  };
  static constexpr std::size_t forms = 6;  ///< of pairs, by `form_of`
  struct Form {
    MprShape a, b;
    void (*kernel)(const MprPairs&, std::size_t, std::uint8_t*);
  };
  static constexpr std::size_t form_of(MprShape a, MprShape b) {
    const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
    return first * (5 - first) / 2 + second;
  }
  template <MprShape A, MprShape B>
  Form form() const {
    return {A, B, GRAZE_KERNEL(chosen_isa(), mpr_overlaps<A, B>)};
  }

  /// Queues a pair with a hull or two, if they have few vertices. Hulls come last.
  [[gnu::noinline]] void add_hulls(std::size_t i, const Kind& kind_a, const Kind& kind_b) {
    const IdPair p = batch_[i];
    const std::size_t vertices_a = vertices_of(kind_a, batch_.a(), p.a),
                      vertices_b = vertices_of(kind_b, batch_.b(), p.b);
    if (std::max(vertices_a, vertices_b) > most_mpr_points) {
      touch_[i] = single_(i);
      return;
    }
    const bool in_order = kind_a.side <= kind_b.side;
    Queue& queue = queue_of(in_order ? form_of(kind_a.side, kind_b.side) : form_of(kind_b.side, kind_a.side));
    queue.pairs.vertices_a.count[queue.count] = static_cast<std::uint8_t>(in_order ? vertices_a : vertices_b);
    queue.pairs.vertices_b.count[queue.count] = static_cast<std::uint8_t>(in_order ? vertices_b : vertices_a);
    if (in_order)
      put(kind_a, batch_.a(), p.a, kind_b, batch_.b(), p.b, i);
    else
      put(kind_b, batch_.b(), p.b, kind_a, batch_.a(), p.a, i);
  }
  static std::size_t vertices_of(const Kind& kind, const Bodies<T>& bodies, std::size_t i) {
    return kind.vertices ? kind.vertices(bodies.concrete(i)) : 0;
  }
  Queue& queue_of(std::size_t form) {
    if (!queues_[form]) queues_[form].reset(new Queue);
    return *queues_[form];
  }

  void put(const Kind& kind_a, const Bodies<T>& a, std::size_t i, const Kind& kind_b, const Bodies<T>& b, std::size_t j,
           std::size_t pair) {
    const std::size_t number = form_of(kind_a.side, kind_b.side);
    Queue& queue = queue_of(number);
    const auto from = [&](std::size_t column) { return MprPlace{queue.pairs.column + column, queue.count}; };
    const T reach = kind_a.put(a.concrete(i), from(MprPairs::of_a)) + a.rounding(i) +
                    (kind_b.put(b.concrete(j), from(MprPairs::of_b)) + b.rounding(j));
    const Pose<T>&pose_a = a.pose(i), &pose_b = b.pose(j);
    from(MprPairs::turn_a).put(pose_a.rotation);
    from(MprPairs::turn_b).put(pose_b.rotation);
    from(MprPairs::way).put(0, pose_b.translation - pose_a.translation);
    from(MprPairs::reach).put(0, reach);
    queue.places[queue.count++] = pair;
    if (queue.count == mpr_chunk) ask(number);
  }
  void ask(std::size_t number) {
    const Form& form = forms_[number];
    Queue& queue = *queues_[number];
    std::uint8_t found[mpr_chunk];
    queue.pairs.fill_up(queue.count, form.a, form.b);
    form.kernel(queue.pairs, queue.count, found);
    for (std::size_t k = 0; k < queue.count; ++k) {
      const std::size_t pair = queue.places[k];
      touch_[pair] = found[k] > 1 ? single_(pair) : found[k];
    }
    queue.count = 0;
  }

  const Batch<T>& batch_;
  std::uint8_t* const touch_;
  const Single single_;
  const Form forms_[forms] = {form<MprShape::sum, MprShape::sum>(),     form<MprShape::sum, MprShape::points>(),
                              form<MprShape::sum, MprShape::hull>(),    form<MprShape::points, MprShape::points>(),
                              form<MprShape::points, MprShape::hull>(), form<MprShape::hull, MprShape::hull>()};
  std::unique_ptr<Queue> queues_[forms];
};

}  // namespace graze
