#include "query/explain_ray.hpp"

#include <algorithm>

#include "query/shape_rays.hpp"

#include "rays/explain.hpp"

namespace graze {

namespace {

using namespace shape_rays;
using rays::Made;

/// A hierarchy that counts the nodes visited.
template <class Hierarchy>
struct CountedHierarchy {
  using Ref = typename Hierarchy::Ref;
  using Children = typename Hierarchy::Children;
  static constexpr std::size_t width = Hierarchy::width;

  const Hierarchy& hierarchy;
  std::size_t& nodes;

  bool empty() const { return hierarchy.empty(); }
  auto root() const { return hierarchy.root(); }
  auto bounds() const { return hierarchy.bounds(); }
  bool leaf(const Ref& ref) const { return hierarchy.leaf(ref); }
  void children(const Ref& ref, Children& out) const {
    ++nodes;
    hierarchy.children(ref, out);
  }
  template <class F>
  bool each_piece(const Ref& ref, F& f) const {
    return hierarchy.each_piece(ref, f);
  }
};

/// Counts the nodes and pieces of a tree that a ray meets before `end`.
template <class Hierarchy>
void count_visits(const Hierarchy& hierarchy, const LocalRay& ray, double end, Trace& trace) {
  const CountedHierarchy<Hierarchy> counted{hierarchy, trace.nodes};
  visit_ray(
      counted, ray.origin, rays::inverse_of(ray.direction), [&] { return end; }, [&](std::uint32_t) { ++trace.pieces; },
      ray.begin, ray.blur);
}

/// Names the span that decides: the last to be entered of all, or the first of any; and its consequence.
void conclude(Made made, bool hit, double end, Trace& trace) {
  const auto& spans = trace.spans;
  if (made == Made::by_steps) {
    trace.reason = hit ? "the advancing ray has come as near as numbers tell"
                       : "no plane of the last step is met before the way ends";
    return;
  }
  const auto entry = [](const TraceSpan& a, const TraceSpan& b) { return a.enter < b.enter; };
  const auto exit = [](const TraceSpan& a, const TraceSpan& b) { return a.leave < b.leave; };
  const auto missed = std::find_if(spans.begin(), spans.end(), [](const auto& s) { return !(s.enter <= s.leave); });
  const TraceSpan& in = made == Made::of_any ? *std::min_element(spans.begin(), spans.end(), entry)
                                             : *std::max_element(spans.begin(), spans.end(), entry);
  const TraceSpan& out = *std::min_element(spans.begin(), spans.end(), exit);
  if (hit) {
    trace.winner = in.name;
    trace.reason = in.enter > 0 ? "the ray comes in through " + in.name : "the ray begins inside";
  } else if (made == Made::of_any || missed != spans.end()) {
    trace.reason = missed != spans.end() ? "the ray never meets " + missed->name : "the ray passes";
    if (in.enter <= in.leave && made == Made::of_any) trace.reason = "the way ends before, or begins behind";
  } else if (in.enter > out.leave) {
    trace.winner = in.name;
    trace.reason = "the ray leaves " + out.name + " before it enters " + in.name;
  } else {
    trace.winner = in.name;
    trace.reason = in.enter > end ? "the way ends before " + in.name : "the shape lies behind the ray's begin";
  }
}

/// Explains one convex shape, in its own frame.
template <class T>
void explain_convex(const Shape<T>& shape, const LocalRay& ray, bool hit, Trace& trace) {
  rays::RayExplanation explanation(ray, trace);
  const Made made = shape.visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>)
      return explanation.of(c, shape.rounding());
    else
      return Made::by_steps;
  });
  conclude(made, hit, ray.end, trace);
}

/// Whether the ray hits, and the length up to which it was followed.
struct RayOutcome {
  bool hit;
  double until;
};

/// Explains a shape of any kind in its frame; for a composite the piece that is hit.
template <class T>
void explain_placed(const Shape<T>& shape, const Frame& frame, const LocalRay& outer,
                    std::optional<std::uint32_t> piece, const RayOutcome& outcome, Trace& trace) {
  const LocalRay ray = seen_from(frame, outer);
  std::string made_of;
  std::size_t count = 0;
  with_surface(shape, [&](const auto& surface) {
    count_visits(surface.hierarchy(), ray, outcome.until, trace);
    made_of = "triangle", count = surface.hierarchy().size();
    if (piece) explain_convex(triangle_shape<T>(surface.triangle(*piece)), ray, outcome.hit, trace);
  });
  if (const auto* compound = shape.template as<Compound<T>>()) {
    const CompoundData<T>& data = compound->data();
    count_visits(data.tree, ray, outcome.until, trace);
    trace.pieces += data.unbounded.size();
    made_of = "child", count = data.children.size();
    // For a child that is a composite itself, the ordinary routine finds which of its pieces is hit.
    if (piece) {
      const Placed<T>& child = data.children[*piece];
      const Frame placed = frame_of(child.pose);
      LocalRay inner = seen_from(placed, ray);
      std::optional<std::uint32_t> deeper;
      if (!child.shape.convex()) deeper = first_hit(child.shape, inner, BackFaces::hit).piece;
      explain_placed(child.shape, placed, ray, deeper, outcome, trace);
    }
  }
  if (made_of.empty()) {
    explain_convex(shape, ray, outcome.hit, trace);
  } else {
    const std::string which = piece ? made_of + " " + std::to_string(*piece) + ": " : "";
    trace.method =
        "pieces of composites, " + which + (piece ? trace.method : "none of " + std::to_string(count) + " is hit");
  }
  if (trace.reason.empty()) trace.reason = "the ray meets none of the pieces that its boxes led to";
  for (TraceSpan& span : trace.spans) span.normal = frame.out(span.normal);
  for (TraceStep& step : trace.steps) step.normal = frame.out(step.normal);
}

}  // namespace

template <class T>
void explain_ray(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length, BackFaces back,
                 const std::optional<RayHit<T>>& hit, Trace& trace) {
  const Frame world{{}, Mat3d::identity()};
  const std::optional<LocalRay> whole = local_ray(ray, length, world);
  if (!whole) {
    trace.method = "none";
    trace.reason = "the ray has no direction, or lies out of reach";
    return;
  }
  const double until = hit ? static_cast<double>(hit->t) : whole->end;
  std::optional<std::uint32_t> piece;
  if (hit && !shape.convex()) piece = hit->piece;
  explain_placed(shape, frame_of(pose), *whole, piece, {hit.has_value(), until}, trace);
  if (back == BackFaces::ignored && !hit) trace.reason += " (triangles from behind are passed)";
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void explain_ray(const Shape<T>&, const Pose<T>&, const Ray<T>&, T, BackFaces,                              \
                            const std::optional<RayHit<T>>&, Trace&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
