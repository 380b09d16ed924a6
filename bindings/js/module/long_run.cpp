// The long run of tests/common/long_run.hpp by the package's own objects, for the test of its bits.
#include "common/long_run.hpp"

extern "C" {

__attribute__((export_name("hash_float"))) std::uint64_t hash_float() {
  return graze::testing::hash_of_a_long_run<float>();
}
__attribute__((export_name("hash_double"))) std::uint64_t hash_double() {
  return graze::testing::hash_of_a_long_run<double>();
}
__attribute__((export_name("golden_float"))) std::uint64_t golden_float() { return graze::testing::golden_bits<float>; }
__attribute__((export_name("golden_double"))) std::uint64_t golden_double() {
  return graze::testing::golden_bits<double>;
}

}  // extern "C"
