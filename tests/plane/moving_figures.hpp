// Two figures that move, in extended precision: how far they are apart at any time, and the proof that they do not meet
// for a while. Nothing of what it checks takes part.
#pragma once

#include "plane/figures.hpp"

namespace graze::plane {

/// The pose at time t.
template <class T>
WidePose wide_at(const Pose2<T>& pose, const Velocity<T>& velocity, Wide t) {
  const WidePose start = wide(pose);
  const Wide angle = t * Wide(velocity.angular), c = std::cos(angle), s = std::sin(angle);
  return {start.x + t * Wide(velocity.linear.x), start.y + t * Wide(velocity.linear.y),
          start.cosine * c - start.sine * s, start.sine * c + start.cosine * s};
}

/// A unit vector, number `i` of `count` around the circle.
inline std::pair<Wide, Wide> compass(int i, int count) {
  const Wide angle = 2 * std::acos(Wide(-1)) * i / count;
  return {std::cos(angle), std::sin(angle)};
}

/// The furthest that a figure reaches from its origin, or a little more.
template <class T>
Wide furthest_reach(const Figure<T>& figure) {
  Wide most = 0;
  for (int i = 0; i < 720; ++i) {
    const auto [x, y] = compass(i, 720);
    most = std::max(most, figure.reach(x, y));
  }
  return most / std::cos(std::acos(Wide(-1)) / 720);
}

/// How the search for a moment of contact ended.
enum class Apart { proven, not_proven, met };

/// Whether two bodies stay apart from time 0 to `until`, or no deeper in each other than `near`. `apart(t, enough)` is
/// their signed distance, or any number above `enough` where that is a lower bound of it. The distance changes by no
/// more than `speed` in a unit of time, so a distance at one time excludes a contact for some time before and after;
/// what is left is halved until it is shorter than `near` takes.
template <class F>
Apart stay_apart(const F& apart, Wide until, Wide speed, Wide near, Wide& met_at) {
  struct Span {
    Wide from, to;
  };
  std::vector<Span> left{{0, until}};
  for (int looks = 0; !left.empty(); ++looks) {
    if (looks > 40000) return Apart::not_proven;
    const Span span = left.back();
    left.pop_back();
    const Wide middle = (span.from + span.to) / 2, change = speed * (span.to - span.from) / 2;
    const Wide distance = apart(middle, change);
    if (distance < -near) {
      met_at = middle;
      return Apart::met;
    }
    if (distance > change || change < near / 4) continue;
    left.push_back({middle, span.to});
    left.push_back({span.from, middle});
  }
  return Apart::proven;
}

/// Two figures that move.
template <class T>
class MovingFigures {
 public:
  MovingFigures(const Figure<T>& a, const Pose2<T>& pose_a, const Velocity<T>& of_a, const Figure<T>& b,
                const Pose2<T>& pose_b, const Velocity<T>& of_b)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), of_a_(of_a), of_b_(of_b) {}

  WidePose a_at(Wide t) const { return wide_at(pose_a_, of_a_, t); }
  WidePose b_at(Wide t) const { return wide_at(pose_b_, of_b_, t); }
  Wide distance_at(Wide t) const { return swept_distance(a_, a_at(t), b_, b_at(t)); }
  /// Their separation along a unit vector.
  Wide separation_at(Wide t, const Vec2<T>& direction) const {
    const Wide x = direction.x, y = direction.y, l = std::hypot(x, y);
    return separation_of(a_, a_at(t), b_, b_at(t))(x / l, y / l);
  }
  /// The length of the way of one seen from the other, in a unit of time.
  Wide way() const {
    return std::hypot(Wide(of_b_.linear.x) - Wide(of_a_.linear.x), Wide(of_b_.linear.y) - Wide(of_a_.linear.y));
  }
  /// The most by which their distance changes in a unit of time.
  Wide speed() const {
    return way() + std::abs(Wide(of_a_.angular)) * furthest_reach(a_) +
           std::abs(Wide(of_b_.angular)) * furthest_reach(b_);
  }
  Apart stay_apart(Wide until, Wide near, Wide& met_at) const {
    std::pair<Wide, Wide> last{1, 0};  // the direction that told them apart before
    const auto apart = [&](Wide t, Wide enough) {
      const auto along = separation_of(a_, a_at(t), b_, b_at(t));
      if (const Wide d = along(last.first, last.second); d > enough) return d;
      Wide most = -std::numeric_limits<Wide>::infinity();
      for (int i = 0; i < 120; ++i) {
        const auto direction = compass(i, 120);
        if (const Wide d = along(direction.first, direction.second); d > most) most = d, last = direction;
      }
      return most > enough ? most : distance_at(t);
    };
    return plane::stay_apart(apart, until, speed(), near, met_at);
  }

 private:
  const Figure<T>&a_, &b_;
  Pose2<T> pose_a_, pose_b_;
  Velocity<T> of_a_, of_b_;
};

}  // namespace graze::plane
