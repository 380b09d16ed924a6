#include "graze/batch_raycast.hpp"

#include "query/shape_rays.hpp"
#include "rays/box_rays.hpp"
#include "rays/height_field_traversal.hpp"
#include "rays/ray_stream.hpp"
#include "simd/flatten.hpp"

namespace graze {

namespace {

using namespace shape_rays;
using rays::BlockFrame;
using rays::BlockHits;
using rays::BlockShape;
using rays::RayBlock;

/// The shapes in the form of the kernels, of a rounding radius; `none` for those without a closed form there.
class BlockShapeOf {
 public:
  BlockShapeOf(double rounding, BackFaces back) : rounding_(rounding) { shape_.both_sides = back == BackFaces::hit; }

  template <class C>
  BlockShape operator()(const C& concrete) && {
    take(concrete);
    return shape_;
  }

 private:
  template <class C>
  void take(const C&) {}
  template <class T>
  void take(const Sphere<T>& sphere) {
    put(0, sphere.center());
    shape_.radius = static_cast<double>(sphere.radius()) + rounding_;
    if (shape_.radius > 0) shape_.kind = BlockShape::ball;
  }
  template <class T>
  void take(const Capsule<T>& capsule) {
    put_balls<T>({T(0), -capsule.half_height(), T(0)}, capsule.radius_bottom(), {T(0), capsule.half_height(), T(0)},
                 capsule.radius_top());
  }
  template <class T>
  void take(const LineSegment<T>& segment) {
    put_balls<T>(segment.point(0), T(0), segment.point(1), T(0));
  }
  template <class T>
  void take(const Cylinder<T>& cylinder) {
    put(0, Vec3<T>{T(0), cylinder.half_height(), T(0)});
    shape_.radius = static_cast<double>(cylinder.radius_bottom());
    shape_.other_radius = static_cast<double>(cylinder.radius_top());
    if (rounding_ == 0 && (shape_.radius > 0 || shape_.other_radius > 0)) shape_.kind = BlockShape::frustum;
  }
  template <class T>
  void take(const Ellipsoid<T>& ellipsoid) {
    const Vec3<T>& radii = ellipsoid.radii();
    put(0, radii);
    if (rounding_ == 0 && least(radii.x, least(radii.y, radii.z)) > T(0)) shape_.kind = BlockShape::ellipsoid;
  }
  template <class T>
  void take(const HalfSpace<T>&) {
    shape_.radius = rounding_;
    shape_.kind = BlockShape::half_space;
  }
  template <class T>
  void take(const Triangle<T>& triangle) {
    for (std::size_t i = 0; i < 3; ++i) put(i, triangle.point(i));
    if (rounding_ == 0) shape_.kind = BlockShape::triangle;
  }

  template <class T>
  void put(std::size_t i, const Vec3<T>& p) {
    for (std::size_t k = 0; k < 3; ++k) shape_.points[i][k] = static_cast<double>(p[k]);
  }
  // Cases of `hit_balls`.
  template <class T>
  void put_balls(const Vec3<T>& a, T core_a, const Vec3<T>& b, T core_b) {
    const Vec3d between = converted<double>(b) - converted<double>(a);
    const double radius_a = static_cast<double>(core_a) + rounding_, radius_b = static_cast<double>(core_b) + rounding_;
    const bool one = length(between) <= std::abs(radius_a - radius_b) || a == b, first = radius_a >= radius_b;
    put(0, one && !first ? b : a);
    put(1, b);
    shape_.radius = one && !first ? radius_b : radius_a;
    shape_.other_radius = radius_b;
    if (radius_a > 0 || radius_b > 0) shape_.kind = one ? BlockShape::ball : BlockShape::ball_cone;
  }

