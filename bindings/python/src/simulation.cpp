// A simulation: what happens next to bodies that have mass.
#include <pybind11/stl.h>

#include "answers.hpp"
#include "draw.hpp"
#include "shapes.hpp"
#include "world.hpp"

namespace graze::python {

namespace {

using Inner = Simulation<double>;

/// A simulation that raises RuntimeError where another call is in a step of it.
class Sim {
 public:
  explicit Sim(const SimulationSettings<double>& settings) : inner_(settings) {}
  Sim(const Sim&) = delete;
  Sim& operator=(const Sim&) = delete;

  Alone::Reading<Inner> read() const { return {inner_, alone_}; }
  Alone::Changing<Inner> change() { return {inner_, alone_}; }
  void step(double dt) {
    const auto changed = change();
    const py::gil_scoped_release free;
    changed->step(dt);
  }
  WorldView<SpaceWords> view() const { return {inner_.world(), shapes_, alone_}; }

 private:
  Alone alone_;
  SpaceWords::Shapes shapes_;
  Inner inner_;
};
using SimClass = py::class_<Sim>;

Combine combine_of(const std::string& name, const char* path) {
  constexpr std::pair<const char*, Combine> names[] = {{"unset", Combine::unset},
                                                       {"average", Combine::average},
                                                       {"minimum", Combine::minimum},
                                                       {"maximum", Combine::maximum},
                                                       {"multiply", Combine::multiply}};
  for (const auto& [text, combine] : names)
    if (name == text) return combine;
  validate::fail(path, "unset, average, minimum, maximum or multiply", name);
}

py::dict object_of(const StepReport<double>& r) {
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
  out["momentum"] = tuple_of(r.momentum);
  out["angular_momentum"] = tuple_of(r.angular_momentum);
  out["milliseconds"] = r.whole_ms;
  return out;
}

void add_bodies(SimClass& sim) {
  sim.def(
         "add",
         [](Sim& s, const Shaped& shape, const Placement& pose, const Vector& linear, const Vector& angular,
            std::optional<double> mass, double density, bool fixed, bool kinematic, double gravity_factor,
            double linear_damping, double angular_damping, const Filter& filter, bool trigger,
            const Material<double>& material) {
           Body<double> body{shape, pose.value, linear.value, angular.value, filter, fixed, trigger, false};
           Dynamics<double> dynamics;
           dynamics.mass = mass;
           dynamics.density = density;
           dynamics.kinematic = kinematic;
           dynamics.gravity_factor = gravity_factor;
           dynamics.linear_damping = linear_damping;
           dynamics.angular_damping = angular_damping;
           return s.change()->add(std::move(body), dynamics, material);
         },
         py::arg("shape"), py::arg("pose") = py::none(), py::arg("linear") = Vector{}, py::arg("angular") = Vector{},
         py::arg("mass") = py::none(), py::arg("density") = 1000.0, py::arg("fixed") = false,
         py::arg("kinematic") = false, py::arg("gravity_factor") = 1.0, py::arg("linear_damping") = 0.0,
         py::arg("angular_damping") = 0.0, py::arg("filter") = Filter{}, py::arg("trigger") = false,
         py::arg("material") = Material<double>{},
         "Adds a body, with the mass of its volume times `density` unless `mass` is given, and returns its BodyId.")
      .def(
          "remove", [](Sim& s, BodyId id) { s.change()->remove(id); }, py::arg("body"))
      .def(
          "remove_joint", [](Sim& s, JointId id) { s.change()->remove(id); }, py::arg("joint"))
      .def(
          "pose",
          [](const Sim& s, BodyId id) {
            const auto inner = s.read();
            return inner->poses()[index_of(inner->world(), id)];
          },
          py::arg("body"))
      .def(
          "velocity",
          [](const Sim& s, BodyId id) {
            const auto motion = s.read()->motion(id);
            return py::make_tuple(array_of(motion.linear), array_of(motion.angular));
          },
          py::arg("body"), "(linear velocity of the centre of mass, angular velocity).")
      .def(
          "mass", [](const Sim& s, BodyId id) { return s.read()->mass(id); }, py::arg("body"),
          "Infinite for what is fixed or kinematic.")
      .def(
          "asleep", [](const Sim& s, BodyId id) { return s.read()->asleep(id); }, py::arg("body"))
      .def(
          "wake", [](Sim& s, BodyId id) { s.change()->wake(id); }, py::arg("body"))
      .def(
          "set_material",
          [](Sim& s, BodyId id, const Material<double>& material) { s.change()->set_material(id, material); },
          py::arg("body"), py::arg("material"))
      .def(
          "angular_momentum", [](const Sim& s, BodyId id) { return array_of(s.read()->angular_momentum(id)); },
          py::arg("body"), "About the centre of mass.")
      .def(
          "set_pose", [](Sim& s, BodyId id, const Placement& pose) { s.change()->set_pose(id, pose.value); },
          py::arg("body"), py::arg("pose"))
      .def(
          "set_velocity",
          [](Sim& s, BodyId id, const Vector& linear, const Vector& angular) {
            s.change()->set_velocity(id, {linear.value, angular.value});
          },
          py::arg("body"), py::arg("linear"), py::arg("angular") = Vector{})
      .def(
          "move_to",
          [](Sim& s, BodyId id, const Placement& pose, double dt) { s.change()->move_to(id, pose.value, dt); },
          py::arg("body"), py::arg("pose"), py::arg("dt"),
          "Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`.")
      .def(
          "apply_impulse",
          [](Sim& s, BodyId id, const Vector& impulse, const Vector& point) {
            s.change()->apply_impulse(id, impulse.value, point.value);
          },
          py::arg("body"), py::arg("impulse"), py::arg("point"))
      .def(
          "apply_force", [](Sim& s, BodyId id, const Vector& force) { s.change()->apply_force(id, force.value); },
          py::arg("body"), py::arg("force"), "On the centre of mass, throughout the next step.")
      .def(
          "apply_torque", [](Sim& s, BodyId id, const Vector& torque) { s.change()->apply_torque(id, torque.value); },
          py::arg("body"), py::arg("torque"));
}

void add_joints(SimClass& sim) {
  const auto join = [&](const char* name, auto make, const char* doc) {
    sim.def(
        name,
        [make](Sim& s, BodyId a, const Placement& frame_a, BodyId b, const Placement& frame_b, bool enable_collision) {
          Joint<double> joint = make(a, frame_a.value, b, frame_b.value);
          joint.enable_collision = enable_collision;
          return s.change()->add(joint);
        },
        py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("enable_collision") = false, doc);
  };
  using Pose = Posed;
  join(
      "fix", [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return fixed_joint<double>(a, f, b, g); },
      "Two frames, each in its body, stay one. Returns a JointId.");
  join(
      "join_ball", [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return ball_joint<double>(a, f, b, g); },
      "The origins of the frames stay one.");
  join(
      "join_hinge", [](BodyId a, const Pose& f, BodyId b, const Pose& g) { return hinge_joint<double>(a, f, b, g); },
      "A turn about the frames' x axis is free.");
  const double infinity = std::numeric_limits<double>::infinity();
  sim.def(
         "join_slider",
         [](Sim& s, BodyId a, const Placement& f, BodyId b, const Placement& g, double min, double max) {
           return s.change()->add(slider_joint<double>(a, f.value, b, g.value, min, max));
         },
         py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("min") = -infinity,
         py::arg("max") = infinity, "A way along the frames' x axis is free, from `min` to `max`.")
      .def(
          "join_distance",
          [](Sim& s, BodyId a, const Placement& f, BodyId b, const Placement& g, double min, double max) {
            return s.change()->add(distance_joint<double>(a, f.value, b, g.value, min, max));
          },
          py::arg("a"), py::arg("frame_a"), py::arg("b"), py::arg("frame_b"), py::arg("min"), py::arg("max"),
          "The origins of the frames stay from `min` to `max` apart.");
}

}  // namespace

void add_simulation(py::module_& m) {
  const Material<double> usual;
  py::class_<Material<double>>(m, "Material", R"(What a surface is made of.

Frictions are Coulomb's coefficients >= 0, restitution is 0 to 1, rolling friction a length;
combine modes: 'unset', 'average', 'minimum', 'maximum' or 'multiply'.)")
      .def(py::init([](double static_friction, double dynamic_friction, double restitution, double rolling_friction,
                       const std::string& friction_combine, const std::string& restitution_combine,
                       const Vector& surface_velocity) {
             Material<double> material;
             material.static_friction = static_friction;
             material.dynamic_friction = dynamic_friction;
             material.restitution = restitution;
             material.rolling_friction = rolling_friction;
             material.friction_combine = combine_of(friction_combine, "friction_combine");
             material.restitution_combine = combine_of(restitution_combine, "restitution_combine");
             material.surface_velocity = surface_velocity.value;
             return material;
           }),
           py::arg("static_friction") = usual.static_friction, py::arg("dynamic_friction") = usual.dynamic_friction,
           py::arg("restitution") = usual.restitution, py::arg("rolling_friction") = usual.rolling_friction,
           py::arg("friction_combine") = "unset", py::arg("restitution_combine") = "unset",
           py::arg("surface_velocity") = Vector{});
  py::class_<JointId>(m, "JointId", "A handle of a joint.")
      .def_readonly("index", &JointId::index)
      .def(
          "__eq__", [](const JointId& a, const JointId& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const JointId& id) { return py::hash(py::make_tuple(id.index, id.generation)); });
  py::class_<State<double>>(m, "State", "A state of a simulation, to go back to.");

  SimClass sim(m, "Simulation", R"(What happens next: bodies fall, collide, hang on joints and come to rest.

gravity: three numbers. sub_steps: of a step, a power of two. sleep: islands at rest cost nothing.

>>> import graze
>>> simulation = graze.Simulation()
>>> floor = simulation.add(graze.HalfSpace(), fixed=True)
>>> box = simulation.add(graze.Box((1, 1, 1)), (0, 2, 0))
>>> for _ in range(120):
...     simulation.step(1 / 60)
>>> round(float(simulation.pose(box).translation[1]), 2)
0.5
)");
  sim.def(py::init([](const Vector& gravity, int sub_steps, bool sleep, bool continuous) {
            SimulationSettings<double> settings;
            settings.gravity = gravity.value;
            settings.sub_steps = sub_steps;
            settings.most_sub_steps = greatest(settings.most_sub_steps, sub_steps);
            settings.sleep = sleep;
            settings.continuous = continuous;
            return std::make_unique<Sim>(settings);
          }),
          py::arg("gravity") = Vector{{0, -9.81, 0}}, py::arg("sub_steps") = 4, py::arg("sleep") = true,
          py::arg("continuous") = true)
      .def("step", &Sim::step, py::arg("dt"),
           R"(Moves everything by `dt` > 0 seconds.

The interpreter's lock is released meanwhile; a use of this simulation by another thread then raises
RuntimeError. Raises ValueError for a step that is not finite, not > 0, or longer than a second.)")
      .def_property_readonly(
          "poses",
          [](const Sim& s) {
            const auto inner = s.read();
            const auto poses = inner->poses();
            return py::array_t<double>({static_cast<py::ssize_t>(poses.size()), py::ssize_t{7}},
                                       reinterpret_cast<const double*>(poses.data()));
          },
          "Of all bodies, by index: rows of translation and quaternion (a copy).")
      .def_property_readonly(
          "report", [](const Sim& s) { return object_of(s.read()->report()); }, "What the last step did: a dictionary.")
      .def_property_readonly("world", py::cpp_function(&Sim::view, py::keep_alive<0, 1>()),
                             "The WorldView of the last step, for questions and contacts.")
      .def(
          "save", [](const Sim& s) { return s.read()->save(); }, "The State that `restore` goes back to.")
      .def(
          "restore", [](Sim& s, const State<double>& state) { s.change()->restore(state); }, py::arg("state"),
          "Goes back, bit for bit. Raises ValueError where bodies or joints came or went in between.");
  add_bodies(sim);
  add_joints(sim);
  m.def(
      "draw",
      [](const py::object& on, const Sim& simulation) {
        PythonDraw to(on);
        draw(to, *simulation.read());
      },
      py::arg("on"), py::arg("simulation"), "As a world, with what sleeps told apart, and joints.");
}

}  // namespace graze::python
