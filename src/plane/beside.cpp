#include "plane/beside.hpp"

#include <algorithm>
#include <array>

#include "plane/joined.hpp"

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

/// The part of a line, in the frame of a core, that lies deeper in it than `depth`. Only solids have one.
template <class T>
Range inside(const Core<T>& core, const Vec2d& origin, const Vec2d& along, Range range, double depth) {
  // Keeps the parameters t with a + b t <= 0.
  const auto keep = [&](double a, double b) {
    if (b > 0)
      range.high = least(range.high, -a / b);
    else if (b < 0)
      range.low = greatest(range.low, -a / b);
    else if (a > 0)
      range = {1, 0};
  };
  if (core.kind == CoreKind::half_plane) {
    keep(origin.y - core.radius + depth, along.y);
  } else if (core.kind == CoreKind::polygon && core.count > 2) {
    for (std::uint32_t i = 0; i < core.count; ++i) {
      const Vec2d n = normalized(right(core.edge(i)));
      keep(dot(origin - core.vertex(i), n) - core.radius + depth, dot(along, n));
    }
  } else {
    return {1, 0};
  }
  return range;
}

/// The directions in which a core goes on from a point that it touches within `step`, none where it does not.
struct Tangents {
  std::array<Vec2d, 2> along{};
  std::size_t count = 0;
  bool buried = false;  ///< whether the point is inside
};
template <class T>
Tangents tangents(const Core<T>& core, const Vec2d& at, double step) {
  if (core.kind == CoreKind::half_plane) {
    if (at.y > step) return {};
    return {{Vec2d{1, 0}, Vec2d{-1, 0}}, 2, at.y < -step};
  }
  if (core.kind != CoreKind::polygon || core.count < 2) return {};
  bool buried = core.count > 2;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d from = at - core.vertex(i), leaving = normalized(core.edge(i)),
                arriving = normalized(core.edge(core.previous(i)));
    if (length(from) <= step) {
      if (core.count == 2) return {{leaving, {}}, 1, false};
      return {{leaving, -arriving}, 2, false};
    }
    const double out = dot(from, right(leaving)), on = dot(from, leaving);
    if (std::abs(out) <= step && on > 0 && on < length(core.edge(i))) return {{leaving, -leaving}, 2, false};
    buried = buried && out < 0;
  }
  return {{}, 0, buried};
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
    // The bound between the two that are left, a quarter turn from `t`.
    const Vec2d& kept = keeps_first ? first : last;
    const double turn = keeps_first ? cross(kept, left(t)) : cross(left(t), kept);
    const bool is_left = std::abs(turn) > in_line ? turn > 0 : dot(left(t), kept) > 0;
    (keeps_first ? last : first) = is_left ? left(t) : right(t);
  }
};

/// Whether the outer side of a segment's edge is the one on which a point is.
template <class T>
bool faces(const Core<T>& segment, std::uint32_t edge, const Vec2d& point) {
  return dot(point - segment.vertex(edge), right(segment.edge(edge))) >= 0;
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
  const bool has_others = compound && compound->children().size() > 1;
  if (around.empty() && !has_others) return;
  const double reach = is_bounded(mover) ? double(extent(mover)) * 2 : std::numeric_limits<double>::infinity();
  const Pose2d at_mover = at_unit(pose_m);
  const auto nowhere = [] { return 0.0; };
  const auto near_mover = near_disc(at_mover.translation, reach, nowhere);
  const auto gather = [&](const Shape<T>& shape, const Pose2<T>& place, bool itself) {
    for_each_leaf(shape, at_unit(place), 0, true, near_mover,
                  [&](const Core<T>& core, const Pose2d& at, double size, std::uint32_t child) {
                    const bool half_plane = core.kind == CoreKind::half_plane;
                    if (!half_plane &&
                        (!has_sides(core) || discs_apart(at.translation - at_mover.translation, size, reach) > 0))
                      return;
                    pieces_.push_back({core, at, itself ? child : of_another});
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
  SmallVector<Range, 8> covered;
  for (const Piece& piece : pieces_) {
    if (piece.child == meeting.child) continue;
    const Pose2d in = relative(piece.pose, meeting.pose);
    const Range range = inside(piece.core, transform(in, start + out * (core.radius + step)),
                               rotate(in.rotation, along), {faced.low - step, faced.high + step}, step / 2);
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
  Normals normals{right(vertex.arriving), right(vertex.leaving)};
  if (core.count == 2) {
    const Vec2d side = normalized(right(core.edge(i)));
    normals.leave_out(faces(core, i, mover_center) ? -side : side);
  }
  bool touched = false;
  for (const Piece& piece : pieces_) {
    if (piece.child == meeting.child || piece.core.radius != 0) continue;
    const Pose2d in = relative(piece.pose, meeting.pose);
    const Tangents on = tangents(piece.core, transform(in, core.vertex(i)), step);
    normals.none = normals.none || on.buried;
    touched = touched || on.buried || on.count > 0;
    for (std::size_t k = 0; k < on.count; ++k) normals.leave_out(inverse_rotate(in.rotation, on.along[k]));
  }
  if (!touched && core.count > 2) return false;
  // The edge that begins here keeps its normal where it is part of the outline.
  if (normals.none || (vertex.outer && dot(normals.last, right(vertex.leaving)) < 1 - in_line))
    vertex.kind = Kind::reflex;
  if (vertex.kind != Kind::convex) return touched;
  vertex.arriving = left(normals.first);
  if (!vertex.outer) vertex.leaving = left(normals.last);
  return touched;
}

template <class T>
void Ground<T>::outline(Core<T>& core, const Meeting& meeting, SmallVector<OutlineVertex, 8>& outline) const {
  outline.clear();
  if (empty() || core.chain || !has_sides(core)) return;
  const double step = seam_step * meeting.size;
  const Pose2d mover_in = relative(meeting.pose, meeting.mover_pose);
  bool matters = false;
  SmallVector<std::uint8_t, 8> covered;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    OutlineVertex vertex;
    if (core.outline) {
      vertex = core.outline[i];
    } else {
      vertex.arriving = normalized(core.edge(core.previous(i)));
      vertex.leaving = normalized(core.edge(i));
      vertex.number = i;
    }
    // The side of a segment that counts is the one on which the other body is.
    if (core.count == 2) vertex.outer = faces(core, i, mover_in.translation);
    covered.push_back(vertex.outer && covers(core, i, meeting, mover_in, step) ? 1 : 0);
    vertex.outer = vertex.outer && covered[i] == 0;
    matters = matters || covered[i] != 0;
    outline.push_back(vertex);
  }
  for (std::uint32_t i = 0; i < core.count; ++i) {
    OutlineVertex& vertex = outline[i];
    const bool touched = core.radius == 0 && restrict_normals(core, i, meeting, mover_in.translation, step, vertex);
    matters = matters || touched;
    leave_covered(covered[core.previous(i)] != 0, covered[i] != 0, touched, vertex);
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
      ground_a.outline(core_a, {pair.pose_a, pair.piece_a, pair.b, pair.pose_b, size}, outline_a);
      ground_b.outline(core_b, {pair.pose_b, pair.piece_b, pair.a, pair.pose_a, size}, outline_b);
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
