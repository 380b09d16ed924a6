// The common part of casts of one ray and of many: the ray in a shape's frame, all of its hits there, and a hit in the
// caller's frame.
//
// Guarantee: all in double, whatever the caller's scalar is; hits carry their position along the ray, in any order.
#pragma once

#include "composite/leaves.hpp"
#include "composite/solid.hpp"
#include "rays/convex_raycast.hpp"
#include "rays/surface.hpp"
#include "simd/flatten.hpp"

namespace graze::shape_rays {

using rays::end_of;
using rays::Frame;
using rays::frame_of;
using rays::LocalHit;
using rays::LocalRay;
using rays::longest;
using rays::opposing;

/// The ray in a frame, if it can hit.
template <class T>
GRAZE_FLATTEN std::optional<LocalRay> local_ray(const Ray<T>& ray, T length, const Frame& frame) {
  // Squares of its numbers must neither over- nor underflow. Zeros and infinities become NaN.
  Vec3d direction = converted<double>(ray.direction);
  if constexpr (!std::is_same_v<T, float>) direction = direction / max_abs(direction);
  const double end = end_of(ray, direction, length);
  if (end < 0) return {};
  // Normalised before the rotation, so that root and division do not wait for the frame.
  LocalRay local =
      seen_from(frame, {converted<double>(ray.origin), direction * (1 / graze::length(direction)), 0, end, 0});
  local.blur = 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * graze::length(local.origin);
  return local;
}

/// Calls `report(hit, triangle)` for the hits of a ray at a shape that is no compound; `report` returns the length up
/// to which the ray is still to be followed, less than zero to end.
template <class T, class Report>
[[gnu::always_inline]] inline void visit_single(const Shape<T>& shape, const LocalRay& ray, BackFaces back,
                                                const Report& report) {
  const bool both_sides = back == BackFaces::hit;
  if (const auto* mesh = shape.template as<Mesh<T>>())
    if (mesh->solid() && encloses(mesh->data(), ray.at(ray.begin)) && report(rays::hit_inside(ray), 0u) < ray.begin)
      return;
  if (with_surface(shape, [&](const auto& surface) { rays::cast_at_surface(surface, ray, both_sides, report); }))
    return;
  if (const auto hit = convex_raycast(shape, ray, back)) report(*hit, 0u);
}

/// Calls `found(hit, piece)` for the hits of a ray at a compound; `found` returns the length up to which the ray is
/// still to be followed. `frame` is the compound's in the frame of the outermost one, in which the ray and the hits are
/// given; `piece` is the child of the outermost, or null for the outermost itself.
template <class T, class Found>
[[gnu::noinline]] void visit_children(const Compound<T>& compound, const Frame& frame, LocalRay& outer, BackFaces back,
                                      const std::uint32_t* piece, Found& found) {
  const LocalRay ray = piece ? seen_from(frame, outer) : outer;
  const CompoundData<T>& data = compound.data();
  const auto cast_at_child = [&](std::uint32_t number) {
    const Placed<T>& child = data.children[number];
    const Frame placed = compose(frame, frame_of(child.pose));
    const std::uint32_t* named = piece ? piece : &number;
    if (const auto* inner = child.shape.template as<Compound<T>>()) {
      visit_children(*inner, placed, outer, back, named, found);
    } else {
      visit_single(child.shape, seen_from(placed, outer), back, [&](const LocalHit& hit, std::uint32_t) {
        return outer.end = found({hit.t, placed.translation + placed.out(hit.point), placed.out(hit.normal)}, *named);
      });
    }
    return outer.end >= outer.begin;
  };
  for (const std::uint32_t number : data.unbounded)
    if (!cast_at_child(number)) return;
  if (data.tree.empty()) return;
  // Rounding of some ten operations on coordinates up to these.
  const Aabb<T>& all = data.tree.bounds();
  const auto extent = static_cast<double>(greatest(max_abs(all.lower), max_abs(all.upper)));
  const double slack = ray.blur + 16 * rays::epsilon * (extent + max_abs(ray.origin));
  visit_ray(
      data.tree, ray.origin, rays::inverse_of(ray.direction), [&] { return outer.end; }, cast_at_child, ray.begin,
      slack);
}

/// Calls `found(hit, piece)` for the hits of a ray at any shape, in its own frame.
template <class T, class Found>
[[gnu::always_inline]] inline void visit_hits(const Shape<T>& shape, LocalRay& ray, BackFaces back, Found& found) {
  if (const auto* compound = shape.template as<Compound<T>>())
    visit_children(*compound, Frame{{}, Mat3d::identity()}, ray, back, nullptr, found);
  else
    visit_single(shape, ray, back, found);
}

/// A hit; of equal ones the one of the least piece comes first, in whichever order they are found.
struct Candidate {
  LocalHit hit{rays::infinity, {}, {}};
  std::uint32_t piece = 0;
};

template <class T>
GRAZE_FLATTEN RayHit<T> in_world(const Candidate& c, const Frame& frame, const Ray<T>& ray, T length) {
  const Vec3d normal = opposing(frame.out(c.hit.normal), converted<double>(ray.direction));
  const Vec3d point = frame.translation + frame.out(c.hit.point);
  return {least(static_cast<T>(c.hit.t), length), converted<T>(point), converted<T>(normal), c.piece};
}

inline bool before(const Candidate& a, const Candidate& b) {
  return a.hit.t != b.hit.t ? a.hit.t < b.hit.t : a.piece < b.piece;
}

/// The first hit; infinitely far along the ray where it misses.
template <class T>
[[gnu::always_inline]] inline Candidate first_hit(const Shape<T>& shape, LocalRay& ray, BackFaces back) {
  Candidate first;
  auto nearest = [&](const LocalHit& hit, std::uint32_t piece) {
    const Candidate found{hit, piece};
    if (before(found, first)) first = found;
    return first.hit.t;
  };
  visit_hits(shape, ray, back, nearest);
  return first;
}

template <class T>
[[gnu::always_inline]] inline bool hits_any(const Shape<T>& shape, LocalRay& ray, BackFaces back) {
  bool hit = false;
  auto stop = [&](const LocalHit&, std::uint32_t) {
    hit = true;
    return -rays::infinity;
  };
  visit_hits(shape, ray, back, stop);
  return hit;
}

}  // namespace graze::shape_rays
