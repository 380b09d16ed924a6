// Any calls in double.
#include "calls/calls.hpp"
#include "calls/zones.hpp"

#define TYPE(name) Graze##name##d
#define NAME(name) graze_##name##_d
#define OTHER_SHAPE GrazeShapef
#define NAME_OF_OTHER(name) graze_##name##_f
#define SCALAR double
#define ANY_CALLS any_calls_of_double

#include "calls/handles.inc"
#include "calls/values.inc"

#include "calls/arguments.inc"
