#include "common/extreme_pair.hpp"

#include <cmath>

namespace graze::testing {

float log_uniform(Random& random, float low, float high) {
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

std::pair<PlacedSpecimen, PlacedSpecimen> extreme_pair(Kind kind_a, Kind kind_b, Random& random, int round) {
  static constexpr float ratios[] = {1e4f, 1e3f, 1e2f, 1};
  static constexpr float nearest[] = {1e-9f, 1e-8f, 1e-3f, 0.3f}, furthest[] = {1e-8f, 1e-3f, 0.3f, 1.5f};
  const auto any = [&](Kind kind, float scale) {
    return random() % 3 == 0 ? degenerate_specimen(kind, scale, random) : random_specimen(kind, scale, random);
  };
  PlacedSpecimen a{any(kind_a, 1), {}, {}}, b{any(kind_b, 1 / ratios[round % 4]), {}, {}};
  if (round % 4 == 3 && kind_a == kind_b) b.specimen = a.specimen;
  if (random() % 2 == 0) a.rotation = random_rotation(random);
  b.rotation = a.rotation;
  if (random() % 2 == 0) {
    const Vec3f lean = random_vector(random, log_uniform(random, 1e-9f, 1));
    b.rotation = normalized(a.rotation) * normalized(Quatf{lean.x, lean.y, lean.z, 1});
  }
  if (const auto way = random() % 5; way > 0) {
    const float far = log_uniform(random, nearest[way - 1], furthest[way - 1]);
    Vec3f along{};
    along[random() % 3] = far;
    b.translation = random() % 2 == 0 ? rotate(normalized(a.rotation), along) : random_vector(random, far);
  }
  if (random() % 2 == 0) std::swap(a, b);
  return {a, b};
}

}  // namespace graze::testing
