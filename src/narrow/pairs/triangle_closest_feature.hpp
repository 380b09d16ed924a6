// The feature of a triangle nearest to a point or a segment, by Voronoi regions (Ericson 2005, section 5.1.5), across
// lanes.
//
// Guarantee: an answer is `known` only where rounding leaves its direction known. Then the nearest place is right to
// the rounding of the coordinates, the direction to six digits, over the face to all. In every lane the bits that a
// triangle alone gives. For double only: the bounds are derived from its digits.
#pragma once

#include <cmath>
#include <limits>

#include "graze/geometry.hpp"
#include "narrow/core/core.hpp"
#include "narrow/manifold/polygon.hpp"
#include "narrow/pairs/triangle_parts.hpp"
#include "simd/axis_permutation.hpp"

namespace graze {

/// Least height of a triangle over its longest side, relative to that side. In thinner ones two edges are about the
/// same line, and rounding decides which of them touches.
inline constexpr double thinnest_triangle = 1.0 / 1024;

/// Distance from an edge or a corner, in roundings, from which on the line to a point is a normal with six digits. A
/// face has a normal of its own: one rounding suffices to decide on which side the point is.
inline constexpr double roundings_off_edge = 1e6;

/// A point and the place of a triangle nearest to it. Meaningless where not known.
template <class S>
struct NearTriangle {
  Vec3<S> place, outward;  ///< outward: the unit vector from the place to the point
  S distance;
  decltype(S() < S()) known;
};
template <class M, class S>
NearTriangle<S> select(const M& condition, const NearTriangle<S>& yes, const NearTriangle<S>& no) {
  NearTriangle<S> near{select(condition, yes.place, no.place), select(condition, yes.outward, no.outward),
                       select(condition, yes.distance, no.distance), no.known};
  near.known = select(condition, yes.known, no.known);
  return near;
}

/// The nearest places of a segment and a triangle.
template <class S>
struct SegmentNearTriangle {
  NearTriangle<S> at;
  S along;  ///< position on the segment, relative to its length
};

/// A triangle seen along a direction away from it, from its front or its back.
template <class S>
struct SeenTriangle {
  using Mask = decltype(S() < S());

  Vec3<S> inward[3];  ///< perpendicular to an edge as seen, and as long as the edge is seen
  S squared[3];       ///< squared lengths of the edges as seen
  S face;             ///< part number of the side that is seen

  S shortest_squared() const { return least(squared[0], least(squared[1], squared[2])); }
  /// The part on which a place is seen: `inside(i)` is its distance inward of an edge, times the edge's length as seen.
  /// `near_squared`: squared distance within which an edge counts.
  template <class Inside>
  S part(const Inside& inside, const S& near_squared) const {
    const auto on_edge = [&](std::size_t i) -> Mask {
      const S inward_by = inside(i);
      return (inward_by <= S(0)) | (inward_by * inward_by <= near_squared * squared[i]);
    };
    const Mask on0 = on_edge(0), on1 = on_edge(1), on2 = on_edge(2);
    if (!any(on0 | on1 | on2)) return face;
    const S beside_0 = select(on1, S(1), select(on2, S(0), edge_from(0))), beside_1 = select(on2, S(2), edge_from(1));
    return select(on0, beside_0, select(on1, beside_1, select(on2, edge_from(2), face)));
  }
  /// The part of the edge that starts at vertex i.
  static S edge_from(std::size_t i) { return S(static_cast<double>(edge_part + (i + 2) % 3)); }
};

/// The feature of a triangle seen along a direction that leans too far from its normal: an edge, or only a vertex.
template <class S>
struct TriangleRim {
  S edge;                       ///< number of the edge: that of the vertex it starts at
  Vec3<S> start, way;           ///< start of the edge, and the vector to its end
  S squared;                    ///< squared length of the edge
  S top;                        ///< number of the vertex furthest out
  decltype(S() < S()) pointed;  ///< only that vertex is seen
};

/// A triangle with data that its queries share.
template <class S>
class TriangleRegions {
  using Mask = decltype(S() < S());
  static constexpr double infinity = std::numeric_limits<double>::infinity();

 public:
  explicit TriangleRegions(const TriangleCore<S>& of)
      : point_{of.point[0], of.point[1], of.point[2]},
        along_{point_[1] - point_[0], point_[2] - point_[1], point_[0] - point_[2]},
        squared_{length_squared(along_[0]), length_squared(along_[1]), length_squared(along_[2])},
        across_(cross(along_[0], along_[1])),
        area_squared_(length_squared(across_)) {}

