#include "plane/beside.hpp"

#include <algorithm>
#include <array>

#include "plane/compound_data.hpp"
#include "plane/joined.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

namespace {

using Kind = OutlineVertex::Kind;

/// Lean of an edge, as a sine and so of no unit, within which it goes on in the line of another one: eight roundings of
/// a pose in float, and a thousandth of the lean that a body feels.
constexpr double in_line = 1e-6;

/// A range of parameters along an edge; empty where it is the other way round.
struct Range {
  double low, high;
};

/// A straight line by a point and a unit vector along it.
struct Line {
  Vec2d origin, along;

  /// Leaves of a range of parameters those at which the line is behind the one through `on_edge` with the outward
  /// normal `n`, moved outwards by `moved`.
  void keep_behind(const Vec2d& on_edge, const Vec2d& n, double moved, Range& range) const {
    const double a = dot(origin - on_edge, n) - moved, b = dot(along, n);
    if (b > 0)
      range.high = least(range.high, -a / b);
    else if (b < 0)
      range.low = greatest(range.low, -a / b);
    else if (a > 0)
      range = {1, 0};
  }
};

/// The part of a line in a polygon whose edges are moved outwards by `moved`, which keeps its corners sharp.
template <class T>
void keep_in_polygon(const Core<T>& core, const Line& line, double moved, Range& range) {
  for (std::uint32_t i = 0; i < core.count; ++i)
    line.keep_behind(core.vertex(i), normalized(right(core.edge(i))), moved, range);
}

/// The part of a line in a polygon or a segment with a rounding of `radius`: convex, and so all between the ends of the
/// parts in its discs, in the strips along its edges and in the polygon itself.
template <class T>
Range in_rounded(const Core<T>& core, const Line& line, double radius) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Range all{inf, -inf};
  const auto take = [&](const Range& part) {
    if (part.low <= part.high) all = {least(all.low, part.low), greatest(all.high, part.high)};
  };
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d from = line.origin - core.vertex(i), n = normalized(right(core.edge(i))), along = left(n);
    const double nearest = -dot(from, line.along), off = cross(line.along, from), half2 = radius * radius - off * off;
    if (half2 >= 0) take({nearest - std::sqrt(half2), nearest + std::sqrt(half2)});
    Range strip{-inf, inf};
    line.keep_behind(core.vertex(i), n, radius, strip);
    line.keep_behind(core.vertex(i), -n, 0, strip);
    line.keep_behind(core.vertex(i), -along, 0, strip);
    line.keep_behind(core.vertex(core.next(i)), along, 0, strip);
    take(strip);
  }
  if (core.count > 2) {
    Range polygon{-inf, inf};
    keep_in_polygon(core, line, 0, polygon);
    take(polygon);
  }
  return all;
}

/// The part of a line, in the frame of a core, that lies deeper in it than `depth`. Only what has an inside has one.
template <class T>
Range inside(const Core<T>& core, const Line& line, Range range, double depth) {
  const double moved = core.radius - depth;
  if (core.kind == CoreKind::half_plane) {
    line.keep_behind({}, {0, 1}, moved, range);
  } else if (core.kind != CoreKind::polygon || core.count < 2) {
    return {1, 0};
  } else if (moved > 0) {
    const Range part = in_rounded(core, line, moved);
    range = {greatest(range.low, part.low), least(range.high, part.high)};
  } else if (core.count > 2) {
    keep_in_polygon(core, line, moved, range);
  } else {
    return {1, 0};
  }
  return range;
}

/// The directions in which a core goes on from a point that it touches within `step`, none where it does not: those of
/// its outline and, between two that are opposite, the one that leads inside.
struct Tangents {
  std::array<Vec2d, 3> along{};
  std::size_t count = 0;
  bool buried = false;  ///< whether the point is inside
};

