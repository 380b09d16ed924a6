// Any calls in float.
#include "calls/calls.hpp"
#include "calls/zones.hpp"

#define TYPE(name) Graze##name##f
#define NAME(name) graze_##name##_f
#define OTHER_SHAPE GrazeShaped
#define NAME_OF_OTHER(name) graze_##name##_d
#define SCALAR float
#define ANY_CALLS any_calls_of_float

#include "calls/handles.inc"
#include "calls/values.inc"

#include "calls/arguments.inc"
