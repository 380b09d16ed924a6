// Whether this machine gives the golden bits. Without a test library, so that it is built with nothing but a compiler
// for any processor, and runs in its emulator.
#include <cinttypes>
#include <cstdio>

#include "common/long_run.hpp"
#include "common/moving_run.hpp"
#include "common/plane_run.hpp"
#include "common/single_run.hpp"

namespace {

bool golden(const char* name, std::uint64_t found, std::uint64_t expected) {
  const bool same = found == expected;
  std::printf("%s: %" PRIu64 "%s\n", name, found, same ? "" : ", which is not the golden number");
  return same;
}

template <class T>
bool golden(const char* scalar, const char* one_by_one, const char* moving, const char* in_the_plane) {
  using namespace graze::testing;
  const bool space = golden(scalar, hash_of_a_long_run<T>(), golden_bits<T>);
  const bool single = golden(one_by_one, hash_of_a_single_run<T>(), golden_single_bits<T>);
  const bool moves = golden(moving, hash_of_a_moving_run<T>(), golden_moving_bits<T>);
  const bool plane = golden(in_the_plane, hash_of_a_plane_run<T>(), golden_plane_bits<T>);
  return space && single && moves && plane;
}

}  // namespace

int main() {
  const bool in_float = golden<float>("float", "float, one by one", "float, moving", "float, the plane"),
             in_double = golden<double>("double", "double, one by one", "double, moving", "double, the plane");
  return in_float && in_double ? 0 : 1;
}