/// The tangents at the nearest point of a smooth outline, `out` outside of which a point is; `n` is the normal there.
Tangents smooth_tangents(double out, const Vec2d& n, double step) {
  if (out > step) return {};
  return {{right(n), left(n), -n}, 3, out < -step};
}

/// The tangents of a polygon or a segment whose edges are moved outwards by `grown`, with round corners.
template <class T>
Tangents grown_tangents(const Core<T>& core, const Vec2d& at, double grown, double step) {
  bool within = core.count > 2;
  double squared = std::numeric_limits<double>::infinity();
  Vec2d nearest{};
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d from = at - core.vertex(i), edge = core.edge(i);
    within = within && dot(from, right(edge)) < 0;
    const Vec2d way = from - edge * clamp(dot(from, edge) / length_squared(edge), 0.0, 1.0);
    if (const double far = length_squared(way); far < squared) squared = far, nearest = way;
  }
  if (within) return {{}, 0, true};
  return smooth_tangents(length(nearest) - grown, normalized(nearest), step);
}

/// The tangents of a polygon whose edges are moved inwards by `shrunk`; a disc of that radius about one of its corners
/// lies inside of the polygon.
template <class T>
Tangents shrunk_tangents(const Core<T>& core, const Vec2d& at, double shrunk, double step) {
  if (core.count < 3) return {};
  Tangents all{{}, 0, true};
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d n = normalized(right(core.edge(i)));
    const double out = dot(at - core.vertex(i), n) + shrunk;
    if (out > step) return {};
    if (out < -step) continue;
    if (all.count > 0) return {{}, 0, true};
    all = {{right(n), left(n), -n}, 3, false};
  }
  return all;
}

/// The tangents of a core seen from a corner with a rounding of its own: the whole of that corner's disc is inside of
/// the rounded core where the corner is inside of what is left when both roundings are made smaller by the corner's.
template <class T>
Tangents tangents(const Core<T>& core, const Vec2d& at, double rounding, double step) {
  const double grown = core.radius - rounding;
  if (core.kind == CoreKind::half_plane) return smooth_tangents(at.y - grown, {0, 1}, step);
  if (core.kind != CoreKind::polygon || core.count < 2) return {};
  if (grown > step) return grown_tangents(core, at, grown, step);
  if (grown < -step) return shrunk_tangents(core, at, -grown, step);
  // A point near a corner may lie on one of its edges as well.
  for (std::uint32_t i = 0; i < core.count; ++i) {
    if (length(at - core.vertex(i)) > step) continue;
    const Vec2d leaving = normalized(core.edge(i)), arriving = normalized(core.edge(core.previous(i)));
    if (core.count == 2) return {{leaving, {}}, 1, false};
    return {{leaving, -arriving}, 2, false};
  }
  bool buried = core.count > 2;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d from = at - core.vertex(i), leaving = normalized(core.edge(i));
    const double out = dot(from, right(leaving)), on = dot(from, leaving);
    if (std::abs(out) <= step && on > 0 && on < length(core.edge(i)))
      return {{leaving, -leaving, left(leaving)}, std::size_t(core.count > 2 ? 3 : 2), false};
    buried = buried && out < 0;
  }
  return {{}, 0, buried};
}

/// Whether a point lies in a core, or no further than `step` over one of its straight sides.
template <class T>
bool holds(const Core<T>& core, const Vec2d& at, double step) {
  if (core.kind == CoreKind::half_plane) return at.y <= core.radius + step;
  if (core.kind != CoreKind::polygon || core.count < 2) return false;
  bool within = core.count > 2;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d from = at - core.vertex(i), edge = core.edge(i);
    const double out = dot(from, normalized(right(edge))), on = dot(from, edge);
    if (out >= 0 && out <= core.radius + step && on >= 0 && on <= length_squared(edge)) return true;
    if (length(from) <= core.radius - step) return true;
    within = within && out <= 0;
  }
  return within;
}

