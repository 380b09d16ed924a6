#include "plane/ray_hit.hpp"

#include <bit>

#include "plane/first_contact.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

namespace {

/// A point, as a core of no size.
template <class T>
const Core<T> point = core_of(Circle<T>(T(0)));

/// Whether a point surely lies outside a rounded polygon: above the line of one of its edges.
template <class T>
bool above_an_edge(const Core<T>& polygon, const Vec2d& p) {
  if (polygon.count == 1) return length_squared(p - polygon.vertex(0)) > polygon.radius * polygon.radius;
  for (std::uint32_t i = 0; i < polygon.count; ++i)
    if (surely_above(polygon.vertex(i) - p, polygon.edge(i), polygon.radius)) return true;
  return false;
}

/// The one edge of a polygon without rounding between whose ends a ray passes that sees it from the front, where that
/// is certain: it leads from the left of the ray to its right. `count` where the line of the ray misses the polygon.
template <class T>
std::optional<std::uint32_t> edge_in_front(const Core<T>& polygon, const Vec2d& origin, const Vec2d& direction) {
  if (polygon.radius != 0 || polygon.count < 3 || polygon.count > 32) return {};
  std::uint32_t on_left = 0;
  double nearest = never, furthest = 0;
  for (std::uint32_t i = 0; i < polygon.count; ++i) {
    const Vec2d to = polygon.vertex(i) - origin;
    const double beside = cross(direction, to);
    nearest = least(nearest, std::abs(beside));
    furthest = greatest(furthest, max_abs(to));
    on_left |= static_cast<std::uint32_t>(beside > 0) << i;
  }
  // The ray passes a vertex so closely that rounding decides.
  if (!(nearest > 2 * beside_rounding * furthest)) return {};
  const std::uint32_t next_on_left = on_left >> 1 | (on_left & 1) << (polygon.count - 1);
  const std::uint32_t front = on_left & ~next_on_left;
  return front == 0 ? polygon.count : static_cast<std::uint32_t>(std::countr_zero(front));
}

template <class T>
std::optional<CoreRayHit> hit_polygon(const Core<T>& polygon, const Vec2d& origin, const Vec2d& direction,
                                      double until) {
  OutlineHit edges, discs;
  for (std::uint32_t i = 0; i < polygon.count; ++i) {
    const Vec2d start = polygon.vertex(i) - origin;
    if (polygon.count > 1) meet_edge(start, polygon.edge(i), polygon.radius, direction, edges);
    if (polygon.radius > 0) meet_disc(start, polygon.radius, direction, discs);
  }
  // The points of an outline without rounding count where no edge does: where it is seen end on.
  if (polygon.radius == 0 && edges.t == never)
    for (std::uint32_t i = 0; i < polygon.count; ++i) meet_disc(polygon.vertex(i) - origin, 0, direction, discs);
  const OutlineHit& first = discs.t < edges.t ? discs : edges;
  if (first.t == never || !(first.t <= until)) return {};
  return CoreRayHit{first.t, first.normal};
}

}  // namespace

template <class T>
std::optional<CoreRayHit> ray_hit(const Core<T>& core, const Vec2d& origin, const Vec2d& direction, double until,
                                  double size, double near) {
  const bool polygon = core.kind == CoreKind::polygon;
  if (const auto front = polygon ? edge_in_front(core, origin, direction) : std::nullopt) {
    if (*front == core.count) return {};
    const Vec2d from = core.vertex(*front) - origin, edge = core.edge(*front);
    OutlineHit hit;
    if (surely_above(from, edge, 0) && meet_edge(from, edge, 0, direction, hit)) {
      if (!(hit.t <= until)) return {};
      return CoreRayHit{hit.t, hit.normal};
    }
  }
  const Pose2d start{origin, {}};
  const bool outside = polygon && above_an_edge(core, origin);
  if (!outside && nearest(core, point<T>, start, size).distance - core.radius <= 0) return CoreRayHit{0, -direction};
  if (polygon) return hit_polygon(core, origin, direction, until);
  const auto hit = first_contact(core, point<T>, start, direction, until, size, near);
  if (!hit) return {};
  return CoreRayHit{hit->t, hit->normal, hit->status};
}

template std::optional<CoreRayHit> ray_hit(const Core<float>&, const Vec2d&, const Vec2d&, double, double, double);
template std::optional<CoreRayHit> ray_hit(const Core<double>&, const Vec2d&, const Vec2d&, double, double, double);

}  // namespace graze::plane
