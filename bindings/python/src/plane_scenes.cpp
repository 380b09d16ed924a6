// Scenes of the plane from files.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "graze/io/plane_scene.hpp"
#include "graze/io/plane_simulate.hpp"
#include "plane_convert.hpp"
#include "playing.hpp"
#include "scene_text.hpp"
#include "shapes.hpp"

namespace graze::python {

void add_plane_scenes(py::module_& m) {
  using Collider = io::PlaneCollider;
  using Scene = io::PlaneScene;
  py::class_<Collider>(m, "Collider", "One shape of a body of a scene, at its pose in the world.")
      .def_property_readonly(
          "name", [](const Collider& c) { return file_text(c.name); }, "Its name in the file; may be empty.")
      .def_readonly("body", &Collider::body, "The index of its body.")
      .def_readonly("pose", &Collider::pose, "In the world.")
      .def_readonly("filter", &Collider::filter, "The category and mask of the file's collision systems.")
      .def_readonly("trigger", &Collider::trigger, "Whether it only reports overlaps.")
      .def_property_readonly(
          "shape", [](const Collider& c) { return ShapeObject{object_of(c.shape)}; }, "The shape, in its own frame.")
      .def("__repr__", [](const Collider& c) { return "<graze.plane.Collider " + quoted(c.name) + ">"; });
  py::class_<Scene>(m, "Scene", "What a file holds. Not pickled: load the file again.")
      .def_property_readonly(
          "source", [](const Scene& s) { return file_text(s.source); }, "The name of the file.")
      .def_readonly("colliders", &Scene::colliders, "All shapes in place, a list of Collider in the file's order.")
      .def_readonly("notices", &Scene::notices, "What was skipped, a sentence each.")
      .def_property_readonly(
          "bodies",
          [](const Scene& scene) {
            py::list out;
            for (const auto& body : scene.bodies) out.append(py::make_tuple(file_text(body.name), text_of(body.type)));
            return out;
          },
          "(name, 'static', 'dynamic' or 'kinematic') of each.")
      .def_property_readonly(
          "moving_bodies", [](const Scene& scene) { return io::moving_bodies(scene); },
          "The indices of the bodies that `simulate` moves, in the order of its frames.")
      .def_property_readonly(
          "gravity",
          [](const Scene& scene) { return scene.gravity ? py::object(array_of(*scene.gravity)) : py::none(); },
          "The file's gravity, or None.")
      .def("__repr__", [](const Scene& scene) { return scene_text("graze.plane.Scene", scene); });
  m.def(
      "load", [](const std::filesystem::path& file) { return io::load_plane_scene(file); }, py::arg("file"),
      R"(Reads a scene of the plane: a drawing in SVG, or JSON of the protocol's shapes (docs/plane.md).

The Y axis points up: a point (x, y) of a drawing is (x, -y) here. Raises ValueError for a file that
cannot be read, with the line and the place of the fault.)");
  add_plane_playing(m);
}

}  // namespace graze::python
