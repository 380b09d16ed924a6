// The methods of worlds, for space and the plane: written once over the words of `world.hpp`.
#pragma once

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "answers.hpp"
#include "decision.hpp"
#include "graze/slide.hpp"
#include "graze/world/reduce.hpp"
#include "plain_values.hpp"
#include "shapes.hpp"
#include "spare.hpp"
#include "whole.hpp"
#include "world.hpp"

namespace graze::python {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::uint64_t all_bits = ~std::uint64_t{0};

py::tuple object_of(const ContactEvent& event);
py::dtype contact_pair_type();

/// The indices of the bodies of each pair.
py::array_t<std::uint32_t> indices_of(std::span<const ContactPair<double>> pairs);

/// The methods of a world of space or the plane.
template <class Words>
class WorldMethods {
 public:
  using Space = typename Words::Space;
  using Shape = typename Words::Shape;
  using Vector = typename Words::Vector;
  using Turning = typename Words::Turning;
  using Placement = typename Words::Placement;
  using View = WorldView<Words>;

  /// Defines the classes `WorldView` and `World`.
  static void add(py::module_& m, const char* view_doc, const char* world_doc) {
    py::class_<View> view(m, "WorldView", view_doc);
    add_bodies(view);
    add_contacts(view);
    add_shape_questions(view);
    add_ray_questions(view);
    using Own = OwnWorld<Words>;
    py::class_<Own, View> world(m, "World", world_doc, collected<Own>());
    world
        .def(py::init([](std::optional<double> margin, const std::optional<Whole>& points_per_pair,
                         const py::object& allow, const ThreadsArgument& threads) {
               WorldSettings<double> given = settings(margin, points_per_pair);
               given.allow = decision<BodyId, BodyId>(allow, "allow");
               auto made = std::make_unique<Own>(threads.own(), given);
               made->note_allow(allow);
               return made;
             }),
             py::arg("margin") = py::none(), py::arg("points_per_pair") = py::none(), py::arg("allow") = py::none(),
             py::arg("threads") = py::none())
        .def(
            "set_allow",
            [](Own& w, const py::object& allow) {
              w.change()->set_allow(decision<BodyId, BodyId>(allow, "allow"));
              w.note_allow(allow);
            },
            py::arg("allow"),
            "Replaces the final decision on pairs, a function of two BodyIds, from the next update on; None allows "
            "all.")
        .def("set_impulses", &set_impulses, py::arg("impulses"),
             (std::string("What a solver has pushed at each of `points`, shape (n, ") +
              std::to_string(Words::vector_size) +
              ").\n\nThe next update carries it on to the points that are the same.")
                 .c_str())
        .def(
            "reduce",
            [](Own& w, const Whole& count) {
              graze::reduce(w.change()->contacts(), count.at_least<std::size_t>(1, "count"));
            },
            py::arg("count"),
            R"(Keeps at most `count` points of each pair, of all its manifolds together: those that span most.

Until the next update, which finds a pair whole again where anything of it changed; `points_per_pair`
does it in every update. Raises ValueError for no points.)");
    add_changes(world);
  }

  /// Defines the class `CapturedWorld`.
  static void add_captured(py::module_& m) {
    using Own = OwnWorld<Words, ToFile<CapturedWorld<double, Space>>>;
    py::class_<Own, View> world(
        m, "CapturedWorld",
        R"(A World whose calls are written to a file, which `graze.replay` and the program graze play.

A frame is in the file when `update` returns. Shapes are those that the file holds: a convex hull is
built anew from its vertices. Raises ValueError for a file that takes no bytes, and for what a file
cannot hold: a shape with a support function in Python. threads: as of World.)");
    world
        .def(py::init([](const std::filesystem::path& file, std::optional<double> margin,
                         const std::optional<Whole>& points_per_pair, const ThreadsArgument& threads) {
               return std::make_unique<Own>(threads.own(), file, settings(margin, points_per_pair));
             }),
             py::arg("file"), py::arg("margin") = py::none(), py::arg("points_per_pair") = py::none(),
             py::arg("threads") = py::none())
        .def(
            "set_name", [](Own& w, BodyId id, const std::string& name) { w.change()->set_name(id, name); },
            py::arg("body"), py::arg("name"), "What `graze.replay` calls a body from here on.");
    add_changes(world);
  }

