#include "io/plane_shapes.hpp"

#include "plane/leaves.hpp"

namespace graze::io {

Aabbd plane_bounds(const plane::Shaped& shape, const plane::Pose2d& pose) {
  const plane::Aabb2<double> box = plane::bounds(shape, pose);
  return {{box.lower.x, box.lower.y, 0}, {box.upper.x, box.upper.y, 0}};
}

bool has_straight_sides(const plane::Shaped& shape) {
  bool straight = true;
  plane::for_each_leaf(shape, plane::Pose2d{},
                       [&](const plane::Core<double>& core, const plane::Pose2d&, double, std::uint32_t) {
                         straight = straight && (core.kind == plane::CoreKind::half_plane ||
                                                 (core.kind == plane::CoreKind::polygon && core.radius == 0));
                       });
  return straight;
}

}  // namespace graze::io
