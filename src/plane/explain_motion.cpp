#include "plane/explain_motion.hpp"

#include "plane/explain.hpp"
#include "plane/first_contact.hpp"

namespace graze::plane {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A ray in the frame of a piece.
struct OwnRay {
  Vec2d origin, direction;
};

/// Adds a span: the part of a piece that the ray is in from `enter` to `leave`, and the part's normal where the ray
/// comes in.
void add_span(std::string name, const Vec2d& normal, double enter, double leave, const Pose2d& pose, Trace& trace) {
  const Vec2d n = rotate(pose.rotation, normal);
  trace.spans.push_back({std::move(name), {n.x, n.y, 0}, enter, leave});
}

/// The number of a vertex and of the edge that begins there; for a piece those on the outline, as in contacts.
template <class T>
std::string numbered(const Core<T>& core, std::uint32_t i) {
  return std::to_string(core.outline ? core.outline[i].number : i);
}

/// Adds the span of the half-plane below the line with outward normal `n` through `on`.
void add_half_plane(const std::string& name, const Vec2d& n, const Vec2d& on, const OwnRay& ray, const Pose2d& pose,
                    Trace& trace) {
  const double above = dot(ray.origin - on, n), climb = dot(ray.direction, n);
  double enter = -infinity, leave = infinity;
  if (climb < 0)
    enter = -above / climb;
  else if (climb > 0)
    leave = -above / climb;
  else if (above > 0)
    enter = infinity, leave = -infinity;
  add_span(name, climb < 0 ? n : Vec2d{}, enter, leave, pose, trace);
}

void add_disc(const std::string& name, const Vec2d& center, double radius, const OwnRay& ray, const Pose2d& pose,
              Trace& trace) {
  const Vec2d to = center - ray.origin;
  const double along = dot(to, ray.direction), across = cross(ray.direction, to);
  const double under = (radius - across) * (radius + across);
  if (!(under >= 0)) return add_span(name, {}, infinity, -infinity, pose, trace);
  const double half = std::sqrt(under);
  const Vec2d n = normalized(ray.direction * (along - half) - to, -ray.direction);
  add_span(name, n, along - half, along + half, pose, trace);
}

/// Adds the span of the rectangle over an edge, as wide to both sides as the rounding: the middle of a capsule, or a
/// segment.
void add_stretch(const std::string& name, const Vec2d& p, const Vec2d& q, double radius, const OwnRay& ray,
                 const Pose2d& pose, Trace& trace) {
  const Vec2d along = normalized(q - p), n = right(along);
  double enter = -infinity, leave = infinity;
  Vec2d through{};
  const auto clip = [&](const Vec2d& outward, double reach) {
    const double above = dot(ray.origin - p, outward) - reach, climb = dot(ray.direction, outward);
    if (climb < 0) {
      if (-above / climb > enter) enter = -above / climb, through = outward;
    } else if (climb > 0) {
      leave = least(leave, -above / climb);
    } else if (above > 0) {
      leave = -infinity;
    }
  };
  clip(n, radius), clip(-n, radius), clip(along, length(q - p)), clip(-along, 0);
  if (enter > leave) through = Vec2d{}, enter = infinity, leave = -infinity;
  add_span(name, through, enter, leave, pose, trace);
}

template <class T>
void add_spans(const Core<T>& core, const OwnRay& ray, const Pose2d& pose, Trace& trace) {
  if (core.kind == CoreKind::half_plane) return add_half_plane("plane", {0, 1}, {0, core.radius}, ray, pose, trace);
  if (core.count == 1) return add_disc("circle", core.vertex(0), core.radius, ray, pose, trace);
  if (core.count == 2) add_stretch("side", core.vertex(0), core.vertex(1), core.radius, ray, pose, trace);
  if (core.count > 2)
    for (std::uint32_t i = 0; i < core.count; ++i)
      if (const Vec2d e = core.edge(i); length_squared(e) > 0)
        add_half_plane((core.outline && !core.outline[i].outer ? "cut from " : "edge ") + numbered(core, i),
                       normalized(right(e)), core.vertex(i) + normalized(right(e)) * core.radius, ray, pose, trace);
  if (core.radius > 0)
    for (std::uint32_t i = 0; i < core.count; ++i)
      add_disc((core.count == 2 ? "end " : "corner ") + numbered(core, i), core.vertex(i), core.radius, ray, pose,
               trace);
}

}  // namespace

template <class T>
void explain_ray(const Core<T>& core, const Pose2d& pose, double extent, double near, const TracedRay& ray,
                 Trace& trace) {
  const OwnRay own{inverse_transform(pose, ray.origin), inverse_rotate(pose.rotation, ray.direction)};
  if (core.kind != CoreKind::polygon && core.kind != CoreKind::half_plane) {
    trace.method = "conservative advancement";
    trace.reason = "each step goes as far as the line between ray and shape allows";
    const auto seen = [&](double t, double gap, const Vec2d& normal) {
      const Vec2d n = rotate(pose.rotation, normal);
      trace.steps.push_back({t, gap, {n.x, n.y, 0}});
    };
    advance_straight(core, core_of(Circle<T>(T(0))), Pose2d{own.origin, {}}, own.direction, ray.length, extent, near,
                     seen);
    return;
  }
  add_spans(core, own, pose, trace);
  trace.method = core.kind == CoreKind::half_plane ? "closed form"
                 : core.count == 1                 ? "quadratic"
                 : core.radius > 0                 ? "edges and corners"
                                                   : "clipping by edges";
  if (!ray.hit) {
    trace.reason = "no stretch of the ray is inside of all that it has to be inside of";
    return;
  }
  if (!(*ray.hit > 0)) {
    trace.reason = "the ray starts inside";
    return;
  }
  // The part that begins at the hit, within some roundings of the way.
  const TraceSpan* best = nullptr;
  for (const TraceSpan& span : trace.spans)
    if (span.enter <= span.leave && (!best || std::abs(span.enter - *ray.hit) < std::abs(best->enter - *ray.hit)))
      best = &span;
  if (best) trace.winner = best->name, trace.reason = "the ray comes in through " + best->name;
}

template <class T>
Trace explained_place(const LeafPair<T>& pair) {
  const Nearest found = nearest(pair.a, pair.b, relative(pair.pose_a, pair.pose_b), pair.size());
  Distance<double> d;
  d.distance = found.distance - pair.a.radius - pair.b.radius;
  d.normal = rotate(pair.pose_a.rotation, found.normal);
  d.status = found.status;
  Trace trace = explained(pair, d);
  trace.gjk.clear();
  trace.epa.clear();
  return trace;
}

template void explain_ray(const Core<float>&, const Pose2d&, double, double, const TracedRay&, Trace&);
template void explain_ray(const Core<double>&, const Pose2d&, double, double, const TracedRay&, Trace&);
template Trace explained_place(const LeafPair<float>&);
template Trace explained_place(const LeafPair<double>&);

}  // namespace graze::plane
