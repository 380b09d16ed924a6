#include "graze/query.hpp"

#include "composite/closest.hpp"
#include "composite/composite.hpp"
#include "composite/explain.hpp"
#include "narrow/pair_table.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// The traced queries, each the ordinary answer followed by its explanation. Out of line, so that the ordinary ones
/// only pass their arguments on: with both in one function contacts of spheres and boxes took a tenth longer.
template <class T>
[[gnu::noinline]] bool traced_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                      const Pose<T>& pose_b, Trace& trace) {
  const bool touch = any_overlap(a, pose_a, b, pose_b);
  explain_any_overlap(a, pose_a, b, pose_b, trace);
  return touch;
}

template <class T>
[[gnu::noinline]] Distance<T> traced_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                              const Pose<T>& pose_b, Trace& trace) {
  const Distance<T> d = any_distance(a, pose_a, b, pose_b);
  explain_any_distance(a, pose_a, b, pose_b, d, trace);
  return d;
}

template <class T>
[[gnu::noinline]] bool traced_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                       const Pose<T>& pose_b, T margin, Manifolds<T>& manifolds, Trace& trace) {
  const std::size_t first = manifolds.size();
  const bool touch = any_contacts(a, pose_a, b, pose_b, margin, manifolds) <= T(0);
  explain_any_contacts(a, pose_a, b, pose_b, margin, std::span<const Manifold<T>>(manifolds).subspan(first), trace);
  return touch;
}

}  // namespace

template <class T>
bool overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace) {
  return trace ? traced_overlap(a, pose_a, b, pose_b, *trace) : any_overlap(a, pose_a, b, pose_b);
}

template <class T>
bool may_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  if (!a.convex() || !b.convex()) return overlap(a, pose_a, b, pose_b);
  return convex_may_overlap(a, pose_a, b, pose_b);
}

template <class T>
T contact_margin(const Shape<T>& a, const Shape<T>& b) {
  const auto size = [](const Shape<T>& shape) {
    return shape.visit([&](const auto& c) -> T {
      using C = std::decay_t<decltype(c)>;
      if constexpr (BoundedConvex<C>) return c.core_extent() + rounding_radius(c, shape.rounding());
      if constexpr (std::is_same_v<C, HalfSpace<T>>) return std::numeric_limits<T>::infinity();
      return length(bounds(shape, Pose<T>{}).extent()) / T(2);
    });
  };
  const T smaller = least(size(a), size(b));
  return smaller < std::numeric_limits<T>::infinity() ? smaller / T(100) : T(0);
}

template <class T>
Distance<T> distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace) {
  return trace ? traced_distance(a, pose_a, b, pose_b, *trace) : any_distance(a, pose_a, b, pose_b);
}

template <class T>
std::optional<Distance<T>> distance_up_to(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                          const Pose<T>& pose_b, T limit) {
  const Distance<T> d = any_distance(a, pose_a, b, pose_b, just_above(limit));
  return d.distance <= limit ? std::optional(d) : std::nullopt;
}

template <class T>
bool within(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit) {
  return any_within(a, pose_a, b, pose_b, limit);
}

template <class T>
void near_pieces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                 std::vector<PieceDistance<T>>& pieces) {
  any_near_pieces(a, pose_a, b, pose_b, margin, pieces);
}

template <class T>
bool contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
              Manifolds<T>& manifolds, Trace* trace) {
  if (trace) return traced_contacts(a, pose_a, b, pose_b, margin, manifolds, *trace);
  return any_contacts(a, pose_a, b, pose_b, margin, manifolds) <= T(0);
}

template <class T>
Closest<T> closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, Trace* trace) {
  const Closest<T> nearest = any_closest(shape, pose, point);
  if (trace) explain_any_closest(shape, pose, point, nearest, *trace);
  return nearest;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template bool overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace*);                     \
  template bool may_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);                         \
  template T contact_margin(const Shape<T>&, const Shape<T>&);                                                         \
  template Distance<T> distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace*);             \
  template std::optional<Distance<T>> distance_up_to(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, \
                                                     T);                                                               \
  template bool within(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T);                           \
  template void near_pieces(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T,                       \
                            std::vector<PieceDistance<T>>&);                                                           \
  template bool contacts(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T, Manifolds<T>&, Trace*);  \
  template Closest<T> closest(const Shape<T>&, const Pose<T>&, const Vec3<T>&, Trace*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
