// Relations between the triangles of a mesh: across common edges, level, or upon each other.
#pragma once

#include <span>
#include <vector>

#include "graze/shape/mesh.hpp"
#include "shape/level_sine.hpp"
#include "shape/triangles_across.hpp"

namespace graze {

/// The edges of a mesh, sorted: by which triangles, and in which direction, each is run through. Edges differ by the
/// places of their ends in the list of points. Triangles that have a corner twice are passed over. Cost n log n.
class EdgeUses {
 public:
  EdgeUses(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t points);

  /// Whether the triangles bound a solid: every edge is run through once in each direction.
  bool bound_solid() const;

  /// The triangles across the edges of each triangle. An edge that more than two use leads from each to the next, and
  /// from the last to the first.
  std::vector<TrianglesAcross> across(std::span<const std::array<std::uint32_t, 3>> triangles) const;

  /// Calls `f(i, j, paired)` for the edges between points i < j, until it returns false; `paired`: run through once in
  /// each direction, and not more. Returns whether it went to the end.
  template <class F>
  bool each(F&& f) const {
    for (std::uint32_t i = 0; i + 1 < begin_.size(); ++i)
      for (std::size_t at = begin_[i], next = at; at < begin_[i + 1]; at = next) {
        next = end_of_edge(i, at);
        const bool paired = next - at == 2 && uses_[at].upwards && !uses_[at + 1].upwards;
        if (!f(i, uses_[at].high, paired)) return false;
      }
    return true;
  }

 private:
  /// An edge as a triangle has it: its greater end, and whether it is run through from the lesser.
  struct Use {
    std::uint32_t high, triangle;
    bool upwards;
  };
  /// The place behind the last use of the edge that begins at `at`, of which point i is the lesser end.
  std::size_t end_of_edge(std::uint32_t i, std::size_t at) const {
    std::size_t next = at + 1;
    while (next < begin_[i + 1] && uses_[next].high == uses_[at].high) ++next;
    return next;
  }

  std::vector<std::uint32_t> begin_;  ///< of each point: where the edges of which it is the lesser end begin
  std::vector<Use> uses_;             ///< those of one edge side by side, upwards first
};

/// For each triangle whether it lies level with all that share a corner with it, the surface going on all around: no
/// contact on its edges and corners has a normal but the face's. Cost n.
template <class T>
std::vector<bool> level_triangles(std::span<const Vec3<T>> points,
                                  std::span<const std::array<std::uint32_t, 3>> triangles, const EdgeUses& edges);

/// The triangles, by number, that do not repeat an earlier one: the same corners in the same turn, or, without area for
/// two corners at one place, the same points. A repetition changes no answer, but thousands at one place cost the
/// square of their number. Cost n.
template <class T>
std::vector<std::uint32_t> different_triangles(std::span<const Vec3<T>> points,
                                               std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace graze
