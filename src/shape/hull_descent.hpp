// The descent of a hull's hierarchy to its furthest vertex, a template over an observer of what is looked at.
//
// Guarantee: `UnobservedDescent`, which every answer is found with, is empty and costs nothing. No observer changes the
// way.
#pragma once

#include "graze/shape/convex_hull.hpp"

namespace graze {

struct UnobservedDescent {
  /// A layer of so many vertices begins.
  void layer(std::size_t /*vertices*/) const {}
  /// A vertex of the hull lies so far along the direction.
  template <class S>
  void look(std::uint32_t /*vertex*/, S /*along*/) const {}
};

/// Climbs from `start` to a vertex with no better neighbour: on a convex polyhedron the best of all.
template <class T, class S, class Vertex, class Around, class Observer>
std::uint32_t climbed(const HullData<T>& hull, const Vec3<S>& direction, std::uint32_t start, const Vertex& vertex,
                      const Around& around, const Observer& observer) {
  std::uint32_t best = start;
  S most = dot(converted<S>(hull.vertices[vertex(best)]), direction);
  observer.look(vertex(best), most);
  for (bool better = true; better;) {
    better = false;
    for (const std::uint32_t n : around(best)) {
      const S along = dot(converted<S>(hull.vertices[vertex(n)]), direction);
      observer.look(vertex(n), along);
      if (along > most) {
        most = along;
        best = n;
        better = true;
        break;
      }
    }
  }
  return best;
}

/// The furthest vertex of a hull with a hierarchy, climbed to on each level from where the coarser one has it.
template <class T, class S, class Observer = UnobservedDescent>
std::uint32_t descended(const HullData<T>& hull, const Vec3<S>& direction, const Observer& observer = {}) {
  std::uint32_t at = 0;
  for (const auto& level : hull.hierarchy) {
    observer.layer(level.vertices.size());
    const auto around = [&](std::uint32_t i) {
      return std::span(level.neighbors)
          .subspan(level.neighbor_begin[i], level.neighbor_begin[i + 1] - level.neighbor_begin[i]);
    };
    at = climbed(
        hull, direction, at, [&](std::uint32_t i) { return level.vertices[i]; }, around, observer);
    at = level.finer[at];
  }
  observer.layer(hull.vertices.size());
  return climbed(
      hull, direction, at, [](std::uint32_t i) { return i; }, [&](std::uint32_t i) { return hull.around(i); },
      observer);
}

}  // namespace graze
