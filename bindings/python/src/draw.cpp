// Debug draw.
#include "draw.hpp"

#include <array>

#include <pybind11/stl.h>

#include "answers.hpp"
#include "plane_world.hpp"
#include "shapes.hpp"

namespace graze::python {

namespace {

constexpr std::array<const char*, 9> layer_words{"shapes", "bounds", "tree",  "contacts", "distances",
                                                 "rays",   "casts",  "trace", "joints"};
constexpr std::array<const char*, 16> meaning_words{"a",      "b",       "fixed",   "touched", "moving", "touching",
                                                    "asleep", "trigger", "contact", "normal",  "gap",    "ruled_out",
                                                    "bounds", "path",    "ghost",   "joint"};

template <class Words>
std::size_t place_of(const Words& words, const std::string& word, const char* path) {
  std::string all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word == words[i]) return i;
    all += std::string(all.empty() ? "" : ", ") + words[i];
  }
  validate::fail(path, "one of " + all, word);
}

DrawArea area_of(const py::object& on) {
  DrawArea area;
  if (py::hasattr(on, "center")) {
    if (!read_vector(on.attr("center"), area.center)) throw py::type_error("center: expected three numbers");
    validate::point(area.center, "center");
  }
  if (py::hasattr(on, "size")) area.size = number_from(on.attr("size"), "size");
  if (!(area.size > 0) || !(area.size <= largest_magnitude<double>)) validate::fail("size", "a size > 0", area.size);
  return area;
}

/// A method of that name, or none, as in a renderer that does not draw such things.
py::object method_of(const py::object& on, const char* name) {
  py::object method = py::getattr(on, name, py::none());
  if (!method.is_none() && PyCallable_Check(method.ptr()) == 0)
    throw py::type_error(std::string(name) + ": expected a method, got " + std::string(py::str(py::repr(method))));
  return method;
}

py::array_t<double> array_of_loop(const Polygons& shape, const std::vector<std::uint32_t>& loop) {
  py::array_t<double> out({static_cast<py::ssize_t>(loop.size()), py::ssize_t{3}});
  double* to = out.mutable_data();
  for (const std::uint32_t i : loop)
    for (const double x : {shape.points[i].x, shape.points[i].y, shape.points[i].z}) *to++ = x;
  return out;
}

/// Polygons by name, as Python has them.
py::dict object_of(const Polygons& shape) {
  py::list loops;
  for (const auto& loop : shape.loops)
    loops.append(py::array_t<std::uint32_t>(static_cast<py::ssize_t>(loop.size()), loop.data()));
  py::dict out;
  out["points"] = array_of_points(shape.points);
  out["loops"] = loops;
  out["smooth"] = shape.smooth;
  out["closed"] = shape.closed;
  return out;
}

template <class... Values>
void hand(const py::object& method, DrawLayer layer, DrawMeaning meaning, const Values&... values) {
  if (!method.is_none())
    method(values..., layer_words[static_cast<std::size_t>(layer)], meaning_words[static_cast<std::size_t>(meaning)]);
}

template <class Words>
void add_worlds(py::module_& m) {
  m.def(
      "draw",
      [](const py::object& on, const WorldView<Words>& world) {
        PythonDraw to(on);
        draw(to, *world.read());
      },
      py::arg("on"), py::arg("world"), "Bodies, bounds, the tree, and the contacts of the last update.");
  m.def(
      "draw_area",
      [](const WorldView<Words>& world) {
        const DrawArea area = draw_area(*world.read());
        return py::make_tuple(array_of(area.center), area.size);
      },
      py::arg("world"), "(center, size) of what has to be looked at to see all of a world.");
}

