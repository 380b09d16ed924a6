// The runs of tests/common by the package's own objects, for the test of their bits.
#include "common/long_run.hpp"
#include "common/moving_run.hpp"
#include "common/plane_run.hpp"
#include "common/single_run.hpp"

namespace {

using namespace graze::testing;

template <class T>
std::uint64_t hash_of(int run) {
  switch (run) {
  case 0: return hash_of_a_long_run<T>();
  case 1: return hash_of_a_single_run<T>();
  case 2: return hash_of_a_moving_run<T>();
  default: return hash_of_a_plane_run<T>();
  }
}

template <class T>
std::uint64_t golden_of(int run) {
  return std::array{golden_bits<T>, golden_single_bits<T>, golden_moving_bits<T>,
                    golden_plane_bits<T>}[std::size_t(run)];
}

}  // namespace

extern "C" {

/// The hash of a run, 0 to 3, in double or in float.
__attribute__((export_name("hash"))) std::uint64_t hash(int run, int in_double) {
  return in_double ? hash_of<double>(run) : hash_of<float>(run);
}
/// Its hash on every other processor.
__attribute__((export_name("golden"))) std::uint64_t golden(int run, int in_double) {
  return in_double ? golden_of<double>(run) : golden_of<float>(run);
}

}  // extern "C"
