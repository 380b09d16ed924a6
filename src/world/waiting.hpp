// Pairs on their way to a kernel.
#pragma once

#include "world/pair_contacts.hpp"

namespace graze {

/// Pairs that wait for a kernel, all for the same.
template <class T, class Space>
struct Waiting {
  typename PairContacts<T, Space>::Lanes lanes;
  std::size_t count = 0;
  typename PairContacts<T, Space>::Pair pairs[most_chunk];
  std::uint32_t places[most_chunk];
};

}  // namespace graze
