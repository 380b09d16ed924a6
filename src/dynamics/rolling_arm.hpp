// The arm of a contact on a curved surface, as its body rolls, and the ball that the surface is there.
//
// The point of contact of a body that rolls wanders over its surface. Arms are those of the step's beginning: the force
// that rights a rocking ellipse would be late by half a step on the average, however many sub-steps there are, and a
// late force of that kind adds energy. So curved surfaces have the arms of the step's middle.
//
// While a body turns, the point of it that was found in contact rises, in a round surface however far: its depth is
// that of the ball of the surface about a point that turns with the body (`radius_of_rolling`).
//
// Guarantee: right to the first order for a body on what is flat and does not turn; on what is curved itself the change
// of the normal is left out. Balls about their centre of mass keep their arms but for rounding, and what is not curved
// to the last bit.
#pragma once

#include <cmath>
#include <optional>

#include "dynamics/rigid_space.hpp"
#include "shape/rounding.hpp"

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

/// The smaller radius of curvature of an ellipsoid where its outward normal is n. The radii's product is the square of
/// that of the half-axes over h^4, h being the support function (Gauss), and their sum is the trace of its Hessian.
template <class T>
T smaller_curvature_radius(const Vec3<T>& radii, const Vec3<T>& n) {
  const T h = length(scaled(radii, n));
  if (!(h > T(0))) return T(0);
  const Vec3<T> squares = scaled(radii, radii), share = radii / h, gradient = scaled(share, scaled(radii, n));
  const T product = radii.x * share.x * radii.y * share.y * (radii.z / h) * (radii.z / h);
  const T sum = (squares.x + squares.y + squares.z - length_squared(gradient)) / h;
  const T greater_twice = sum + std::sqrt(greatest(T(0), sum * sum - T(4) * product));
  return greater_twice > T(0) ? T(2) * product / greater_twice : T(0);
}

/// The radius of a ball whose surface is that of the shape about a point of contact, however the shape turns; of
/// cylinders that lie, however they turn about their axis. `outward`, unit, and `point` are in the shape's frame.
template <class T>
T radius_of_rolling(const Shape<T>& shape, const Vec3<T>& outward, const Vec3<T>& point) {
  const T around = rounding_radius(shape);
  if (shape.template as<Cylinder<T>>()) {
    if (std::abs(outward.y) > face_lean<T>) return around;  // on its rim, it would be lifted as it rocks
    const Vec3<T> on_core = point - outward * around;
    return around + greatest(T(0), on_core.x * outward.x + on_core.z * outward.z);
  }
  const auto* ellipsoid = shape.template as<Ellipsoid<T>>();
  return ellipsoid ? around + smaller_curvature_radius(ellipsoid->radii(), outward) : around;
}

namespace plane {

/// The radius of the disc that is added to a core: a shape's own and its rounding.
template <class T>
T rounding_radius(const Shape<T>& shape) {
  if (const auto* disc = shape.template as<Circle<T>>()) return disc->radius() + shape.rounding();
  const auto* capsule = shape.template as<Capsule<T>>();
  return shape.rounding() + (capsule ? least(capsule->radius_bottom(), capsule->radius_top()) : T(0));
}

template <class T>
T radius_of_rolling(const Shape<T>& shape, const Vec2<T>& outward, const Vec2<T>&) {
  const auto* ellipse = shape.template as<Ellipse<T>>();
  if (!ellipse) return rounding_radius(shape);
  const T h = length(scaled(ellipse->radii(), outward)), product = ellipse->radii().x * ellipse->radii().y;
  return shape.rounding() + (h > T(0) ? (product / h) * (product / h) / h : T(0));
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
