#include "plane/on_outline.hpp"

#include <limits>

namespace graze::plane {

namespace {

using Kind = OutlineVertex::Kind;

/// The rounding of a unit vector that came from a few others.
constexpr double unit_rounding = 16 * std::numeric_limits<double>::epsilon();

bool is_edge(std::uint32_t feature) { return (feature >> graze::detail::feature_number_bits) == 2; }

/// The vertex of a feature or the one where its edge begins. Numbers wrap in pieces of more than 16,384 vertices, so
/// it is the one of that name that lies furthest along `n`.
template <class T>
std::uint32_t vertex_of(const Core<T>& core, std::uint32_t feature, const Vec2d& n) {
  constexpr std::uint32_t period = 1u << graze::detail::feature_number_bits;
  std::uint32_t best = feature & (period - 1);
  for (std::uint32_t i = best + period; i < core.count; i += period)
    if (dot(core.vertex(i), n) > dot(core.vertex(best), n)) best = i;
  return best;
}

/// The error of the normal of nearest points that are right within the rounding of the sizes and of what lies between
/// the bodies, as those of polygons are.
double normal_rounding(const Pose2d& b_in_a, const Nearest& found, double size) {
  const double apart = std::abs(found.distance);
  if (!(apart > 0)) return 1;
  return greatest(unit_rounding, unit_rounding * (size + length(b_in_a.translation)) / apart);
}

/// The error of the normal of any nearest points.
template <class T>
double normal_error(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double size) {
  const double apart = std::abs(found.distance), of_points = normal_rounding(b_in_a, found, size);
  if (!(apart > 0)) return 1;
  if (a.kind == CoreKind::polygon && b.kind == CoreKind::polygon) return of_points;
  // The distance of a curved core is right within `error`. The point v that was found and the nearest one w of a convex
  // set make no acute angle at w, so |v - w|^2 <= v^2 - w^2 <= 2 |v| error, and seen from the origin they are no
  // further apart than the square root of 2 error / |v|, up to the square of that.
  const double error = accuracy(a, b, b_in_a, size) + found.error;
  return greatest(of_points, least(std::sqrt(2 * error / apart), 1.0));
}

/// Whether the unit vector `n`, known to within `off`, is a normal of the outline at vertex i.
bool has_normal(const OutlineVertex& v, const Vec2d& n, double off) {
  const bool before = dot(n, v.arriving) >= -off, after = dot(n, v.leaving) <= off;
  switch (v.kind) {
  case Kind::convex: return before && after;
  case Kind::reflex: return false;
  case Kind::first: return after;
  case Kind::last: return before;
  }
  return false;
}

/// Whether a core's feature has `n` (unit, outward, in its frame) on the outline. Of a segment both edges are one
/// feature, and the normal says which.
template <class T>
bool feature_has_normal(const Core<T>& core, std::uint32_t feature, const Vec2d& n, double off) {
  if (!core.outline) return true;
  const std::uint32_t i = vertex_of(core, feature, n);
  if (!is_edge(feature)) return has_normal(core.outline[i], n, off);
  if (core.count > 2) return core.outline[i].outer;
  return core.outline[dot(right(core.edge(0)), n) > 0 ? 0 : 1].outer;
}

}  // namespace

template <class T>
bool on_cut(const Core<T>& core, std::uint32_t feature, const Vec2d& n) {
  return core.outline && !core.chain && is_edge(feature) && !core.outline[vertex_of(core, feature, n)].outer;
}

namespace {

/// Whether `n`, known to within `off`, is the normal of one of the outline's edges that end at vertex i. The search for
/// the nearest points of curved cores names an edge by its nearer end, which may be a reflex vertex.
template <class T>
bool beside_has_normal(const Core<T>& core, std::uint32_t feature, const Vec2d& n, double off) {
  if (!core.outline || is_edge(feature)) return false;
  const std::uint32_t i = vertex_of(core, feature, n);
  for (const std::uint32_t k : {i, core.previous(i)}) {
    const OutlineVertex& v = core.outline[k];
    if (v.outer && std::abs(dot(v.leaving, n)) <= off && dot(right(v.leaving), n) > 0) return true;
  }
  return false;
}

/// Whether a piece lies within the line through its vertex i that has the outward normal `n`.
template <class T>
bool lies_within(const Core<T>& core, std::uint32_t i, const Vec2d& n) {
  const Vec2d at = core.vertex(i);
  return dot(core.vertex(core.next(i)) - at, n) <= 0 && dot(core.vertex(core.previous(i)) - at, n) <= 0;
}

/// Calls `f(n, i, edge, own)` with the outward normals of a core's outline at its edges and beside them: a vertex on
/// the line with that normal, the core's own edge there, and whether the normal is that edge's. An edge's own normal
/// comes once. At a reflex vertex of a solid the edges beside a piece bound it as well where they end at its tip: what
/// comes in over a valley's bottom is pushed out by the slopes, not by what bounds the piece on its far side.
template <class T, class F>
void for_each_normal(const Core<T>& core, F&& f) {
  if (core.kind != CoreKind::polygon || core.count < 2) return;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    if (!core.outline) {
      if (const Vec2d e = core.edge(i); e.x != 0 || e.y != 0) f(normalized(right(e)), i, i, true);
      continue;
    }
    const OutlineVertex& v = core.outline[i];
    const OutlineVertex& before = core.outline[core.previous(i)];
    const Vec2d leaving = right(v.leaving), arriving = right(v.arriving);
    if (v.outer) f(leaving, i, i, true);
    if (v.kind != Kind::convex && (v.kind != Kind::reflex || core.chain)) continue;
    const auto bounds = [&](const Vec2d& n) { return v.kind == Kind::convex || lies_within(core, i, n); };
    const bool same_leaving = before.outer && v.leaving == before.leaving, same_arriving = v.arriving == v.leaving;
    if (!v.outer && !same_leaving && bounds(leaving)) f(leaving, i, core.previous(i), false);
    if (!before.outer && !(v.outer && same_arriving) && bounds(arriving)) f(arriving, i, i, false);
  }
}

/// The distance along an axis, of `b` beyond the line through `on_a`.
struct Axis {
  double gap = -std::numeric_limits<double>::infinity();
  OnOutline points{};
};

/// Whether a core has an inside on whose far side `other` must not come out: a piece of a solid polygon, or a polygon
/// that meets no line. What a line's segment leaves no normal for has a contact with the next segment.
template <class T>
bool is_solid(const Core<T>& core, const Core<T>& other) {
  return core.kind == CoreKind::polygon && core.count > 2 && !core.chain && (core.outline || !other.chain);
}

/// Whether a core, whose points furthest along `n` (unit, in its frame) are `gap` beyond an edge against whose outward
/// normal that is, lies wholly behind the edge, which a rounding of `radius` moves outwards.
template <class T>
bool is_behind(const Core<T>& core, const Vec2d& n, double gap, double radius) {
  const double width = dot(support(core, n).point - support(core, -n).point, n);
  return gap + width + core.radius < radius;
}

/// Whether the normal, known to within `off`, belongs to both outlines.
template <class T>
bool on_outlines_within(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double off) {
  const bool searched = a.kind != CoreKind::polygon || b.kind != CoreKind::polygon;
  const auto has_normal_at = [&](const Core<T>& core, std::uint32_t feature, const Vec2d& n) {
    return feature_has_normal(core, feature, n, off) || (searched && beside_has_normal(core, feature, n, off));
  };
  return has_normal_at(a, found.a.feature, found.normal) &&
         has_normal_at(b, found.b.feature, inverse_rotate(b_in_a.rotation, -found.normal));
}

}  // namespace