  /// The type of records of a solver's points. The fields of a contact point are those of one by itself, and the
  /// impulse behind them ends the record: C++ defines `offsetof` only for structs that have their fields in one class.
  static py::dtype solver_point_type() {
    using P = SolverPoint<double, Space>;
    using Base = typename Space::ContactPoint;
    static_assert(sizeof(P) == sizeof(Base) + sizeof(typename Space::Vec));
    return record_type({{"a", Words::vector_type, offsetof(Base, a)},
                        {"b", Words::vector_type, offsetof(Base, b)},
                        {"distance", "f8", offsetof(Base, distance)},
                        {"feature", "u4", offsetof(Base, feature)},
                        {"weight", "f8", offsetof(Base, weight)},
                        {"impulse", Words::vector_type, sizeof(Base)}},
                       sizeof(P));
  }

 private:
  using ViewClass = py::class_<View>;

  static WorldSettings<double> settings(std::optional<double> margin, const std::optional<Whole>& points_per_pair) {
    WorldSettings<double> settings;
    settings.margin = margin;
    if (points_per_pair) settings.points_per_pair = points_per_pair->as<std::size_t>("points_per_pair");
    return settings;
  }

  /// Defines a question whose last arguments are a filter's; `Given` are those before, with their names.
  template <class... Given, class Ask, class... Names>
  static void add_question(ViewClass& view, const char* name, const Ask& ask, const char* doc, const Names&... names) {
    view.def(
        name,
        [ask](const View& w, const Given&... given, const Whole& category, const Whole& mask, bool triggers,
              const Whole& group, const py::object& accept) {
          const Filter filter{category.as<std::uint64_t>("category"), mask.as<std::uint64_t>("mask"),
                              group.as<std::int32_t>("group")};
          return ask(w, given..., QueryFilter{filter, triggers, decision<BodyId>(accept, "accept")});
        },
        names..., py::arg("category") = Whole(all_bits), py::arg("mask") = Whole(all_bits), py::arg("triggers") = false,
        py::arg("group") = Whole(0), py::arg("accept") = py::none(), doc);
  }

  static py::dtype manifold_type() {
    using M = ContactManifold<double, Space>;
    return record_type({{"normal", Words::vector_type, offsetof(M, normal)},
                        {"piece_a", "u4", offsetof(M, piece_a)},
                        {"piece_b", "u4", offsetof(M, piece_b)},
                        {"first_point", "u4", offsetof(M, first_point)},
                        {"point_count", "u4", offsetof(M, point_count)}},
                       sizeof(M));
  }

  template <class Record>
  static py::array copied(const std::vector<Record>& values, const py::dtype& type) {
    return records(std::vector<Record>(values), type);
  }
  using RayHit = typename Space::RayHit;
  using CastHit = typename Space::CastHit;
  /// A body and a hit of it, a pair in Python.
  template <class Hit>
  using BodyAnd = std::tuple<BodyId, Hit>;

  template <class Hit, class Found>
  static std::optional<BodyAnd<Hit>> body_and_hit(const std::optional<Found>& found) {
    if (!found) return std::nullopt;
    return BodyAnd<Hit>{found->body, found->hit};
  }
  template <class Hit, class Hits>
  static std::vector<BodyAnd<Hit>> bodies_and_hits(const Hits& hits) {
    std::vector<BodyAnd<Hit>> out;
    for (const auto& hit : hits) out.push_back({hit.body, hit.hit});
    return out;
  }

