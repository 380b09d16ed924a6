// The drawing in SVG that all pictures share: a view of the world, and on it shaded shapes, arrows, dots and lines.
//
// Guarantee: any scene gives a picture, however small or far away.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/detail/validate.hpp"
#include "graze/draw.hpp"
#include "graze/error.hpp"

namespace graze::io {

using Color = std::array<double, 3>;

constexpr Color mixed(const Color& a, const Color& b, double part) {
  Color c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = a[i] + (b[i] - a[i]) * part;
  return c;
}
std::string hex(const Color& color, double light = 1);
/// The colour of a shape by its meaning in the picture.
Color color_of(DrawMeaning meaning);
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

/// An arrow of fixed length on the picture, along a unit vector.
std::string arrow(const View& view, const Vec3d& from, const Vec3d& along);
/// A straight line between two places of the world; `look` is a class or a colour, `more` further attributes.
std::string line(const View& view, const Vec3d& p, const Vec3d& q, const std::string& look, double thickness,
                 const char* more = "");
/// A dot upon everything.
std::string dot_at(const View& view, const Vec3d& p, const std::string& look);

/// Debug draw on a view: faces in the order in which they hide each other, and over all of them arrows, lines and dots,
/// so that none is hidden. Shapes that touch nothing (triggers, the two of an explanation) are translucent, and places
/// along a way are pale.
class SvgDraw final : public DebugDraw {
 public:
  /// Faces of at least `background` lie behind all others: the middle of so large a face does not tell if it is hidden.
  SvgDraw(const View& view, const DrawArea& area, double background)
      : DebugDraw(area), view_(view), background_(background) {}

  bool wants(DrawLayer) const override { return true; }
  void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) override;
  void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) override;
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) override;
  void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) override;
  void polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) override;
  void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) override;

  /// A colour for faces instead of that of their meaning.
  void set_tint(const Color& color) { tint_ = color; }

  /// The picture's parts: faces, which hide each other, and the things that lie over them.
  std::string faces() const;
  std::string over() const;

  struct Face {
    double depth;
    bool background;
    std::string text;
  };
  /// The faces in the order in which they came, for a picture that is put together elsewhere.
  std::vector<Face> take_faces() { return std::move(faces_); }

 private:
  /// A shape without thickness: a segment, or a point.
  std::string thin(const Vec3d& from, const Vec3d& to, const std::string& color) const;

  const View& view_;
  double background_;
  std::optional<Color> tint_;
  std::vector<Face> faces_;
  std::string arrows_, lines_, dots_, words_;
};

/// Words in a look: a class of the picture's style ("ink", "soft", "red"), or a colour ("#1f6feb").
std::string text(double x, double y, double size, const std::string& words, const std::string& look = "ink",
                 const char* anchor = "start");

/// All pictures have one size, in pixels.
inline constexpr double picture_width = 960, picture_height = 600;
/// The least size with which a scene is drawn, which may be one point: the smallest that keeps the places of a picture
/// finite, which are a few coordinates times the picture's width, divided by the size.
inline constexpr double least_size =
    16 * picture_width * largest_magnitude<double> / std::numeric_limits<double>::max();
/// The beginning of a picture with its style, for light paper and for dark, and its background; `</svg>` ends it.
std::string svg_head(double height = picture_height);

}  // namespace graze::io
