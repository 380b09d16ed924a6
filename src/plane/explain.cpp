#include "plane/explain.hpp"

#include <algorithm>
#include <limits>

#include "plane/nearest.hpp"

namespace graze::plane {

namespace {

struct Interval {
  double lower, upper;
};

/// The interval that a placed shape covers along a direction of the world.
template <class T>
Interval interval(const Core<T>& core, const Pose2d& pose, const Vec2d& direction) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double at = dot(pose.translation, direction);
  const Vec2d own = inverse_rotate(pose.rotation, direction);
  if (core.kind == CoreKind::half_plane) {
    // A half-plane ends along its normal, within the rounding of a rotation, and along no other direction.
    const bool along = std::abs(own.x) <= 1e-12;
    return {along && own.y < 0 ? at - core.radius : -inf, along && own.y > 0 ? at + core.radius : inf};
  }
  return {at + dot(support(core, -own).point, own) - core.radius,
          at + dot(support(core, own).point, own) + core.radius};
}

template <class T>
void add_axis(const LeafPair<T>& pair, std::string name, const Vec2d& direction, Trace& trace) {
  const Interval a = interval(pair.a, pair.pose_a, direction), b = interval(pair.b, pair.pose_b, direction);
  trace.axes.push_back({std::move(name), {direction.x, direction.y, 0}, a.lower, a.upper, b.lower, b.upper});
}

/// The normals of a core's edges, each turned so that the shapes overlap less along it. A box has the two axes of its
/// frame, whose names they bear; a piece has those of the outline, by their numbers there, and a chain its segment.
template <class T>
void add_edges(const LeafPair<T>& pair, const Core<T>& core, const Pose2d& pose, bool box, const std::string& letter,
               Trace& trace) {
  const auto add = [&](const std::string& name, const Vec2d& own, bool both_ways) {
    const Vec2d n = rotate(pose.rotation, own);
    add_axis(pair, name, letter == "A" ? n : -n, trace);
    if (!both_ways) return;
    const TraceAxis tried = trace.axes.back();
    add_axis(pair, name, letter == "A" ? -n : n, trace);
    const bool second = trace.axes.back().overlap() < tried.overlap();
    if (second)
      trace.axes.erase(trace.axes.end() - 2);
    else
      trace.axes.pop_back();
  };
  if (core.kind == CoreKind::half_plane) return add(letter + " edge 0", {0, 1}, false);
  if (core.kind != CoreKind::polygon) return;
  if (box && !core.outline) {
    add(letter + "0", {1, 0}, true);
    add(letter + "1", {0, 1}, true);
    return;
  }
  // A segment's two edges are one axis; the other runs along it.
  if (core.count == 2) {
    const Vec2d e = core.edge(0);
    if (length(e) > 0) {
      add(letter + " edge " + std::to_string(core.outline ? core.outline[0].number : 0), normalized(right(e)), true);
      add(letter + " along", normalized(e), true);
    }
    return;
  }
  if (core.count < 3) return;
  for (std::uint32_t i = 0; i < core.count; ++i)
    if (const Vec2d e = core.edge(i); length(e) > 0 && !(core.outline && !core.outline[i].outer))
      add(letter + " edge " + std::to_string(core.outline ? core.outline[i].number : i), normalized(right(e)), false);
}

template <class T>
bool is_box(const Core<T>& core) {
  return core.kind == CoreKind::polygon && core.count == 4 && core.edge(0).y == 0 && core.edge(1).x == 0 &&
         core.edge(2).y == 0 && core.edge(3).x == 0;
}

template <class T>
bool closed_form(const Core<T>& a, const Core<T>& b) {
  const auto simple = [](const Core<T>& c) {
    return c.kind == CoreKind::half_plane || (c.kind == CoreKind::polygon && c.count <= 2);
  };
  return simple(a) && simple(b);
}

template <class T>
bool has_one_sided_chain(const Shape<T>& shape) {
  if (const auto* chain = shape.template as<Chain<T>>()) return chain->sides() != ChainSides::both;
  const auto* compound = shape.template as<Compound<T>>();
  return compound && std::any_of(compound->children().begin(), compound->children().end(),
                                 [](const Placed<T>& child) { return has_one_sided_chain(child.shape); });
}

/// Names the axis that decided: the edge's whose overlap is the answer, or the normal.
void explain_winner(const Distance<double>& answer, double size, Trace& trace) {
  const auto best = std::min_element(trace.axes.begin(), trace.axes.end(),
                                     [](const TraceAxis& p, const TraceAxis& q) { return p.overlap() < q.overlap(); });
  // The axis of an edge is the answer's normal within some roundings, or corners are nearest.
  const double rounding = 1e-9 * (size + std::abs(answer.distance));
  const auto decides = [&](const TraceAxis& axis) { return std::abs(axis.overlap() + answer.distance) <= rounding; };
  trace.winner = "normal";
  trace.reason = "corners or round sides are nearest to each other: no edge's normal is the way between them";
  if (best == trace.axes.end()) return;
  if (decides(*best)) {
    trace.winner = best->name;
    trace.reason = best->name + (best->overlap() >= 0 ? " has the least overlap" : " shows the widest gap of all axes");
  } else if (best->overlap() < -answer.distance) {
    const auto way = std::find_if(trace.axes.begin(), trace.axes.end(), decides);
    if (way != trace.axes.end()) trace.winner = way->name;
    trace.reason = (way != trace.axes.end() ? way->name : "the normal") +
                   " leads out of the whole: along axes on which these pieces overlap less, others are in the way";
  }
}

}  // namespace

template <class T>
Trace explained(const LeafPair<T>& pair, const Distance<double>& answer) {
  Trace trace;
  const bool half_plane = !pair.bounded();
  const bool polygons = pair.a.kind == CoreKind::polygon && pair.b.kind == CoreKind::polygon;
  if (!half_plane) {
    trace.difference = difference_outline(pair);
    trace.rounding = pair.a.radius + pair.b.radius;
  }
  if (!half_plane && !polygons) explain_curved_search(pair, trace);
  trace.method = half_plane || closed_form(pair.a, pair.b) ? "closed form"
                 : polygons                                ? "separating axes"
                 : trace.epa.empty()                       ? "gjk"
                                                           : "gjk + epa";
  // Beyond this many vertices a picture of the steps shows nothing.
  constexpr std::uint32_t most_shown = 64;
  if (polygons && pair.a.count + pair.b.count <= most_shown) explain_search(pair, trace);
  add_edges(pair, pair.a, pair.pose_a, is_box(pair.a), "A", trace);
  add_edges(pair, pair.b, pair.pose_b, is_box(pair.b), "B", trace);
  if (answer.status == Status::unbounded) {
    trace.reason = "the half-planes are not opposite: they overlap without end";
    return trace;
  }
  explain_winner(answer, pair.size(), trace);
  add_axis(pair, "normal", answer.normal, trace);
  return trace;
}

template <class T>
void explain_missing_contacts(const Shape<T>& a, const Shape<T>& b, Trace& trace) {
  if (has_one_sided_chain(a) || has_one_sided_chain(b))
    trace.reason += "; no contacts: a chain of one side lets through what comes from behind";
}

template void explain_missing_contacts(const Shape<float>&, const Shape<float>&, Trace&);
template void explain_missing_contacts(const Shape<double>&, const Shape<double>&, Trace&);
template Trace explained(const LeafPair<float>&, const Distance<double>&);
template Trace explained(const LeafPair<double>&, const Distance<double>&);

}  // namespace graze::plane
