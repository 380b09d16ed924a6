// The pairs of a batch: bodies in the caller's arrays, and which of them are paired.
//
// Guarantee: views, which copy and allocate nothing. Written once, over `Placed`, the shape in place of a space:
// `graze::Placed` in three dimensions, `plane::Placed` in two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/detail/lent.hpp"
#include "graze/detail/validate.hpp"
#include "graze/shape.hpp"

namespace graze {

/// Shapes and their poses, in the caller's arrays, which must outlive this view. There are as many shapes as poses, or
/// one shape for all poses, or one pose for all shapes.
template <class T, class Placed = graze::Placed<T>>
class GRAZE_API Bodies {
 public:
  using Shape = decltype(Placed::shape);  ///< a shape of any kind
  using Pose = decltype(Placed::pose);    ///< the pose of one

  /// `shapes` are of one kind known at compile time, such as `Box<T>`, or of any kind: `Shape`. Shapes of one kind
  /// take less memory and thus less time to load. Throws `InvalidValue` for numbers of shapes and poses that do not
  /// match.
  template <class C>
  Bodies(std::span<const C> shapes, std::span<const Pose> poses);
  /// Bodies in vectors, which are borrowed like any array.
  template <class C>
  Bodies(const std::vector<C>& shapes, const std::vector<Pose>& poses)
      : Bodies(std::span<const C>(shapes), std::span<const Pose>(poses)) {}

  std::size_t size() const { return size_; }
  /// The pose of the i-th body; a single pose belongs to all bodies.
  const Pose& pose(std::size_t i) const { return poses_.size() == 1 ? poses_[0] : poses_[i]; }
  /// The kind of the i-th shape: its index in `ShapeList`.
  std::size_t kind(std::size_t i) const { return one_kind() ? kind_ : any(i).index(); }
  /// Whether all shapes are of one kind that is known at compile time.
  bool one_kind() const { return kind_ < Shape::count; }
  /// Pointer to the i-th shape as an object of the class of its kind.
  const void* concrete(std::size_t i) const {
    if (one_kind()) return static_cast<const char*>(shapes_) + place(i) * stride_;
    return any(i).visit([](const auto& c) { return static_cast<const void*>(&c); });
  }
  /// The rounding radius of the i-th shape: zero for shapes of one kind, since only a `Shape` has one.
  T rounding(std::size_t i) const { return one_kind() ? T(0) : any(i).rounding(); }
  /// The bodies from the `begin`-th to the one before the `end`-th, as a view of the same arrays.
  Bodies part(std::size_t begin, std::size_t end) const {
    Bodies some = *this;
    some.size_ = end - begin;
    if (shape_count_ != 1) {
      some.shapes_ = static_cast<const char*>(shapes_) + begin * stride_;
      some.shape_count_ = end - begin;
    }
    if (poses_.size() != 1) some.poses_ = poses_.subspan(begin, end - begin);
    return some;
  }
  /// The i-th shape as a value; where all are of one kind, lent by the concrete shape.
  Shape shape(std::size_t i) const { return one_kind() ? made_(concrete(i)) : any(i); }
  /// Calls `f` with the i-th shape, without a copy unless all are of one kind.
  template <class F>
  decltype(auto) visit(std::size_t i, F&& f) const {
    return one_kind() ? f(made_(concrete(i))) : f(any(i));
  }

 private:
  std::size_t place(std::size_t i) const { return shape_count_ == 1 ? 0 : i; }
  const Shape& any(std::size_t i) const { return static_cast<const Shape*>(shapes_)[place(i)]; }

  const void* shapes_;
  std::size_t shape_count_, stride_, size_;
  std::size_t kind_ = Shape::count;  ///< the common kind; `Shape::count` if there is none
  std::span<const Pose> poses_;
  Shape (*made_)(const void* concrete);
};

/// The pairs of a batched query.
template <class T, class Placed = graze::Placed<T>>
class GRAZE_API Batch {
 public:
  /// Pairs by index: each of `pairs` holds an index into `a` and one into `b`, which may be the same bodies. Throws
  /// `InvalidValue` for an index out of range.
  Batch(const Bodies<T, Placed>& a, const Bodies<T, Placed>& b, std::span<const IdPair> pairs);
  /// Pairs in order: the i-th body of A with the i-th of B. A side with a single body pairs it with every body of the
  /// other: one shape against N poses, or against N shapes. Throws `InvalidValue` for numbers that do not match.
  Batch(const Bodies<T, Placed>& a, const Bodies<T, Placed>& b);

  std::size_t size() const { return size_; }
  /// The first bodies of the pairs.
  const Bodies<T, Placed>& a() const { return a_; }
  /// The second bodies of the pairs.
  const Bodies<T, Placed>& b() const { return b_; }
  /// Whether the pairs come without indices: the i-th pair has the i-th bodies, or the single body of a side.
  bool in_order() const { return pairs_.empty(); }
  /// The indices of the i-th pair's bodies, in `a` and in `b`.
  IdPair operator[](std::size_t i) const {
    if (!pairs_.empty()) return pairs_[i];
    const auto place = static_cast<std::uint32_t>(i);
    return {a_.size() == 1 ? 0 : place, b_.size() == 1 ? 0 : place};
  }

  /// The pairs from the `begin`-th to the one before the `end`-th, as a view of the same arrays.
  Batch part(std::size_t begin, std::size_t end) const {
    Batch some = *this;
    some.size_ = end - begin;
    if (!pairs_.empty()) {
      some.pairs_ = pairs_.subspan(begin, end - begin);
    } else {
      if (a_.size() != 1) some.a_ = a_.part(begin, end);
      if (b_.size() != 1) some.b_ = b_.part(begin, end);
    }
    return some;
  }
  /// Calls `f(shape_a, pose_a, shape_b, pose_b)` with the i-th pair.
  template <class F>
  decltype(auto) visit(std::size_t i, F&& f) const {
    const IdPair p = (*this)[i];
    return a_.visit(p.a, [&](const auto& shape_a) {
      return b_.visit(p.b, [&](const auto& shape_b) { return f(shape_a, a_.pose(p.a), shape_b, b_.pose(p.b)); });
    });
  }

 private:
  Bodies<T, Placed> a_, b_;
  std::span<const IdPair> pairs_;
  std::size_t size_;
};

template <class T, class Placed>
template <class C>
Bodies<T, Placed>::Bodies(std::span<const C> shapes, std::span<const Pose> poses)
    : shapes_(shapes.data()),
      shape_count_(shapes.size()),
      stride_(sizeof(C)),
      size_(shapes.size() == 1 ? poses.size() : shapes.size()),
      poses_(poses),
      made_([](const void* concrete) { return Shape(lent(*static_cast<const C*>(concrete))); }) {
  if constexpr (!std::is_same_v<C, Shape>) kind_ = Shape::template index_of<C>();
  if (poses.size() != size_ && poses.size() != 1)
    validate::fail("poses", "as many as shapes, or one", static_cast<double>(poses.size()));
  if (shapes.empty() && !poses.empty()) validate::fail("shapes", "one for the poses", 0);
}

}  // namespace graze
