#include "graze/plane/cast.hpp"

#include "plane/first_contact.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

namespace {

/// The most steps of conservative advancement of bodies that turn.
constexpr int most_advances = 2000;

Pose2d moved(const Pose2d& pose, const Velocity<double>& velocity, double t) {
  Pose2d out{pose.translation + velocity.linear * t, pose.rotation};
  if (velocity.angular != 0) out.rotation = normalized(Rot2d::from_angle(velocity.angular * t) * pose.rotation);
  return out;
}

/// A convex piece and how it moves: of a compound's child, that turns with its body, the pose at any time.
template <class T>
struct Mover {
  const Core<T>& core;
  Pose2d in_body;  ///< the piece seen from its body
  Pose2d body;
  Velocity<double> velocity;
  double reach;  ///< of the piece from the body's origin

  Pose2d at(double t) const { return compose(moved(body, velocity, t), in_body); }
  /// How much further than `height` the piece may reach along a fixed direction once its body has turned by `angle`:
  /// its points lie below that height and no further than `reach` from the body's origin.
  double gain(double height, double angle) const {
    if (angle == 0 || !(height < reach)) return 0;
    const double away = std::acos(greatest(height / reach, -1.0));
    return reach * std::cos(greatest(away - angle, 0.0)) - height;
  }
};

struct WorldContact {
  double t = 0;
  Vec2d point{}, normal{};
  double depth = 0;
  Status status = Status::converged;
};

/// The longest time, up to `longest`, in which `closing` (which grows) stays below `gap`: by bisection to a double's
/// digits.
template <class F>
double time_to_close(double gap, double longest, const F& closing) {
  double low = 0, high = longest;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (closing(middle) < gap ? low : high) = middle;
  }
  return low;
}

/// Conservative advancement: along the normal of the nearest points no body gets further than its origin moves and the
/// turn of the piece's outermost points adds.
template <class T>
std::optional<WorldContact> advance(const Mover<T>& a, const Mover<T>& b, double duration, double size, double near) {
  WorldContact out;
  const Vec2d linear = b.velocity.linear - a.velocity.linear;
  for (int step = 0; step < most_advances; ++step) {
    const Pose2d pose_a = a.at(out.t), pose_b = b.at(out.t);
    const Nearest found = nearest(a.core, b.core, relative(pose_a, pose_b), size);
    const double gap = found.distance - found.error - a.core.radius - b.core.radius;
    out.normal = rotate(pose_a.rotation, found.normal);
    const Vec2d on_a = transform(pose_a, found.a.point + found.normal * a.core.radius);
    out.point = on_a + out.normal * (gap / 2);
    if (gap <= near) return out;
    const double approach = greatest(-dot(linear, out.normal), 0.0);
    const double height_a = dot(on_a - a.body.translation - a.velocity.linear * out.t, out.normal);
    const double height_b = -dot(on_a + out.normal * gap - b.body.translation - b.velocity.linear * out.t, out.normal);
    const auto closing = [&](double time) {
      return approach * time + a.gain(height_a, std::abs(a.velocity.angular) * time) +
             b.gain(height_b, std::abs(b.velocity.angular) * time);
    };
    // To half of what counts as contact, so that the last step does not fall short by rounding.
    const double left_over = duration - out.t;
    if (closing(left_over) < gap - near / 2) return {};
    const double later = out.t + time_to_close(gap - near / 2, left_over, closing);
    if (later == out.t) return out;
    out.t = later;
  }
  out.status = Status::bounded;
  return out;
}

/// The first contact of two convex pieces.
template <class T>
std::optional<WorldContact> pair_cast(const Mover<T>& a, const Mover<T>& b, double duration, double size, double near) {
  const Pose2d pose_a = a.at(0), pose_b = b.at(0), b_in_a = relative(pose_a, pose_b);
  const Nearest start = nearest(a.core, b.core, b_in_a, size);
  const double gap = start.distance - a.core.radius - b.core.radius;
  if (gap <= 0) {
    WorldContact out;
    out.normal = rotate(pose_a.rotation, start.normal);
    out.depth = start.status == Status::unbounded ? 0 : -gap;
    out.point = transform(pose_a, start.a.point + start.normal * (a.core.radius + (out.depth > 0 ? gap / 2 : 0.0)));
    return out;
  }
  if (a.velocity.angular != 0 || b.velocity.angular != 0) return advance(a, b, duration, size, near);
  const Vec2d velocity = inverse_rotate(pose_a.rotation, b.velocity.linear - a.velocity.linear);
  const auto hit = first_contact(a.core, b.core, b_in_a, velocity, duration, size, near);
  if (!hit) return {};
  const Pose2d then = a.at(hit->t);
  return WorldContact{hit->t, transform(then, hit->point), rotate(then.rotation, hit->normal), 0, hit->status};
}

