// Many rays at one shape of the plane: by the kernel of ray_block.hpp where that is sure, else one by one.
#include <algorithm>

#include "graze/plane/batch.hpp"
#include "graze/plane/cast.hpp"
#include "plane/ray_block.hpp"
#include "plane/unit_rotation.hpp"

namespace graze::plane {

namespace {

/// The kernel of the level that the machine runs at.
RayBlockKernel ray_block_kernel() {
  static const RayBlockKernel chosen = GRAZE_KERNEL(chosen_isa(), plane_ray_block)();
  return chosen;
}

/// Rays below which it does not pay to look at the polygon first.
constexpr std::size_t few_rays = 4;

/// Whether rays go to the kernel together.
template <class T>
bool go_together(const Shape<T>& shape, std::size_t rays, T length) {
  if (rays < few_rays || !(length >= T(0)) || shape.rounding() != T(0)) return false;
  const auto* polygon = shape.template as<ConvexPolygon<T>>();
  if (polygon) return polygon->vertices().size() >= 3 && polygon->vertices().size() <= most_ray_vertices;
  const auto* box = shape.template as<Box<T>>();
  return box && box->half_extents().x > T(0) && box->half_extents().y > T(0);
}

/// A box or polygon in the form that the kernel takes.
template <class T>
RayPolygon ray_polygon(const Shape<T>& shape, const Pose2<T>& pose) {
  RayPolygon out;
  const Pose2d at = at_unit(pose);
  out.x = at.translation.x, out.y = at.translation.y;
  out.cosine = at.rotation.cosine, out.sine = at.rotation.sine;
  const auto put = [&](const Vec2d& p, const Vec2d& n) {
    const std::size_t i = out.count++;
    const Vec2d world = rotate(at.rotation, n);
    out.vertex_x[i] = p.x, out.vertex_y[i] = p.y;
    out.normal_x[i] = n.x, out.normal_y[i] = n.y;
    out.world_x[i] = world.x, out.world_y[i] = world.y;
  };
  if (const auto* polygon = shape.template as<ConvexPolygon<T>>()) {
    const std::span<const Vec2<T>> all = polygon->vertices();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec2d from = converted<double>(all[i]), edge = converted<double>(all[(i + 1) % all.size()]) - from;
      put(from, right(edge / length(edge)));
    }
  } else {
    const Vec2d half = converted<double>(shape.template as<Box<T>>()->half_extents());
    put({-half.x, -half.y}, {0, -1});
    put({half.x, -half.y}, {1, 0});
    put(half, {0, 1});
    put({-half.x, half.y}, {-1, 0});
  }
  return out;
}

/// Puts rays into a block, which is filled up with the last.
template <class T>
void put(std::span<const Ray<T>> rays, RayBlock& block) {
  const auto put_one = [&](std::size_t i, const Ray<T>& ray) {
    block.origin_x[i] = double(ray.origin.x), block.origin_y[i] = double(ray.origin.y);
    block.direction_x[i] = double(ray.direction.x), block.direction_y[i] = double(ray.direction.y);
  };
  for (std::size_t i = 0; i < rays.size(); ++i) put_one(i, rays[i]);
  for (std::size_t i = rays.size(); i % most_lanes != 0; ++i) put_one(i, rays.back());
}

/// Calls `f(i, block, place)` for each ray, whose answer by the kernel stands at that place of the block.
template <class T, class F>
void each_ray(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays, const F& f) {
  const RayPolygon polygon = ray_polygon(shape, pose);
  const RayBlockKernel kernel = ray_block_kernel();
  RayBlock block;
  for (std::size_t first = 0; first < rays.size(); first += most_rays) {
    const auto some = rays.subspan(first, std::min(most_rays, rays.size() - first));
    put(some, block);
    kernel(polygon, block, some.size());
    for (std::size_t k = 0; k < some.size(); ++k) f(first + k, block, k);
  }
}

}  // namespace

template <class T>
void raycast(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays,
             std::span<std::optional<RayHit<T>>> hits, T length) {
  rays = rays.first(std::min(rays.size(), hits.size()));
  if (!go_together(shape, rays.size(), length)) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = raycast(shape, pose, rays[i], length);
    return;
  }
  const auto until = double(length);
  each_ray(shape, pose, rays, [&](std::size_t i, const RayBlock& block, std::size_t k) {
    if (block.state[k] == RayBlock::unknown) {
      hits[i] = raycast(shape, pose, rays[i], length);
    } else if (block.state[k] == RayBlock::missed || !(block.t[k] <= until)) {
      hits[i].reset();
    } else {
      hits[i] = RayHit<T>{static_cast<T>(block.t[k]),
                          {static_cast<T>(block.point_x[k]), static_cast<T>(block.point_y[k])},
                          {static_cast<T>(block.normal_x[k]), static_cast<T>(block.normal_y[k])},
                          0,
                          Status::converged};
    }
  });
}

template <class T>
void raycast_any(const Shape<T>& shape, const Pose2<T>& pose, std::span<const Ray<T>> rays, std::span<bool> hits,
                 T length) {
  rays = rays.first(std::min(rays.size(), hits.size()));
  if (!go_together(shape, rays.size(), length)) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = raycast_any(shape, pose, rays[i], length);
    return;
  }
  const auto until = double(length);
  each_ray(shape, pose, rays, [&](std::size_t i, const RayBlock& block, std::size_t k) {
    hits[i] = block.state[k] == RayBlock::unknown ? raycast_any(shape, pose, rays[i], length)
                                                  : block.state[k] == RayBlock::hit && block.t[k] <= until;
  });
}

#define GRAZE_RAYS(T)                                                                                                  \
  template void raycast(const Shape<T>&, const Pose2<T>&, std::span<const Ray<T>>,                                     \
                        std::span<std::optional<RayHit<T>>>, T);                                                       \
  template void raycast_any(const Shape<T>&, const Pose2<T>&, std::span<const Ray<T>>, std::span<bool>, T);
GRAZE_RAYS(float)
GRAZE_RAYS(double)
#undef GRAZE_RAYS

}  // namespace graze::plane
