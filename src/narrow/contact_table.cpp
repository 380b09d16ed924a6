// The table of contacts: which routine finds those of two convex shapes.
#include <array>

#include "narrow/convex_pair.hpp"
#include "narrow/core/relative_frame.hpp"
#include "narrow/general_contacts.hpp"
#include "simd/flatten.hpp"

// The pairs with a form of their own. A pair without one takes the general path.
#include "narrow/pairs/box_box/contacts.hpp"
#include "narrow/pairs/box_triangle/contacts.hpp"
#include "narrow/pairs/capsule_box_contact.hpp"
#include "narrow/pairs/half_space_contacts.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"
#include "narrow/pairs/sphere_capsule_triangle_contact.hpp"
#include "narrow/pairs/triangle_triangle/pair.hpp"

namespace graze {

namespace {

template <class A, class B, class T>
concept HasOwnContacts = requires(const A& a, const B& b, T margin, const Pose<T>& pose, Manifold<T>& manifold) {
  own_contacts(a, margin, pose, b, margin, pose, margin, manifold);
};

template <class T>
using Routine = T (*)(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T, Manifold<T>&);

template <class A, class B, class T>
concept MayLie = requires(const A& a, const B& b, T margin, const Pose<T>& pose, Manifold<T>& manifold) {
  segment_contacts(a, margin, pose, b, margin, pose, margin, manifold);
};

/// Where `own_contacts` has no answer; of two that lie it has left the closest points. Its own function: its numbers
/// would push those of the other pairs out of registers, a sixth of their time.
template <class A, class B, class T>
[[gnu::noinline]] GRAZE_FLATTEN T remaining_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                     const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  if constexpr (MayLie<A, B, T>)
    if (!manifold.points.empty())
      if (const auto distance = segment_contacts(*a.template as<A>(), a.rounding(), pose_a, *b.template as<B>(),
                                                 b.rounding(), pose_b, margin, manifold))
        return *distance;
  return general_contacts<T>(a, pose_a, b, pose_b, margin, manifold);
}

/// Of the concrete shapes A and B, which stand in order. One function, so that numbers stay in registers on their way
/// to the manifold.
template <class A, class B, class T>
GRAZE_FLATTEN T pair_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                              T margin, Manifold<T>& manifold) {
  const A& ca = *a.template as<A>();
  const B& cb = *b.template as<B>();
  const auto own = own_contacts(ca, a.rounding(), pose_a, cb, b.rounding(), pose_b, margin, manifold);
  return own ? *own : remaining_contacts<A, B>(a, pose_a, b, pose_b, margin, manifold);
}

template <class T>
T other_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                 Manifold<T>& manifold) {
  return general_contacts<T>(a, pose_a, b, pose_b, margin, manifold);
}

/// Of two shapes that stand against the order.
template <class T>
T mirrored_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                    Manifold<T>& manifold) {
  const T distance = convex_contacts<T>(b, pose_b, a, pose_a, margin, manifold);
  mirror(manifold);
  return distance;
}

/// Whether a pair of one kind is answered the other way round. What the general path chooses where two choices are as
/// good (the face that others are laid over, the edge that counts, the vertex that a search begins at) follows the
/// order of the shapes. The larger shape tells theirs or, of two as large, where each sees the other: a swap swaps both
/// to the last bit, and a motion of the two keeps them.
template <class T>
bool stands_second(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  const auto extent = [](const Shape<T>& shape) {
    return shape.visit([](const auto& c) {
      if constexpr (requires { c.core_extent(); }) return c.core_extent();
      return T(0);
    });
  };
  const T size_a = extent(a) + a.rounding(), size_b = extent(b) + b.rounding();
  if (size_a != size_b) return size_a < size_b;
  const Posed frame_a = in_double(pose_a), frame_b = in_double(pose_b);
  const Vec3d at_b = inverse_transform(frame_a, frame_b.translation),
              at_a = inverse_transform(frame_b, frame_a.translation);
  for (std::size_t i = 0; i < 3; ++i)
    if (at_b[i] != at_a[i]) return at_b[i] < at_a[i];
  const Quatd b_of_a = relative(frame_a, frame_b).rotation, a_of_b = relative(frame_b, frame_a).rotation;
  const Vec3d turn_b = b_of_a.vector() * b_of_a.w, turn_a = a_of_b.vector() * a_of_b.w;
  for (std::size_t i = 0; i < 3; ++i)
    if (turn_b[i] != turn_a[i]) return turn_b[i] < turn_a[i];
  return false;
}

/// Of two shapes of one kind.
template <class T>
T alike_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                 Manifold<T>& manifold) {
  if (!stands_second(a, pose_a, b, pose_b)) return other_contacts(a, pose_a, b, pose_b, margin, manifold);
  const T distance = other_contacts(b, pose_b, a, pose_a, margin, manifold);
  mirror(manifold);
  return distance;
}

template <class T, std::size_t A, std::size_t B>
constexpr Routine<T> routine_of() {
  using CA = std::variant_alternative_t<A, ShapeList<T>>;
  using CB = std::variant_alternative_t<B, ShapeList<T>>;
  if constexpr (A > B)
    return &mirrored_contacts<T>;
  else if constexpr (std::is_same_v<CA, Triangle<T>> && std::is_same_v<CB, Triangle<T>>)
    return &triangle_pair_contacts<T>;
  else if constexpr (HasOwnContacts<CA, CB, T>)
    return &pair_contacts<CA, CB, T>;
  else if constexpr (A == B)
    return &alike_contacts<T>;
  else
    return &other_contacts<T>;
}

template <class T, std::size_t... I>
constexpr auto make_table(std::index_sequence<I...>) {
  constexpr std::size_t n = Shape<T>::count;
  return std::array<Routine<T>, n * n>{routine_of<T, I / n, I % n>()...};
}
template <class T>
constexpr auto table = make_table<T>(std::make_index_sequence<Shape<T>::count * Shape<T>::count>());

}  // namespace

template <class T>
T convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                  Manifold<T>& manifold) {
  return table<T>[a.index() * Shape<T>::count + b.index()](a, pose_a, b, pose_b, margin, manifold);
}

template float convex_contacts(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&, float,
                               Manifold<float>&);
template double convex_contacts(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                                double, Manifold<double>&);

}  // namespace graze
