// Calls of any functions of the C interface, in one scalar.
#pragma once

#include "c/bytes.hpp"

/// Makes up to sixty calls with handles of their own.
void any_calls_of_double(Bytes& in);
void any_calls_of_float(Bytes& in);
