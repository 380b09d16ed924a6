// GJK and EPA in the plane, step by step: as textbooks have them, on the difference B - A in the world.
#include <limits>
#include <optional>

#include "graze/angles.hpp"
#include "plane/curved_search.hpp"
#include "plane/difference.hpp"
#include "plane/explain.hpp"

namespace graze::plane {

namespace {

/// The most steps, more than polygons of many vertices take; curved cores end by `search_goal`.
constexpr int most_search_steps = 200;
/// The gap between the bounds at which the search ends, relative to the size of the pair.
constexpr double search_goal = 1e-10;
/// The number of directions that sample the difference of curved cores.
constexpr int sampled_directions = 96;

/// A point of B - A with the points that it is made of.
struct DifferenceVertex {
  Vec2d a, b, point;

  TraceSupport shown() const { return {{a.x, a.y, 0}, {b.x, b.y, 0}}; }
};

Vec3d in_space(const Vec2d& v) { return {v.x, v.y, 0}; }

template <class T>
DifferenceVertex support_of(const LeafPair<T>& pair, const Vec2d& direction) {
  const auto of = [](const Core<T>& core, const Pose2d& pose, const Vec2d& d) {
    return transform(pose, support(core, inverse_rotate(pose.rotation, d)).point);
  };
  const Vec2d a = of(pair.a, pair.pose_a, -direction), b = of(pair.b, pair.pose_b, direction);
  return {a, b, b - a};
}

using Simplex = std::vector<DifferenceVertex>;

std::vector<TraceSupport> shown(const Simplex& simplex) {
  std::vector<TraceSupport> out;
  for (const DifferenceVertex& v : simplex) out.push_back(v.shown());
  return out;
}

/// The point of an edge nearest to the origin.
Vec2d nearest_on(const Vec2d& p, const Vec2d& q) {
  const Vec2d e = q - p;
  const double l2 = length_squared(e), t = l2 > 0 ? clamp(-dot(p, e) / l2, 0.0, 1.0) : 0.0;
  return t <= 0.5 ? p + e * t : q - e * (1 - t);
}

/// Reduces a simplex to the vertices that its point nearest to the origin needs, and returns that point; nothing when a
/// triangle holds the origin.
std::optional<Vec2d> reduce(Simplex& simplex) {
  if (simplex.size() == 1) return simplex[0].point;
  if (simplex.size() == 3) {
    if (cross(simplex[1].point - simplex[0].point, simplex[2].point - simplex[0].point) < 0)
      std::swap(simplex[1], simplex[2]);
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) inside = inside && cross(simplex[i].point, simplex[(i + 1) % 3].point) > 0;
    if (inside) return {};
  }
  double least_squared = std::numeric_limits<double>::infinity();
  Simplex best;
  Vec2d foot;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    const DifferenceVertex &p = simplex[i], &q = simplex[(i + 1) % simplex.size()];
    const Vec2d at = nearest_on(p.point, q.point);
    if (!(length_squared(at) < least_squared)) continue;
    least_squared = length_squared(at), foot = at;
    best = at == p.point ? Simplex{p} : at == q.point ? Simplex{q} : Simplex{p, q};
  }
  simplex = std::move(best);
  return foot;
}

/// The expanding polygon about the origin, from the last simplex of GJK.
template <class T>
void expand(const LeafPair<T>& pair, Simplex polygon, double near, Trace& trace) {
  for (const Vec2d& d : {Vec2d{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    if (polygon.size() >= 2) break;
    const DifferenceVertex v = support_of(pair, d);
    if (!(v.point == polygon[0].point)) polygon.push_back(v);
  }
  if (polygon.size() < 2) return;  // the difference is one point
  if (polygon.size() == 3 && cross(polygon[1].point - polygon[0].point, polygon[2].point - polygon[0].point) < 0)
    std::swap(polygon[1], polygon[2]);
  for (int step = 0; step < most_search_steps; ++step) {
    std::size_t edge = 0;
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2d p = polygon[i].point, e = polygon[(i + 1) % polygon.size()].point - p;
      const double l = length(e);
      if (l > 0 && cross(p, e) / l < reach) reach = cross(p, e) / l, edge = i;
    }
    const Vec2d n = normalized(right(polygon[(edge + 1) % polygon.size()].point - polygon[edge].point));
    const DifferenceVertex found = support_of(pair, n);
    const double reached = dot(found.point, n);
    // The way out is against the outside of B - A: from A to B.
    trace.epa.push_back({in_space(-n), greatest(reach, 0.0), reached, found.shown(), polygon.size(), shown(polygon)});
    if (reached - reach <= near) return;
    polygon.insert(polygon.begin() + std::ptrdiff_t(edge) + 1, found);
    trace.epa.back().faces = polygon.size();
  }
}

TraceSupport in_world(const Pose2d& pose, const GrownVertex& v) {
  const Vec2d a = transform(pose, v.a.point), b = transform(pose, v.b.point);
  return {{a.x, a.y, 0}, {b.x, b.y, 0}};
}

/// One step of the growth for the trace: those outside are GJK's, those inside EPA's.
void record(const GrowingPolygon& polygon, const GrownFoot& foot, const GrownVertex& found, const Pose2d& pose,
            Trace& trace) {
  const Vec2d n = rotate(pose.rotation, foot.normal);
  const double reached = dot(found.point, foot.normal);
  // Shown as B - A, in which a polygon of A - B runs counter-clockwise too.
  std::vector<TraceSupport> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) vertices.push_back(in_world(pose, polygon[i]));
  if (foot.inside) {
    trace.epa.push_back(
        {{n.x, n.y, 0}, foot.reach, reached, in_world(pose, found), polygon.size() + 1, std::move(vertices)});
    return;
  }
  TraceGjk step;
  step.simplex.push_back(in_world(pose, polygon[foot.edge]));
  if (foot.parameter > 0) step.simplex.push_back(in_world(pose, polygon[polygon.next(foot.edge)]));
  step.direction = {n.x, n.y, 0};
  step.found = in_world(pose, found);
  step.lower = greatest(-reached, trace.gjk.empty() ? 0.0 : trace.gjk.back().lower);
  step.upper = length(foot.point);
  step.polygon = std::move(vertices);
  trace.gjk.push_back(std::move(step));
}

}  // namespace

