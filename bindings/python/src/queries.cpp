// Queries of one pair, one shape or one ray.
#include "answers.hpp"
#include "shapes.hpp"
#include "traced.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

/// `traced` for queries whose answers are the library's.
template <class F>
py::object answered(const py::object& trace, const F& ask) {
  return traced(trace, [&](Trace* t) { return object_of_answer(ask(t)); });
}

template <class Hit>
py::list list_of(const std::vector<Hit>& hits) {
  py::list found;
  for (const Hit& hit : hits) found.append(py::cast(hit));
  return found;
}

Velocity<double> velocity_of(const Vector& linear, const Vector& angular, const char* name) {
  return {validate::point(linear.value, std::string(name) + ".linear"),
          validate::point(angular.value, std::string(name) + ".angular")};
}

CastOptions options_of(bool ignore_separating) { return {ignore_separating ? Separating::ignored : Separating::hit}; }

void add_pairs(py::module_& m) {
  const auto pair = [](const char* text) { return std::string(text); };
  m.def(
      "overlap",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b, const py::object& trace) {
        return answered(trace, [&](Trace* t) { return overlap(a, pose_a.value, b, pose_b.value, t); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("trace") = false,
      pair(R"(Whether two shapes touch: their distance is <= 0. With trace=True (answer, trace); with a
renderer as of draw for trace, what the question did is drawn through it. Raises ValueError for a
pose whose numbers are not finite or no rotation.

>>> import graze
>>> graze.overlap(graze.Box((2, 2, 2)), None, graze.Sphere(0.5), (1.4, 0, 0))
True
)")
          .c_str());
  m.def(
      "distance",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b, const py::object& trace) {
        return answered(trace, [&](Trace* t) { return distance(a, pose_a.value, b, pose_b.value, t); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("trace") = false,
      R"(The signed distance of two shapes, the points that realise it, and the normal from a to b.

Negative where they overlap: minus the length of the shortest translation that separates them. With
trace=True (answer, trace). Raises ValueError for a pose whose numbers are not finite or no rotation.

>>> import graze
>>> d = graze.distance(graze.Box((2, 2, 2)), None, graze.Sphere(0.5), (1.4, 0, 0))
>>> round(d.distance, 12), d.normal
(-0.1, array([1., 0., 0.]))
)");
  m.def(
      "distance_up_to",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b,
         double limit) -> py::object {
        const auto d = distance_up_to(a, pose_a.value, b, pose_b.value, checked_reach(limit, "limit"));
        return d ? py::cast(*d) : py::none();
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("limit"),
      "The distance of shapes no further apart than `limit` >= 0, else None; costs what lies within the limit.");
  m.def(
      "may_overlap",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b) {
        return may_overlap(a, pose_a.value, b, pose_b.value);
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"),
      "False only where two shapes certainly do not touch: cheaper than `overlap`.");
  m.def(
      "within",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b, double limit) {
        return within(a, pose_a.value, b, pose_b.value, checked_reach(limit, "limit"));
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("limit"),
      "Whether two shapes are no further apart than `limit` >= 0.");
  m.def(
      "near_pieces",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b, double margin) {
        std::vector<PieceDistance<double>> pieces;
        near_pieces(a, pose_a.value, b, pose_b.value, checked_reach(margin, "margin"), pieces);
        py::list found;
        for (const auto& piece : pieces) found.append(py::make_tuple(piece.piece_a, piece.piece_b, piece.distance));
        return found;
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin"),
      "All pairs of convex pieces within `margin`: (piece of a, piece of b, Distance).");
  m.def(
      "contacts",
      [](const Shaped& a, const Placement& pose_a, const Shaped& b, const Placement& pose_b, double margin,
         const py::object& trace) {
        checked_reach(margin, "margin");
        return answered(trace, [&](Trace* t) {
          Manifolds<double> manifolds;
          contacts(a, pose_a.value, b, pose_b.value, margin, manifolds, t);
          py::list found;
          for (Manifold<double>& manifold : manifolds) found.append(py::cast(std::move(manifold)));
          return found;
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("trace") = false,
      R"(Where two shapes touch, or are up to `margin` >= 0 apart: a list of Manifold.

With trace=True (list, trace). Raises ValueError for a margin that is negative, and for a pose whose
numbers are not finite or no rotation.

>>> import graze
>>> box = graze.Box((1, 1, 1))
>>> [m] = graze.contacts(box, None, box, (0, 0.99, 0))
>>> len(m.points), m.normal
(4, array([0., 1., 0.]))
)");
  m.def(
      "contact_margin", [](const Shaped& a, const Shaped& b) { return contact_margin(a, b); }, py::arg("a"),
      py::arg("b"), "The margin that a world uses for the two: a hundredth of the smaller one's size.");
  m.def(
      "feature_corners",
      [](const Shaped& shape, const Whole& feature, const Whole& piece) {
        const auto id = feature_of_b(feature.as<std::uint16_t>("feature"));
        const auto corners = feature_corners(shape, piece.as<std::uint32_t>("piece"), id);
        return array_of_points(std::span(corners.begin(), corners.size()));
      },
      py::arg("shape"), py::arg("feature"), py::arg("piece") = Whole(0),
      R"(The corners of the vertex, edge or face that a point of contact names, in the shape's frame: shape (n, 3).

feature: `point.feature >> 16` of shape a, `point.feature & 0xffff` of b. piece: the manifold's, of a mesh or a
compound. None of what has no corners, or is not certain.

>>> import graze
>>> box = graze.Box((2, 2, 2))
>>> [m] = graze.contacts(graze.HalfSpace(), None, box, (0, 0.99, 0))
>>> graze.feature_corners(box, m.points[0].feature & 0xffff)[:, 1]
array([-1.])
)");
}

void add_points_and_rays(py::module_& m) {
  m.def(
      "closest",
      [](const Shaped& shape, const Placement& pose, const Vector& point, const py::object& trace) {
        const Vec3d p = validate::point(point.value, "point");
        return answered(trace, [&](Trace* t) { return closest(shape, pose.value, p, t); });
      },
      py::arg("shape"), py::arg("pose"), py::arg("point"), py::arg("trace") = false,
      R"(The point of a shape's surface nearest to a point: a Closest, whose distance is negative inside a solid.

With trace=True (answer, trace). Raises ValueError for a point or a pose that is not finite.)");
  m.def(
      "raycast",
      [](const Shaped& shape, const Placement& pose, const Vector& origin, const Vector& direction, double length,
         bool back_faces, const py::object& trace) {
        const Ray<double> ray = ray_of(origin, direction);
        return answered(trace, [&](Trace* t) -> py::object {
          const auto hit = raycast(shape, pose.value, ray, checked_reach(length, "length"),
                                   back_faces ? BackFaces::hit : BackFaces::ignored, t);
          return hit ? py::cast(*hit) : py::none();
        });
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
      py::arg("trace") = false,
      R"(What a ray hits first within `length`: a RayHit, or None.

direction need not be of unit length; one of zeros hits nothing. t of the hit is a length.
Raises ValueError for what is not finite.

>>> import graze
>>> graze.raycast(graze.Sphere(1), None, (-3, 0, 0), (1, 0, 0)).t
2.0
)");
  m.def(
      "raycast_any",
      [](const Shaped& shape, const Placement& pose, const Vector& origin, const Vector& direction, double length,
         bool back_faces) {
        return raycast_any(shape, pose.value, ray_of(origin, direction), checked_reach(length, "length"),
                           back_faces ? BackFaces::hit : BackFaces::ignored);
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
      "Whether a ray hits anything within `length`.");
  m.def(
      "raycast_all",
      [](const Shaped& shape, const Placement& pose, const Vector& origin, const Vector& direction, double length,
         bool back_faces) {
        std::vector<RayHit<double>> hits;
        raycast_all(shape, pose.value, ray_of(origin, direction), hits, checked_reach(length, "length"),
                    back_faces ? BackFaces::hit : BackFaces::ignored);
        return list_of(hits);
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
      "Where a ray enters each piece of the shape, in the order of the ray.");
}

void add_casts(py::module_& m) {
  m.def(
      "cast",
      [](const Shaped& a, const Placement& pose_a, const Vector& linear_a, const Shaped& b, const Placement& pose_b,
         const Vector& linear_b, double duration, const Vector& angular_a, const Vector& angular_b,
         bool ignore_separating, const py::object& trace) {
        const Velocity<double> v = velocity_of(linear_a, angular_a, "a"), w = velocity_of(linear_b, angular_b, "b");
        checked_duration(duration);
        return answered(trace, [&](Trace* t) -> py::object {
          const auto hit = cast(a, pose_a.value, v, b, pose_b.value, w, duration, options_of(ignore_separating), t);
          return hit ? py::cast(*hit) : py::none();
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("linear_a"), py::arg("b"), py::arg("pose_b"), py::arg("linear_b"),
      py::arg("duration") = 1.0, py::arg("angular_a") = Vector{}, py::arg("angular_b") = Vector{},
      py::arg("ignore_separating") = false, py::arg("trace") = false,
      R"(When two moving bodies first touch within `duration`: a CastHit, or None.

Velocities in units of length and radians per unit of time, in world axes; the hit's t is in the unit of
`duration`. ignore_separating: bodies that overlap from the start and part count as not met. With
trace=True (answer, trace). Raises ValueError for a duration that is negative, and for what is not finite.

>>> import graze
>>> hit = graze.cast(graze.Box((2, 2, 2)), None, (0, 0, 0), graze.Sphere(0.5), (9, 0, 0), (-15, 0, 0))
>>> round(hit.t, 6)
0.5
)");
  m.def(
      "cast_all",
      [](const Shaped& a, const Placement& pose_a, const Vector& linear_a, const Shaped& b, const Placement& pose_b,
         const Vector& linear_b, double duration, const Vector& angular_a, const Vector& angular_b,
         bool ignore_separating) {
        std::vector<CastHit<double>> hits;
        cast_all(a, pose_a.value, velocity_of(linear_a, angular_a, "a"), b, pose_b.value,
                 velocity_of(linear_b, angular_b, "b"), checked_duration(duration), hits,
                 options_of(ignore_separating));
        return list_of(hits);
      },
      py::arg("a"), py::arg("pose_a"), py::arg("linear_a"), py::arg("b"), py::arg("pose_b"), py::arg("linear_b"),
      py::arg("duration") = 1.0, py::arg("angular_a") = Vector{}, py::arg("angular_b") = Vector{},
      py::arg("ignore_separating") = false,
      "When each pair of convex pieces of two moving bodies first touches, as if it were alone: CastHits in the order "
      "of "
      "time.");
  m.def(
      "pose_at",
      [](const Placement& pose, const Vector& linear, const Vector& angular, double t) {
        if (!std::isfinite(t)) validate::fail("t", "a finite number", t);
        return pose_at(pose.value, velocity_of(linear, angular, "velocity"), t);
      },
      py::arg("pose"), py::arg("linear"), py::arg("angular"), py::arg("t"),
      "Where a body stands at time t that moves at a constant velocity and turns at a constant rate.");
}

}  // namespace

void add_queries(py::module_& m) {
  add_pairs(m);
  add_points_and_rays(m);
  add_casts(m);
}

}  // namespace graze::python
