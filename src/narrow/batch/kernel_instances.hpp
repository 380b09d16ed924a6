// The instances of a kernel for the pairs of the list, which the kernel's file takes from there. Only for
// `*.kernel.cpp`.
//
// Guarantee: derived from the list of pairs and from nothing else. A table of addresses is all that is compiled.
#pragma once

#include "narrow/pair_list.hpp"

namespace graze::GRAZE_ISA {

/// A kernel's address for each pair of the list, null for pairs without it: taking the address instantiates the kernel.
template <class Kernel>
struct KernelInstances {
  Kernel* of[PairList::count]{};

  /// `address<P>()`: the kernel for the pair P, or `nullptr`.
  template <class Address>
  explicit consteval KernelInstances(const Address& address) {
    std::size_t place = 0;
    PairList::each([&]<class P>() { of[place++] = address.template operator()<P>(); });
  }
};

/// Pairs whose struct says that a family of kernels has them; `pairs/pair.hpp` has the members.
template <class P>
concept HasClosedFormRows = requires {
  requires P::closed_form_rows;
};
template <class P>
concept HasOneContactKernels = requires {
  requires P::one_contact_kernels;
};
template <class P>
concept HasHalfSpaceKernels = requires {
  requires P::half_space_kernels;
};

}  // namespace graze::GRAZE_ISA
