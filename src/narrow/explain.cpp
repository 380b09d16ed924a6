#include "narrow/explain.hpp"

#include <algorithm>

#include "narrow/pairs/capsule_box.hpp"
#include "narrow/polyhedral_pair.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

template <class T>
double radius_of(const Shape<T>& shape) {
  return shape.visit([&](const auto& c) { return static_cast<double>(rounding_radius(c, shape.margin())); });
}

template <class T>
std::optional<BoxCore<double>> box_core(const Shape<T>& shape) {
  std::optional<BoxCore<double>> core;
  shape.visit([&](const auto& c) {
    if constexpr (std::is_same_v<decltype(core_of(c)), BoxCore<T>>) core = cast<double>(core_of(c));
  });
  return core;
}

template <class T>
std::optional<SegmentCore<double>> segment_core(const Shape<T>& shape) {
  std::optional<SegmentCore<double>> core;
  shape.visit([&](const auto& c) {
    if constexpr (std::is_same_v<decltype(core_of(c)), SegmentCore<T>>)
      if (has_core(c)) core = cast<double>(core_of(c));
  });
  return core;
}

/// A box's three axes and their products with a segment, the segment seen from the box. `box_name` and `segment_name`
/// are their letters in the question.
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
  const auto best = std::min_element(trace.axes.begin(), trace.axes.end(),
                                     [](const TraceAxis& p, const TraceAxis& q) { return p.overlap() < q.overlap(); });
  trace.winner = best->name;
  trace.reason = best->name + (best->overlap() > 0 ? " has the least overlap" : " shows the widest gap of all axes");
}

/// The same axes with A and B in each other's place.
void mirror(std::vector<TraceAxis>& axes) {
  for (TraceAxis& axis : axes)
    axis = {axis.name, -axis.direction, -axis.b_upper, -axis.b_lower, -axis.a_upper, -axis.a_lower};
}

/// From A's frame to the world.
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

/// How far a shape reaches along a direction of the world.
template <class T>
double furthest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& direction) {
  if (shape.template as<HalfSpace<T>>()) {
    const Vec3<T> up = rotate(pose.rotation, Vec3<T>{T(0), T(1), T(0)});
    const bool along = dot(up, direction) > T(0.5);
    return along ? static_cast<double>(dot(pose.translation, direction) + shape.margin())
                 : std::numeric_limits<double>::infinity();
  }
  const Vec3<T> point = support(shape, rotate(conjugate(pose.rotation), direction));
  return static_cast<double>(dot(transform(pose, point), direction));
}

}  // namespace

template <class T>
void explain_axes(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace& trace) {
  const Posed frame_a = in_double(pose_a), frame_b = in_double(pose_b);
  const auto box_a = box_core(a), box_b = box_core(b);
  const auto segment_a = segment_core(a), segment_b = segment_core(b);
  const auto moved = [](const SegmentCore<double>& core, const Posed& pose) {
    return Segment<double>{transform(pose, core.segment.a), transform(pose, core.segment.b)};
  };
  if (has_separating_axes(a, b)) {
    const Posed b_in_a = relative(frame_a, frame_b);
    const PolyhedralPair pair(a, b, b_in_a);
    const SeparatingAxis best = pair.all_axes(trace).best(noise_of(a, b, b_in_a.translation));
    const bool apart = best.separation > radius_of(a) + radius_of(b);
    std::string reason = pair.name(best) + (apart ? " shows the widest gap of all axes" : " has the least overlap");
    if (!trace.reason.empty()) reason += "; " + trace.reason;
    trace.reason = reason;
    if (trace.winner.empty()) trace.winner = pair.name(best);
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
}

template <class T>
void explain_normal(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, Trace& trace) {
  if (trace.winner.empty()) trace.winner = "normal";
  trace.axes.push_back({"normal", cast<double>(normal), -furthest(a, pose_a, -normal), furthest(a, pose_a, normal),
                        -furthest(b, pose_b, -normal), furthest(b, pose_b, normal)});
}

void mirror(Trace& trace) {
  trace.winner.clear();  // its name counts from the other side
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
  for (auto& t : trace.triangles) std::swap(t[1], t[2]);  // the difference is turned about the origin
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void explain_axes(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, Trace&);                \
  template void explain_normal(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, const Vec3<T>&,       \
                               Trace&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
