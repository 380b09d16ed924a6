#include "graze/plane/cast.hpp"

#include <algorithm>

#include "plane/advance.hpp"
#include "plane/explain_motion.hpp"
#include "plane/first_contact.hpp"
#include "plane/leaves.hpp"
#include "plane/ray_hit.hpp"
#include "plane/rounded_time.hpp"
#include "plane/sliding.hpp"
#include "plane/straight_contact.hpp"
#include "plane/sure_hit.hpp"

namespace graze::plane {

namespace {

/// The contact of pieces that touch where they begin.
template <class T>
std::optional<WorldContact> contact_at_start(const Core<T>& a, const Core<T>& b, const Pose2d& pose_a,
                                             const Pose2d& b_in_a, double size, double rounding) {
  const Nearest start = nearest(a, b, b_in_a, size);
  const double gap = start.distance - a.radius - b.radius;
  if (!(gap <= rounding)) return {};
  WorldContact out;
  out.normal = rotate(pose_a.rotation, start.normal);
  out.depth = start.status == Status::unbounded ? 0 : greatest(-gap, 0.0);
  out.point = transform(pose_a, start.a.point + start.normal * (a.radius + (out.depth > 0 ? gap / 2 : 0.0)));
  return out;
}

/// The first contact of two convex pieces. Calls `seen(t, gap, normal)`, the normal in the world, at each time that a
/// search looks at.
template <class T, class Seen>
std::optional<WorldContact> pair_cast(const Mover<T>& a, const Mover<T>& b, double duration, double size, double near,
                                      const Seen& seen) {
  const Pose2d pose_a = a.at(0), pose_b = b.at(0), b_in_a = relative(pose_a, pose_b);
  const bool polygons = a.core.kind == CoreKind::polygon && b.core.kind == CoreKind::polygon;
  const bool far = polygons && discs_apart(b.body.translation - a.body.translation, a.reach, b.reach) > 0;
  const double rounding = touching_rounding * (size + max_abs(b_in_a.translation));
  if (!far && (!polygons || !surely_apart(a.core, b.core, b_in_a, rounding)))
    if (const auto touching = contact_at_start(a.core, b.core, pose_a, b_in_a, size, rounding)) return touching;
  if (a.velocity.angular != 0 || b.velocity.angular != 0) {
    const std::optional<double> from = far ? discs_meet(a, b, near) : 0;
    if (!from || !(*from <= duration)) return {};
    return advance(a, b, *from, duration, size, near, near,
                   [&](const Nearby& now) { seen(now.contact.t, now.gap, now.contact.normal); });
  }
  const Vec2d velocity = inverse_rotate(pose_a.rotation, b.velocity.linear - a.velocity.linear);
  const auto in_world = [&](double t, double gap, const Vec2d& n) { seen(t, gap, rotate(pose_a.rotation, n)); };
  const auto hit = polygons ? contact_of_polygons(a.core, b.core, b_in_a, velocity, duration, size)
                            : advance_straight(a.core, b.core, b_in_a, velocity, duration, size, near, in_world);
  if (!hit) return {};
  const Pose2d then = a.at(hit->t);
  return WorldContact{hit->t, transform(then, hit->point), rotate(then.rotation, hit->normal), 0, hit->status};
}

/// Nobody who looks on.
constexpr auto unseen = [](double, double, const Vec2d&) {};

/// The pose from which a body moves, without negative zeros: what is added on the way to a piece's place would make
/// some of them positive.
template <class T>
[[gnu::always_inline]] inline Pose2d start_of(const Pose2<T>& pose) {
  const Pose2d at = at_unit(pose);
  return {at.translation + Vec2d{}, at.rotation};
}

/// Two bodies that move, as the pairs of their convex pieces.
template <class T>
struct MovingPair {
  const Shape<T>&a, &b;
  Pose2d body_a, body_b;
  Velocity<double> of_a, of_b;

  MovingPair(const Shape<T>& shape_a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& shape_b,
             const Pose2<T>& pose_b, const Velocity<T>& velocity_b)
      : a(shape_a),
        b(shape_b),
        body_a(start_of(pose_a)),
        body_b(start_of(pose_b)),
        of_a{converted<double>(velocity_a.linear), double(velocity_a.angular)},
        of_b{converted<double>(velocity_b.linear), double(velocity_b.angular)} {}