/// Defines the drawing of rays, casts and joints.
template <class Words>
void add_paths(py::module_& m) {
  using Space = typename Words::Space;
  using Vector = typename Words::Vector;
  using Placement = typename Words::Placement;
  m.def(
      "draw_ray",
      [](const py::object& on, const Vector& origin, const Vector& direction, double length,
         const std::optional<typename Space::RayHit>& hit) {
        PythonDraw to(on);
        draw(to, ray_of(origin, direction), checked_reach(length, "length"), hit);
      },
      py::arg("on"), py::arg("origin"), py::arg("direction"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("hit") = py::none(),
      "A ray up to its `hit`, a RayHit, with the normal there; one without as an arrow of its length, or to the end of "
      "what is looked at.");
  m.def(
      "draw_cast",
      [](const py::object& on, const typename Words::Shape& shape, const Placement& pose, const Vector& linear,
         double duration, const typename Words::Turning& angular, const std::optional<typename Space::CastHit>& hit) {
        PythonDraw to(on);
        draw(to, Words::value_of(shape), pose.value, Words::velocity(linear, angular), checked_duration(duration), hit);
      },
      py::arg("on"), py::arg("shape"), py::arg("pose"), py::arg("linear"), py::arg("duration") = 1.0,
      py::arg("angular") = typename Words::Turning{}, py::arg("hit") = py::none(),
      "A moving shape up to its `hit`, a CastHit, or for `duration`: its path, places along it, and the hit.");
  m.def(
      "draw_joint",
      [](const py::object& on, const Placement& frame_a, const Placement& pose_a, const Placement& frame_b,
         const Placement& pose_b) {
        PythonDraw to(on);
        draw(to, Joint<double, Space>{{}, {}, frame_a.value, frame_b.value, {}, {}, false}, pose_a.value, pose_b.value);
      },
      py::arg("on"), py::arg("frame_a"), py::arg("pose_a"), py::arg("frame_b"), py::arg("pose_b"),
      "A joint of bodies at these poses: from either origin to its anchor, and the gap between the anchors.");
}

/// Defines the drawing of an answer, of space or of the plane.
template <class Answer>
void add_answer(py::module_& m, const char* doc) {
  m.def(
      "draw",
      [](const py::object& on, const Answer& answer) {
        PythonDraw to(on);
        draw(to, answer);
      },
      py::arg("on"), py::arg("answer"), doc);
}

}  // namespace

DrawMeaning meaning_of(const std::string& word) {
  return static_cast<DrawMeaning>(place_of(meaning_words, word, "meaning"));
}

PythonDraw::PythonDraw(const py::object& on)
    : DebugDraw(area_of(on)),
      on_(on),
      point_(method_of(on, "point")),
      line_(method_of(on, "line")),
      triangle_(method_of(on, "triangle")),
      text_(method_of(on, "text")),
      polygon_(method_of(on, "polygon")),
      arrow_(method_of(on, "arrow")) {
  if (py::hasattr(on, "layers")) read_layers(on.attr("layers"));
}

void PythonDraw::read_layers(const py::object& words) {
  layers_.emplace();
  if (py::isinstance<py::str>(words)) throw py::type_error("layers: expected a list of words, got one word");
  for (const py::handle layer : words) {
    if (!py::isinstance<py::str>(layer)) throw py::type_error("layers: expected a list of words");
    layers_->insert(static_cast<DrawLayer>(place_of(layer_words, layer.cast<std::string>(), "layers")));
  }
}

void PythonDraw::point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) {
  hand(point_, layer, meaning, array_of(at));
}
void PythonDraw::line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) {
  hand(line_, layer, meaning, array_of(from), array_of(to));
}
void PythonDraw::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) {
  hand(triangle_, layer, meaning, array_of(a), array_of(b), array_of(c));
}
void PythonDraw::text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) {
  hand(text_, layer, meaning, array_of(at), py::str(std::string(words)));
}
void PythonDraw::polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) {
  if (polygon_.is_none()) return DebugDraw::polygons(shape, layer, meaning);
  for (const auto& loop : shape.loops) hand(polygon_, layer, meaning, array_of_loop(shape, loop));
}
void PythonDraw::arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) {
  if (arrow_.is_none()) return DebugDraw::arrow(from, direction, layer, meaning);
  hand(arrow_, layer, meaning, array_of(from), array_of(direction));
}

