#include "graze/plane/swept.hpp"

#include "graze/plane/support.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

namespace {

/// The core's support, at whichever end of the motion lies further along.
template <class T>
class SweptCore final : public SupportFunction<T> {
 public:
  SweptCore(Shape<T> shape, const Vec2<T>& motion)
      : shape_(std::move(shape)), core_(convex_core(shape_)), motion_(motion) {}

  Vec2<T> support(const Vec2<T>& direction) const override {
    const Vec2<T> at_start = converted<T>(plane::support(core_, converted<double>(direction)).point);
    return dot(direction, motion_) > T(0) ? at_start + motion_ : at_start;
  }

 private:
  Shape<T> shape_;  ///< which the core borrows from
  Core<T> core_;
  Vec2<T> motion_;  ///< in the shape's frame
};

}  // namespace

template <class T>
Vec2<T> support(const Shape<T>& shape, const Vec2<T>& direction) {
  if (!shape.convex() || !is_bounded(shape)) return {};
  const Core<T> core = convex_core(shape);
  const Vec2d along = converted<double>(direction);
  return converted<T>(support(core, along).point + normalized(along) * core.radius);
}

template <class T>
Shape<T> swept(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& motion) {
  if (!shape.convex() || !is_bounded(shape)) throw InvalidValue("shape", "a bounded convex shape", shape.name());
  const Vec2<T> local = inverse_rotate(pose.rotation, detail::checked_point(motion, "motion"));
  const Core<T> core = convex_core(shape);
  const T radius = static_cast<T>(core.radius);
  if (core.kind != CoreKind::polygon) return {UserConvex<T>(std::make_shared<SweptCore<T>>(shape, local)), radius};
  std::vector<Vec2<T>> points;
  points.reserve(2 * std::size_t{core.count});
  for (std::uint32_t i = 0; i < core.count; ++i) {
    points.push_back(converted<T>(core.vertex(i)));
    points.push_back(points.back() + local);
  }
  if (core.count == 1) return {Segment<T>(points[0], points[1]), radius};
  return {ConvexPolygon<T>(points), radius};
}

#define GRAZE_PLANE_SWEPT(T)                                                                                           \
  template Vec2<T> support(const Shape<T>&, const Vec2<T>&);                                                           \
  template Shape<T> swept(const Shape<T>&, const Pose2<T>&, const Vec2<T>&);
GRAZE_PLANE_SWEPT(float)
GRAZE_PLANE_SWEPT(double)
#undef GRAZE_PLANE_SWEPT

}  // namespace graze::plane
