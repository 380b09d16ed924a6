// Answers of kernels for a block of pairs, turned from columns of doubles into rows.
//
// Guarantee: the answers of `pair_answers.hpp`, bit for bit.
#pragma once

#include <type_traits>

#include "graze/plane/query.hpp"
#include "plane/pairs/pair_kernels.hpp"

namespace graze {

namespace plane {

/// A manifold with room for both points, whether there are any or not.
template <class T>
struct ContactRow {
  Vec2<T> normal;
  ContactPoint<T> points[2];
};

/// Kernels that write `count` rows, up to the next full register; `turned`: A and B stand the other way round.
template <class T>
struct StoreKernels {
  void (*distances)(const DistanceColumns<block_pairs>& found, std::size_t count, bool turned, Distance<T>* rows);
  void (*contacts)(const ContactColumns<block_pairs>& found, std::size_t count, bool turned, ContactRow<T>* rows);
};

/// The kernels for both scalars.
struct AllStoreKernels {
  StoreKernels<float> of_float;
  StoreKernels<double> of_double;

  template <class T>
  const StoreKernels<T>& of() const {
    if constexpr (std::is_same_v<T, float>)
      return of_float;
    else
      return of_double;
  }
};

}  // namespace plane

GRAZE_DECLARE_KERNEL(const plane::AllStoreKernels& plane_store_kernels();)

}  // namespace graze
