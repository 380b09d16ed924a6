#include "plane/joined.hpp"

#include <algorithm>
#include <utility>

#include "plane/manifold.hpp"

namespace graze::plane {

namespace {

template <class T>
Vec2d polygon_center(const Core<T>& core) {
  const Vec2d origin = core.vertex(0);
  Vec2d mean{}, weighted{};
  double area = 0;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const Vec2d p = core.vertex(i) - origin, q = core.vertex(core.next(i)) - origin;
    const double twice = cross(p, q);
    mean += p;
    area += twice;
    weighted += (p + q) * twice;
  }
  // A sliver whose area is lost to rounding has the mean of its vertices, which lies in it too.
  const double width = length_squared(mean) / (core.count * core.count);
  if (!(area > 1e-12 * width)) return origin + mean / core.count;
  return origin + weighted / (3 * area);
}

/// A point in the middle of a convex core: a polygon's centroid, and `far` below the surface of a half-plane.
template <class T>
Vec2d center_of(const Core<T>& core, double far) {
  switch (core.kind) {
  case CoreKind::polygon: return polygon_center(core);
  case CoreKind::tapered: return {0, (core.radii.y - core.radii.x) / 2};
  case CoreKind::ellipse: return {};
  case CoreKind::user: {
    const auto middle = [&](const Vec2d& d) {
      return (dot(support(core, d).point, d) - dot(support(core, -d).point, -d)) / 2;
    };
    return {middle({1, 0}), middle({0, 1})};
  }
  case CoreKind::half_plane: break;
  }
  return {0, -far};
}

/// The centre of a body in the world: the mean over its convex pieces.
template <class T>
Vec2d body_center(const Shape<T>& shape, const Pose2d& pose, double far) {
  Vec2d sum{};
  double count = 0;
  for_each_leaf(shape, pose, Everywhere{}, [&](const Core<T>& core, const Pose2d& at, double, std::uint32_t) {
    sum += transform(at, center_of(core, far));
    count += 1;
  });
  return sum / count;
}

/// Whether a point lies on the left of a chain: the side of its nearest segment or, where a corner is nearest, the
/// side on which that corner stands out.
template <class T>
bool left_of(const Pieces<T>& segments, const Vec2d& point) {
  double squared = std::numeric_limits<double>::infinity();
  bool left = false;
  const auto nearer = [&](const Aabb2<double>& box) {
    return length_squared(point - least(greatest(point, box.lower), box.upper)) < squared;
  };
  segments.for_each(nearer, [&](std::uint32_t i) {
    const std::span<const Vec2<T>> ends = segments.vertices(i);
    const Vec2d start = converted<double>(ends[0]), edge = converted<double>(ends[1]) - start;
    const double t = clamp(dot(point - start, edge) / length_squared(edge), 0.0, 1.0);
    const double far = length_squared(start + edge * t - point);
    if (!(far < squared)) return;
    squared = far;
    left = cross(edge, point - start) > 0;
    if (t > 0 && t < 1) return;
    const OutlineVertex* outline = segments.outline(i);
    const bool end = t > 0;
    if (outline[end].kind == OutlineVertex::Kind::reflex) left = true;
    if (outline[end + 2].kind == OutlineVertex::Kind::reflex) left = false;
  });
  return left;
}

/// A feature with the number of its vertex on the outline in place of that in the piece.
template <class T>
std::uint32_t on_whole(const Core<T>& core, std::uint32_t feature) {
  const std::uint32_t kind = feature >> graze::detail::feature_number_bits,
                      vertex = feature & ((1u << graze::detail::feature_number_bits) - 1);
  return core.outline ? graze::detail::feature_of_kind(kind, core.outline[vertex].number) : feature;
}

template <class T>
void name_on_wholes(Manifold<double>& manifold, const Core<T>& a, const Core<T>& b) {
  for (ContactPoint<double>& p : manifold.points)
    p.feature = feature_id(on_whole(a, p.feature >> 16), on_whole(b, p.feature & 0xffff));
}

/// Whether a point on the line of one of the core's edges lies beside that edge.
template <class T>
bool beside_edge(const Core<T>& core, std::uint32_t feature, const Vec2d& point) {
  if (core.kind != CoreKind::polygon || (feature >> graze::detail::feature_number_bits) != 2) return false;
  const std::uint32_t i = feature & ((1u << graze::detail::feature_number_bits) - 1);
  const double at = dot(point - core.vertex(i), core.edge(i));
  return at < 0 || at > length_squared(core.edge(i));
}

/// Whether all of a body lies behind the line through a point of the world whose outward normal is `n`.
template <class T>
bool lies_behind(const Shape<T>& shape, const Pose2d& pose, const Vec2d& on_line, const Vec2d& n) {
  bool behind = true;
  for_each_leaf(shape, pose, Everywhere{}, [&](const Core<T>& core, const Pose2d& at, double, std::uint32_t) {
    if (!behind) return;
    const auto out = [&] { return transform(at, support(core, inverse_rotate(at.rotation, n)).point) - on_line; };
    behind = core.kind != CoreKind::half_plane && dot(out(), n) + core.radius < 0;
  });
  return behind;
}

/// Whether a point has a surer name than another one in the same place, as two pieces that both have it name it: a
/// vertex is surer than an edge, whichever shape is A and whichever piece came first.
template <class T>
bool is_surer_name(const ContactPoint<T>& p, const ContactPoint<T>& q) {
  const auto key = [](std::uint32_t feature) {
    const std::uint32_t a = feature >> 16, b = feature & 0xffff;
    return std::pair(std::max(a, b), std::min(a, b));
  };
  return key(p.feature) < key(q.feature);
}

/// The depth, as a multiple of that of the nearest way out, from which on a neighbour's normal holds a piece that the
/// body does not rest on: a body that leans over a seam gets a few times as deep along the right one.
constexpr double far_deeper = 8;

/// The largest error of a normal, in radians, within which contacts are still taken for the same.
constexpr double most_doubt = 0x1p-4;

}  // namespace

