#include "query/explain_cast.hpp"

#include "composite/composite.hpp"
#include "composite/explain.hpp"
#include "shape/reach.hpp"

namespace graze {

namespace {

/// Largest number of steps shown, since longer tables are not read; shapes that turn fast near each other need
/// thousands.
constexpr std::size_t most_shown_steps = 64;

/// The greatest speed of any point of a body due to its rotation alone.
template <class T>
double turning_speed(const BodyOnItsWay<T>& body) {
  const double rate = length(converted<double>(body.velocity.angular));
  return rate > 0 ? rate * static_cast<double>(reach_of(body.shape)) : 0;
}

/// Conservative advancement with a bound on the speed (Mirtich 1996, "Impulse-based dynamic simulation of rigid body
/// systems", section 2.3): the plane between the shapes separates them until the gap along its normal is used up.
template <class T>
class ShownAdvancement {
 public:
  ShownAdvancement(const BodyOnItsWay<T>& a, const BodyOnItsWay<T>& b)
      : a_(a),
        b_(b),
        velocity_(converted<double>(b.velocity.linear) - converted<double>(a.velocity.linear)),
        turning_(turning_speed(a) + turning_speed(b)) {}

  Distance<T> at(T t) const { return any_distance(a_.shape, pose_of(a_, t), b_.shape, pose_of(b_, t)); }
  void explain(T t, const Distance<T>& answer, Trace& trace) const {
    explain_any_distance(a_.shape, pose_of(a_, t), b_.shape, pose_of(b_, t), answer, trace);
  }

  /// The time until which the plane of that distance separates the shapes; infinite when they do not approach along its
  /// normal.
  double parted_until(double t, const Distance<T>& d) const {
    const double closing = turning_ - dot(converted<double>(d.normal), velocity_);
    return closing > 0 ? t + static_cast<double>(d.distance) / closing : std::numeric_limits<double>::infinity();
  }

 private:
  static Pose<T> pose_of(const BodyOnItsWay<T>& body, T t) { return pose_at(body.pose, body.velocity, t); }

  const BodyOnItsWay<T>&a_, &b_;
  Vec3d velocity_;
  double turning_;
};

}  // namespace

template <class T>
void explain_cast(const BodyOnItsWay<T>& a, const BodyOnItsWay<T>& b, T duration, const std::optional<CastHit<T>>& hit,
                  Trace& trace) {
  const ShownAdvancement<T> advancement(a, b);
  const T last = hit ? hit->t : duration;
  const auto show = [&](T t, const Distance<T>& d) {
    trace.steps.push_back({static_cast<double>(t), static_cast<double>(d.distance), converted<double>(d.normal)});
  };
  std::string end = hit ? "the shapes touch" : "the time is over before they touch";
  T t(0);
  while (t < last && trace.steps.size() < most_shown_steps) {
    const Distance<T> d = advancement.at(t);
    if (d.status == Status::unbounded || !(d.distance > T(0))) break;
    show(t, d);
    const double until = advancement.parted_until(static_cast<double>(t), d);
    if (!hit && !(until < static_cast<double>(last))) {
      end = until < std::numeric_limits<double>::infinity() ? "this plane parts them for the rest of the time"
                                                            : "they never come nearer along this normal";
      break;
    }
    const T next = until < static_cast<double>(last) ? static_cast<T>(until) : last;
    if (!(next > t)) break;
    t = next;
  }
  const bool ended = trace.steps.size() == most_shown_steps && t < last;
  if (hit || ended || !(t < last)) t = last;
  const Distance<T> d = advancement.at(t);
  advancement.explain(t, d, trace);
  if (d.status != Status::unbounded && (trace.steps.empty() || trace.steps.back().t < static_cast<double>(t)))
    show(t, d);
  if (ended) end += ", after steps that are not shown";
  trace.reason = end + "; then " + trace.method + (trace.reason.empty() ? "" : ": " + trace.reason);
  trace.method = "conservative advancement";
}

template void explain_cast(const BodyOnItsWay<float>&, const BodyOnItsWay<float>&, float,
                           const std::optional<CastHit<float>>&, Trace&);
template void explain_cast(const BodyOnItsWay<double>&, const BodyOnItsWay<double>&, double,
                           const std::optional<CastHit<double>>&, Trace&);

}  // namespace graze
