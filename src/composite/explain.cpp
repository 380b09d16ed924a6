#include "composite/explain.hpp"

#include <limits>
#include <optional>
#include <string>

#include "composite/internal_edges/leaf_in_context.hpp"
#include "composite/leaf_pairs.hpp"
#include "composite/solid.hpp"
#include "narrow/explain.hpp"
#include "narrow/pair_table.hpp"

namespace graze {

namespace {

/// A pair of convex pieces and its distance.
template <class T>
struct DecidingPair {
  Distance<T> distance;
  Placed<T> a, b;
  std::uint32_t piece_a, piece_b;
};

/// The nearest or deepest pair of pieces that comes within `reach`, of those for which `counts(part_a, part_b)`.
template <class T, class Counts>
std::optional<DecidingPair<T>> deciding_pair(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                             const Pose<T>& pose_b, T reach, const Counts& counts) {
  std::optional<DecidingPair<T>> pair;
  auto offer = [&](const Part<T>& pa, const Part<T>& pb) {
    if (!counts(pa, pb)) return;
    const Distance<T> d = convex_distance(pa.shape, pa.pose, pb.shape, pb.pose);
    if (pair && !(d.distance < pair->distance.distance)) return;
    pair.emplace(DecidingPair<T>{d, {pa.shape, pa.pose}, {pb.shape, pb.pose}, pa.number, pb.number});
    reach = least(reach, d.distance);
  };
  visit_convex_pairs<T>({a, pose_a}, {b, pose_b}, {reach}, PairVisitor<T>(offer));
  return pair;
}

/// The reach of a shape along a direction of the world.
template <class T>
double reach_along(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& direction) {
  double reach = -std::numeric_limits<double>::infinity();
  visit_pieces(
      shape, pose, Aabb<T>::everything(), [] { return T(0); },
      [&](const Shape<T>& piece, const Pose<T>& pose_of_piece, std::uint32_t) {
        double along = std::numeric_limits<double>::infinity();
        if (!piece.convex())
          along = reach_along(piece, pose_of_piece, direction);
        else if (!piece.template as<HalfSpace<T>>())
          along = static_cast<double>(dot(furthest(piece, pose_of_piece, direction), direction));
        reach = greatest(reach, along);
      });
  return reach;
}

/// Explains an answer with this distance and normal if it is that of a body inside a solid mesh: the axis is the way
/// out, on which the mesh ends where the body's last point has to go. Returns whether it is.
template <class T>
bool explain_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T distance,
                      const Vec3<T>& normal, Trace& trace) {
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  if (!inside || inside->distance.distance != distance || inside->distance.normal != normal) return false;
  trace.method = "inside a solid mesh: the way out";
  trace.axes.push_back({"way out", converted<double>(normal), -reach_along(a, pose_a, -normal),
                        static_cast<double>(dot(inside->distance.a, normal)),
                        static_cast<double>(dot(inside->distance.b, normal)), reach_along(b, pose_b, normal)});
  return true;
}

template <class T>
std::string piece_name(const Shape<T>& whole, std::string letter, std::uint32_t piece) {
  if (whole.convex()) return letter;
  letter += " piece ";
  return letter += std::to_string(piece);
}

/// Names the pieces in front of the method by which they were answered.
template <class T>
void name_pieces(const Shape<T>& a, const Shape<T>& b, const DecidingPair<T>& pair, Trace& trace) {
  std::string method("pieces of composites, ");
  method += piece_name(a, "A", pair.piece_a);
  method += " and ";
  method += piece_name(b, "B", pair.piece_b);
  method += ": ";
  trace.method = method += trace.method;
}

template <class T>
void explain_nearest_pieces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            Trace& trace) {
  trace.method = "pieces of composites";
  const auto any = [](const Part<T>&, const Part<T>&) { return true; };
  const auto pair = deciding_pair(a, pose_a, b, pose_b, std::numeric_limits<T>::infinity(), any);
  if (!pair) return;
  explain_distance(pair->a.shape, pair->a.pose, pair->b.shape, pair->b.pose, pair->distance, trace);
  name_pieces(a, b, *pair, trace);
}

template <class T>
const Manifold<T>* deepest(std::span<const Manifold<T>> manifolds) {
  const Manifold<T>* deepest = nullptr;
  T least_distance = std::numeric_limits<T>::infinity();
  for (const Manifold<T>& m : manifolds)
    for (const ContactPoint<T>& p : m.points)
      if (p.distance < least_distance) {
        least_distance = p.distance;
        deepest = &m;
      }
  return deepest;
}

}  // namespace

template <class T>
void explain_any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                          const Distance<T>& answer, Trace& trace) {
  if (a.convex() && b.convex())
    explain_distance(a, pose_a, b, pose_b, answer, trace);
  else if (!explain_enclosed(a, pose_a, b, pose_b, answer.distance, answer.normal, trace))
    explain_nearest_pieces(a, pose_a, b, pose_b, trace);
}

template <class T>
void explain_any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         Trace& trace) {
  if (a.convex() && b.convex()) return explain_overlap(a, pose_a, b, pose_b, trace);
  const std::optional<Enclosed<T>> inside = deepest_enclosed(a, pose_a, b, pose_b);
  if (!inside || !explain_enclosed(a, pose_a, b, pose_b, inside->distance.distance, inside->distance.normal, trace))
    explain_nearest_pieces(a, pose_a, b, pose_b, trace);
}

template <class T>
void explain_any_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                          std::span<const Manifold<T>> answer, Trace& trace) {
  if (a.convex() && b.convex()) {
    explain_contacts(a, pose_a, b, pose_b, margin, answer.empty() ? Manifold<T>{} : answer[0], trace);
    return;
  }
  const Manifold<T>* const stood_on = deepest(answer);
  if (!stood_on) return explain_nearest_pieces(a, pose_a, b, pose_b, trace);
  for (const ContactPoint<T>& p : stood_on->points)
    if (explain_enclosed(a, pose_a, b, pose_b, p.distance, stood_on->normal, trace)) return;
  const auto its_own = [&](const Part<T>& pa, const Part<T>& pb) {
    return pa.number == stood_on->piece_a && pb.number == stood_on->piece_b;
  };
  const auto pair = deciding_pair(a, pose_a, b, pose_b, margin, its_own);
  if (!pair) return explain_nearest_pieces(a, pose_a, b, pose_b, trace);
  Manifold<T> manifold;
  convex_contacts(pair->a.shape, pair->a.pose, pair->b.shape, pair->b.pose, margin, manifold);
  explain_contacts(pair->a.shape, pair->a.pose, pair->b.shape, pair->b.pose, margin, manifold, trace);
  name_pieces(a, b, *pair, trace);
}

template <class T>
void explain_any_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, const Closest<T>& answer,
                         Trace& trace) {
  trace.method = "pieces of composites";
  if (!shape.convex()) return;
  const Distance<T> distance{answer.distance, answer.normal, answer.point, point, answer.status};
  explain_distance(shape, pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{point, {}}, distance, trace);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void explain_any_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&,                 \
                                     const Distance<T>&, Trace&);                                                      \
  template void explain_any_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace&);         \
  template void explain_any_contacts(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T,              \
                                     std::span<const Manifold<T>>, Trace&);                                            \
  template void explain_any_closest(const Shape<T>&, const Pose<T>&, const Vec3<T>&, const Closest<T>&, Trace&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
