// The edges at which a triangle of a mesh or height field goes on in others.
//
// Guarantee: a plane across a normal that leads over such an edge cuts the triangle beyond it, and so separates nothing
// from the surface, whatever it does to the one triangle. A body that is thin along such a normal would else slide into
// the seam between two triangles, each of which it leaves to one side.
#pragma once

#include <array>
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
      if (across[i] == no_triangle) continue;
      const Vec3d& begin = own[i];
      const Vec3d along = normalized(own[(i + 1) % 3] - begin, Vec3d{});
      // The corner beyond the edge is the one that lies furthest from its line.
      Vec3d beyond{};
      for (const Vec3d& corner : corners(data, across[i])) {
        const Vec3d aside = corner - begin - along * dot(corner - begin, along);
        if (length_squared(aside) > length_squared(beyond)) beyond = aside;
      }
      beyond = normalized(beyond, Vec3d{});
      if (beyond != Vec3d{}) seams_[count_++] = {cross(along, normal_), beyond};
    }
  }

  /// The triangle's unit normal; zero where it has no seams.
  const Vec3d& normal() const { return normal_; }
  /// Whether a unit vector leads over a seam, into the triangle beyond.
  bool crossed_by(const Vec3d& n) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (dot(n, seams_[i].outward) > over_edge && dot(n, seams_[i].beyond) > over_edge) return true;
    return false;
  }

 private:
  struct Seam {
    Vec3d outward;  ///< in the triangle's plane, away from it
    Vec3d beyond;   ///< in the plane of the triangle beyond, into it
  };
  template <class Data>
  static std::array<Vec3d, 3> corners(const Data& data, std::uint32_t number) {
    const auto c = data.triangle(number);
    return {converted<double>(c[0]), converted<double>(c[1]), converted<double>(c[2])};
  }

  std::array<Seam, 3> seams_{};
  std::size_t count_ = 0;
  Vec3d normal_{};
};

}  // namespace graze
