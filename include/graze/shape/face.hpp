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

  /// Forgets all vertices.
  void clear() {
    vertices.clear();
    ids.clear();
    id = 0;
  }
  /// One more vertex, with the id that it has in its shape.
  void push(const Vec3<T>& v, std::size_t vertex_id) {
    vertices.push_back(v);
    ids.push_back(static_cast<std::uint32_t>(vertex_id));
  }
};

/// How far, in radians, a direction may lean from a flat part's normal (or from the normal plane of a straight part)
/// and still have the whole part as its support face. A solver's resting contacts tilt by a few milliradians; two
/// degrees keep their faces whole, and the true distance of each point is reported whatever the lean.
template <class T>
inline constexpr T face_lean = T(0.035);

/// The same for what flat sides meet once a normal is chosen: a side is laid over the other shape's while it leans up
/// to 60 degrees (this is the sine), and is seen from the edge beyond. No corner of a box leans as far from all three
/// of its faces.
template <class T>
inline constexpr T side_lean = T(0.866);

}  // namespace graze
