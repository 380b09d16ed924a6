#include "graze/plane/query.hpp"

#include <cmath>
#include <limits>

#include "graze/plane/proximity.hpp"
#include "plane/beside.hpp"
#include "plane/explain.hpp"
#include "plane/joined.hpp"
#include "plane/leaves.hpp"
#include "plane/manifold.hpp"
#include "plane/nearest_axes.hpp"
#include "plane/on_outline.hpp"
#include "plane/pairs/pair_table.hpp"

namespace graze::plane {

namespace {

/// A core to which any normal belongs if it is a chain's: but for its contacts a chain is a line.
template <class T>
Core<T> as_line(Core<T> core) {
  if (core.chain) core.outline = nullptr;
  return core;
}

/// Whether cores overlap, or touch on a cut of a polygon, which is inside of it.
template <class T>
bool may_lie_on_cut(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found) {
  if (found.distance < 0) return true;
  if (found.distance > touching_rounding * (pair.size() + max_abs(b_in_a.translation))) return false;
  return on_cut(pair.a, found.a.feature, found.normal) ||
         on_cut(pair.b, found.b.feature, inverse_rotate(b_in_a.rotation, -found.normal));
}

/// The answer of a pair of convex shapes in world space, in double.
template <class T>
Distance<double> pair_distance(const LeafPair<T>& pair) {
  const Pose2d b_in_a = relative(pair.pose_a, pair.pose_b);
  Nearest found = nearest(pair.a, pair.b, b_in_a, pair.size());
  // A way out of a polygon leads through its outline and not through a cut.
  const bool polygon = (pair.a.outline && !pair.a.chain) || (pair.b.outline && !pair.b.chain);
  if (polygon && may_lie_on_cut(pair, b_in_a, found)) {
    const Core<T> a = as_line(pair.a), b = as_line(pair.b);
    if (!on_outlines(a, b, b_in_a, found, pair.size()))
      if (const auto outward = least_overlap_on_outlines(a, b, b_in_a)) found = *outward;
  }
  Distance<double> out;
  out.distance = found.distance - pair.a.radius - pair.b.radius;
  out.normal = rotate(pair.pose_a.rotation, found.normal);
  out.a = transform(pair.pose_a, found.a.point + found.normal * pair.a.radius);
  out.b = transform(pair.pose_a, found.b.point - found.normal * pair.b.radius);
  take_status(found, pair, out);
  return out;
}

template <class T>
bool pair_overlaps(const LeafPair<T>& pair) {
  if (pair.a.kind == CoreKind::polygon && pair.b.kind == CoreKind::polygon) {
    const Pose2d b_in_a = relative(pair.pose_a, pair.pose_b);
    if (const auto known = within_by_axes(pair.a, pair.b, b_in_a, pair.size(), pair.a.radius + pair.b.radius))
      return *known;
  }
  return pair_distance(pair).distance <= 0;
}

template <class T>
Distance<T> narrowed(const Distance<double>& d) {
  return {static_cast<T>(d.distance), converted<T>(d.normal), converted<T>(d.a), converted<T>(d.b), d.status,
          static_cast<T>(d.error)};
}

/// The smallest distance over all pairs, of those that are less than `below` apart; else that distance and no more.
/// With a trace, explains the pair that has it.
template <class T>
Distance<double> smallest(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                          Trace* trace, double below = std::numeric_limits<double>::infinity()) {
  Distance<double> best;
  best.distance = below;
  const auto within = [&] { return best.distance; };
  for_each_pair_within(a, pose_a, b, pose_b, within, [&](const LeafPair<T>& pair) {
    if (pair.apart() >= best.distance) return;
    if (const Distance<double> d = pair_distance(pair); d.distance < best.distance) {
      best = d;
      if (trace) *trace = explained(pair, d);
    }
  });
  return best;
}

template <class T>
Distance<T> convex_distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Distance<T> out;
  out.distance = static_cast<T>(infinite);
  with_convex_pair(a, pose_a, b, pose_b, infinite, [&](const LeafPair<T>& pair) {
    if (const Distance<double> d = pair_distance(pair); d.distance < infinite) out = narrowed<T>(d);
  });
  return out;
}

/// The distance of shapes without a special pair, in a function of its own: special pairs do not pay for its set-up.
template <class T>
[[gnu::noinline]] Distance<T> general_distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                               const Pose2<T>& pose_b) {
  if (a.convex() && b.convex()) return convex_distance(a, pose_a, b, pose_b);
  return narrowed<T>(smallest(a, pose_a, b, pose_b, nullptr));
}

