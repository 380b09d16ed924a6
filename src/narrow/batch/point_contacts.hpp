// Results of lanes for pairs with one point of contact at most, given by pointers. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/layouts.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/batch/row_bundle.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

/// Writes all lanes.
template <class T>
[[gnu::always_inline]] inline void put_all(const CoreDistance<Lanes<T>>& d, const std::uint32_t* features,
                                           const Lanes<T>& weight, PointContact<T>* to) {
  if constexpr (sizeof(T) == 4) {
    char* const rows = reinterpret_cast<char*>(to);
    Lanes<T> names;
    std::memcpy(&names.v, features, sizeof names.v);
    scatter(d.a.x, d.a.y, d.a.z, d.b.x, rows, sizeof *to);
    scatter(d.b.y, d.b.z, d.distance, names, rows + 16, sizeof *to);
    scatter(weight, d.normal.x, d.normal.y, d.normal.z, rows + 32, sizeof *to);
  } else {
    const auto vector = [](const Vec3<Lanes<T>>& v, int i) { return Vec3<T>{v.x[i], v.y[i], v.z[i]}; };
    for (std::size_t k = 0; k < lanes_of<T>; ++k) {
      const int i = static_cast<int>(k);
      to[k] = {{vector(d.a, i), vector(d.b, i), d.distance[i], features[k], weight[i]}, vector(d.normal, i)};
    }
  }
}

/// The filled lanes whose pairs lie, a bit each, of meetings as numbers: no other has a greater one.
template <class T>
[[gnu::always_inline]] inline std::uint32_t lying_lanes(const Lanes<T>& meeting, std::size_t filled) {
  return Chosen<T>::not_less(meeting, Lanes<T>(static_cast<T>(Meeting::lying))).bits() & filled_lanes<T>(filled);
}

/// Writes a bundle of pairs of A and B, and how they meet within the margins, which is returned, too.
template <class A, class B, class T>
[[gnu::always_inline]] inline Lanes<T> put_all(const OneContact<Lanes<T>>& c, const Lanes<T>& margin,
                                               const Lanes<T>& weight, PointContact<T>* contacts, Meeting* meetings) {
  using S = Lanes<T>;
  using Whole = typename S::BitVector;
  const auto is = [](Meeting one) { return S(static_cast<T>(one)); };
  S touching = select(c.known == S(0), is(Meeting::lying), is(Meeting::touching));
  if constexpr (std::is_same_v<B, Triangle<T>>) touching = select(c.known < S(0), is(Meeting::unknown), touching);
  const S meeting = select(c.at.distance <= margin, touching, is(Meeting::apart));
  put_bytes<T>(__builtin_convertvector(meeting.v, Whole), lanes_of<T>, reinterpret_cast<std::uint8_t*>(meetings));
  const Whole place = __builtin_convertvector(feature_place(c.part_a, c.part_b).v, Whole);
  std::uint32_t features[lanes_of<T>];
  for (std::size_t k = 0; k < lanes_of<T>; ++k)
    features[k] = feature_ids_with(static_cast<const B*>(nullptr)).of[static_cast<std::size_t>(place[k])];
  put_all(c.at, features, weight, contacts);
  return meeting;
}

}  // namespace graze::GRAZE_ISA
