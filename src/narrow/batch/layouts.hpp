// The layouts in memory on which kernels rely: they load shapes and poses as rows of numbers and write answers column
// by column. A change of one of these classes that breaks a kernel does not compile, and says here what it broke.
#pragma once

#include <cstddef>

#include "graze/batch_contacts.hpp"
#include "graze/compact_contacts.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/batch/pair_kernels.hpp"

namespace graze::layouts {

/// Classes that kernels load: nothing but their numbers, one after the other.
template <class T>
consteval bool loaded() {
  constexpr std::size_t number = sizeof(T);
  static_assert(sizeof(Vec3<T>) == 3 * number);
  static_assert(sizeof(Pose<T>) == 7 * number && offsetof(Pose<T>, rotation) == 3 * number);
  static_assert(sizeof(Sphere<T>) == 4 * number);
  static_assert(sizeof(Capsule<T>) == 3 * number);
  static_assert(sizeof(Box<T>) == 3 * number);
  static_assert(sizeof(Rectangle<T>) == 3 * number);
  static_assert(sizeof(Triangle<T>) == 9 * number);
  static_assert(offsetof(Distance<T>, normal) == number && offsetof(Distance<T>, a) == 4 * number);
  return true;
}
static_assert(loaded<float>() && loaded<double>());

/// Classes that kernels write in columns of four bytes, which is done in float alone; in double they assign members.
consteval bool written() {
  using Found = Distance<float>;
  static_assert(sizeof(Found) == 48 && offsetof(Found, b) == 28 && offsetof(Found, error) == 44);
  static_assert(static_cast<int>(Status::converged) == 0);  // written as a number that is zero
  using Point = ContactPoint<float>;
  static_assert(sizeof(Point) == 36 && offsetof(Point, b) == 12 && offsetof(Point, distance) == 24 &&
                offsetof(Point, feature) == 28 && offsetof(Point, weight) == 32);
  static_assert(sizeof(PointContact<float>) == 48 && offsetof(PointContact<float>, normal) == 36);
  using Pair = BatchContacts<float>::Pair;
  static_assert(sizeof(Pair) == 12 && offsetof(Pair, first_manifold) == 4 && offsetof(Pair, manifold_count) == 8);
  using Group = BatchContacts<float>::Group;
  static_assert(sizeof(Group) == 28 && offsetof(Group, piece_a) == 12 && offsetof(Group, first_point) == 20);
  static_assert(sizeof(CompactContacts<float>::Point) == 16);
  using CompactGroup = CompactContacts<float>::Group;
  static_assert(sizeof(CompactGroup) == 24 && offsetof(CompactGroup, pair) == 12 &&
                offsetof(CompactGroup, first_point) == 16);
  return true;
}
static_assert(written());

}  // namespace graze::layouts