/// A time in T that is not later.
template <class T>
T rounded_down(double t) {
  const T rounded = static_cast<T>(t);
  return double(rounded) > t ? std::nextafter(rounded, T(0)) : rounded;
}

}  // namespace

template <class T>
Pose2<T> pose_at(const Pose2<T>& pose, const Velocity<T>& velocity, T t) {
  return converted<T>(moved({converted<double>(pose.translation), normalized(converted<double>(pose.rotation))},
                            {converted<double>(velocity.linear), double(velocity.angular)}, double(t)));
}

template <class T>
std::optional<CastHit<T>> cast(const Shape<T>& a, const Pose2<T>& pose_a, const Velocity<T>& velocity_a,
                               const Shape<T>& b, const Pose2<T>& pose_b, const Velocity<T>& velocity_b, T duration) {
  const auto wide = [](const Pose2<T>& pose) {
    return Pose2d{converted<double>(pose.translation), normalized(converted<double>(pose.rotation))};
  };
  const Pose2d body_a = wide(pose_a), body_b = wide(pose_b);
  const Velocity<double> of_a{converted<double>(velocity_a.linear), double(velocity_a.angular)},
      of_b{converted<double>(velocity_b.linear), double(velocity_b.angular)};
  const double way = length(of_b.linear - of_a.linear) * double(duration);
  std::optional<CastHit<T>> best;
  double until = double(duration);
  for_each_pair(a, Pose2<T>{}, b, Pose2<T>{}, [&](const LeafPair<T>& pair) {
    const Mover<T> mover_a{pair.a, pair.pose_a, body_a, of_a, length(pair.pose_a.translation) + pair.extent_a};
    const Mover<T> mover_b{pair.b, pair.pose_b, body_b, of_b, length(pair.pose_b.translation) + pair.extent_b};
    const double size = greatest(mover_a.reach, mover_b.reach);
    // Half of D: the other half is for rounding the time.
    const double near =
        double(cast_tolerance<T>) / 2 * size +
        4 * std::numeric_limits<double>::epsilon() * (way + length(body_b.translation - body_a.translation));
    const auto hit = pair_cast(mover_a, mover_b, until, size, near);
    if (!hit || (best && hit->t == until && !(hit->depth > double(best->depth)))) return;
    until = hit->t;
    best = CastHit<T>{rounded_down<T>(hit->t),
                      converted<T>(hit->point),
                      converted<T>(hit->normal),
                      static_cast<T>(hit->depth),
                      hit->status,
                      pair.piece_a,
                      pair.piece_b};
  });
  return best;
}

template <class T>
std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose2<T>& pose, const Ray<T>& ray, T length_of_ray) {
  const Vec2d direction = normalized(converted<double>(ray.direction), Vec2d{}), origin = converted<double>(ray.origin);
  const bool finite = std::isfinite(origin.x) && std::isfinite(origin.y) && length_squared(direction) > 0;
  if (!finite || !(length_of_ray >= T(0))) return {};
  const Core<T> point = core_of(Circle<T>(T(0)));
  std::optional<RayHit<T>> best;
  double until = double(length_of_ray);
  for_each_leaf(shape, pose, [&](const Core<T>& core, const Pose2d& at, double extent, std::uint32_t piece) {
    const Vec2d own = inverse_transform(at, origin), along = inverse_rotate(at.rotation, direction);
    const Pose2d start{own, {}};
    const double near = double(tolerance<T>) / 4 * extent + 4 * std::numeric_limits<double>::epsilon() * length(own);
    if (nearest(core, point, start, extent).distance - core.radius <= 0) {
      if (best && until == 0) return;
      until = 0;
      best = RayHit<T>{T(0), ray.origin, converted<T>(-direction), piece};
      return;
    }
    const auto hit = first_contact(core, point, start, along, until, extent, near);
    if (!hit || (best && hit->t == until)) return;
    until = hit->t;
    // By rounding across the ray at most: a surface that it grazes does not face along it.
    const Vec2d n = rotate(at.rotation, hit->normal);
    best = RayHit<T>{static_cast<T>(hit->t), converted<T>(origin + direction * hit->t), converted<T>(n), piece,
                     hit->status};
  });
  return best;
}

#define GRAZE_PLANE_CASTS(T)                                                                                           \
  template Pose2<T> pose_at(const Pose2<T>&, const Velocity<T>&, T);                                                   \
  template std::optional<CastHit<T>> cast(const Shape<T>&, const Pose2<T>&, const Velocity<T>&, const Shape<T>&,       \
                                          const Pose2<T>&, const Velocity<T>&, T);                                     \
  template std::optional<RayHit<T>> raycast(const Shape<T>&, const Pose2<T>&, const Ray<T>&, T);
GRAZE_PLANE_CASTS(float)
GRAZE_PLANE_CASTS(double)
#undef GRAZE_PLANE_CASTS

}  // namespace graze::plane
