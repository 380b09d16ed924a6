// Streams of rays at a surface of triangles, all in flight at once (see `ray_stream.hpp`). Only for `*.kernel.cpp`.
//
// Guarantee: that of `ray_stream.hpp`. Everything is inlined or lives in the namespace of the level.
#pragma once

#include "rays/bvh_lanes.hpp"
#include "rays/ray_lanes.hpp"
#include "rays/ray_triangle.hpp"

namespace graze::GRAZE_ISA::ray_streams {

using namespace tree;
using namespace ray_lanes;

/// Rays in flight at once: enough to hide memory latency, few enough to stay in the nearest cache themselves. 32 in
/// place of 64 take 3 to 10 % longer, and half of some 60 KB of stack, which small machines have little of.
inline constexpr std::size_t stream_size = register_bytes >= 32 ? 64 : 32;
using Numbers = double[stream_size];

/// Rays that wait for the same step.
struct List {
  std::uint8_t ray[stream_size + 1];
  std::size_t count = 0;
  /// Writes in any case, keeps if `really`.
  [[gnu::always_inline]] void add(std::size_t i, bool really) {
    ray[count] = static_cast<std::uint8_t>(i);
    count += really;
  }
};

/// Many rays at one surface. `Surface` is a hierarchy of triangles:
///   Scalar, Ref (a node), Leaf, Piece (a triangle), children (most of a node), most (most triangles of a leaf);
///   deep: a ray with this many nodes waiting is cast alone
///   question: its `extent`, `radius`, `center`, `both_sides` and `any` are those of `BlockMesh`
///   root(), open(bvh_ray, ref, limit): the keys of a node's children
///   go(ref, leaf, place): moves from a node to a child, true for a node; prefetches the child's data
///   each(bvh_ray, ref, leaf, add): calls add(piece, really) for the triangles of a leaf that may be crossed
///   prefetch(piece): prefetches its corners
///   triangle(piece): coordinates of a triangle by (corner, axis); number(piece): its number
template <class Surface>
class RayStream {
  using T = typename Surface::Scalar;
  using Ref = typename Surface::Ref;
  using Leaf = typename Surface::Leaf;
  using Piece = typename Surface::Piece;
  using Keys = KeysOf<Surface::children>;

 public:
  [[gnu::always_inline]] RayStream(rays::RayBlock& block, std::size_t first, std::size_t count, const Surface& surface,
                                   std::uint32_t* pieces)
      : block_(block), first_(first), count_(count), surface_(surface), pieces_(pieces + first) {}

  [[gnu::always_inline]] void cast() {
    for (std::size_t i = 0; i < count_; i += step) enter(i);
    begin();
    while (inner_.count + leaf_.count + back_.count > 0) {
      come_back();
      open_nodes();
      open_leaves();
    }
    if (surface_.question.any) return;
    for (std::size_t i = 0; i < count_; i += step) leave(i);
  }

 private:
  /// The state of a ray.
  struct Ray {
    BvhRay<T> bvh_ray;
    float limit;
    Ref node;  ///< node that the ray is at
    Leaf leaf;
    std::size_t waiting;  ///< nodes to come back to
  };
  /// A ray with the names of `BvhQuestion`, for the constructor of `BvhRay`.
  struct Line {
    double extent, radius, origin[3], direction[3], begin, end;
  };
  struct Candidate {
    Piece piece;
    std::uint8_t ray;
  };

  /// Prepares rays: `recentered`, `RayAlignedFrame` and the beginning of `cast_at_surface`, for lanes.
  [[gnu::always_inline]] void enter(std::size_t i) {
    const V direction = load_vec3<S>(block_.direction, first_ + i), center = broadcast<S>(surface_.question.center);
    V origin = load_vec3<S>(block_.origin, first_ + i);
    const S end = S::load(block_.end + first_ + i);
    const S shift = greatest(dot(center - origin, direction), S(0));
    origin = origin + direction * shift;
    const V to = center - origin;
    const S reach = S(surface_.question.radius) + greatest(dot(to, direction), S(0));
    const M aimed = (end >= S(0)) & (dot(to, to) <= reach * reach);
    store(origin, origin_, i);
    shift.store(shift_ + i);
    rays::end_from(shift, end).store(end_ + i);
    reach.store(reach_ + i);
    select(aimed, S(rays::ray_hit), S(rays::ray_missed)).store(block_.state + first_ + i);

    const rays::RayAlignedFrame<S> frame({origin, direction, S(0), S(0), S(0)});
    store(frame.shear(), shear_, i);
    store(frame.order()(origin), ordered_origin_, i);
    store(frame.order()(V{S(0), S(1), S(2)}), axis_, i);
  }

