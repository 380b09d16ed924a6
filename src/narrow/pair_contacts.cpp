// The table of contact routines for two convex shapes.
#include <array>
#include <type_traits>

#include "narrow/alike_order.hpp"
#include "narrow/general_contacts.hpp"
#include "narrow/pair_list.hpp"
#include "narrow/pair_table.hpp"
#include "simd/flatten.hpp"

namespace graze {

namespace {

template <class P, class T>
using InPlaceA = InPlace<typename P::template A<T>, T>;
template <class P, class T>
using InPlaceB = InPlace<typename P::template B<T>, T>;

template <class C, class T>
InPlace<C, T> in_place(const Shape<T>& shape, const Pose<T>& pose) {
  return {*shape.template as<C>(), shape.rounding(), pose};
}

template <class P, class T>
concept HasContacts = requires(const InPlaceA<P, T>& a, const InPlaceB<P, T>& b, T margin, Manifold<T>& manifold) {
  P::contacts(a, b, margin, manifold);
};
template <class P, class T>
concept HasMoreContacts = requires(const InPlaceA<P, T>& a, const InPlaceB<P, T>& b, T margin, Manifold<T>& manifold) {
  P::more_contacts(a, b, margin, manifold);
};

template <class T>
using Routine = T (*)(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T, Manifold<T>&);

template <class T>
T other_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                 Manifold<T>& manifold) {
  return general_contacts<T>(a, pose_a, b, pose_b, margin, manifold);
}

/// The contacts of two shapes in reverse order.
template <class T>
T mirrored_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                    Manifold<T>& manifold) {
  const T distance = convex_contacts<T>(b, pose_b, a, pose_a, margin, manifold);
  mirror(manifold);
  return distance;
}

/// The contacts of two shapes of one kind.
template <class T>
T alike_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                 Manifold<T>& manifold) {
  if (!stands_second(a, pose_a, b, pose_b)) return other_contacts(a, pose_a, b, pose_b, margin, manifold);
  const T distance = other_contacts(b, pose_b, a, pose_a, margin, manifold);
  mirror(manifold);
  return distance;
}

/// The contacts where the pair's own routine has no answer; for pairs with several points it has left the closest. A
/// function of its own: its numbers would push those of the other pairs out of registers, a sixth of their time.
template <class P, class T>
[[gnu::noinline]] GRAZE_FLATTEN T remaining_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                     const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  if constexpr (HasMoreContacts<P, T>)
    if (!manifold.points.empty())
      if (const auto distance = P::more_contacts(in_place<typename P::template A<T>>(a, pose_a),
                                                 in_place<typename P::template B<T>>(b, pose_b), margin, manifold))
        return *distance;
  if constexpr (std::is_same_v<typename P::template A<T>, typename P::template B<T>>)
    return alike_contacts(a, pose_a, b, pose_b, margin, manifold);
  else
    return general_contacts<T>(a, pose_a, b, pose_b, margin, manifold);
}

/// The contacts by the pair's routine. One function, so that numbers stay in registers on their way to the manifold.
template <class P, class T>
GRAZE_FLATTEN T pair_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                              T margin, Manifold<T>& manifold) {
  const auto own = P::contacts(in_place<typename P::template A<T>>(a, pose_a),
                               in_place<typename P::template B<T>>(b, pose_b), margin, manifold);
  return own ? *own : remaining_contacts<P>(a, pose_a, b, pose_b, margin, manifold);
}

/// The routines: the general path, in order or swapped, or the pair's own routine.
template <class T>
class Table {
 public:
  constexpr Table() {
    for (std::size_t a = 0; a < Shape<T>::count; ++a)
      for (std::size_t b = 0; b < Shape<T>::count; ++b)
        at(a, b) = a > b ? &mirrored_contacts<T> : a == b ? &alike_contacts<T> : &other_contacts<T>;
    PairList::each([this]<class P>() {
      if constexpr (HasContacts<P, T>)
        at(detail::kind_of<typename P::template A<T>, T>(), detail::kind_of<typename P::template B<T>, T>()) =
            &pair_contacts<P, T>;
    });
  }
  constexpr Routine<T> operator()(std::size_t a, std::size_t b) const { return routines_[a * Shape<T>::count + b]; }

 private:
  constexpr Routine<T>& at(std::size_t a, std::size_t b) { return routines_[a * Shape<T>::count + b]; }

  std::array<Routine<T>, Shape<T>::count * Shape<T>::count> routines_{};
};
template <class T>
inline constexpr Table<T> table;

}  // namespace

template <class T>
T convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                  Manifold<T>& manifold) {
  return table<T>(a.index(), b.index())(a, pose_a, b, pose_b, margin, manifold);
}

template float convex_contacts(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&, float,
                               Manifold<float>&);
template double convex_contacts(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                                double, Manifold<double>&);

}  // namespace graze
