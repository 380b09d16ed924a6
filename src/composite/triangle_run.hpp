// Triangles of one surface that may touch the same body, asked about several at a time.
//
// Guarantee: of each triangle what `convex_contacts` answers, bit for bit, and in the order in which they were
// gathered. Nothing is allocated.
#pragma once

#include "composite/leaf_pairs.hpp"
#include "composite/near_convex.hpp"
#include "narrow/batch/lane_pairs.hpp"
#include "narrow/general_contacts.hpp"

namespace graze {

/// Some triangles of a surface and a bounded body whose bounds they come near. As plain numbers, so that none is
/// cleared that is not used.
template <class T>
struct TriangleRun {
  static constexpr std::size_t most = block_pairs;

  const Part<T>&surface, &body;
  bool surface_is_a;
  const MeshPatch<T>* patch;  ///< of the surface's mesh, where there is one
  const NearConvex<T>& question;
  std::size_t count = 0;
  std::uint32_t number[most];
  T corner[most][3][3];

  TriangleRun(const Part<T>& of, const Part<T>& with, bool of_a, const MeshPatch<T>* in, const NearConvex<T>& asked)
      : surface(of), body(with), surface_is_a(of_a), patch(in), question(asked) {}

  void add(const Corners<T>& corners, std::uint32_t triangle) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) corner[count][i][axis] = corners[i][axis];
    number[count++] = triangle;
  }
  Corners<T> corners(std::size_t i) const {
    const auto& c = corner[i];
    return {{{c[0][0], c[0][1], c[0][2]}, {c[1][0], c[1][1], c[1][2]}, {c[2][0], c[2][1], c[2][2]}}};
  }
  /// The triangles of which `leave_out(i)` is false, in their order.
  template <class F>
  TriangleRun without(const F& leave_out) const {
    TriangleRun rest(surface, body, surface_is_a, patch, question);
    for (std::size_t i = 0; i < count; ++i)
      if (!leave_out(i)) rest.add(corners(i), number[i]);
    return rest;
  }
  /// Calls `f(part_a, part_b)` for the i-th triangle and the body, as a `PairVisitor` is called.
  template <class F>
  decltype(auto) with_pair(std::size_t i, F&& f) const {
    const Shape<T> shape = triangle_shape(corners(i));
    Part<T> piece = surface.piece(shape, surface.pose, number[i]);
    piece.patch = patch;
    return surface_is_a ? f(piece, body) : f(body, piece);
  }
};

/// Whether a shape's kind stands before triangles in the list of shapes.
template <class T>
bool stands_before_triangles(const Shape<T>& shape) {
  return shape.index() < detail::kind_of<Triangle<T>, T>();
}

/// The concrete shape, if there are kernels for its contacts with triangles, else null. Only of kinds that stand before
/// triangles: the body is the first of each pair then, whichever of the two the surface is.
template <class T>
const void* concrete_for_runs(const Shape<T>& shape) {
  constexpr std::size_t triangle = detail::kind_of<Triangle<T>, T>();
  if (!stands_before_triangles(shape) || !with_contact_lanes(lane_table<T>(shape.index(), triangle).pair))
    return nullptr;
  return concrete_for_lanes(shape);
}

/// The sink (`narrow/batch/contact_sink.hpp`) of a run: makes manifolds, without the names of their pieces.
template <class T, class Touching, class Alone>
class RunSink {
 public:
  using Scalar = T;
  static constexpr std::size_t most = TriangleRun<T>::most;

  RunSink(const TriangleRun<T>& run, const Touching& touching, const Alone& alone)
      : run_(run), touching_(touching), alone_(alone) {}

  void apart(std::size_t) {}
  void unknown(std::size_t i) { alone_(i); }
  void one(std::size_t i, const PointContact<T>& c) {
    touch(i, c.point.distance, c.normal, [&](auto& points) { points.push_back(c.point); });
  }
  template <class Points>
  void several(std::size_t i, T distance, const Vec3<T>& normal, const Points& found, std::size_t) {
    touch(i, distance, normal, [&](auto& points) { found.append(points); });
  }
  void met(const MetPairs<T>& met, bool) {
    const ContactPoint<T>* from = met.points;
    for (std::size_t k = 0; k < met.count; ++k) {
      const std::span points(from, met.points_of(k));
      from += points.size();
      touch(met.place(k), met.distance(k), met.normal(k), [&](auto& to) {
        for (const ContactPoint<T>& point : points) to.push_back(point);
      });
    }
  }

 private:
  template <class AddPoints>
  void touch(std::size_t i, T distance, const Vec3<T>& normal, const AddPoints& add_points) {
    Manifold<T> manifold;
    manifold.normal = normal;
    add_points(manifold.points);
    if (run_.surface_is_a) mirror(manifold);
    touching_(i, distance, manifold);
  }

  const TriangleRun<T>& run_;
  const Touching& touching_;
  const Alone& alone_;
};

/// Finds the contacts of a run with a body that has kernels for them (`concrete_for_runs`) up to `margin`, which is not
/// negative: `touching(i, distance, manifold)`, the manifold without its pieces' names, or `alone(i)` where no kernel
/// tells. Those that are further apart are passed over.
template <class T, class Touching, class Alone>
void visit_run_contacts(const TriangleRun<T>& run, T margin, const Touching& touching, const Alone& alone) {
  static_assert(sizeof run.corner[0] == sizeof(Triangle<T>));  // as kernels load them
  const void* const body = concrete_for_runs(run.body.shape);
  PairRef<T> pairs[TriangleRun<T>::most];
  for (std::size_t i = 0; i < run.count; ++i)
    pairs[i] = {body, run.corner[i], &run.body.pose, &run.surface.pose, margin};
  RunSink sink(run, touching, alone);
  visit_lane_contacts(lane_table<T>(run.body.shape.index(), detail::kind_of<Triangle<T>, T>()), pairs, run.count, sink);
}

}  // namespace graze
