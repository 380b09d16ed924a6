#include "plane/entry_axes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "plane/axes_kernels.hpp"
#include "plane/difference_outline.hpp"

namespace graze::plane {

namespace {

template <class T>
bool find_entries(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction, double size,
                  EdgeEntries& out) {
  const double slack = axes_slack(b_in_a, size);
  if (!axes_take(a, b, slack, size)) return false;
  const AxesPolygon<T> of_a = axes_polygon(a), of_b = axes_polygon(b);
  if constexpr (std::is_same_v<T, float>)
    axes_kernels().entries_of_float(of_a, of_b, b_in_a, a.radius + b.radius, direction, slack, out);
  else
    axes_kernels().entries_of_double(of_a, of_b, b_in_a, a.radius + b.radius, direction, slack, out);
  return out.regular;
}

/// A few edges in the order of the walk.
class FewEdges {
 public:
  /// Inserts an edge and returns whether there was room.
  bool insert(const DifferenceEdge& e) {
    if (size_ == edges_.size()) return false;
    std::size_t k = size_++;
    for (; k > 0 && earlier(e, edges_[k - 1]); --k) edges_[k] = edges_[k - 1];
    edges_[k] = e;
    return true;
  }
  const DifferenceEdge* begin() const { return edges_.data(); }
  const DifferenceEdge* end() const { return edges_.data() + size_; }

 private:
  std::array<DifferenceEdge, 4> edges_;
  std::size_t size_ = 0;
};

/// The least distance of a hit from the end of its moved edge or arc, relative to the numbers of its place. So far from
/// it the outline's next part lies behind, by half of the square of this: far more than the rounding of a time, which
/// cannot make it the first. Edges of an arc's vertex are longer than that, or the next vertex would be as near.
constexpr double end_margin = 0x1p-20;

/// The first hit on the outline rounded by `radius`, if the line of the moved edge `e` is the last that the ray enters:
/// on that edge, or on the disc about the end beyond which it passes. Returns false where that is not sure.
template <class T>
bool enter_rounded(DifferenceOutline<T>& outline, const DifferenceEdge& e, double radius, const Vec2d& direction,
                   DifferenceHit& out) {
  const double l = length(e.edge);
  const Vec2d along = e.edge / l, n = right(along);
  const double t = (-dot(n, e.start) - radius) / -dot(n, direction), at = dot(direction * t - e.start, along);
  const double margin = end_margin * (std::abs(t) + length(e.start) + l + radius);
  if (at > margin && at < l - margin) {
    out.edge = e;
    return meet_edge(e.start, e.edge, radius, direction, out.on_edge);
  }
  const bool before = at < -margin;
  if (!before && !(at > l + margin)) return false;
  const DifferenceEdge next = before ? e : outline.after(e), previous = before ? outline.before(e) : e;
  OutlineHit on_disc;
  if (!outline.known() || !meet_disc(next.start, radius, direction, on_disc)) return false;
  // Between the normals of the two edges the disc is the outline.
  const Vec2d from_vertex = on_disc.normal * radius;
  const double before_it = length(previous.edge), after_it = length(next.edge);
  if (!(before_it > margin && after_it > margin && dot(from_vertex, previous.edge) > margin * before_it &&
        dot(from_vertex, next.edge) < -margin * after_it))
    return false;
  out.on_disc = on_disc;
  out.vertex_a = next.i;
  return true;
}

}  // namespace

template <class T>
bool entry_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction, double size,
                   DifferenceHit& out) {
  EdgeEntries entries;
  if (!find_entries(a, b, b_in_a, direction, size, entries)) return false;
  if (entries.missed) return true;
  DifferenceOutline<T> outline(a, b, b_in_a);
  FewEdges few;
  for (std::uint32_t edges = entries.edges_a; edges != 0; edges &= edges - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(edges));
    if (!few.insert(outline.edge_of_a(i, static_cast<std::uint32_t>(entries.deepest_b[i])))) return false;
  }
  for (std::uint32_t edges = entries.edges_b; edges != 0; edges &= edges - 1) {
    const auto j = static_cast<std::uint32_t>(std::countr_zero(edges));
    if (!few.insert(outline.edge_of_b(static_cast<std::uint32_t>(entries.deepest_a[j]), j))) return false;
  }
  if (!outline.known()) return false;
  const double radius = a.radius + b.radius;
  if (radius > 0)
    return std::any_of(few.begin(), few.end(),
                       [&](const DifferenceEdge& e) { return enter_rounded(outline, e, radius, direction, out); });
  for (const DifferenceEdge& e : few)
    if (meet_edge(e.start, e.edge, 0, direction, out.on_edge)) out.edge = e;
  return out.on_edge.t != never;
}

template bool entry_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, const Vec2d&, double,
                            DifferenceHit&);
template bool entry_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, const Vec2d&, double,
                            DifferenceHit&);

}  // namespace graze::plane
