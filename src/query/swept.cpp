#include "graze/swept.hpp"

#include "shape/rounding.hpp"

namespace graze {

namespace {

/// The core's support function, at the end of the motion that lies further along.
template <class T>
class SweptCore final : public SupportFunction<T> {
 public:
  SweptCore(Shape<T> shape, const Vec3<T>& motion) : shape_(std::move(shape)), motion_(motion) {}

  Vec3<T> support(const Vec3<T>& direction) const override {
    const Vec3<T> core = shape_.visit([&](const auto& c) -> Vec3<T> {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
        return c.core_support(direction);
      else
        return {};
    });
    return dot(direction, motion_) > T(0) ? core + motion_ : core;
  }

 private:
  Shape<T> shape_;
  Vec3<T> motion_;  ///< in the shape's frame
};

}  // namespace

template <class T>
Shape<T> swept(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion) {
  const bool bounded = shape.visit([](const auto& c) { return BoundedConvex<std::decay_t<decltype(c)>>; });
  if (!bounded) throw InvalidValue("shape", "a bounded convex shape", shape.name());
  const Vec3<T> local = rotate(conjugate(pose.rotation), validate::point(motion, "motion"));
  const T radius = shape.visit([&](const auto& c) { return rounding_radius(c, shape.rounding()); });
  return {UserConvex<T>(std::make_shared<SweptCore<T>>(shape, local)), radius};
}

template Shape<float> swept(const Shape<float>&, const Pose<float>&, const Vec3<float>&);
template Shape<double> swept(const Shape<double>&, const Pose<double>&, const Vec3<double>&);

}  // namespace graze
