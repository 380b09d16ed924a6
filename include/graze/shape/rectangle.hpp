// The thin rectangle in the XZ plane, normal +Y.
//
// Guarantee: exactly a box of zero thickness, with a box's numbers for its parts.
#pragma once

#include "graze/shape/box.hpp"

namespace graze {

/// A flat rectangle in the XZ plane.
template <class T>
class Rectangle {
 public:
  static constexpr const char* name = "rectangle";

  /// A rectangle with full edge lengths along X and Z, each >= 0. Throws `InvalidValue`.
  Rectangle(T size_x, T size_z) : box_({validate::size(size_x, "sizeX"), T(0), validate::size(size_z, "sizeZ")}) {}

  /// The rectangle as a box of zero thickness.
  const Box<T>& as_box() const { return box_; }

  T core_radius() const { return T(0); }
  T core_extent() const { return box_.core_extent(); }
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    return box_.core_support(direction);
  }
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    box_.core_face(direction, face, lean);
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const { return box_.core_bounds(pose); }

 private:
  Box<T> box_;
};

}  // namespace graze
