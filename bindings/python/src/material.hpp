// The class `Material` of a module, for space and the plane: written once over the words of `world.hpp`.
#pragma once

#include "answers.hpp"
#include "graze/material.hpp"
#include "plain_values.hpp"

namespace graze::python {

/// The rule of a word. Throws `InvalidValue` for a word that is none.
Combine combine_of(const std::string& name, const char* path);
/// The word of a rule.
const char* text_of(Combine combine);

/// Defines the class.
template <class Words>
void add_material(py::module_& m) {
  using Vector = typename Words::Vector;
  using Material = graze::Material<double, typename Words::Space::Vec>;
  const Material usual;
  py::class_<Material>(m, "Material", R"(What a surface is made of.

Frictions are Coulomb's coefficients >= 0, restitution is 0 to 1, rolling friction a length;
combine modes: 'unset', 'average', 'minimum', 'maximum' or 'multiply'. surface_velocity: of a belt,
in the body's frame. Raises ValueError for a combine mode or a number that is none.)")
      .def(py::init([](double static_friction, double dynamic_friction, double restitution, double rolling_friction,
                       const std::string& friction_combine, const std::string& restitution_combine,
                       const Vector& surface_velocity) {
             const Material material{static_friction,
                                     dynamic_friction,
                                     restitution,
                                     rolling_friction,
                                     combine_of(friction_combine, "friction_combine"),
                                     combine_of(restitution_combine, "restitution_combine"),
                                     Words::checked(surface_velocity, "surface_velocity")};
             check(material);
             return material;
           }),
           py::arg("static_friction") = usual.static_friction, py::arg("dynamic_friction") = usual.dynamic_friction,
           py::arg("restitution") = usual.restitution, py::arg("rolling_friction") = usual.rolling_friction,
           py::arg("friction_combine") = "unset", py::arg("restitution_combine") = "unset",
           py::arg("surface_velocity") = Vector{})
      .def_readonly("static_friction", &Material::static_friction,
                    "Coulomb's coefficient of what does not slide, >= 0.")
      .def_readonly("dynamic_friction", &Material::dynamic_friction, "Coulomb's coefficient of what slides, >= 0.")
      .def_readonly("restitution", &Material::restitution,
                    "The fraction of the approach speed that comes back, 0 to 1.")
      .def_readonly("rolling_friction", &Material::rolling_friction,
                    "A length: torque against rolling by the normal force.")
      .def_property_readonly(
          "friction_combine", [](const Material& x) { return python::text_of(x.friction_combine); },
          "How the coefficients of two materials are combined: 'unset', 'average', 'minimum', 'maximum' or "
          "'multiply'.")
      .def_property_readonly(
          "restitution_combine", [](const Material& x) { return python::text_of(x.restitution_combine); },
          "How the restitutions of two materials are combined, as for friction.")
      .def_property_readonly(
          "surface_velocity", [](const Material& x) { return array_of(x.surface_velocity); },
          "Of a conveyor's surface, in the body's frame.")
      .def("__repr__",
           [](const py::object& self) {
             const auto& x = self.cast<const Material&>();
             return call_text(class_name(self),
                              {{"static_friction", py::cast(x.static_friction)},
                               {"dynamic_friction", py::cast(x.dynamic_friction)},
                               {"restitution", py::cast(x.restitution)},
                               {"rolling_friction", py::cast(x.rolling_friction)},
                               {"friction_combine", py::cast(python::text_of(x.friction_combine))},
                               {"restitution_combine", py::cast(python::text_of(x.restitution_combine))},
                               {"surface_velocity", tuple_of(x.surface_velocity)}});
           })
      .def("__reduce__", [](const py::object& self) {
        const auto& x = self.cast<const Material&>();
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(x.static_friction, x.dynamic_friction, x.restitution, x.rolling_friction,
                                             python::text_of(x.friction_combine),
                                             python::text_of(x.restitution_combine), tuple_of(x.surface_velocity)));
      });
}

}  // namespace graze::python
