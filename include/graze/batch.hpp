// The questions of query.hpp about many pairs at once.
//
// Guarantee: for every pair the bits that the question about it alone gives, in whatever order the pairs come, whatever
// pairs stand beside it, and at every level of the instruction set; so that a batch is a matter of speed only. Pairs of
// kinds that have a kernel are asked about many at a time (2 to 16, by the machine and the numbers), all others one by
// one. Nothing throws but what says so; nothing is allocated where the arrays of the answer have the room already.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "graze/batch_contacts.hpp"
#include "graze/broad_phase.hpp"
#include "graze/compact_contacts.hpp"
#include "graze/query.hpp"

namespace graze {

/// Shapes and where they stand, in the caller's arrays, which outlive this. There are as many shapes as poses, or one
/// shape for all poses, or one pose for all shapes.
template <class T>
class GRAZE_API Bodies {
 public:
  /// `shapes` are of one kind known to the compiler, such as `Box<T>`, or of any: `Shape<T>`. Those of one kind take
  /// less memory and thus less time to load. Throws `InvalidValue` for numbers that do not go together.
  template <class C>
  Bodies(std::span<const C> shapes, std::span<const Pose<T>> poses);
  /// Bodies in vectors, which are borrowed like any array.
  template <class C>
  Bodies(const std::vector<C>& shapes, const std::vector<Pose<T>>& poses)
      : Bodies(std::span<const C>(shapes), std::span<const Pose<T>>(poses)) {}

  std::size_t size() const { return size_; }
  /// Of the i-th body: a single pose is that of all.
  const Pose<T>& pose(std::size_t i) const { return poses_.size() == 1 ? poses_[0] : poses_[i]; }
  /// The place of a shape in `ShapeList`.
  std::size_t kind(std::size_t i) const { return one_kind() ? kind_ : any(i).index(); }
  /// Whether all are of one kind, known to the compiler.
  bool one_kind() const { return kind_ < Shape<T>::count; }
  /// The concrete shape, which is of that kind.
  const void* concrete(std::size_t i) const {
    if (one_kind()) return static_cast<const char*>(shapes_) + place(i) * stride_;
    return any(i).visit([](const auto& c) { return static_cast<const void*>(&c); });
  }
  /// The rounding radius, which only a `Shape<T>` has.
  T rounding(std::size_t i) const { return one_kind() ? T(0) : any(i).rounding(); }
  /// The shape as a value; where all are of one kind, lent by the concrete one.
  Shape<T> shape(std::size_t i) const { return one_kind() ? made_(concrete(i)) : any(i); }
  /// Calls `f` with it; it is only copied where all are of one kind.
  template <class F>
  decltype(auto) visit(std::size_t i, F&& f) const {
    return one_kind() ? f(made_(concrete(i))) : f(any(i));
  }

 private:
  std::size_t place(std::size_t i) const { return shape_count_ == 1 ? 0 : i; }
  const Shape<T>& any(std::size_t i) const { return static_cast<const Shape<T>*>(shapes_)[place(i)]; }

  const void* shapes_;
  std::size_t shape_count_, stride_, size_;
  std::size_t kind_ = Shape<T>::count;  ///< that of all, or none
  std::span<const Pose<T>> poses_;
  Shape<T> (*made_)(const void* concrete);
};

/// The pairs that a question is about.
template <class T>
class GRAZE_API Batch {
 public:
  /// Places in `a` and in `b`; these may be the same. Throws `InvalidValue` for a place that they do not have.
  Batch(const Bodies<T>& a, const Bodies<T>& b, std::span<const IdPair> pairs);
  /// The first of A with the first of B, and so on; where one of them has a single body, that with all of the other:
  /// one shape against N poses, or against N shapes. Throws `InvalidValue` for numbers that do not go together.
  Batch(const Bodies<T>& a, const Bodies<T>& b);

  std::size_t size() const { return size_; }
  /// The first bodies of the pairs.
  const Bodies<T>& a() const { return a_; }
  /// The second bodies of the pairs.
  const Bodies<T>& b() const { return b_; }
  /// Whether no places are given: the i-th pair is of the i-th bodies, or of the single one of a side.
  bool in_order() const { return pairs_.empty(); }
  /// The places of the i-th pair.
  IdPair operator[](std::size_t i) const {
    if (!pairs_.empty()) return pairs_[i];
    const auto place = static_cast<std::uint32_t>(i);
    return {a_.size() == 1 ? 0 : place, b_.size() == 1 ? 0 : place};
  }

 private:
  Bodies<T> a_, b_;
  std::span<const IdPair> pairs_;
  std::size_t size_;
};

/// `overlap` of each pair: 1 or 0. Kernels: spheres, capsules and boxes with each other; these and triangles with
/// half-spaces; spheres and capsules with triangles; cylinders, cones and ellipsoids with each other and with spheres,
/// capsules, boxes, rectangles, segments and triangles; triangles with each other and with boxes and rectangles.
template <class T>
GRAZE_API void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch);

/// `distance` of each pair. Kernels: spheres, capsules and boxes with each other; these and triangles with half-spaces;
/// spheres and capsules with triangles, and triangles with each other.
template <class T>
GRAZE_API void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances);

/// `contacts` of each pair up to `margin` >= 0 apart. Kernels: spheres, capsules and boxes with each other and with
/// triangles; all of these with half-spaces; triangles with each other, to tell those that are further apart.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found);

/// `contacts` of each pair in few bytes, for callers who want points, normals and distances only.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, CompactContacts<T>& found);

template <class T>
template <class C>
Bodies<T>::Bodies(std::span<const C> shapes, std::span<const Pose<T>> poses)
    : shapes_(shapes.data()),
      shape_count_(shapes.size()),
      stride_(sizeof(C)),
      size_(shapes.size() == 1 ? poses.size() : shapes.size()),
      poses_(poses),
      made_([](const void* concrete) { return Shape<T>(lent(*static_cast<const C*>(concrete))); }) {
  if constexpr (!std::is_same_v<C, Shape<T>>) kind_ = detail::kind_of<C, T>();
  if (poses.size() != size_ && poses.size() != 1)
    validate::fail("poses", "as many as shapes, or one", static_cast<double>(poses.size()));
  if (shapes.empty() && !poses.empty()) validate::fail("shapes", "one for the poses", 0);
}

}  // namespace graze
