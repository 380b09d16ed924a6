// A simulation of space, and the parts that simulations of space and the plane share: joints'
// limits, drives and handles.
#include "shapes.hpp"
#include "simulation_methods.hpp"

namespace graze::python {

namespace {

JointSpace joint_space_of(const std::string& word) {
  if (word == "linear") return JointSpace::linear;
  if (word == "angular") return JointSpace::angular;
  validate::fail("space", "linear or angular", word);
}

const char* text_of(JointSpace space) { return space == JointSpace::linear ? "linear" : "angular"; }

/// The axes of a word such as "x" or "yz".
std::array<bool, 3> axes_of(const std::string& word) {
  std::array<bool, 3> axes{};
  for (const char letter : word) {
    const std::size_t axis = static_cast<std::size_t>(letter - 'x');
    if (letter < 'x' || letter > 'z' || axes[axis]) validate::fail("axes", "some of x, y and z, each once", word);
    axes[axis] = true;
  }
  return axes;
}

std::uint8_t axis_of(const std::string& word) {
  if (word != "x" && word != "y" && word != "z") validate::fail("axis", "x, y or z", word);
  return static_cast<std::uint8_t>(word[0] - 'x');
}

void add_joint_parts(py::module_& m) {
  using Limit = JointLimit<double>;
  py::class_<Limit>(m, "JointLimit", R"(Bounds on a joint, along axes of its frame on the first body or about them.

space: 'linear' (lengths) or 'angular' (radians). axes: of 'x', 'y' and 'z'; with several the bounds
are on the length of the part that lies in them, so that 'yz' makes a tube and 'xyz' a ball.
min <= max; equal for what is held. stiffness: force per length, or torque per radian, beyond the
bounds; None for hard bounds. damping: of a soft limit. Raises ValueError for words that are none;
for numbers that are none where a joint gets the limit.)")
      .def(py::init([](const std::string& space, const std::string& axes, double min, double max,
                       std::optional<double> stiffness, double damping) {
             return Limit{joint_space_of(space), axes_of(axes), min, max, stiffness, damping};
           }),
           py::arg("space"), py::arg("axes"), py::arg("min") = 0.0, py::arg("max") = 0.0,
           py::arg("stiffness") = py::none(), py::arg("damping") = 0.0)
      .def_property_readonly(
          "space", [](const Limit& l) { return text_of(l.space); }, "'linear' or 'angular'.")
      .def_property_readonly(
          "axes",
          [](const Limit& l) {
            std::string axes;
            for (std::size_t i = 0; i < 3; ++i)
              if (l.axes[i]) axes += "xyz"[i];
            return axes;
          },
          "Those of frame a that are bounded together, 'xy' for instance.")
      .def_readonly("min", &Limit::min, "The lower bound: a length or an angle in radians; may be infinite.")
      .def_readonly("max", &Limit::max, "The upper bound, not below `min`.")
      .def_readonly("stiffness", &Limit::stiffness, "Force a length or torque a radian beyond the bounds; 0 is hard.")
      .def_readonly("damping", &Limit::damping, "Force or torque by the speed beyond soft bounds.")
      .def("__repr__",
           [](const py::object& self) {
             return call_text("graze.JointLimit", {{"space", self.attr("space")},
                                                   {"axes", self.attr("axes")},
                                                   {"min", self.attr("min")},
                                                   {"max", self.attr("max")},
                                                   {"stiffness", self.attr("stiffness")},
                                                   {"damping", self.attr("damping")}});
           })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(self.attr("space"), self.attr("axes"), self.attr("min"), self.attr("max"),
                                             self.attr("stiffness"), self.attr("damping")));
      });
  using Drive = JointDrive<double>;
  const Drive usual;
  py::class_<Drive>(m, "JointDrive", R"(A motor on one axis of a joint's frame on the first body.

It pushes with stiffness (position_target - position) + damping (velocity_target - velocity), at
most `max_force`. space: 'linear' or 'angular'; axis: 'x', 'y' or 'z'. acceleration: stiffness and
damping are of an acceleration, which mass and inertia do not change, else of a force or torque.
Raises ValueError for words that are none; for numbers that are none where a joint gets the drive.)")
      .def(py::init([](const std::string& space, const std::string& axis, double position_target,
                       double velocity_target, double stiffness, double damping, double max_force, bool acceleration) {
             return Drive{joint_space_of(space),
                          acceleration ? DriveMode::acceleration : DriveMode::force,
                          axis_of(axis),
                          position_target,
                          velocity_target,
                          stiffness,
                          damping,
                          max_force};
           }),
           py::arg("space"), py::arg("axis"), py::arg("position_target") = usual.position_target,
           py::arg("velocity_target") = usual.velocity_target, py::arg("stiffness") = usual.stiffness,
           py::arg("damping") = usual.damping, py::arg("max_force") = usual.max_force, py::arg("acceleration") = false)
      .def_property_readonly(
          "space", [](const Drive& d) { return text_of(d.space); }, "'linear' or 'angular'.")
      .def_property_readonly(
          "axis", [](const Drive& d) { return std::string(1, "xyz"[d.axis]); }, "'x', 'y' or 'z', of frame a.")
      .def_readonly("position_target", &Drive::position_target, "Where to, a length or an angle in radians.")
      .def_readonly("velocity_target", &Drive::velocity_target, "How fast, in lengths or radians.")
      .def_readonly("stiffness", &Drive::stiffness, "Force a length or torque a radian away from the target.")
      .def_readonly("damping", &Drive::damping, "Force or torque by the difference from the velocity wanted.")
      .def_readonly("max_force", &Drive::max_force, "The largest force or torque; may be infinite.")
      .def_property_readonly(
          "acceleration", [](const Drive& d) { return d.mode == DriveMode::acceleration; },
          "Whether stiffness and damping are those of accelerations, which mass and inertia do not change.")
      .def("__repr__",
           [](const py::object& self) {
             return call_text("graze.JointDrive", {{"space", self.attr("space")},
                                                   {"axis", self.attr("axis")},
                                                   {"position_target", self.attr("position_target")},
                                                   {"velocity_target", self.attr("velocity_target")},
                                                   {"stiffness", self.attr("stiffness")},
                                                   {"damping", self.attr("damping")},
                                                   {"max_force", self.attr("max_force")},
                                                   {"acceleration", self.attr("acceleration")}});
           })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(self.attr("space"), self.attr("axis"), self.attr("position_target"),
                                             self.attr("velocity_target"), self.attr("stiffness"), self.attr("damping"),
                                             self.attr("max_force"), self.attr("acceleration")));
      });
  py::class_<JointId>(m, "JointId", "A handle of a joint: its index, and how often that was given away before.")
      .def_readonly("index", &JointId::index, "The place among the joints.")
      .def_readonly("generation", &JointId::generation, "How often the index was given away before.")
      .def(
          "__repr__",
          [](const JointId& id) {
            return call_text("graze.JointId", {{"index", py::cast(id.index)}, {"generation", py::cast(id.generation)}});
          })
      .def(pickled<JointId>(&JointId::index, &JointId::generation))
      .def(
          "__eq__", [](const JointId& a, const JointId& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const JointId& id) { return py::hash(py::make_tuple(id.index, id.generation)); });
}

}  // namespace

