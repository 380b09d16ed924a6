// Boxes, and capsules as boxes that are only long, a register of pairs at a time in double.
#include "narrow/pair_bundle.hpp"
#include "narrow/pairs/capsule_box_contact.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;

template <std::size_t part, class L>
[[gnu::always_inline]] inline Vec3<S> vector_in_double(const Vec3<L>& v) {
  return {lanes_in_double<part>(v.x), lanes_in_double<part>(v.y), lanes_in_double<part>(v.z)};
}
template <std::size_t part, class L>
[[gnu::always_inline]] inline PlacedBox<S> in_double(const PlacedBox<L>& box) {
  const Quat<L>& q = box.pose.rotation;
  return {vector_in_double<part>(box.half),
          lanes_in_double<part>(box.radius),
          {vector_in_double<part>(box.pose.translation),
           {lanes_in_double<part>(q.x), lanes_in_double<part>(q.y), lanes_in_double<part>(q.z),
            lanes_in_double<part>(q.w)}}};
}

/// Compiled once for all.
[[gnu::noinline, gnu::flatten]] void answer(const PlacedBox<S>& a, const PlacedBox<S>& b, BoxDistance<S>& found) {
  found = box_distance(a, b);
}

/// As many pairs of a bundle as a register holds in double, with their distances.
struct Part {
  std::size_t first, count;
  PlacedBox<S> a, b;
  BoxDistance<S> found;
};
template <std::size_t part, class Pairs, class F>
[[gnu::always_inline]] inline void visit_part(const Pairs& p, const F& f) {
  constexpr std::size_t lanes = lanes_of<double>, first = part * lanes;
  if (p.count <= first) return;
  Part of{first,
          p.count - first < lanes ? p.count - first : lanes,
          in_double<part>(placed_box(p.a, p.pose_a)),
          in_double<part>(placed_box(p.b, p.pose_b)),
          {}};
  answer(of.a, of.b, of.found);
  f(of, lanes_in_double<part>(p.margin));
}

/// Calls `f(part, margins, number of its first pair)`.
template <class A, class B, class T, class F>
[[gnu::always_inline]] inline void visit_parts(const PairRef<T>* pairs, std::size_t count, const F& f) {
  using Pairs = PairBundle<A, B, T>;
  for (std::size_t begin = 0; begin < count; begin += Pairs::lanes) {
    const Pairs p(pairs + begin, count - begin);
    const auto placed = [&](const Part& part, const S& margin) { f(part, margin, begin + part.first); };
    visit_part<0>(p, placed);
    if constexpr (sizeof(T) == 4) visit_part<1>(p, placed);
  }
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] void box_distances(const PairRef<T>* pairs, std::size_t count, Distance<T>* distances,
                                    std::uint8_t* proven) {
  visit_parts<A, B>(pairs, count, [&](const Part& part, const S&, std::size_t begin) {
    put(part.found.at, part.count, distances + begin);
    for (std::size_t k = 0; k < part.count; ++k) proven[begin + k] = part.found.proven[static_cast<int>(k)];
  });
}

template <class T>
[[gnu::flatten]] void capsule_box_contacts(const PairRef<T>* pairs, std::size_t count, PointContact<T>* contacts,
                                           Meeting* meetings) {
  visit_parts<Capsule<T>, Box<T>>(pairs, count, [&](const Part& part, const S& margin, std::size_t begin) {
    const RoundContact<S> c = capsule_box_contact(part.a, part.b, part.found, before_rounding<T>(margin));
    const S place = feature_place(c);
    for (std::size_t k = 0; k < part.count; ++k) {
      const int i = static_cast<int>(k);
      const T distance = static_cast<T>(c.at.distance[i]);
      contacts[begin + k] = {{lane<T>(c.at.a, i), lane<T>(c.at.b, i), distance,
                              ids_with_box.of[static_cast<std::size_t>(place[i])], T(0.5)},
                             lane<T>(c.at.normal, i)};
      meetings[begin + k] = c.known[i] == 0                       ? Meeting::unknown
                            : distance <= pairs[begin + k].margin ? Meeting::touching
                                                                  : Meeting::apart;
    }
  });
}

#define GRAZE_INSTANTIATE(A, T)                                                                                        \
  template void box_distances<A<T>, Box<T>>(const PairRef<T>*, std::size_t, Distance<T>*, std::uint8_t*);
GRAZE_INSTANTIATE(Box, float)
GRAZE_INSTANTIATE(Box, double)
GRAZE_INSTANTIATE(Capsule, float)
GRAZE_INSTANTIATE(Capsule, double)
#undef GRAZE_INSTANTIATE
template void capsule_box_contacts(const PairRef<float>*, std::size_t, PointContact<float>*, Meeting*);
template void capsule_box_contacts(const PairRef<double>*, std::size_t, PointContact<double>*, Meeting*);

}  // namespace graze::GRAZE_ISA
