// Shapes to test with, described once and built for the library and for the reference alike.
//
// All numbers are floats, so that `Shape<float>`, `Shape<double>` and the reference mean exactly the same shape.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include "graze/shape.hpp"
#include "reference/shape.hpp"

namespace graze::testing {

enum class Kind {
  sphere,
  capsule,
  tapered_capsule,
  box,
  rectangle,
  cylinder,
  cone,
  truncated_cone,
  ellipsoid,
  segment,
  triangle,
  hull,
  user,
  half_space
};
inline constexpr int kind_count = 14;
inline constexpr int bounded_kinds = 13;

const char* name_of(Kind kind);
/// Whether the signed distance of such shapes involves a curved core, for which depths are iterated.
bool curved(Kind kind);

struct Specimen {
  Kind kind = Kind::sphere;
  std::array<float, 3> size{};
  std::vector<Vec3f> points;
  float margin = 0;
};

struct PlacedSpecimen {
  Specimen specimen;
  Vec3f translation{};
  Quatf rotation{};
};

using Random = std::mt19937_64;

float uniform(Random& random, float low, float high);
Vec3f random_vector(Random& random, float reach);
Quatf random_rotation(Random& random);

/// Any shape of the kind, its sizes from a tenth of `scale` to about `scale`; one in three is rounded.
Specimen random_specimen(Kind kind, float scale, Random& random);
/// A shape whose sizes are `scale` times 0, 1e-4, 1/2, 1 or 2: flat, thin, equal, aligned.
Specimen degenerate_specimen(Kind kind, float scale, Random& random);
/// A pose of the lattice: half steps of `scale`, turns of 45, 90 and 120 degrees.
PlacedSpecimen on_lattice(Specimen specimen, float scale, Random& random);

/// In units of `scale`.
template <class T>
Shape<T> build(const Specimen& specimen, T scale = T(1));
template <class T>
Pose<T> pose_of(const PlacedSpecimen& placed, T scale = T(1));

reference::Placed reference_of(const PlacedSpecimen& placed);

/// For messages: everything needed to repeat the case.
std::string describe(const PlacedSpecimen& placed);

}  // namespace graze::testing
