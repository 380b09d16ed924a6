#include "plane/ray_hit.hpp"

#include "plane/first_contact.hpp"
#include "plane/sure_hit.hpp"

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

/// The hit where no edge is surely the one that is met.
template <class T>
[[gnu::noinline]] std::optional<CoreRayHit>
hit_closely(const Core<T>& core, const Vec2d& origin, const Vec2d& direction, double until, double size, double near) {
  const bool polygon = core.kind == CoreKind::polygon;
  const Pose2d start{origin, {}};
  const bool outside = polygon && above_an_edge(core, origin);
  if (!outside && nearest(core, point<T>, start, size).distance - core.radius <= 0) return CoreRayHit{0, -direction};
  if (polygon) return hit_polygon(core, origin, direction, until);
  const auto unseen = [](double, double, const Vec2d&) {};
  const auto hit = advance_straight(core, point<T>, start, direction, until, size, near, unseen);
  if (!hit) return {};
  return CoreRayHit{hit->t, hit->normal, hit->status};
}

}  // namespace

template <class T>
std::optional<CoreRayHit> ray_hit(const Core<T>& core, const Vec2d& origin, const Vec2d& direction, double until,
                                  double size, double near) {
  if (core.kind == CoreKind::polygon && core.radius == 0) {
    const SureHit sure = sure_hit(axes_polygon(core), origin, direction, size);
    if (sure.known)
      return sure.t <= until && sure.t != never ? std::optional(CoreRayHit{sure.t, sure.normal}) : std::nullopt;
  }
  return hit_closely(core, origin, direction, until, size, near);
}

template std::optional<CoreRayHit> ray_hit(const Core<float>&, const Vec2d&, const Vec2d&, double, double, double);
template std::optional<CoreRayHit> ray_hit(const Core<double>&, const Vec2d&, const Vec2d&, double, double, double);

}  // namespace graze::plane
