// Several shapes that move as one, nested as wished.
//
// Guarantee: shared and immutable; the children keep the order in which they were given.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/pose.hpp"

namespace graze {

template <class T>
class Shape;
template <class T>
struct Placed;

template <class T>
class Compound {
 public:
  static constexpr const char* name = "compound";

  /// At least one child, each at its pose in the compound's frame. Throws `InvalidValue`.
  explicit Compound(std::vector<Placed<T>> children);

  std::span<const Placed<T>> children() const;

  T core_extent() const;
  Aabb<T> core_bounds(const Pose<T>& pose) const;

 private:
  std::shared_ptr<const std::vector<Placed<T>>> children_;
};

}  // namespace graze
