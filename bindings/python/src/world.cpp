// A world: bodies that come, move and go, what touches, and questions about all of them.
#include "answers.hpp"
#include "shapes.hpp"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

namespace graze::python {

namespace {

QueryFilter query_filter(std::uint64_t category, std::uint64_t mask, bool triggers) {
  return {Filter{category, mask, 0}, triggers, {}};
}

/// A body's place in the arrays of its world.
std::size_t index_of(const World<double>& w, BodyId id) {
  if (!w.bodies().contains(id)) validate::fail("body", "a body of this world", "one that was removed, or another's");
  return id.index;
}

/// The bodies of the pairs that touch, and their points, as arrays of their own.
py::array_t<std::uint32_t> pairs_of(const ContactArrays<double>& found) {
  py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(found.pairs.size()), py::ssize_t{2}});
  std::uint32_t* to = out.mutable_data();
  for (const auto& pair : found.pairs) {
    *to++ = pair.a;
    *to++ = pair.b;
  }
  return out;
}

template <class Record>
py::array copied(const std::vector<Record>& values, const py::dtype& type) {
  return records(std::vector<Record>(values), type);
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
py::dtype contact_manifold_type() {
  using M = ContactManifold<double>;
  return record_type({{"normal", "(3,)f8", offsetof(M, normal)},
                      {"piece_a", "u4", offsetof(M, piece_a)},
                      {"piece_b", "u4", offsetof(M, piece_b)},
                      {"first_point", "u4", offsetof(M, first_point)},
                      {"point_count", "u4", offsetof(M, point_count)}},
                     sizeof(M));
}

py::tuple object_of(const ContactEvent& event) {
  const char* kind = event.kind == EventKind::begin ? "begin" : event.kind == EventKind::stay ? "stay" : "end";
  return py::make_tuple(kind, event.a, event.b, event.trigger);
}

using WorldClass = py::class_<World<double>>;

void add_bodies(WorldClass& world) {
  world
      .def(
          "add",
          [](World<double>& w, const Shaped& shape, const Placement& pose, const Vector& linear, const Vector& angular,
             const Filter& filter, bool fixed, bool trigger, bool fast) {
            return w.add({shape, pose.value, linear.value, angular.value, filter, fixed, trigger, fast});
          },
          py::arg("shape"), py::arg("pose") = py::none(), py::arg("linear") = Vector{}, py::arg("angular") = Vector{},
          py::arg("filter") = Filter{}, py::arg("fixed") = false, py::arg("trigger") = false, py::arg("fast") = false,
          R"(Adds a body and returns its BodyId.

linear, angular: velocities in world axes. fixed: never moves by itself; two fixed bodies are no
pair. trigger: only tells what is inside it. fast: asked what it would pass through.)")
      .def("remove", &World<double>::remove, py::arg("body"))
      .def(
          "move", [](World<double>& w, BodyId id, const Placement& pose) { w.move(id, pose.value); }, py::arg("body"),
          py::arg("pose"), "Puts a body elsewhere; its velocities stay.")
      .def(
          "move_all",
          [](World<double>& w, const std::vector<BodyId>& ids, const py::object& poses) {
            const Rows given = rows(poses, 7, "poses");
            if (static_cast<std::size_t>(given.shape(0)) != ids.size())
              validate::fail("poses", std::to_string(ids.size()) + " rows, one for each body",
                             static_cast<double>(given.shape(0)));
            for (std::size_t i = 0; i < ids.size(); ++i) {
              const double* p = given.data(static_cast<py::ssize_t>(i), 0);
              const std::string path = "poses[" + std::to_string(i) + "]";
              w.move(ids[i], {validate::point(Vec3d{p[0], p[1], p[2]}, path),
                              validate::rotation(Quatd{p[3], p[4], p[5], p[6]}, path)});
            }
          },
          py::arg("bodies"), py::arg("poses"), "Puts many elsewhere: rows of translation and quaternion.")
      .def(
          "set_shape", [](World<double>& w, BodyId id, const Shaped& shape) { w.set_shape(id, shape); },
          py::arg("body"), py::arg("shape"))
      .def("set_filter", &World<double>::set_filter, py::arg("body"), py::arg("filter"))
      .def(
          "shape",
          [](const World<double>& w, BodyId id) { return python::object_of(w.bodies().shapes()[index_of(w, id)]); },
          py::arg("body"))
      .def(
          "pose", [](const World<double>& w, BodyId id) { return w.bodies().poses()[index_of(w, id)]; },
          py::arg("body"))
      .def("__contains__", [](const World<double>& w, BodyId id) { return w.bodies().contains(id); })
      .def("__len__", [](const World<double>& w) { return w.bodies().count(); });
}

void add_contacts(WorldClass& world) {
  world
      .def(
          "update",
          [](World<double>& w, double duration) {
            const py::gil_scoped_release free;
            w.update(duration);
          },
          py::arg("duration") = 0.0,
          "Finds what touches now, and what fast bodies would pass through within `duration`.")
      .def_property_readonly(
          "events",
          [](const World<double>& w) {
            py::list out;
            for (const auto& event : w.events()) out.append(object_of(event));
            return out;
          },
          "Of the last update: (kind, a, b, trigger), kind 'begin', 'stay' or 'end'.")
      .def_property_readonly(
          "impacts",
          [](const World<double>& w) {
            py::list out;
            for (const auto& i : w.impacts()) out.append(py::make_tuple(i.a, i.b, i.hit, i.trigger));
            return out;
          },
          "Of the last update, in the order of time: (a, b, CastHit, trigger).")
      .def_property_readonly(
          "touching", [](const World<double>& w) { return pairs_of(w.contacts()); },
          "The indices of the pairs within their margin: shape (n, 2).")
      .def_property_readonly(
          "pairs", [type = contact_pair_type()](const World<double>& w) { return copied(w.contacts().pairs, type); },
          "Records: a, b, overlap, first_manifold, manifold_count.")
      .def_property_readonly(
          "manifolds",
          [type = contact_manifold_type()](const World<double>& w) { return copied(w.contacts().manifolds, type); },
          "Records: normal, piece_a, piece_b, first_point, point_count.")
      .def_property_readonly(
          "points", [type = solver_point_type()](const World<double>& w) { return copied(w.contacts().points, type); },
          "Records: a, b, distance, feature, weight, impulse.")
      .def(
          "set_impulses",
          [](World<double>& w, const py::object& impulses) {
            const Rows given = rows(impulses, 3, "impulses");
            auto& points = w.contacts().points;
            if (static_cast<std::size_t>(given.shape(0)) != points.size())
              validate::fail("impulses", std::to_string(points.size()) + " rows, one for each point",
                             static_cast<double>(given.shape(0)));
            const std::vector<Vec3d> read = points_of(given);
            for (std::size_t i = 0; i < points.size(); ++i) points[i].impulse = read[i];
          },
          py::arg("impulses"), "A solver's own, which the next update carries on to the points that are the same.");
}

void add_questions(WorldClass& world) {
  const auto all = ~std::uint64_t{0};
  world
      .def(
          "overlapping",
          [](const World<double>& w, const Shaped& shape, const Placement& pose, std::uint64_t category,
             std::uint64_t mask, bool triggers) {
            std::vector<BodyId> found;
            w.overlapping(shape, pose.value, query_filter(category, mask, triggers), found);
            return found;
          },
          py::arg("shape"), py::arg("pose") = py::none(), py::arg("category") = all, py::arg("mask") = all,
          py::arg("triggers") = false, "The bodies that touch a shape.")
      .def(
          "nearest",
          [](const World<double>& w, const Shaped& shape, const Placement& pose, std::size_t count, double limit,
             std::uint64_t category, std::uint64_t mask) {
            if (!(limit >= 0)) validate::fail("limit", "a number >= 0", limit);
            std::vector<BodyDistance<double>> found;
            w.nearest(shape, pose.value, count, limit, query_filter(category, mask, false), found);
            py::list out;
            for (const auto& f : found) out.append(py::make_tuple(f.body, f.distance));
            return out;
          },
          py::arg("shape"), py::arg("pose") = py::none(), py::arg("count") = 1,
          py::arg("limit") = std::numeric_limits<double>::infinity(), py::arg("category") = all, py::arg("mask") = all,
          "The `count` bodies nearest to a shape, the nearest first: (BodyId, Distance).")
      .def(
          "raycast",
          [](const World<double>& w, const Vector& origin, const Vector& direction, double length,
             std::uint64_t category, std::uint64_t mask) -> py::object {
            if (!(length >= 0)) validate::fail("length", "a number >= 0", length);
            const auto hit = w.raycast({origin.value, direction.value}, length, query_filter(category, mask, false));
            return hit ? py::object(py::make_tuple(hit->body, hit->hit)) : py::none();
          },
          py::arg("origin"), py::arg("direction"), py::arg("length") = std::numeric_limits<double>::infinity(),
          py::arg("category") = all, py::arg("mask") = all, "The first body that a ray hits: (BodyId, RayHit) or None.")
      .def(
          "cast",
          [](const World<double>& w, const Shaped& shape, const Placement& pose, const Vector& linear, double duration,
             const Vector& angular, std::uint64_t category, std::uint64_t mask) -> py::object {
            if (!(duration >= 0 && duration <= largest_magnitude<double>))
              validate::fail("duration", "a finite number >= 0", duration);
            const Velocity<double> velocity{validate::point(linear.value, "linear"),
                                            validate::point(angular.value, "angular")};
            const auto hit = w.cast(shape, pose.value, velocity, duration, query_filter(category, mask, false));
            return hit ? py::object(py::make_tuple(hit->body, hit->hit)) : py::none();
          },
          py::arg("shape"), py::arg("pose"), py::arg("linear"), py::arg("duration") = 1.0,
          py::arg("angular") = Vector{}, py::arg("category") = all, py::arg("mask") = all,
          "The first body that a moving shape meets: (BodyId, CastHit) or None; the bodies stand still.");
}

}  // namespace

