// Intersection of lines with a box about the origin (Kay, Kajiya 1986, "Ray tracing complex scenes"), one line or a
// register of them.
//
// Guarantee: exact operations in the order written; a lane has the bits of one line alone. Everything is inlined, so
// that kernels may use it.
#pragma once

#include "graze/vec3.hpp"
#include "rays/limits.hpp"

namespace graze::rays {

/// Minus the sign of `d` where `by` holds, else 0. Without a branch, since the entry face is unpredictable.
[[gnu::always_inline]] inline double minus_sign(bool by, double d) {
  return static_cast<double>(int(by & (d < 0)) - int(by & (d > 0)));
}
template <class S>
[[gnu::always_inline]] inline S minus_sign(const typename S::Mask& by, const S& d) {
  return select(by, select(d > S(0), S(-1), S(1)), S(0));
}

template <class S>
class BoxCrossing {
 public:
  using Mask = decltype(S() < S());

  [[gnu::always_inline]] BoxCrossing(const Vec3<S>& origin, const Vec3<S>& direction, const Vec3<S>& half)
      : x_(origin.x, direction.x, half.x),
        y_(origin.y, direction.y, half.y),
        z_(origin.z, direction.z, half.z),
        direction_(direction),
        enter_(greatest(x_.enter, greatest(y_.enter, z_.enter))),
        leave_(least(x_.leave, least(y_.leave, z_.leave))) {}

  /// Parameter of entry, in lengths of the direction; infinite where the line is parallel to every face that it is
  /// between.
  [[gnu::always_inline]] const S& enter() const { return enter_; }
  [[gnu::always_inline]] const S& leave() const { return leave_; }
  [[gnu::always_inline]] Mask met() const { return (!(x_.missed | y_.missed | z_.missed)) & (enter_ <= leave_); }
  /// The normal of the face by which the line enters, the first of several.
  [[gnu::always_inline]] Vec3<S> normal() const {
    const Mask by_x = enter_ == x_.enter, by_y = (!by_x) & (enter_ == y_.enter), by_z = !(by_x | by_y);
    return {minus_sign(by_x, direction_.x), minus_sign(by_y, direction_.y), minus_sign(by_z, direction_.z)};
  }

 private:
  /// The space between two planes.
  struct Slab {
    S enter, leave;
    Mask missed;
    [[gnu::always_inline]] Slab(const S& origin, const S& direction, const S& half) {
      using std::abs;
      constexpr double unbounded = __builtin_inf();
      const S per_direction = S(1) / direction, low = (-half - origin) * per_direction,
              high = (half - origin) * per_direction;
      const Mask along = abs(direction) < S(no_component);
      enter = select(along, S(-unbounded), least(low, high));
      leave = select(along, S(unbounded), greatest(low, high));
      missed = along & (abs(origin) > half);
    }
  };

  Slab x_, y_, z_;
  Vec3<S> direction_;
  S enter_, leave_;
};

}  // namespace graze::rays
