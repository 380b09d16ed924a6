#include "graze/shape.hpp"

#include "shape/rounding.hpp"

namespace graze {

namespace {

/// The rounding between a shape's numbers and its bounds, relative to the largest number involved. Each
/// operation rounds by half a unit in the last place: at most eight in turning the pose's quaternion to a
/// matrix, three a product, three sums.
template <class T>
constexpr T bounds_rounding = T(16) * std::numeric_limits<T>::epsilon();

}  // namespace

template <class T>
Aabb<T> bounds(const Shape<T>& shape, const Pose<T>& pose) {
  return shape.visit([&](const auto& c) {
    const T grow = rounding_radius(c, shape.rounding());
    const T slack = bounds_rounding<T> * (max_abs(pose.translation) + c.core_extent() + grow);
    return inflated(c.core_bounds(pose), grow + slack);
  });
}

template <class T>
Vec3<T> support(const Shape<T>& shape, const Vec3<T>& direction) {
  return shape.visit([&](const auto& c) -> Vec3<T> {
    if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
      return c.core_support(direction) + normalized(direction) * rounding_radius(c, shape.rounding());
    else
      return Vec3<T>{};
  });
}

template Aabb<float> bounds(const Shape<float>&, const Pose<float>&);
template Aabb<double> bounds(const Shape<double>&, const Pose<double>&);
template Vec3<float> support(const Shape<float>&, const Vec3<float>&);
template Vec3<double> support(const Shape<double>&, const Vec3<double>&);

}  // namespace graze
