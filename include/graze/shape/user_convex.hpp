// A convex shape of the user's own, given by its support function.
//
// Guarantee: takes part in every query that any convex shape does. Answers are as accurate as the support function: it
// must return a point of the shape that lies furthest along the direction, and the same one for equal directions.
#pragma once

#include <memory>

#include "graze/aabb.hpp"
#include "graze/detail/lent.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// The support function of a bounded, closed convex set in its own frame.
template <class T>
class GRAZE_API SupportFunction {
 public:
  virtual ~SupportFunction() = default;
  /// A point of the set furthest along `direction`, which is not zero and need not be unit.
  virtual Vec3<T> support(const Vec3<T>& direction) const = 0;
};

/// The support function of the origin alone.
template <class T>
class OriginSupport final : public SupportFunction<T> {
 public:
  Vec3<T> support(const Vec3<T>&) const override { return {}; }
};

/// A convex shape that is given by its support function.
template <class T>
class UserConvex {
 public:
  static constexpr const char* name = "user";

  /// Shares `function`. Throws `InvalidValue` when it is null or its support along an axis is not finite or larger than
  /// `largest_magnitude`. A set that reaches less than `smallest_magnitude` along every axis becomes the origin; small
  /// parts of others are kept as they are.
  explicit UserConvex(std::shared_ptr<const SupportFunction<T>> function) : function_(std::move(function)) {
    if (!function_) validate::fail("function", "a support function", "null");
    const Aabb<T> box = core_bounds({});
    validate::point(box.lower, "function.support(negative axes)");
    validate::point(box.upper, "function.support(positive axes)");
    const Vec3<T> reach = greatest(abs(box.lower), abs(box.upper));
    if (max_abs(reach) < smallest_magnitude<T>)
      function_ = std::make_shared<OriginSupport<T>>();
    else
      extent_ = length(reach);
  }
  UserConvex(const UserConvex& lender, Lent)
      : function_(std::shared_ptr<void>(), lender.function_.get()), extent_(lender.extent_) {}

  /// The caller's function.
  const SupportFunction<T>& function() const { return *function_; }

  T core_radius() const { return T(0); }
  T core_extent() const { return extent_; }
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    return converted<S>(function_->support(converted<T>(normalized(direction))));
  }
  void core_face(const Vec3<T>& direction, Face<T>& face) const {
    face.clear();
    face.push(core_support(direction), 0);
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const Mat3<T> m = rotation_matrix(pose.rotation);
    Vec3<T> lower, upper;
    for (std::size_t i = 0; i < 3; ++i) {
      upper[i] = dot(m.row[i], core_support(m.row[i]));
      lower[i] = dot(m.row[i], core_support(-m.row[i]));
    }
    return {pose.translation + lower, pose.translation + upper};
  }

 private:
  std::shared_ptr<const SupportFunction<T>> function_;
  T extent_ = T(0);
};

}  // namespace graze
