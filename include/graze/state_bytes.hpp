// Saved states as bytes: for a game that is saved to a file, and for a state that is sent to another computer.
//
// Guarantee: a state that was read back restores to the same bits as the one that was written, on every processor, and
// equal states have equal bytes: the report's times by the clock are left out. Whatever bytes are read, memory stays in
// proportion to them, and what comes out is a state whose bodies have finite motions, or an `InvalidValue` that says
// what is wrong with them; `Simulation::restore` then refuses the state of other bodies as it refuses any. The format
// has a version, 3; bytes of version 2, whose simulations are all warm started, are read as well, those of any other
// are refused.
#pragma once

#include <string>
#include <string_view>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze {

/// The bytes of a state: in double precision 631 for a body of space and 24 for a point of contact, 391 and 16 in the
/// plane, besides the materials of pieces. Throws `InvalidValue` for an empty state.
template <class T, class Space>
GRAZE_API std::string state_bytes(const State<T, Space>& state);

/// The state that `state_bytes` wrote. Throws `InvalidValue` for other bytes: of another version, of another precision
/// or dimension, changed, cut, or longer.
template <class T, class Space = graze::Space<T>>
GRAZE_API State<T, Space> read_state(std::string_view bytes);

}  // namespace graze
