// Box against box, the contacts of a single pair.
//
// Guarantee: the bits that the kernels give for the pair among many.
#pragma once

#include <optional>

#include "narrow/batch/box_batch.hpp"
#include "narrow/core/relative_frame.hpp"

namespace graze {

/// The points of two boxes, as the kernels find them for many pairs; nothing where one is rounded or not regular, or
/// their faces do not tell. As the separating axes of polyhedra give them, in T, but also where hardly more than the
/// distance is between the faces.
template <class T>
std::optional<T> own_contacts(const Box<T>& a, T margin_a, const Pose<T>& pose_a, const Box<T>& b, T margin_b,
                              const Pose<T>& pose_b, T margin, Manifold<T>& manifold) {
  if (margin_a != T(0) || margin_b != T(0)) return std::nullopt;
  BoxReferenceAxis<T> choice;
  ContactSlots<T> found;
  if (!GRAZE_KERNEL(chosen_isa(), box_contact<T>)({&a, &b, &pose_a, &pose_b, margin}, choice, found))
    return choice.distance;
  if (found.known == T(0)) return std::nullopt;
  take_points<T>(
      static_cast<unsigned>(found.filled), [&](std::size_t i) { return found.slot(i); }, box_features.of,
      box_features.of, manifold.points);
  manifold.normal = found.normal;
  return choice.distance;
}

}  // namespace graze
