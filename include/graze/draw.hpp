// Debug draw: shapes, contacts, traces and worlds on a renderer of the user's own.
//
// A renderer implements how points, lines, triangles and texts come onto its screen; the functions below decompose
// shapes, bounds, contacts, distances, rays, casts, traces, trees, joints, worlds and simulations into these, in space
// and in the plane (there at z = 0). Colours are named by their meaning, and everything belongs to a layer, so that a
// reader can switch off what hides the rest.
//
// Guarantee: drawing changes no state; equal states draw equal calls in equal order. Positions are in world space, in
// double, and finite where the scene is; a box without any finite bound is left out. Contacts are drawn where they were
// found: those of a world at its last update, those of a simulation at the beginning of its last step, while bodies are
// drawn at their present poses. Costs memory and time for each line, and is meant for the eye, not for every pair of a
// hot loop.
#pragma once

#include <span>
#include <string_view>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"
#include "graze/tessellate.hpp"

namespace graze {

/// Layers that a reader switches on and off.
enum class DrawLayer : std::uint8_t { shapes, bounds, tree, contacts, distances, rays, casts, trace, joints };

/// Meanings of colours.
enum class DrawMeaning : std::uint8_t {
  a,          ///< the first of two shapes, and what belongs to it: its interval on an axis, its support point
  b,          ///< the second of two shapes, and what belongs to it
  fixed,      ///< a body that never moves
  touched,    ///< a fixed body that is touched
  moving,     ///< a moving body without contacts
  touching,   ///< a moving body with contacts
  asleep,     ///< a body of a simulation at rest
  trigger,    ///< a body that only reports what is inside it
  contact,    ///< a point of contact, or the overlap of two intervals
  normal,     ///< a normal or another direction
  gap,        ///< the shortest connection of two shapes
  ruled_out,  ///< a trial that decided nothing: an axis, a candidate
  bounds,     ///< a box around something
  path,       ///< the path of a body or of a ray
  ghost,      ///< a position along a path
  joint       ///< a joint of two bodies
};

/// A colour in sRGB, 0 to 255.
struct DrawColor {
  std::uint8_t red, green, blue;  ///< 0 to 255 each.
};
/// The colour of a meaning in the project's own pictures, distinct on light paper and on dark.
GRAZE_API DrawColor suggested_color(DrawMeaning meaning);

/// The region of interest of a drawing. Unbounded things are drawn about its centre as far as its size, and arrows are
/// a twelfth of it.
struct DrawArea {
  Vec3d center{};   ///< centre of the region
  double size = 1;  ///< > 0
};
/// The bounds of all bodies that have finite ones; the default `DrawArea` when none has.
template <class T, class Space>
GRAZE_API DrawArea draw_area(const World<T, Space>& world);

/// A renderer. The first five functions are required; the others have implementations in terms of them, to be improved
/// on.
class GRAZE_API DebugDraw {
 public:
  /// Draws within `area`.
  explicit DebugDraw(const DrawArea& area = {}) : area_(area) {}
  virtual ~DebugDraw();

  /// Whether the layer is visible; the contents of hidden layers are not even computed.
  virtual bool wants(DrawLayer layer) const = 0;
  virtual void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) = 0;  ///< A point of the world.
  /// A line between two points of the world.
  virtual void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) = 0;
  /// A triangle, counter-clockwise seen from outside.
  virtual void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) = 0;
  /// `words` at a point; the text is valid until the function returns.
  virtual void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) = 0;

  /// All faces of a shape; by default as triangles, with lines along the edges that are the shape's own, coinciding
  /// ones once. Loops of two points are lines, of one point points.
  virtual void polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning);
  /// A direction, a unit vector, at a place; by default as a line of a length that suits the area, with two for its
  /// head.
  virtual void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning);

  /// The region of interest.
  const DrawArea& area() const { return area_; }

 protected:
  DebugDraw(const DebugDraw&) = default;             ///< A copy draws within the same area.
  DebugDraw& operator=(const DebugDraw&) = default;  ///< A copy draws within the same area.

 private:
  DrawArea area_;
};

/// A shape in place.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Shape<T>& shape, const Pose<T>& pose,
                    DrawMeaning meaning = DrawMeaning::moving);
