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
struct GRAZE_API Placed;

template <class T>
struct CompoundData;

/// Several shapes that move as one.
template <class T>
class GRAZE_API Compound {
 public:
  static constexpr const char* name = "compound";

  /// A compound of at least one child, each at its pose in the compound's frame. Throws `InvalidValue`, also for more
  /// than 2^22 shapes nested more than 32 deep.
  explicit Compound(std::vector<Placed<T>> children);

  /// The children in place. What is nested in them more than 32 deep is taken apart into one compound of its shapes.
  std::span<const Placed<T>> children() const;
  /// The data that copies of the shape share.
  const CompoundData<T>& data() const { return *data_; }
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const CompoundData<T>> data_;
  T extent_{};
};

extern template class Compound<float>;
extern template class Compound<double>;

}  // namespace graze::plane
