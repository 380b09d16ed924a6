// Queries of one pair, one shape or one ray of the plane.
#include "plane_convert.hpp"
#include "traced.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

using plane::Shaped;

/// `traced` for queries whose answers are the library's.
template <class F>
py::object answered(const py::object& trace, const F& ask) {
  return traced(trace, [&](Trace* t) { return object_of_answer(ask(t)); });
}

template <class Hit>
py::object object_or_none(const std::optional<Hit>& hit) {
  return hit ? py::cast(*hit) : py::none();
}

template <class Hit>
py::list list_of(const std::vector<Hit>& hits) {
  py::list found;
  for (const Hit& hit : hits) found.append(py::cast(hit));
  return found;
}

double finite(double value, const char* name) {
  if (const char* expectation = validate::fault_of_coordinate(value)) validate::fail(name, expectation, value);
  return value;
}

plane::Velocity<double> velocity_of(const Vector2& linear, double angular, const std::string& name) {
  return {checked(linear.value, ("linear" + name).c_str()), finite(angular, ("angular" + name).c_str())};
}

CastOptions options_of(bool ignore_separating) { return {ignore_separating ? Separating::ignored : Separating::hit}; }

void add_pairs(py::module_& m) {
  m.def(
      "overlap",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b,
         const py::object& trace) {
        return answered(trace, [&](Trace* t) { return overlap(a, pose_a.value, b, pose_b.value, t); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("trace") = false,
      R"(Whether two shapes touch: their distance is <= 0. With trace=True (answer, trace); with a
renderer as of draw for trace, what the question did is drawn through it. Raises ValueError for a
pose whose numbers are not finite or no rotation.

>>> from graze import plane
>>> plane.overlap(plane.Box((2, 2)), None, plane.Circle(0.5), (1.4, 0))
True
)");
  m.def(
      "distance",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b,
         const py::object& trace) {
        return answered(trace, [&](Trace* t) { return distance(a, pose_a.value, b, pose_b.value, t); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("trace") = false,
      R"(The signed distance of two shapes, the points that realise it, and the normal from a to b.

Negative where they overlap: minus the length of the shortest translation that separates them. With
trace=True (answer, trace). Raises ValueError for a pose whose numbers are not finite or no rotation.

>>> from graze import plane
>>> d = plane.distance(plane.Box((2, 2)), None, plane.Circle(0.5), (3, 0))
>>> d.distance, d.normal
(1.5, array([1., 0.]))
)");
  m.def(
      "distance_up_to",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b, double limit) {
        return object_or_none(distance_up_to(a, pose_a.value, b, pose_b.value, checked_reach(limit, "limit")));
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("limit"),
      "The distance of shapes no further apart than `limit` >= 0, else None; costs what lies within the limit.");
  m.def(
      "within",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b, double limit) {
        return within(a, pose_a.value, b, pose_b.value, checked_reach(limit, "limit"));
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("limit"),
      "Whether two shapes are no further apart than `limit` >= 0.");
  m.def(
      "near_pieces",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b, double margin) {
        std::vector<plane::PieceDistance<double>> pieces;
        near_pieces(a, pose_a.value, b, pose_b.value, checked_reach(margin, "margin"), pieces);
        py::list found;
        for (const auto& piece : pieces) found.append(py::make_tuple(piece.piece_a, piece.piece_b, piece.distance));
        return found;
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin"),
      R"(All pairs of convex pieces within `margin`: (piece of a, piece of b, Distance).

Pieces are numbered as those of a manifold: children, pieces of a polygon, segments of a chain.

>>> from graze import plane
>>> steps = plane.Chain([(0, 0), (1, 0), (1, 1), (2, 1)])
>>> [segment for segment, _, _ in plane.near_pieces(steps, None, plane.Circle(0.1), (1.2, 0.2), 0.15)]
[1]
)");
  m.def(
      "contacts",
      [](const Shaped& a, const Placement2& pose_a, const Shaped& b, const Placement2& pose_b, double margin,
         const py::object& trace) {
        checked_reach(margin, "margin");
        return answered(trace, [&](Trace* t) {
          plane::Manifolds<double> manifolds;
          contacts(a, pose_a.value, b, pose_b.value, margin, manifolds, t);
          py::list found;
          for (const plane::Manifold<double>& manifold : manifolds) found.append(py::cast(manifold));
          return found;
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("trace") = false,
      R"(Where two shapes touch, or are up to `margin` >= 0 apart: a list of Manifold.

With trace=True (list, trace). Raises ValueError for a margin that is negative, and for a pose whose
numbers are not finite or no rotation.

>>> from graze import plane
>>> [m] = plane.contacts(plane.HalfPlane(), None, plane.Box((2, 2)), (0, 1))
>>> len(m.points), m.normal
(2, array([0., 1.]))
)");
  m.def(
      "contact_margin", [](const Shaped& a, const Shaped& b) { return contact_margin(a, b); }, py::arg("a"),
      py::arg("b"), "A margin with which a body at rest keeps its points: a hundredth of the smaller one's size.");
  m.def(
      "feature_corners",
      [](const Shaped& shape, const Whole& feature, const Whole& piece) {
        const auto id = feature_of_b(feature.as<std::uint16_t>("feature"));
        const auto corners = feature_corners(shape, piece.as<std::uint32_t>("piece"), id);
        return array_of_points(std::span(corners.begin(), corners.size()));
      },
      py::arg("shape"), py::arg("feature"), py::arg("piece") = Whole(0),
      R"(The corners of the vertex or edge that a point of contact names, in the shape's frame: shape (n, 2).

feature: `point.feature >> 16` of shape a, `point.feature & 0xffff` of b. piece: the manifold's, of a polygon, a chain
or a compound. None of what has no corners, or is not certain.)");
  m.def(
      "closest",
      [](const Shaped& shape, const Placement2& pose, const Vector2& point, const py::object& trace) {
        const plane::Vec2d p = checked(point.value, "point");
        return answered(trace, [&](Trace* t) { return closest(shape, pose.value, p, t); });
      },
      py::arg("shape"), py::arg("pose"), py::arg("point"), py::arg("trace") = false,
      R"(The point of a shape's surface nearest to a point: a Closest, whose distance is negative inside a solid.

With trace=True (answer, trace). Raises ValueError for a point or a pose that is not finite.)");
}

void add_rays_and_casts(py::module_& m) {
  m.def(
      "raycast",
      [](const Shaped& shape, const Placement2& pose, const Vector2& origin, const Vector2& direction, double length,
         const py::object& trace) {
        return traced(trace, [&](Trace* t) {
          return object_or_none(
              raycast(shape, pose.value, ray_of(origin, direction), checked_reach(length, "length"), t));
        });
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("trace") = false,
      R"(What a ray hits first within `length`: a RayHit, or None.

direction need not be of unit length; one of zeros hits nothing. t of the hit is a length.
Raises ValueError for what is not finite.

>>> from graze import plane
>>> plane.raycast(plane.Circle(1), None, (-3, 0), (1, 0)).t
2.0
)");
  m.def(
      "raycast_any",
      [](const Shaped& shape, const Placement2& pose, const Vector2& origin, const Vector2& direction, double length) {
        return raycast_any(shape, pose.value, ray_of(origin, direction), checked_reach(length, "length"));
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), "Whether a ray hits anything within `length`.");
  m.def(
      "raycast_all",
      [](const Shaped& shape, const Placement2& pose, const Vector2& origin, const Vector2& direction, double length) {
        std::vector<plane::RayHit<double>> hits;
        raycast_all(shape, pose.value, ray_of(origin, direction), hits, checked_reach(length, "length"));
        return list_of(hits);
      },
      py::arg("shape"), py::arg("pose"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(),
      "Where a ray enters each convex piece of the shape, in the order of the ray.");
  m.def(
      "cast",
      [](const Shaped& a, const Placement2& pose_a, const Vector2& linear_a, const Shaped& b, const Placement2& pose_b,
         const Vector2& linear_b, double duration, double angular_a, double angular_b, bool ignore_separating,
         const py::object& trace) {
        const auto v = velocity_of(linear_a, angular_a, "_a"), w = velocity_of(linear_b, angular_b, "_b");
        finite(checked_reach(duration, "duration"), "duration");
        return traced(trace, [&](Trace* t) {
          return object_or_none(
              cast(a, pose_a.value, v, b, pose_b.value, w, duration, options_of(ignore_separating), t));
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("linear_a"), py::arg("b"), py::arg("pose_b"), py::arg("linear_b"),
      py::arg("duration") = 1.0, py::arg("angular_a") = 0.0, py::arg("angular_b") = 0.0,
      py::arg("ignore_separating") = false, py::arg("trace") = false,
      R"(When two moving bodies first touch within `duration`: a CastHit, or None.

Velocities in units of length and radians (counter-clockwise) per unit of time; the hit's t is in the
unit of `duration`. ignore_separating: whether shapes that touch at the start and move apart do not count.
With trace=True (answer, trace). Raises ValueError for a duration that is negative, and for what is not
finite.

>>> from graze import plane
>>> plane.cast(plane.Box((2, 2)), None, (0, 0), plane.Circle(0.5), (9, 0), (-15, 0)).t
0.5
)");
  m.def(
      "cast_all",
      [](const Shaped& a, const Placement2& pose_a, const Vector2& linear_a, const Shaped& b, const Placement2& pose_b,
         const Vector2& linear_b, double duration, double angular_a, double angular_b, bool ignore_separating) {
        std::vector<plane::CastHit<double>> hits;
        cast_all(a, pose_a.value, velocity_of(linear_a, angular_a, "_a"), b, pose_b.value,
                 velocity_of(linear_b, angular_b, "_b"), finite(checked_reach(duration, "duration"), "duration"), hits,
                 options_of(ignore_separating));
        return list_of(hits);
      },
      py::arg("a"), py::arg("pose_a"), py::arg("linear_a"), py::arg("b"), py::arg("pose_b"), py::arg("linear_b"),
      py::arg("duration") = 1.0, py::arg("angular_a") = 0.0, py::arg("angular_b") = 0.0,
      py::arg("ignore_separating") = false,
      "When each pair of convex pieces of two moving bodies first touches, as if it were alone: CastHits in the order "
      "of "
      "time.");
  m.def(
      "pose_at",
      [](const Placement2& pose, const Vector2& linear, double angular, double t) {
        if (!std::isfinite(t)) validate::fail("t", "a finite number", t);
        return pose_at(pose.value, velocity_of(linear, angular, ""), t);
      },
      py::arg("pose"), py::arg("linear"), py::arg("angular"), py::arg("t"),
      "Where a body stands at time t that moves at a constant velocity and turns at a constant rate.");
}

}  // namespace

void add_plane_queries(py::module_& m) {
  add_pairs(m);
  add_rays_and_casts(m);
}

void add_plane(py::module_& m) {
  py::module_ plane = m.def_submodule("_plane", "The same words in two dimensions.");
  plane.attr("__name__") = "graze.plane";  // the module that its classes name as theirs
  add_plane_pose(plane);
  add_plane_shapes(plane);
  add_plane_answers(plane);
  add_plane_queries(plane);
  add_plane_batches(plane);
  add_plane_motion(plane);
  add_plane_world(plane);
  add_plane_simulation(plane);
  add_plane_draw(plane);
  add_plane_scenes(plane);
}

}  // namespace graze::python