  const double rounding_;
  BlockShape shape_;
};

template <class T>
BlockShape block_shape(const Shape<T>& shape, BackFaces back) {
  return shape.visit([&](const auto& concrete) {
    BlockShape out = BlockShapeOf(static_cast<double>(shape.rounding()), back)(concrete);
    out.around = rays::infinity;
    if constexpr (BoundedConvex<std::decay_t<decltype(concrete)>>) out.around = ball_around(concrete, shape.rounding());
    return out;
  });
}

template <class T>
BlockFrame block_frame(const Pose<T>& pose) {
  const Frame frame = frame_of(pose);
  BlockFrame block;
  for (std::size_t i = 0; i < 3; ++i) {
    block.translation[i] = frame.translation[i];
    for (std::size_t k = 0; k < 3; ++k) block.rotation[i][k] = frame.rotation.row[i][k];
  }
  return block;
}

template <class T>
Vec3<T> at(const T (&from)[3][RayBlock::size], std::size_t i) {
  return {from[0][i], from[1][i], from[2][i]};
}
void put(double (&to)[3][RayBlock::size], std::size_t i, const Vec3d& v) {
  for (std::size_t k = 0; k < 3; ++k) to[k][i] = v[k];
}

LocalRay local_ray(const RayBlock& block, std::size_t i) {
  return {at(block.origin, i), at(block.direction, i), 0, block.end[i], block.blur[i]};
}

/// The number of lanes, a multiple of the widest registers'.
std::size_t lanes_for(std::size_t rays) { return (rays + 7) / 8 * 8; }

/// Loads up to `RayBlock::size` rays into the shape's frame; returns the number of lanes filled.
template <class T>
std::size_t load(RayBlock& block, std::span<const Ray<T>> rays, T length, const BlockFrame& frame) {
  static_assert(sizeof(Ray<T>) == 6 * sizeof(T) && std::is_standard_layout_v<Ray<T>>);
  static const auto to_local = GRAZE_KERNEL(chosen_isa(), block_to_local<T>);
  to_local(block, &rays.front().origin.x, rays.size(), rays::end_of(length), frame);
  return lanes_for(rays.size());
}

/// Calls `f(block, first, some)` for consecutive groups of rays, `first` being the index of the first.
template <class T, class F>
void each_block(std::span<const Ray<T>> rays, const F& f) {
  RayBlock block;
  for (std::size_t first = 0; first < rays.size(); first += RayBlock::size)
    f(block, first, rays.subspan(first, least(RayBlock::size, rays.size() - first)));
}

/// Finds the hits of some rays at a box.
template <class T>
void find_hits(RayBlock& block, std::span<const Ray<T>> rays, T length, const rays::TurnedBox& box,
               BlockHits<T>& hits) {
  static const auto at_box = GRAZE_KERNEL(chosen_isa(), rays_at_box<T>);
  at_box(block, &rays.front().origin.x, rays.size(), length, box, hits);
}
template <class T>
std::optional<rays::TurnedBox> turned_box(const Shape<T>& shape, const Pose<T>& pose) {
  const Vec3<T>* half = rays::plain_box(shape);
  if (!half) return std::nullopt;
  return rays::TurnedBox(*half, pose);
}

template <class T>
rays::BlockMesh<T> block_mesh(const MeshData<T>& mesh, BackFaces back, bool any) {
  const Vec3d center = converted<double>(mesh.tree.bounds().center());
  return {.nodes = mesh.tree.nodes().data(),
          .leaves = mesh.leaves.data(),
          .points = &mesh.points.data()->x,
          .triangles = mesh.triangles.data()->data(),
          .order = mesh.tree.order().data(),
          .extent = static_cast<double>(mesh.extent),
          .center = {center.x, center.y, center.z},
          .radius = mesh.radius,
          .both_sides = back == BackFaces::hit,
          .any = any};
}

template <class T>
rays::BlockField<T> block_field(const HeightFieldData<T>& field, BackFaces back, bool any) {
  const Vec3d center = converted<double>(field.bounds().center());
  return {&field.pyramid,
          static_cast<double>(field.extent),
          {center.x, center.y, center.z},
          field.radius,
          back == BackFaces::hit,
          any};
}

/// A shape for which several rays can be cast at a time.
template <class T>
class BlockTarget {
 public:
  BlockTarget(const Shape<T>& shape, BackFaces back, bool any) : closed_(block_shape(shape, back)) {
    // Rays that may begin inside a solid mesh are cast one by one.
    if (const auto* mesh = shape.template as<Mesh<T>>(); mesh && !mesh->solid())
      mesh_ = block_mesh(mesh->data(), back, any);
    else if (const auto* field = shape.template as<HeightField<T>>())
      field_ = block_field(field->data(), back, any);
  }

  bool takes(std::size_t rays) const {
    constexpr std::size_t few = 4;  // at a surface fewer are faster one by one
    return closed_.kind != BlockShape::none || ((mesh_ || field_) && rays >= few);
  }

  /// Finds the hits of the first `count` rays; the block is filled up with others.
  void find_hits(RayBlock& block, std::size_t count, std::uint32_t (&pieces)[RayBlock::size]) const {
    static const auto at_shape = GRAZE_KERNEL(chosen_isa(), block_hits);
    static const auto at_mesh = GRAZE_KERNEL(chosen_isa(), block_at_mesh<T>);
    static const auto at_field = GRAZE_KERNEL(chosen_isa(), block_at_field<T>);
    if (mesh_)
      at_mesh(block, count, *mesh_, pieces);
    else if (field_)
      at_field(block, count, *field_, pieces);
    else
      at_shape(block, lanes_for(count), closed_);
  }

