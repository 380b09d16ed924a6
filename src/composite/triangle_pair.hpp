// A first look at two triangles: may they come within a limit?
//
// Guarantee: says no only where the signed distance exceeds the limit; rounding is allowed for. Costs some sixty
// products, where the pair's own routine costs a microsecond.
#pragma once

#include "shape/hierarchy_pairs.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

template <class T>
using Corners = std::array<Vec3<T>, 3>;

/// Whether something is more than `limit` from the plane of two edges u and v. `n`: their product; `along`: how far it
/// is along that, times its length; `reach`: the largest coordinate of what was projected for it, from a corner.
template <class T>
bool is_off_plane(const Vec3<T>& u, const Vec3<T>& v, const Vec3<T>& n, T along, T reach, T limit) {
  // A sliver's normal is mostly rounding: of each product of two differences half a unit in the last place, some six of
  // them times a third difference.
  const T noise = T(16) * std::numeric_limits<T>::epsilon() * max_abs(u) * max_abs(v) * reach;
  return signed_square(along - noise) > signed_square(limit) * length_squared(n);
}

/// Whether all of `b` may be kept within `limit` of the plane of `a`: along its normal, a triangle without thickness is
/// one number, and the signed distance is at least what parts that from the interval of the other.
template <class T>
bool may_come_within_plane(const Corners<T>& a, const Corners<T>& b, T limit, T slack) {
  const Vec3<T> u = a[1] - a[0], v = a[2] - a[0], n = cross(u, v);
  T low = std::numeric_limits<T>::infinity(), high = -low, reach = T(0);
  for (const Vec3<T>& p : b) {
    const Vec3<T> to = p - a[0];
    const T along = dot(n, to);
    low = least(low, along);
    high = greatest(high, along);
    reach = greatest(reach, max_abs(to));
  }
  return !is_off_plane(u, v, n, greatest(low, -high), reach, limit + slack);
}

/// Whether two triangles of one frame come within `limit` of each other along a unit vector from A to B: no distance is
/// less than what parts them along any. The best normal so far rules out nearly all pairs of two smooth surfaces.
template <class T>
bool may_come_within_along(const Corners<T>& a, const Corners<T>& b, const Vec3<T>& direction, T limit, T slack) {
  const T high = greatest(dot(a[0], direction), greatest(dot(a[1], direction), dot(a[2], direction)));
  const T low = least(dot(b[0], direction), least(dot(b[1], direction), dot(b[2], direction)));
  return !(low - high > limit + slack);
}

/// Two triangles of one frame. `slack`: what the rounding of their corners may be.
template <class T>
bool may_come_within(const Corners<T>& a, const Corners<T>& b, T limit, T slack) {
  if (BoxQuestion<T>{inflated(bounds_of(b), slack)}(bounds_of(a)) > signed_square(limit)) return false;
  return may_come_within_plane(a, b, limit, slack) && may_come_within_plane(b, a, limit, slack);
}

}  // namespace graze