template <class T>
bool on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double size) {
  if (!a.outline && !b.outline) return true;
  return on_outlines_within(a, b, b_in_a, found, normal_error(a, b, b_in_a, found, size));
}

template <class T>
Doubt doubt(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found, double size) {
  const double rounding = normal_rounding(b_in_a, found, size), possible = normal_error(a, b, b_in_a, found, size);
  if (on_outlines_within(a, b, b_in_a, found, rounding)) return {0, possible};
  // To within a factor, which is enough for an order.
  constexpr double step = 1.0 / 8;
  double taken = possible;
  while (taken > rounding && on_outlines_within(a, b, b_in_a, found, taken * step)) taken *= step;
  return {taken, possible};
}

template <class T>
std::optional<OnOutline> least_overlap_on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a) {
  // No point of a half-plane is furthest along a normal of the other.
  if (a.kind == CoreKind::half_plane || b.kind == CoreKind::half_plane) return {};
  Axis best;
  for_each_normal(a, [&](const Vec2d& n, std::uint32_t i, std::uint32_t edge, bool is_own) {
    const Vec2d toward_a = inverse_rotate(b_in_a.rotation, -n);
    const CorePoint deepest = support(b, toward_a);
    if (!feature_has_normal(b, deepest.feature, toward_a, unit_rounding)) return;
    const Vec2d point = transform(b_in_a, deepest.point);
    const double gap = dot(point - a.vertex(i), n);
    if (!(gap > best.gap)) return;
    best.gap = gap;
    best.points.normal = n;
    best.points.a = {point - n * gap, side_feature(edge)};
    best.points.b = {point, deepest.feature};
    best.points.of_neighbour = a.outline && !is_own;
    best.points.behind_a = is_solid(a, b) && is_behind(b, toward_a, gap, a.radius);
    best.points.behind_b = false;
  });
  for_each_normal(b, [&](const Vec2d& own, std::uint32_t j, std::uint32_t edge, bool is_own) {
    const Vec2d n = -rotate(b_in_a.rotation, own);
    const CorePoint deepest = support(a, n);
    if (!feature_has_normal(a, deepest.feature, n, unit_rounding)) return;
    const double gap = dot(transform(b_in_a, b.vertex(j)) - deepest.point, n);
    if (!(gap > best.gap)) return;
    best.gap = gap;
    best.points.normal = n;
    best.points.a = deepest;
    best.points.b = {deepest.point + n * gap, side_feature(edge)};
    best.points.of_neighbour = b.outline && !is_own;
    best.points.behind_a = false;
    best.points.behind_b = is_solid(b, a) && is_behind(a, n, gap, b.radius);
  });
  if (best.gap == -std::numeric_limits<double>::infinity()) return {};
  best.points.distance = best.gap;
  return best.points;
}

