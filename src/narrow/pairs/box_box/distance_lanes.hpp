// The distances of boxes and of box-like shapes (`box_like_pair.hpp`), a register of pairs at a time in double. Only
// for `*.kernel.cpp`.
//
// Guarantee: in every lane the bits that the pair gives alone; everything is inlined or has a copy in each file.
#pragma once

#include "narrow/batch/row_answers.hpp"
#include "narrow/core/in_double.hpp"
#include "narrow/pairs/box_box/distance.hpp"

namespace graze::GRAZE_ISA {

namespace {

template <std::size_t part, class L>
[[gnu::always_inline]] inline PlacedBox<Lanes<double>> in_double(const PlacedBox<L>& box) {
  return {GRAZE_ISA::in_double<part>(box.half), lanes_in_double<part>(box.radius),
          GRAZE_ISA::in_double<part>(box.pose)};
}

/// The distance of a register of pairs, compiled once a file.
[[gnu::noinline, gnu::flatten]] void answer(const PlacedBox<Lanes<double>>& a, const PlacedBox<Lanes<double>>& b,
                                            BoxDistance<Lanes<double>>& found) {
  found = box_distance(a, b);
}

/// The distances of a bundle, and the lanes in which they are known.
template <class T>
struct BundleDistances {
  CoreDistance<Lanes<T>> at;
  typename Lanes<T>::Mask known;
};
template <class A, class B, class T>
BundleDistances<T> distances_of(const RowBundle<A, B, T>& p, std::size_t count) {
  using S = Lanes<double>;
  BoxDistance<S> found[parts_of<T>]{};
  const auto a = placed_box(p.a.shapes, p.pose_a), b = placed_box(p.b.shapes, p.pose_b);
  visit_parts<T>(count, [&](auto part) { answer(in_double<part>(a), in_double<part>(b), found[part]); });
  const auto number = [&](const auto& of) {
    S parts[parts_of<T>];
    for (std::size_t i = 0; i < parts_of<T>; ++i) parts[i] = of(found[i]);
    return joined(parts);
  };
  const auto vector = [&](auto member) {
    return Vec3<Lanes<T>>{number([=](const BoxDistance<S>& d) { return (d.at.*member).x; }),
                          number([=](const BoxDistance<S>& d) { return (d.at.*member).y; }),
                          number([=](const BoxDistance<S>& d) { return (d.at.*member).z; })};
  };
  const S none(0), one(1);
  return {{number([](const BoxDistance<S>& d) { return d.at.distance; }), vector(&Distance<S>::normal),
           vector(&Distance<S>::a), vector(&Distance<S>::b)},
          (number([&](const BoxDistance<S>& d) { return select(d.proven, one, none); }) > Lanes<T>(0)) & p.regular()};
}

}  // namespace

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t box_row_distances(const PairRows<T>& rows, std::size_t count, bool turned,
                                                 Distance<T>* distances, std::uint8_t* unknown) {
  const auto write = [=](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const BundleDistances<T> found = distances_of(pairs, filled);
    put(turned ? mirrored(found.at) : found.at, filled, distances + first);
    return found.known;
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t box_like_row_overlaps(const PairRows<T>& rows, std::size_t count, std::uint8_t* touch,
                                                     std::uint8_t* unknown) {
  const auto write = [=](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const BundleDistances<T> found = distances_of(pairs, filled);
    put_bytes<T>((found.at.distance <= Lanes<T>(0)).bits & 1, filled, touch + first);
    return found.known;
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

}  // namespace graze::GRAZE_ISA
