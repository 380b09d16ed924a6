// The Minkowski difference A - B of two polygons: the origin lies in it where they overlap.
//
// Guarantee: visits its edges in order of their angle, counter-clockwise, in n + m steps and without memory: the edges
// of A and those of -B merged (de Berg and others, "Computational geometry", section 13.3). Points, segments and
// vertices upon each other are polygons too.
#pragma once

#include "plane/core.hpp"

namespace graze::plane {

/// One edge of the difference: edge `i` of A swept by vertex `j` of B, or edge `j` of B by vertex `i` of A.
struct DifferenceEdge {
  bool of_a;
  std::uint32_t i, j;
  Vec2d start;  ///< a_i - b_j
  Vec2d edge;   ///< to the next vertex of the difference
};

namespace detail {

/// Whether the direction's angle is in [pi, 2 pi).
inline bool lower_half(const Vec2d& d) { return d.y < 0 || (d.y == 0 && d.x < 0); }

/// Whether the angle of `a` in [0, 2 pi) is no larger than that of `b`.
inline bool not_after(const Vec2d& a, const Vec2d& b) {
  const bool a_lower = lower_half(a), b_lower = lower_half(b);
  return a_lower != b_lower ? b_lower : cross(a, b) >= 0;
}

inline bool is_zero(const Vec2d& v) { return v.x == 0 && v.y == 0; }

/// The edge of a polygon with which its angles begin: the first that points up after one that points down.
template <class EdgeOf>
std::uint32_t first_edge(std::uint32_t count, const EdgeOf& edge_of) {
  bool was_lower = false;
  for (std::uint32_t i = count; i-- > 0;)
    if (const Vec2d e = edge_of(i); !is_zero(e)) {
      was_lower = lower_half(e);
      break;
    }
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2d e = edge_of(i);
    if (is_zero(e)) continue;
    if (was_lower && !lower_half(e)) return i;
    was_lower = lower_half(e);
  }
  return 0;
}

}  // namespace detail

/// Calls `f` with every edge of A - B, B seen from A by `b_in_a`. The difference of two points has none.
template <class T, class F>
void for_each_difference_edge(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, F&& f) {
  const auto edge_of_a = [&](std::uint32_t i) { return a.edge(i); };
  const auto edge_of_b = [&](std::uint32_t j) { return rotate(b_in_a.rotation, -b.edge(j)); };
  std::uint32_t left_a = a.count < 2 ? 0 : a.count, left_b = b.count < 2 ? 0 : b.count;
  std::uint32_t i = left_a ? detail::first_edge(left_a, edge_of_a) : 0;
  std::uint32_t j = left_b ? detail::first_edge(left_b, edge_of_b) : 0;
  Vec2d vertex_a = a.vertex(i), vertex_b = transform(b_in_a, b.vertex(j));
  Vec2d edge_a = left_a ? edge_of_a(i) : Vec2d{}, edge_b = left_b ? edge_of_b(j) : Vec2d{};
  while (left_a + left_b > 0) {
    // Edges of no length have no angle and are gone through where they stand.
    const bool take_a = left_a > 0 && (left_b == 0 || detail::is_zero(edge_a) ||
                                       (!detail::is_zero(edge_b) && detail::not_after(edge_a, edge_b)));
    f(DifferenceEdge{take_a, i, j, vertex_a - vertex_b, take_a ? edge_a : edge_b});
    if (take_a) {
      --left_a;
      i = a.next(i);
      vertex_a = a.vertex(i);
      edge_a = edge_of_a(i);
    } else {
      --left_b;
      j = b.next(j);
      vertex_b = transform(b_in_a, b.vertex(j));
      edge_b = edge_of_b(j);
    }
  }
}

}  // namespace graze::plane
