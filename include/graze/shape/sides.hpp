// One-sided and two-sided surfaces.
#pragma once

#include <cstdint>

#include "graze/detail/standard.hpp"

namespace graze {

/// The sides of a surface without thickness that push. With `front`, `contacts` leaves out contacts that would push a
/// body out through the back of a triangle, the side from which its corners run clockwise. A body comes through from
/// behind as through a one-way door, and one whose middle has passed the surface is not pushed back, as is usual in
/// physics engines; edges push to either side. A closed mesh whose fronts lead out of it pushes outward alone also with
/// `both`, unless the other shape may lie within it. Distance, overlap and the nearest point are geometry and
/// independent of sides.
enum class Sides : std::uint8_t { both, front };

}  // namespace graze
