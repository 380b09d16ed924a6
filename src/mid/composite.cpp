#include "mid/composite.hpp"

#include "mid/group.hpp"
#include "mid/piece_pairs.hpp"
#include "narrow/convex_pair.hpp"

namespace graze {

namespace {

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

constexpr const char* method = "pieces of composites";

}  // namespace

template <class T>
Distance<T> any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         Trace* trace) {
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b, trace);
  Distance<T> best;
  best.distance = infinity<T>;
  const auto limit = [&] { return best.distance; };
  auto nearer = [&](const Part<T>& pa, const Part<T>& pb) {
    const Distance<T> d = convex_distance(pa.shape, pa.pose, pb.shape, pb.pose, nullptr);
    if (d.distance < best.distance) best = d;
  };
  visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, limit, nearer);
  if (trace) trace->method = method;
  return best;
}

template <class T>
bool any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace) {
  if (a.convex() && b.convex()) return convex_overlap(a, pose_a, b, pose_b, trace);
  const auto limit = [] { return T(0); };
  auto apart = [&](const Part<T>& pa, const Part<T>& pb) {
    return !convex_overlap(pa.shape, pa.pose, pb.shape, pb.pose, nullptr);
  };
  const bool all_apart = visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, limit, apart);
  if (trace) trace->method = method;
  return !all_apart;
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
  ManifoldGroups<T> groups(manifolds);
  const auto limit = [&] { return margin; };
  auto touch = [&](const Part<T>& pa, const Part<T>& pb) {
    Manifold<T> manifold;
    manifold.piece_a = pa.number;
    manifold.piece_b = pb.number;
    const T distance = convex_contacts(pa.shape, pa.pose, pb.shape, pb.pose, margin, manifold, nullptr);
    least_distance = least(least_distance, distance);
    if (!manifold.points.empty()) groups.add(manifold);
  };
  visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, limit, touch);
  groups.finish();
  if (trace) trace->method = method;
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