template <class T>
std::optional<OnOutline> nearest_on_outlines(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                             const Nearest& found, double size) {
  if (!a.outline && !b.outline) return OnOutline{found};
  // The axes decide about cores so near to each other that rounding takes more than a few digits of the normal.
  constexpr double few_digits = 65536 * unit_rounding;
  const bool apart = found.distance > few_digits * (size + length(b_in_a.translation));
  const bool settled = apart || a.kind != CoreKind::polygon || b.kind != CoreKind::polygon;
  if (settled && on_outlines(a, b, b_in_a, found, size)) return OnOutline{found};
  if (apart) return {};
  return least_overlap_on_outlines(a, b, b_in_a);
}

template <class T>
Nearest nearest_on_outline(const Core<T>& piece, const Vec2d& from, bool inside) {
  double squared = std::numeric_limits<double>::infinity();
  Nearest found;
  const double side = inside ? -1 : 1;
  for (std::uint32_t k = 0; k < piece.pieces->size(); ++k) {
    const std::span<const Vec2<T>> vertices = piece.pieces->vertices(k);
    const OutlineVertex* outline = piece.pieces->outline(k);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (!outline[i].outer) continue;
      const Vec2d start = plane::converted<double>(vertices[i]),
                  edge = plane::converted<double>(vertices[i + 1 == vertices.size() ? 0 : i + 1]) - start;
      const double t = clamp(dot(from - start, edge) / length_squared(edge), 0.0, 1.0);
      const Vec2d point = start + edge * t, way = point - from;
      if (!(length_squared(way) < squared)) continue;
      squared = length_squared(way);
      const Vec2d outward = right(outline[i].leaving);
      const bool inner = t > 0 && t < 1;
      found.normal = inner ? outward : normalized(way * -side, outward);
      found.distance = side * (inner ? greatest(-side * dot(way, outward), 0.0) : length(way));
      found.a = {point, side_feature(outline[i].number)};
    }
  }
  return found;
}

#define GRAZE_PLANE_OUTLINES(T)                                                                                        \
  template bool on_outlines(const Core<T>&, const Core<T>&, const Pose2d&, const Nearest&, double);                    \
  template bool on_cut(const Core<T>&, std::uint32_t, const Vec2d&);                                                   \
  template Doubt doubt(const Core<T>&, const Core<T>&, const Pose2d&, const Nearest&, double);                         \
  template std::optional<OnOutline> least_overlap_on_outlines(const Core<T>&, const Core<T>&, const Pose2d&);          \
  template std::optional<OnOutline> nearest_on_outlines(const Core<T>&, const Core<T>&, const Pose2d&, const Nearest&, \
                                                        double);                                                       \
  template Nearest nearest_on_outline(const Core<T>&, const Vec2d&, bool);
GRAZE_PLANE_OUTLINES(float)
GRAZE_PLANE_OUTLINES(double)
#undef GRAZE_PLANE_OUTLINES

}  // namespace graze::plane
