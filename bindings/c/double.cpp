// The C interface for double. Its text is written once, with names in place of types: see the files that are included.
#include "bounded_convex.hpp"
#include "broad_phase_kinds.hpp"
#include "c/callbacks.hpp"
#include "c/capture.hpp"
#include "c/draw.hpp"
#include "c/gathered.hpp"
#include "c/trace.hpp"
#include "c/world_changes.hpp"
#include "graze/graze.hpp"
#include "state_number.hpp"

#define GRAZE_C_SCALAR double
#define GRAZE_C_TAG 0x67720d00u
#define TYPE(name) Graze##name##d
#define NAME(name) graze_##name##_d

#include "c/handles.inc"
#include "c/shapes.inc"

#include "c/queries.inc"

#include "c/measures.inc"

#include "c/hulls.inc"

#include "c/broad.inc"

#include "c/impulse.inc"

#include "c/batches.inc"

#include "c/worlds.inc"

#include "c/joints.inc"

#include "c/space_simulations.inc"

#include "c/plane.inc"

#include "c/plane_measures.inc"

#include "c/motion.inc"

#include "c/plane_worlds.inc"

#include "c/plane_simulations.inc"

#include "c/draw.inc"

#include "c/capture.inc"
