// The operations on bodies that turn in which the spaces differ, under the same names, so that all else is written
// once.
//
// Guarantee: free functions found by their arguments, of `graze` for three dimensions and of `graze::plane` for two.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dynamics/turning.hpp"
#include "graze/angles.hpp"
#include "graze/plane/rigid.hpp"
#include "graze/rigid.hpp"
#include "shape/reach.hpp"

namespace graze {

template <class Space>
using RotationIn = typename Rigid<Space>::Rotation;
template <class Space>
using MotionIn = typename Rigid<Space>::Motion;
template <class Space>
using FreeBodyIn = typename Rigid<Space>::FreeBody;
template <class Space>
using InertiaIn = typename Rigid<Space>::Inertia;
template <class Space>
using InverseMassIn = typename Rigid<Space>::InverseMass;

/// A body that nothing pushes as one that keeps its `spin`.
template <class T>
FreeBody<T> spinning(FreeBody<T> body, const Vec3<T>& spin) {
  body.inverse_inertia = {T(1), T(1), T(1)};
  body.angular_momentum = spin;
  return body;
}

/// A tensor that is diagonal about the principal axes, in world space.
template <class T>
Mat3<T> in_world(const Vec3<T>& diagonal, const Quat<T>& rotation) {
  const Mat3<T> r = rotation_matrix(rotation);
  return r * Mat3<T>::diagonal(diagonal) * transposed(r);
}

/// The inertia, with zero in place of an infinite one: about such an axis a body never gains angular momentum, so that
/// any number will do.
template <class T>
Vec3<T> finite_inertia(const Vec3<T>& inertia, const Vec3<T>& inverse) {
  return {inverse.x > T(0) ? inertia.x : T(0), inverse.y > T(0) ? inertia.y : T(0),
          inverse.z > T(0) ? inertia.z : T(0)};
}

/// The angular momentum of a change of the angular velocity.
template <class T>
Vec3<T> momentum_of(const FreeBody<T>& body, const Vec3<T>& inertia, const Vec3<T>& angular) {
  Vec3<T> gained = rotate(conjugate(body.rotation), angular);
  for (std::size_t i = 0; i < 3; ++i) gained[i] = body.inverse_inertia[i] > T(0) ? gained[i] * inertia[i] : T(0);
  return rotate(body.rotation, gained);
}

/// The axis times the angle of the turn from one rotation to another, the shorter way: in vector part v and w,
/// 2 atan2(|v|, w) v / |v|; as a rate, over `time`.
template <class T>
Vec3<T> turning_between(const Quat<T>& from, const Quat<T>& to, T time) {
  Quat<T> turn = to * conjugate(from);
  if (turn.w < T(0)) turn = {-turn.x, -turn.y, -turn.z, -turn.w};
  const T sine = length(turn.vector());
  const T per_sine = sine > T(0) ? T(2) * angle_of(turn.w, sine) / sine : T(2);
  return turn.vector() * (per_sine / time);
}

/// A turning that leads to the same rotation in this time, by whole turns as near to `like` as can be.
template <class T>
Vec3<T> by_whole_turns(const Vec3<T>& turning, const Vec3<T>& like, T time) {
  const T turn = T(2) * std::numbers::pi_v<T> / time;
  const Vec3<T> axis = normalized(turning, normalized(like, Vec3<T>{}));
  return turning + axis * (turn * std::floor(dot(like - turning, axis) / turn + T(0.5)));
}

/// The change of `v` by turning it back: `rotate(conjugate(q), v) - v`, without the rounding of the difference.
template <class S>
Vec3<S> turned_back_by(const Quat<S>& q, const Vec3<S>& v) {
  const Vec3<S> t = cross(v, q.vector()) * S(2);
  return t * q.w + cross(t, q.vector());
}

template <class T>
bool is_finite(const Quat<T>& rotation) {
  return std::isfinite(rotation.x + rotation.y + rotation.z + rotation.w);
}
/// Whether the coordinates are numbers that bodies may have; a NaN among them is none, whichever it is.
template <class T>
bool is_accepted(const Vec3<T>& v) {
  return std::abs(v.x) <= largest_magnitude<T> && std::abs(v.y) <= largest_magnitude<T> &&
         std::abs(v.z) <= largest_magnitude<T>;
}

/// The point or turning; throws `InvalidValue` for one that is not finite or too large.
template <class T>
Vec3<T> checked_vector(const Vec3<T>& v, const char* path) {
  return validate::point(v, path);
}

/// The least of `ways`, one for each axis, along the axes along which a shape of these extents is no surface. A surface
/// is thinner than a thousandth of its largest extent: that is rounding or relief, and no size.
template <class T, std::size_t N>
T least_across(const std::array<T, N>& extents, const std::array<T, N>& ways) {
  const T largest = *std::max_element(extents.begin(), extents.end());
  T least_way = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < N; ++i)
    if (extents[i] > largest * T(1e-3)) least_way = least(least_way, ways[i]);
  return least_way;
}