  template <class Own>
  static void move_all(Own& own, const std::vector<BodyId>& ids, const py::object& poses) {
    // All poses are read and all handles checked before any body moves: an error has changed nothing.
    const std::vector<typename Space::Pose> read = poses_of(poses);
    if (read.size() != ids.size())
      validate::fail("poses", std::to_string(ids.size()) + " rows, one for each body",
                     static_cast<double>(read.size()));
    const auto world = own.change();
    for (const BodyId id : ids) index_of(asked(*world), id);
    for (std::size_t i = 0; i < ids.size(); ++i) world->move(ids[i], read[i]);
  }

  /// Poses from the rows of an array, or from a sequence of poses in any form that one has.
  static std::vector<typename Space::Pose> poses_of(const py::object& given) {
    std::vector<typename Space::Pose> poses;
    const auto add = [&](const auto& read) {
      try {
        poses.push_back(read());
      } catch (const InvalidValue& error) {
        throw error.below("poses[" + std::to_string(poses.size()) + "]");
      }
    };
    if (py::isinstance<py::array>(given) && py::array(given).ndim() == 2 &&
        py::array(given).shape(1) == Words::pose_size) {
      const Rows all = rows(given, Words::pose_size, "poses");
      for (py::ssize_t i = 0; i < all.shape(0); ++i) add([&] { return Words::pose_of_row(all.data(i, 0)); });
      return poses;
    }
    if (!py::isinstance<py::iterable>(given)) throw py::type_error("poses: expected an array or a sequence of poses");
    for (const py::handle one : given)
      add([&] {
        typename Space::Pose pose;
        if (!read_pose(one, pose)) throw py::type_error("poses[" + std::to_string(poses.size()) + "]: expected a pose");
        return pose;
      });
    return poses;
  }

