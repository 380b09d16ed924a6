// Batches: the queries of query.hpp on many pairs of shapes at once.
//
// Guarantee: each pair gets the bits that the query gives for it alone, whatever the order of the pairs, the other
// pairs of the batch and the level of the instruction set; a batch is a matter of speed only. Pairs of kinds that have
// a kernel are answered 2 to 16 at a time (by the machine and the type of numbers), all others one by one. Only
// functions documented to throw do so; nothing is allocated while the arrays of the answer have the capacity.
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

/// Shapes and their poses, in the caller's arrays, which must outlive this view. There are as many shapes as poses, or
/// one shape for all poses, or one pose for all shapes.
template <class T>
class GRAZE_API Bodies {
 public:
  /// `shapes` are of one kind known at compile time, such as `Box<T>`, or of any kind: `Shape<T>`. Shapes of one kind
  /// take less memory and thus less time to load. Throws `InvalidValue` for numbers of shapes and poses that do not
  /// match.
  template <class C>
  Bodies(std::span<const C> shapes, std::span<const Pose<T>> poses);
  /// Bodies in vectors, which are borrowed like any array.
  template <class C>
  Bodies(const std::vector<C>& shapes, const std::vector<Pose<T>>& poses)
      : Bodies(std::span<const C>(shapes), std::span<const Pose<T>>(poses)) {}

  std::size_t size() const { return size_; }
  /// The pose of the i-th body; a single pose belongs to all bodies.
  const Pose<T>& pose(std::size_t i) const { return poses_.size() == 1 ? poses_[0] : poses_[i]; }
  /// The kind of the i-th shape: its index in `ShapeList`.
  std::size_t kind(std::size_t i) const { return one_kind() ? kind_ : any(i).index(); }
  /// Whether all shapes are of one kind that is known at compile time.
  bool one_kind() const { return kind_ < Shape<T>::count; }
  /// Pointer to the i-th shape as an object of the class of its kind.
  const void* concrete(std::size_t i) const {
    if (one_kind()) return static_cast<const char*>(shapes_) + place(i) * stride_;
    return any(i).visit([](const auto& c) { return static_cast<const void*>(&c); });
  }
  /// The rounding radius of the i-th shape: zero for shapes of one kind, since only a `Shape<T>` has one.
  T rounding(std::size_t i) const { return one_kind() ? T(0) : any(i).rounding(); }
  /// The i-th shape as a value; where all are of one kind, lent by the concrete shape.
  Shape<T> shape(std::size_t i) const { return one_kind() ? made_(concrete(i)) : any(i); }
  /// Calls `f` with the i-th shape, without a copy unless all are of one kind.
  template <class F>
  decltype(auto) visit(std::size_t i, F&& f) const {
    return one_kind() ? f(made_(concrete(i))) : f(any(i));
  }

 private:
  std::size_t place(std::size_t i) const { return shape_count_ == 1 ? 0 : i; }
  const Shape<T>& any(std::size_t i) const { return static_cast<const Shape<T>*>(shapes_)[place(i)]; }

  const void* shapes_;
  std::size_t shape_count_, stride_, size_;
  std::size_t kind_ = Shape<T>::count;  ///< the common kind; `Shape<T>::count` if there is none
  std::span<const Pose<T>> poses_;
  Shape<T> (*made_)(const void* concrete);
};

/// The pairs of a batched query.
template <class T>
class GRAZE_API Batch {
 public:
  /// Pairs by index: each of `pairs` holds an index into `a` and one into `b`, which may be the same bodies. Throws
  /// `InvalidValue` for an index out of range.
  Batch(const Bodies<T>& a, const Bodies<T>& b, std::span<const IdPair> pairs);
  /// Pairs in order: the i-th body of A with the i-th of B. A side with a single body pairs it with every body of the
  /// other: one shape against N poses, or against N shapes. Throws `InvalidValue` for numbers that do not match.
  Batch(const Bodies<T>& a, const Bodies<T>& b);

  std::size_t size() const { return size_; }
  /// The first bodies of the pairs.
  const Bodies<T>& a() const { return a_; }
  /// The second bodies of the pairs.
  const Bodies<T>& b() const { return b_; }
  /// Whether the pairs come without indices: the i-th pair has the i-th bodies, or the single body of a side.
  bool in_order() const { return pairs_.empty(); }
  /// The indices of the i-th pair's bodies, in `a` and in `b`.
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

/// Sets `touch[i]` to 1 where the i-th pair overlaps, else to 0. Kernels: spheres, capsules and boxes with each other;
/// these and triangles with half-spaces; spheres and capsules with triangles; cylinders, cones and ellipsoids with each
/// other and with spheres, capsules, boxes, rectangles, segments and triangles; triangles with each other and with
/// boxes and rectangles.
template <class T>
GRAZE_API void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch);

/// Sets `distances[i]` to the `distance` of the i-th pair. Kernels: spheres, capsules and boxes with each other; these
/// and triangles with half-spaces; spheres and capsules with triangles, and triangles with each other.
template <class T>
GRAZE_API void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances);

/// Contacts of the pairs that are at most `margin` >= 0 apart, as `contacts` gives them. Kernels: spheres, capsules and
/// boxes with each other and with triangles; all of these with half-spaces; triangles with each other, where lanes rule
/// out the pairs that are further apart.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found);

/// Contacts in compact form, for callers who need points, normals and distances only.
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