  [[gnu::always_inline]] void begin() {
    for (std::size_t i = 0; i < (count_ + step - 1) / step * step; ++i) {
      double& state = block_.state[first_ + i];
      const bool aimed = i < count_ && state != rays::ray_missed;
      state = rays::ray_missed;
      if (!aimed) continue;
      best_[i] = rays::infinity;
      const std::size_t at = first_ + i;
      const Line line{surface_.question.extent,
                      reach_[i],
                      {origin_[0][i], origin_[1][i], origin_[2][i]},
                      {block_.direction[0][at], block_.direction[1][at], block_.direction[2][at]},
                      -shift_[i],
                      end_[i]};
      Ray& ray = rays_[i];
      ray.bvh_ray = BvhRay<T>(line);
      ray.limit = ray.bvh_ray.key(line.end);
      ray.node = surface_.root();
      ray.waiting = 0;
      inner_.add(i, true);
    }
  }

  /// Moves the ray on to the nearest of those children, if there is any; the others wait.
  [[gnu::always_inline]] void choose(std::size_t i, const Ref& at, Keys keys) {
    Ray& ray = rays_[i];
    const std::uint32_t alive = keys.up_to(number_bits(ray.limit) | Keys::place_bits);
    const std::int32_t key = keys.least();
    const bool some = alive != 0;
    ray.node = at;
    const bool is_inner = surface_.go(ray.node, ray.leaf, static_cast<std::uint32_t>(key & Keys::place_bits));
    keys.remove(key);
    keys.store(keys_[i][ray.waiting]);
    waiting_[i][ray.waiting] = at;
    const std::size_t more = (alive & (alive - 1)) != 0;
    if (ray.waiting + more >= Surface::deep) [[unlikely]] {
      block_.state[first_ + i] = rays::ray_again;
      return;
    }
    ray.waiting += more;
    inner_.add(i, some & is_inner);
    leaf_.add(i, some & !is_inner);
    back_.add(i, !some & (ray.waiting > 0));
  }

  [[gnu::always_inline]] void come_back() {
    List list = back_;
    back_.count = 0;
    for (std::size_t k = 0; k < list.count; ++k) {
      const std::size_t i = list.ray[k];
      const std::size_t top = --rays_[i].waiting;
      Keys keys;
      keys.load(keys_[i][top]);
      const Ref at = waiting_[i][top];
      choose(i, at, keys);
    }
  }

  [[gnu::always_inline]] void open_nodes() {
    List list = inner_;
    inner_.count = 0;
    for (std::size_t k = 0; k < list.count; ++k) {
      const std::size_t i = list.ray[k];
      const Ray& ray = rays_[i];
      const Ref at = ray.node;
      choose(i, at, surface_.open(ray.bvh_ray, at, ray.limit));
    }
  }

  [[gnu::always_inline]] void open_leaves() {
    std::size_t candidates = 0;
    for (std::size_t k = 0; k < leaf_.count; ++k) {
      const std::size_t i = leaf_.ray[k];
      const Ray& ray = rays_[i];
      surface_.each(
          ray.bvh_ray, ray.node, ray.leaf, [&](const Piece& piece, bool really) __attribute__((always_inline)) {
            candidates_[candidates] = {piece, static_cast<std::uint8_t>(i)};
            candidates += really;
          });
    }
    for (std::size_t k = 0; k < candidates; ++k) surface_.prefetch(candidates_[k].piece);
    for (std::size_t k = 0; k < candidates; k += step) test(k, candidates);
    for (std::size_t k = 0; k < leaf_.count; ++k) {
      const std::size_t i = leaf_.ray[k];
      back_.add(i, rays_[i].waiting > 0);
    }
    leaf_.count = 0;
  }

