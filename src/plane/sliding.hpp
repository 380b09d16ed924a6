// The distinction of pieces that touch and press against each other from those that slide along each other and leave.
//
// Guarantee: `Separating::ignored` of `graze/motion.hpp`. Pieces slide as long as their signed distance, which for
// convex pieces is the gap along the plane that keeps them furthest apart, stays above what it was at the start less
// what they may sink; that is a part of the way to the middle of each other, so nothing passes through by sliding.
// Where that plane leads over a seam of a chain, the gap along the segment's normal counts instead.
#pragma once

#include "plane/advance.hpp"
#include "plane/chain_seams.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

/// The part of the way to the middle of each other that pieces may sink, and the part of the size of the smaller one by
/// which rounding of coordinates may sink them, both as in `src/cast/sliding.hpp`.
inline constexpr double sinking_of_way = 1.0 / 4, slack_of_size = 1.0 / 16;

/// The width of a piece along a direction of the world; infinite for a half-plane.
template <class T>
double width(const Mover<T>& piece, const Vec2d& normal, double t) {
  if (piece.core.kind == CoreKind::half_plane) return std::numeric_limits<double>::infinity();
  const Vec2d own = inverse_rotate(piece.at(t).rotation, normal);
  return dot(own, support(piece.core, own).point - support(piece.core, -own).point) + 2 * piece.core.radius;
}

/// The depth beyond that of a contact to which its pieces may sink while they slide.
template <class T>
double may_sink(const Mover<T>& a, const Mover<T>& b, const WorldContact& contact, double duration,
                const LeafPair<T>& pair, double near) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto size = [](const Core<T>& core, double extent) {
    return core.kind == CoreKind::half_plane ? infinite : extent;
  };
  const double smaller = least(size(pair.a, pair.extent_a), size(pair.b, pair.extent_b));
  double reach = 0;
  for (const Mover<T>* m : {&a, &b})
    reach = greatest(reach, max_abs(m->body.translation) + length(m->velocity.linear) * duration);
  const double rounding = 4 * double(std::numeric_limits<T>::epsilon()) * reach;
  const double sink = sinking * double(cast_tolerance<T>) * smaller + least(rounding, smaller * slack_of_size);
  const double way = (width(a, contact.normal, contact.t) + width(b, contact.normal, contact.t)) / 2 - contact.depth;
  // No less than the error of a distance.
  return greatest(least(sink, way * sinking_of_way), near / 8);
}

/// Whether the bodies come closer where they touch.
template <class T>
bool approaches(const Mover<T>& a, const Mover<T>& b, const WorldContact& contact) {
  const auto velocity = [&](const Mover<T>& m) {
    const Vec2d arm = contact.point - m.body.translation - m.velocity.linear * contact.t;
    return m.velocity.linear + left(arm) * m.velocity.angular;
  };
  return dot(velocity(b) - velocity(a), contact.normal) < 0;
}

/// The contact at which two pieces begin to press that touch at `first`; nothing where they slide or leave until the
/// end. `near`: half of the D of `graze/plane/cast.hpp`.
template <class T>
std::optional<WorldContact> pressing(const Mover<T>& a, const Mover<T>& b, const WorldContact& first, double duration,
                                     const LeafPair<T>& pair, double near) {
  if (!pair.bounded() && pair.a.kind == pair.b.kind) return first;  // two half-planes
  if (first.status != Status::converged) return first;
  const double size = pair.size();
  const double deep = first.depth + may_sink(a, b, first, duration, pair, near);
  WorldContact press = first;
  bool apart = false;
  const auto seen = [&](Nearby& now) {
    keep_off_seams(a, b, near, now);
    if (now.contact.t == first.t || now.gap < -first.depth) return;
    press = now.contact;
    apart = now.gap > near;
  };
  if (!advance(a, b, first.t, duration, size, -deep, near, seen)) {
    // Pieces that press count from the depth D on where no time is left to get as deep.
    Nearby last = nearby(a, b, duration, size);
    keep_off_seams(a, b, near, last);
    if (!(last.gap < -first.depth - 2 * near) || !approaches(a, b, last.contact)) return {};
  }
  // A piece that has left the other and comes back touches it anew.
  return apart ? advance(a, b, press.t, duration, size, near) : press;
}

}  // namespace graze::plane