/// Turns a chain's segment to the side that the other body is on. False where that side gives no contacts.
template <class T>
bool Joined<T>::face(Core<T>& segment, const Pose2d& pose, const Vec2d& other_center, ChainSide& known) const {
  const Vec2d own = inverse_transform(pose, other_center);
  if (known.chain != segment.chain || !(known.pose == pose)) {
    known = {segment.chain, pose, segment.chain->sides() == ChainSides::both && left_of(*segment.pieces, own)};
  }
  if (known.left) segment.outline += 2;
  const double side = cross(segment.edge(0), own - segment.vertex(0));
  return known.left ? side >= 0 : side <= 0;
}

/// Turns the segments of chains among two cores to the other body. False where a side gives no contacts.
template <class T>
bool Joined<T>::faces(Core<T>& a, Core<T>& b, const LeafPair<T>& pair, const Pose2d& b_in_a) {
  const double far = 4 * (pair.extent_a + pair.extent_b + length(b_in_a.translation));
  return (!a.chain || face(a, pair.pose_a, body_center(b_, pose_b_, far), side_a_)) &&
         (!b.chain || face(b, pair.pose_b, body_center(a_, pose_a_, far), side_b_));
}

/// Whether another piece has the contact, if any has: the normal is that of an edge beside this one, or of an edge on
/// the far side, over which the other body has not come in, since it lies wholly behind it.
template <class T>
bool Joined<T>::gives_way(const OnOutline& found, const LeafPair<T>& pair) const {
  if (found.of_neighbour) return true;
  const Vec2d n = rotate(pair.pose_a.rotation, found.normal);
  if (found.behind_a)
    return lies_behind(b_, pose_b_, transform(pair.pose_a, found.a.point + found.normal * pair.a.radius), n);
  if (found.behind_b)
    return lies_behind(a_, pose_a_, transform(pair.pose_a, found.b.point - found.normal * pair.b.radius), -n);
  return false;
}

template <class T>
void Joined<T>::measure(const LeafPair<T>& pair) {
  const bool bounded = pair.a.kind != CoreKind::half_plane && pair.b.kind != CoreKind::half_plane;
  size_ = greatest(size_, pair.size());
  step_ = greatest(step_, seam_step * (bounded ? least(pair.extent_a, pair.extent_b) : pair.size()));
}

