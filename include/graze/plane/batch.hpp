// Batches in the plane: the queries of plane/query.hpp on many pairs of shapes at once.
//
// Guarantee: each pair gets the bits that the query gives for it alone, whatever the order of the pairs, the other
// pairs of the batch, the level of the instruction set and the number of threads; a batch is a matter of speed only.
// Circles, untapered capsules, segments, boxes, half-planes and convex polygons of up to eight vertices are answered
// many at a time where that is faster, all other pairs one by one. Kernels allocate nothing; the arrays of the answer
// grow as needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/executor.hpp"
#include "graze/plane/cast.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {

namespace detail {

/// The index of a kind in `ShapeList`.
template <class C, class T>
constexpr std::size_t kind_of() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    std::size_t place = 0;
    static_cast<void>(((place = I, std::is_same_v<std::variant_alternative_t<I, ShapeList<T>>, C>) || ...));
    return place;
  }
  (std::make_index_sequence<Shape<T>::count>());
}

}  // namespace detail

/// Shapes and their poses, in the caller's arrays, which must outlive this view. There are as many shapes as poses, or
/// one shape for all poses, or one pose for all shapes.
template <class T>
class GRAZE_API Bodies {
 public:
  /// `shapes` are of one kind known at compile time, such as `Box<T>`, or of any kind: `Shape<T>`. Shapes of one kind
  /// take less memory and thus less time to load. Throws `InvalidValue` for numbers of shapes and poses that do not
  /// match.
  template <class C>
  Bodies(std::span<const C> shapes, std::span<const Pose2<T>> poses);
  /// Bodies in vectors, which are borrowed like any array.
  template <class C>
  Bodies(const std::vector<C>& shapes, const std::vector<Pose2<T>>& poses)
      : Bodies(std::span<const C>(shapes), std::span<const Pose2<T>>(poses)) {}

  std::size_t size() const { return size_; }
  /// The pose of the i-th body; a single pose belongs to all bodies.
  const Pose2<T>& pose(std::size_t i) const { return poses_.size() == 1 ? poses_[0] : poses_[i]; }
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
  /// Calls `f` with the i-th shape as a value, without a copy unless all are of one kind.
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
  std::span<const Pose2<T>> poses_;
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
  /// other. Throws `InvalidValue` for numbers that do not match.
  Batch(const Bodies<T>& a, const Bodies<T>& b);

  std::size_t size() const { return size_; }
  /// The first bodies of the pairs.
  const Bodies<T>& a() const { return a_; }
  /// The second bodies of the pairs.
  const Bodies<T>& b() const { return b_; }
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

/// Contacts of a batch: the manifolds and points of all its pairs in three arrays.
template <class T>
struct BatchContacts {
  /// One pair of the batch.
  struct Pair {
    bool overlap;  ///< distance <= 0, whatever the margin
    std::uint32_t first_manifold, manifold_count;
  };
  /// One manifold of a pair.
  struct Group {
    Vec2<T> normal{};                        ///< unit, from A to B
    std::uint32_t piece_a = 0, piece_b = 0;  ///< the child of a compound that touches, else 0
    std::uint32_t first_point = 0, point_count = 0;
  };
  std::vector<Pair> pairs;              ///< one for each pair of the batch, in its order
  std::vector<Group> manifolds;         ///< manifolds of a pair are contiguous
  std::vector<ContactPoint<T>> points;  ///< points of a manifold are contiguous

  std::span<const Group> manifolds_of(std::size_t pair) const {
    return std::span(manifolds).subspan(pairs[pair].first_manifold, pairs[pair].manifold_count);
  }
  std::span<const ContactPoint<T>> points_of(const Group& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

/// Sets `touch[i]` to 1 where the i-th pair overlaps, else to 0. With an executor, on its threads.
template <class T>
GRAZE_API void overlap(const Batch<T>& batch, std::vector<std::uint8_t>& touch, Executor* executor = nullptr);

/// Sets `distances[i]` to the `distance` of the i-th pair. With an executor, on its threads.
template <class T>
GRAZE_API void distance(const Batch<T>& batch, std::vector<Distance<T>>& distances, Executor* executor = nullptr);

/// Contacts of the pairs that are at most `margin` >= 0 apart, as `contacts` gives them. With an executor, on its
/// threads; the arrays are the same.
template <class T>
GRAZE_API void contacts(const Batch<T>& batch, T margin, BatchContacts<T>& found, Executor* executor = nullptr);

/// Sets `hits[i]` to the first contact of the i-th pair at a time in [0, duration], as `cast` gives it, or to none.
/// `velocities_a` and `velocities_b` are those of the bodies of `batch.a()` and `batch.b()`: as many as
/// bodies, or one for all of them. Throws `InvalidValue` for numbers that do not match. With an executor, on its
/// threads. Cost: that of the casts one by one.
template <class T>
GRAZE_API void cast(const Batch<T>& batch, std::type_identity_t<std::span<const Velocity<T>>> velocities_a,
                    std::type_identity_t<std::span<const Velocity<T>>> velocities_b, std::type_identity_t<T> duration,
                    std::vector<std::optional<CastHit<T>>>& hits, const CastOptions& options = {},
                    Executor* executor = nullptr);

/// Writes the nearest point of the shape's surface for each of `points`, as `closest` gives it, to the entry of `found`
/// at the point's index. Points beyond the end of `found` are left out. With an executor, on its threads.
/// Cost: that of the points one by one.
template <class T>
GRAZE_API void closest(const Shape<T>& shape, const Pose2<T>& pose,
                       std::type_identity_t<std::span<const Vec2<T>>> points,
                       std::type_identity_t<std::span<Closest<T>>> found, Executor* executor = nullptr);

/// Writes the first hit of each ray with 0 <= t <= `length`, as `raycast` defines it, to the entry of `hits` at the
/// ray's index. Rays beyond the end of `hits` are left out. At boxes and convex polygons without rounding many rays at
/// a time.
template <class T>
GRAZE_API void raycast(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays,
                       std::span<std::optional<RayHit<T>>> hits, T length = std::numeric_limits<T>::infinity());

/// Writes to `hits`, for each ray, whether anything is hit with 0 <= t <= `length`, as `raycast_any` defines it.
template <class T>
GRAZE_API void raycast_any(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays,
                           std::span<bool> hits, T length = std::numeric_limits<T>::infinity());

template <class T>
template <class C>
Bodies<T>::Bodies(std::span<const C> shapes, std::span<const Pose2<T>> poses)
    : shapes_(shapes.data()),
      shape_count_(shapes.size()),
      stride_(sizeof(C)),
      size_(shapes.size() == 1 ? poses.size() : shapes.size()),
      poses_(poses),
      made_([](const void* concrete) { return Shape<T>(*static_cast<const C*>(concrete)); }) {
  if constexpr (!std::is_same_v<C, Shape<T>>) kind_ = detail::kind_of<C, T>();
  if (poses.size() != size_ && poses.size() != 1)
    validate::fail("poses", "as many as shapes, or one", static_cast<double>(poses.size()));
  if (shapes.empty() && !poses.empty()) validate::fail("shapes", "one for the poses", 0);
}

}  // namespace graze::plane
