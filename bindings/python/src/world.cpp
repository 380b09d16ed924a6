// A world of space, and the parts that worlds of space and the plane share: handles of bodies, filters, events.
#include "shapes.hpp"
#include "space_batch.hpp"
#include "whole.hpp"
#include "world_methods.hpp"

namespace graze::python {

namespace {

void add_handles(py::module_& m) {
  py::class_<BodyId>(m, "BodyId", "A handle of a body: its index, and how often that was given away before.")
      .def_readonly("index", &BodyId::index, "The place in all arrays of the world.")
      .def_readonly("generation", &BodyId::generation, "How often the index was given away before.")
      .def(
          "__eq__", [](const BodyId& a, const BodyId& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const BodyId& id) { return py::hash(py::make_tuple(id.index, id.generation)); })
      .def(pickled<BodyId>(&BodyId::index, &BodyId::generation))
      .def("__repr__", [](const BodyId& id) {
        return "graze.BodyId(index=" + std::to_string(id.index) + ", generation=" + std::to_string(id.generation) + ")";
      });
  py::class_<Filter>(m, "Filter", R"(What a body is and what it collides with.

category, mask: 64 bits; two bodies may collide when each one's category meets the other's mask.
group: of equal groups, positive always collide and negative never; 0 is no group.)")
      .def(py::init([](const Whole& category, const Whole& mask, const Whole& group) {
             return Filter{category.as<std::uint64_t>("category"), mask.as<std::uint64_t>("mask"),
                           group.as<std::int32_t>("group")};
           }),
           py::arg("category") = Whole(Filter{}.category), py::arg("mask") = Whole(Filter{}.mask),
           py::arg("group") = Whole(Filter{}.group))
      .def_readonly("category", &Filter::category, "The bits that the body belongs to.")
      .def_readonly("mask", &Filter::mask, "The bits that it collides with.")
      .def_readonly("group", &Filter::group,
                    "Bodies of one group collide always if it is positive, never if negative; 0 is no group.")
      .def(
          "may_collide", [](const Filter& a, const Filter& b) { return may_collide(a, b); }, py::arg("other"),
          R"(Whether two bodies with these filters may collide.

>>> import graze
>>> graze.Filter(category=2, mask=1).may_collide(graze.Filter(category=1, mask=4))
False
)")
      .def(pickled<Filter>(&Filter::category, &Filter::mask, &Filter::group))
      .def("__repr__", [](const Filter& f) {
        return py::str("graze.Filter(category={}, mask={}, group={})").format(f.category, f.mask, f.group);
      });
}

}  // namespace

py::tuple object_of(const ContactEvent& event) {
  const char* kind = event.kind == EventKind::begin ? "begin" : event.kind == EventKind::stay ? "stay" : "end";
  return py::make_tuple(kind, event.a, event.b, event.trigger);
}

py::dtype contact_pair_type() {
  using P = ContactPair<double>;
  return record_type({{"a", "u4", offsetof(P, a)},
                      {"b", "u4", offsetof(P, b)},
                      {"overlap", "?", offsetof(P, overlap)},
                      {"first_manifold", "u4", offsetof(P, first_manifold)},
                      {"manifold_count", "u4", offsetof(P, manifold_count)}},
                     sizeof(P));
}

py::array_t<std::uint32_t> indices_of(std::span<const ContactPair<double>> pairs) {
  py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::uint32_t* to = out.mutable_data();
  for (const auto& pair : pairs) {
    *to++ = pair.a;
    *to++ = pair.b;
  }
  return out;
}

py::object SpaceWords::Shapes::object(const World<double>& world, std::size_t index) {
  return python::object_of(world.bodies().shapes()[index]);
}

py::dtype solver_point_type() { return WorldMethods<SpaceWords>::solver_point_type(); }

void add_world(py::module_& m) {
  add_handles(m);
  m.def(
      "along_planes",
      [](const Vector& motion, const py::object& normals) {
        const std::vector<Vec3d> away = points_of(rows(normals, 3, "normals"));
        for (std::size_t i = 0; i < away.size(); ++i)
          unit_vector<SpaceBatch>(away[i], "normals[" + std::to_string(i) + "]");
        return array_of(along_planes<double>(validate::point(motion.value, "motion"), away));
      },
      py::arg("motion"), py::arg("normals"),
      R"(The part of a motion that planes leave: the nearest motion that leads into none of them.

normals: unit vectors away from the obstacles, shape (n, 3). Raises ValueError.

>>> import graze
>>> graze.along_planes((1, -1, 0), [(0, 1, 0)])
array([1., 0., 0.])
)");
  WorldMethods<SpaceWords>::add(m, "A world to read: its bodies, what touched in the last update, and questions.",
                                R"(Bodies that come, move and go, and what touches.

margin: contacts are reported up to this far apart, >= 0; by default a hundredth of the smaller
body's size. points_per_pair: at most so many points a pair. allow: the final decision on
pairs that their filters allow, a function of two BodyIds. threads: how many run an update, or a
`graze.Threads`; the result has the same bits. Raises ValueError.

>>> import graze
>>> world = graze.World()
>>> floor = world.add(graze.HalfSpace(), fixed=True)
>>> ball = world.add(graze.Sphere(0.5), (0, 0.49, 0))
>>> world.update()
>>> [(kind, a.index, b.index) for kind, a, b, _ in world.events]
[('begin', 0, 1)]
)");
  WorldMethods<SpaceWords>::add_captured(m);
}

}  // namespace graze::python
