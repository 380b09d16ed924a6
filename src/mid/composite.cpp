#include "mid/composite.hpp"

#include "mid/deciding_pair.hpp"
#include "mid/group.hpp"
#include "mid/pieces.hpp"
#include "narrow/convex_pair.hpp"

namespace graze {

namespace {

/// Calls `f` for all pairs of convex pieces that come within `limit()` of each other.
/// `f(shape_a, pose_a, piece_a, shape_b, pose_b, piece_b)`; a piece number is that of the outermost composite.
template <class T, class Limit, class F>
void visit_pairs(const Shape<T>& a, const Pose<T>& pose_a, std::uint32_t piece_a, const Shape<T>& b,
                 const Pose<T>& pose_b, std::uint32_t piece_b, const Limit& limit, F& f, bool outer_a = true,
                 bool outer_b = true) {
  if (!a.convex()) {
    const Aabb<T> region = bounds(b, relative(pose_a, pose_b));
    visit_pieces(a, pose_a, region, limit, [&](const Shape<T>& piece, const Pose<T>& pose, std::uint32_t number) {
      visit_pairs(piece, pose, outer_a ? number : piece_a, b, pose_b, piece_b, limit, f, false, outer_b);
    });
  } else if (!b.convex()) {
    const Aabb<T> region = bounds(a, relative(pose_b, pose_a));
    visit_pieces(b, pose_b, region, limit, [&](const Shape<T>& piece, const Pose<T>& pose, std::uint32_t number) {
      visit_pairs(a, pose_a, piece_a, piece, pose, outer_b ? number : piece_b, limit, f, false, false);
    });
  } else {
    f(a, pose_a, piece_a, b, pose_b, piece_b);
  }
}

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

}  // namespace

template <class T>
Distance<T> any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         Trace* trace) {
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b, trace);
  Distance<T> best;
  best.distance = infinity<T>;
  const auto limit = [&] { return best.distance; };
  DecidingPair<T> deciding(trace);
  auto nearer = [&](const Shape<T>& pa, const Pose<T>& qa, std::uint32_t na, const Shape<T>& pb, const Pose<T>& qb,
                    std::uint32_t nb) {
    const Distance<T> d = convex_distance(pa, qa, pb, qb, nullptr);
    deciding.offer(d.distance, pa, qa, na, pb, qb, nb);
    if (d.distance < best.distance) best = d;
  };
  visit_pairs(a, pose_a, 0u, b, pose_b, 0u, limit, nearer);
  deciding.explain(a, b, convex_distance<T>);
  return best;
}

template <class T>
bool any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace) {
  if (a.convex() && b.convex()) return convex_overlap(a, pose_a, b, pose_b, trace);
  bool found = false;
  const auto limit = [] { return T(0); };
  auto touch = [&](const Shape<T>& pa, const Pose<T>& qa, std::uint32_t, const Shape<T>& pb, const Pose<T>& qb,
                   std::uint32_t) { found = found || convex_overlap(pa, qa, pb, qb, nullptr); };
  visit_pairs(a, pose_a, 0u, b, pose_b, 0u, limit, touch);
  if (trace) any_distance(a, pose_a, b, pose_b, trace);
  return found;
}

template <class T>
T any_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
               Manifolds<T>& manifolds, Trace* trace) {
  if (a.convex() && b.convex()) {
    Manifold<T> manifold;
    const T distance = convex_contacts(a, pose_a, b, pose_b, margin, manifold, trace);
    if (!manifold.points.empty()) manifolds.push_back(manifold);
    return distance;
  }
  T least_distance = infinity<T>;
  const std::size_t first = manifolds.size();
  const auto limit = [&] { return margin; };
  DecidingPair<T> deciding(trace);
  auto touch = [&](const Shape<T>& pa, const Pose<T>& qa, std::uint32_t na, const Shape<T>& pb, const Pose<T>& qb,
                   std::uint32_t nb) {
    Manifold<T> manifold;
    manifold.piece_a = na;
    manifold.piece_b = nb;
    const T distance = convex_contacts(pa, qa, pb, qb, margin, manifold, nullptr);
    least_distance = least(least_distance, distance);
    deciding.offer(distance, pa, qa, na, pb, qb, nb);
    if (!manifold.points.empty()) manifolds.push_back(manifold);
  };
  visit_pairs(a, pose_a, 0u, b, pose_b, 0u, limit, touch);
  group_by_normal(manifolds, first);
  if (trace && manifolds.size() == first) {
    any_distance(a, pose_a, b, pose_b, trace);
  } else {
    deciding.explain(a, b, [&](const auto& pa, const auto& qa, const auto& pb, const auto& qb, Trace* asked) {
      Manifold<T> manifold;
      convex_contacts(pa, qa, pb, qb, margin, manifold, asked);
    });
  }
  return least_distance;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Distance<T> any_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace*);         \
  template bool any_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace*);                 \
  template T any_contacts(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T, Manifolds<T>&, Trace*);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