namespace {

constexpr std::pair<const char*, Combine> combine_names[] = {{"unset", Combine::unset},
                                                             {"average", Combine::average},
                                                             {"minimum", Combine::minimum},
                                                             {"maximum", Combine::maximum},
                                                             {"multiply", Combine::multiply}};

}  // namespace

Combine combine_of(const std::string& name, const char* path) {
  for (const auto& [text, combine] : combine_names)
    if (name == text) return combine;
  validate::fail(path, "unset, average, minimum, maximum or multiply", name);
}

const char* text_of(Combine combine) {
  const auto* found = std::ranges::find(combine_names, combine, &std::pair<const char*, Combine>::second);
  return found->first;
}

namespace {

/// Sets moments and axes of a symmetric matrix, by NumPy's solver for its eigenvectors.
void set_inertia_of_tensor(Dynamics<double>& dynamics, const py::object& given) {
  const Rows tensor = rows(given, 3, "inertia");
  if (tensor.shape(0) != 3) validate::fail("inertia", "a matrix of shape (3, 3)", "another shape");
  double largest = 0;
  for (py::ssize_t i = 0; i < 9; ++i) {
    const double element = tensor.data()[i];
    if (const char* expected = validate::fault_of_coordinate(element)) validate::fail("inertia", expected, element);
    largest = std::max(largest, std::abs(element));
  }
  for (py::ssize_t i = 0; i < 3; ++i)
    for (py::ssize_t j = 0; j < i; ++j)
      if (!(std::abs(tensor.at(i, j) - tensor.at(j, i)) <= unit_slack * largest))
        validate::fail("inertia[" + std::to_string(i) + "][" + std::to_string(j) + "]", "a symmetric matrix",
                       tensor.at(i, j));
  const py::tuple found = py::module_::import("numpy").attr("linalg").attr("eigh")(tensor);
  const Rows axes = found[1].cast<Rows>();
  if (!read_vector(found[0], dynamics.inertia_diagonal.emplace())) throw py::type_error("inertia: expected moments");
  // The columns are the axes, which may be left-handed.
  py::array_t<double> matrix(py::array::ShapeContainer{py::ssize_t{4}, py::ssize_t{4}});
  std::fill_n(matrix.mutable_data(), 16, 0.0);
  matrix.mutable_at(3, 3) = 1;
  const auto column = [&](py::ssize_t j) { return Vec3d{axes.at(0, j), axes.at(1, j), axes.at(2, j)}; };
  const double hand = dot(cross(column(0), column(1)), column(2)) < 0 ? -1 : 1;
  for (py::ssize_t i = 0; i < 3; ++i)
    for (py::ssize_t j = 0; j < 3; ++j) matrix.mutable_at(i, j) = (j == 2 ? hand : 1) * axes.at(i, j);
  Posed turned;
  read_pose(matrix, turned);
  dynamics.inertia_orientation = turned.rotation;
}

}  // namespace

