// The Python module `graze._graze`; the package's __init__.py shows its names as graze's own.
#include "answers.hpp"
#include "raised.hpp"
#include "shapes.hpp"

PYBIND11_MODULE(_graze, m) {
  using namespace graze::python;
  m.attr("__version__") = GRAZE_VERSION_TEXT;
  add_pose(m);
  add_shapes(m);
  add_answers(m);
  add_queries(m);
  add_batches(m);
  add_motion(m);
  add_world(m);
  add_broad(m);
  add_draw(m);
  add_simulation(m);
  add_replay(m);
  add_scenes(m);
  add_plane(m);
  raise_after_calls(m);
}
