// The methods of simulations, for space and the plane: written once over the words of `world.hpp`.
#pragma once

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "answers.hpp"
#include "draw.hpp"
#include "graze/state_bytes.hpp"
#include "material.hpp"
#include "plain_values.hpp"
#include "whole.hpp"
#include "world.hpp"

namespace graze::python {

/// A simulation that raises RuntimeError where another call is in a step of it. Changes go to `Inner`.
template <class Words, class Inner = Simulation<double, typename Words::Space>>
class OwnSimulation {
 public:
  using Shapes = typename Words::Shapes;

  /// `threads`, which may be null, run the steps.
  template <class... Arguments>
  explicit OwnSimulation(std::shared_ptr<Threads> threads, const Arguments&... arguments)
      : threads_(std::move(threads)), inner_(arguments..., threads_.get()) {}
  OwnSimulation(const OwnSimulation&) = delete;
  OwnSimulation& operator=(const OwnSimulation&) = delete;

  Alone::Reading<Simulation<double, typename Words::Space>> read() const { return {asked(inner_), alone_}; }
  Alone::Changing<Inner> change() { return {inner_, alone_}; }
  /// The Python objects of the bodies' shapes, to be changed together with the bodies.
  Shapes& shapes() { return shapes_; }
  void step(double dt) {
    const auto changed = change();
    const py::gil_scoped_release free;
    changed->step(dt);
  }
  WorldView<Words> view() const { return {asked(inner_).world(), shapes_, alone_}; }

 private:
  Alone alone_;
  Shapes shapes_;
  std::shared_ptr<Threads> threads_;
  Inner inner_;
};

/// The methods of a simulation of space or the plane.
template <class Words>
class SimulationMethods {
 public:
  using Space = typename Words::Space;
  using Shape = typename Words::Shape;
  using Vector = typename Words::Vector;
  using Turning = typename Words::Turning;
  using Placement = typename Words::Placement;
  using Pose = typename Space::Pose;
  using Material = graze::Material<double, typename Space::Vec>;
  using State = graze::State<double, Space>;
  using Joint = graze::Joint<double, Space>;
  using Settings = SimulationSettings<double, Space>;
  /// A state of a captured simulation of this space: each module has a class of its own.
  struct CapturedState {
    StateNumber kept;
  };

  /// Defines the classes `Material`, `State` and `Simulation`, and `draw` of a simulation.
  static void add(py::module_& m, const char* doc) {
    using Own = OwnSimulation<Words>;
    add_material<Words>(m);
    py::class_<State>(m, "State", "A state of a simulation, to go back to; pickled, it goes on in another process.")
        .def(py::pickle([](const State& state) { return py::bytes(state_bytes(state)); },
                        [](const py::bytes& bytes) { return read_state<double, Space>(std::string_view(bytes)); }));
    py::class_<Own> simulation(m, "Simulation", doc);
    add_constructor(simulation);
    simulation
        .def(
            "save", [](const Own& s) { return s.read()->save(); }, "The State that `restore` goes back to.")
        .def(
            "restore", [](Own& s, const State& state) { s.change()->restore(state); }, py::arg("state"),
            "Goes back, or on from a state of another simulation with the same bodies and joints, added in the same "
            "order, bit for bit. Raises ValueError where there are others now.");
    add_methods(m, simulation);
  }

  /// Defines the class `CapturedSimulation`, and `draw` of one.
  static void add_captured(py::module_& m) {
    py::class_<CapturedState>(m, "CapturedState", "A state of a captured simulation, to go back to.");
    using Own = OwnSimulation<Words, SimulationToFile<Space>>;
    py::class_<Own> simulation(
        m, "CapturedSimulation",
        R"(A Simulation whose calls are written to a file, which `graze.replay` and the program graze play.

A frame is in the file when `step` returns. Shapes are those that the file holds: a convex hull is
built anew from its vertices. Raises ValueError for a file that takes no bytes, and for what a file
cannot hold: a shape with a support function in Python. threads: as of Simulation.)");
    add_constructor<Own, std::filesystem::path>(simulation, py::arg("file"));
    simulation
        .def(
            "save", [](Own& s) { return CapturedState{s.change()->save()}; },
            "The state that `restore` goes back to, as a replay will. There are at most 16 at a time: ValueError.")
        .def(
            "restore", [](Own& s, const CapturedState& state) { s.change()->restore(state.kept); }, py::arg("state"),
            "Goes back, bit for bit. Raises ValueError for a state of another simulation, and as Simulation.restore.")
        .def(
            "set_name", [](Own& s, BodyId id, const std::string& name) { s.change()->set_name(id, name); },
            py::arg("body"), py::arg("name"), "What `graze.replay` calls a body from here on.");
    add_methods(m, simulation);
  }