/// Calls `f(n)` with the directions, in the frame of a core, in which a mover may press against one of its vertices:
/// towards the nearest point of the mover or, if that is a polygon around the vertex, against the mover's edges.
template <class T, class F>
void for_each_way_to(const Core<T>& mover, const Pose2d& mover_in, const Vec2d& vertex, double size, const F& f) {
  const Nearest found = nearest(polygon_core<T>(0, plane::converted<T>(vertex)), mover, mover_in, size);
  if (found.distance > 0 || mover.kind != CoreKind::polygon) return f(found.normal);
  for (std::uint32_t i = 0; i < mover.count; ++i) f(-rotate(mover_in.rotation, normalized(right(mover.edge(i)))));
}

/// Normals from one unit vector counter-clockwise to another, at most half a turn.
struct Normals {
  Vec2d first, last;
  bool none = false;

  /// Leaves out those that lead along `t`.
  void leave_out(const Vec2d& t) {
    const bool keeps_first = dot(first, t) <= in_line, keeps_last = dot(last, t) <= in_line;
    if (keeps_first && keeps_last) return;
    none = none || !(keeps_first || keeps_last);
    // The bound between the two that are left, a quarter turn from `t`; one normal is left where the two are in line.
    const Vec2d& kept = keeps_first ? first : last;
    const double turn = keeps_first ? cross(kept, left(t)) : cross(left(t), kept);
    (keeps_first ? last : first) = std::abs(turn) <= in_line ? kept : turn > 0 ? left(t) : right(t);
  }
};

/// Whether the outer side of a segment's edge is the one on which a point is.
template <class T>
bool faces(const Core<T>& segment, std::uint32_t edge, const Vec2d& point) {
  return dot(point - segment.vertex(edge), right(segment.edge(edge))) >= 0;
}

/// A disc around a core, rounding included, in the world; an endless one around a half-plane.
template <class T>
Disc disc_around(const Core<T>& core, const Pose2d& pose) {
  if (core.kind == CoreKind::half_plane) return {{}, std::numeric_limits<double>::infinity()};
  Vec2d sum{};
  for (std::uint32_t i = 0; i < core.count; ++i) sum += core.vertex(i);
  const Vec2d middle = sum / core.count;
  double squared = 0;
  for (std::uint32_t i = 0; i < core.count; ++i) squared = greatest(squared, length_squared(core.vertex(i) - middle));
  return {transform(pose, middle), std::sqrt(squared) + core.radius};
}

/// Whether a core is a polygon or a segment all of whose edges have a length.
template <class T>
bool has_sides(const Core<T>& core) {
  if (core.kind != CoreKind::polygon || core.count < 2) return false;
  for (std::uint32_t i = 0; i < core.count; ++i)
    if (!(length_squared(core.edge(i)) > 0)) return false;
  return true;
}

/// Takes the normals of covered edges from the vertex between them, of which the one that arrives or leaves is covered:
/// where a covered edge faces the other body, a vertex that nothing touches does not.
void leave_covered(bool arriving, bool leaving, bool touched, OutlineVertex& vertex) {
  if (!touched && vertex.kind == Kind::convex) {
    if (arriving && leaving) vertex.kind = Kind::reflex;
    if (arriving) vertex.arriving = vertex.leaving;
    if (leaving) vertex.leaving = vertex.arriving;
  }
  if (vertex.kind != Kind::reflex) return;
  // Edges beside a piece that end at its tip bound it; a covered edge bounds nothing.
  if (arriving) vertex.arriving = -vertex.arriving;
  if (leaving) vertex.leaving = -vertex.leaving;
}

}  // namespace

