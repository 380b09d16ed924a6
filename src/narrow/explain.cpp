#include "narrow/explain.hpp"

#include <algorithm>

#include "narrow/core/segment_box.hpp"
#include "narrow/explain_faces.hpp"
#include "narrow/explain_search.hpp"
#include "narrow/general.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/sat/polyhedral_pair.hpp"
#include "narrow/sat/reference_axis.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

template <class T>
double radius_of(const Shape<T>& shape) {
  return static_cast<double>(rounding_radius(shape));
}

template <class T>
std::optional<BoxCore<double>> box_core(const Shape<T>& shape) {
  std::optional<BoxCore<double>> core;
  shape.visit([&](const auto& c) {
    if constexpr (std::is_same_v<decltype(core_of(c)), BoxCore<T>>) core = converted<double>(core_of(c));
  });
  return core;
}

template <class T>
std::optional<SegmentCore<double>> segment_core(const Shape<T>& shape) {
  std::optional<SegmentCore<double>> core;
  shape.visit([&](const auto& c) {
    if constexpr (std::is_same_v<decltype(core_of(c)), SegmentCore<T>>)
      if (has_core(c)) core = converted<double>(core_of(c));
  });
  return core;
}

/// Traces a box's three axes and their products with a segment, in the box's frame. `box_name` and `segment_name` are
/// their letters in the query.
void trace_segment_box(const Vec3d& half, const Segment<double>& segment, const std::string& box_name,
                       const std::string& segment_name, Trace& trace) {
  visit_axes(half, segment, [&](const Vec3d& n, bool valid, std::size_t axis, bool edge) {
    if (!valid) return;
    const double along = dot(n, (segment.a + segment.b) * 0.5);
    const Vec3d toward = along < 0 ? -n : n;
    const double reach = dot(abs(n), half), from = dot(toward, segment.a), to = dot(toward, segment.b);
    std::string name = numbered(box_name, axis);
    if (edge) name = name + "×" + segment_name;
    trace.axes.push_back({name, toward, -reach, reach, least(from, to), greatest(from, to)});
  });
}

bool overlaps_less(const TraceAxis& p, const TraceAxis& q) { return p.overlap() < q.overlap(); }

/// Exchanges A and B in the axes.
void mirror(std::vector<TraceAxis>& axes) {
  for (TraceAxis& axis : axes)
    axis = {axis.name, -axis.direction, -axis.b_upper, -axis.b_lower, -axis.a_upper, -axis.a_lower};
}

/// Moves the axes from A's frame to the world.
void move(std::vector<TraceAxis>& axes, const Posed& pose) {
  for (TraceAxis& axis : axes) {
    axis.direction = rotate(pose.rotation, axis.direction);
    const double moved = dot(pose.translation, axis.direction);
    for (double* end : {&axis.a_lower, &axis.a_upper, &axis.b_lower, &axis.b_upper}) *end += moved;
  }
}

void widen(std::vector<TraceAxis>& axes, double radius_a, double radius_b) {
  for (TraceAxis& axis : axes) {
    axis.a_lower -= radius_a, axis.a_upper += radius_a;
    axis.b_lower -= radius_b, axis.b_upper += radius_b;
  }
}

/// The extent of a shape along a direction of the world.
template <class T>
double furthest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& direction) {
  if (shape.template as<HalfSpace<T>>()) {
    const Vec3<T> up = rotate(pose.rotation, Vec3<T>{T(0), T(1), T(0)});
    const bool along = dot(up, direction) > T(0.5);
    return along ? static_cast<double>(dot(pose.translation, direction) + shape.rounding())
                 : std::numeric_limits<double>::infinity();
  }
  const Vec3<T> point = support(shape, rotate(conjugate(pose.rotation), direction));
  return static_cast<double>(dot(transform(pose, point), direction));
}

/// Puts a sentence before the reason that is there.
void add_reason(const std::string& sentence, Trace& trace) {
  trace.reason = trace.reason.empty() ? sentence : sentence + "; " + trace.reason;
}