template <class T>
void Joined<T>::add(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found, double margin) {
  if (found.distance - pair.a.radius - pair.b.radius > margin) return;
  Core<T> a = pair.a, b = pair.b;
  if (!faces(a, b, pair, b_in_a)) return;
  const std::optional<OnOutline> settled = nearest_on_outlines(a, b, b_in_a, found, pair.size());
  if (!settled) return keep_in_line(a, b, pair, b_in_a, margin);
  Manifold<double> m = manifold(a, b, b_in_a, *settled, margin);
  if (m.points.empty()) return;
  const bool own = settled->a.point == found.a.point && settled->b.point == found.b.point;
  const bool way = !own && gives_way(*settled, pair);
  const bool beside = way || (!own && m.points.size() == 1 &&
                              (beside_edge(a, settled->a.feature, settled->a.point) ||
                               beside_edge(b, settled->b.feature, inverse_transform(b_in_a, settled->b.point))));
  name_on_wholes(m, a, b);
  const Manifold<T> placed = in_world<T>(m, pair);
  if (!beside) {
    const bool curved = a.kind != CoreKind::polygon || b.kind != CoreKind::polygon;
    const Doubt off = curved ? doubt(a, b, b_in_a, *settled, pair.size()) : Doubt{};
    if (off.taken == 0) return join(placed);
    off_ = greatest(off_, least(off.possible, most_doubt));
    return keep_doubtful(placed, off.taken);
  }
  if (instead_ && !(placed.points[0].distance > instead_->points[0].distance)) return;
  instead_ = placed;
  deeper_ = way && (!settled->of_neighbour || settled->distance < far_deeper * found.distance);
}

template <class T>
void Joined<T>::stand_in(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found) {
  const double distance = found.distance - pair.a.radius - pair.b.radius;
  if (distance > 0 || (instead_ && !(distance < deepest_))) return;
  const auto one_sided = [](const Core<T>& core) { return core.chain && core.chain->sides() != ChainSides::both; };
  Core<T> a = pair.a, b = pair.b;
  if ((one_sided(a) || one_sided(b)) && !faces(a, b, pair, b_in_a)) return;
  a.outline = b.outline = nullptr;
  Manifold<double> m = manifold(a, b, b_in_a, found, 0);
  if (m.points.empty()) return;
  name_on_wholes(m, pair.a, pair.b);
  instead_ = in_world<T>(m, pair);
  deeper_ = false;
  deepest_ = distance;
}

/// Keeps the contacts of two sides that face each other along a normal of an outline. A side that leans a little over
/// pieces in line is nearest to one of them, and to the others where they begin, along a normal that is not theirs; but
/// it may rest on them all.
template <class T>
void Joined<T>::keep_in_line(const Core<T>& a, const Core<T>& b, const LeafPair<T>& pair, const Pose2d& b_in_a,
                             double margin) {
  if (a.kind != CoreKind::polygon || b.kind != CoreKind::polygon) return;
  const std::optional<OnOutline> along = least_overlap_on_outlines(a, b, b_in_a);
  if (!along) return;
  Manifold<double> m = facing_manifold(a, b, b_in_a, *along, margin);
  if (m.points.empty()) return;
  name_on_wholes(m, a, b);
  in_line_.push_back(InLine(in_world<T>(m, pair)));
}

/// Adds a manifold to the one that it goes on from, or as one of its own.
template <class T>
void Joined<T>::join(const Manifold<T>& manifold) {
  if (!extend(manifold, out_.size())) out_.push_back(manifold);
}

/// Adds the contacts of pieces in line to the manifolds beside them. A piece that was added may be the neighbour of the
/// next one, so the search is repeated.
template <class T>
void Joined<T>::extend_in_line() {
  for (bool more = true; more;) {
    more = false;
    std::size_t left_over = 0;
    for (std::size_t i = 0; i < in_line_.size(); ++i)
      if (extend(in_line_[i].manifold(), out_.size()))
        more = true;
      else
        in_line_[left_over++] = in_line_[i];
    in_line_.truncate(left_over);
  }
}

template <class T>
void Joined<T>::keep_doubtful(const Manifold<T>& manifold, double taken) {
  InLine doubtful(manifold);
  doubtful.doubt = taken;
  doubtful_.push_back(doubtful);
  for (std::size_t i = doubtful_.size() - 1; i > 0 && doubtful_[i].doubt < doubtful_[i - 1].doubt; --i)
    std::swap(doubtful_[i], doubtful_[i - 1]);
}

