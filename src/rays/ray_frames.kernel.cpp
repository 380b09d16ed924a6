// Transforms of rays into the frame of a shape and of hits out of it.
#include "rays/lane_vec3.hpp"
#include "rays/ray_rows.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
using V = Vec3<S>;
constexpr auto step = static_cast<std::size_t>(S::lanes);
static_assert(rays::RayBlock::size % step == 0);

/// A frame's rotation, the same in all lanes.
struct Rotation {
  V row[3];
  [[gnu::always_inline]] explicit Rotation(const rays::BlockFrame& frame)
      : row{broadcast<S>(frame.rotation[0]), broadcast<S>(frame.rotation[1]), broadcast<S>(frame.rotation[2])} {}
  [[gnu::always_inline]] V out(const V& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
  [[gnu::always_inline]] V in(const V& v) const { return row[0] * v.x + row[1] * v.y + row[2] * v.z; }
};

}  // namespace

template <class T>
void block_to_local(rays::RayBlock& block, const T* rays, std::size_t count, double end,
                    const rays::BlockFrame& frame) {
  constexpr bool single = sizeof(T) == 4;
  constexpr double epsilon = single ? 0x1p-23 : 0x1p-52;
  // Values of `longest` and `end_of` for one ray.
  constexpr double longest = single ? 1e37 : 1e150, most = 1.7976931348623157e308;
  const Rotation rotation(frame);
  const S zero(0), one(1);
  const V translation = broadcast<S>(frame.translation);
  read_rays(rays, count, block);
  for (std::size_t i = 0; i < filled(count); i += step) {
    // NaN compares as false.
    const auto within = [](const V& v, double limit) __attribute__((always_inline)) {
      const S l(limit);
      return (abs(v.x) <= l) & (abs(v.y) <= l) & (abs(v.z) <= l);
    };
    const V from = load_vec3<S>(block.origin, i), to = load_vec3<S>(block.along, i);
    const auto usable = within(from, longest) & within(to, most) & ((to.x != zero) | (to.y != zero) | (to.z != zero));
    const V along = select(usable, to, V{zero, one, zero});
    const V safe = single ? along : along / max_abs(along);
    const V origin = rotation.in(select(usable, from, V{zero, zero, zero}) - translation);
    select(usable, S(end), S(-1)).store(block.end + i);
    store(along, block.along, i);
    store(origin, block.origin, i);
    store(rotation.in(safe * (one / length(safe))), block.direction, i);
    (S(4 * epsilon) * length(origin)).store(block.blur + i);
  }
}

template <class T>
void block_to_world(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame, T length,
                    rays::BlockHits<T>& hits) {
  using Narrow = Wide<T, S::lanes>;
  const auto narrowed = [](const S& s) __attribute__((always_inline)) {
    return Narrow::of(__builtin_convertvector(s.v, typename Narrow::Vector));
  };
  const auto all_narrowed = [&](const V& v) __attribute__((always_inline)) {
    return Vec3<Narrow>{narrowed(v.x), narrowed(v.y), narrowed(v.z)};
  };
  const Rotation rotation(frame);
  const V translation = broadcast<S>(frame.translation);
  for (std::size_t i = 0; i < count; i += step) {
    const V normal = rotation.out(load_vec3<S>(block.normal, i));
    const auto turned = dot(normal, load_vec3<S>(block.along, i)) > S(0);
    const S state = S::load(block.state + i);
    select(turned & (state == S(rays::ray_hit)), S(rays::ray_again), state).store(block.state + i);
    store(all_narrowed(normal), hits.normal, i);
    store(all_narrowed(translation + rotation.out(load_vec3<S>(block.point, i))), hits.point, i);
    least(narrowed(S::load(block.t + i)), Narrow(length)).store(hits.t + i);
  }
}

template void block_to_local(rays::RayBlock&, const float*, std::size_t, double, const rays::BlockFrame&);
template void block_to_local(rays::RayBlock&, const double*, std::size_t, double, const rays::BlockFrame&);
template void block_to_world(rays::RayBlock&, std::size_t, const rays::BlockFrame&, float, rays::BlockHits<float>&);
template void block_to_world(rays::RayBlock&, std::size_t, const rays::BlockFrame&, double, rays::BlockHits<double>&);

}  // namespace graze::GRAZE_ISA
