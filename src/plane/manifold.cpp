#include "plane/manifold.hpp"

#include <limits>

#include "plane/shared_stretch.hpp"

namespace graze::plane {

namespace {

/// The least cosine between the normal of an edge and that of the contact for the edge to be clipped by the other's: 60
/// degrees.
constexpr double least_facing = 0.5;

/// The error of the normal of tapered cores: the search finds it within the root of its goal only.
double searched_normal() { return 4 * std::sqrt(goal); }

/// The straight side of a shape that faces a normal, seen along that normal: its ends by their place across it and
/// their height along it, each rounded by a radius of its own.
struct Side {
  struct End {
    double across = 0, height = 0, radius = 0;
    std::uint32_t vertex = 0;
  };
  bool straight = false;
  Vec2d own{};           ///< its own normal, in the frame of its core
  End low{}, high{};     ///< in order across
  double slope = 0;      ///< of the side's surface: height gained per length across
  double facing = 1;     ///< cosine between its own normal and the given one
  double leaning = 0;    ///< sine of that angle: how far its own normal leans across
  double reach = 0;      ///< the coordinates of both ends, added up: what rounding refers to
  bool endless = false;  ///< of a half-plane

  /// Height of the surface at a place across: that of the straight piece or, beyond it, of the disc at the end.
  double height_at(double across) const {
    if (endless) return low.height;
    const auto on_disc = [&](const End& end) {
      const double off = across - end.across, under = end.radius * end.radius - off * off;
      return end.height + std::sqrt(greatest(under, 0.0));
    };
    const double from = low.across + low.radius * leaning, to = high.across + high.radius * leaning;
    if (across < from) return on_disc(low);
    if (across > to) return on_disc(high);
    return low.height + low.radius * facing + (across - from) * slope;
  }
};

/// The vertex of a polygon that lies furthest along `direction`, found from one near it.
template <class T>
std::uint32_t furthest_from(const Core<T>& core, const Vec2d& direction, std::uint32_t vertex) {
  double most = dot(core.vertex(vertex), direction);
  const auto climb = [&](const auto& beside) {
    for (std::uint32_t k = 0; k < core.count; ++k) {
      const double d = dot(core.vertex(beside(vertex)), direction);
      if (!(d > most)) return;
      most = d, vertex = beside(vertex);
    }
  };
  climb([&](std::uint32_t i) { return core.next(i); });
  climb([&](std::uint32_t i) { return core.previous(i); });
  return vertex;
}

/// The edge of a polygon that faces `n` most, of the two beside the vertex that lies furthest along it.
template <class T>
struct FacingEdge {
  double facing = -1;  ///< cosine
  double length = 1;
  Vec2d edge{};
  std::uint32_t from = 0;

  /// `feature` is one near that edge.
  FacingEdge(const Core<T>& core, const Vec2d& n, std::uint32_t feature) {
    const std::uint32_t near = vertex_of(core, feature);
    const Edge own(core, n, near);
    // The edge whose normal is the given one needs no comparison with others.
    if (own.facing >= same_normal) {
      take(own);
      return;
    }
    const std::uint32_t top = furthest_from(core, n, near);
    const Edge behind(core, n, core.previous(top));
    if (top == near && own.length > 0 && behind.length > 0) {
      // A branch between the two would be mispredicted often: the number is selected, and the edge is read anew.
      const double facings[2] = {own.facing, behind.facing}, lengths[2] = {own.length, behind.length};
      const std::size_t k = behind.facing > own.facing ? 1 : 0;
      from = k == 0 ? own.from : behind.from;
      facing = facings[k], length = lengths[k], edge = core.edge(from);
    } else {
      take_beside(core, n, top);
    }
  }

 private:
  /// The cosine from which on a normal counts as the given one: only edges in line have two normals so near.
  static constexpr double same_normal = 1 - 0x1p-40;

  struct Edge {
    Vec2d edge;
    double length, facing;
    std::uint32_t from;

