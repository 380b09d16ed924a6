// The transform of a glTF node: a matrix, or translation, rotation and scale.
//
// Guarantee: finite numbers, up to `largest_magnitude` but for those of a matrix; a rotation of unit length.
#pragma once

#include "io/affine.hpp"
#include "io/json_value.hpp"

namespace graze::io {

/// A transform that scales first, then rotates, then translates.
struct NodeTransform {
  Vec3d translation{};
  Quatd rotation{};
  Vec3d scale{1, 1, 1};

  Affine map() const {
    const auto sign = [](double s) { return s < 0 ? -1.0 : 1.0; };
    return {
        rotation_matrix(rotation) * Mat3d::diagonal(scale), translation, {sign(scale.x), sign(scale.y), sign(scale.z)}};
  }
};

inline Vec3d vector_or(const JsonValue& json, const char* key, const Vec3d& otherwise) {
  const auto found = json.find(key);
  return found ? found->vector<double>() : otherwise;
}

inline Quatd read_quaternion(const JsonValue& json) {
  const auto p = json.elements(4);
  const Quatd q{p[0].number<double>(), p[1].number<double>(), p[2].number<double>(), p[3].number<double>()};
  if (q == Quatd{0, 0, 0, 0}) json.fail("a quaternion that is not zero");
  return normalized(q);
}

/// The transform of a node without a matrix. Throws `InvalidValue`, as does `node_map`.
inline NodeTransform node_transform(const JsonValue& node) {
  const auto rotation = node.find("rotation");
  return {vector_or(node, "translation", {}), rotation ? read_quaternion(*rotation) : Quatd{},
          vector_or(node, "scale", {1, 1, 1})};
}

inline Affine node_map(const JsonValue& node) {
  const auto matrix = node.find("matrix");
  if (!matrix) return node_transform(node).map();
  const auto m = matrix->elements(16);
  const auto at = [&](std::size_t column, std::size_t row) { return m[4 * column + row].number<double>(); };
  Affine map;
  for (std::size_t r = 0; r < 3; ++r) map.linear.row[r] = {at(0, r), at(1, r), at(2, r)};
  map.translation = {at(3, 0), at(3, 1), at(3, 2)};
  // The X axis has the sign of a matrix that mirrors, as in the usual decomposition.
  if (determinant(map.linear) < 0) map.signs.x = -1;
  return map;
}

}  // namespace graze::io
