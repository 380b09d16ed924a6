// Pairs of polygons that wait for a block to fill: pairs without an entry in the pair list, of which one at least has
// an inside and neither has more vertices than the kernels take.
#pragma once

#include <algorithm>
#include <span>

#include "graze/plane/batch.hpp"
#include "plane/pairs/load_kernels.hpp"
#include "plane/pairs/polygon_kernels.hpp"

namespace graze::plane {

/// The kernels of the level that the machine runs at.
inline const PolygonKernels& polygon_kernels() {
  static const PolygonKernels& chosen = GRAZE_KERNEL(chosen_isa(), plane_polygon_kernels)();
  return chosen;
}

/// The polygons of one side of a queue.
template <class T>
class QueuedPolygons {
 public:
  /// Takes the i-th body as the k-th of the queue and returns its number of vertices, or zero if the kernels do not
  /// take it.
  std::size_t take(const Bodies<T>& bodies, std::size_t i, std::size_t k) {
    const std::size_t count = take_vertices(bodies.kind(i), bodies.concrete(i), k);
    if (count == 0) return 0;
    counts_[k] = count;
    radii_[k] += double(bodies.rounding(i));
    poses_[k] = &bodies.pose(i);
    return count;
  }
  /// Writes the columns of the first `count` polygons; up to a full register the last one is repeated.
  void load(std::size_t count, const LoadKernels<T>& kernels, PolygonColumns& to) {
    for (std::size_t k = count; k % most_lanes != 0; ++k) {
      rows_[k] = rows_[count - 1], poses_[k] = poses_[count - 1];
      counts_[k] = counts_[count - 1], radii_[k] = radii_[count - 1];
    }
    to.most = *std::max_element(counts_, counts_ + count);
    for (std::size_t k = 0; k < block_pairs; ++k) to.count[k] = double(counts_[k]), to.radius[k] = radii_[k];
    kernels.poses(poses_, count, to.pose);
    if constexpr (std::is_same_v<T, float>)
      polygon_kernels().load_of_float(rows_, count, to);
    else
      polygon_kernels().load_of_double(rows_, count, to);
  }

 private:
  static constexpr std::size_t most_lanes = 16;

  std::size_t put(std::size_t k, const std::array<Vec2<T>, lane_vertices>& vertices, std::size_t count, double radius) {
    own_[k] = vertices;
    rows_[k] = own_[k].data();
    radii_[k] = radius;
    return count;
  }
  std::size_t take_vertices(std::size_t kind, const void* shape, std::size_t k) {
    if (kind == detail::kind_of<ConvexPolygon<T>, T>()) {
      const std::span<const Vec2<T>> vertices = static_cast<const ConvexPolygon<T>*>(shape)->vertices();
      if (vertices.size() > lane_vertices) return 0;
      rows_[k] = vertices.data();
      radii_[k] = 0;
      return vertices.size();
    }
    if (kind == detail::kind_of<Box<T>, T>()) {
      const Vec2<T> h = static_cast<const Box<T>*>(shape)->half_extents();
      return put(k, {-h, {h.x, -h.y}, h, {-h.x, h.y}}, 4, 0);
    }
    if (kind == detail::kind_of<Capsule<T>, T>()) {
      const auto& c = *static_cast<const Capsule<T>*>(shape);
      if (c.tapered()) return 0;
      return put(k, {Vec2<T>{T(0), -c.half_height()}, {T(0), c.half_height()}}, 2, double(c.radius_top()));
    }
    if (kind == detail::kind_of<Segment<T>, T>()) {
      const auto& s = *static_cast<const Segment<T>*>(shape);
      return put(k, {s.a(), s.b()}, 2, 0);
    }
    if (kind == detail::kind_of<Circle<T>, T>())
      return put(k, {}, 1, double(static_cast<const Circle<T>*>(shape)->radius()));
    return 0;
  }

  std::array<Vec2<T>, lane_vertices> own_[block_pairs];  ///< of shapes that hold no vertices
  const Vec2<T>* rows_[block_pairs];
  const Pose2<T>* poses_[block_pairs];
  std::size_t counts_[block_pairs] = {};
  double radii_[block_pairs] = {};
};

template <class T>
class PolygonQueue {
 public:
  /// Takes a pair of polygons that the kernels take, one of them with an inside, and returns whether the i-th is such.
  bool take(const Batch<T>& batch, std::size_t i) {
    const IdPair p = batch[i];
    const std::size_t a = a_.take(batch.a(), p.a, count_), b = a == 0 ? 0 : b_.take(batch.b(), p.b, count_);
    if (b == 0 || (a < 3 && b < 3)) return false;
    place_[count_++] = static_cast<std::uint32_t>(i);
    return true;
  }
  std::size_t count() const { return count_; }
  const std::uint32_t* place() const { return place_; }
  /// The columns of all pairs that wait. The queue is empty afterwards.
  const PolygonBlock& load(const LoadKernels<T>& kernels) {
    a_.load(count_, kernels, block_.a);
    b_.load(count_, kernels, block_.b);
    count_ = 0;
    return block_;
  }

 private:
  std::size_t count_ = 0;
  QueuedPolygons<T> a_, b_;
  std::uint32_t place_[block_pairs];
  PolygonBlock block_;
};

}  // namespace graze::plane
