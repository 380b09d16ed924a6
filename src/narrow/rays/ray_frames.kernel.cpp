// The way of rays into the frame of a shape and of hits out of it.
#include "narrow/rays/lane_vec3.hpp"
#include "narrow/rays/ray_block.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
using V = Lane3<S>;
constexpr auto step = static_cast<std::size_t>(S::lanes);
static_assert(rays::RayBlock::size % step == 0);

/// A frame's rotation, the same in all lanes.
struct Rotation {
  V vector;
  S w;
  [[gnu::always_inline]] explicit Rotation(const rays::BlockFrame& frame)
      : vector{S(frame.rotation[0]), S(frame.rotation[1]), S(frame.rotation[2])}, w(frame.rotation[3]) {}
};

}  // namespace

template <class T>
void block_to_local(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame) {
  constexpr bool single = sizeof(T) == 4;
  constexpr double epsilon = single ? 0x1p-23 : 0x1p-52;
  const Rotation forward(frame);
  const V back = -forward.vector, translation = V::all(frame.translation);
  for (std::size_t i = 0; i < count; i += step) {
    const V along = V::load(block.along, i);
    const V safe = single ? along : along / max_abs(along);
    const V origin = rotate(back, forward.w, V::load(block.from, i) - translation);
    origin.store(block.origin, i);
    normalized(rotate(back, forward.w, safe), V{S(0), S(1), S(0)}).store(block.direction, i);
    (S(4 * epsilon) * length(origin)).store(block.blur + i);
  }
}

template <class T>
void block_to_world(rays::RayBlock& block, std::size_t count, const rays::BlockFrame& frame) {
  using Narrow = Wide<T, S::lanes>;
  const auto narrowed = [](const S& s) __attribute__((always_inline)) {
    return Narrow::of(__builtin_convertvector(s.v, typename Narrow::Vector));
  };
  const auto widened = [](const Narrow& n) __attribute__((always_inline)) {
    return S::of(__builtin_convertvector(n.v, S::Vector));
  };
  const Rotation rotation(frame);
  const V translation = V::all(frame.translation);
  for (std::size_t i = 0; i < count; i += step) {
    const V normal = rotate(rotation.vector, rotation.w, V::load(block.normal, i));
    const auto turned = dot(normal, V::load(block.along, i)) > S(0);
    for (int k = 0; k < S::lanes; ++k) {
      std::uint8_t& state = block.state[i + static_cast<std::size_t>(k)];
      state = turned[k] && state == rays::ray_hit ? static_cast<std::uint8_t>(rays::ray_again) : state;
    }
    const Lane3<Narrow> n = normalized(Lane3<Narrow>{narrowed(normal.x), narrowed(normal.y), narrowed(normal.z)},
                                       Lane3<Narrow>{Narrow(T(0)), Narrow(T(1)), Narrow(T(0))});
    V{widened(n.x), widened(n.y), widened(n.z)}.store(block.world_normal, i);
    (translation + rotate(rotation.vector, rotation.w, V::load(block.point, i))).store(block.world_point, i);
  }
}

template void block_to_local<float>(rays::RayBlock&, std::size_t, const rays::BlockFrame&);
template void block_to_local<double>(rays::RayBlock&, std::size_t, const rays::BlockFrame&);
template void block_to_world<float>(rays::RayBlock&, std::size_t, const rays::BlockFrame&);
template void block_to_world<double>(rays::RayBlock&, std::size_t, const rays::BlockFrame&);

}  // namespace graze::GRAZE_ISA