template <class T>
Ground<T>::Ground(std::span<const PlacedRef<T>> around, const Shape<T>& own, const Pose2<T>& pose,
                  const Shape<T>& mover, const Pose2<T>& pose_m)
    : around_(around), own_(own) {
  const auto* compound = own.template as<Compound<T>>();
  const bool has_others = compound && compound->data().nesting.leaves > 1;
  if (around.empty() && !has_others) return;
  const double reach = is_bounded(mover) ? double(extent(mover)) * 2 : std::numeric_limits<double>::infinity();
  const Pose2d at_mover = at_unit(pose_m);
  const auto nowhere = [] { return 0.0; };
  const auto near_mover = near_disc(at_mover.translation, reach, nowhere);
  const auto gather = [&](const Shape<T>& shape, const Pose2<T>& place, bool itself) {
    for_each_leaf(
        shape, at_unit(place), near_mover, [&](const Core<T>& core, const Pose2d& at, double size, std::uint32_t) {
          const bool half_plane = core.kind == CoreKind::half_plane;
          if (!half_plane && (!has_sides(core) || discs_apart(at.translation - at_mover.translation, size, reach) > 0))
            return;
          pieces_.push_back({core, at, itself, disc_around(core, at)});
        });
  };
  if (has_others) gather(own, pose, true);
  for (const PlacedRef<T>& body : around)
    if (body.shape != &own) gather(*body.shape, *body.pose, false);
}

template <class T>
bool Ground<T>::overlaps(const Shape<T>& shape, const Pose2<T>& pose) const {
  return std::any_of(around_.begin(), around_.end(), [&](const PlacedRef<T>& body) {
    return body.shape != &own_ && plane::overlap(shape, pose, *body.shape, *body.pose);
  });
}