  static void set_impulses(OwnWorld<Words>& own, const py::object& impulses) {
    const Rows given = rows(impulses, Words::vector_size, "impulses");
    const auto world = own.change();
    auto& points = world->contacts().points;
    if (static_cast<std::size_t>(given.shape(0)) != points.size())
      validate::fail("impulses", std::to_string(points.size()) + " rows, one for each point",
                     static_cast<double>(given.shape(0)));
    std::vector<typename Space::Vec> read(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      try {
        read[i] = Words::vector_of_row(given.data(static_cast<py::ssize_t>(i), 0));
      } catch (const InvalidValue& error) {
        throw error.below("impulses[" + std::to_string(i) + "]");
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) points[i].impulse = read[i];
  }

  template <class Own>
  static void add_changes(py::class_<Own, View>& world) {
    world
        .def(
            "add",
            [](Own& w, const Shape& shape, const Placement& pose, const Vector& linear, const Turning& angular,
               const Filter& filter, bool fixed, bool trigger, bool fast) {
              const auto changed = w.change();
              const BodyId id = changed->add({Words::value_of(shape), pose.value, Words::value_of(linear),
                                              Words::value_of(angular), filter, fixed, trigger, fast});
              w.shapes().keep(id.index, shape);
              return id;
            },
            py::arg("shape"), py::arg("pose") = py::none(), py::arg("linear") = Vector{},
            py::arg("angular") = Turning{}, py::arg("filter") = Filter{}, py::arg("fixed") = false,
            py::arg("trigger") = false, py::arg("fast") = false,
            (std::string(R"(Adds a body and returns its BodyId.

linear: velocity of the pose's origin in world axes, length per unit of time. angular:
)") + Words::turning_unit +
             R"(. fixed: never moves by itself; two fixed bodies are no pair.
trigger: tells that something is inside it and has no contact points. fast: asked what it would
pass through. Raises ValueError for a pose or velocity that is not finite.)")
                .c_str())
        .def(
            "remove",
            [](Own& w, BodyId id) {
              w.change()->remove(id);
              w.shapes().drop(id.index);
            },
            py::arg("body"),
            "Removes a body. Raises ValueError, as all that take one, for a body that was removed before.")
        .def(
            "move", [](Own& w, BodyId id, const Placement& pose) { w.change()->move(id, pose.value); }, py::arg("body"),
            py::arg("pose"), "Puts a body elsewhere; its velocities stay.")
        .def(
            "set_velocity",
            [](Own& w, BodyId id, const Vector& linear, const Turning& angular) {
              const auto changed = w.change();
              const auto& world = asked(*changed);
              const typename Space::Pose pose = world.bodies().poses()[index_of(world, id)];
              changed->move(id, pose, Words::value_of(linear), Words::value_of(angular));
            },
            py::arg("body"), py::arg("linear"), py::arg("angular") = Turning{},
            "Other velocities for a body that stays where it is.")
        .def("move_all", &move_all<Own>, py::arg("bodies"), py::arg("poses"),
             (std::string("Puts many bodies elsewhere: rows of ") + Words::pose_row +
              ", or a sequence of poses in any form.\n\nAll of them, or none where it raises ValueError.")
                 .c_str())
        .def(
            "set_shape",
            [](Own& w, BodyId id, const Shape& shape) {
              w.change()->set_shape(id, Words::value_of(shape));
              w.shapes().keep(id.index, shape);
            },
            py::arg("body"), py::arg("shape"), "Another shape for a body.")
        .def(
            "set_filter", [](Own& w, BodyId id, const Filter& filter) { w.change()->set_filter(id, filter); },
            py::arg("body"), py::arg("filter"), "Another filter for a body.")
        .def(
            "set_fast", [](Own& w, BodyId id, bool fast) { w.change()->set_fast(id, fast); }, py::arg("body"),
            py::arg("fast"), "Whether a body is asked what it would pass through before the next update.")
        .def(
            "find_impacts", [](Own& w, double duration) { w.change()->find_impacts(checked_duration(duration)); },
            py::arg("duration"),
            "What fast bodies would pass through within `duration`, as `impacts`, without an update.")
        .def("update", &Own::update, py::arg("duration") = 0.0,
             R"(Finds what touches now, and what fast bodies would pass through within `duration`.

The interpreter's lock is released meanwhile; a use of this world by another thread then raises
RuntimeError, as does a change of it by a support function in Python while it is asked. Raises
ValueError for a duration that is negative or not finite.)");
  }

  static void add_bodies(ViewClass& view) {
    view.def(
            "shape", [](const View& w, BodyId id) { return ShapeObject{w.shape(id)}; }, py::arg("body"),
            "The shape of a body.")
        .def(
            "pose",
            [](const View& w, BodyId id) {
              const auto world = w.read();
              return world->bodies().poses()[index_of(*world, id)];
            },
            py::arg("body"), "Where a body stands.")
        .def(
            "velocity",
            [](const View& w, BodyId id) {
              const auto world = w.read();
              const std::size_t i = index_of(*world, id);
              return py::make_tuple(Words::object_of(world->bodies().linear()[i]),
                                    Words::object_of(world->bodies().angular()[i]));
            },
            py::arg("body"), "(linear velocity of its origin, angular velocity), in world axes.")
        .def(
            "filter",
            [](const View& w, BodyId id) {
              const auto world = w.read();
              return world->bodies().filters()[index_of(*world, id)];
            },
            py::arg("body"), "What a body is and what it collides with.")
        .def(
            "body_at",
            [](const View& w, const Whole& index) -> std::optional<BodyId> {
              const auto place = index.as<std::uint32_t>("index");
              const auto world = w.read();
              const auto& bodies = world->bodies();
              if (place >= bodies.size() || bodies.alive()[place] == 0) return std::nullopt;
              return bodies.id(place);
            },
            py::arg("index"), "The BodyId of the body that has an index, as in `touching` and `pairs`, or None.")
        .def_property_readonly(
            "bodies",
            [](const View& w) {
              const auto world = w.read();
              const auto& bodies = world->bodies();
              std::vector<BodyId> out;
              for (std::uint32_t i = 0; i < bodies.size(); ++i)
                if (bodies.alive()[i] != 0) out.push_back(bodies.id(i));
              return out;
            },
            "The BodyIds of all bodies, by index.")
        .def_property_readonly(
            "poses",
            [](const View& w) {
              static_assert(sizeof(typename Space::Pose) == Words::pose_size * sizeof(double));
              const auto world = w.read();
              const auto poses = world->bodies().poses();
              return py::array_t<double>({static_cast<py::ssize_t>(poses.size()), Words::pose_size},
                                         reinterpret_cast<const double*>(poses.data()));
            },
            (std::string("Of all bodies, by index: rows of ") + Words::pose_row + " (a copy).").c_str())
        .def_property_readonly(
            "memory", [](const View& w) { return w.read()->memory(); }, "Bytes held, without those of the shapes.")
        .def("__contains__", [](const View& w, BodyId id) { return w.read()->bodies().contains(id); })
        .def("__len__", [](const View& w) { return w.read()->bodies().count(); })
        .def("__repr__", [](const py::object& self) {
          const auto world = self.cast<const View&>().read();
          return call_text(class_name(self), {{"bodies", py::cast(world->bodies().count())},
                                              {"pairs", py::cast(world->contacts().pairs.size())}});
        });
  }

  static void add_contacts(ViewClass& view) {
    view.def_property_readonly(
            "events",
            [](const View& w) {
              py::list out;
              const auto world = w.read();
              for (const ContactEvent& event : world->events()) out.append(object_of(event));
              return out;
            },
            "Of the last update: (kind, a, b, trigger), kind 'begin', 'stay' or 'end'.")
        .def_property_readonly(
            "impacts",
            [](const View& w) {
              py::list out;
              const auto world = w.read();
              for (const auto& impact : world->impacts())
                out.append(py::make_tuple(impact.a, impact.b, impact.hit, impact.trigger));
              return out;
            },
            "Of the last update, in the order of time: (a, b, CastHit, trigger).")
        .def_property_readonly(
            "touching", [](const View& w) { return indices_of(w.read()->contacts().pairs); },
            "The indices of the bodies of each pair within its margin: shape (n, 2).")
        .def_property_readonly(
            "pairs", [type = contact_pair_type()](const View& w) { return copied(w.read()->contacts().pairs, type); },
            "Records: a, b (indices of bodies), overlap, first_manifold, manifold_count.")
        .def_property_readonly(
            "manifolds",
            [type = manifold_type()](const View& w) { return copied(w.read()->contacts().manifolds, type); },
            "Records: normal, piece_a, piece_b, first_point, point_count.")
        .def_property_readonly(
            "points", [type = solver_point_type()](const View& w) { return copied(w.read()->contacts().points, type); },
            "Records: a, b, distance, feature, weight, impulse.");
  }

  static void add_shape_questions(ViewClass& view) {
    add_question<Shape, Placement>(
        view, "overlapping",
        [](const View& w, const Shape& shape, const Placement& pose, const QueryFilter& filter) {
          std::vector<BodyId> found;
          w.read()->overlapping(Words::value_of(shape), pose.value, filter, found);
          return found;
        },
        R"(The bodies that touch a shape, by index.

category, mask, group: of the question, as in a Filter; triggers: finds those too; accept: the final
decision on a body, a function of its BodyId. All questions to a world have them.)",
        py::arg("shape"), py::arg("pose") = py::none());
    add_question<Shape, Placement>(
        view, "overlaps_any",
        [](const View& w, const Shape& shape, const Placement& pose, const QueryFilter& filter) {
          return w.read()->overlaps_any(Words::value_of(shape), pose.value, filter);
        },
        "Whether any body touches a shape; ends at the first.", py::arg("shape"), py::arg("pose") = py::none());
    add_question<Shape, Placement, Whole, double>(
        view, "nearest",
        [](const View& w, const Shape& shape, const Placement& pose, const Whole& count, double limit,
           const QueryFilter& filter) {
          std::vector<BodyDistance<double, Space>> found;
          w.read()->nearest(Words::value_of(shape), pose.value, count.as<std::size_t>("count"),
                            checked_reach(limit, "limit"), filter, found);
          std::vector<BodyAnd<typename Space::Distance>> out;
          for (const auto& f : found) out.push_back({f.body, f.distance});
          return out;
        },
        "The `count` bodies nearest to a shape and within `limit`, the nearest first: (BodyId, Distance).",
        py::arg("shape"), py::arg("pose") = py::none(), py::arg("count") = Whole(1), py::arg("limit") = infinity);
    add_question<Shape, Placement, Vector, double, Turning>(
        view, "cast",
        [](const View& w, const Shape& shape, const Placement& pose, const Vector& linear, double duration,
           const Turning& angular, const QueryFilter& filter) {
          return body_and_hit<CastHit>(w.read()->cast(Words::value_of(shape), pose.value,
                                                      Words::velocity(linear, angular), checked_duration(duration),
                                                      filter));
        },
        "The first body that a moving shape meets: (BodyId, CastHit) or None; the bodies stand still.",
        py::arg("shape"), py::arg("pose"), py::arg("linear"), py::arg("duration") = 1.0,
        py::arg("angular") = Turning{});
    add_question<Shape, Placement, Vector, double, Turning>(
        view, "cast_all",
        [](const View& w, const Shape& shape, const Placement& pose, const Vector& linear, double duration,
           const Turning& angular, const QueryFilter& filter) {
          std::vector<BodyCastHit<double, Space>> hits;
          w.read()->cast_all(Words::value_of(shape), pose.value, Words::velocity(linear, angular),
                             checked_duration(duration), filter, hits);
          return bodies_and_hits<CastHit>(hits);
        },
        "All bodies that a moving shape meets, each where it is first met, in the order of time.", py::arg("shape"),
        py::arg("pose"), py::arg("linear"), py::arg("duration") = 1.0, py::arg("angular") = Turning{});
    add_question<Shape, Placement, Vector, Whole>(
        view, "slide",
        [](const View& w, const Shape& shape, const Placement& pose, const Vector& motion, const Whole& casts,
           const QueryFilter& filter) {
          const auto found = slide(Words::value_of(shape), pose.value, Words::checked(motion, "motion"), *w.read(),
                                   filter, SlideOptions{casts.at_least<int>(1, "casts")});
          return py::make_tuple(found.pose, Words::object_of(found.left), bodies_and_hits<CastHit>(found.touched));
        },
        R"(Moves a shape by `motion` until it touches, then along what it touches, and so on, without turning.

Returns (Pose where it ends, what is left of the motion after so many casts, what was in the way:
(BodyId, CastHit) in the order in which it was met). The bodies stand still. Raises ValueError.)",
        py::arg("shape"), py::arg("pose"), py::arg("motion"), py::arg("casts") = Whole(SlideOptions{}.iterations));
  }

