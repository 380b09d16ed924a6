// The distances of pairs in rows: spheres, capsules, balls with boxes, and all of these and triangles with half-spaces.
#include "narrow/batch/row_answers.hpp"
#include "narrow/pairs/row_distance.hpp"

namespace graze::GRAZE_ISA {

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t row_distances(const PairRows<T>& rows, std::size_t count, bool turned,
                                             Distance<T>* distances, std::uint8_t* unknown) {
  const auto write = [=](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const CoreDistance<Lanes<T>> found = distance_of(pairs);
    put(turned ? mirrored(found) : found, filled, distances + first);
    return pairs.regular();
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

#define GRAZE_INSTANTIATE_FOR(A, B, T)                                                                                 \
  template std::uint32_t row_distances<A<T>, B<T>>(const PairRows<T>&, std::size_t, bool, Distance<T>*, std::uint8_t*);
#define GRAZE_INSTANTIATE(A, B)                                                                                        \
  GRAZE_INSTANTIATE_FOR(A, B, float)                                                                                   \
  GRAZE_INSTANTIATE_FOR(A, B, double)
GRAZE_FOR_ROUND_PAIRS(GRAZE_INSTANTIATE)
GRAZE_INSTANTIATE(Sphere, HalfSpace)
GRAZE_INSTANTIATE(Capsule, HalfSpace)
GRAZE_INSTANTIATE(Box, HalfSpace)
GRAZE_INSTANTIATE(Triangle, HalfSpace)
#undef GRAZE_INSTANTIATE
#undef GRAZE_INSTANTIATE_FOR

}  // namespace graze::GRAZE_ISA