/// The distance by the special pair of the shapes' kinds, else the smallest over all pairs of convex pieces.
template <class T>
Distance<T> any_distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b) {
  // No answer is copied: it is written in parts, and processors wait before they read them in one piece.
  if (Distance<T> special; special_distance(a, pose_a, b, pose_b, special)) return special;
  return general_distance(a, pose_a, b, pose_b);
}

/// The signed distance of a point inside: the deepest of its ways out, which from a polygon leads through the outline
/// of the whole and not through that of one piece.
template <class T>
Distance<double> deepest_way_out(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& point) {
  Distance<double> best;
  best.distance = std::numeric_limits<double>::infinity();
  const auto take_deeper = [&](const Distance<double>& d) {
    if (d.distance < best.distance) best = d;
  };
  for_each_pair(shape, pose, Shape<T>(Circle<T>(T(0))), {point, {}}, [&](const LeafPair<T>& pair) {
    const Vec2d own = inverse_transform(pair.pose_a, pair.pose_b.translation);
    Distance<double> d = pair_distance(pair);
    if (pair.a.outline && !pair.a.chain) {
      // Beside a corner in which pieces meet a point may lie outside of each by rounding, and a piece have no way out
      // but one at its far side.
      const double gap = nearest(pair.a, pair.b, Pose2d{own, {}}, pair.size()).distance;
      if (!(gap <= 0 || d.distance < gap - pair.a.radius)) return take_deeper(d);
      const Nearest out = nearest_on_outline(pair.a, own, gap <= 0);
      d.distance = out.distance - pair.a.radius;
      d.normal = rotate(pair.pose_a.rotation, out.normal);
      d.a = transform(pair.pose_a, out.a.point + out.normal * pair.a.radius);
    }
    take_deeper(d);
  });
  return best;
}

template <class T>
bool all_contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                  Manifolds<T>& manifolds) {
  if (const auto known = special_contacts(a, pose_a, b, pose_b, margin, manifolds)) return *known;
  if (!a.convex() || !b.convex()) return contacts_beside(a, pose_a, b, pose_b, margin, manifolds, {}, {});
  bool overlaps = false;
  with_convex_pair(a, pose_a, b, pose_b, double(margin), [&](const LeafPair<T>& pair) {
    const Pose2d b_in_a = relative(pair.pose_a, pair.pose_b);
    const Nearest found = nearest(pair.a, pair.b, b_in_a, pair.size());
    overlaps = add_manifold(pair, b_in_a, found, double(margin), manifolds);
  });
  return overlaps;
}

}  // namespace

template <class T>
bool overlap(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, Trace* trace) {
  if (trace) smallest(a, pose_a, b, pose_b, trace);
  if (const auto known = special_overlap(a, pose_a, b, pose_b)) return *known;
  bool found = false;
  const auto no_gap = [] { return 0.0; };
  for_each_pair_within(a, pose_a, b, pose_b, no_gap,
                       [&](const LeafPair<T>& pair) { found = found || (pair.apart() <= 0 && pair_overlaps(pair)); });
  return found;
}

template <class T>
Distance<T> distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                     Trace* trace) {
  if (trace) smallest(a, pose_a, b, pose_b, trace);
  return any_distance(a, pose_a, b, pose_b);
}

template <class T>
bool contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
              Manifolds<T>& manifolds, Trace* trace) {
  if (!trace) return all_contacts(a, pose_a, b, pose_b, margin, manifolds);
  smallest(a, pose_a, b, pose_b, trace);
  const std::size_t before = manifolds.size();
  const bool overlaps = all_contacts(a, pose_a, b, pose_b, margin, manifolds);
  if (overlaps && manifolds.size() == before) explain_missing_contacts(a, b, *trace);
  return overlaps;
}

