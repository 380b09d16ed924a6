// The arm of a contact on a curved surface, as its body rolls.
//
// Where a body rolls, its point of contact wanders over its surface. Arms are those of the step's beginning: the force
// that rights a rocking ellipse would be late by half a step on the average, however many sub-steps there are, and a late
// force of that kind adds energy. So curved surfaces have the arms of the step's middle.
//
// Guarantee: right to the first order for a body on what is flat and does not turn; on what is curved itself the change
// of the normal is left out. Balls about their centre of mass, and what is not curved, keep their arms.
#pragma once

#include <optional>

#include "dynamics/rigid_space.hpp"

namespace graze {

/// The change of the point that a shape has furthest along a unit vector n by a change of n across it: the Hessian of the
/// support function. Nothing for shapes that are flat or sharp somewhere.
template <class T>
std::optional<Vec3<T>> change_of_support(const Shape<T>& shape, const Vec3<T>& n, const Vec3<T>& change) {
  if (const auto* ball = shape.template as<Sphere<T>>()) return change * (ball->radius() + shape.rounding());
  const auto* ellipsoid = shape.template as<Ellipsoid<T>>();
  if (!ellipsoid) return {};
  const Vec3<T>& r = ellipsoid->radii();
  const T h = length(scaled(r, n));
  if (!(h > T(0))) return {};
  const Vec3<T> gradient = scaled(r, scaled(r, n)) / h;
  return (scaled(r, scaled(r, change)) - gradient * dot(gradient, change)) / h + change * shape.rounding();
}

namespace plane {

template <class T>
std::optional<Vec2<T>> change_of_support(const Shape<T>& shape, const Vec2<T>& n, const Vec2<T>& change) {
  if (const auto* disc = shape.template as<Circle<T>>()) return change * (disc->radius() + shape.rounding());
  const auto* ellipse = shape.template as<Ellipse<T>>();
  if (!ellipse) return {};
  const Vec2<T>& r = ellipse->radii();
  const auto scaled = [&](const Vec2<T>& v) { return Vec2<T>{r.x * v.x, r.y * v.y}; };
  const T h = length(scaled(n));
  if (!(h > T(0))) return {};
  const Vec2<T> gradient = scaled(scaled(n)) / h;
  return (scaled(scaled(change)) - gradient * dot(gradient, change)) / h + change * shape.rounding();
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
