// A convex shape as its queries see it: a core, and the radius of the disc that rounds it.
//
// Guarantee: one type for every convex shape, made by the overloads of `core_of`; a shape in `ShapeList` without one
// does not compile. Vertices stay in `T` and are read as doubles, in which all kernels work: the products of two floats
// are exact there.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "graze/plane/shape.hpp"
#include "narrow/manifold/features.hpp"

namespace graze::plane {

enum class CoreKind : std::uint8_t {
  polygon,     ///< one vertex (circle), two (capsule, segment) or more
  tapered,     ///< the hull of a disc and a point on the Y axis
  ellipse,     ///< by its radii
  user,        ///< by its support function
  half_plane,  ///< y <= 0
};

template <class T>
struct Core {
  Core() {}  // NOLINT(modernize-use-equals-default): of a union it would be deleted

  CoreKind kind = CoreKind::polygon;
  double radius = 0;        ///< of the rounding disc
  std::uint32_t count = 0;  ///< of vertices
  union {
    std::array<Vec2<T>, 8> inside;  ///< vertices, counter-clockwise, of a shape that holds none; the rest is untouched
  };
  const Vec2<T>* outside = nullptr;  ///< vertices of a polygon, which stand in the shape, with room for eight at least
  Vec2d radii{};                     ///< of an ellipse; of a tapered core those of the lower and the upper disc
  double half_height = 0;            ///< of a tapered core
  const SupportFunction<T>* user = nullptr;
  /// The outline about each vertex of a piece of a polygon or a chain, else null.
  const OutlineVertex* outline = nullptr;
  const Pieces<T>* pieces = nullptr;  ///< all pieces of that polygon or chain
  const Chain<T>* chain = nullptr;    ///< the chain that a segment belongs to
  std::uint32_t leaf = 0;             ///< number of the shape in its body, of those that are no compounds

