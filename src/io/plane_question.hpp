// A question of the protocol in two dimensions, as data.
#pragma once

#include <optional>

#include "graze/plane/cast.hpp"
#include "io/json_value.hpp"
#include "io/question.hpp"

namespace graze::io {

template <class T>
struct PlaneBody {
  plane::Shape<T> shape;
  plane::Pose2<T> pose{};
  plane::Velocity<T> velocity{};
};

/// A question in two dimensions.
template <class T>
using PlaneQuestion = QuestionOf<T, PlaneBody<T>, plane::Ray<T>, plane::Vec2<T>>;

/// Whether the question is one of the plane. A `dimension` that is neither 2 nor 3 is refused by `read_question`.
bool in_the_plane(const Json& question);

/// Reads a whole question; throws `InvalidValue` with the path of the first value at fault.
template <class T>
PlaneQuestion<T> read_plane_question(const JsonValue& json);

/// A shape of the plane.
template <class T>
plane::Shape<T> read_plane_shape(const JsonValue& json);

}  // namespace graze::io
