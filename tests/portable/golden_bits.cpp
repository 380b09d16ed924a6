// Whether this machine gives the golden bits. Without a test library, so that it is built with nothing but a compiler
// for any processor, and runs in its emulator.
#include <cinttypes>
#include <cstdio>

#include "common/long_run.hpp"

namespace {

template <class T>
bool golden(const char* scalar) {
  using namespace graze::testing;
  const std::uint64_t found = hash_of_a_long_run<T>();
  const bool same = found == golden_bits<T>;
  std::printf("%s: %" PRIu64 "%s\n", scalar, found, same ? "" : ", which is not the golden number");
  return same;
}

}  // namespace

int main() {
  const bool in_float = golden<float>("float"), in_double = golden<double>("double");
  return in_float && in_double ? 0 : 1;
}
