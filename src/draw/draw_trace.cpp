// The drawing of a query's steps.
#include <algorithm>
#include <cmath>

#include "graze/draw.hpp"

namespace graze {

namespace {

constexpr DrawLayer layer = DrawLayer::trace;

/// The distance between intervals that are drawn beside each other, in parts of the area.
constexpr double beside = 1.0 / 60;

Vec3d difference(const TraceSupport& support) { return support.b - support.a; }

void draw_outline(DebugDraw& on, const std::vector<TraceSupport>& polygon, DrawMeaning meaning) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1; ++i)
    on.line(difference(polygon[i]), difference(polygon[(i + 1) % polygon.size()]), layer, meaning);
}

void draw_face(DebugDraw& on, const std::vector<Vec3d>& corners, DrawMeaning meaning) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    on.line(corners[i], corners[(i + 1) % corners.size()], layer, meaning);
}

/// Whether an iteration searched: one whose simplex holds the origin has no direction, and finds nothing.
bool searched(const TraceGjk& iteration) { return max_abs(iteration.direction) > 0; }

void draw_simplex(DebugDraw& on, const std::vector<TraceSupport>& simplex) {
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    on.point(difference(simplex[i]), layer, DrawMeaning::b);
    for (std::size_t k = 0; k < i; ++k) on.line(difference(simplex[k]), difference(simplex[i]), layer, DrawMeaning::b);
  }
}

void draw_origin(DebugDraw& on) {
  on.point({}, layer, DrawMeaning::normal);
  on.text({}, "O", layer, DrawMeaning::normal);
}

void draw_polytope(DebugDraw& on, const Trace& trace) {
  Polygons polytope;
  for (const TraceSupport& vertex : trace.polytope) polytope.points.push_back(difference(vertex));
  for (const auto& triangle : trace.triangles) {
    auto& loop = polytope.loops.emplace_back();
    for (const std::size_t i : triangle) loop.push_back(static_cast<std::uint32_t>(i));
  }
  if (!polytope.loops.empty()) on.polygons(polytope, layer, DrawMeaning::b);
}

}  // namespace

void draw(DebugDraw& on, const TraceGjk& iteration) {
  if (!on.wants(layer)) return;
  draw_outline(on, iteration.polygon, DrawMeaning::ruled_out);
  draw_simplex(on, iteration.simplex);
  draw_origin(on);
  if (!searched(iteration)) return;
  on.point(difference(iteration.found), layer, DrawMeaning::contact);
  on.arrow({}, normalized(iteration.direction), layer, DrawMeaning::normal);
}

void draw(DebugDraw& on, const TraceEpa& expansion) {
  if (!on.wants(layer)) return;
  draw_outline(on, expansion.polygon, DrawMeaning::b);
  draw_origin(on);
  // The normal points from A to B: the way out of B - A is the other.
  on.line({}, expansion.normal * -expansion.face_depth, layer, DrawMeaning::gap);
  on.point(difference(expansion.found), layer, DrawMeaning::contact);
}

void draw(DebugDraw& on, const TraceAxis& axis, bool decides) {
  if (!on.wants(layer)) return;
  const Vec3d& along = axis.direction;
  const double middle = dot(along, on.area().center);
  const Vec3d foot = on.area().center - along * middle;
  const Vec3d aside = any_perpendicular(along) * (on.area().size * beside);
  // A half-space's interval has no end.
  const auto end = [&](double at) { return std::isfinite(at) ? at : middle + std::copysign(on.area().size, at); };
  const auto interval = [&](double lower, double upper, const Vec3d& at, DrawMeaning meaning) {
    const double from = end(lower), to = end(upper);
    if (from <= to) on.line(at + along * from, at + along * to, layer, meaning);
  };
  interval(axis.a_lower, axis.a_upper, foot - aside, decides ? DrawMeaning::a : DrawMeaning::ruled_out);
  interval(axis.b_lower, axis.b_upper, foot + aside, decides ? DrawMeaning::b : DrawMeaning::ruled_out);
  if (!decides) return;
  const double from = end(std::min(axis.a_upper, axis.b_lower)), to = end(std::max(axis.a_upper, axis.b_lower));
  on.line(foot + along * from, foot + along * to, layer, axis.overlap() >= 0 ? DrawMeaning::contact : DrawMeaning::gap);
  on.text(foot + along * ((from + to) / 2), axis.name, layer, DrawMeaning::normal);
}

void draw(DebugDraw& on, const TraceSpan& span, const Ray<double>& ray, bool decides) {
  if (!on.wants(layer)) return;
  if (!(span.enter <= span.leave)) return;
  // An open end lies at the edge of the area, or as far beyond the other end.
  const Vec3d way = normalized(ray.direction, Vec3d{});
  const double middle = dot(way, on.area().center - ray.origin);
  const double size = on.area().size;
  const double enter = std::isfinite(span.enter) ? span.enter : std::min(middle, span.leave) - size;
  const double leave = std::isfinite(span.leave) ? span.leave : std::max(middle, enter) + size;
  const Vec3d from = ray.origin + way * enter;
  on.line(from, ray.origin + way * leave, layer, decides ? DrawMeaning::a : DrawMeaning::ruled_out);
  if (!decides || !std::isfinite(span.enter)) return;
  on.point(from, layer, DrawMeaning::contact);
  if (span.normal != Vec3d{}) on.arrow(from, span.normal, layer, DrawMeaning::normal);
  on.text(from, span.name, layer, DrawMeaning::normal);
}

void draw(DebugDraw& on, const TraceCut& cut) {
  if (!on.wants(layer)) return;
  on.line(cut.from, cut.to, layer, DrawMeaning::normal);
  draw_face(on, cut.left, DrawMeaning::contact);
  for (const Vec3d& corner : cut.left) on.point(corner, layer, DrawMeaning::contact);
}

void draw(DebugDraw& on, const Trace& trace) {
  if (!on.wants(layer)) return;
  for (const TraceAxis& axis : trace.axes) draw(on, axis, axis.name == trace.winner);
  draw_face(on, trace.face_a, DrawMeaning::a);
  draw_face(on, trace.face_b, DrawMeaning::b);
  if (!trace.cuts.empty()) draw_face(on, trace.cuts.back().left, DrawMeaning::contact);
  draw_outline(on, trace.difference, DrawMeaning::ruled_out);
  if (!trace.gjk.empty()) draw(on, trace.gjk.back());
  if (!trace.epa.empty()) draw(on, trace.epa.back());
  draw_polytope(on, trace);
}

}  // namespace graze
