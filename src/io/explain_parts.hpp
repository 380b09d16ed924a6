// The parts of an explanation's picture: the shapes, and beside them the list of axes, spans or steps.
#pragma once

#include "graze/io/explain.hpp"
#include "io/drawing.hpp"

namespace graze::io {

inline constexpr double page_margin = 28, head_height = 64;
/// The place of the shapes, with room above and below for their letters.
inline constexpr Panel shapes_panel{page_margin, head_height + 16, 520,
                                    picture_height - head_height - page_margin - 36};
/// The place of the list: names, bars and numbers.
inline constexpr double list_x = 590, name_width = 138, bars_x = list_x + name_width, bars_width = 138, number_x = 936;
inline constexpr std::size_t most_rows = 20;

inline const Color color_a = color_of(DrawMeaning::a), color_b = color_of(DrawMeaning::b);

/// The item of that name in a list, or null.
template <class Item>
const Item* named(const std::vector<Item>& items, const std::string& name) {
  for (const Item& item : items)
    if (item.name == name) return &item;
  return nullptr;
}

/// The winning axis beside the shapes: the interval of each, what they share, and lines down from the shapes.
class AxisDrawing {
 public:
  AxisDrawing(const TraceAxis& axis, const Vec3d& toward, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b);

  /// The points for which the picture must have room.
  std::vector<Vec3d> corners() const { return {at(low_, bar_b_), at(high_, bar_b_)}; }
  std::string draw(const View& view) const;
  /// "B0: overlap 0.6".
  std::string caption() const;

 private:
  Vec3d at(double along, double aside) const { return axis_.direction * along + beside_ * aside; }
  std::string shadow(const View& view, const std::vector<Vec3d>& points, double lower, double upper, double bar,
                     const Color& color) const;

  const TraceAxis& axis_;
  Vec3d beside_;  ///< unit, across the axis in the plane of the picture
  const std::vector<Vec3d>&of_a_, &of_b_;
  double low_, high_, bar_a_, bar_b_;  ///< of the shapes along the axis; where along `beside_` the bars are
};

/// The two lines at the top: the outcome and the method.
std::string headline(const Explanation& e);

/// The letters of both shapes, each just outside of its shape, where that is furthest away from the other. A shape
/// without points has none.
std::string draw_letters(const View& view, const Polygons& a, const Polygons& b);

/// A bar of a list.
std::string bar(double x0, double x1, double y, const Color& color);
/// The background of the row of a list that won.
std::string chosen_row(double y, double height);

/// Whether the overlap or the gap along an axis is too small to see.
bool needs_inset(const View& view, const TraceAxis& axis);
/// The height that the shapes leave free for an inset, from the top of their panel.
inline constexpr double inset_height = 132;
/// The intervals of both shapes along the axis, enlarged, above the shapes, with a line to `place`, where they are.
std::string draw_inset(const View& view, const TraceAxis& axis, const Vec3d& place);

/// All axes as rows: the intervals of both shapes, to one scale; down to `bottom`.
std::string draw_axes(const Explanation& e, double bottom);
/// All four axes of two boxes in the plane as projections, each in a panel of its own; nothing of other pairs.
std::string draw_projections(const Explanation& e, const Polygons& a, const Polygons& b, double bottom);
/// The Minkowski difference of two shapes in the plane and in it the steps of GJK and EPA, from `top` down; nothing
/// where the trace has none.
std::string draw_difference(const Explanation& e, double top);
/// The height of that drawing.
double difference_height(const Trace& trace);

/// The spans of a ray as rows, to one scale, and where it hits.
std::string draw_spans(const Explanation& e);
/// The steps of conservative advancement as rows, the distance as a bar on a logarithmic scale; down to `bottom`.
std::string draw_steps(const Explanation& e, double bottom);

/// A blow: the bodies with their velocities before and after it, the impulse, and beside them the quantities and
/// Coulomb's cone.
std::string draw_response(const Explanation& e, const Vec3d& toward_viewer);

}  // namespace graze::io