/// Whether the pieces cover all of an edge that faces a core: the inside of one of them lies just outside of it, but
/// for gaps no wider than `step`.
template <class T>
bool Ground<T>::covers(const Core<T>& core, std::uint32_t edge, const Meeting& meeting, const Pose2d& mover_in,
                       double step) const {
  const Core<T>& mover = meeting.mover;
  const Vec2d start = core.vertex(edge), whole = core.edge(edge), along = normalized(whole), out = right(along);
  const double end = length(whole);
  Range faced{0, end};
  if (mover.kind != CoreKind::half_plane) {
    const auto reach = [&](const Vec2d& d) {
      return dot(transform(mover_in, support(mover, inverse_rotate(mover_in.rotation, d)).point) - start, d) +
             mover.radius;
    };
    faced = {clamp(-reach(-along), 0.0, end), clamp(reach(along), 0.0, end)};
  }
  const Vec2d middle = transform(meeting.pose, start + whole * 0.5);
  SmallVector<Range, 8> covered;
  for (const Piece& piece : pieces_) {
    if (is_same(piece, core) || piece.around.is_beyond(middle, end / 2 + core.radius + 2 * step)) continue;
    const Pose2d in = relative(piece.pose, meeting.pose);
    const Line over{transform(in, start + out * (core.radius + step)), rotate(in.rotation, along)};
    const Range range = inside(piece.core, over, {faced.low - step, faced.high + step}, step / 2);
    if (range.low <= range.high) covered.push_back(range);
  }
  std::sort(covered.begin(), covered.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
  double reached = faced.low;
  for (const Range& range : covered) {
    if (range.low > reached + step) return false;
    reached = greatest(reached, range.high);
  }
  return !covered.empty() && reached >= faced.high - step;
}

/// Leaves a vertex those normals that lead into none of the pieces that touch it. Returns whether any touches it.
template <class T>
bool Ground<T>::restrict_normals(const Core<T>& core, std::uint32_t i, const Meeting& meeting,
                                 const Vec2d& mover_center, double step, OutlineVertex& vertex) const {
  if (vertex.kind == Kind::reflex) return false;
  Normals normals{right(vertex.arriving), right(vertex.leaving)};
  if (core.chain) {
    // The end of a chain has the normals of half a turn, of which those of this side count.
    if (vertex.kind == Kind::first) normals = {left(vertex.leaving), right(vertex.leaving)};
    if (vertex.kind == Kind::last) normals = {right(vertex.arriving), left(vertex.arriving)};
    if (vertex.kind != Kind::convex) normals.leave_out(left(vertex.leaving));
  } else if (core.count == 2) {
    const Vec2d side = normalized(right(core.edge(i)));
    normals.leave_out(faces(core, i, mover_center) ? -side : side);
  }
  const Vec2d at = transform(meeting.pose, core.vertex(i));
  bool touched = false;
  for (const Piece& piece : pieces_) {
    if (is_same(piece, core) || piece.around.is_beyond(at, core.radius + 2 * step)) continue;
    const Pose2d in = relative(piece.pose, meeting.pose);
    const Tangents on = tangents(piece.core, transform(in, core.vertex(i)), core.radius, step);
    normals.none = normals.none || on.buried;
    touched = touched || on.buried || on.count > 0;
    for (std::size_t k = 0; k < on.count; ++k) normals.leave_out(inverse_rotate(in.rotation, on.along[k]));
  }
  if (!touched && (core.count > 2 || core.chain)) return false;
  if (core.chain && !normals.none) vertex.kind = Kind::convex;
  // The edge that begins here keeps its normal where it is part of the outline.
  if (normals.none || (vertex.outer && dot(normals.last, right(vertex.leaving)) < 1 - in_line))
    vertex.kind = Kind::reflex;
  if (vertex.kind != Kind::convex) return touched;
  vertex.arriving = left(normals.first);
  if (!vertex.outer) vertex.leaving = left(normals.last);
  return touched;
}

/// Whether the disc at a vertex, wherever the mover may press against it beside the core's own edges, is inside of the
/// pieces around it or level with them: an edge of a piece with a smaller rounding that begins at the top of the disc
/// leaves it behind only little by little. Pieces with the same rounding or a larger one have left no such normals.
template <class T>
bool Ground<T>::is_buried(const Core<T>& core, std::uint32_t i, const Meeting& meeting, double step,
                          const OutlineVertex& vertex) const {
  if (!(core.radius > 0)) return false;
  const Vec2d center = core.vertex(i), in_world = transform(meeting.pose, center);
  const auto is_near = [&](const Piece& piece) {
    return !is_same(piece, core) && !piece.around.is_beyond(in_world, core.radius + 2 * step);
  };
  const auto is_sharper = [&](const Piece& piece) { return piece.core.radius < core.radius - step && is_near(piece); };
  if (std::none_of(pieces_.begin(), pieces_.end(), is_sharper)) return false;
  bool meets = false, bare = false;
  const Pose2d mover_in = relative(meeting.pose, meeting.mover_pose);
  for_each_way_to(meeting.mover, mover_in, center, meeting.pair_size, [&](const Vec2d& n) {
    if (bare || !(dot(n, vertex.arriving) > in_line && dot(n, vertex.leaving) < -in_line)) return;
    meets = true;
    const Vec2d at = transform(meeting.pose, center + n * core.radius);
    bare = std::none_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
      return is_near(piece) && holds(piece.core, inverse_transform(piece.pose, at), step);
    });
  });
  return meets && !bare;
}

/// Fits the outline of a core, seen from one side if it is a chain's segment, into the ground. Returns whether anything
/// beside it matters.
template <class T>
bool Ground<T>::outline_of_side(const Core<T>& core, const Meeting& meeting, double step,
                                std::span<OutlineVertex> side) const {
  const Pose2d mover_in = relative(meeting.pose, meeting.mover_pose);
  bool matters = false;
  SmallVector<std::uint8_t, 8> covered;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    OutlineVertex& vertex = side[i];
    covered.push_back(vertex.outer && covers(core, i, meeting, mover_in, step) ? 1 : 0);
    vertex.outer = vertex.outer && covered[i] == 0;
    matters = matters || covered[i] != 0;
  }
  for (std::uint32_t i = 0; i < core.count; ++i) {
    bool touched = restrict_normals(core, i, meeting, mover_in.translation, step, side[i]);
    if (side[i].kind == Kind::convex && is_buried(core, i, meeting, step, side[i])) {
      side[i].kind = Kind::reflex;
      touched = true;
    }
    matters = matters || touched;
    leave_covered(covered[core.previous(i)] != 0, covered[i] != 0, touched, side[i]);
  }
  return matters;
}

