// Scenes from files, and the query protocol.
#include "answers.hpp"
#include "playing.hpp"
#include "scene_physics.hpp"
#include "shapes.hpp"

#include "graze/io/collide.hpp"
#include "graze/io/plane_scene.hpp"
#include "graze/io/protocol.hpp"
#include "graze/io/recording.hpp"
#include "graze/io/scene.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace graze::python {

namespace {

io::LoadOptions load_options(const std::string& colliders, bool animations) {
  constexpr std::pair<const char*, io::MeshColliders> names[] = {{"mesh", io::MeshColliders::mesh},
                                                                 {"hull", io::MeshColliders::hull},
                                                                 {"box", io::MeshColliders::box},
                                                                 {"sphere", io::MeshColliders::sphere}};
  io::LoadOptions options;
  options.animations = animations;
  for (const auto& [text, kind] : names)
    if (colliders == text) {
      options.mesh_colliders = kind;
      return options;
    }
  validate::fail("colliders", "mesh, hull, box or sphere", colliders);
}

}  // namespace

void add_scenes(py::module_& m) {
  py::class_<io::Collider>(m, "Collider", "One shape of a body of a scene, at its pose in the world.")
      .def_property_readonly(
          "name", [](const io::Collider& c) { return file_text(c.name); }, "Its name in the file; may be empty.")
      .def_readonly("body", &io::Collider::body, "The index of its body.")
      .def_readonly("pose", &io::Collider::pose, "In the world.")
      .def_readonly("filter", &io::Collider::filter, "The category and mask of the file's collision filters.")
      .def_readonly("trigger", &io::Collider::trigger, "Whether it only reports overlaps.")
      .def_property_readonly(
          "material", [](const io::Collider& c) { return py::cast(c.material); },
          "The Material of its surface, or None where the file has none.")
      .def_property_readonly(
          "shape", [](const io::Collider& c) { return ShapeObject{object_of(c.shape)}; },
          "The shape, in its own frame.")
      .def("__repr__", [](const io::Collider& c) { return "<graze.Collider " + quoted(c.name) + ">"; });
  py::class_<io::Scene>(m, "Scene", "What a file holds. Not pickled: load the file again.")
      .def("__repr__", [](const io::Scene& scene) { return scene_text("graze.Scene", scene); })
      .def_property_readonly(
          "source", [](const io::Scene& s) { return file_text(s.source); }, "The name of the file.")
      .def_readonly("colliders", &io::Scene::colliders, "All shapes in place, a list of Collider in the file's order.")
      .def_readonly("notices", &io::Scene::notices, "What was skipped or approximated, a sentence each.")
      .def_readonly("collision_systems", &io::Scene::collision_systems, "The names behind the bits of filters.")
      .def_property_readonly(
          "motions",
          [](const io::Scene& scene) {
            py::list out;
            for (const auto& body : scene.bodies) out.append(object_of(body.motion));
            return out;
          },
          R"(What the file says of the motion of each body: a dictionary, or None for one that is fixed.

kinematic, mass (infinite where it does not move), center_of_mass, inertia (moments, quaternion) and
gravity_factor are arguments of `Simulation.add`, None where the file leaves them to the shape;
linear_velocity is that of the centre of mass and angular_velocity in radians, in world axes.)")
      .def_property_readonly(
          "joints",
          [](const io::Scene& scene) {
            py::list out;
            for (const auto& joint : scene.joints) out.append(object_of(joint));
            return out;
          },
          R"(The joints: a dictionary each of the arguments of `Simulation.join`, and its name.

a, b: indices of `bodies`, None for the world, where the frame is in the world at rest.)")
      .def_property_readonly(
          "animations",
          [](const io::Scene& scene) {
            py::list out;
            for (const auto& animation : scene.animations)
              out.append(py::make_tuple(file_text(animation.name), animation.duration));
            return out;
          },
          "(name, seconds) of each animation of the file, where it was loaded with `animations=True`.")
      .def_property_readonly(
          "moving_bodies", [](const io::Scene& scene) { return io::moving_bodies(scene); },
          "The indices of the bodies that `simulate` moves, in the order of its frames.")
      .def_property_readonly(
          "bodies",
          [](const io::Scene& scene) {
            py::list out;
            for (const auto& body : scene.bodies) {
              out.append(py::make_tuple(file_text(body.name), text_of(body.type), body.pose));
            }
            return out;
          },
          "(name, 'static', 'dynamic' or 'kinematic', Pose) of each.");
  m.def(
      "load",
      [](const std::filesystem::path& file, const std::string& colliders, bool animations) {
        if (io::is_plane_scene(file))
          throw InvalidValue("file", "a scene of space; graze.plane.load reads those of the plane", file.string());
        return io::load_scene(file, load_options(colliders, animations));
      },
      py::arg("file"), py::arg("colliders") = "mesh", py::arg("animations") = false,
      R"(Reads a scene: glTF 2.0 (with KHR_implicit_shapes and KHR_physics_rigid_bodies), OBJ, STL, PLY.

colliders: what meshes of files without physics become: 'mesh', 'hull', 'box' or 'sphere'.
animations: whether those of glTF are read too, for `simulate` and `collide_frames`.
Raises ValueError for a file that cannot be read, with the place of the fault. Drawings of the plane
(.svg, .json) are read by `graze.plane.load`.)");
  m.def(
      "collide",
      [](const io::Scene& scene, double margin) {
        io::CollideOptions options;
        options.margin = margin;
        std::vector<io::TouchingPair> pairs;
        {
          const py::gil_scoped_release free;
          pairs = io::collide(scene, options);
        }
        py::list out;
        for (auto& pair : pairs) {
          py::list manifolds;
          for (auto& manifold : pair.manifolds) manifolds.append(py::cast(std::move(manifold)));
          out.append(py::make_tuple(pair.a, pair.b, manifolds));
        }
        return out;
      },
      py::arg("scene"), py::arg("margin") = 0.0,
      R"(Which colliders of a scene touch: (index, index, list of Manifold), normals from the first to the second.

margin: >= 0, up to which contacts count. Raises ValueError for one that is negative or not finite.)");
  m.def(
      "answer",
      [](const std::string& question) { return io::answer_line(question, io::Precision::double_precision).text; },
      py::arg("question"),
      R"(The answer to a question of the query protocol, a line of JSON each.

>>> import graze
>>> graze.answer('{"id": 1, "query": "overlap", "a": {"shape": {"type": "sphere", "sphere": {"radius": 1}}},'
...              ' "b": {"shape": {"type": "sphere", "sphere": {"radius": 1}}, "translation": [1, 0, 0]}}')
'{"id":1,"overlap":true}'
)");
  add_playing(m);
}

}  // namespace graze::python
