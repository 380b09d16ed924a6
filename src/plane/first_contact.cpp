#include "plane/first_contact.hpp"

#include <limits>

#include "plane/difference.hpp"

namespace graze::plane {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The most steps along separating lines. Each closes what the line leaves of the gap: flat sides take a few, round
/// ones converge quadratically unless they pass each other.
constexpr int most_steps = 100;

/// A ray from the origin, with a unit direction, against a rounded outline: the first of its pieces.
struct OutlineHit {
  double t = infinity;
  Vec2d normal{};
};

/// Against an edge moved outward by `radius`, from its front. Its ends are met within the rounding of the path: a ray
/// through the vertex of two edges meets one of them.
void meet_edge(const Vec2d& start, const Vec2d& edge, double radius, const Vec2d& direction, OutlineHit& best) {
  const double l = length(edge);
  if (!(l > 0)) return;
  const Vec2d along = edge / l, n = right(along);
  const double toward = -dot(n, direction), above = -dot(n, start) - radius;
  if (!(toward > 0) || above < 0) return;
  const double t = above / toward;
  if (!(t < best.t)) return;
  const double at = dot(direction * t - start, along);
  const double slack = 8 * std::numeric_limits<double>::epsilon() * (t + length(start) + l + radius);
  if (at >= -slack && at <= l + slack) best = {t, n};
}

/// Against the disc about a vertex. One of no radius is met within the rounding of the path.
void meet_disc(const Vec2d& center, double radius, const Vec2d& direction, OutlineHit& best) {
  const double along = dot(center, direction), across = cross(direction, center);
  const double reach = radius > 0 ? radius : 8 * std::numeric_limits<double>::epsilon() * length(center);
  const double under = (reach - across) * (reach + across);
  if (!(along >= 0) || !(under >= 0)) return;
  const double t = radius > 0 ? along - std::sqrt(under) : along;
  if (!(t < best.t)) return;
  best = {greatest(t, 0.0), normalized(direction * t - center, -direction)};
}

/// The distance along `direction` at which polygon B, moved along it, meets polygon A.
template <class T>
OutlineHit meet_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction) {
  const double radius = a.radius + b.radius;
  OutlineHit edges, discs;
  const auto disc = [&](const Vec2d& center) { meet_disc(center, radius, direction, discs); };
  if (a.count == 1 && b.count == 1) disc(a.vertex(0) - transform(b_in_a, b.vertex(0)));
  for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
    meet_edge(e.start, e.edge, radius, direction, edges);
    disc(e.start);
  });
  // The points of an outline without rounding count where no edge does: where it is seen end on.
  return radius > 0 || edges.t == infinity ? (discs.t < edges.t ? discs : edges) : edges;
}

}  // namespace

template <class T>
std::optional<FirstContact> first_contact(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                          const Vec2d& velocity, double duration, double size, double near,
                                          std::vector<TraceStep>* steps) {
  const double speed = length(velocity);
  if (!(speed > 0)) return {};
  FirstContact out;
  const auto moved = [&](double t) { return Pose2d{b_in_a.translation + velocity * t, b_in_a.rotation}; };
  if (a.kind == CoreKind::polygon && b.kind == CoreKind::polygon) {
    const Vec2d direction = normalized(velocity);
    const OutlineHit hit = meet_polygons(a, b, b_in_a, direction);
    out.t = hit.t / speed;
    // A path without end that meets nothing does so at no time, and not at the last.
    if (!(out.t <= duration) || hit.t == infinity) return {};
    const Nearest touching = nearest(a, b, moved(out.t), size);
    out.normal = hit.normal;
    out.point = touching.a.point + out.normal * a.radius;
    return out;
  }
  for (int step = 0; step < most_steps; ++step) {
    const Nearest found = nearest(a, b, moved(out.t), size);
    const double gap = found.distance - found.error - a.radius - b.radius, closing = -dot(velocity, found.normal);
    out.normal = found.normal;
    out.point = found.a.point + found.normal * a.radius;
    if (steps) steps->push_back({out.t, gap, {found.normal.x, found.normal.y, 0}});
    if (gap <= near && (closing > 0 || gap <= 0)) return out;
    if (!(closing > 0)) return {};
    // To half of what counts as contact, so that the last step does not fall short by rounding.
    const double later = out.t + (gap - near / 2) / closing;
    if (later == infinity) return {};
    if (!(later <= duration)) {
      // What remains of the gap at the end may count as contact.
      const Nearest last = nearest(a, b, moved(duration), size);
      if (!(last.distance - a.radius - b.radius <= 0)) return {};
      out.t = duration;
      return out;
    }
    if (later == out.t) return out;
    out.t = later;
  }
  out.status = Status::bounded;
  return out;
}

template std::optional<FirstContact> first_contact(const Core<float>&, const Core<float>&, const Pose2d&, const Vec2d&,
                                                   double, double, double, std::vector<TraceStep>*);
template std::optional<FirstContact> first_contact(const Core<double>&, const Core<double>&, const Pose2d&,
                                                   const Vec2d&, double, double, double, std::vector<TraceStep>*);

}  // namespace graze::plane
