// Any bytes as calls of any functions of the C interface, in either scalar: the table of functions comes from the
// header, the arguments from their types and names. Where c_fuzz.cpp knows what a call means, this one forgets no
// function.
//
// Checked are the header's promises to all: nothing but a status comes back, a refusal leaves a message and changes
// none of the variables that pointers point to.
#include "calls/calls.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Bytes in(bytes, size);
  if (in.byte() % 2 == 0)
    any_calls_of_double(in);
  else
    any_calls_of_float(in);
  return 0;
}
