// Lent shapes: short-lived copies that borrow the data which shapes of their kind share.
//
// Guarantee: a shape made with `Lent` answers as its lender; it must not outlive the lender. Copying and dropping it
// counts no references, where a share in the data costs two atomic operations, which many threads that use one shape
// would have to wait for.
#pragma once

#include <type_traits>

#include "graze/detail/standard.hpp"

namespace graze {

/// Tag of the constructors that lend.
struct Lent {};

/// A short-lived copy of the shape: lent, if the shape shares data, else an ordinary one.
template <class C>
C lent(const C& concrete) {
  if constexpr (std::is_constructible_v<C, const C&, Lent>)
    return C(concrete, Lent());
  else
    return concrete;
}

}  // namespace graze
