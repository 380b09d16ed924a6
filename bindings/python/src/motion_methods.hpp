// Bodies as blows meet them, blows that are passed on, and free motion: written once for space and the plane, which
// differ in their `Words` (`motion.cpp`).
#pragma once

#include "plain_values.hpp"
#include "row_batches.hpp"
#include "whole.hpp"

#include <pybind11/stl.h>

namespace graze::python {

inline double coefficient(double value, const std::string& path) {
  if (!(value >= 0) || !std::isfinite(value)) validate::fail(path, "a finite number >= 0", value);
  return value;
}

template <class Words>
struct MotionMethods {
  using Body = typename Words::Body;
  using Free = typename Words::Free;
  using Shape = typename Words::Shape;
  using Placement = typename Words::Placement;
  using VectorGiven = typename Words::VectorGiven;
  using TurningGiven = typename Words::TurningGiven;

  /// A vector or a turning with numbers that queries take.
  template <class Given>
  static auto checked_value(const Given& given, const char* path) {
    Words::check(Words::value_of(given), path);
    return Words::value_of(given);
  }

  /// One of many blows in the form of Python: its points are not yet among those of the others.
  struct Meeting {
    std::uint32_t a, b;
    typename Words::Vector normal;
    std::vector<typename Words::Vector> points;
    double restitution;
  };

  static void add(py::module_& m) {
    add_bodies(m);
    add_blows(m);
    add_free(m);
  }

 private:
  static void add_bodies(py::module_& m) {
    py::class_<Body>(
        m, "StruckBody",
        (std::string("A body as a blow meets it: how it moves, and what resists.\n\nmass: > 0, infinite "
                     "for what does not move. ") +
         Words::inertia_doc +
         "; None for\nwhat does not turn. pose: where the centre of mass is, and the axes. linear, angular: "
         "its velocity.\nRaises ValueError.")
            .c_str())
        .def(py::init([](double mass, const py::object& inertia, const Placement& pose, const VectorGiven& linear,
                         const TurningGiven& angular) {
               return Body{{checked_value(linear, "linear"), checked_value(angular, "angular"), pose.value.translation},
                           Words::inverse(mass, inertia, pose.value)};
             }),
             py::arg("mass"), py::arg("inertia") = py::none(), py::arg("pose") = py::none(),
             py::arg("linear") = VectorGiven{}, py::arg("angular") = TurningGiven{})
        .def_static(
            "of_shape",
            [](const Shape& shape, double mass, const Placement& pose, const VectorGiven& linear,
               const TurningGiven& angular) {
              return Body{{checked_value(linear, "linear"), checked_value(angular, "angular"),
                           transform(pose.value, mass_properties(shape).center)},
                          Words::inverse_of_shape(shape, mass, pose.value)};
            },
            py::arg("shape"), py::arg("mass"), py::arg("pose") = py::none(), py::arg("linear") = VectorGiven{},
            py::arg("angular") = TurningGiven{},
            "With `mass` spread evenly in a shape that stands at `pose`; `linear` is that of the centre of mass.")
        .def_property_readonly(
            "linear", [](const Body& b) { return Words::object_of(b.motion.linear); },
            "The velocity of the centre of mass.")
        .def_property_readonly(
            "angular", [](const Body& b) { return Words::object_of(b.motion.angular); },
            "The rate of turning about the centre of mass, in radians.")
        .def_property_readonly(
            "center", [](const Body& b) { return Words::object_of(b.motion.center); },
            "The centre of mass, in the world.")
        .def_property_readonly(
            "movable", [](const Body& b) { return b.mass.movable(); },
            "Whether impulses change its motion: not so for a body of infinite mass.")
        .def("__repr__",
             [](const py::object& self) {
               const auto& b = self.cast<const Body&>();
               return call_text(class_name(self), {{"linear", member_of(b.motion.linear)},
                                                   {"angular", member_of(b.motion.angular)},
                                                   {"center", member_of(b.motion.center)},
                                                   {"movable", py::cast(b.mass.movable())}});
             })
        .def(py::pickle(
            [](const Body& b) {
              return py::make_tuple(member_of(b.motion.linear), member_of(b.motion.angular), member_of(b.motion.center),
                                    b.mass.mass, member_of(b.mass.inertia));
            },
            [](const py::tuple& state) {
              if (state.size() != 5) validate::fail("state", "5 members", std::to_string(state.size()));
              Body b{};
              read_member(state[0], b.motion.linear);
              read_member(state[1], b.motion.angular);
              read_member(state[2], b.motion.center);
              read_member(state[3], b.mass.mass);
              read_member(state[4], b.mass.inertia);
              return b;
            }))
        .def(
            "apply_impulse",
            [](const Body& body, const VectorGiven& impulse, const VectorGiven& point) {
              return Body{apply_impulse(body, checked_value(impulse, "impulse"), checked_value(point, "point")),
                          body.mass};
            },
            py::arg("impulse"), py::arg("point"), "The body after an impulse at a point of the world.");
  }

