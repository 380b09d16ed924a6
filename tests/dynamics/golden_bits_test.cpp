// The bits that every processor has to give. CMake runs these at every level of the instruction set (lanes.dynamics_*).
#include <gtest/gtest.h>

#include "common/moving_run.hpp"

namespace graze::testing {
namespace {

TEST(SimulationBits, AreTheGoldenOnes) {
  EXPECT_EQ(hash_of_a_moving_run<float>(), golden_moving_bits<float>);
  EXPECT_EQ(hash_of_a_moving_run<double>(), golden_moving_bits<double>);
}

}  // namespace
}  // namespace graze::testing
