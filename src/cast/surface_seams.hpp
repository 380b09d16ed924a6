// The edges at which a triangle of a mesh or height field goes on in others.
//
// Guarantee: a plane across a normal that leads over such an edge cuts the triangle beyond it, and so separates nothing
// from the surface, whatever it does to the one triangle. A body that is thin along such a normal would else slide into
// the seam between two triangles, each of which it leaves to one side.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "graze/shape.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

/// The sine from which on a normal leads over an edge. Corners rounded to float turn the plane of a triangle by some
/// ten-millionths; what is round and comes over an edge leans by the root of its distance, which is far more.
inline constexpr double over_edge = 1e-6;

/// The seams of one triangle, in the frame of its surface.
class SurfaceSeams {
 public:
  SurfaceSeams() = default;
  /// The seams of a triangle by its number. A sliver without a plane of its own has none.
  template <class Data>
  SurfaceSeams(const Data& data, std::uint32_t number) {
    const std::array<Vec3d, 3> own = corners(data, number);
    normal_ = normalized(cross(own[1] - own[0], own[2] - own[0]), Vec3d{});
    if (normal_ == Vec3d{}) return;
    const TrianglesAcross across = data.across(number);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& begin = own[i];
      const Vec3d along = normalized(own[(i + 1) % 3] - begin, Vec3d{});
      sides_[i] = {begin, cross(along, normal_)};
      is_rim_[i] = across[i] == no_triangle;
      if (is_rim_[i]) continue;
      // The corner beyond the edge is the one that lies furthest from its line.
      Vec3d beyond{}, far{};
      for (const Vec3d& corner : corners(data, across[i])) {
        const Vec3d aside = corner - begin - along * dot(corner - begin, along);
        if (length_squared(aside) > length_squared(beyond)) beyond = aside, far = corner;
      }
      beyond = normalized(beyond, Vec3d{});
      if (beyond != Vec3d{}) seams_[count_++] = {i, beyond, far};
    }
  }

  /// The triangle's unit normal; zero where it has no seams.
  const Vec3d& normal() const { return normal_; }
  /// Whether a unit vector leads over a seam, into the triangle beyond.
  bool crossed_by(const Vec3d& n) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (leads_over(seams_[i], n)) return true;
    return false;
  }
  /// Whether it leads over the seam on which a point of the triangle lies, so that what is beyond is cut there. On a
  /// rim it leads into the air, whatever lies beyond other sides: at a corner beyond the side that ends there too.
  bool crossed_by(const Vec3d& n, const Vec3d& point) const {
    std::array<double, 3> aside;
    for (std::size_t i = 0; i < 3; ++i) aside[i] = std::abs(dot(point - sides_[i].begin, sides_[i].outward));
    // A corner lies on two sides, but for rounding.
    const double nearest = least(least(aside[0], aside[1]), aside[2]) + over_edge * (aside[0] + aside[1] + aside[2]);
    for (std::size_t i = 0; i < 3; ++i)
      if (is_rim_[i] && aside[i] <= nearest && dot(n, sides_[i].outward) > over_edge) return false;
    for (std::size_t i = 0; i < count_; ++i)
      if (leads_over(seams_[i], n) && aside[seams_[i].side] <= nearest && dot(n, seams_[i].far - point) > 0)
        return true;
    return false;
  }

 private:
  struct Side {
    Vec3d begin;    ///< a corner on it
    Vec3d outward;  ///< in the triangle's plane, away from it
  };
  struct Seam {
    std::size_t side;
    Vec3d beyond;  ///< in the plane of the triangle beyond, into it
    Vec3d far;     ///< the corner of that triangle which is not on the seam
  };
  template <class Data>
  static std::array<Vec3d, 3> corners(const Data& data, std::uint32_t number) {
    const auto c = data.triangle(number);
    return {converted<double>(c[0]), converted<double>(c[1]), converted<double>(c[2])};
  }

  bool leads_over(const Seam& seam, const Vec3d& n) const {
    return dot(n, sides_[seam.side].outward) > over_edge && dot(n, seam.beyond) > over_edge;
  }

  std::array<Side, 3> sides_{};
  std::array<bool, 3> is_rim_{};  ///< sides beyond which there is nothing
  std::array<Seam, 3> seams_{};
  std::size_t count_ = 0;
  Vec3d normal_{};
};

}  // namespace graze
