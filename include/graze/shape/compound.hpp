// Several shapes that move as one, nested as wished.
//
// Guarantee: shared and immutable, with a tree of bounds over the children, so that copies are cheap, a query visits
// only nearby children, and queries from any thread are safe. The children keep their given order.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/detail/lent.hpp"
#include "graze/pose.hpp"

namespace graze {

/// Any shape (graze/shape.hpp).
template <class T>
class Shape;
template <class T>
struct GRAZE_API Placed;

template <class T>
struct CompoundData;

/// Several shapes that move as one.
template <class T>
class GRAZE_API Compound {
 public:
  static constexpr const char* name = "compound";

  /// A compound of at least one child, each at its pose in the compound's frame. Cost n log n. Throws `InvalidValue`,
  /// also for more than 2^22 shapes nested more than 32 deep.
  explicit Compound(std::vector<Placed<T>> children);
  Compound(const Compound& lender, Lent) : data_(std::shared_ptr<void>(), lender.data_.get()) {}

  /// The children in place. What is nested in them more than 32 deep is taken apart into one compound of its shapes.
  std::span<const Placed<T>> children() const;
  /// The data that copies of the shape share.
  const CompoundData<T>& data() const { return *data_; }

  T core_extent() const;
  Aabb<T> core_bounds(const Pose<T>& pose) const;

 private:
  std::shared_ptr<const CompoundData<T>> data_;
};

}  // namespace graze