/// Adds doubtful contacts, but for those that equal another one within the error of their normals.
template <class T>
void Joined<T>::join_doubtful() {
  const auto off = static_cast<T>(off_), near = off * static_cast<T>(size_) + tolerated();
  for (const InLine& doubtful : doubtful_) {
    const Manifold<T> manifold = doubtful.manifold();
    const auto is_known = [&](const Manifold<T>& there) {
      if (!(length(there.normal - manifold.normal) <= off)) return false;
      return std::all_of(manifold.points.begin(), manifold.points.end(), [&](const ContactPoint<T>& p) {
        return std::any_of(there.points.begin(), there.points.end(),
                           [&](const ContactPoint<T>& q) { return length(p.a - q.a) <= near; });
      });
    };
    if (std::none_of(out_.begin() + static_cast<std::ptrdiff_t>(first_), out_.end(), is_known)) join(manifold);
  }
  doubtful_.clear();
}

/// Makes one of the manifolds that have grown up to each other.
template <class T>
void Joined<T>::unite() {
  for (std::size_t i = out_.size(); i-- > first_ + 1;)
    if (extend(out_[i], i)) out_.erase(out_.begin() + static_cast<std::ptrdiff_t>(i));
}

/// Adds a manifold to the one that it goes on from, if there is one before the place `end`.
template <class T>
bool Joined<T>::extend(const Manifold<T>& manifold, std::size_t end) {
  for (std::size_t i = first_; i < end; ++i) {
    Manifold<T>& there = out_[i];
    if (!(dot(there.normal, manifold.normal) > T(0)) || std::abs(cross(there.normal, manifold.normal)) > tolerance<T>)
      continue;
    const Vec2<T> along = left(there.normal);
    const auto at = [&](const ContactPoint<T>& p) { return dot(p.a - there.points[0].a, along); };
    const auto by_place = [&](const ContactPoint<T>& p, const ContactPoint<T>& q) { return at(p) < at(q); };
    std::array<ContactPoint<T>, 4> all;
    auto last = std::copy(there.points.begin(), there.points.end(), all.begin());
    const auto bounds_there = std::minmax_element(all.begin(), last, by_place);
    const T low = at(*bounds_there.first), high = at(*bounds_there.second), gap = seam_gap(there.points[0]);
    const auto own = std::minmax_element(manifold.points.begin(), manifold.points.end(), by_place);
    if (at(*own.first) > high + gap || at(*own.second) < low - gap) continue;
    last = std::copy(manifold.points.begin(), manifold.points.end(), last);
    const auto ends = std::minmax_element(all.begin(), last, by_place);
    ContactPoint<T> first = *ends.first, second = *ends.second;
    const std::span<const ContactPoint<T>> points(all.begin(), last);
    if (stands_out(points, first, second, at)) continue;
    for (ContactPoint<T>* bound : {&first, &second})
      for (const ContactPoint<T>& p : points)
        if (std::abs(at(p) - at(*bound)) <= gap && is_surer_name(p, *bound)) *bound = p;
    there.points.clear();
    // The first of several pieces gives its number, whichever of them was nearest.
    if (std::pair(manifold.piece_a, manifold.piece_b) < std::pair(there.piece_a, there.piece_b))
      there.piece_a = manifold.piece_a, there.piece_b = manifold.piece_b;
    there.points.push_back(first);
    if (at(second) - at(first) > tolerated()) there.points.push_back(second);
    return true;
  }
  return false;
}

/// Whether one of the points is deeper than the line between both ends, by more than a seam may be: what is in line
/// loses nothing where its ends alone are kept, and what bulges out between them is no side of one ground.
template <class T>
template <class At>
bool Joined<T>::stands_out(std::span<const ContactPoint<T>> points, const ContactPoint<T>& first,
                           const ContactPoint<T>& second, const At& at) const {
  const T width = at(second) - at(first), allowed = static_cast<T>(step_) + tolerated();
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint<T>& p) {
    const T part = width > T(0) ? (at(p) - at(first)) / width : T(0);
    return p.distance < first.distance + (second.distance - first.distance) * part - allowed;
  });
}

template class Joined<float>;
template class Joined<double>;

}  // namespace graze::plane