py::dtype solver_point_type() {
  using P = SolverPoint<double>;
  using Base = ContactPoint<double>;
  return record_type({{"a", "(3,)f8", offsetof(Base, a)},
                      {"b", "(3,)f8", offsetof(Base, b)},
                      {"distance", "f8", offsetof(Base, distance)},
                      {"feature", "u4", offsetof(Base, feature)},
                      {"weight", "f8", offsetof(Base, weight)},
                      {"impulse", "(3,)f8", sizeof(P) - sizeof(Vec3d)}},
                     sizeof(P));
}

void add_world(py::module_& m) {
  py::class_<BodyId>(m, "BodyId", "A handle of a body: its index, and how often that was given away before.")
      .def_readonly("index", &BodyId::index)
      .def_readonly("generation", &BodyId::generation)
      .def(
          "__eq__", [](const BodyId& a, const BodyId& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const BodyId& id) { return py::hash(py::make_tuple(id.index, id.generation)); })
      .def("__repr__", [](const BodyId& id) {
        return "graze.BodyId(index=" + std::to_string(id.index) + ", generation=" + std::to_string(id.generation) + ")";
      });
  py::class_<Filter>(m, "Filter", R"(What a body is and what it collides with.

category, mask: 64 bits; two bodies may collide when each one's category meets the other's mask.
group: of equal groups, positive always collide and negative never; 0 is no group.)")
      .def(py::init([](std::uint64_t category, std::uint64_t mask, std::int32_t group) {
             return Filter{category, mask, group};
           }),
           py::arg("category") = 1, py::arg("mask") = ~std::uint64_t{0}, py::arg("group") = 0)
      .def_readonly("category", &Filter::category)
      .def_readonly("mask", &Filter::mask)
      .def_readonly("group", &Filter::group)
      .def("__repr__", [](const Filter& f) {
        return py::str("graze.Filter(category={}, mask={}, group={})").format(f.category, f.mask, f.group);
      });
  WorldClass world(m, "World", R"(Bodies that come, move and go, and what touches.

margin: contacts are reported up to this far apart; by default a hundredth of the smaller body's
size. points_per_pair: at most so many points a pair.

>>> import graze
>>> world = graze.World()
>>> floor = world.add(graze.HalfSpace(), fixed=True)
>>> ball = world.add(graze.Sphere(0.5), (0, 0.49, 0))
>>> world.update()
>>> [(kind, a.index, b.index) for kind, a, b, _ in world.events]
[('begin', 0, 1)]
)");
  world.def(py::init([](std::optional<double> margin, std::optional<std::size_t> points_per_pair) {
              WorldSettings<double> settings;
              settings.margin = margin;
              settings.points_per_pair = points_per_pair;
              return std::make_unique<World<double>>(std::move(settings));
            }),
            py::arg("margin") = py::none(), py::arg("points_per_pair") = py::none());
  add_bodies(world);
  add_contacts(world);
  add_questions(world);
}

}  // namespace graze::python
