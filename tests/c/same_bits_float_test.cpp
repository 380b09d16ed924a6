// The C interface gives the bits of the C++ one, in float.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <thread>

#include "common/specimen.hpp"
#include "graze/graze.h"
#include "graze/graze.hpp"

#define GRAZE_TEST_SCALAR float
#define TYPE(name) Graze##name##f
#define NAME(name) graze_##name##_f

#include "c/same_bits.inc"

#include "c/same_bits_broad.inc"

#include "c/same_bits_plane_worlds.inc"

#include "c/same_bits_plane_simulations.inc"

#include "c/same_bits_motion.inc"

#include "c/same_bits_shapes.inc"

#include "c/same_bits_changes.inc"
