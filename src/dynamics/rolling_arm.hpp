// The arm of a contact on a curved surface, as its body rolls.
//
// The point of contact of a body that rolls wanders over its surface. Arms are those of the step's beginning: the force
// that rights a rocking ellipse would be late by half a step on the average, however many sub-steps there are, and a
// late force of that kind adds energy. So curved surfaces have the arms of the step's middle.
//
// Guarantee: right to the first order for a body on what is flat and does not turn; on what is curved itself the change
// of the normal is left out. Balls about their centre of mass keep their arms but for rounding, and what is not curved
// to the last bit.
#pragma once

#include <optional>

#include "dynamics/rigid_space.hpp"

namespace graze {

namespace plane {

template <class T>
Vec2<T> scaled(const Vec2<T>& v, const Vec2<T>& by) {
  return {v.x * by.x, v.y * by.y};
}

}  // namespace plane

/// The change of the point that an ellipsoid, or an ellipse, has furthest along a unit vector n by a change of n across
/// it: by the Hessian of the support function |D n|, D being the diagonal of the radii. Nothing where that is flat.
template <class Vec>
std::optional<Vec> change_on_ellipsoid(const Vec& radii, const Vec& n, const Vec& change) {
  const auto h = length(scaled(radii, n));
  if (!(h > 0)) return {};
  const Vec gradient = scaled(radii, scaled(radii, n)) / h;
  return (scaled(radii, scaled(radii, change)) - gradient * dot(gradient, change)) / h;
}

/// The change of the point that a shape has furthest along a unit vector n by a change of n across it. Nothing for
/// shapes that are flat or sharp somewhere.
template <class T>
std::optional<Vec3<T>> change_of_support(const Shape<T>& shape, const Vec3<T>& n, const Vec3<T>& change) {
  if (const auto* ball = shape.template as<Sphere<T>>()) return change * (ball->radius() + shape.rounding());
  const auto* ellipsoid = shape.template as<Ellipsoid<T>>();
  const auto own = ellipsoid ? change_on_ellipsoid(ellipsoid->radii(), n, change) : std::nullopt;
  return own ? std::optional(*own + change * shape.rounding()) : std::nullopt;
}

namespace plane {

template <class T>
std::optional<Vec2<T>> change_of_support(const Shape<T>& shape, const Vec2<T>& n, const Vec2<T>& change) {
  if (const auto* disc = shape.template as<Circle<T>>()) return change * (disc->radius() + shape.rounding());
  const auto* ellipse = shape.template as<Ellipse<T>>();
  const auto own = ellipse ? change_on_ellipsoid(ellipse->radii(), n, change) : std::nullopt;
  return own ? std::optional(*own + change * shape.rounding()) : std::nullopt;
}

}  // namespace plane

/// The rate at which an arm from the centre of mass to a point of contact changes. `outward`: the unit normal there.
template <class Shape, class Rotation, class Turning, class Vec>
Vec rate_of_arm(const Shape& shape, const Rotation& rotation, const Turning& spin, const Vec& outward, const Vec& arm) {
  const auto back = conjugate(rotation);
  // Seen from the body, the normal turns the other way.
  const auto change = change_of_support(shape, rotate(back, outward), rotate(back, -cross(spin, outward)));
  return change ? cross(spin, arm) + rotate(rotation, *change) : Vec{};
}

}  // namespace graze