  Vec2d vertex(std::uint32_t i) const { return plane::converted<double>(outside ? outside[i] : inside[i]); }
  std::uint32_t next(std::uint32_t i) const { return i + 1 == count ? 0 : i + 1; }
  std::uint32_t previous(std::uint32_t i) const { return i == 0 ? count - 1 : i - 1; }
  /// Edge i leads from vertex i to the next.
  Vec2d edge(std::uint32_t i) const { return vertex(next(i)) - vertex(i); }
};

/// A core of the given vertices, stored one by one: a list of them is written in pieces of one size and read back in
/// pieces of another, and such a read waits for the memory.
template <class T, class... Vertices>
Core<T> polygon_core(double radius, const Vertices&... vertices) {
  Core<T> core;
  core.radius = radius;
  ((core.inside[core.count++] = vertices), ...);
  return core;
}

template <class T>
Core<T> core_of(const Circle<T>& c) {
  return polygon_core<T>(double(c.radius()), Vec2<T>{});
}
template <class T>
Core<T> core_of(const Capsule<T>& c) {
  const T h = c.half_height();
  const auto bottom = double(c.radius_bottom()), top = double(c.radius_top());
  if (!c.tapered()) return polygon_core<T>(top, Vec2<T>{T(0), -h}, Vec2<T>{T(0), h});
  // One disc in the other: the capsule is that disc.
  if (2 * double(h) <= std::abs(bottom - top))
    return polygon_core<T>(greatest(bottom, top), Vec2<T>{T(0), bottom > top ? -h : h});
  Core<T> core;
  core.kind = CoreKind::tapered;
  core.radius = least(bottom, top);
  core.radii = {bottom - core.radius, top - core.radius};
  core.half_height = double(h);
  return core;
}
template <class T>
Core<T> core_of(const Box<T>& box) {
  const Vec2<T> h = box.half_extents();
  return polygon_core<T>(0, -h, Vec2<T>{h.x, -h.y}, h, Vec2<T>{-h.x, h.y});
}
template <class T>
Core<T> core_of(const Segment<T>& s) {
  return polygon_core<T>(0, s.a(), s.b());
}
template <class T>
Core<T> core_of(const ConvexPolygon<T>& p) {
  Core<T> core;
  core.count = static_cast<std::uint32_t>(p.vertices().size());
  core.outside = p.vertices().data();
  return core;
}
template <class T>
Core<T> core_of(const Ellipse<T>& e) {
  if (e.radii().x == e.radii().y) return polygon_core<T>(double(e.radii().x), Vec2<T>{});
  if (e.radii().x == T(0)) return polygon_core<T>(0, Vec2<T>{T(0), -e.radii().y}, Vec2<T>{T(0), e.radii().y});
  if (e.radii().y == T(0)) return polygon_core<T>(0, Vec2<T>{-e.radii().x, T(0)}, Vec2<T>{e.radii().x, T(0)});
  Core<T> core;
  core.kind = CoreKind::ellipse;
  core.radii = plane::converted<double>(e.radii());
  return core;
}
template <class T>
Core<T> core_of(const UserConvex<T>& u) {
  Core<T> core;
  core.kind = CoreKind::user;
  core.user = &u.function();
  return core;
}
template <class T>
Core<T> core_of(const HalfPlane<T>&) {
  Core<T> core;
  core.kind = CoreKind::half_plane;
  return core;
}

/// The core of one piece of a polygon or a chain.
template <class T>
Core<T> piece_core(const Pieces<T>& pieces, std::uint32_t piece) {
  Core<T> core;
  const std::span<const Vec2<T>> vertices = pieces.vertices(piece);
  core.count = static_cast<std::uint32_t>(vertices.size());
  if (core.count > core.inside.size())
    core.outside = vertices.data();
  else
    for (std::uint32_t i = 0; i < core.count; ++i) core.inside[i] = vertices[i];
  core.outline = pieces.outline(piece);
  core.pieces = &pieces;
  return core;
}

/// Whether shapes of the kind C are made of pieces.
template <class C>
inline constexpr bool has_pieces = false;
template <class T>
inline constexpr bool has_pieces<Compound<T>> = true;
template <class T>
inline constexpr bool has_pieces<Polygon<T>> = true;
template <class T>
inline constexpr bool has_pieces<Chain<T>> = true;

/// The core of a shape that is not made of pieces. Built in the place of the result: a copy of a core that was just
/// written waits for the memory.
template <class T>
Core<T> convex_core(const Shape<T>& shape) {
  Core<T> core = shape.visit([](const auto& c) -> Core<T> {
    if constexpr (has_pieces<std::decay_t<decltype(c)>>)
      return Core<T>();
    else
      return core_of(c);
  });
  core.radius += double(shape.rounding());
  return core;
}

/// The feature of edge i.
constexpr std::uint32_t side_feature(std::uint32_t i) { return graze::detail::feature_of_kind(2, i); }

/// The vertex of a polygon that a feature is, or at which it begins.
template <class T>
std::uint32_t vertex_of(const Core<T>& core, std::uint32_t feature) {
  const std::uint32_t number = feature & ((std::uint32_t{1} << graze::detail::feature_number_bits) - 1);
  return number < core.count ? number : 0;
}

/// A point of a core and the feature of the shape on which it lies.
struct CorePoint {
  Vec2d point;
  std::uint32_t feature = 0;
};

/// The vertex that lies furthest along `direction`; of equals the first.
template <class T>
std::uint32_t furthest_vertex(const Core<T>& core, const Vec2d& direction) {
  std::uint32_t best = 0;
  double most = dot(core.vertex(0), direction);
  for (std::uint32_t i = 1; i < core.count; ++i)
    if (const double d = dot(core.vertex(i), direction); d > most) most = d, best = i;
  return best;
}

/// The point of a bounded core that lies furthest along `direction`, in its own frame.
template <class T>
CorePoint support(const Core<T>& core, const Vec2d& direction) {
  switch (core.kind) {
  case CoreKind::polygon: {
    const std::uint32_t i = furthest_vertex(core, direction);
    return {core.vertex(i), vertex_feature(i)};
  }
  case CoreKind::tapered: {
    const Vec2d n = normalized(direction);
    const double h = core.half_height;
    const bool up = h * n.y + core.radii.y >= core.radii.x - h * n.y;
    return {Vec2d{0, up ? h : -h} + n * (up ? core.radii.y : core.radii.x), vertex_feature(up ? 1 : 0)};
  }
  case CoreKind::ellipse: {
    const Vec2d scaled = normalized(Vec2d{core.radii.x * direction.x, core.radii.y * direction.y}, Vec2d{});
    return {{core.radii.x * scaled.x, core.radii.y * scaled.y}, vertex_feature(0)};
  }
  case CoreKind::user:
    return {plane::converted<double>(core.user->support(plane::converted<T>(normalized(direction)))),
            vertex_feature(0)};
  case CoreKind::half_plane: break;
  }
  return {};
}

}  // namespace graze::plane
