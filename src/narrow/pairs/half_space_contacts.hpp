// Boxes, balls and even capsules on a half-space: the support face, each of its corners with its own height, in T.
//
// Guarantee: the distance is that of `distance`, bit for bit; the points are those that the general path gives, up to
// rounding, under the same names. Nothing is answered for other shapes.
#pragma once

#include <optional>

#include "narrow/closed_form.hpp"
#include "narrow/rest_batch.hpp"

namespace graze {

/// `b` is the half-space. Fills the manifold as `convex_contacts`, and returns the distance.
template <class T>
std::optional<T> half_space_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                     T margin, Manifold<T>& manifold) {
  if (!b.template as<HalfSpace<T>>()) return std::nullopt;
  const auto contacts = [&](const auto& body) {
    const Rest<T> found = rest(rounded_core(body, a.margin()), pose_a, b.margin(), pose_b, margin);
    manifold.normal = -found.up;
    each_rest_point<T>(
        static_cast<unsigned>(found.filled), points_together(body, a.margin()),
        [&](std::size_t i) { return found.slots[i]; }, [&](const ContactPoint<T>& p) { manifold.points.push_back(p); });
    return found.distance;
  };
  if (const auto* ball = a.template as<Sphere<T>>()) return contacts(*ball);
  if (const auto* capsule = a.template as<Capsule<T>>())
    return has_core(*capsule) && capsule->half_height() > T(0) ? std::optional(contacts(*capsule)) : std::nullopt;
  // The corners of a rounded box do not lie straight above its lowest points.
  const auto* box = a.template as<Box<T>>();
  return box && a.margin() == T(0) ? std::optional(contacts(*box)) : std::nullopt;
}

}  // namespace graze
