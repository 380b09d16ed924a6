// A simulation of the plane.
#include "graze/plane/joint.hpp"
#include "graze/plane/simulation.hpp"
#include "plane_world.hpp"
#include "simulation_methods.hpp"

namespace graze::python {

void add_plane_simulation(py::module_& m) {
  SimulationMethods<PlaneWords>::add(m, R"(What happens next in the plane: bodies fall, collide and come to rest.

gravity: two numbers. sub_steps: of a step, a power of two. sleep: islands at rest cost nothing.
continuous: what moves fast passes through nothing. most_sub_steps: for an island under load, 64 by
default. longest_step: longer ones are refused. warm_start: sub-steps begin with the impulses of
the last one; without it stacks sink and lean. threads: how many run a step, or a `graze.Threads`;
the result has the same bits. Handles of bodies and joints, filters, and the limits and drives of
joints are those of space.

>>> from graze import plane
>>> simulation = plane.Simulation()
>>> floor = simulation.add(plane.HalfPlane(), fixed=True)
>>> box = simulation.add(plane.Box((1, 1)), (0, 2))
>>> for _ in range(120):
...     simulation.step(1 / 60)
>>> round(float(simulation.pose(box).translation[1]), 2)
0.5
)");
  SimulationMethods<PlaneWords>::add_captured(m);
}

}  // namespace graze::python