  /// Whether the triangle is thick enough for the queries below.
  Mask regular() const {
    // A guard of double's range: below this, for sides of 1e-50, the products of five lengths that decide on which side
    // of an edge a point is run out of digits. The thickness is bounded by `thinnest_triangle`.
    constexpr double least_area_squared = 1e-200;
    const S longest = greatest(squared_[0], greatest(squared_[1], squared_[2]));
    return (area_squared_ > S(least_area_squared)) &
           (area_squared_ > S(thinnest_triangle * thinnest_triangle) * longest * longest);
  }
  /// The largest distance of its points from the origin of its frame.
  S extent() const {
    using std::sqrt;
    return sqrt(greatest(length_squared(point_[0]), greatest(length_squared(point_[1]), length_squared(point_[2]))));
  }

  /// The place nearest to a point. Not known where `noise`, the rounding of the coordinates, hides the direction.
  NearTriangle<S> nearest_to(const Vec3<S>& p, const S& noise) const {
    using std::sqrt;
    // The nearest place lies on one of the edges that the point is beyond, or else straight below it (Ericson 2005,
    // section 5.1.5).
    S least_squared(infinity);
    Vec3<S> best{S(0), S(0), S(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<S> from = p - point_[i];
      const Mask beyond = dot(side(i), from) < S(0);
      if (!any(beyond)) continue;
      const S t = clamp(dot(from, along_[i]) / squared_[i], S(0), S(1));
      const Vec3<S> place = select(t < S(1), point_[i] + along_[i] * t, point_[next(i)]);
      const S squared = length_squared(p - place);
      const Mask nearer = beyond & (squared < least_squared);
      least_squared = select(nearer, squared, least_squared);
      best = select(nearer, place, best);
    }
    const Mask inside = least_squared == S(infinity);
    if (all(inside)) return below(p, noise);
    const S distance = sqrt(least_squared);
    const NearTriangle<S> of_edge{best, (p - best) / distance, distance, distance > S(roundings_off_edge) * noise};
    return any(inside) ? select(inside, below(p, noise), of_edge) : of_edge;
  }

  /// The nearest places of the edges and a segment from `start` along `d`, which is not zero; known if a plane between
  /// the two proves that nothing is nearer.
  SegmentNearTriangle<S> nearest_across(const Vec3<S>& start, const Vec3<S>& d, const S& noise) const {
    using std::sqrt;
    const S per_squared = S(1) / length_squared(d);
    S least_squared(infinity), along(0);
    Vec3<S> place{S(0), S(0), S(0)}, to = place;
    for (std::size_t i = 0; i < 3; ++i) {
      // No such plane touches an edge that the segment is nowhere beyond.
      const Vec3<S> r = start - point_[i];
      const S from_start = dot(side(i), r);
      const Mask beyond = least(from_start, from_start + dot(side(i), d)) < S(0);
      if (!any(beyond)) continue;
      // The nearest points of the two lines, clamped; then the point of the edge nearest to that, clamped; then that of
      // the segment (Ericson 2005, section 5.1.9). By a cross product, which loses no digits for near-parallel lines.
      const Vec3<S>& e = along_[i];
      const Vec3<S> n = cross(d, e);
      const S nn = length_squared(n), at_line = clamp(dot(cross(e, r), n) / select(nn > S(0), nn, S(1)), S(0), S(1)),
              on_edge = clamp(dot(e, r + d * at_line) / squared_[i], S(0), S(1));
      const Vec3<S> between = r - e * on_edge;
      const S at = clamp(-dot(d, between) * per_squared, S(0), S(1));
      const Vec3<S> gap = between + d * at;
      const S squared = length_squared(gap);
      const Mask nearer = beyond & (squared < least_squared);
      least_squared = select(nearer, squared, least_squared);
      along = select(nearer, at, along);
      to = select(nearer, gap, to);
      place = select(nearer, point_[i] + e * on_edge, place);
    }
    const S distance = sqrt(least_squared);
    const Vec3<S> outward = to / distance;
    const auto above = [&](const Vec3<S>& p) { return dot(p - place, outward); };
    const S highest = greatest(above(point_[0]), greatest(above(point_[1]), above(point_[2]))),
            lowest = least(above(start), above(start + d)) - distance;
    const Mask known = (distance > S(roundings_off_edge) * noise) & (highest <= noise) & (lowest >= -noise);
    return {{place, outward, distance, known}, along};
  }

  const Vec3<S>& point(std::size_t i) const { return point_[i]; }
  /// The unit normal on the front side.
  Vec3<S> normal() const {
    using std::sqrt;
    return across_ / sqrt(area_squared_);
  }
  /// The component of a unit vector along the normal, times twice the area: positive on the front side.
  S facing(const Vec3<S>& outward) const { return dot(across_, outward); }
  /// Whether the general path sees the whole triangle along a vector with this `facing`.
  Mask seen_whole(const S& facing) const {
    return facing * facing >= S(1 - side_lean<double> * side_lean<double>) * area_squared_;
  }
  SeenTriangle<S> seen(const Vec3<S>& outward, const S& facing) const {
    const Mask front = facing > S(0);
    const Vec3<S> off_front = outward * select(front, S(1), S(-1));
    SeenTriangle<S> seen;
    seen.face = select(front, S(front_part), S(back_part));
    for (std::size_t i = 0; i < 3; ++i) {
      const S rise = dot(along_[i], outward);
      seen.squared[i] = squared_[i] - rise * rise;
      seen.inward[i] = cross(off_front, along_[i]);
    }
    return seen;
  }
  /// The edge or vertex that the general path sees where it does not see the whole: the flatter of the two edges that
  /// leave the vertex furthest out.
  TriangleRim<S> rim(const Vec3<S>& outward) const {
    const S height[3] = {dot(point_[0], outward), dot(point_[1], outward), dot(point_[2], outward)};
    const Mask second = height[1] > height[0], third = height[2] > greatest(height[0], height[1]);
    const auto fall = [&](std::size_t i) {
      const S down = height[i] - height[next(i)];
      return down * down;
    };
    const S falls[3] = {fall(0), fall(1), fall(2)};
    const auto flatter = [&](std::size_t i, std::size_t than) -> Mask {
      return falls[i] * squared_[than] < falls[than] * squared_[i];
    };
    TriangleRim<S> rim;
    rim.top = select(third, S(2), select(second, S(1), S(0)));
    rim.edge = select(third, select(flatter(1, 2), S(1), S(2)),
                      select(second, select(flatter(0, 1), S(0), S(1)), select(flatter(2, 0), S(2), S(0))));
    const AxisPermutation<S> one(rim.edge);
    rim.start = one.pick(point_[0], point_[1], point_[2]);
    rim.way = one.pick(along_[0], along_[1], along_[2]);
    rim.squared = one.pick(squared_[0], squared_[1], squared_[2]);
    rim.pointed = one.pick(falls[0], falls[1], falls[2]) > S(side_lean<double> * side_lean<double>) * rim.squared;
    return rim;
  }

  /// The part that a place on the triangle lies on, for contacts whose normal `outward` leads away from the triangle:
  /// as on the general path, which sees the whole triangle unless that leans further than `side_lean`.
  S part(const Vec3<S>& place, const Vec3<S>& outward) const {
    const S facing = this->facing(outward);
    const Mask whole = seen_whole(facing);
    S of_edge(0);
    if (!all(whole)) {
      of_edge = part_of_edge(place);
      if (!any(whole)) return of_edge;
    }
    return select(whole, part_of_face(place, outward, facing), of_edge);
  }
  /// The part where the whole triangle is seen. `near_other`: squared distance within which parts of the other shape
  /// count.
  S part_of_face(const Vec3<S>& place, const Vec3<S>& outward, const S& facing,
                 const S& near_other = S(infinity)) const {
    const SeenTriangle<S> seen = this->seen(outward, facing);
    const auto inside = [&](std::size_t i) { return dot(seen.inward[i], place - point_[i]); };
    return seen.part(inside, least(S(same_place * same_place) * seen.shortest_squared(), near_other));
  }

 private:
  static constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }
  /// A vector perpendicular to an edge, in the triangle's plane, inward.
  Vec3<S> side(std::size_t i) const { return cross(across_, along_[i]); }
  NearTriangle<S> below(const Vec3<S>& p, const S& noise) const {
    using std::abs;
    const Vec3<S> normal = this->normal();
    const S height = dot(p - point_[0], normal), distance = abs(height);
    return {p - normal * height, select(height > S(0), normal, -normal), distance, distance > noise};
  }
  /// The part of the edge nearest to a place: the edge or one of its ends.
  S part_of_edge(const Vec3<S>& place) const {
    S least_squared(infinity), part(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const S squared = length_squared(cross(along_[i], place - point_[i])) / squared_[i],
              near = S(same_place * same_place) * squared_[i];
      const auto at_end = [&](std::size_t end) -> Mask { return length_squared(place - point_[end]) <= near; };
      const Mask nearer = squared < least_squared;
      const auto number = [](std::size_t vertex) { return S(static_cast<double>(vertex)); };
      const S here =
          select(at_end(i), number(i), select(at_end(next(i)), number(next(i)), SeenTriangle<S>::edge_from(i)));
      least_squared = select(nearer, squared, least_squared);
      part = select(nearer, here, part);
    }
    return part;
  }

  Vec3<S> point_[3], along_[3];  ///< `along_`: the edge from a point to the next
  S squared_[3];                 ///< squared lengths of the edges
  Vec3<S> across_;               ///< normal on the front side, as long as twice the area
  S area_squared_;               ///< four times the square of the area
};

}  // namespace graze
