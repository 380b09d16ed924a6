// A ray of a batch against the same ray alone.
#pragma once

#include <gtest/gtest.h>

#include "graze/raycast.hpp"

namespace graze::testing {

/// That the hit of a ray in a batch, and whether it hits at all, are what it gets alone; counts those that hit.
template <class T>
void expect_as_alone(const std::optional<RayHit<T>>& hit, bool any, const Shape<T>& shape, const Pose<T>& pose,
                     const Ray<T>& ray, T length, BackFaces back, std::size_t& met) {
  const auto alone = raycast(shape, pose, ray, length, back);
  ASSERT_EQ(hit.has_value(), alone.has_value());
  ASSERT_EQ(any, alone.has_value());
  if (!alone) return;
  met += 1;
  ASSERT_EQ(hit->t, alone->t);
  ASSERT_EQ(hit->point, alone->point);
  ASSERT_EQ(hit->normal, alone->normal);
  ASSERT_EQ(hit->piece, alone->piece);
}

}  // namespace graze::testing
