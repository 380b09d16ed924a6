// Overlap tests of pairs of any simple cores, a register of float's at a time.
#include "narrow/gjk/mpr.hpp"

#include "narrow/batch/row_bundle.hpp"
#include "narrow/gjk/mpr_pairs.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<float>;

[[gnu::always_inline]] inline Vec3<S> vector_from(const PortalPairs::Column* columns, std::size_t first) {
  return {S::load(columns[0] + first), S::load(columns[1] + first), S::load(columns[2] + first)};
}
/// Rotations to float's precision, whatever the length of the given quaternions.
[[gnu::always_inline]] inline Quat<S> turn_from(const PortalPairs::Column* columns, std::size_t first) {
  const Vec3<S> v = vector_from(columns, first);
  const S w = S::load(columns[3] + first), share = S(1) / sqrt(length_squared(v) + w * w);
  return {v.x * share, v.y * share, v.z * share, w * share};
}

/// A side's core in lanes. The vertices of hulls are written to `vertices`.
template <PortalSide side>
[[gnu::always_inline]] inline auto core_from(const PortalPairs::Column* columns, std::size_t first, std::size_t most,
                                             Vec3<S>* vertices) {
  if constexpr (side == PortalSide::hull) {
    for (std::size_t k = 0; k < most; ++k) vertices[k] = vector_from(columns + 3 * k, first);
    return PortalHull<S>{vertices, most};
  } else {
    const Vec3<S> p = vector_from(columns, first), q = vector_from(columns + 3, first);
    if constexpr (side == PortalSide::points) {
      return PortalPoints<S>{{p, q, vector_from(columns + 6, first)}};
    } else {
      const S widest = max_abs(q), share = select(widest > S(0), S(1) / widest, S(0));
      return PortalSum<S>{p, q, S::load(columns[6] + first) * share, S::load(columns[7] + first) * share};
    }
  }
}

}  // namespace

template <PortalSide A, PortalSide B>
[[gnu::flatten]] void mpr_overlaps(const PortalPairs& pairs, std::size_t count, std::uint8_t* touch) {
  Vec3<S> vertices_a[most_portal_points], vertices_b[most_portal_points];
  for (std::size_t first = 0; first < count; first += S::lanes) {
    auto a = core_from<A>(pairs.column + PortalPairs::of_a, first, pairs.vertices_a.most, vertices_a);
    auto b = core_from<B>(pairs.column + PortalPairs::of_b, first, pairs.vertices_b.most, vertices_b);
    S reach = S::load(pairs.column[PortalPairs::reach] + first);
    const S unit = S(1) / (a.size() + b.size() + reach);
    a.scale(unit);
    b.scale(unit);
    reach *= unit;
    const Quat<S> back = conjugate(turn_from(pairs.column + PortalPairs::turn_a, first)),
                  turn = turn_from(pairs.column + PortalPairs::turn_b, first);
    const PortalDifference<decltype(a), decltype(b), S> difference{
        a,
        b,
        rotation_matrix(back * turn),
        rotate(back, vector_from(pairs.column + PortalPairs::way, first) * unit),
        reach,
        any(reach > S(0))};
    const PortalAnswer<S> answer = portal_overlap<S>(difference);
    put_bytes<float>((answer.touching.bits & 1) | (~(answer.touching.bits | answer.apart.bits) & 2),
                     least(static_cast<std::size_t>(S::lanes), count - first), touch + first);
  }
}

template void mpr_overlaps<PortalSide::sum, PortalSide::sum>(const PortalPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<PortalSide::sum, PortalSide::points>(const PortalPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<PortalSide::sum, PortalSide::hull>(const PortalPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<PortalSide::points, PortalSide::points>(const PortalPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<PortalSide::points, PortalSide::hull>(const PortalPairs&, std::size_t, std::uint8_t*);
template void mpr_overlaps<PortalSide::hull, PortalSide::hull>(const PortalPairs&, std::size_t, std::uint8_t*);

}  // namespace graze::GRAZE_ISA
