// Sphere against box: the nearest point of the box to the centre.
#pragma once

#include "narrow/pairs/one_contact_pair.hpp"

namespace graze {

struct SphereBox : OneContactPair<Sphere, Box> {};

}  // namespace graze
