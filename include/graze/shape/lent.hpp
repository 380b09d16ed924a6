// Shapes that share their data, lent for a moment.
//
// Guarantee: a shape made with `Lent` answers as the one that lends; it must not outlive that one. Copying and dropping
// it counts nothing, where a share in the data costs two atomic operations, which many threads that use one shape would
// have to wait for.
#pragma once

#include <type_traits>

#include "graze/standard.hpp"

namespace graze {

/// Marks the constructors that lend.
struct Lent {};

/// The shape for a moment: lent, if it shares data, else a copy.
template <class C>
C lent(const C& concrete) {
  if constexpr (std::is_constructible_v<C, const C&, Lent>)
    return C(concrete, Lent());
  else
    return concrete;
}

}  // namespace graze
