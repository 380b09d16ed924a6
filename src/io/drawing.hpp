// Drawing in SVG what all pictures share: a view of the world, shaded shapes, arrows.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "graze/error.hpp"
#include "graze/tessellate.hpp"
#include "graze/validate.hpp"

namespace graze::io {

using Color = std::array<double, 3>;

constexpr Color mixed(const Color& a, const Color& b, double part) {
  Color c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = a[i] + (b[i] - a[i]) * part;
  return c;
}
std::string hex(const Color& color, double light = 1);
/// Text between tags.
std::string escaped(const std::string& text);

/// The part of a picture that a view fills.
struct Panel {
  double x, y, width, height;
};

/// The world as seen from a direction, orthographic, Y up, fitted around some points.
class View {
 public:
  View(const Vec3d& toward_viewer, const std::vector<Vec3d>& points, const Panel& panel);

  double x(const Vec3d& p) const { return x_ + scale_ * dot(p, right_); }
  double y(const Vec3d& p) const { return y_ - scale_ * dot(p, up_); }
  double depth(const Vec3d& p) const { return dot(p, toward_); }
  double scale() const { return scale_; }
  const Vec3d& toward() const { return toward_; }
  /// Lights from above, a little to the left of the viewer.
  double light(const Vec3d& normal) const;

 private:
  Vec3d toward_, right_, up_;
  double scale_ = 1, x_ = 0, y_ = 0;
};

struct DrawnFace {
  double depth;
  bool background;  ///< so large that the middle says nothing about what it hides
  std::string text;
};

/// Appends the faces that are seen; `glass` lets shine through what lies behind.
void draw_shape(const View& view, const Polygons& shape, const Color& color, bool glass, double scene_size,
                std::vector<DrawnFace>& faces);
/// The faces in the order in which they hide each other.
std::string painted(std::vector<DrawnFace> faces);

/// An arrow of fixed length on the picture, along a unit vector.
std::string arrow(const View& view, const Vec3d& from, const Vec3d& along);

/// Words in a look: a class of the picture's style ("ink", "soft", "red"), or a colour ("#5482b0").
std::string text(double x, double y, double size, const std::string& words, const std::string& look = "ink",
                 const char* anchor = "start");

/// All pictures have one size, in pixels.
inline constexpr double picture_width = 960, picture_height = 600;
/// A scene may be one point. It is then drawn as if it had this size: the smallest that keeps the places of a picture
/// finite, which are a few coordinates times the picture's width, divided by the size.
inline constexpr double least_size =
    16 * picture_width * largest_magnitude<double> / std::numeric_limits<double>::max();
/// The beginning of a picture with its style, for light paper and for dark, and its background; `</svg>` ends it.
std::string svg_head(double height = picture_height);

}  // namespace graze::io