 private:
  /// Defines the constructor, whose last arguments are a simulation's settings; the first ones are `Before`.
  template <class Own, class... Before, class... Names>
  static void add_constructor(py::class_<Own>& simulation, const Names&... names) {
    const Settings usual;
    simulation.def(py::init([](const Before&... before, const Vector& gravity, const Whole& sub_steps, bool sleep,
                               bool continuous, const std::optional<Whole>& most_sub_steps, double longest_step,
                               bool warm_start, const ThreadsArgument& threads) {
                     Settings settings;
                     settings.gravity = gravity.value;
                     settings.sub_steps = sub_steps.as<int>("sub_steps");
                     settings.most_sub_steps = most_sub_steps ? most_sub_steps->as<int>("most_sub_steps")
                                                              : greatest(settings.most_sub_steps, settings.sub_steps);
                     settings.sleep = sleep;
                     settings.continuous = continuous;
                     settings.longest_step = longest_step;
                     settings.warm_start = warm_start;
                     return std::make_unique<Own>(threads.own(), before..., settings);
                   }),
                   names..., py::arg("gravity") = Vector{usual.gravity}, py::arg("sub_steps") = Whole(usual.sub_steps),
                   py::arg("sleep") = usual.sleep, py::arg("continuous") = usual.continuous,
                   py::arg("most_sub_steps") = py::none(), py::arg("longest_step") = usual.longest_step,
                   py::arg("warm_start") = usual.warm_start, py::arg("threads") = py::none());
  }

  /// Defines the methods of all simulations.
  template <class Own>
  static void add_methods(py::module_& m, py::class_<Own>& simulation) {
    add_steps(simulation);
    add_bodies(simulation);
    add_motion(simulation);
    add_joints(simulation);
    simulation.def("__repr__", [](const py::object& self) {
      const auto inner = self.cast<const Own&>().read();
      return call_text(class_name(self), {{"bodies", py::cast(inner->world().bodies().count())},
                                          {"joints", py::cast(inner->joints().size())}});
    });
    m.def(
        "draw",
        [](const py::object& on, const Own& drawn) {
          PythonDraw to(on);
          draw(to, *drawn.read());
        },
        py::arg("on"), py::arg("simulation"), "As a world, with what sleeps told apart, and joints.");
  }

  template <class Own>
  static JointId added(Own& simulation, Joint joint, bool enable_collision) {
    joint.enable_collision = enable_collision;
    return simulation.change()->add(joint);
  }

  /// Defines a joint that needs no more than its frames, by the name of its method.
  template <class Own, class Make>
  static void add_joint(py::class_<Own>& simulation, const char* name, Make make, const char* doc) {
    simulation.def(
        name,
        [make](Own& s, BodyId a, const Placement& frame_a, BodyId b, const Placement& frame_b, bool enable_collision) {
          return added(s, make(a, frame_a.value, b, frame_b.value), enable_collision);
        },
        py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("enable_collision") = false, doc);
  }

  static py::object plain(double value) { return py::float_(value); }
  template <class Vec>
  static py::object plain(const Vec& value) {
    return tuple_of(value);
  }

  static py::dict object_of(const StepReport<double, Space>& r) {
    py::dict out;
    out["awake"] = r.awake;
    out["islands"] = r.islands;
    out["contacts"] = r.contacts;
    out["most_sub_steps"] = r.most_sub_steps;
    out["stopped"] = r.stopped;
    out["deepest"] = r.deepest;
    out["mean_depth"] = r.mean_depth;
    out["residual"] = r.residual;
    out["kinetic_energy"] = r.kinetic_energy;
    out["potential_energy"] = r.potential_energy;
    out["momentum"] = plain(r.momentum);
    out["angular_momentum"] = plain(r.angular_momentum);
    out["milliseconds"] = r.whole_ms;
    return out;
  }

  static py::dict object_of(const Joint& joint) {
    py::dict out;
    out["a"] = joint.a;
    out["frame_a"] = joint.frame_a;
    out["b"] = joint.b;
    out["frame_b"] = joint.frame_b;
    out["limits"] = joint.limits;
    out["drives"] = joint.drives;
    out["enable_collision"] = joint.enable_collision;
    return out;
  }

