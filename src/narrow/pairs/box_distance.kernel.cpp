#include "narrow/pairs/box_distance.hpp"

#include "narrow/pair_bundle.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;

template <std::size_t part, class L>
[[gnu::always_inline]] inline Vec3<S> vector_in_double(const Vec3<L>& v) {
  return {in_double<part>(v.x), in_double<part>(v.y), in_double<part>(v.z)};
}
template <std::size_t part, class L>
[[gnu::always_inline]] inline PlacedBox<S> placed(const Vec3<L>& half, const Pose<L>& pose) {
  const Quat<L>& q = pose.rotation;
  return {vector_in_double<part>(half),
          S(0),
          {vector_in_double<part>(pose.translation),
           {in_double<part>(q.x), in_double<part>(q.y), in_double<part>(q.z), in_double<part>(q.w)}}};
}

/// Compiled once for both scalars.
[[gnu::noinline, gnu::flatten]] void answer(const PlacedBox<S>& a, const PlacedBox<S>& b, BoxDistance<S>& found) {
  found = box_distance(a, b);
}

/// Answers for as many pairs of a bundle as a register holds in double.
template <std::size_t part, class T>
[[gnu::always_inline]] inline void find(const PairBundle<Box<T>, Box<T>, T>& p, Distance<T>* distances,
                                        std::uint8_t* proven) {
  constexpr std::size_t lanes = lanes_of<double>, first = part * lanes;
  if (p.count <= first) return;
  const std::size_t count = p.count - first < lanes ? p.count - first : lanes;
  BoxDistance<S> found;
  answer(placed<part>(p.a.core.half, p.pose_a), placed<part>(p.b.core.half, p.pose_b), found);
  put(found.at, count, distances + first);
  for (std::size_t i = 0; i < count; ++i) proven[first + i] = found.proven[static_cast<int>(i)];
}

}  // namespace

template <class T>
[[gnu::flatten]] void box_distances(const PairRef<T>* pairs, std::size_t count, Distance<T>* distances,
                                    std::uint8_t* proven) {
  using Pairs = PairBundle<Box<T>, Box<T>, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    find<0>(p, distances + first, proven + first);
    if constexpr (sizeof(T) == 4) find<1>(p, distances + first, proven + first);
  }
}

template void box_distances(const PairRef<float>*, std::size_t, Distance<float>*, std::uint8_t*);
template void box_distances(const PairRef<double>*, std::size_t, Distance<double>*, std::uint8_t*);

}  // namespace graze::GRAZE_ISA