  static void add_blows(py::module_& m) {
    py::class_<Meeting>(m, "Blow", "Points of two bodies that share a normal, struck together.")
        .def(py::init([](const Whole& a, const Whole& b, const VectorGiven& normal, const py::object& points,
                         double restitution) {
               if (!(restitution >= 0 && restitution <= 1))
                 validate::fail("restitution", "a number from 0 to 1", restitution);
               return Meeting{a.as<std::uint32_t>("a"), b.as<std::uint32_t>("b"),
                              unit_vector<Words>(Words::value_of(normal), "normal"),
                              vectors_of<Words>(points, "points"), restitution};
             }),
             py::arg("a"), py::arg("b"), py::arg("normal"), py::arg("points"), py::arg("restitution") = 0.0,
             (std::string("a, b: places among the bodies. normal: unit, from a to b. points: ") + Words::vectors +
              ".\nrestitution: how much of the approach comes back, 0 to 1.")
                 .c_str())
        .def("__repr__",
             [](const py::object& self) { return call_text(class_name(self), arguments(self.cast<const Meeting&>())); })
        .def("__reduce__", [](const py::object& self) {
          py::list values;
          for (const auto& [name, value] : arguments(self.cast<const Meeting&>())) values.append(value);
          return py::make_tuple(py::type::of(self), py::tuple(values));
        });
    m.def("pass_on", &pass_all_on, py::arg("bodies"), py::arg("blows"), py::arg("resting_speed") = 0.0,
          py::arg("most") = Whole(1000),
          R"(What bodies do that touch each other while one of them is struck, as in a cradle: a dictionary.

Strikes the blow that approaches fastest until none does by more than `resting_speed`, or `most` were struck. `bodies`
are those after it, `impulses` has an array for each blow of what its points pushed, `struck` says how many blows were
struck, and `approach` how fast the fastest still is.)");
  }

  /// The arguments that make a blow anew.
  static Arguments arguments(const Meeting& x) {
    py::list points;
    for (const auto& point : x.points) points.append(member_of(point));
    return {{"a", py::cast(x.a)},
            {"b", py::cast(x.b)},
            {"normal", member_of(x.normal)},
            {"points", points},
            {"restitution", py::cast(x.restitution)}};
  }

  static py::dict pass_all_on(const std::vector<Body>& given, const std::vector<Meeting>& meetings,
                              double resting_speed, const Whole& most_blows) {
    const auto most = most_blows.as<std::size_t>("most");
    std::vector<Body> bodies = given;
    std::vector<typename Words::Blow> blows;
    std::vector<typename Words::Vector> points;
    for (const Meeting& meeting : meetings) {
      const std::string path = "blows[" + std::to_string(blows.size()) + "]";
      for (const auto& [place, name] : {std::pair(meeting.a, ".a"), std::pair(meeting.b, ".b")})
        if (place >= bodies.size()) validate::fail(path + name, "a place among the bodies", double(place));
      if (meeting.a == meeting.b) validate::fail(path + ".b", "another body than a", double(meeting.b));
      blows.push_back({meeting.a, meeting.b, meeting.normal, meeting.restitution,
                       static_cast<std::uint32_t>(points.size()), static_cast<std::uint32_t>(meeting.points.size())});
      points.insert(points.end(), meeting.points.begin(), meeting.points.end());
    }
    std::vector<double> impulses(points.size());
    PassedOn<double> passed;
    {
      coefficient(resting_speed, "resting_speed");
      const py::gil_scoped_release free;
      passed = pass_on<double>(bodies, blows, points, impulses, resting_speed, most);
    }
    py::list of_blows;
    for (const auto& blow : blows)
      of_blows.append(
          py::array_t<double>(static_cast<py::ssize_t>(blow.point_count), impulses.data() + blow.first_point));
    py::dict out;
    out["bodies"] = py::cast(bodies);
    out["impulses"] = of_blows;
    out["struck"] = passed.struck;
    out["approach"] = passed.approach;
    return out;
  }

  static void add_free(py::module_& m) {
    py::class_<Free>(m, "FreeBody",
                     (std::string("A body that nothing touches: it falls and turns, its angular momentum kept bit for "
                                  "bit.\n\npose: its centre of mass, and the principal axes. ") +
                      Words::moments_doc + ".\nRaises ValueError.")
                         .c_str())
        .def(py::init([](const typename Words::InertiaGiven& inertia, const Placement& pose, const VectorGiven& linear,
                         const TurningGiven& angular) {
               Free body = Words::free_body(pose.value, Words::value_of(inertia));
               body.linear = checked_value(linear, "linear");
               set_angular_velocity(body, checked_value(angular, "angular"));
               return body;
             }),
             py::arg("inertia"), py::arg("pose") = py::none(), py::arg("linear") = VectorGiven{},
             py::arg("angular") = TurningGiven{})
        .def_property_readonly(
            "pose",
            [](const Free& b) {
              return typename Words::Pose{b.center, b.rotation};
            },
            "The centre of mass and the principal axes, in the world.")
        .def_property_readonly(
            "linear", [](const Free& b) { return Words::object_of(b.linear); }, "The velocity of the centre of mass.")
        .def_property_readonly(
            "angular", [](const Free& b) { return Words::object_of(angular_velocity(b)); },
            "The rate of turning about the centre of mass, in radians.")
        .def_property_readonly(
            "angular_momentum", [](const Free& b) { return Words::object_of(b.angular_momentum); },
            "About the centre of mass, in the world's axes; what stays constant.")
        .def_property_readonly(
            "rotational_energy", [](const Free& b) { return rotational_energy(b); },
            "The energy of turning, half of angular velocity times angular momentum.")
        .def("__repr__",
             [](const py::object& self) {
               return call_text(class_name(self),
                                {{"pose", self.attr("pose")},
                                 {"linear", member_of(self.cast<const Free&>().linear)},
                                 {"angular_momentum", member_of(self.cast<const Free&>().angular_momentum)}});
             })
        .def(pickled<Free>(&Free::center, &Free::rotation, &Free::linear, &Free::angular_momentum,
                           &Free::inverse_inertia))
        .def(
            "advance",
            [](Free& body, double duration, const VectorGiven& acceleration) {
              if (!std::isfinite(duration)) validate::fail("duration", "a finite number", duration);
              advance(body, checked_value(acceleration, "acceleration"), duration);
            },
            py::arg("duration"), py::arg("acceleration") = VectorGiven{},
            "Moves it for `duration`, of either sign, under a constant acceleration.");
  }
};

}  // namespace graze::python