  static void add_ray_questions(ViewClass& view) {
    add_question<Vector, Vector, double>(
        view, "raycast",
        [](const View& w, const Vector& origin, const Vector& direction, double length, const QueryFilter& filter) {
          return body_and_hit<RayHit>(
              w.read()->raycast(ray_of(origin, direction), checked_reach(length, "length"), filter));
        },
        "The first body that a ray hits: (BodyId, RayHit) or None.", py::arg("origin"), py::arg("direction"),
        py::arg("length") = infinity);
    add_question<Vector, Vector, double>(
        view, "raycast_any",
        [](const View& w, const Vector& origin, const Vector& direction, double length, const QueryFilter& filter) {
          return w.read()->raycast_any(ray_of(origin, direction), checked_reach(length, "length"), filter);
        },
        "Whether a ray hits any body; ends at the first.", py::arg("origin"), py::arg("direction"),
        py::arg("length") = infinity);
    add_question<Vector, Vector, double>(
        view, "raycast_all",
        [](const View& w, const Vector& origin, const Vector& direction, double length, const QueryFilter& filter) {
          std::vector<BodyRayHit<double, Space>> hits;
          w.read()->raycast_all(ray_of(origin, direction), checked_reach(length, "length"), filter, hits);
          return bodies_and_hits<RayHit>(hits);
        },
        "All bodies that a ray hits, each where it is first hit, in the order of the ray.", py::arg("origin"),
        py::arg("direction"), py::arg("length") = infinity);
  }
};

}  // namespace graze::python
