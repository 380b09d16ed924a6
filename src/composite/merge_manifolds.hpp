// Manifolds of neighbouring pieces that share a normal become one.
//
// Guarantee: each group stands where its first manifold was found and keeps its points in the order found, but for
// those that coincide with an earlier one on both shapes (a vertex that two triangles share), of which the lowest
// pieces give the number. What is held stays within twice of what is handed out.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "composite/point_names.hpp"
#include "composite/spanning_points.hpp"
#include "graze/contact.hpp"

namespace graze {

/// Two normals are one when they differ by less than the rounding of a quaternion's rotation, some ten operations.
template <class T>
inline constexpr T same_normal = T(64) * std::numeric_limits<T>::epsilon();

namespace detail {

/// Drops the points that repeat an earlier one, which shares its name. n log n, but for few, which are compared with
/// each other.
template <class T>
void keep_different(std::vector<ContactPoint<T>>& points, const PointNames& names) {
  const auto same = [](const ContactPoint<T>& p, const ContactPoint<T>& q) { return p.a == q.a && p.b == q.b; };
  std::size_t kept = 0;
  if (points.size() <= 16) {
    for (const ContactPoint<T>& p : points) {
      const auto end = points.begin() + static_cast<std::ptrdiff_t>(kept);
      const auto earlier = std::find_if(points.begin(), end, [&](const ContactPoint<T>& q) { return same(p, q); });
      if (earlier == end)
        points[kept++] = p;
      else
        names.share(*earlier, p);
    }
  } else {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i, std::size_t k) { return k < 3 ? points[i].a[k] : points[i].b[k - 3]; };
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      for (std::size_t k = 0; k < 6; ++k)
        if (key(i, k) != key(j, k)) return key(i, k) < key(j, k);
      return i < j;
    });
    std::vector<char> repeats(points.size(), 0);
    for (std::size_t i = 1, earliest = 0; i < order.size(); ++i) {
      repeats[order[i]] = same(points[order[i - 1]], points[order[i]]) ? 1 : 0;
      if (repeats[order[i]] == 0) earliest = i;
      names.share(points[order[earliest]], points[order[i]]);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!repeats[i]) points[kept++] = points[i];
  }
  points.resize(kept);
}

/// The place, for each manifold, of the first one with its normal.
template <class T>
std::vector<std::size_t> leaders(std::span<const Manifold<T>> manifolds) {
  // Sorted along a direction that no model is built along, so that normals near each other there are few.
  const Vec3<T> along{T(0.4767), T(0.6229), T(0.6203)};
  // Normals that differ by so much in each coordinate differ by less than twice that along a unit vector.
  const T window = T(2) * same_normal<T>;
  std::vector<std::pair<T, std::size_t>> order(manifolds.size());
  for (std::size_t i = 0; i < manifolds.size(); ++i) order[i] = {dot(manifolds[i].normal, along), i};
  std::sort(order.begin(), order.end());

  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> leader(manifolds.size(), none), group;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3<T>& normal = manifolds[order[i].second].normal;
    if (leader[order[i].second] != none) continue;
    group.clear();
    for (std::size_t j = i; j < order.size() && order[j].first - order[i].first <= window; ++j) {
      const std::size_t other = order[j].second;
      if (leader[other] == none && max_abs(manifolds[other].normal - normal) <= same_normal<T>) group.push_back(other);
    }
    const std::size_t front = *std::min_element(group.begin(), group.end());
    for (const std::size_t member : group) leader[member] = front;
  }
  return leader;
}

}  // namespace detail

/// Passes on that a member is not proven to the manifold that it joins.
template <class T>
void join_status(Manifold<T>& joined, const Manifold<T>& member) {
  if (member.status != Status::bounded) return;
  joined.status = member.status;
  joined.error = greatest(joined.error, member.error);
}

/// Joins the manifolds from `first` on that share a normal.
template <class T>
void group_by_normal(Manifolds<T>& manifolds, std::size_t first, const PointNames& names) {
  const std::size_t count = manifolds.size() - first;
  if (count < 2) return;
  const std::vector<std::size_t> leader = detail::leaders(std::span<const Manifold<T>>(manifolds).subspan(first));
  std::size_t different = 0;
  while (different < count && leader[different] == different) ++different;
  if (different == count) return;
  // The members of each group, one behind the other.
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return leader[i] < leader[j]; });

  std::size_t kept = first;
  std::vector<ContactPoint<T>> points;
  for (std::size_t i = 0, end = 0; i < count; i = end) {
    const std::size_t front = leader[order[i]];
    while (end < count && leader[order[end]] == front) ++end;
    // Groups come in the order of their first member, so that none is overwritten before it is read.
    Manifold<T> joined = manifolds[first + front];
    if (end - i > 1) {
      points.clear();
      for (std::size_t k = i; k < end; ++k) {
        const Manifold<T>& member = manifolds[first + order[k]];
        join_status(joined, member);
        for (const ContactPoint<T>& p : member.points) points.push_back(p);
      }
      detail::keep_different(points, names);
      joined.points.clear();
      for (const ContactPoint<T>& p : points) joined.points.push_back(p);
    }
    manifolds[kept++] = std::move(joined);
  }
  manifolds.resize(kept);
}

/// Manifolds as they are found, joined whenever what is held of them has doubled: by their points, since a join sorts
/// all of these, and thousands may have become one manifold (a flat mesh on another).
template <class T>
class ManifoldGroups {
 public:
  /// Appends to `manifolds`; what is there stays apart.
  explicit ManifoldGroups(Manifolds<T>& manifolds) : manifolds_(manifolds), first_(manifolds.size()) {}

  /// Points have no feature numbers from here on, but places in a list of them, until `name_points`.
  void add(const Manifold<T>& manifold, const LeafPair& leaves) {
    manifolds_.push_back(manifold);
    names_.take(manifolds_.back(), leaves);
    held_ += size_of(manifold);
    if (held_ < next_) return;
    finish();
    PointNames kept;
    held_ = 0;
    for (std::size_t i = first_; i < manifolds_.size(); ++i) {
      held_ += size_of(manifolds_[i]);
      for (ContactPoint<T>& p : manifolds_[i].points) names_.move_to(kept, p);
    }
    names_ = std::move(kept);
    next_ = 2 * held_ + few;
  }
  void finish() { group_by_normal(manifolds_, first_, names_); }
  /// Leaves out the points that others span, and gives the points their feature numbers again. Nothing may be added
  /// after. `size`: of the smaller shape.
  void name_spanning(T size) {
    for (std::size_t i = first_; i < manifolds_.size(); ++i) keep_spanning(manifolds_[i], size, names_);
    name_points();
  }
  /// Gives the points their feature numbers again. Nothing may be added after.
  void name_points() {
    for (std::size_t i = first_; i < manifolds_.size(); ++i) names_.give(manifolds_[i]);
  }

 private:
  static constexpr std::size_t room = 8;          ///< a manifold takes the memory of so many points, if it has none
  static constexpr std::size_t few = 256 * room;  ///< points
  static std::size_t size_of(const Manifold<T>& manifold) { return room + manifold.points.size(); }

  Manifolds<T>& manifolds_;
  PointNames names_;
  std::size_t first_, held_ = 0, next_ = few;
};

}  // namespace graze
