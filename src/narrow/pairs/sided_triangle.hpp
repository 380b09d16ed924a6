// A triangle as points and segments look at it, in double: what of it is nearest, and its name.
//
// Guarantee: an answer is given only where rounding leaves its direction known; else nothing. The nearest place is
// right to the rounding of the coordinates, the direction to six digits, over the face to all.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "graze/geometry.hpp"
#include "graze/shape/triangle.hpp"
#include "narrow/features.hpp"
#include "narrow/outline.hpp"

namespace graze {

/// How high a triangle has to be over its longest side, relative to that side. In thinner ones two edges are about the
/// same line, and which of them touches is rounding.
inline constexpr double thinnest_triangle = 1.0 / 1024;

/// From how many roundings off an edge or a corner the line from there to a point is a normal, right to six digits. A
/// face has a normal of its own: one rounding tells on which side the point is.
inline constexpr double roundings_off_edge = 1e6;

/// A point and the place of a triangle nearest to it.
struct NearTriangle {
  Vec3d place, outward;  ///< outward: the unit vector from the place to the point
  double distance;
};

/// The same of a segment.
struct SegmentNearTriangle {
  NearTriangle at;
  double along;  ///< where on the segment, of its length
};

/// A triangle with what its questions share.
class SidedTriangle {
 public:
  template <class T>
  explicit SidedTriangle(const Triangle<T>& triangle)
      : point_{cast<double>(triangle.point(0)), cast<double>(triangle.point(1)), cast<double>(triangle.point(2))},
        along_{point_[1] - point_[0], point_[2] - point_[1], point_[0] - point_[2]},
        squared_{length_squared(along_[0]), length_squared(along_[1]), length_squared(along_[2])},
        across_(cross(along_[0], along_[1])),
        area_squared_(length_squared(across_)) {}

  bool thin() const {
    // A guard of double's range: below this, of sides of 1e-50, the products of five lengths, which tell the sides, run
    // out of digits. How thin a triangle may be, `thinnest_triangle` tells.
    constexpr double least_area_squared = 1e-200;
    const double longest = greatest(squared_[0], greatest(squared_[1], squared_[2]));
    return !(area_squared_ > least_area_squared &&
             area_squared_ > thinnest_triangle * thinnest_triangle * longest * longest);
  }
  /// Of its points from the origin of its frame.
  double extent() const {
    return std::sqrt(
        greatest(length_squared(point_[0]), greatest(length_squared(point_[1]), length_squared(point_[2]))));
  }

  /// Of one that is not thin; nothing where `noise`, the rounding of the coordinates, hides the direction.
  std::optional<NearTriangle> nearest_to(const Vec3d& p, double noise) const {
    // What is nearest lies on one of the edges that the point is beyond, or else below it (Ericson 2005, section
    // 5.1.5).
    double least_squared = std::numeric_limits<double>::infinity();
    Vec3d best{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d from = p - point_[i];
      if (dot(cross(across_, along_[i]), from) >= 0) continue;
      const double t = clamp(dot(from, along_[i]) / squared_[i], 0.0, 1.0);
      const Vec3d place = t < 1 ? point_[i] + along_[i] * t : point_[i == 2 ? 0 : i + 1];
      const double squared = length_squared(p - place);
      if (!(squared < least_squared)) continue;
      least_squared = squared;
      best = place;
    }
    if (least_squared == std::numeric_limits<double>::infinity()) return below(p, noise);
    const double distance = std::sqrt(least_squared);
    if (!(distance > roundings_off_edge * noise)) return std::nullopt;
    return NearTriangle{best, (p - best) / distance, distance};
  }

  /// Where a segment comes nearest to an edge, if a plane between the two shows that nothing is nearer.
  std::optional<SegmentNearTriangle> nearest_across(const Segment<double>& s, double noise) const {
    double least_squared = std::numeric_limits<double>::infinity(), along = 0;
    Vec3d place{}, from{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Segment<double> edge{point_[i], point_[i == 2 ? 0 : i + 1]};
      const auto [at, on_edge] = closest_parameters(s, edge);
      const Vec3d p = point_at(s, at), q = point_at(edge, on_edge);
      const double squared = length_squared(p - q);
      if (!(squared < least_squared)) continue;
      least_squared = squared;
      along = at;
      from = p;
      place = q;
    }
    const double distance = std::sqrt(least_squared);
    if (!(distance > roundings_off_edge * noise)) return std::nullopt;
    const Vec3d outward = (from - place) / distance;
    const double highest = greatest(dot(point_[0] - place, outward),
                                    greatest(dot(point_[1] - place, outward), dot(point_[2] - place, outward))),
                 lowest = least(dot(s.a - from, outward), dot(s.b - from, outward));
    if (highest > noise || lowest < -noise) return std::nullopt;
    return SegmentNearTriangle{{place, outward, distance}, along};
  }

  /// The name of what a place on the triangle lies on, for contacts whose normal is `outward`, off the triangle: as the
  /// general path names it, which sees the whole triangle unless that leans further than `side_lean`.
  std::uint32_t feature(const Vec3d& place, const Vec3d& outward) const {
    const double facing = dot(across_, outward);
    const bool whole = facing * facing >= (1 - side_lean<double> * side_lean<double>)*area_squared_;
    double seen[3], nearest_squared = same_place * same_place;
    bool on[3];
    if (whole) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double rise = dot(along_[i], outward);
        seen[i] = squared_[i] - rise * rise;
      }
      nearest_squared *= least(seen[0], least(seen[1], seen[2]));
      for (std::size_t i = 0; i < 3; ++i) {
        const double turned = dot(cross(along_[i], place - point_[i]), outward), inside = facing > 0 ? turned : -turned;
        on[i] = inside <= 0 || inside * inside <= nearest_squared * seen[i];
      }
      if (!(on[0] || on[1] || on[2])) return face_feature(facing > 0 ? 0 : 1);
    } else {
      // On the edge that it is nearest to, or at an end of that.
      const std::size_t edge = nearest_edge(place), next = edge == 2 ? 0 : edge + 1;
      for (const std::size_t end : {edge, next})
        if (length_squared(place - point_[end]) <= nearest_squared * squared_[edge])
          return vertex_feature(static_cast<std::uint32_t>(end));
      for (std::size_t i = 0; i < 3; ++i) on[i] = i == edge;
    }
    if (on[0] && on[1]) return vertex_feature(1);
    if (on[1] && on[2]) return vertex_feature(2);
    if (on[2] && on[0]) return vertex_feature(0);
    return on[0] ? edge_feature(0, 1) : on[1] ? edge_feature(1, 2) : edge_feature(0, 2);
  }

 private:
  std::optional<NearTriangle> below(const Vec3d& p, double noise) const {
    const Vec3d normal = across_ / std::sqrt(area_squared_);
    const double height = dot(p - point_[0], normal), distance = std::abs(height);
    if (!(distance > noise)) return std::nullopt;
    return NearTriangle{p - normal * height, height > 0 ? normal : -normal, distance};
  }
  std::size_t nearest_edge(const Vec3d& place) const {
    std::size_t nearest = 0;
    double least_squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const double squared = length_squared(cross(along_[i], place - point_[i])) / squared_[i];
      if (!(squared < least_squared)) continue;
      least_squared = squared;
      nearest = i;
    }
    return nearest;
  }

  Vec3d point_[3], along_[3];  ///< along: the edge from a point to the next
  double squared_[3];          ///< of the edges
  Vec3d across_;               ///< as long as twice the area, to the front
  double area_squared_;        ///< of four times the square of the area
};

}  // namespace graze
