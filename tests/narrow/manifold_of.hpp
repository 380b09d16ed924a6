// What the tests of manifolds have in common: bodies that are only moved, and the one manifold of two of them.
#pragma once

#include <gtest/gtest.h>

#include "graze/query.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {

constexpr Posed at(double x, double y, double z) { return {{x, y, z}, {}}; }

template <class T>
reference::Vector vector_of(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// Of two convex bodies; empty when they are apart.
inline Manifold<double> only_manifold(const Shaped& a, const Posed& pa, const Shaped& b, const Posed& pb,
                                      double margin = 0) {
  Manifolds<double> manifolds;
  contacts(a, pa, b, pb, margin, manifolds);
  EXPECT_LE(manifolds.size(), 1u);
  return manifolds.empty() ? Manifold<double>{} : manifolds[0];
}

}  // namespace graze::testing
