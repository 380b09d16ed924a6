// The bits that single questions have to give on every processor, at whatever level of the instruction set.
#include <gtest/gtest.h>

#include "common/single_run.hpp"

namespace graze::testing {
namespace {

TEST(SingleQuestions, GiveTheGoldenBits) {
  EXPECT_EQ(hash_of_a_single_run<float>(), golden_single_bits<float>);
  EXPECT_EQ(hash_of_a_single_run<double>(), golden_single_bits<double>);
}

}  // namespace
}  // namespace graze::testing
