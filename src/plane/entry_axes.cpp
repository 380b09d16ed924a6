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
    axes_kernels().entries_of_float(of_a, of_b, b_in_a, direction, slack, out);
  else
    axes_kernels().entries_of_double(of_a, of_b, b_in_a, direction, slack, out);
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

}  // namespace

template <class T>
bool entry_by_axes(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, const Vec2d& direction, double size,
                   DifferenceEntry& out) {
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
  for (const DifferenceEdge& e : few)
    if (meet_edge(e.start, e.edge, 0, direction, out.hit)) out.edge = e;
  return out.hit.t != never;
}

template bool entry_by_axes(const Core<float>&, const Core<float>&, const Pose2d&, const Vec2d&, double,
                            DifferenceEntry&);
template bool entry_by_axes(const Core<double>&, const Core<double>&, const Pose2d&, const Vec2d&, double,
                            DifferenceEntry&);

}  // namespace graze::plane