  Mover<T> mover_a(const LeafPair<T>& pair) const {
    return {pair.a, pair.pose_a, body_a, of_a, length(pair.pose_a.translation) + pair.extent_a};
  }
  Mover<T> mover_b(const LeafPair<T>& pair) const {
    return {pair.b, pair.pose_b, body_b, of_b, length(pair.pose_b.translation) + pair.extent_b};
  }
  /// Calls `f` with the pieces of each pair in the frames of their bodies.
  template <class F>
  void for_each(F&& f) const {
    for_each_pair(a, Pose2<T>{}, b, Pose2<T>{}, f);
  }
  /// The contact of one pair of pieces, no later than `until` of the whole `duration`; `seen` as for `pair_cast`.
  template <class Seen>
  std::optional<WorldContact> contact(const LeafPair<T>& pair, double until, double duration,
                                      const CastOptions& options, const Seen& seen) const {
    const Mover<T> at_a = mover_a(pair), at_b = mover_b(pair);
    const double size = greatest(at_a.reach, at_b.reach), way = length(of_b.linear - of_a.linear) * duration;
    // Half of D: the other half is for rounding the time.
    const double near =
        double(cast_tolerance<T>) / 2 * size +
        4 * std::numeric_limits<double>::epsilon() * (way + length(body_b.translation - body_a.translation));
    if (options.separating == Separating::hit) return pair_cast(at_a, at_b, until, size, near, seen);
    // A contact that slides until the end is recognised over the whole time only.
    auto first = pair_cast(at_a, at_b, duration, size, near, seen);
    if (first) first = pressing(at_a, at_b, *first, duration, pair, near);
    if (first && first->t > until) first.reset();
    return first;
  }
  CastHit<T> hit(const WorldContact& contact, const LeafPair<T>& pair) const {
    return {rounded_down<T>(contact.t),
            converted<T>(contact.point),
            converted<T>(contact.normal),
            static_cast<T>(contact.depth),
            contact.status,
            pair.piece_a,
            pair.piece_b};
  }
};

/// The cast of two shapes in one function, in which vectors stay in registers: of convex polygons, rounded or not, that
/// do not turn and are surely apart at the start by the discs around them. Returns whether they are such; the answer
/// has the bits of `MovingPair`.
template <class T>
[[gnu::always_inline]] inline bool
straight_cast(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
              const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::optional<CastHit<T>>& out) {
  if (velocity_a.angular != T(0) || velocity_b.angular != T(0) || !a.convex() || !b.convex()) return false;
  const Pose2d at_a = start_of(pose_a), at_b = start_of(pose_b);
  const auto extent_a = double(extent(a)), extent_b = double(extent(b));
  if (!(discs_apart(at_b.translation - at_a.translation, extent_a, extent_b) > 0)) return false;
  const Core<T> core_a = convex_core(a), core_b = convex_core(b);
  if (core_a.kind != CoreKind::polygon || core_b.kind != CoreKind::polygon) return false;
  const Vec2d of_a = converted<double>(velocity_a.linear), of_b = converted<double>(velocity_b.linear);
  const auto hit = straight_contact(core_a, core_b, relative(at_a, at_b), inverse_rotate(at_a.rotation, of_b - of_a),
                                    double(duration), greatest(extent_a, extent_b));
  if (!hit) return true;
  const Pose2d then{at_a.translation + of_a * hit->t, at_a.rotation};
  out = CastHit<T>{rounded_down<T>(hit->t),
                   converted<T>(transform(then, hit->point)),
                   converted<T>(rotate(then.rotation, hit->normal)),
                   T(0),
                   Status::converged,
                   0,
                   0};
  return true;
}

/// Fills the trace with what a cast did about the pair of pieces numbered `number`, from which its answer came.
template <class T>
[[gnu::noinline]] void explain_cast(const MovingPair<T>& moving, std::size_t number, double duration,
                                    const CastOptions& options, Trace& trace) {
  std::size_t i = 0;
  moving.for_each([&](const LeafPair<T>& pair) {
    if (i++ != number) return;
    std::vector<TraceStep> steps;
    const auto found = moving.contact(pair, duration, duration, options, [&](double t, double gap, const Vec2d& n) {
      steps.push_back({t, gap, {n.x, n.y, 0}});
    });
    const Mover<T> a = moving.mover_a(pair), b = moving.mover_b(pair);
    const auto place = [&](double t) {
      const Pose2d at_a = a.at(t), at_b = b.at(t);
      return explained_place(
          LeafPair<T>{pair.a, pair.b, at_a, at_b, pair.extent_a, pair.extent_b, pair.piece_a, pair.piece_b});
    };
    trace = place(found ? found->t : duration);
    if (found && found->t > 0) trace.difference = place(0).difference;
    trace.steps = std::move(steps);
    const bool turns = a.velocity.angular != 0 || b.velocity.angular != 0;
    if (turns) trace.difference.clear();  // another one at every time
    trace.method = turns || !trace.steps.empty() ? "conservative advancement" : "ray against the Minkowski difference";
    if (found && !(found->t > 0)) trace.method = "closed form", trace.reason = "the bodies touch at the start";
  });
  trace.pieces = i > 1 ? i : 0;
}

/// A ray in the world, in double.
template <class T>
struct WorldRay {
  Vec2d origin, direction;
  bool valid;

