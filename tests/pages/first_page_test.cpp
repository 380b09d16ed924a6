// README.md: the first queries have the answers that their comments give.
#include "README_includes.inc"

#include <gtest/gtest.h>

TEST(Pages, TheFirstPagesQueriesHaveTheAnswersShown) {
#include "README_1.inc"
  EXPECT_TRUE(touch);
  EXPECT_NEAR(d.distance, -0.1, 1e-15);
  EXPECT_EQ(d.normal, graze::Vec3d(1, 0, 0));
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].normal, d.normal);
  EXPECT_EQ(c.distance, 2);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 0.5, 1e-9);
}