    Edge(const Core<T>& core, const Vec2d& n, std::uint32_t i)
        : edge(core.edge(i)), length(plane::length(edge)), facing(-1), from(i) {
      // Cuts of polygons and the far sides of chains touch nothing.
      const bool outer = !core.outline || core.outline[i].outer;
      if (length > 0 && outer) facing = dot(right(edge), n) / length;
    }
  };
  void take(const Edge& e) {
    if (!(e.facing > facing)) return;
    facing = e.facing, length = e.length, edge = e.edge, from = e.from;
  }
  /// The better one of the edges beside a vertex, past those without a length.
  void take_beside(const Core<T>& core, const Vec2d& n, std::uint32_t top) {
    const auto offer = [&](std::uint32_t i) {
      const Edge e(core, n, i);
      take(e);
      return e.length > 0;
    };
    std::uint32_t ahead = top, behind = core.previous(top);
    for (std::uint32_t k = 0; k < core.count && !offer(ahead); ++k) ahead = core.next(ahead);
    for (std::uint32_t k = 0; k < core.count && !offer(behind); ++k) behind = core.previous(behind);
  }
};

/// The side of a core towards `n` (unit, in the core's frame), if it has one that faces it. `along` runs across the
/// normal, to the left of A's; `feature` is one near that side.
template <class T>
Side side_towards(const Core<T>& core, const Vec2d& n, const Vec2d& along, std::uint32_t feature) {
  Side side;
  if (core.kind == CoreKind::half_plane) {
    side.straight = side.endless = true;
    side.low.height = side.high.height = core.radius;
    side.low.across = -std::numeric_limits<double>::infinity();
    side.high.across = std::numeric_limits<double>::infinity();
    return side;
  }
  Vec2d p, q, own;
  double radius_p = core.radius, radius_q = core.radius;
  std::uint32_t vertex_p = 0, vertex_q = 1;
  if (core.kind == CoreKind::polygon && core.count > 1) {
    const FacingEdge<T> best(core, n, feature);
    if (best.facing < least_facing) return side;
    own = right(best.edge) / best.length;
    vertex_p = best.from, vertex_q = core.next(best.from);
    p = core.vertex(vertex_p), q = core.vertex(vertex_q);
  } else if (core.kind == CoreKind::tapered) {
    p = {0, -core.half_height}, q = {0, core.half_height};
    radius_p += core.radii.x, radius_q += core.radii.y;
    // The side leans from the axis by the angle whose sine is the difference of the radii over the height.
    const double sine = (radius_p - radius_q) / (2 * core.half_height),
                 cosine = std::sqrt(greatest(1 - sine * sine, 0.0));
    own = {n.x < 0 ? -cosine : cosine, sine};
    if (dot(own, n) < least_facing) return side;
  } else {
    return side;
  }
  side.straight = true;
  side.own = own;
  side.facing = dot(own, n);
  side.leaning = dot(own, along);
  side.slope = -side.leaning / side.facing;
  side.low = {dot(p, along), dot(p, n), radius_p, vertex_p};
  side.high = {dot(q, along), dot(q, n), radius_q, vertex_q};
  side.reach = reach_of(p, q);
  if (side.low.across > side.high.across) std::swap(side.low, side.high);
  return side;
}

/// Makes the deepest point that of the nearest points. Where a disc of a tapered core meets a corner, the end of the
/// stretch that both sides share has the error of the normal, which is larger than that of the distance.
template <class T>
void take_nearest(Manifold<double>& out, const Core<T>& a, const Core<T>& b, const Nearest& found) {
  ContactPoint<double>* deepest = nullptr;
  for (ContactPoint<double>& p : out.points)
    if (!deepest || p.distance < deepest->distance) deepest = &p;
  if (!deepest) return;
  deepest->distance = found.distance - a.radius - b.radius;
  deepest->a = found.a.point + found.normal * a.radius;
  deepest->b = deepest->a + found.normal * deepest->distance;
}

/// The normal of tapered cores, replaced by that of the straight side that it stands for: a depth changes by the square
/// of the error of a normal.
template <class T>
Vec2d settled_normal(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& n) {
  if (a.kind != CoreKind::tapered && b.kind != CoreKind::tapered) return n;
  const auto stands_for = [&](const Side& side) {
    return side.straight && !side.endless && std::abs(side.leaning) <= searched_normal() && side.facing > 0;
  };
  const Vec2d toward_a = inverse_rotate(b_in_a.rotation, -n);
  if (const Side side = side_towards(a, n, left(n), 0); stands_for(side)) return side.own;
  if (const Side side = side_towards(b, toward_a, left(toward_a), 0); stands_for(side))
    return -rotate(b_in_a.rotation, side.own);
  return n;
}

/// B's side seen from A's frame: its heights grow against the normal.
Side seen_from_a(Side side, const Vec2d& translation, const Vec2d& n, const Vec2d& along) {
  const double across = dot(translation, along), height = -dot(translation, n);
  for (Side::End* end : {&side.low, &side.high}) end->across += across, end->height += height;
  return side;
}

void add_point(Manifold<double>& out, const Vec2d& along, double across, double height_a, double height_b,
               std::uint32_t feature, double margin) {
  const double distance = height_b - height_a;
  if (!(distance <= margin)) return;
  const Vec2d foot = along * across;
  ContactPoint<double>& point = out.points.emplace_back();
  point.a = foot + out.normal * height_a;
  point.b = foot + out.normal * height_b;
  point.distance = distance;
  point.feature = feature;
  point.weight = 0.5;
}

/// Adds one point, where the shapes are nearest. Between two discs it is weighted by their radii.
template <class T>
void add_nearest(Manifold<double>& out, const Core<T>& a, const Core<T>& b, const Nearest& found, double margin) {
  const double distance = found.distance - a.radius - b.radius;
  if (!(distance <= margin)) return;
  const bool discs = a.kind == CoreKind::polygon && b.kind == CoreKind::polygon && a.count == 1 && b.count == 1;
  const double radii = a.radius + b.radius;
  const Vec2d on_a = found.a.point + found.normal * a.radius;
  out.points.push_back({on_a, on_a + found.normal * distance, distance, feature_id(found.a.feature, found.b.feature),
                        discs && radii > 0 ? a.radius / radii : 0.5});
}

/// The straight side of a polygon, seen along a normal: like `Side`, but in order across from its construction on.
struct PolygonSide {
  double low_across, high_across, low_height, high_height, radius, facing, leaning, slope, reach;
  std::uint32_t low_vertex, high_vertex;

