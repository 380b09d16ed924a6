// The impulse that ends the sliding of two bodies at a point.
//
// Guarantee: it lies across the normal, and changes the tangential velocity there by minus the sliding, up to rounding,
// whatever the two bodies' inertia couples. At least one of the bodies yields.
#pragma once

#include <utility>

#include "dynamics/rigid_space.hpp"
#include "graze/impulse.hpp"

namespace graze {

/// The matrix K: the change of the relative velocity at a point by an impulse on B there and its opposite on A.
template <class T>
struct Yielding {
  const InverseMass<T>& a;
  const InverseMass<T>& b;
  Vec3<T> from_a, from_b;  ///< the point seen from the centres of mass

  Vec3<T> operator*(const Vec3<T>& impulse) const {
    return impulse * (a.mass + b.mass) + cross(a.inertia * cross(from_a, impulse), from_a) +
           cross(b.inertia * cross(from_b, impulse), from_b);
  }
};

/// The impulse perpendicular to `normal` that changes the tangential velocity by minus `sliding`: the tangential
/// 2×2 block of K is solved by elimination, the larger pivot first, so that the smaller one stays positive.
template <class T>
Vec3<T> stopping(const Yielding<T>& k, const Vec3<T>& normal, const Vec3<T>& sliding) {
  Vec3<T> u = any_perpendicular(normal), v = cross(normal, u);
  Vec3<T> ku = k * u, kv = k * v;
  if (dot(u, ku) < dot(v, kv)) {
    std::swap(u, v);
    std::swap(ku, kv);
  }
  const T uu = dot(u, ku), uv = dot(u, kv), vv = dot(v, kv);
  const T factor = uv / uu;
  const T y = -(dot(v, sliding) - factor * dot(u, sliding)) / (vv - factor * uv);
  const T x = -(dot(u, sliding) + uv * y) / uu;
  return u * x + v * y;
}

/// The impulse on B at `point`, and its opposite on A, that ends a sliding of B over A.
template <class T>
Vec3<T> stopping_impulse(const StruckBody<T>& a, const StruckBody<T>& b, const Vec3<T>& point, const Vec3<T>& normal,
                         const Vec3<T>& sliding) {
  return stopping(Yielding<T>{a.mass, b.mass, point - a.motion.center, point - b.motion.center}, normal, sliding);
}

namespace plane {

template <class T>
Vec2<T> stopping_impulse(const graze::StruckBody<T, Space<T>>& a, const graze::StruckBody<T, Space<T>>& b,
                         const Vec2<T>& point, const Vec2<T>& normal, const Vec2<T>& sliding) {
  const Vec2<T> along = left(normal);
  const auto yields = [&](const auto& body) {
    const T turn = cross(point - body.motion.center, along);
    return body.mass.mass + body.mass.inertia * turn * turn;
  };
  return along * (-dot(sliding, along) / (yields(a) + yields(b)));
}

}  // namespace plane

}  // namespace graze