template <class T>
std::array<T, 3> coordinates(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}
template <class T>
std::array<T, 2> coordinates(const plane::Vec2<T>& v) {
  return {v.x, v.y};
}

/// The least extent of a shape along its axes; infinite for a half-space, and for a surface its thickness.
template <class T>
T size_of(const Shape<T>& shape) {
  if (shape.template as<HalfSpace<T>>()) return std::numeric_limits<T>::infinity();
  const auto extents = coordinates(bounds(shape, Pose<T>{}).extent());
  return least_across(extents, extents);
}

namespace plane {

template <class T>
constexpr Rot2<T> conjugate(const Rot2<T>& q) {
  return inverse(q);
}

template <class T>
constexpr Pose2<T> inverse(const Pose2<T>& pose) {
  return {inverse_rotate(pose.rotation, -pose.translation), inverse(pose.rotation)};
}

template <class T>
FreeBody<T> spinning(FreeBody<T> body, const T& spin) {
  body.inverse_inertia = T(1);
  body.angular_momentum = spin;
  return body;
}
template <class T>
T in_world(const T& inertia, const Rot2<T>&) {
  return inertia;
}
template <class T>
T momentum_of(const FreeBody<T>& body, const T& inertia, const T& angular) {
  return body.inverse_inertia > T(0) ? angular * inertia : T(0);
}
template <class T>
T turning_between(const Rot2<T>& from, const Rot2<T>& to, T time) {
  const Rot2<T> turn = to * conjugate(from);
  return angle_of(turn.cosine, turn.sine) / time;
}
template <class S>
Vec2<S> turned_back_by(const Rot2<S>& q, const Vec2<S>& v) {
  return inverse_rotate(q, v) - v;
}
template <class T>
bool is_finite(const Rot2<T>& rotation) {
  return std::isfinite(rotation.cosine + rotation.sine);
}
template <class T>
bool is_accepted(const Vec2<T>& v) {
  return std::abs(v.x) <= largest_magnitude<T> && std::abs(v.y) <= largest_magnitude<T>;
}
template <class T>
Vec2<T> checked_vector(const Vec2<T>& v, const char* path) {
  return plane::detail::checked_point(v, path);
}
/// The radius of the disc about the shape's origin that holds it; infinite for a shape without end.
template <class T>
T reach_of(const Shape<T>& shape) {
  return Space<T>::speed_of_turning(shape, T(1));
}
template <class T>
T size_of(const Shape<T>& shape) {
  if (shape.template as<HalfPlane<T>>()) return std::numeric_limits<T>::infinity();
  const Aabb2<T> box = bounds(shape, Pose2<T>{});
  const auto extents = coordinates(box.upper - box.lower);
  return least_across(extents, extents);
}

}  // namespace plane

/// The way from a shape's centre of mass to the nearest side of the box of its extents: half of its size for one that
/// is alike on both sides, half of that for a cone. A sixteenth of its size at least, wherever the centre may be.
template <class Shape, class Vec>
auto depth_of_center(const Shape& shape, const Vec& center) {
  using T = std::decay_t<decltype(center.x)>;
  const T size = size_of(shape);
  if (!std::isfinite(size)) return size;
  const auto box = bounds(shape, {});
  const auto extents = coordinates(box.upper - box.lower), below = coordinates(center - box.lower),
             above = coordinates(box.upper - center);
  return greatest(least(size / T(2), least(least_across(extents, below), least_across(extents, above))), size / T(16));
}

/// The operations of vectors for turnings of the plane, which are plain numbers: their type has no namespace in which
/// such names would be found.
template <std::floating_point T>
T finite_inertia(const T& inertia, const T& inverse) {
  return inverse > T(0) ? inertia : T(0);
}
template <std::floating_point T>
T by_whole_turns(const T& turning, const T& like, T time) {
  const T turn = T(2) * std::numbers::pi_v<T> / time;
  return turning + turn * std::floor((like - turning) / turn + T(0.5));
}
template <std::floating_point T>
bool is_accepted(const T& turning) {
  return std::abs(turning) <= largest_magnitude<T>;
}
template <std::floating_point T>
T checked_vector(const T& turning, const char* path) {
  if (const char* expectation = validate::fault_of_coordinate(turning))
    validate::fail(path, expectation, static_cast<double>(turning));
  return turning;
}

}  // namespace graze
