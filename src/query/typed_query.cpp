#include "graze/typed_query.hpp"

#include <type_traits>

#include "narrow/general_contacts.hpp"
#include "narrow/pair_list.hpp"
#include "narrow/pair_table.hpp"
#include "simd/flatten.hpp"

namespace graze {

namespace {

/// The special pair of two kinds in order.
template <class A, class B, class T, class First, class... Rest>
constexpr auto find_pair(Pairs<First, Rest...>) {
  if constexpr (std::is_same_v<typename First::template A<T>, A> && std::is_same_v<typename First::template B<T>, B>)
    return std::type_identity<First>();
  else
    return find_pair<A, B, T>(Pairs<Rest...>());
}
template <class A, class B, class T>
using PairOf = typename decltype(find_pair<A, B, T>(PairList()))::type;

template <class A, class B, class T>
constexpr bool in_order() {
  return detail::kind_of<A, T>() <= detail::kind_of<B, T>();
}

template <class C, class T>
InPlace<C, T> in_place(const C& shape, const Pose<T>& pose) {
  return {shape, T(0), pose};
}

/// The answers where the pair's own routine has none. Out of line, so that other pairs do not pay for it.
template <class A, class B, class T>
[[gnu::noinline]] bool overlap_as_shapes(const A& a, const Pose<T>& pose_a, const B& b, const Pose<T>& pose_b) {
  return convex_overlap<T>(a, pose_a, b, pose_b);
}
template <class A, class B, class T>
[[gnu::noinline]] Distance<T> distance_as_shapes(const A& a, const Pose<T>& pose_a, const B& b, const Pose<T>& pose_b) {
  return convex_distance<T>(a, pose_a, b, pose_b);
}
template <class A, class B, class T, std::size_t N>
[[gnu::noinline]] T contacts_as_shapes(const A& a, const Pose<T>& pose_a, const B& b, const Pose<T>& pose_b, T margin,
                                       FixedManifold<T, N>& manifold) {
  Manifold<T> found;
  const T distance = convex_contacts<T>(a, pose_a, b, pose_b, margin, found);
  manifold.normal = found.normal;
  manifold.status = found.status;
  manifold.error = found.error;
  manifold.points.clear();
  for (std::size_t i = 0; i < found.points.size() && i < N; ++i) manifold.points.push_back(found.points[i]);
  return distance;
}

/// The contacts where the pair's own routine found the closest points of two shapes that may touch in more.
template <class P, class A, class B, class T, std::size_t N>
[[gnu::noinline]] GRAZE_FLATTEN T more_contacts(const A& a, const Pose<T>& pose_a, const B& b, const Pose<T>& pose_b,
                                                T margin, FixedManifold<T, N>& manifold) {
  if constexpr (requires { P::more_contacts(in_place(a, pose_a), in_place(b, pose_b), margin, manifold); })
    if (!manifold.points.empty())
      if (const auto distance = P::more_contacts(in_place(a, pose_a), in_place(b, pose_b), margin, manifold))
        return *distance;
  return contacts_as_shapes(a, pose_a, b, pose_b, margin, manifold);
}

/// Fills the contacts of two shapes in order.
template <class A, class B, class T, std::size_t N>
void fill_contacts(const A& a, const Pose<T>& pose_a, const B& b, const Pose<T>& pose_b, T margin,
                   FixedManifold<T, N>& manifold) {
  using P = PairOf<A, B, T>;
  const auto own = P::contacts(in_place(a, pose_a), in_place(b, pose_b), margin, manifold);
  manifold.overlap = (own ? *own : more_contacts<P>(a, pose_a, b, pose_b, margin, manifold)) <= T(0);
}

template <class T, std::size_t N>
void mirror(FixedManifold<T, N>& manifold) {
  put(-manifold.normal, manifold.normal);
  for (ContactPoint<T>& p : manifold.points) {
    const ContactPoint<T> turned = mirrored(p);
    put(turned.a, p.a);
    put(turned.b, p.b);
    p.feature = turned.feature;
    p.weight = turned.weight;
  }
}

}  // namespace

template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_FLATTEN bool overlap(const A<T>& a, const Pose<T>& pose_a, const B<T>& b,
                                                    const Pose<T>& pose_b) {
  if constexpr (!in_order<A<T>, B<T>, T>()) {
    return overlap(b, pose_b, a, pose_a);
  } else {
    using P = PairOf<A<T>, B<T>, T>;
    if constexpr (requires { P::overlap(in_place(a, pose_a), in_place(b, pose_b)); }) {
      if (const auto touch = P::overlap(in_place(a, pose_a), in_place(b, pose_b))) return *touch;
    } else {
      if (const auto found = P::distance(in_place(a, pose_a), in_place(b, pose_b))) return found->distance <= T(0);
    }
    return overlap_as_shapes(a, pose_a, b, pose_b);
  }
}

template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_FLATTEN Distance<T> distance(const A<T>& a, const Pose<T>& pose_a, const B<T>& b,
                                                            const Pose<T>& pose_b) {
  Distance<T> d;
  if constexpr (in_order<A<T>, B<T>, T>()) {
    if (const auto found = PairOf<A<T>, B<T>, T>::distance(in_place(a, pose_a), in_place(b, pose_b)))
      put(*found, d);
    else
      d = distance_as_shapes(a, pose_a, b, pose_b);
  } else {
    if (const auto found = PairOf<B<T>, A<T>, T>::distance(in_place(b, pose_b), in_place(a, pose_a)))
      put(mirrored(*found), d);
    else
      d = distance_as_shapes(a, pose_a, b, pose_b);
  }
  return d;
}

template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_FLATTEN typename detail::FixedManifoldOf<A, B, T>::type
contacts(const A<T>& a, const Pose<T>& pose_a, const B<T>& b, const Pose<T>& pose_b, T margin) {
  // In the outermost block: g++ 12 copies a return value from an inner one.
  typename detail::FixedManifoldOf<A, B, T>::type manifold;
  if constexpr (in_order<A<T>, B<T>, T>()) {
    fill_contacts(a, pose_a, b, pose_b, margin, manifold);
  } else {
    fill_contacts(b, pose_b, a, pose_a, margin, manifold);
    mirror(manifold);
  }
  return manifold;
}

/// The queries of two kinds.
template <template <class> class A, template <class> class B, class T>
struct TypedQueries {
  using Manifold = typename detail::FixedManifoldOf<A, B, T>::type;
  bool (*overlap)(const A<T>&, const Pose<T>&, const B<T>&, const Pose<T>&) = &graze::overlap<A, B, T>;
  Distance<T> (*distance)(const A<T>&, const Pose<T>&, const B<T>&, const Pose<T>&) = &graze::distance<A, B, T>;
  Manifold (*contacts)(const A<T>&, const Pose<T>&, const B<T>&, const Pose<T>&, T) = &graze::contacts<A, B, T>;
};

/// The queries of a pair in both orders of its shapes, if its kinds are known to `typed_query.hpp`.
template <class P, bool typed = TypedPair<P::template A, P::template B>>
struct QueriesOf {};
template <class P>
struct QueriesOf<P, true> {
  TypedQueries<P::template A, P::template B, float> floats;
  TypedQueries<P::template A, P::template B, double> doubles;
  TypedQueries<P::template B, P::template A, float> floats_turned;
  TypedQueries<P::template B, P::template A, double> doubles_turned;
};

template <class List>
struct QueriesOfList;
template <class... P>
struct QueriesOfList<Pairs<P...>> : QueriesOf<P>... {};

/// The queries of all pairs of the list that have them: naming them instantiates them.
extern const QueriesOfList<PairList> typed_queries;
const QueriesOfList<PairList> typed_queries{};

}  // namespace graze