  WorldRay(const Ray<T>& ray, T length)
      : origin(converted<double>(ray.origin)),
        direction(unit_vector(converted<double>(ray.direction), Vec2d{})),
        valid(std::isfinite(origin.x) && std::isfinite(origin.y) && length_squared(direction) > 0 && length >= T(0)) {}

  /// Whether the ray may come into a box of pieces before `until`, each rounded; with room for the rounding of a few
  /// numbers as large as the way to them.
  auto near(const double& until) const {
    return [this, &until](const Pose2d& pose, const Aabb2<double>& box, double rounding) {
      const Vec2d own = inverse_transform(pose, origin), along = inverse_rotate(pose.rotation, direction);
      const Vec2d center = (box.lower + box.upper) * 0.5 - own, half = (box.upper - box.lower) * 0.5;
      const double slack = rounding + 1e-13 * (length(own) + length(box.lower) + length(box.upper) + rounding);
      const Vec2d to_side = abs(along);
      if (std::abs(cross(along, center)) > half.x * to_side.y + half.y * to_side.x + slack) return false;
      const double middle = dot(along, center), reach = half.x * to_side.x + half.y * to_side.y + slack;
      return middle + reach >= 0 && middle - reach <= until;
    };
  }

  double near_enough(const Pose2d& at, double extent) const {
    return double(tolerance<T>) / 4 * extent +
           4 * std::numeric_limits<double>::epsilon() * length(inverse_transform(at, origin));
  }
  /// The hit of one convex piece up to `until`.
  std::optional<RayHit<T>> meet(const Core<T>& core, const Pose2d& at, double extent, std::uint32_t piece, double until,
                                double& t) const {
    const Vec2d own = inverse_transform(at, origin), along = inverse_rotate(at.rotation, direction);
    const double near = core.kind == CoreKind::polygon ? 0 : near_enough(at, extent);
    const auto hit = ray_hit(core, own, along, until, extent, near);
    if (!hit) return {};
    t = hit->t;
    if (t == 0 && hit->normal == -along) return RayHit<T>{T(0), converted<T>(origin), converted<T>(-direction), piece};
    return seen(at, t, hit->normal, piece, hit->status);
  }
  /// A hit in the world, at time t.
  RayHit<T> seen(const Pose2d& at, double t, const Vec2d& normal, std::uint32_t piece, Status status) const {
    // A surface that the ray grazes lies along it: its normal points along the ray by rounding at most.
    const Vec2d n = rotate(at.rotation, normal);
    return {static_cast<T>(t), converted<T>(origin + direction * t), converted<T>(n), piece, status};
  }
};

/// The first hit of a ray up to `until`, which becomes its time. Calls `seen(core, pose, extent, nearer)` for each
/// piece that is looked at; `nearer`: it is hit before all pieces so far.
template <class T, class Seen>
std::optional<RayHit<T>> first_hit(const Shape<T>& shape, const Pose2<T>& pose, const WorldRay<T>& world, double& until,
                                   const Seen& seen) {
  std::optional<RayHit<T>> best;
  for_each_leaf(shape, at_unit(pose), world.near(until),
                [&](const Core<T>& core, const Pose2d& at, double extent, std::uint32_t piece) {
                  double t = 0;
                  const bool done = best && until == 0;
                  const auto hit = done ? std::nullopt : world.meet(core, at, extent, piece, until, t);
                  const bool nearer = hit && !(best && t == until);
                  seen(core, at, extent, nearer);
                  if (!nearer) return;
                  until = t;
                  best = hit;
                });
  return best;
}

/// Fills the trace with what the first hit of a ray is found from: the piece that is hit, or else the first one.
template <class T>
void explain_raycast(const Shape<T>& shape, const Pose2<T>& pose, const WorldRay<T>& world, double length_of_ray,
                     Trace& trace) {
  struct Met {
    Core<T> core;
    Pose2d pose;
    double extent;
  };
  std::optional<Met> met;
  std::size_t pieces = 0;
  double until = length_of_ray;
  const auto best =
      first_hit(shape, pose, world, until, [&](const Core<T>& core, const Pose2d& at, double extent, bool nearer) {
        ++pieces;
        if (nearer || !met) met = Met{core, at, extent};
      });
  const std::optional<double> hit = best ? std::optional<double>(until) : std::nullopt;
  if (met) {
    const TracedRay traced{world.origin, world.direction, length_of_ray, hit};
    explain_ray(met->core, met->pose, met->extent, world.near_enough(met->pose, met->extent), traced, trace);
  } else {
    trace.method = "bounds", trace.reason = "the ray passes by the bounds of all pieces";
  }
  trace.pieces = pieces > 1 ? pieces : 0;
}

/// The answer of a raycast, and then its explanation.
template <class T>
[[gnu::noinline]] std::optional<RayHit<T>> explained_raycast(const Shape<T>& shape, const Pose2<T>& pose,
                                                             const Ray<T>& ray, T length_of_ray, Trace& trace) {
  const auto hit = raycast(shape, pose, ray, length_of_ray);
  const WorldRay<T> world(ray, length_of_ray);
  if (world.valid) explain_raycast(shape, pose, world, double(length_of_ray), trace);
  return hit;
}

/// A ray at any shape, in a function of its own: rays at a shape with a sure hit do not pay for its set-up.
template <class T>
[[gnu::noinline]] std::optional<RayHit<T>> any_raycast(const Shape<T>& shape, const Pose2<T>& pose,
                                                       const WorldRay<T>& world, double until) {
  return first_hit(shape, pose, world, until, [](const Core<T>&, const Pose2d&, double, bool) {});
}

}  // namespace

template <class T>
Pose2<T> pose_at(const Pose2<T>& pose, const Velocity<T>& velocity, T t) {
  return converted<T>(moved(at_unit(pose), {converted<double>(velocity.linear), double(velocity.angular)}, double(t)));
}

template <class T>
std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a,
                               const Shape<T>& b, const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration,
                               const CastOptions& options, Trace* trace) {
  std::optional<CastHit<T>> best;
  const bool straight = options.separating == Separating::hit &&
                        straight_cast(a, pose_a, velocity_a, b, pose_b, velocity_b, duration, best);
  if (straight && !trace) return best;
  const MovingPair<T> moving(a, pose_a, velocity_a, b, pose_b, velocity_b);
  auto until = double(duration);
  std::size_t number = 0, first = 0;
  if (!straight)
    moving.for_each([&](const LeafPair<T>& pair) {
      const std::size_t own = number++;
      const auto hit = moving.contact(pair, until, double(duration), options, unseen);
      if (!hit || (best && hit->t == until && !(hit->depth > double(best->depth)))) return;
      until = hit->t;
      best = moving.hit(*hit, pair);
      first = own;
    });
  if (trace) explain_cast(moving, first, double(duration), options, *trace);
  return best;
}