template <class T>
void explain_curved_search(const LeafPair<T>& pair, Trace& trace) {
  const auto seen = [&](const GrowingPolygon& polygon, const GrownFoot& foot, const GrownVertex& found) {
    record(polygon, foot, found, pair.pose_a, trace);
  };
  search_curved(pair.a, pair.b, relative(pair.pose_a, pair.pose_b), pair.size(), seen);
}

template <class T>
void explain_search(const LeafPair<T>& pair, Trace& trace) {
  const double near = search_goal * pair.size() + 8 * std::numeric_limits<double>::epsilon() *
                                                      length(pair.pose_b.translation - pair.pose_a.translation);
  Simplex simplex{support_of(pair, {0, 1})};  // any direction will do
  double lower = 0;
  for (int step = 0; step < most_search_steps; ++step) {
    const std::vector<TraceSupport> before = shown(simplex);
    const std::optional<Vec2d> foot = reduce(simplex);
    if (!foot || length(*foot) <= near) {
      // The triangle that holds the origin is the last simplex; the search for a way out goes on from it.
      trace.gjk.push_back({before, {}, {}, 0, 0});
      return expand(pair, simplex, near, trace);
    }
    const double upper = length(*foot);
    const Vec2d direction = normalized(*foot);  // from A to B
    const DifferenceVertex found = support_of(pair, -direction);
    lower = greatest(lower, dot(found.point, direction));
    trace.gjk.push_back({shown(simplex), in_space(direction), found.shown(), lower, upper});
    if (upper - lower <= near) return;
    for (const DifferenceVertex& v : simplex)
      if (v.point == found.point) return;
    simplex.push_back(found);
  }
}

template <class T>
std::vector<TraceSupport> difference_outline(const LeafPair<T>& pair) {
  std::vector<TraceSupport> out;
  if (pair.a.kind == CoreKind::polygon && pair.b.kind == CoreKind::polygon) {
    const auto add = [&](std::uint32_t i, std::uint32_t j) {
      out.push_back(
          {in_space(transform(pair.pose_a, pair.a.vertex(i))), in_space(transform(pair.pose_b, pair.b.vertex(j)))});
    };
    if (pair.a.count == 1 && pair.b.count == 1) add(0, 0);
    for_each_difference_edge(pair.a, pair.b, relative(pair.pose_a, pair.pose_b),
                             [&](const DifferenceEdge& e) { add(e.i, e.j); });
    return out;
  }
  for (int i = 0; i < sampled_directions; ++i) {
    const auto [cosine, sine] = cosine_sine(6.283185307179586 * i / sampled_directions);
    const TraceSupport p = support_of(pair, {cosine, sine}).shown();
    if (out.empty() || !(out.back().a == p.a) || !(out.back().b == p.b)) out.push_back(p);
  }
  return out;
}

template void explain_curved_search(const LeafPair<float>&, Trace&);
template void explain_curved_search(const LeafPair<double>&, Trace&);
template void explain_search(const LeafPair<float>&, Trace&);
template void explain_search(const LeafPair<double>&, Trace&);
template std::vector<TraceSupport> difference_outline(const LeafPair<float>&);
template std::vector<TraceSupport> difference_outline(const LeafPair<double>&);

}  // namespace graze::plane