template <class T>
void Ground<T>::outline(Core<T>& core, const Meeting& meeting, SmallVector<OutlineVertex, 8>& outline) const {
  outline.clear();
  if (empty() || !has_sides(core)) return;
  const std::uint32_t count = core.chain ? 2 * core.count : core.count;
  for (std::uint32_t i = 0; i < count; ++i) {
    OutlineVertex vertex;
    if (core.outline) {
      vertex = core.outline[i];
    } else {
      vertex.arriving = normalized(core.edge(core.previous(i)));
      vertex.leaving = normalized(core.edge(i));
      vertex.number = i;
      // The side of a segment that counts is the one on which the other body is.
      if (core.count == 2) vertex.outer = faces(core, i, relative(meeting.pose, meeting.mover_pose).translation);
    }
    outline.push_back(vertex);
  }
  const double step = seam_step * meeting.size;
  bool matters = false;
  for (std::uint32_t first = 0; first < count; first += core.count) {
    const std::span side(outline.data() + first, core.count);
    matters = outline_of_side(core, meeting, step, side) || matters;
  }
  if (matters)
    core.outline = outline.data();
  else
    outline.clear();
}

template <class T>
bool contacts_beside(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                     Manifolds<T>& manifolds, std::span<const PlacedRef<T>> of_a, std::span<const PlacedRef<T>> of_b) {
  const Ground<T> ground_a(of_a, a, pose_a, b, pose_b), ground_b(of_b, b, pose_b, a, pose_a);
  const auto limit = double(margin);
  const auto within = [&] { return limit; };
  const auto visit_near = [&](const auto& see) {
    for_each_pair_within(a, pose_a, b, pose_b, within, [&](const LeafPair<T>& pair) {
      if (!(pair.apart() > limit)) see(pair);
    });
  };
  SmallVector<OutlineVertex, 8> outline_a, outline_b;
  // Calls `see` with every pair of pieces near each other that has its outlines among the ground.
  const auto visit = [&](const auto& see) {
    visit_near([&](const LeafPair<T>& pair) {
      const double size = least(pair.extent_a, pair.extent_b);
      Core<T> core_a = pair.a, core_b = pair.b;
      ground_a.outline(core_a, {pair.pose_a, pair.b, pair.pose_b, size, pair.size()}, outline_a);
      ground_b.outline(core_b, {pair.pose_b, pair.a, pair.pose_a, size, pair.size()}, outline_b);
      see(LeafPair<T>{core_a, core_b, pair.pose_a, pair.pose_b, pair.extent_a, pair.extent_b, pair.piece_a,
                      pair.piece_b});
    });
  };
  bool matters = false;
  if (!ground_a.empty() || !ground_b.empty())
    visit([&](const LeafPair<T>&) { matters = matters || !outline_a.empty() || !outline_b.empty(); });
  if (!matters && a.convex() && b.convex()) return contacts(a, pose_a, b, pose_b, margin, manifolds);
  if (!matters) return join_contacts(a, pose_a, b, pose_b, limit, manifolds, visit_near, [] { return true; });

  return join_contacts(a, pose_a, b, pose_b, limit, manifolds, visit,
                       [&] { return !ground_a.overlaps(b, pose_b) && !ground_b.overlaps(a, pose_a); });
}

#define GRAZE_PLANE_BESIDE(T)                                                                                          \
  template class Ground<T>;                                                                                            \
  template bool contacts_beside(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, T, Manifolds<T>&,  \
                                std::span<const PlacedRef<T>>, std::span<const PlacedRef<T>>);
GRAZE_PLANE_BESIDE(float)
GRAZE_PLANE_BESIDE(double)
#undef GRAZE_PLANE_BESIDE

}  // namespace graze::plane
