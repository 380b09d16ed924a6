#include "plane/first_contact.hpp"

#include <limits>

#include "plane/entry_axes.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

namespace {

/// The most steps along separating lines. Each closes what the line leaves of the gap: flat sides take a few, round
/// ones converge quadratically unless they pass each other.
constexpr int most_steps = 100;

/// The first hits of polygon B, moved along a direction, on polygon A: the nearest moved edge and the nearest disc.
struct DifferenceHit {
  OutlineHit on_edge{}, on_disc{};
  DifferenceEdge edge{};       ///< of `on_edge`
  std::uint32_t vertex_a = 0;  ///< of `on_disc`
};

template <class T>
DifferenceHit meet_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction,
                            double size) {
  const double radius = a.radius + b.radius;
  DifferenceHit hit;
  if (DifferenceEntry entry; radius == 0 && entry_by_axes(a, b, b_in_a, direction, size, entry)) {
    hit.on_edge = entry.hit;
    hit.edge = entry.edge;
    return hit;
  }
  const auto disc = [&](const Vec2d& center, std::uint32_t i) {
    if (meet_disc(center, radius, direction, hit.on_disc)) hit.vertex_a = i;
  };
  if (a.count == 1 && b.count == 1) disc(a.vertex(0) - transform(b_in_a, b.vertex(0)), 0);
  for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) {
    if (meet_edge(e.start, e.edge, radius, direction, hit.on_edge)) hit.edge = e;
    if (radius > 0) disc(e.start, e.i);
  });
  // The points of an outline without rounding count where no edge does: where it is seen end on.
  if (radius == 0 && hit.on_edge.t == never)
    for_each_difference_edge(a, b, b_in_a, [&](const DifferenceEdge& e) { disc(e.start, e.i); });
  return hit;
}

/// The point of A's core at a hit.
template <class T>
Vec2d point_of_a(const Core<T>& a, const DifferenceHit& hit, const Vec2d& direction) {
  if (hit.on_disc.t < hit.on_edge.t) return a.vertex(hit.vertex_a);
  const DifferenceEdge& e = hit.edge;
  if (!e.of_a) return a.vertex(e.i);
  const double along = dot(direction * hit.on_edge.t - e.start, e.edge) / length_squared(e.edge);
  return a.vertex(e.i) + a.edge(e.i) * clamp(along, 0.0, 1.0);
}

}  // namespace

template <class T>
bool surely_apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double near) {
  const double radius = a.radius + b.radius + near;
  bool apart = a.count == 1 && b.count == 1 &&
               length_squared(a.vertex(0) - transform(b_in_a, b.vertex(0))) * (1 - 0x1p-40) > radius * radius;
  for_each_difference_edge(a, b, b_in_a,
                           [&](const DifferenceEdge& e) { apart = apart || surely_above(e.start, e.edge, radius); });
  return apart;
}

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
    const DifferenceHit hit = meet_polygons(a, b, b_in_a, direction, size);
    const OutlineHit& first = hit.on_disc.t < hit.on_edge.t ? hit.on_disc : hit.on_edge;
    out.t = first.t / speed;
    // A path without end that meets nothing does so at no time, and not at the last.
    if (!(out.t <= duration) || first.t == never) return {};
    out.normal = first.normal;
    out.point = point_of_a(a, hit, direction) + out.normal * a.radius;
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
    // Up to half of the gap that counts as contact, so that the last step does not fall short by rounding.
    const double later = out.t + (gap - near / 2) / closing;
    if (later == never) return {};
    if (!(later <= duration)) {
      // The way ends before this step does: at its end the cores may touch all the same.
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

template bool surely_apart(const Core<float>&, const Core<float>&, const Pose2d&, double);
template bool surely_apart(const Core<double>&, const Core<double>&, const Pose2d&, double);
template std::optional<FirstContact> first_contact(const Core<float>&, const Core<float>&, const Pose2d&, const Vec2d&,
                                                   double, double, double, std::vector<TraceStep>*);
template std::optional<FirstContact> first_contact(const Core<double>&, const Core<double>&, const Pose2d&,
                                                   const Vec2d&, double, double, double, std::vector<TraceStep>*);

}  // namespace graze::plane
