// Composites taken apart: the pieces of a shape that come near a region or a half-space.
//
// Guarantee: every piece whose bounds lie within the limit is visited, and the same ones in the same order for the same
// input; nearer ones first, so that a limit that shrinks prunes the rest. No triangle is stored or allocated for it.
#pragma once

#include "graze/shape.hpp"
#include "shape/compound_data.hpp"
#include "shape/height_field_data.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

/// Calls `f(surface)` with the data of a mesh or height field: `hierarchy()`, `triangle(number)` and `extent`. False
/// for another shape.
template <class T, class F>
bool with_surface(const Shape<T>& shape, F&& f) {
  if (const auto* mesh = shape.template as<Mesh<T>>()) {
    f(mesh->data());
    return true;
  }
  if (const auto* field = shape.template as<HeightField<T>>()) {
    f(field->data());
    return true;
  }
  return false;
}

/// Whether the triangles of a shape push from their front alone.
template <class T>
bool one_sided(const Shape<T>& shape) {
  bool front = false;
  with_surface(shape, [&](const auto& surface) { front = surface.sides == Sides::front; });
  return front;
}

/// A triangle as a shape, without a margin.
template <class T>
Shape<T> triangle_shape(const std::array<Vec3<T>, 3>& corners) {
  return Triangle<T>(corners[0], corners[1], corners[2]);
}

/// Calls `f(shape, pose, number)` for a triangle of a surface whose bounds `question` lets pass, as `visit_pieces`
/// does.
template <class T, class Surface, class Question, class Limit, class F>
bool visit_near_triangle(const Surface& surface, std::uint32_t number, const Pose<T>& pose, const Question& question,
                         const Limit& limit, F& f) {
  const std::array<Vec3<T>, 3> corners = surface.triangle(number);
  if constexpr (requires { question.may_reach(corners, limit); })
    if (!question.may_reach(corners, limit)) return true;
  return go_on(f, triangle_shape(corners), pose, number);
}

/// Visits a triangle where `question` may rule its bounds out.
template <class T, class Surface, class Question, class Limit, class F>
bool visit_triangle(const Surface& surface, std::uint32_t number, const Pose<T>& pose, const Question& question,
                    const Limit& limit, F& f) {
  if (question(bounds_of(surface.triangle(number))) > question.key(limit)) return true;
  return visit_near_triangle<T>(surface, number, pose, question, limit, f);
}

/// Calls `f(shape, pose, number)` for each child or triangle of a composite that `question` (in the composite's frame)
/// lets pass at `limit()`, triangles also by `question.may_reach(corners, limit)` where it has that; a convex shape is
/// its own only piece. `f` may return false to end the visit; returns whether it went to the end.
template <class T, class Question, class Limit, class F>
bool visit_pieces(const Shape<T>& shape, const Pose<T>& pose, const Question& question, const Limit& limit, F&& f) {
  bool whole = true;
  const auto of_surface = [&](const auto& surface) {
    const auto near = [&](std::uint32_t i) { return visit_triangle<T>(surface, i, pose, question, limit(), f); };
    whole = visit(surface.hierarchy(), question, limit, near);
  };
  if (with_surface(shape, of_surface)) return whole;
  if (const auto* compound = shape.template as<Compound<T>>()) {
    const CompoundData<T>& data = compound->data();
    const auto near = [&](std::uint32_t i) {
      const Placed<T>& child = data.children[i];
      return question(data.boxes[i]) > question.key(limit()) || go_on(f, child.shape, compose(pose, child.pose), i);
    };
    for (const std::uint32_t i : data.unbounded)
      if (!near(i)) return false;
    return visit(data.tree, question, limit, near);
  }
  return go_on(f, shape, pose, 0u);
}

/// Visits the pieces that come within `limit()` of a region.
template <class T, class Limit, class F>
bool visit_pieces(const Shape<T>& shape, const Pose<T>& pose, const Aabb<T>& region, const Limit& limit, F&& f) {
  return visit_pieces(shape, pose, BoxQuestion<T>{region}, limit, f);
}

}  // namespace graze