/// A shape of the plane in place.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose,
                    DrawMeaning meaning = DrawMeaning::moving);

/// A box by its twelve edges, coinciding ones once; nothing for a box that is empty or unbounded.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Aabb<T>& box, DrawLayer layer = DrawLayer::bounds,
                    DrawMeaning meaning = DrawMeaning::bounds);

/// A contact manifold: its points, and its normal as an arrow from their middle.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Manifold<T>& manifold);
/// A contact manifold of the plane: its points, and its normal as an arrow from their middle.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Manifold<T>& manifold);

/// The shortest segment between two shapes, or the least translation out of each other, with its point on either.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Distance<T>& distance);
/// The shortest segment between two shapes of the plane, or the least translation out of each other.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Distance<T>& distance);

/// A ray up to its hit, with the normal there; a ray that misses as an arrow of its length, or to the end of the area.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Ray<T>& ray, T length, const std::optional<RayHit<T>>& hit);
/// A ray of the plane up to its hit, with the normal there, or its whole length.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Ray<T>& ray, T length, const std::optional<plane::RayHit<T>>& hit);

/// A moving shape, up to its hit or for the whole duration: the path of its origin, shapes along it, more of them where
/// it turns, the shape at the end, and there the point and the normal of the hit.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Shape<T>& shape, const Pose<T>& pose, const Velocity<T>& velocity, T duration,
                    const std::optional<CastHit<T>>& hit);
/// A moving shape of the plane, up to its hit or for the whole duration.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose,
                    const plane::Velocity<T>& velocity, T duration, const std::optional<plane::CastHit<T>>& hit);

/// The steps of a query. Separating axes are drawn through the area's centre, on each the intervals of the two shapes
/// side by side, the axis that decided by its name; the Minkowski difference B - A is drawn about the origin, where it
/// lies: the polygon of the plane, the last simplex of GJK with its search direction, and the polytope of EPA.
GRAZE_API void draw(DebugDraw& on, const Trace& trace);
/// One iteration of GJK: the simplex, the search direction, and the support point that was found.
GRAZE_API void draw(DebugDraw& on, const TraceGjk& iteration);
/// One expansion of EPA: the polytope's polygon, and the support point that was found.
GRAZE_API void draw(DebugDraw& on, const TraceEpa& expansion);
/// One separating axis as above: with its name and what the intervals share or leave free where it decides.
GRAZE_API void draw(DebugDraw& on, const TraceAxis& axis, bool decides = true);
/// One span of a ray within a convex shape: the stretch of the ray inside of that condition, as far as the area where
/// it has no end; where it decides, with its name, and the normal where the ray enters. Nothing where it is never met.
GRAZE_API void draw(DebugDraw& on, const TraceSpan& span, const Ray<double>& ray, bool decides = true);
/// One cut of a face: the side of the other face that cuts, and what is left, with its corners.
GRAZE_API void draw(DebugDraw& on, const TraceCut& cut);

/// The boxes of a tree: the bounds of its nodes, and the boxes in it.
template <class T>
GRAZE_API void draw(DebugDraw& on, const DynamicTree<T>& tree);

/// A joint of bodies at these poses: from either origin to its anchor, and the gap between the anchors.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Joint<T>& joint, const Pose<T>& pose_a, const Pose<T>& pose_b);
/// A joint of bodies of the plane at these poses.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Joint<T, plane::Space<T>>& joint, const plane::Pose2<T>& pose_a,
                    const plane::Pose2<T>& pose_b);

/// All bodies of a world, their bounds, its tree, and the contacts of its last update.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const World<T, Space>& world);

/// One body of a world as the drawing of the whole world shows it: by what it does, with its bounds. Throws
/// `InvalidValue` for a body that is not in the world. Time grows with the pairs of the last update.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const World<T, Space>& world, BodyId body);
/// One body of a simulation as the drawing of the whole simulation shows it. Throws `InvalidValue` for a body that is
/// not in it.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const Simulation<T, Space>& simulation, BodyId body);

/// A simulation: its world, with sleeping bodies marked, and its joints. Bodies are drawn where the last step left
/// them, contacts where they were at its beginning.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const Simulation<T, Space>& simulation);

}  // namespace graze
