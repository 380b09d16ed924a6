// A world of the plane.
#include "plane_world.hpp"

#include "graze/plane/world.hpp"
#include "plane_batch.hpp"
#include "world_methods.hpp"

namespace graze::python {

plane::Velocity<double> PlaneWords::velocity(const Vector2& linear, double angular) {
  if (const char* expectation = validate::fault_of_coordinate(angular)) validate::fail("angular", expectation, angular);
  return {checked(linear, "linear"), angular};
}

plane::Pose2d PlaneWords::pose_of_row(const double* p) {
  return {python::checked({p[0], p[1]}, "translation"), unit_rotation(p[2], p[3], "rotation")};
}

void add_plane_world(py::module_& m) {
  m.def(
      "along_lines",
      [](const Vector2& motion, const py::object& normals) {
        const std::vector<plane::Vec2d> away = points_of_plane(normals, "normals");
        for (std::size_t i = 0; i < away.size(); ++i)
          unit_vector<PlaneBatch>(away[i], "normals[" + std::to_string(i) + "]");
        return array_of(plane::along_lines<double>(checked(motion.value, "motion"), away));
      },
      py::arg("motion"), py::arg("normals"),
      R"(The part of a motion that lines leave: the nearest motion that leads into none of them.

normals: unit vectors away from the obstacles, shape (n, 2). Raises ValueError.

>>> from graze import plane
>>> plane.along_lines((1, -1), [(0, 1)])
array([1., 0.])
)");
  WorldMethods<PlaneWords>::add(m,
                                "A world of the plane to read: its bodies, what touched in the last update, questions.",
                                R"(Bodies of the plane that come, move and go, and what touches.

margin: contacts are reported up to this far apart, >= 0; by default a hundredth of the smaller
body's size. points_per_pair: at most so many points a pair. allow: the final decision on
pairs that their filters allow, a function of two BodyIds. threads: how many run an update, or a
`graze.Threads`; the result has the same bits. Raises ValueError. Handles of bodies
and filters are those of space.

>>> from graze import plane
>>> world = plane.World()
>>> floor = world.add(plane.HalfPlane(), fixed=True)
>>> crate = world.add(plane.Box((1, 1)), (3, 0.49))
>>> world.update()
>>> [(kind, a == floor, b == crate) for kind, a, b, _ in world.events]
[('begin', True, True)]
>>> world.points["distance"].round(12)
array([-0.01, -0.01])
)");
  WorldMethods<PlaneWords>::add_captured(m);
}

}  // namespace graze::python
