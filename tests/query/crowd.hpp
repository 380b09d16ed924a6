// Many bodies near each other, and whether two answers about a pair of them are the same.
#pragma once

#include <cstring>
#include <vector>

#include "common/specimen.hpp"
#include "graze/batch.hpp"

namespace graze::testing {

/// Bodies of all kinds, many of them of those with kernels, most of them near each other; some face to face.
template <class T>
struct Crowd {
  std::vector<Shape<T>> shapes;
  std::vector<Pose<T>> poses;
  std::vector<IdPair> pairs;

  explicit Crowd(std::size_t count, unsigned seed) {
    Random random(seed);
    constexpr Kind often[] = {Kind::sphere, Kind::capsule, Kind::box, Kind::box, Kind::triangle};
    for (std::size_t i = 0; i < count; ++i) {
      const Kind kind = i % 12 == 11 ? Kind::half_space
                        : i % 4 == 3 ? static_cast<Kind>(random() % kind_count)
                                     : often[random() % 5];
      const Specimen specimen = random_specimen(kind, 1, random);
      const PlacedSpecimen placed{specimen, random_vector(random, 0.7f),
                                  i % 3 == 0 ? Quatf{} : random_rotation(random)};
      shapes.push_back(build<T>(specimen));
      poses.push_back(pose_of<T>(placed));
    }
    for (std::size_t i = 0; i < 4 * count; ++i)
      pairs.push_back({static_cast<std::uint32_t>(random() % count), static_cast<std::uint32_t>(random() % count)});
  }
  Bodies<T> bodies() const { return {std::span<const Shape<T>>(shapes), std::span<const Pose<T>>(poses)}; }
};

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
template <class T>
bool same_bits(const Distance<T>& a, const Distance<T>& b) {
  return same_bits(a.distance, b.distance) && same_bits(a.normal, b.normal) && same_bits(a.a, b.a) &&
         same_bits(a.b, b.b) && a.status == b.status && same_bits(a.error, b.error);
}
template <class T>
bool same_bits(const ContactPoint<T>& p, const ContactPoint<T>& q) {
  return same_bits(p.a, q.a) && same_bits(p.b, q.b) && same_bits(p.distance, q.distance) && p.feature == q.feature &&
         same_bits(p.weight, q.weight);
}

}  // namespace graze::testing
