// Bodies wholly inside a solid mesh: there the surfaces are apart, and the bodies overlap all the same.
//
// Guarantee: the side is the one that `closest` tells. The depth is the length of a translation that was seen to lead
// out, or that leads beyond the bounds of the mesh: never less than the true depth, but for rounding.
#pragma once

#include <optional>

#include "composite/leaf_pairs.hpp"
#include "graze/result.hpp"

namespace graze {

/// Whether a shape is a solid mesh or has one among its children.
template <class T>
bool has_solid_mesh(const Shape<T>& shape) {
  if (const auto* mesh = shape.template as<Mesh<T>>()) return mesh->solid();
  const auto* compound = shape.template as<Compound<T>>();
  return compound && compound->data().solid;
}

/// A child of A or B that lies wholly inside one of the other, and the way out.
template <class T>
struct Enclosed {
  Distance<T> distance;
  std::uint32_t piece_a = 0, piece_b = 0;
};

/// Whether any child of one lies inside a solid mesh of the other. To be asked where no pair of pieces overlaps.
template <class T>
bool any_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// The deepest of the children that lie wholly inside, without touching the surface.
template <class T>
std::optional<Enclosed<T>> deepest_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                            const Pose<T>& pose_b);

/// Whether a point (in double, of the mesh's frame) lies inside: the side that `closest` tells.
template <class T>
bool encloses(const MeshData<T>& mesh, const Vec3d& point);

}  // namespace graze
