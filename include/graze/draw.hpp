// Debug draw: what the library knows, drawn by a renderer of your own.
//
// A renderer says how a point, a line, a triangle and a text come onto its screen; the functions below say what there
// is to draw: shapes, bounds, contacts, distances, rays, casts, traces, trees, joints, worlds and simulations, in space
// and in the plane (there at z = 0). Colours are named by what they mean, and everything stands in a layer, so that a
// reader can switch off what hides the rest.
//
// Guarantee: nothing that is drawn changes by it; the same state draws the same calls in the same order. Places are in
// world space, in double, and finite where the scene is; a box that is nowhere bounded is left out. Everything is drawn
// as it was found: contacts of a world where its last update found them, those of a simulation where its last step
// began, while bodies are drawn where they are now. Costs memory and time for each line: for the eye, not for each
// pair of a hot loop.
#pragma once

#include <span>
#include <string_view>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"
#include "graze/tessellate.hpp"

namespace graze {

/// What a reader switches on and off together.
enum class DrawLayer : std::uint8_t { shapes, bounds, tree, contacts, distances, rays, casts, trace, joints };

/// What a colour says.
enum class DrawMeaning : std::uint8_t {
  a,          ///< the first of two, and what is its own: its interval on an axis, its support point
  b,          ///< the second
  fixed,      ///< a body that never moves
  touched,    ///< a fixed body that something touches
  moving,     ///< a body that moves, and touches nothing
  touching,   ///< a body that moves, and touches something
  asleep,     ///< a body of a simulation at rest
  trigger,    ///< a body that only tells what is inside it
  contact,    ///< a point of contact, or the overlap of two intervals
  normal,     ///< a normal or another direction
  gap,        ///< the shortest way between two things
  ruled_out,  ///< what was tried and decided nothing
  bounds,     ///< a box around something
  path,       ///< a way of something that moves, or of a ray
  ghost,      ///< a place along a way
  joint       ///< what holds two bodies together
};

/// A colour in sRGB, 0 to 255.
struct DrawColor {
  std::uint8_t red, green, blue;  ///< 0 to 255 each.
};
/// The colour that the project's own pictures give a meaning, to be told apart on light paper and on dark.
GRAZE_API DrawColor suggested_color(DrawMeaning meaning);

/// The part of the world that is looked at. What has no end is drawn about its centre as far as its size, and arrows
/// are a twelfth of it.
struct DrawArea {
  Vec3d center{};   ///< the middle of what is looked at
  double size = 1;  ///< > 0
};
/// Bounds of all bodies that have any, without an end to their size; the default of `DrawArea` when none has.
template <class T, class Space>
GRAZE_API DrawArea draw_area(const World<T, Space>& world);

/// A renderer. The first five are what it must do, and the rest what it may do better than with these.
class GRAZE_API DebugDraw {
 public:
  /// Draws within `area`.
  explicit DebugDraw(const DrawArea& area = {}) : area_(area) {}
  virtual ~DebugDraw();

  /// Whether the layer is seen; what is in one that is not is not even computed.
  virtual bool wants(DrawLayer layer) const = 0;
  virtual void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) = 0;  ///< A point of the world.
  /// A line between two points of the world.
  virtual void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) = 0;
  /// Counter-clockwise seen from outside.
  virtual void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) = 0;
  /// `words` at a point; they live until the function returns.
  virtual void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) = 0;

  /// All faces of a shape: by itself triangles, and lines along the edges that are the shape's own.
  virtual void polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning);
  /// A direction, a unit vector, at a place: by itself a line of a length for the area, with two for its head.
  virtual void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning);

  /// What is looked at.
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
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose,
                    DrawMeaning meaning = DrawMeaning::moving);

/// A box by its twelve edges, those that fall together once; nothing for one that is empty or has no end.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Aabb<T>& box, DrawLayer layer = DrawLayer::bounds,
                    DrawMeaning meaning = DrawMeaning::bounds);

/// A contact manifold: its points, and its normal as an arrow from their middle.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Manifold<T>& manifold);
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Manifold<T>& manifold);

/// The shortest way between two shapes, or out of each other, with its point on either.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Distance<T>& distance);
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Distance<T>& distance);

/// A ray up to its hit, with the normal there; one that hits nothing as an arrow of its length, or to the end of the
/// area.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Ray<T>& ray, T length, const std::optional<RayHit<T>>& hit);
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Ray<T>& ray, T length, const std::optional<plane::RayHit<T>>& hit);

/// A shape on its way, up to its hit or for the whole duration: the path of its origin, places along it, more where it
/// turns, the place where it comes to, and there the point and the normal of the hit.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Shape<T>& shape, const Pose<T>& pose, const Velocity<T>& velocity, T duration,
                    const std::optional<CastHit<T>>& hit);
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const plane::Shape<T>& shape, const plane::Pose2<T>& pose,
                    const plane::Velocity<T>& velocity, T duration, const std::optional<plane::CastHit<T>>& hit);

/// What a query did. Separating axes are drawn through the area's centre, on each the interval of either shape side by
/// side, the axis that decided by its name; the Minkowski difference B - A is drawn about the origin, where it lies:
/// the polygon of the plane, the last simplex of GJK with its search direction, and the polytope of EPA.
GRAZE_API void draw(DebugDraw& on, const Trace& trace);
/// One iteration of GJK, or one expansion of EPA: the simplex or polygon, the direction, and the point that was found.
GRAZE_API void draw(DebugDraw& on, const TraceGjk& iteration);
/// One expansion of EPA: the polygon, and the point that was found.
GRAZE_API void draw(DebugDraw& on, const TraceEpa& expansion);

/// The boxes of a tree, those of its nodes and those in it.
template <class T>
GRAZE_API void draw(DebugDraw& on, const DynamicTree<T>& tree);

/// A joint of bodies that stand at these poses: from either origin to its anchor, and how far the anchors are apart.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Joint<T>& joint, const Pose<T>& pose_a, const Pose<T>& pose_b);
/// The same in the plane.
template <class T>
GRAZE_API void draw(DebugDraw& on, const Joint<T, plane::Space<T>>& joint, const plane::Pose2<T>& pose_a,
                    const plane::Pose2<T>& pose_b);

/// All bodies of a world, their bounds, its tree, and the contacts of its last update.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const World<T, Space>& world);

/// As a world, with what sleeps told apart, and joints. Bodies stand where the last step left them, contacts where it
/// began.
template <class T, class Space>
GRAZE_API void draw(DebugDraw& on, const Simulation<T, Space>& simulation);

}  // namespace graze
