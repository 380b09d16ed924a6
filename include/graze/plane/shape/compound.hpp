// Several shapes of the plane that move as one, nested as wished.
//
// Guarantee: shared and immutable, so that copies are cheap and queries from any thread are safe. The children keep
// their given order.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "graze/plane/pose2.hpp"

namespace graze::plane {

template <class T>
struct Placed;

/// Several shapes that move as one.
template <class T>
class GRAZE_API Compound {
 public:
  static constexpr const char* name = "compound";

  /// A compound of at least one child, each at its pose in the compound's frame. Throws `InvalidValue`.
  explicit Compound(std::vector<Placed<T>> children);

  std::span<const Placed<T>> children() const;  ///< the children in place
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const std::vector<Placed<T>>> children_;
  T extent_{};
};

extern template class Compound<float>;
extern template class Compound<double>;

}  // namespace graze::plane
