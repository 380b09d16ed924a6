// Answers about the plane for Python.
#include "plain_values.hpp"
#include "plane_convert.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

using Distance = plane::Distance<double>;
using Closest = plane::Closest<double>;
using ContactPoint = plane::ContactPoint<double>;
using Manifold = plane::Manifold<double>;
using RayHit = plane::RayHit<double>;
using CastHit = plane::CastHit<double>;

template <class C>
auto vector_of(plane::Vec2d C::*member) {
  return [member](const C& c) { return array_of(c.*member); };
}
template <class C>
auto status_of() {
  return [](const C& c) { return text_of(c.status); };
}
std::string text(double value) { return validate::number(value); }
std::string text(const plane::Vec2d& v) { return "[" + text(v.x) + ", " + text(v.y) + "]"; }

constexpr const char* status_doc = "'converged', 'bounded' (right within `error`) or 'unbounded'.";

void add_contacts(py::module_& m) {
  py::class_<ContactPoint>(m, "ContactPoint", "One point of contact: b - a = distance * normal.")
      .def_property_readonly("a", vector_of(&ContactPoint::a), "On the surface of a, in the world.")
      .def_property_readonly("b", vector_of(&ContactPoint::b), "On the surface of b.")
      .def_readonly("distance", &ContactPoint::distance, "Negative is penetration.")
      .def_readonly("feature", &ContactPoint::feature, "The same as long as the same features touch.")
      .def_property_readonly(
          "position", [](const ContactPoint& p) { return array_of(p.position()); },
          "The point between the two that a solver wants.")
      .def("__repr__",
           [](const ContactPoint& p) {
             return "graze.plane.ContactPoint(" + text(p.distance) + ", position=" + text(p.position()) + ")";
           })
      .def(pickled<ContactPoint>(&ContactPoint::a, &ContactPoint::b, &ContactPoint::distance, &ContactPoint::feature,
                                 &ContactPoint::weight));
  py::class_<Manifold>(m, "Manifold", "At most two points of contact that share a normal.")
      .def_property_readonly("normal", vector_of(&Manifold::normal), "Unit, from a to b.")
      .def_property_readonly(
          "points",
          [](const Manifold& manifold) {
            py::list points;
            for (const ContactPoint& p : manifold.points) points.append(py::cast(p));
            return points;
          },
          "The points, a list of at most two ContactPoint.")
      .def_readonly("piece_a", &Manifold::piece_a, "The child or piece of a that touches, else 0.")
      .def_readonly("piece_b", &Manifold::piece_b, "The same of b.")
      .def_property_readonly("status", status_of<Manifold>(), status_doc)
      .def_readonly("error", &Manifold::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def(
          "reduce",
          [](Manifold& manifold, const Whole& count) { reduce(manifold, count.at_least<std::size_t>(1, "count")); },
          py::arg("count"), "Keeps the `count` deepest points.")
      .def("__len__", [](const Manifold& manifold) { return manifold.points.size(); })
      .def(pickled_manifold<Manifold>())
      .def("__repr__", [](const Manifold& manifold) {
        return "graze.plane.Manifold(normal=" + text(manifold.normal) + ", " + std::to_string(manifold.points.size()) +
               " points)";
      });
}

}  // namespace

void add_plane_answers(py::module_& m) {
  py::class_<Distance>(m, "Distance", "A signed distance: b - a = distance * normal.")
      .def_readonly("distance", &Distance::distance,
                    "A length; negative where the shapes overlap: minus the shortest way out.")
      .def_property_readonly("normal", vector_of(&Distance::normal), "Unit, from a to b.")
      .def_property_readonly("a", vector_of(&Distance::a), "On the surface of a, in the world.")
      .def_property_readonly("b", vector_of(&Distance::b), "On the surface of b.")
      .def_property_readonly("status", status_of<Distance>(), status_doc)
      .def_readonly("error", &Distance::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def("__float__", [](const Distance& d) { return d.distance; })
      .def("__repr__",
           [](const Distance& d) {
             return "graze.plane.Distance(" + text(d.distance) + ", normal=" + text(d.normal) + ")";
           })
      .def(pickled<Distance>(&Distance::distance, &Distance::normal, &Distance::a, &Distance::b, &Distance::status,
                             &Distance::error));
  py::class_<Closest>(m, "Closest", "A point of a surface: question - point = distance * normal.")
      .def_readonly("distance", &Closest::distance, "Negative inside a solid.")
      .def_property_readonly("point", vector_of(&Closest::point), "The nearest point of the surface, in the world.")
      .def_property_readonly("normal", vector_of(&Closest::normal), "Unit, outward.")
      .def_property_readonly("status", status_of<Closest>(), status_doc)
      .def_readonly("error", &Closest::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def(
          "__repr__",
          [](const Closest& c) { return "graze.plane.Closest(" + text(c.distance) + ", point=" + text(c.point) + ")"; })
      .def(pickled<Closest>(&Closest::distance, &Closest::point, &Closest::normal, &Closest::status, &Closest::error));
  py::class_<RayHit>(m, "RayHit", "Where a ray meets a shape.")
      .def_readonly("t", &RayHit::t, "Along the ray, a length.")
      .def_property_readonly("point", vector_of(&RayHit::point),
                             "On the surface, in the world; the origin of a ray that begins inside a solid.")
      .def_property_readonly("normal", vector_of(&RayHit::normal), "Unit, against the ray.")
      .def_readonly("piece", &RayHit::piece, "The child of a compound, else 0.")
      .def_property_readonly("status", status_of<RayHit>(), status_doc)
      .def("__repr__",
           [](const RayHit& h) { return "graze.plane.RayHit(t=" + text(h.t) + ", point=" + text(h.point) + ")"; })
      .def(pickled<RayHit>(&RayHit::t, &RayHit::point, &RayHit::normal, &RayHit::piece, &RayHit::status));
  py::class_<CastHit>(m, "CastHit", "When and where two moving bodies first touch.")
      .def_readonly("t", &CastHit::t, "The time of the first contact, from 0 to `duration`, in its unit.")
      .def_property_readonly("point", vector_of(&CastHit::point), "In the world at time t.")
      .def_property_readonly("normal", vector_of(&CastHit::normal), "Unit, from a to b.")
      .def_readonly("depth", &CastHit::depth, "Of bodies that overlap from the start, else 0.")
      .def_property_readonly("status", status_of<CastHit>(), status_doc)
      .def_readonly(
          "piece_a", &CastHit::piece_a,
          "The child of a compound, the piece of a polygon or the segment of a chain that a touches with, else 0.")
      .def_readonly("piece_b", &CastHit::piece_b, "The same of b.")
      .def("__repr__",
           [](const CastHit& h) { return "graze.plane.CastHit(t=" + text(h.t) + ", point=" + text(h.point) + ")"; })
      .def(pickled<CastHit>(&CastHit::t, &CastHit::point, &CastHit::normal, &CastHit::depth, &CastHit::status,
                            &CastHit::piece_a, &CastHit::piece_b));
  add_contacts(m);
}

}  // namespace graze::python