template <class T>
void reduce(Manifold<T>& manifold, std::size_t count) {
  while (manifold.points.size() > count) {
    std::size_t least_deep = 0;
    for (std::size_t i = 1; i < manifold.points.size(); ++i)
      if (manifold.points[i].distance >= manifold.points[least_deep].distance) least_deep = i;
    for (std::size_t i = least_deep + 1; i < manifold.points.size(); ++i) manifold.points[i - 1] = manifold.points[i];
    manifold.points.truncate(manifold.points.size() - 1);
  }
}

template <class T>
T contact_margin(const Shape<T>& a, const Shape<T>& b) {
  constexpr T unbounded = std::numeric_limits<T>::infinity();
  const auto size = [](const Shape<T>& shape) {
    if (shape.template as<HalfPlane<T>>()) return unbounded;
    if (!shape.template as<Compound<T>>()) return extent(shape);
    const Aabb2<T> box = bounds(shape, Pose2<T>{});
    return length(box.upper - box.lower) / T(2);
  };
  const T smaller = least(size(a), size(b));
  return smaller < unbounded ? smaller / T(100) : T(0);
}

template <class T>
Closest<T> closest(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& point, Trace* trace) {
  const Shape<T> spot = Circle<T>(T(0));
  if (trace) smallest<T>(shape, pose, spot, {point, {}}, trace);
  Distance<T> d;
  if (!special_distance<T>(shape, pose, spot, {point, {}}, d)) {
    Distance<double> found = smallest<T>(shape, pose, spot, {point, {}}, nullptr);
    if (found.distance < 0) found = deepest_way_out(shape, pose, point);
    d = narrowed<T>(found);
  }
  return {d.distance, d.a, d.normal, d.status, d.error};
}

namespace {

/// The bound below which a distance rounded to T is no larger than `limit`.
template <class T>
double just_above(T limit) {
  return double(std::nextafter(limit, std::numeric_limits<T>::infinity()));
}

}  // namespace

template <class T>
bool within(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T limit) {
  if (Distance<T> special; special_distance(a, pose_a, b, pose_b, special)) return special.distance <= limit;
  bool found = false;
  const auto reach = [above = just_above(limit)] { return above; };
  for_each_pair_within(a, pose_a, b, pose_b, reach, [&](const LeafPair<T>& pair) {
    found = found || (pair.apart() <= reach() && static_cast<T>(pair_distance(pair).distance) <= limit);
  });
  return found;
}

template <class T>
std::optional<Distance<T>> distance_up_to(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                          const Pose2<T>& pose_b, T limit) {
  Distance<T> d;
  if (!special_distance(a, pose_a, b, pose_b, d))
    d = narrowed<T>(smallest(a, pose_a, b, pose_b, nullptr, just_above(limit)));
  if (d.distance > limit) return {};
  return d;
}

template <class T>
void near_pieces(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                 std::vector<PieceDistance<T>>& pieces) {
  if (Distance<T> special; special_distance(a, pose_a, b, pose_b, special)) {
    if (special.distance <= margin) pieces.push_back({0, 0, special});
    return;
  }
  const auto reach = [above = just_above(margin)] { return above; };
  for_each_pair_within(a, pose_a, b, pose_b, reach, [&](const LeafPair<T>& pair) {
    if (pair.apart() > reach()) return;
    const Distance<T> d = narrowed<T>(pair_distance(pair));
    if (d.distance <= margin) pieces.push_back({pair.piece_a, pair.piece_b, d});
  });
}

#define GRAZE_PLANE_QUERIES(T)                                                                                         \
  template bool overlap(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, Trace*);                   \
  template Distance<T> distance(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, Trace*);           \
  template bool contacts(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, T, Manifolds<T>&,         \
                         Trace*);                                                                                      \
  template void reduce(Manifold<T>&, std::size_t);                                                                     \
  template T contact_margin(const Shape<T>&, const Shape<T>&);                                                         \
  template Closest<T> closest(const Shape<T>&, const Pose2<T>&, const Vec2<T>&, Trace*);                               \
  template bool within(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, T);                         \
  template std::optional<Distance<T>> distance_up_to(const Shape<T>&, const Pose2<T>&, const Shape<T>&,                \
                                                     const Pose2<T>&, T);                                              \
  template void near_pieces(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, T,                     \
                            std::vector<PieceDistance<T>>&);
GRAZE_PLANE_QUERIES(float)
GRAZE_PLANE_QUERIES(double)
#undef GRAZE_PLANE_QUERIES

}  // namespace graze::plane