/// Writes the intervals of both shapes, with their rounding, on every separating axis of the pair: boxes' fifteen,
/// other polyhedra's faces and crossing edges, the six of a box and a segment. Nothing for other pairs. Returns the
/// name of the axis along which the shapes overlap least.
template <class T>
std::string explain_axes(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         Trace& trace) {
  const Posed frame_a = in_double(pose_a), frame_b = in_double(pose_b);
  const auto box_a = box_core(a), box_b = box_core(b);
  const auto segment_a = segment_core(a), segment_b = segment_core(b);
  const auto moved = [](const SegmentCore<double>& core, const Posed& pose) {
    return Segment<double>{transform(pose, core.segment.a), transform(pose, core.segment.b)};
  };
  std::string best;
  if (has_separating_axes(a, b)) {
    const Posed b_in_a = relative(frame_a, frame_b);
    const PolyhedralPair pair(a, b, b_in_a);
    best = pair.name(pair.all_axes().best(noise_of(a, b, b_in_a.translation)));
    for (const auto& [axis, a_lower, a_upper, b_lower, b_upper] : pair.intervals())
      trace.axes.push_back({pair.name(axis), axis.normal, a_lower, a_upper, b_lower, b_upper});
    move(trace.axes, frame_a);
  } else if (box_a && segment_b) {
    trace_segment_box(box_a->half, moved(*segment_b, relative(frame_a, frame_b)), "A", "B", trace);
    move(trace.axes, frame_a);
  } else if (segment_a && box_b) {
    trace_segment_box(box_b->half, moved(*segment_a, relative(frame_b, frame_a)), "B", "A", trace);
    mirror(trace.axes);
    move(trace.axes, frame_b);
  }
  widen(trace.axes, radius_of(a), radius_of(b));
  if (best.empty() && !trace.axes.empty())
    best = std::min_element(trace.axes.begin(), trace.axes.end(), overlaps_less)->name;
  return best;
}

/// Writes the axis of the answer, "normal", for any pair.
template <class T>
void explain_normal(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, Trace& trace) {
  trace.axes.push_back({"normal", converted<double>(normal), -furthest(a, pose_a, -normal), furthest(a, pose_a, normal),
                        -furthest(b, pose_b, -normal), furthest(b, pose_b, normal)});
}

/// The overlap along an axis, and the rounding that numbers in T leave in it.
struct ShownOverlap {
  double overlap, rounding;
};
template <class T>
ShownOverlap shown_overlap(const TraceAxis& axis) {
  double greatest_end = 0;
  for (const double end : {axis.a_lower, axis.a_upper, axis.b_lower, axis.b_upper})
    if (std::isfinite(end)) greatest_end = greatest(greatest_end, std::abs(end));
  // An end is a product with a unit vector, which is rounded itself, in a frame that is.
  constexpr double roundings = 16;
  return {axis.overlap(), roundings * static_cast<double>(std::numeric_limits<T>::epsilon()) * greatest_end};
}

/// Names the axis that decided, and why: the best of the shapes' own, or "normal", the last one written, where the
/// shapes overlap less along it than along any other. A winner that is named already stays.
template <class T>
void explain_winner(const std::string& best, bool apart, Trace& trace) {
  const bool has_normal = !trace.axes.empty() && trace.axes.back().name == "normal";
  std::string winner = best;
  if (has_normal && !best.empty() && trace.winner.empty()) {
    const auto own = std::find_if(trace.axes.begin(), trace.axes.end(), [&](auto& axis) { return axis.name == best; });
    const ShownOverlap least = shown_overlap<T>(*own), along = shown_overlap<T>(trace.axes.back());
    if (along.overlap < least.overlap - least.rounding - along.rounding) winner = "normal";
  }
  if (winner == "normal")
    add_reason(
        "corners or round sides are nearest to each other: no axis of their faces or edges is the way between them",
        trace);
  else if (!winner.empty())
    add_reason(winner + (apart ? " shows the widest gap of all axes" : " has the least overlap"), trace);
  if (trace.winner.empty()) trace.winner = !winner.empty() ? winner : has_normal ? "normal" : "";
}

/// Writes the normal of the distance for shapes that are apart though all axes show an overlap, and names the winner.
template <class T>
void explain_winner_without_normal(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                   const std::string& best, Trace& trace) {
  if (best.empty()) return;
  const auto least = std::min_element(trace.axes.begin(), trace.axes.end(), overlaps_less);
  bool apart = least->overlap() < 0;
  if (!apart) {
    const Distance<T> nearest = convex_distance(a, pose_a, b, pose_b);
    apart = nearest.distance > T(0);
    if (apart) explain_normal(a, pose_a, b, pose_b, nearest.normal, trace);
  }
  explain_winner<T>(best, apart, trace);
}

/// Exchanges A and B in the steps of GJK and EPA.
void mirror(Trace& trace) {
  const auto swap_ends = [](TraceSupport& p) { std::swap(p.a, p.b); };
  for (TraceGjk& step : trace.gjk) {
    for (TraceSupport& p : step.simplex) swap_ends(p);
    step.direction = -step.direction;
    swap_ends(step.found);
  }
  for (TraceEpa& step : trace.epa) {
    step.normal = -step.normal;
    swap_ends(step.found);
  }
  for (TraceSupport& p : trace.polytope) swap_ends(p);
  for (auto& t : trace.triangles) std::swap(t[1], t[2]);  // the difference is mirrored at the origin
}

template <class T>
bool are_boxes(const Shape<T>& a, const Shape<T>& b) {
  return box_core(a) && box_core(b);
}