  /// Tests candidates: `TriangleCast` for lanes.
  [[gnu::always_inline]] void test(std::size_t at, std::size_t end) {
    double corner[3][3][step], origin[3][step], shear[3][step], from[step], to[step];
    for (std::size_t lane = 0; lane < step; ++lane) {
      const Candidate& c = candidates_[at + lane < end ? at + lane : end - 1];
      const auto triangle = surface_.triangle(c.piece);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis_[axis][c.ray]);
        for (std::size_t k = 0; k < 3; ++k) corner[k][axis][lane] = static_cast<double>(triangle(k, place));
        origin[axis][lane] = ordered_origin_[axis][c.ray];
        shear[axis][lane] = shear_[axis][c.ray];
      }
      from[lane] = -shift_[c.ray];
      to[lane] = end_[c.ray];
    }
    const V o = load_vec3<S>(origin, 0), slope = load_vec3<S>(shear, 0);
    V p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = rays::RayAlignedFrame<S>::sheared(load_vec3<S>(corner[k], 0) - o, slope);
    const rays::LineCrossing<S> crossing = rays::line_crossing(p[0], p[1], p[2]);
    const S& t = crossing.t;
    M met = crossing.through & (t >= S::load(from)) & (t <= S::load(to));
    if (!surface_.question.both_sides) met = met & (crossing.whole > S(0));
    double state[step], place[step];
    select(crossing.edge_on, S(rays::ray_again), select(met, S(rays::ray_hit), S(rays::ray_missed))).store(state);
    t.store(place);
    for (std::size_t lane = 0; lane < step && at + lane < end; ++lane)
      if (state[lane] != rays::ray_missed) keep(candidates_[at + lane], state[lane], place[lane]);
  }

  [[gnu::always_inline]] void keep(const Candidate& c, double state, double t) {
    Ray& ray = rays_[c.ray];
    double& known = block_.state[first_ + c.ray];
    if (known == rays::ray_again) return;
    known = state;
    if (state == rays::ray_again || surface_.question.any) {
      ray.waiting = 0;
      return;
    }
    const double shift = shift_[c.ray], along = t + shift;
    double& best = best_[c.ray];
    Candidate& nearest = nearest_[c.ray];
    if (!(along < best || (along == best && number(c) < number(nearest)))) return;
    best = along;
    nearest = c;
    best_local_[c.ray] = t;
    const float limit = ray.bvh_ray.key(rays::end_after(along, shift));
    ray.limit = limit < ray.limit ? limit : ray.limit;
  }

  [[gnu::always_inline]] std::uint32_t number(const Candidate& c) const { return surface_.number(c.piece); }

  /// Writes the hits, as `TriangleCast` returns them.
  [[gnu::always_inline]] void leave(std::size_t i) {
    double corner[3][3][step] = {}, t[step] = {}, along[step] = {};
    for (std::size_t lane = 0; lane < step; ++lane) {
      if (block_.state[first_ + i + lane] != rays::ray_hit) continue;
      const Candidate& c = nearest_[i + lane];
      pieces_[i + lane] = number(c);
      const auto triangle = surface_.triangle(c.piece);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t axis = 0; axis < 3; ++axis) corner[k][axis][lane] = static_cast<double>(triangle(k, axis));
      t[lane] = best_local_[i + lane];
      along[lane] = best_[i + lane];
    }
    const V a = load_vec3<S>(corner[0], 0), b = load_vec3<S>(corner[1], 0), c = load_vec3<S>(corner[2], 0);
    const V direction = load_vec3<S>(block_.direction, first_ + i);
    const V normal = normalized(cross(b - a, c - a), -direction);
    store(select(dot(normal, direction) > S(0), -normal, normal), block_.normal, first_ + i);
    store(load_vec3<S>(origin_, i) + direction * S::load(t), block_.point, first_ + i);
    S::load(along).store(block_.t + first_ + i);
  }

  rays::RayBlock& block_;
  std::size_t first_, count_;
  const Surface& surface_;
  std::uint32_t* pieces_;
  // In order: the ray from near the surface, and its frame for the triangles.
  Numbers origin_[3], shift_, end_, reach_, ordered_origin_[3], shear_[3], axis_[3];
  // The first hit so far: along the caller's ray, along the near one, and the triangle.
  Numbers best_, best_local_;
  Candidate nearest_[stream_size];
  Ray rays_[stream_size];
  float keys_[stream_size][Surface::deep][Surface::children];
  Ref waiting_[stream_size][Surface::deep];
  List inner_, leaf_, back_;
  Candidate candidates_[Surface::most * stream_size + 1];
};

template <class Surface>
[[gnu::always_inline]] inline void cast_block(rays::RayBlock& block, std::size_t count, const Surface& surface,
                                              std::uint32_t* pieces) {
  for (std::size_t first = 0; first < count; first += stream_size)
    RayStream<Surface>(block, first, count - first < stream_size ? count - first : stream_size, surface, pieces).cast();
}

}  // namespace graze::GRAZE_ISA::ray_streams
