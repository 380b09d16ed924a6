// The outline of the Minkowski difference of two polygons, gone along from any of its edges.
//
// Guarantee: the edges that `for_each_difference_edge` visits, each at the same vertex of the other polygon, so that
// what is computed from them has the same bits.
#pragma once

#include "plane/difference.hpp"

namespace graze::plane {

/// The order of two directions less than half a turn apart, counter-clockwise.
enum class Order { before, same, after, unknown };
inline Order order(const Vec2d& first, const Vec2d& second) {
  const double turn = cross(first, second);
  if (turn != 0) return turn > 0 ? Order::before : Order::after;
  return dot(first, second) > 0 ? Order::same : Order::unknown;
}

/// The outline of the Minkowski difference, gone along step by step: edges of A come before edges of B of the same
/// direction, in the order of `for_each_difference_edge`.
template <class T>
class DifferenceOutline {
 public:
  DifferenceOutline(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a)
      : a_(a), b_(b), b_in_a_(b_in_a), more_(a.count + b.count) {}

  /// Whether rounding has left an order so far.
  bool known() const { return known_; }

  /// The edge of A numbered `i`, swept by the vertex of B below it: `j`, or one beside it.
  DifferenceEdge edge_of_a(std::uint32_t i, std::uint32_t j) {
    if (b_.count > 1) {
      const Vec2d e = a_.edge(i);
      while (comes_first(e, edge_b(b_.previous(j))) && step()) j = b_.previous(j);
      while (order(e, edge_b(j)) == Order::after && step()) j = b_.next(j);
    }
    return made(true, i, j);
  }
  /// The edge of B numbered `j`, swept by the vertex of A below it: `i`, or one beside it.
  DifferenceEdge edge_of_b(std::uint32_t i, std::uint32_t j) {
    if (a_.count > 1) {
      const Vec2d e = edge_b(j);
      while (order(a_.edge(a_.previous(i)), e) == Order::after && step()) i = a_.previous(i);
      while (comes_first(a_.edge(i), e) && step()) i = a_.next(i);
    }
    return made(false, i, j);
  }
  DifferenceEdge after(const DifferenceEdge& e) {
    step();
    const std::uint32_t i = e.of_a ? a_.next(e.i) : e.i, j = e.of_a ? e.j : b_.next(e.j);
    return made(a_first(i, j), i, j);
  }
  DifferenceEdge before(const DifferenceEdge& e) {
    step();
    const std::uint32_t i = a_.previous(e.i), j = b_.previous(e.j);
    return b_.count > 1 && (a_.count < 2 || a_first(i, j)) ? made(false, e.i, j) : made(true, i, e.j);
  }

 private:
  Vec2d edge_b(std::uint32_t j) const { return rotate(b_in_a_.rotation, -b_.edge(j)); }
  /// Whether A's edge i comes before B's edge j. Where one polygon has no edges, those of the other come first.
  bool a_first(std::uint32_t i, std::uint32_t j) {
    if (a_.count < 2 || b_.count < 2) return b_.count < 2;
    const Order o = order(a_.edge(i), edge_b(j));
    known_ = known_ && o != Order::unknown;
    return o != Order::after;
  }
  /// Whether an edge of A comes before one of B.
  static bool comes_first(const Vec2d& of_a, const Vec2d& of_b) {
    const Order o = order(of_a, of_b);
    return o == Order::before || o == Order::same;
  }
  /// Goes on by one edge, unless it has been all around.
  bool step() {
    known_ = known_ && more_ > 0;
    if (known_) --more_;
    return known_;
  }
  DifferenceEdge made(bool of_a, std::uint32_t i, std::uint32_t j) const {
    const Vec2d start = a_.vertex(i) - transform(b_in_a_, b_.vertex(j));
    return {of_a, i, j, start, of_a ? a_.edge(i) : edge_b(j)};
  }

  const Core<T>&a_, &b_;
  const Pose2d& b_in_a_;
  std::uint32_t more_;  ///< steps that are left
  bool known_ = true;
};

/// Whether the walk comes to an edge earlier than to another one.
inline bool earlier(const DifferenceEdge& e, const DifferenceEdge& than) {
  return e.of_a ? detail::not_after(e.edge, than.edge) : !detail::not_after(than.edge, e.edge);
}

}  // namespace graze::plane