 private:
  BlockShape closed_;
  std::optional<rays::BlockMesh<T>> mesh_;
  std::optional<rays::BlockField<T>> field_;
};

/// Finds the hits one by one, for shapes without a way for several rays.
template <class T>
GRAZE_FLATTEN void find_hits(RayBlock& block, std::size_t count, const Shape<T>& shape, BackFaces back,
                             std::uint32_t (&pieces)[RayBlock::size]) {
  for (std::size_t i = 0; i < lanes_for(count); ++i) {
    block.state[i] = rays::ray_missed;
    block.t[i] = 0;
    put(block.point, i, {});
    put(block.normal, i, {0, 1, 0});
    if (i >= count || block.end[i] < 0) continue;
    LocalRay ray = local_ray(block, i);
    const Candidate first = first_hit(shape, ray, back);
    if (!(first.hit.t < rays::infinity)) continue;
    block.state[i] = rays::ray_hit;
    block.t[i] = first.hit.t;
    put(block.point, i, first.hit.point);
    put(block.normal, i, first.hit.normal);
    pieces[i] = first.piece;
  }
}

}  // namespace

template <class T>
void raycast(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays,
             std::span<std::optional<RayHit<T>>> hits, T length, BackFaces back) {
  const std::optional<rays::TurnedBox> box = turned_box(shape, pose);
  const BlockFrame frame = block_frame(pose);
  const BlockTarget<T> target(shape, back, false);
  static const auto to_world = GRAZE_KERNEL(chosen_isa(), block_to_world<T>);
  std::uint32_t pieces[RayBlock::size] = {};
  BlockHits<T> found;
  each_block(rays.first(least(rays.size(), hits.size())),
             [&](RayBlock& block, std::size_t first, std::span<const Ray<T>> some) {
               if (box) {
                 find_hits(block, some, length, *box, found);
               } else {
                 const std::size_t filled = load(block, some, length, frame);
                 if (target.takes(some.size()))
                   target.find_hits(block, some.size(), pieces);
                 else
                   find_hits(block, some.size(), shape, back, pieces);
                 to_world(block, filled, frame, length, found);
               }
               for (std::size_t i = 0; i < some.size(); ++i) {
                 // Written in any case: whether a ray hits is unpredictable.
                 std::optional<RayHit<T>>& hit = hits[first + i];
                 hit = RayHit<T>{found.t[i], at(found.point, i), at(found.normal, i), pieces[i]};
                 if (block.state[i] != rays::ray_hit) hit.reset();
               }
               for (std::size_t i = 0; i < some.size(); ++i)
                 if (block.state[i] == rays::ray_again) hits[first + i] = raycast(shape, pose, some[i], length, back);
             });
}

template <class T>
void raycast_any(const Shape<T>& shape, const Pose<T>& pose, std::span<const Ray<T>> rays, std::span<bool> hits,
                 T length, BackFaces back) {
  const std::optional<rays::TurnedBox> box = turned_box(shape, pose);
  const BlockFrame frame = block_frame(pose);
  const BlockTarget<T> target(shape, back, true);
  std::uint32_t pieces[RayBlock::size] = {};
  BlockHits<T> found;
  each_block(rays.first(least(rays.size(), hits.size())),
             [&](RayBlock& block, std::size_t first, std::span<const Ray<T>> some) {
               if (box) {
                 find_hits(block, some, length, *box, found);
                 for (std::size_t i = 0; i < some.size(); ++i) hits[first + i] = block.state[i] != rays::ray_missed;
                 return;
               }
               load(block, some, length, frame);
               const bool by_kernel = target.takes(some.size());
               if (by_kernel) target.find_hits(block, some.size(), pieces);
               for (std::size_t i = 0; i < some.size(); ++i) {
                 if (by_kernel && block.state[i] != rays::ray_again) {
                   hits[first + i] = block.state[i] == rays::ray_hit;
                 } else {
                   LocalRay ray = local_ray(block, i);
                   hits[first + i] = ray.end >= 0 && hits_any(shape, ray, back);
                 }
               }
             });
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void raycast(const Shape<T>&, const Pose<T>&, std::span<const Ray<T>>, std::span<std::optional<RayHit<T>>>, \
                        T, BackFaces);                                                                                 \
  template void raycast_any(const Shape<T>&, const Pose<T>&, std::span<const Ray<T>>, std::span<bool>, T, BackFaces);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
