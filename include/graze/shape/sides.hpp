// Which sides of a surface without thickness push.
#pragma once

#include <cstdint>

#include "graze/standard.hpp"

namespace graze {

/// `front`: `contacts` leaves out what would push a body out through the back of a triangle, the side from which its
/// corners run clockwise. A body comes through from behind as through a one-way door, and one whose middle has passed
/// the surface is not pushed back, as in the engines of the field; edges push to either side. A closed mesh whose
/// fronts lead out of it pushes outward alone also with `both`, unless the other shape may lie within it. Distance,
/// overlap and the nearest point are geometry and know no sides.
enum class Sides : std::uint8_t { both, front };

}  // namespace graze
