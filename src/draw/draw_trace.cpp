// The drawing of a query's steps.
#include <algorithm>

#include "graze/draw.hpp"

namespace graze {

namespace {

constexpr DrawLayer layer = DrawLayer::trace;

/// The distance between intervals that are drawn beside each other, in parts of the area.
constexpr double beside = 1.0 / 60;

void draw_axis(DebugDraw& on, const TraceAxis& axis, bool winner) {
  const Vec3d& along = axis.direction;
  const Vec3d foot = on.area().center - along * dot(along, on.area().center);
  const Vec3d aside = any_perpendicular(along) * (on.area().size * beside);
  const auto interval = [&](double lower, double upper, const Vec3d& at, DrawMeaning meaning) {
    // The interval of a half-space has no end.
    const double near = dot(along, on.area().center) - on.area().size;
    const double from = std::max(lower, near), to = std::min(upper, near + 2 * on.area().size);
    if (from <= to) on.line(at + along * from, at + along * to, layer, meaning);
  };
  interval(axis.a_lower, axis.a_upper, foot - aside, winner ? DrawMeaning::a : DrawMeaning::ruled_out);
  interval(axis.b_lower, axis.b_upper, foot + aside, winner ? DrawMeaning::b : DrawMeaning::ruled_out);
  if (!winner) return;
  const double from = std::min(axis.a_upper, axis.b_lower), to = std::max(axis.a_upper, axis.b_lower);
  on.line(foot + along * from, foot + along * to, layer, axis.overlap() >= 0 ? DrawMeaning::contact : DrawMeaning::gap);
  on.text(foot + along * ((from + to) / 2), axis.name, layer, DrawMeaning::normal);
}

Vec3d difference(const TraceSupport& support) { return support.b - support.a; }

void draw_outline(DebugDraw& on, const std::vector<TraceSupport>& polygon, DrawMeaning meaning) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1; ++i)
    on.line(difference(polygon[i]), difference(polygon[(i + 1) % polygon.size()]), layer, meaning);
}

void draw_face(DebugDraw& on, const std::vector<Vec3d>& corners, DrawMeaning meaning) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    on.line(corners[i], corners[(i + 1) % corners.size()], layer, meaning);
}

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
  on.point(difference(iteration.found), layer, DrawMeaning::contact);
  on.arrow({}, normalized(iteration.direction), layer, DrawMeaning::normal);
}

void draw(DebugDraw& on, const TraceEpa& expansion) {
  if (!on.wants(layer)) return;
  draw_outline(on, expansion.polygon, DrawMeaning::b);
  draw_origin(on);
  on.line({}, expansion.normal * expansion.face_depth, layer, DrawMeaning::gap);
  on.point(difference(expansion.found), layer, DrawMeaning::contact);
}

void draw(DebugDraw& on, const Trace& trace) {
  if (!on.wants(layer)) return;
  for (const TraceAxis& axis : trace.axes) draw_axis(on, axis, axis.name == trace.winner);
  draw_face(on, trace.face_a, DrawMeaning::a);
  draw_face(on, trace.face_b, DrawMeaning::b);
  if (!trace.cuts.empty()) draw_face(on, trace.cuts.back().left, DrawMeaning::contact);
  draw_outline(on, trace.difference, DrawMeaning::ruled_out);
  if (!trace.gjk.empty()) draw(on, trace.gjk.back());
  if (!trace.epa.empty()) draw(on, trace.epa.back());
  draw_polytope(on, trace);
}

}  // namespace graze