  template <class Own>
  static void add_steps(py::class_<Own>& simulation) {
    simulation
        .def("step", &Own::step, py::arg("dt"),
             R"(Moves everything by `dt` > 0 seconds.

The interpreter's lock is released meanwhile; a use of this simulation by another thread then raises
RuntimeError. Raises ValueError for a step that is not finite, not > 0, or longer than a second.)")
        .def_property_readonly(
            "report", [](const Own& s) { return object_of(s.read()->report()); },
            "What the last step did: a dictionary.")
        .def(
            "state_hash", [](const Own& s) { return s.read()->state_hash(); },
            "A hash of all bits that the next step depends on: equal runs have equal hashes, also after `restore`.")
        .def_property_readonly("world", py::cpp_function(&Own::view, py::keep_alive<0, 1>()),
                               "The WorldView of the last step, for questions and contacts.")
        .def(
            "set_gravity", [](Own& s, const Vector& gravity) { s.change()->set_gravity(gravity.value); },
            py::arg("gravity"), "From the next step on.");
  }

  template <class Own>
  static void add_bodies(py::class_<Own>& simulation) {
    const Dynamics usual;
    simulation
        .def(
            "add",
            [](Own& s, const Shape& shape, const Placement& pose, const Vector& linear, const Turning& angular,
               std::optional<double> mass, double density, bool fixed, bool kinematic, double gravity_factor,
               double linear_damping, double angular_damping, const Filter& filter, bool trigger,
               const Material& material, bool may_sleep, const std::optional<Vector>& center_of_mass,
               const py::object& inertia) {
              const auto changed = s.change();
              Body<double, Space> body{Words::value_of(shape),
                                       pose.value,
                                       Words::value_of(linear),
                                       Words::value_of(angular),
                                       filter,
                                       fixed,
                                       trigger,
                                       false};
              Dynamics dynamics;
              dynamics.mass = mass;
              if (center_of_mass) dynamics.center_of_mass = center_of_mass->value;
              if (!inertia.is_none()) Words::set_inertia(dynamics, inertia);
              dynamics.density = density;
              dynamics.kinematic = kinematic;
              dynamics.gravity_factor = gravity_factor;
              dynamics.linear_damping = linear_damping;
              dynamics.angular_damping = angular_damping;
              dynamics.may_sleep = may_sleep;
              const BodyId id = changed->add(std::move(body), dynamics, material);
              s.shapes().keep(id.index, shape);
              return id;
            },
            py::arg("shape"), py::arg("pose") = py::none(), py::arg("linear") = Vector{},
            py::arg("angular") = Turning{}, py::arg("mass") = py::none(), py::arg("density") = usual.density,
            py::arg("fixed") = false, py::arg("kinematic") = usual.kinematic,
            py::arg("gravity_factor") = usual.gravity_factor, py::arg("linear_damping") = usual.linear_damping,
            py::arg("angular_damping") = usual.angular_damping, py::arg("filter") = Filter{},
            py::arg("trigger") = false, py::arg("material") = Material{}, py::arg("may_sleep") = usual.may_sleep,
            py::arg("center_of_mass") = py::none(), py::arg("inertia") = py::none(),
            (std::string("Adds a body, with ") + Words::measure +
             R"( times `density` unless `mass` is given, and returns its BodyId.

linear: velocity of the pose's origin in world axes, length per unit of time. angular:
)" + Words::turning_unit +
             R"(. fixed: never moves. kinematic: keeps the velocity
that it is given; pushes and is not pushed. trigger: tells what is in it, and is not pushed by
that; with a mass of its own it falls and hangs on joints, without one it keeps its velocity.
may_sleep: whether it sleeps with its island where nothing in it moves. center_of_mass: in the
body's frame, by default the shape's. inertia:
)" + Words::inertia_given +
             R"(; by default
the shape's, filled evenly with the mass. Raises ValueError for a mass or an inertia that is none,
and a body with mass whose shape has no end.)")
                .c_str())
        .def(
            "remove",
            [](Own& s, BodyId id) {
              s.change()->remove(id);
              s.shapes().drop(id.index);
            },
            py::arg("body"), "Removes a body and its joints; what stood on it wakes.")
        .def_property_readonly(
            "poses",
            [](const Own& s) {
              static_assert(sizeof(Pose) == Words::pose_size * sizeof(double));
              const auto inner = s.read();
              const auto poses = inner->poses();
              return py::array_t<double>({static_cast<py::ssize_t>(poses.size()), Words::pose_size},
                                         reinterpret_cast<const double*>(poses.data()));
            },
            (std::string("Of all bodies, by index: rows of ") + Words::pose_row + " (a copy).").c_str())
        .def(
            "pose",
            [](const Own& s, BodyId id) {
              const auto inner = s.read();
              return inner->poses()[index_of(inner->world(), id)];
            },
            py::arg("body"), "Where a body stands.")
        .def(
            "velocity",
            [](const Own& s, BodyId id) {
              const auto motion = s.read()->motion(id);
              return py::make_tuple(Words::object_of(motion.linear), Words::object_of(motion.angular));
            },
            py::arg("body"), "(linear velocity of the centre of mass, angular velocity).")
        .def(
            "mass", [](const Own& s, BodyId id) { return s.read()->mass(id); }, py::arg("body"),
            "Infinite for what is fixed or kinematic.")
        .def(
            "center_of_mass", [](const Own& s, BodyId id) { return Words::object_of(s.read()->motion(id).center); },
            py::arg("body"), "In the world.")
        .def(
            "angular_momentum",
            [](const Own& s, BodyId id) { return Words::object_of(s.read()->angular_momentum(id)); }, py::arg("body"),
            "About the centre of mass.")
        .def(
            "asleep", [](const Own& s, BodyId id) { return s.read()->asleep(id); }, py::arg("body"),
            "Whether a body is at rest, and not moved until something wakes it.")
        .def(
            "sub_steps", [](const Own& s, BodyId id) { return s.read()->sub_steps(id); }, py::arg("body"),
            "The sub-steps of a body's island in the last step; 0 before its first.")
        .def(
            "set_material", [](Own& s, BodyId id, const Material& material) { s.change()->set_material(id, material); },
            py::arg("body"), py::arg("material"), "Another material for a body, of all of its pieces.")
        .def(
            "set_filter", [](Own& s, BodyId id, const Filter& filter) { s.change()->set_filter(id, filter); },
            py::arg("body"), py::arg("filter"),
            "Another filter for a body, from the next step on. What it touches wakes.")
        .def(
            "set_materials",
            [](Own& s, BodyId id, const std::vector<Material>& materials, const std::vector<Whole>& of_piece) {
              std::vector<std::uint32_t> places;
              for (const Whole& place : of_piece)
                places.push_back(place.as<std::uint32_t>(("of_piece[" + std::to_string(places.size()) + "]").c_str()));
              s.change()->set_materials(id, materials, places);
            },
            py::arg("body"), py::arg("materials"), py::arg("of_piece"),
            R"(Gives the pieces of a body's shape materials of their own.

of_piece[i] is the place among `materials` of that of piece i: the children of a compound, triangles
of a mesh or a height field (two for each cell, holes included), segments of a chain in the plane. A
point of contact has the material of the piece whose surface is nearest to it, at the cost of a
search of the pieces in each step. Raises ValueError for another shape, another number of pieces,
and a place that is none.)");
  }

  template <class Own>
  static void add_motion(py::class_<Own>& simulation) {
    simulation
        .def(
            "wake", [](Own& s, BodyId id) { s.change()->wake(id); }, py::arg("body"),
            "Wakes a body and what touches it.")
        .def(
            "set_pose", [](Own& s, BodyId id, const Placement& pose) { s.change()->set_pose(id, pose.value); },
            py::arg("body"), py::arg("pose"), "Puts a body elsewhere at once; its velocity stays.")
        .def(
            "set_velocity",
            [](Own& s, BodyId id, const Vector& linear, const Turning& angular) {
              s.change()->set_velocity(id, {Words::value_of(linear), Words::value_of(angular)});
            },
            py::arg("body"), py::arg("linear"), py::arg("angular") = Turning{},
            "Of the pose's origin, and the turning about it.")
        .def(
            "move_to",
            [](Own& s, BodyId id, const Placement& pose, double dt) { s.change()->move_to(id, pose.value, dt); },
            py::arg("body"), py::arg("pose"), py::arg("dt"),
            "Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`.")
        .def(
            "apply_impulse",
            [](Own& s, BodyId id, const Vector& impulse, const Vector& point) {
              s.change()->apply_impulse(id, impulse.value, point.value);
            },
            py::arg("body"), py::arg("impulse"), py::arg("point"), "At a point of the world, at once.")
        .def(
            "apply_angular_impulse",
            [](Own& s, BodyId id, const Turning& impulse) {
              s.change()->apply_angular_impulse(id, Words::value_of(impulse));
            },
            py::arg("body"), py::arg("impulse"), "A turning blow, at once.")
        .def(
            "apply_force", [](Own& s, BodyId id, const Vector& force) { s.change()->apply_force(id, force.value); },
            py::arg("body"), py::arg("force"), "On the centre of mass, throughout the next step.")
        .def(
            "apply_torque",
            [](Own& s, BodyId id, const Turning& torque) { s.change()->apply_torque(id, Words::value_of(torque)); },
            py::arg("body"), py::arg("torque"), "Throughout the next step.");
  }

  template <class Own>
  static void add_joints(py::class_<Own>& simulation) {
    // The makers of joints of the space at hand are found by the type of their frames.
    if constexpr (Words::vector_size == 3)
      add_joint(
          simulation, "join_ball",
          [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return ball_joint<double>(a, f, b, g); },
          "The origins of the frames stay one.");
    add_joint(
        simulation, "fix",
        [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return fixed_joint<double>(a, f, b, g); },
        "Two frames, each in its body, stay one. Returns a JointId.");
    add_joint(
        simulation, "join_hinge",
        [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return hinge_joint<double>(a, f, b, g); }, Words::hinge);
    const double infinity = std::numeric_limits<double>::infinity();
    simulation
        .def(
            "join_slider",
            [](Own& s, BodyId a, const Placement& f, BodyId b, const Placement& g, double min, double max,
               bool enable_collision) {
              return added(s, slider_joint<double>(a, f.value, b, g.value, min, max), enable_collision);
            },
            py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("min") = -infinity,
            py::arg("max") = infinity, py::arg("enable_collision") = false,
            "A way along the frames' x axis is free, from `min` to `max`.")
        .def(
            "join_distance",
            [](Own& s, BodyId a, const Placement& f, BodyId b, const Placement& g, double min, double max,
               bool enable_collision) {
              return added(s, distance_joint<double>(a, f.value, b, g.value, min, max), enable_collision);
            },
            py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("min"), py::arg("max"),
            py::arg("enable_collision") = false, "The origins of the frames stay from `min` to `max` apart.")
        .def(
            "join",
            [](Own& s, BodyId a, const Placement& f, BodyId b, const Placement& g,
               const std::vector<JointLimit<double>>& limits, const std::vector<JointDrive<double>>& drives,
               bool enable_collision) {
              return s.change()->add(Joint{a, b, f.value, g.value, limits, drives, enable_collision});
            },
            py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"),
            py::arg("limits") = std::vector<JointLimit<double>>{},
            py::arg("drives") = std::vector<JointDrive<double>>{}, py::arg("enable_collision") = false,
            (std::string("Any joint: what is not limited is free.\n\nlimits: JointLimits, drives: JointDrives. ") +
             Words::joint_axes + " Raises ValueError for limits and drives that are none.")
                .c_str())
        .def(
            "joints", [](const Own& s) { return s.read()->joints(); }, "The JointIds of all joints, by index.")
        .def(
            "joint", [](const Own& s, JointId id) { return object_of(s.read()->joint(id)); }, py::arg("joint"),
            "A joint as it was added or set last: a dictionary of the arguments of `join`.")
        .def(
            "set_joint",
            [](Own& s, JointId id, const std::optional<Placement>& f, const std::optional<Placement>& g,
               const std::optional<std::vector<JointLimit<double>>>& limits,
               const std::optional<std::vector<JointDrive<double>>>& drives, std::optional<bool> enable_collision) {
              Joint joint = s.read()->joint(id);
              if (f) joint.frame_a = f->value;
              if (g) joint.frame_b = g->value;
              if (limits) joint.limits = *limits;
              if (drives) joint.drives = *drives;
              joint.enable_collision = enable_collision.value_or(joint.enable_collision);
              s.change()->set_joint(id, joint);
            },
            py::arg("joint"), py::kw_only(), py::arg("frame_a") = py::none(), py::arg("frame_b") = py::none(),
            py::arg("limits") = py::none(), py::arg("drives") = py::none(), py::arg("enable_collision") = py::none(),
            "Changes what is given of a joint from the next step on, as the drives of a motor that gets another "
            "target. "
            "Its bodies wake.")
        .def(
            "joint_impulses",
            [](const Own& s, JointId id) {
              const auto inner = s.read();
              const auto impulses = inner->joint_impulses(id);
              return py::array_t<double>(static_cast<py::ssize_t>(impulses.size()), impulses.data());
            },
            py::arg("joint"), "Of the last step: a number for each row of the joint.")
        .def(
            "remove_joint", [](Own& s, JointId id) { s.change()->remove(id); }, py::arg("joint"),
            "Removes a joint; the bodies that it joined wake.");
  }

  using Dynamics = typename Rigid<Space>::Dynamics;
};

}  // namespace graze::python
