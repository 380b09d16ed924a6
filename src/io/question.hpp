// A question of the protocol, as data.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "graze/lines.hpp"
#include "graze/shape.hpp"
#include "io/json_value.hpp"

namespace graze::io {

enum class QueryKind { overlap, distance, contacts, raycast, cast, closest };

template <class T>
struct MovingBody {
  Shape<T> shape;
  Pose<T> pose{};
  Vec3<T> linear{}, angular{};
};

/// A question, over the types of its space: a body that moves, a ray and a point.
template <class T, class Body, class RayOfSpace, class Point>
struct QuestionOf {
  QueryKind query = QueryKind::overlap;
  std::optional<Body> a, b;
  T margin = T(0);
  std::optional<RayOfSpace> ray;
  T ray_length = std::numeric_limits<T>::infinity();
  std::optional<Point> point;
  T duration = T(1);
  std::optional<T> limit;
  bool explain = false;
};

/// A question in three dimensions.
template <class T>
using Question = QuestionOf<T, MovingBody<T>, Ray<T>, Vec3<T>>;

/// The query that a question names.
QueryKind read_query_kind(const JsonValue& json);

/// Reads a whole question in space; throws `InvalidValue` with the path of the first value at fault.
template <class T>
Question<T> read_question(const JsonValue& json);

/// The shape of a body in space.
template <class T>
Shape<T> read_shape(const JsonValue& json);

/// A quaternion that is not zero, at unit length.
template <class T>
Quat<T> read_rotation(const JsonValue& json);

}  // namespace graze::io