void SpaceWords::set_inertia(Dynamics<double>& dynamics, const py::object& given) {
  py::object moments = given;
  double q[4] = {0, 0, 0, 1};
  if (py::isinstance<py::sequence>(given) && py::len(given) == 2) {
    moments = given[py::int_(0)];
    if (!read_numbers(given[py::int_(1)], q, 4)) throw py::type_error("inertia: expected a quaternion of four numbers");
  }
  dynamics.inertia_orientation = {q[0], q[1], q[2], q[3]};
  if (read_vector(moments, dynamics.inertia_diagonal.emplace())) return;
  const py::array tensor = py::array::ensure(given);
  if (!tensor) PyErr_Clear();
  if (!tensor || tensor.ndim() != 2)
    throw py::type_error("inertia: expected three moments, (moments, quaternion), or a matrix of shape (3, 3)");
  set_inertia_of_tensor(dynamics, tensor);
}

void add_simulation(py::module_& m) {
  add_joint_parts(m);
  SimulationMethods<SpaceWords>::add(m, R"(What happens next: bodies fall, collide, hang on joints and come to rest.

gravity: three numbers. sub_steps: of a step, a power of two. sleep: islands at rest cost nothing.
continuous: what moves fast passes through nothing. most_sub_steps: for an island under load, 64 by
default. longest_step: longer ones are refused. warm_start: sub-steps begin with the impulses of
the last one; without it stacks sink and lean. threads: how many run a step, or a
`graze.Threads`; the result has the same bits.

>>> import graze
>>> simulation = graze.Simulation()
>>> floor = simulation.add(graze.HalfSpace(), fixed=True)
>>> box = simulation.add(graze.Box((1, 1, 1)), (0, 2, 0))
>>> for _ in range(120):
...     simulation.step(1 / 60)
>>> round(float(simulation.pose(box).translation[1]), 2)
0.5
)");
  SimulationMethods<SpaceWords>::add_captured(m);
}

}  // namespace graze::python