void add_draw(py::module_& m) {
  m.def(
      "draw",
      [](const py::object& on, const Shaped& shape, const Placement& pose, const std::string& meaning) {
        PythonDraw to(on);
        draw(to, shape, pose.value, meaning_of(meaning));
      },
      py::arg("on"), py::arg("shape"), py::arg("pose") = py::none(), py::arg("meaning") = "moving",
      R"(Shows what the library knows through a renderer of yours.

on: any object. Of its methods those that it has are called: point(at, layer, meaning), line(from,
to, layer, meaning), triangle(a, b, c, layer, meaning), counter-clockwise seen from outside,
text(at, words, layer, meaning), and polygon(corners, layer, meaning) instead of the triangles and
lines of a face, arrow(from, direction, layer, meaning) instead of the lines of an arrow. Places
are arrays of three numbers in the world. layer: shapes, bounds, tree, contacts, distances, rays,
casts, trace or joints; on.layers, if there, are those that are wanted. meaning: what the colour is
to say, as in suggested_color. on.center (three numbers) and on.size (> 0) say what is looked at:
what has no end is drawn as far. Raises ValueError, and what the methods raise.

>>> import graze
>>> class Corners:
...     def polygon(self, corners, layer, meaning):
...         print(layer, meaning, corners.shape)  # a triangle has two sides
>>> graze.draw(Corners(), graze.Triangle((0, 0, 0), (1, 0, 0), (0, 1, 0)))
shapes moving (3, 3)
shapes moving (3, 3)
)");
  m.def(
      "tessellate",
      [](const Shaped& shape, const Placement& pose, const Vector& center, double half_space_size) {
        return object_of(tessellate(shape, pose.value, validate::point(center.value, "center"),
                                    validate::extent(half_space_size, "half_space_size")));
      },
      py::arg("shape"), py::arg("pose") = py::none(), py::arg("center") = Vector{}, py::arg("half_space_size") = 1.0,
      R"(The faces of a shape as polygons, curved ones sampled for the eye: a dictionary.

points: shape (n, 3), in the world. loops: arrays of their indices, counter-clockwise seen from
outside. smooth: whether edges come from the sampling. closed: whether there is an inside. A
half-space is a square whose sides are twice half_space_size, about the foot of center. Raises
ValueError.

>>> import graze
>>> box = graze.tessellate(graze.Box((1, 1, 1)))
>>> len(box["points"]), [len(loop) for loop in box["loops"]]
(8, [4, 4, 4, 4, 4, 4])
)");
  add_answer<Manifold<double>>(m, "Points of contact, and the normal as an arrow from their middle.");
  add_answer<Distance<double>>(m, "The shortest way between two shapes, or out of each other.");
  add_worlds<SpaceWords>(m);
  add_paths<SpaceWords>(m);
  m.def(
      "draw_bounds",
      [](const py::object& on, const Vector& lower, const Vector& upper, const std::string& layer) {
        PythonDraw to(on);
        draw(to, Aabb<double>{lower.value, upper.value}, static_cast<DrawLayer>(place_of(layer_words, layer, "layer")));
      },
      py::arg("on"), py::arg("lower"), py::arg("upper"), py::arg("layer") = "bounds",
      "A box by its edges; nothing for one that is empty or has no end. layer: tree for the parts of a BroadPhase.");
  m.def(
      "suggested_color",
      [](const std::string& meaning) {
        const DrawColor c = suggested_color(meaning_of(meaning));
        return py::make_tuple(c.red, c.green, c.blue);
      },
      py::arg("meaning"), R"(The colour (red, green, blue; 0 to 255) that the project's own pictures give a meaning.

meaning: a, b, fixed, touched, moving, touching, asleep, trigger, contact, normal, gap, ruled_out,
bounds, path, ghost or joint. Raises ValueError.

>>> import graze
>>> graze.suggested_color("contact")
(193, 18, 31)
)");
}

void add_plane_draw(py::module_& m) {
  m.def(
      "draw",
      [](const py::object& on, const plane::Shaped& shape, const Placement2& pose, const std::string& meaning) {
        PythonDraw to(on);
        draw(to, shape, pose.value, meaning_of(meaning));
      },
      py::arg("on"), py::arg("shape"), py::arg("pose") = py::none(), py::arg("meaning") = "moving",
      R"(As graze.draw: shows what is known of the plane through a renderer of yours. Places have three
numbers there too, the last of which is 0.

>>> from graze import plane
>>> class Corners:
...     def polygon(self, corners, layer, meaning):
...         print(len(corners))
>>> plane.draw(Corners(), plane.Box((1, 2)), (3, 0))
4
)");
  m.def(
      "tessellate",
      [](const plane::Shaped& shape, const Placement2& pose, const Vector2& center, double half_plane_size) {
        const plane::Vec2d at = checked(center.value, "center");
        return object_of(
            tessellate(shape, pose.value, Vec3d{at.x, at.y, 0}, validate::extent(half_plane_size, "half_plane_size")));
      },
      py::arg("shape"), py::arg("pose") = py::none(), py::arg("center") = Vector2{}, py::arg("half_plane_size") = 1.0,
      R"(The outline of a shape, as graze.tessellate: points have three numbers, the last of which is 0.

A half-plane reaches half_plane_size to both sides of the foot of center.)");
  add_answer<plane::Manifold<double>>(m, "Points of contact, and the normal as an arrow from their middle.");
  add_answer<plane::Distance<double>>(m, "The shortest way between two shapes, or out of each other.");
  add_worlds<PlaneWords>(m);
  add_paths<PlaneWords>(m);
}

}  // namespace graze::python
