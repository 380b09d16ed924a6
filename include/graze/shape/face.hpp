// The support face of a shape: the flat piece that lies furthest in a direction.
//
// Guarantee: at least one vertex; vertices in order around the face (counter-clockwise seen from outside, for three or
// more); as many as the shape has: the buffer keeps sixteen in place and grows on the heap beyond.
#pragma once

#include <cstdint>

#include "graze/small_vector.hpp"
#include "graze/vec3.hpp"

namespace graze {

/// A vertex (1), an edge (2) or a polygon (3 and more) of a shape's core, in the shape's frame.
template <class T>
struct Face {
  SmallVector<Vec3<T>, 16> vertices;   ///< in order, counter-clockwise seen from outside
  SmallVector<std::uint32_t, 16> ids;  ///< the shape's own number for each vertex
  std::uint32_t id = 0;                ///< the shape's own number for the face, edge or vertex

  /// Removes all vertices.
  void clear() {
    vertices.clear();
    ids.clear();
    id = 0;
  }
  /// Appends a vertex, with its number in the shape.
  void push(const Vec3<T>& v, std::size_t vertex_id) {
    vertices.push_back(v);
    ids.push_back(static_cast<std::uint32_t>(vertex_id));
  }
};

/// Largest angle, in radians, between a direction and a flat part's normal (or a straight part's normal plane) for
/// which the whole part is the support face. A solver's resting contacts tilt by a few milliradians; two degrees keep
/// their faces whole, and the true distance of each point is reported whatever the lean.
template <class T>
inline constexpr T face_lean = T(0.035);

/// Largest lean (a sine) of an incident face from the chosen normal: a face is clipped by the other shape's while it
/// leans up to 60 degrees, and beyond that an edge is taken instead. No direction leans as far from all three faces of
/// a box's corner.
template <class T>
inline constexpr T side_lean = T(0.866);

}  // namespace graze
