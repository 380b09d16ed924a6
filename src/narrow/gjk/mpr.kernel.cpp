// Overlap tests of pairs of any simple cores, a register of float's at a time.
#include "narrow/gjk/mpr.hpp"

#include "narrow/batch/row_bundle.hpp"
#include "narrow/gjk/mpr_pairs.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<float>;

[[gnu::always_inline]] inline Vec3<S> vector_from(const MprPairs::Column* columns, std::size_t first) {
  return {S::load(columns[0] + first), S::load(columns[1] + first), S::load(columns[2] + first)};
}
/// Rotations to float's precision, whatever the length of the given quaternions.
[[gnu::always_inline]] inline Quat<S> turn_from(const MprPairs::Column* columns, std::size_t first) {
  const Vec3<S> v = vector_from(columns, first);
  const S w = S::load(columns[3] + first), share = S(1) / sqrt(length_squared(v) + w * w);
  return {v.x * share, v.y * share, v.z * share, w * share};
}

/// A side's core in lanes. The vertices of hulls are written to `vertices`.
template <MprShape side>
[[gnu::always_inline]] inline auto core_from(const MprPairs::Column* columns, std::size_t first, std::size_t most,
                                             Vec3<S>* vertices) {
  if constexpr (side == MprShape::hull) {
    for (std::size_t k = 0; k < most; ++k) vertices[k] = vector_from(columns + 3 * k, first);
    return MprHull<S>{vertices, most};
  } else {
    const Vec3<S> p = vector_from(columns, first), q = vector_from(columns + 3, first);
    if constexpr (side == MprShape::points) {
      return MprPoints<S>{{p, q, vector_from(columns + 6, first)}};
    } else {
      const S widest = max_abs(q), share = select(widest > S(0), S(1) / widest, S(0));
      return MprSum<S>{p, q, S::load(columns[6] + first) * share, S::load(columns[7] + first) * share};
    }
  }
}

}  // namespace

template <MprShape A, MprShape B>
[[gnu::flatten]] void mpr_overlaps(const MprPairs& pairs, std::size_t count, std::uint8_t* touch) {
  Vec3<S> vertices_a[most_mpr_points], vertices_b[most_mpr_points];
  for (std::size_t first = 0; first < count; first += S::lanes) {
    auto a = core_from<A>(pairs.column + MprPairs::of_a, first, pairs.vertices_a.most, vertices_a);
    auto b = core_from<B>(pairs.column + MprPairs::of_b, first, pairs.vertices_b.most, vertices_b);
    S reach = S::load(pairs.column[MprPairs::reach] + first);
    const S unit = S(1) / (a.size() + b.size() + reach);
    a.scale(unit);
    b.scale(unit);
    reach *= unit;
    const Quat<S> back = conjugate(turn_from(pairs.column + MprPairs::turn_a, first)),
                  turn = turn_from(pairs.column + MprPairs::turn_b, first);
    const MprDifference<decltype(a), decltype(b), S> difference{
        a,
        b,
        rotation_matrix(back * turn),
        rotate(back, vector_from(pairs.column + MprPairs::way, first) * unit),
        reach,
        any(reach > S(0))};
    const MprAnswer<S> answer = mpr_overlap<S>(difference);
    put_bytes<float>((answer.touching.bits & 1) | (~(answer.touching.bits | answer.apart.bits) & 2),
                     least(static_cast<std::size_t>(S::lanes), count - first), touch + first);
  }
}

template void mpr_overlaps<MprShape::sum, MprShape::sum>(const MprPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<MprShape::sum, MprShape::points>(const MprPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<MprShape::sum, MprShape::hull>(const MprPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<MprShape::points, MprShape::points>(const MprPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<MprShape::points, MprShape::hull>(const MprPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<MprShape::hull, MprShape::hull>(const MprPairs&, std::size_t, std::uint8_t*);

}  // namespace graze::GRAZE_ISA
