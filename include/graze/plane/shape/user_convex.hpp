// A convex shape of the user's own in the plane, given by its support function.
//
// Guarantee: takes part in every query that any convex shape does. Answers are as accurate as the support function: it
// must return a point of the shape that lies furthest along the direction, and the same one for equal directions.
#pragma once

#include <memory>

#include "graze/plane/shape/flat.hpp"

namespace graze::plane {

/// The support function of a bounded, closed convex set in its own frame.
template <class T>
class GRAZE_API SupportFunction {
 public:
  virtual ~SupportFunction() = default;
  /// A point of the set furthest along `direction`, which is not zero and need not be unit.
  virtual Vec2<T> support(const Vec2<T>& direction) const = 0;
};

/// A convex shape of the plane that is given by its support function.
template <class T>
class UserConvex {
 public:
  static constexpr const char* name = "user";

  /// Shares `function`. Throws `InvalidValue` when it is null or its support along an axis is not finite or larger
  /// than `largest_magnitude`.
  explicit UserConvex(std::shared_ptr<const SupportFunction<T>> function) : function_(std::move(function)) {
    if (!function_) validate::fail("function", "a support function", "null");
    Vec2<T> reach{};
    for (const Vec2<T>& d : {Vec2<T>{T(1), T(0)}, {T(0), T(1)}, {T(-1), T(0)}, {T(0), T(-1)}}) {
      const Vec2<T> p = detail::checked_point(function_->support(d), "function.support(axis)");
      reach =
          d.x != T(0) ? Vec2<T>{greatest(reach.x, d.x * p.x), reach.y} : Vec2<T>{reach.x, greatest(reach.y, d.y * p.y)};
    }
    extent_ = length(reach);
  }

  /// The caller's function.
  const SupportFunction<T>& function() const { return *function_; }
  T core_extent() const { return extent_; }

 private:
  std::shared_ptr<const SupportFunction<T>> function_;
  T extent_{};
};

}  // namespace graze::plane
