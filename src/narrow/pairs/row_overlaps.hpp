// The overlap test of pairs in rows, by their distance unless their two kinds have an overload of `touching`. Only for
// `*.kernel.cpp`.
//
// Guarantee: in every lane the answer that the pair gives alone; everything is inlined or has a copy in each file.
#pragma once

#include "narrow/batch/row_answers.hpp"
#include "narrow/pairs/row_distance.hpp"

namespace graze::GRAZE_ISA {

/// The lanes that touch, and those in which that is known.
template <class S>
struct Touching {
  typename S::Mask touch, known;
};

template <class A, class B, class T>
inline Touching<Lanes<T>> touching(const RowBundle<A, B, T>& p) {
  return {distance_of(p).distance <= Lanes<T>(0), p.regular()};
}

template <class A, class B, class T>
[[gnu::flatten]] std::uint32_t row_overlaps(const PairRows<T>& rows, std::size_t count, std::uint8_t* touch,
                                            std::uint8_t* unknown) {
  const auto write = [touch](const RowBundle<A, B, T>& pairs, std::size_t filled, std::size_t first) {
    const Touching<Lanes<T>> found = touching(pairs);
    put_bytes<T>(found.touch.bits & 1, filled, touch + first);
    return found.known;
  };
  return answer_rows<A, B>(rows, count, unknown, write);
}

}  // namespace graze::GRAZE_ISA