/// Names the method by which the distance of two shapes in order was found.
template <class T>
void explain_ordered_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                              const Distance<T>& answer, Trace& trace) {
  const bool special = special_distance(a, pose_a, b, pose_b).has_value();
  if (special && !are_boxes(a, b)) {
    trace.method = "closed form";
  } else if (special && answer.distance + rounding_radius(a) + rounding_radius(b) <= T(0)) {
    trace.method = "separating axes";
  } else {
    explain_distance_search(a, pose_a, b, pose_b, trace);
  }
}

/// Names the method of the overlap test of two shapes in order.
template <class T>
void explain_ordered_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             Trace& trace) {
  if (special_overlap(a, pose_a, b, pose_b))
    trace.method = has_separating_axes(a, b) ? "separating axes" : "closed form";
  else if (overlaps_by_distance_alone(a, b))
    explain_ordered_distance(a, pose_a, b, pose_b, convex_distance(a, pose_a, b, pose_b), trace);
  else
    explain_overlap_search(a, pose_a, b, pose_b, trace);
}

/// Calls `f(a, pose_a, b, pose_b)` with the shapes in the order of the list of shapes, and mirrors the trace back.
template <class T, class F>
void in_order(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace& trace, F&& f) {
  if (!against_order(a, b)) return f(a, pose_a, b, pose_b);
  f(b, pose_b, a, pose_a);
  mirror(trace);
}

/// Whether a manifold's points belong to one of the separating axes, or it has none since one separates the shapes by
/// more than the margin. Names the axis and the reason for the choice.
template <class T>
bool explain_reference_axis(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            T margin, const Manifold<T>& answer, Trace& trace) {
  if (!has_separating_axes(a, b)) return false;
  const Posed frame = in_double(pose_a), b_in_a = relative(frame, in_double(pose_b));
  const PolyhedralPair pair(a, b, b_in_a);
  const SeparatingAxes axes = pair.all_axes();
  const double noise = noise_of(a, b, b_in_a.translation);
  const SeparatingAxis& best = axes.best(noise);
  if (answer.points.empty()) return best.separation - radius_of(a) - radius_of(b) > static_cast<double>(margin);
  const double smaller = least(Side<T>(a, Posed{}).size(), Side<T>(b, Posed{}).size());
  const SeparatingAxis& axis = reference_axis(axes, smaller);
  // The answer's normal is rounded to T; the axis of two nearly parallel edges differs by more.
  const Vec3d normal = rotate(frame.rotation, axis.normal);
  if (length(normal - converted<double>(answer.normal)) >
      std::sqrt(static_cast<double>(std::numeric_limits<T>::epsilon())))
    return false;
  trace.winner = pair.name(axis);
  if (&axis != &best)
    trace.reason = "the best axis of a face is nearly as good and is taken: faces hold contacts steadier than edges";
  return true;
}

}  // namespace

template <class T>
void explain_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                      const Distance<T>& answer, Trace& trace) {
  in_order(a, pose_a, b, pose_b, trace, [&](const auto&... pair) { explain_ordered_distance(pair..., answer, trace); });
  const std::string best = explain_axes(a, pose_a, b, pose_b, trace);
  explain_normal(a, pose_a, b, pose_b, answer.normal, trace);
  explain_winner<T>(best, answer.distance > T(0), trace);
}

template <class T>
void explain_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace& trace) {
  in_order(a, pose_a, b, pose_b, trace, [&](const auto&... pair) { explain_ordered_overlap(pair..., trace); });
  const std::string best = explain_axes(a, pose_a, b, pose_b, trace);
  explain_winner_without_normal(a, pose_a, b, pose_b, best, trace);
}

template <class T>
void explain_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                      const Manifold<T>& answer, Trace& trace) {
  if (explain_reference_axis(a, pose_a, b, pose_b, margin, answer, trace)) {
    trace.method = "separating axes";
  } else {
    const Distance<T> nearest = convex_distance(a, pose_a, b, pose_b);
    in_order(a, pose_a, b, pose_b, trace,
             [&](const auto&... pair) { explain_ordered_distance(pair..., nearest, trace); });
  }
  const std::string best = explain_axes(a, pose_a, b, pose_b, trace);
  if (answer.points.empty()) return explain_winner_without_normal(a, pose_a, b, pose_b, best, trace);
  explain_normal(a, pose_a, b, pose_b, answer.normal, trace);
  const auto apart = [](const ContactPoint<T>& p) { return p.distance > T(0); };
  explain_winner<T>(best, std::all_of(answer.points.begin(), answer.points.end(), apart), trace);
  explain_faces(a, pose_a, b, pose_b, answer, trace);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void explain_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, const Distance<T>&, \
                                 Trace&);                                                                              \
  template void explain_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace&);             \
  template void explain_contacts(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T,                  \
                                 const Manifold<T>&, Trace&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
