// The bits that every processor has to give. CMake runs these at every level of the instruction set (lanes.plane_*).
#include <gtest/gtest.h>

#include "common/plane_run.hpp"

namespace graze::testing {
namespace {

TEST(PlaneBatches, GiveTheGoldenBits) {
  EXPECT_EQ(hash_of_a_plane_run<float>(), golden_plane_bits<float>);
  EXPECT_EQ(hash_of_a_plane_run<double>(), golden_plane_bits<double>);
}

}  // namespace
}  // namespace graze::testing
