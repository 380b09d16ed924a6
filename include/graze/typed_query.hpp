// Queries on two shapes whose kinds are known at compile time: overlap, distance and contacts of spheres, capsules,
// boxes and triangles, without a `Shape` around them.
//
// Guarantee: to the last bit what `query.hpp` answers for `Shape<T>(a)` and `Shape<T>(b)`, in either order, since the
// same routines answer. Nothing is allocated, dispatched at run time or thrown; safe from any thread. The limits of
// `query.hpp` on poses and margins hold.
//
// Cost: that of the pair's routine. A tapered capsule, a box without thickness and cores that overlap without a closed
// form for the depth are handed on as `Shape`s, at the cost of `query.hpp` and of the check before.
#pragma once

#include <cstddef>

#include "graze/contact.hpp"
#include "graze/detail/visibility.hpp"
#include "graze/fixed_vector.hpp"
#include "graze/pose.hpp"
#include "graze/result.hpp"
#include "graze/shape/box.hpp"
#include "graze/shape/capsule.hpp"
#include "graze/shape/sphere.hpp"
#include "graze/shape/triangle.hpp"

namespace graze {

namespace detail {

/// Largest number of contact points of two kinds: one for a ball, two for a capsule (the ends of its segment), for
/// boxes the corners of one face clipped by another. 0 where the pair has no typed queries.
template <template <class> class A, template <class> class B>
inline constexpr std::size_t most_points = 0;
template <>
inline constexpr std::size_t most_points<Sphere, Sphere> = 1;
template <>
inline constexpr std::size_t most_points<Sphere, Capsule> = 1;
template <>
inline constexpr std::size_t most_points<Sphere, Box> = 1;
template <>
inline constexpr std::size_t most_points<Sphere, Triangle> = 1;
template <>
inline constexpr std::size_t most_points<Capsule, Capsule> = 2;
template <>
inline constexpr std::size_t most_points<Capsule, Box> = 2;
template <>
inline constexpr std::size_t most_points<Capsule, Triangle> = 2;
template <>
inline constexpr std::size_t most_points<Box, Box> = 8;

}  // namespace detail

/// The most points of contact of two kinds, in either order; 0 for kinds without typed queries.
template <template <class> class A, template <class> class B>
inline constexpr std::size_t most_contacts =
    detail::most_points<A, B> > 0 ? detail::most_points<A, B> : detail::most_points<B, A>;

/// Pairs of kinds that have typed queries: spheres, capsules and boxes with each other, and spheres and capsules with
/// triangles, in either order.
template <template <class> class A, template <class> class B>
concept TypedPair = most_contacts<A, B> >
0;

/// `Manifold` with room for `N` points, all of it in place.
template <class T, std::size_t N>
struct FixedManifold {
  Vec3<T> normal{};  ///< unit, from A to B, in the world; without meaning where there are no points
  FixedVector<ContactPoint<T>, N> points;  ///< points of contact
  bool overlap = false;                    ///< distance <= 0, whatever the margin
  Status status = Status::converged;       ///< `bounded` where the distance is not proven
  T error{};                               ///< bound on the error of the points' distances where `bounded`
};

namespace detail {

/// A class rather than a plain return type, since g++ 12 takes `most_contacts<A, B>` in two declarations of one
/// function for two different arguments.
template <template <class> class A, template <class> class B, class T>
struct FixedManifoldOf {
  using type = FixedManifold<T, most_contacts<A, B>>;
};

}  // namespace detail

/// Whether the shapes touch: distance <= 0. Poses are those of the shapes in the world.
template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_API bool overlap(const A<T>& a, const Pose<T>& pose_a, const B<T>& b,
                                                const Pose<T>& pose_b);

/// The signed distance, its normal from A to B and the points that realise it, in the world.
template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_API Distance<T> distance(const A<T>& a, const Pose<T>& pose_a, const B<T>& b,
                                                        const Pose<T>& pose_b);

/// The points of contact that are up to `margin` >= 0 apart, in the world.
template <template <class> class A, template <class> class B, class T>
requires TypedPair<A, B> GRAZE_API typename detail::FixedManifoldOf<A, B, T>::type
contacts(const A<T>& a, const Pose<T>& pose_a, const B<T>& b, const Pose<T>& pose_b, T margin);

}  // namespace graze