  /// `forward` says whether the polygon's edges run along `along` where they face `n`: those of A do, of B they do not.
  template <class T>
  PolygonSide(const Core<T>& core, const FacingEdge<T>& best, const Vec2d& n, const Vec2d& along, bool forward)
      : radius(core.radius) {
    const Vec2d own = right(best.edge) / best.length;
    facing = dot(own, n);
    leaning = dot(own, along);
    slope = -leaning / facing;
    low_vertex = forward ? best.from : core.next(best.from);
    high_vertex = forward ? core.next(best.from) : best.from;
    const Vec2d low = core.vertex(low_vertex), high = core.vertex(high_vertex);
    low_across = dot(low, along), low_height = dot(low, n);
    high_across = dot(high, along), high_height = dot(high, n);
    reach = reach_of(low, high);
  }
  void move(double across, double height) {
    low_across += across, high_across += across;
    low_height += height, high_height += height;
  }
  double height_at(double across) const {
    const double from = low_across + radius * leaning, to = high_across + radius * leaning;
    if (radius > 0 && (across < from || across > to)) {
      const bool low = across < from;
      const double off = across - (low ? low_across : high_across), under = radius * radius - off * off;
      return (low ? low_height : high_height) + std::sqrt(greatest(under, 0.0));
    }
    return low_height + radius * facing + (across - from) * slope;
  }
};

/// The points of two polygons whose edges face each other; none where they do not.
template <class T>
void add_facing_edges(Manifold<double>& out, const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                      const Nearest& found, double margin) {
  const Vec2d n = found.normal, along = left(n);
  const Vec2d toward_a = inverse_rotate(b_in_a.rotation, -n), along_b = inverse_rotate(b_in_a.rotation, along);
  const FacingEdge<T> edge_a(a, n, found.a.feature), edge_b(b, toward_a, found.b.feature);
  if (edge_a.facing < least_facing || edge_b.facing < least_facing) return;
  const PolygonSide of_a(a, edge_a, n, along, true);
  PolygonSide of_b(b, edge_b, toward_a, along_b, false);
  of_b.move(dot(b_in_a.translation, along), -dot(b_in_a.translation, n));
  const double low = greatest(of_a.low_across, of_b.low_across), high = least(of_a.high_across, of_b.high_across);
  if (!share_a_stretch(low, high, of_a.reach, of_b.reach, b_in_a.translation)) return;
  // A's outline runs to the left of its normal and B's to the right: at the low end lies the first vertex of A's edge
  // and the last of B's, whichever of them bounds the stretch.
  add_point(out, along, low, of_a.height_at(low), -of_b.height_at(low),
            feature_id(vertex_feature(of_a.low_vertex), vertex_feature(of_b.low_vertex)), margin);
  add_point(out, along, high, of_a.height_at(high), -of_b.height_at(high),
            feature_id(vertex_feature(of_a.high_vertex), vertex_feature(of_b.high_vertex)), margin);
}

}  // namespace

template <class T>
Manifold<double> manifold(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found,
                          double margin) {
  Manifold<double> out;
  out.normal = found.normal;
  if (found.status == Status::unbounded || !(found.distance - a.radius - b.radius <= margin)) return out;
  if (a.kind == CoreKind::polygon && b.kind == CoreKind::polygon) {
    if (a.count > 1 && b.count > 1) add_facing_edges(out, a, b, b_in_a, found, margin);
    if (out.points.empty()) add_nearest(out, a, b, found, margin);
    return out;
  }
  const Vec2d n = settled_normal(a, b, b_in_a, found.normal), along = left(n);
  const Side of_a = side_towards(a, n, along, found.a.feature);
  const Vec2d toward_a = inverse_rotate(b_in_a.rotation, -n), along_b = inverse_rotate(b_in_a.rotation, along);
  const Side of_b = of_a.straight
                        ? seen_from_a(side_towards(b, toward_a, along_b, found.b.feature), b_in_a.translation, n, along)
                        : Side{};
  const double low = greatest(of_a.low.across, of_b.low.across), high = least(of_a.high.across, of_b.high.across);
  const bool faces = of_a.straight && of_b.straight && !(of_a.endless && of_b.endless);
  const bool tapered = a.kind == CoreKind::tapered || b.kind == CoreKind::tapered;
  if (!faces || !share_a_stretch(low, high, of_a.reach, of_b.reach, b_in_a.translation,
                                 tapered ? searched_normal() : touching_rounding)) {
    add_nearest(out, a, b, found, margin);
    return out;
  }
  out.normal = n;
  const auto name = [](const Side& side, const Side::End& end) {
    return side.endless ? side_feature(0) : vertex_feature(end.vertex);
  };
  // A's outline runs to the left of its normal and B's to the right: at the low end lies the first vertex of A's edge
  // and the last of B's, whichever of them bounds the stretch.
  add_point(out, along, low, of_a.height_at(low), -of_b.height_at(low),
            feature_id(name(of_a, of_a.low), name(of_b, of_b.low)), margin);
  add_point(out, along, high, of_a.height_at(high), -of_b.height_at(high),
            feature_id(name(of_a, of_a.high), name(of_b, of_b.high)), margin);
  if (tapered && n == found.normal) take_nearest(out, a, b, found);
  if (out.points.empty()) {
    out.normal = found.normal;
    add_nearest(out, a, b, found, margin);
  }
  return out;
}

template <class T>
Manifold<double> facing_manifold(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Nearest& found,
                                 double margin) {
  Manifold<double> out;
  out.normal = found.normal;
  if (a.count > 1 && b.count > 1) add_facing_edges(out, a, b, b_in_a, found, margin);
  return out;
}

template Manifold<double> facing_manifold(const Core<float>&, const Core<float>&, const Pose2d&, const Nearest&,
                                          double);
template Manifold<double> facing_manifold(const Core<double>&, const Core<double>&, const Pose2d&, const Nearest&,
                                          double);
template Manifold<double> manifold(const Core<float>&, const Core<float>&, const Pose2d&, const Nearest&, double);
template Manifold<double> manifold(const Core<double>&, const Core<double>&, const Pose2d&, const Nearest&, double);

}  // namespace graze::plane
