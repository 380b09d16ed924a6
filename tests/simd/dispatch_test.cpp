// The choice of the instruction set.
#include "simd/dispatch.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

TEST(Dispatch, TakesTheNamedLevelOrElseTheBest) {
  const Isa best = isa_by_name(nullptr);
  EXPECT_TRUE(isa_available(best));
  EXPECT_EQ(isa_by_name(""), best);
  EXPECT_EQ(isa_by_name("sse9"), best);
  EXPECT_EQ(isa_by_name("baseline"), isa_available(Isa::baseline) ? Isa::baseline : best);
  EXPECT_EQ(isa_by_name("avx2"), isa_available(Isa::avx2) ? Isa::avx2 : best);
  EXPECT_EQ(isa_by_name("avx512"), isa_available(Isa::avx512) ? Isa::avx512 : best);
}

#ifdef GRAZE_ONLY_LEVEL
TEST(Dispatch, HasTheOneLevelThatWasBuilt) { EXPECT_EQ(isa_by_name(nullptr), Isa::GRAZE_ONLY_LEVEL); }
#else
TEST(Dispatch, HasTheBaselineEverywhere) { EXPECT_TRUE(isa_available(Isa::baseline)); }
#endif

TEST(Dispatch, HasNoBetterLevelThanTheBest) {
  for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa_available(level)) {
      EXPECT_LE(level, isa_by_name(nullptr));
    }
}

}  // namespace
}  // namespace graze