template <class T>
void cast_all(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a, const Shape<T>& b,
              const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration, std::vector<CastHit<T>>& hits,
              const CastOptions& options) {
  const MovingPair<T> moving(a, pose_a, velocity_a, b, pose_b, velocity_b);
  const auto before = static_cast<std::ptrdiff_t>(hits.size());
  moving.for_each([&](const LeafPair<T>& pair) {
    if (const auto hit = moving.contact(pair, double(duration), double(duration), options, unseen))
      hits.push_back(moving.hit(*hit, pair));
  });
  std::stable_sort(hits.begin() + before, hits.end(), [](const CastHit<T>& p, const CastHit<T>& q) {
    if (p.t != q.t) return p.t < q.t;
    return p.piece_a != q.piece_a ? p.piece_a < q.piece_a : p.piece_b < q.piece_b;
  });
}

template <class T>
std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray, T length_of_ray,
                                 Trace* trace) {
  if (trace) return explained_raycast(shape, pose, ray, length_of_ray, *trace);
  const WorldRay<T> world(ray, length_of_ray);
  if (!world.valid) return {};
  const auto until = double(length_of_ray);
  const Pose2d at = at_unit(pose);
  const SureHit sure =
      sure_hit(shape, inverse_transform(at, world.origin), inverse_rotate(at.rotation, world.direction));
  if (!sure.known) return any_raycast(shape, pose, world, until);
  if (!(sure.t <= until) || sure.t == never) return {};
  return world.seen(at, sure.t, sure.normal, 0, Status::converged);
}

