// The little languages in SVG's attributes: numbers, transforms and path data.
//
// Guarantee: any text gives its values or `InvalidValue`; curves become straight pieces that are nowhere further from
// them than the tolerance. The number of points is bounded.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "graze/plane/vec2.hpp"

namespace graze::io {

/// An affine map of the plane: p -> x p.x + y p.y + origin.
struct Affine2 {
  plane::Vec2d x{1, 0}, y{0, 1}, origin{};

  plane::Vec2d direction(const plane::Vec2d& v) const { return x * v.x + y * v.y; }
  plane::Vec2d operator()(const plane::Vec2d& p) const { return direction(p) + origin; }
  friend Affine2 operator*(const Affine2& a, const Affine2& b) {
    return {a.direction(b.x), a.direction(b.y), a(b.origin)};
  }
};

/// A linear map as rotations before and after stretches along the axes: `turn` takes the X axis to the direction of the
/// longer stretch.
struct Stretches {
  double longer, shorter;
  plane::Vec2d turn;  ///< unit
  bool similar;       ///< the same stretch in all directions, within some roundings
};
Stretches stretches_of(const Affine2& map);

/// The numbers of a list with commas or spaces between them. Throws for anything else.
std::vector<double> number_list(std::string_view text);

/// SVG's `transform`: matrix, translate, scale, rotate, skewX and skewY, one behind the other.
Affine2 read_transform(std::string_view text);

/// The map from the `viewBox` of a viewport to its area, from the origin to `size`: as `preserveAspectRatio` says,
/// which is xMidYMid meet where it is empty.
Affine2 read_view_box(std::string_view view_box, const plane::Vec2d& size, std::string_view preserve_aspect_ratio);

/// One outline of a path.
struct Subpath {
  std::vector<plane::Vec2d> points;
  bool closed = false;
};

/// SVG's path data in the frame that `map` leads to. Curves are flattened to `tolerance` there, or without one to a
/// thousandth of the larger side of all points and control points.
std::vector<Subpath> read_path(std::string_view text, const Affine2& map, std::optional<double> tolerance);

/// The most points that one path or list may have.
inline constexpr std::size_t most_path_points = 100000;

}  // namespace graze::io
