// The depth of a point inside a core, in closed form: any translation that moves a point of one core out of the other
// is at least as long, which proves a depth without a search (the distance to the boundary of a convex body is the
// least over all directions).
//
// Guarantee: no more than the true depth but for rounding; negative for a point outside, minus infinity for cores
// without a closed form. All in double, in the frame of the shape.
#pragma once

#include <cmath>
#include <limits>

#include "graze/shape.hpp"

namespace graze {

/// The least distance to the three lines of the profile, which is a trapezoid that turns about Y.
template <class T>
double inside_core(const Cylinder<T>& c, const Vec3d& point) {
  const auto half = static_cast<double>(c.half_height()), bottom = static_cast<double>(c.radius_bottom()),
             top = static_cast<double>(c.radius_top());
  const double across = std::sqrt(point.x * point.x + point.z * point.z), taper = bottom - top, height = 2 * half;
  const double slant = std::sqrt(height * height + taper * taper);
  if (!(slant > 0)) return -across;
  // The line through (bottom, -half) and (top, half), from which its normal (height, taper) / slant leads outward.
  const double side = ((bottom - across) * height - (point.y + half) * taper) / slant;
  return least(half - std::abs(point.y), side);
}
/// The depth in the core of a tapered capsule: a ball and a point, and the cone between them (as of two balls).
template <class T>
double inside_core(const Capsule<T>& c, const Vec3d& point) {
  const auto half = static_cast<double>(c.half_height()), core = static_cast<double>(c.core_radius());
  const double bottom = static_cast<double>(c.radius_bottom()) - core, top = static_cast<double>(c.radius_top()) - core;
  const double across = std::sqrt(point.x * point.x + point.z * point.z), taper = bottom - top, height = 2 * half;
  const auto inside_ball = [&](double radius, double y) {
    return radius - std::sqrt(across * across + (point.y - y) * (point.y - y));
  };
  if (std::abs(taper) >= height) return taper > 0 ? inside_ball(bottom, -half) : inside_ball(top, half);
  // Position along the side's generator from where it leaves the lower ball: the lower ball is nearest before it, the
  // upper one beyond its end.
  const double sine = taper / height, cosine = std::sqrt((1 - sine) * (1 + sine));
  const double along = cosine * (point.y + half) - sine * across;
  if (along <= 0) return inside_ball(bottom, -half);
  if (along >= cosine * height) return inside_ball(top, half);
  return bottom - cosine * across - sine * (point.y + half);
}
template <class T>
double inside_core(const Box<T>& box, const Vec3d& point) {
  const Vec3d beside = converted<double>(box.half_extents()) - abs(point);
  return least(beside.x, least(beside.y, beside.z));
}
template <class C>
double inside_core(const C&, const Vec3d&) {
  return -std::numeric_limits<double>::infinity();
}

template <class T>
double inside_core_of(const Shape<T>& shape, const Vec3d& point) {
  return shape.visit([&](const auto& concrete) { return inside_core(concrete, point); });
}

}  // namespace graze