template <class T>
bool raycast_any(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray, T length_of_ray) {
  const WorldRay<T> world(ray, length_of_ray);
  if (!world.valid) return false;
  bool found = false;
  const auto until = double(length_of_ray);
  const auto near = world.near(until);
  const auto wanted = [&](const Pose2d& at, const Aabb2<double>& box, double rounding) {
    return !found && near(at, box, rounding);
  };
  for_each_leaf(shape, at_unit(pose), wanted,
                [&](const Core<T>& core, const Pose2d& at, double extent, std::uint32_t piece) {
                  double t = 0;
                  found = found || world.meet(core, at, extent, piece, until, t);
                });
  return found;
}

template <class T>
std::size_t raycast_all(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray, std::vector<RayHit<T>>& hits,
                        T length_of_ray) {
  const WorldRay<T> world(ray, length_of_ray);
  if (!world.valid) return 0;
  const std::size_t before = hits.size();
  const auto until = double(length_of_ray);
  for_each_leaf(shape, at_unit(pose), world.near(until),
                [&](const Core<T>& core, const Pose2d& at, double extent, std::uint32_t piece) {
                  double t = 0;
                  if (const auto hit = world.meet(core, at, extent, piece, until, t)) hits.push_back(*hit);
                });
  std::stable_sort(hits.begin() + static_cast<std::ptrdiff_t>(before), hits.end(),
                   [](const RayHit<T>& p, const RayHit<T>& q) { return p.t != q.t ? p.t < q.t : p.piece < q.piece; });
  return hits.size() - before;
}

#define GRAZE_PLANE_CASTS(T)                                                                                           \
  template Pose2<T> pose_at(const Pose2<T>&, const Velocity<T>&, T);                                                   \
  template std::optional<CastHit<T>> cast(const Shape<T>&, const Pose2<T>&, const Velocity<T>&, const Shape<T>&,       \
                                          const Pose2<T>&, const Velocity<T>&, T, const CastOptions&, Trace*);         \
  template void cast_all(const Shape<T>&, const Pose2<T>&, const Velocity<T>&, const Shape<T>&, const Pose2<T>&,       \
                         const Velocity<T>&, T, std::vector<CastHit<T>>&, const CastOptions&);                         \
  template std::optional<RayHit<T>> raycast(const Shape<T>&, const Pose2<T>&, const Ray<T>&, T, Trace*);               \
  template bool raycast_any(const Shape<T>&, const Pose2<T>&, const Ray<T>&, T);                                       \
  template std::size_t raycast_all(const Shape<T>&, const Pose2<T>&, const Ray<T>&, std::vector<RayHit<T>>&, T);
GRAZE_PLANE_CASTS(float)
GRAZE_PLANE_CASTS(double)
#undef GRAZE_PLANE_CASTS

}  // namespace graze::plane
