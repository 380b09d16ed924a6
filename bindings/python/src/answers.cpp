#include "answers.hpp"

#include "plain_values.hpp"

#include "whole.hpp"
#include <pybind11/stl.h>

namespace graze::python {

namespace {

template <class C, class T>
auto vector_of(Vec3<T> C::*member) {
  return [member](const C& c) { return array_of(c.*member); };
}

py::tuple object_of(const TraceSupport& s) { return py::make_tuple(tuple_of(s.a), tuple_of(s.b)); }

template <class List, class F>
py::list list_of(const List& list, F&& f) {
  py::list out;
  for (const auto& item : list) out.append(f(item));
  return out;
}

py::list outline_of(const std::vector<TraceSupport>& points) {
  return list_of(points, [](const TraceSupport& p) { return object_of(p); });
}

py::list corners_of(const std::vector<Vec3d>& corners) {
  return list_of(corners, [](const Vec3d& p) { return tuple_of(p); });
}

std::string text_of(double value) { return validate::number(value); }

std::string text_of(const Vec3d& v) { return "[" + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + "]"; }

void add_distances(py::module_& m) {
  py::class_<Distance<double>>(m, "Distance", "A signed distance: b - a = distance * normal.")
      .def_readonly("distance", &Distance<double>::distance,
                    "A length; negative where the shapes overlap: minus the shortest way out.")
      .def_property_readonly("normal", vector_of(&Distance<double>::normal), "Unit, from a to b.")
      .def_property_readonly("a", vector_of(&Distance<double>::a), "On the surface of a, in the world.")
      .def_property_readonly("b", vector_of(&Distance<double>::b), "On the surface of b.")
      .def_property_readonly(
          "status", [](const Distance<double>& d) { return python::text_of(d.status); },
          "'converged', 'bounded' (right within `error`) or 'unbounded'.")
      .def_readonly("error", &Distance<double>::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def("__float__", [](const Distance<double>& d) { return d.distance; })
      .def("__repr__",
           [](const Distance<double>& d) {
             return "graze.Distance(" + text_of(d.distance) + ", normal=" + text_of(d.normal) + ")";
           })
      .def(pickled<Distance<double>>(&Distance<double>::distance, &Distance<double>::normal, &Distance<double>::a,
                                     &Distance<double>::b, &Distance<double>::status, &Distance<double>::error));
  py::class_<Closest<double>>(m, "Closest", "A point of a surface: question - point = distance * normal.")
      .def_readonly("distance", &Closest<double>::distance, "Negative inside a solid.")
      .def_property_readonly("point", vector_of(&Closest<double>::point),
                             "The nearest point of the surface, in the world.")
      .def_property_readonly("normal", vector_of(&Closest<double>::normal), "Unit, outward.")
      .def_property_readonly(
          "status", [](const Closest<double>& c) { return python::text_of(c.status); },
          "'converged', 'bounded' (right within `error`) or 'unbounded'.")
      .def_readonly("error", &Closest<double>::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def("__repr__",
           [](const Closest<double>& c) {
             return "graze.Closest(" + text_of(c.distance) + ", point=" + text_of(c.point) + ")";
           })
      .def(pickled<Closest<double>>(&Closest<double>::distance, &Closest<double>::point, &Closest<double>::normal,
                                    &Closest<double>::status, &Closest<double>::error));
}

void add_hits(py::module_& m) {
  py::class_<RayHit<double>>(m, "RayHit", "Where a ray meets a shape.")
      .def_readonly("t", &RayHit<double>::t, "Along the ray, a length.")
      .def_property_readonly("point", vector_of(&RayHit<double>::point),
                             "On the surface, in the world; the origin of a ray that begins inside a solid.")
      .def_property_readonly("normal", vector_of(&RayHit<double>::normal), "Unit, against the ray.")
      .def_readonly("piece", &RayHit<double>::piece, "The triangle of a mesh or the child of a compound, else 0.")
      .def("__repr__",
           [](const RayHit<double>& h) {
             return "graze.RayHit(t=" + text_of(h.t) + ", point=" + text_of(h.point) + ")";
           })
      .def(pickled<RayHit<double>>(&RayHit<double>::t, &RayHit<double>::point, &RayHit<double>::normal,
                                   &RayHit<double>::piece));
  py::class_<CastHit<double>>(m, "CastHit", "When and where two moving bodies first touch.")
      .def_readonly("t", &CastHit<double>::t, "The time of the first contact, from 0 to `duration`, in its unit.")
      .def_property_readonly("point", vector_of(&CastHit<double>::point), "In the world at time t.")
      .def_property_readonly("normal", vector_of(&CastHit<double>::normal), "Unit, from a to b.")
      .def_readonly("depth", &CastHit<double>::depth, "Of bodies that overlap from the start, else 0.")
      .def_property_readonly(
          "status", [](const CastHit<double>& h) { return python::text_of(h.status); },
          "'converged', 'bounded' (right within `error`) or 'unbounded'.")
      .def_readonly("piece_a", &CastHit<double>::piece_a,
                    "The triangle of a mesh or the child of a compound that a touches with, else 0.")
      .def_readonly("piece_b", &CastHit<double>::piece_b, "The same of b.")
      .def("__repr__",
           [](const CastHit<double>& h) {
             return "graze.CastHit(t=" + text_of(h.t) + ", point=" + text_of(h.point) + ")";
           })
      .def(pickled<CastHit<double>>(&CastHit<double>::t, &CastHit<double>::point, &CastHit<double>::normal,
                                    &CastHit<double>::depth, &CastHit<double>::status, &CastHit<double>::piece_a,
                                    &CastHit<double>::piece_b));
}

void add_contacts(py::module_& m) {
  py::class_<ContactPoint<double>>(m, "ContactPoint", "One point of contact: b - a = distance * normal.")
      .def_property_readonly("a", vector_of(&ContactPoint<double>::a), "On the surface of a, in the world.")
      .def_property_readonly("b", vector_of(&ContactPoint<double>::b), "On the surface of b, in the world.")
      .def_readonly("distance", &ContactPoint<double>::distance, "Negative is penetration.")
      .def_readonly("feature", &ContactPoint<double>::feature, "The same as long as the same features touch.")
      .def_property_readonly(
          "position", [](const ContactPoint<double>& p) { return array_of(p.position()); },
          "The point between the two that a solver wants.")
      .def("__repr__",
           [](const ContactPoint<double>& p) {
             return "graze.ContactPoint(" + text_of(p.distance) + ", position=" + text_of(p.position()) + ")";
           })
      .def(pickled<ContactPoint<double>>(&ContactPoint<double>::a, &ContactPoint<double>::b,
                                         &ContactPoint<double>::distance, &ContactPoint<double>::feature,
                                         &ContactPoint<double>::weight));
  py::class_<Manifold<double>>(m, "Manifold", "Points of contact that share a normal.")
      .def_property_readonly("normal", vector_of(&Manifold<double>::normal), "Unit, from a to b.")
      .def_property_readonly(
          "points",
          [](const Manifold<double>& manifold) {
            return list_of(manifold.points, [](const auto& p) { return py::cast(p); });
          },
          "The points, a list of ContactPoint.")
      .def_readonly("piece_a", &Manifold<double>::piece_a,
                    "The triangle of a mesh or the child of a compound that a touches with, else 0.")
      .def_readonly("piece_b", &Manifold<double>::piece_b, "The same of b.")
      .def_property_readonly(
          "status", [](const Manifold<double>& x) { return python::text_of(x.status); },
          "'converged', 'bounded' (right within `error`) or 'unbounded'.")
      .def_readonly("error", &Manifold<double>::error,
                    "A bound of the difference from the truth, a length; 0 where the status is 'converged'.")
      .def(
          "reduce",
          [](Manifold<double>& manifold, const Whole& count) {
            reduce(manifold, count.at_least<std::size_t>(1, "count"));
          },
          py::arg("count"), "Keeps the `count` points that span most.")
      .def("__len__", [](const Manifold<double>& manifold) { return manifold.points.size(); })
      .def(pickled_manifold<Manifold<double>>())
      .def("__repr__", [](const Manifold<double>& manifold) {
        return "graze.Manifold(normal=" + text_of(manifold.normal) + ", " + std::to_string(manifold.points.size()) +
               " points)";
      });
}

}  // namespace

py::dict object_of(const Trace& trace) {
  py::dict out;
  out["method"] = trace.method;
  out["axes"] = list_of(trace.axes, [](const TraceAxis& axis) {
    py::dict a;
    a["name"] = axis.name;
    a["direction"] = tuple_of(axis.direction);
    a["a"] = py::make_tuple(axis.a_lower, axis.a_upper);
    a["b"] = py::make_tuple(axis.b_lower, axis.b_upper);
    a["overlap"] = axis.overlap();
    return a;
  });
  out["gjk"] = list_of(trace.gjk, [](const TraceGjk& step) {
    py::dict s;
    s["simplex"] = outline_of(step.simplex);
    s["direction"] = tuple_of(step.direction);
    s["found"] = object_of(step.found);
    s["lower"] = step.lower;
    s["upper"] = step.upper;
    if (!step.polygon.empty()) s["polygon"] = outline_of(step.polygon);
    return s;
  });
  out["epa"] = list_of(trace.epa, [](const TraceEpa& step) {
    py::dict s;
    s["normal"] = tuple_of(step.normal);
    s["face_depth"] = step.face_depth;
    s["found_depth"] = step.found_depth;
    s["found"] = object_of(step.found);
    s["faces"] = step.faces;
    if (!step.polygon.empty()) s["polygon"] = outline_of(step.polygon);
    return s;
  });
  out["difference"] = outline_of(trace.difference);
  out["rounding"] = trace.rounding;
  out["polytope"] = outline_of(trace.polytope);
  out["triangles"] = list_of(trace.triangles, [](const auto& t) { return py::make_tuple(t[0], t[1], t[2]); });
  out["spans"] = list_of(trace.spans, [](const TraceSpan& span) {
    py::dict s;
    s["name"] = span.name;
    s["normal"] = tuple_of(span.normal);
    s["enter"] = span.enter;
    s["leave"] = span.leave;
    return s;
  });
  out["steps"] = list_of(trace.steps, [](const TraceStep& step) {
    py::dict s;
    s["t"] = step.t;
    s["distance"] = step.distance;
    s["normal"] = tuple_of(step.normal);
    return s;
  });
  out["face_a"] = corners_of(trace.face_a);
  out["face_b"] = corners_of(trace.face_b);
  out["cuts"] = list_of(trace.cuts, [](const TraceCut& cut) {
    py::dict c;
    c["from"] = tuple_of(cut.from);
    c["to"] = tuple_of(cut.to);
    c["left"] = corners_of(cut.left);
    return c;
  });
  out["nodes"] = trace.nodes;
  out["pieces"] = trace.pieces;
  out["winner"] = trace.winner;
  out["reason"] = trace.reason;
  return out;
}

py::dtype distance_type() {
  using D = Distance<double>;
  return record_type({{"distance", "f8", offsetof(D, distance)},
                      {"normal", "(3,)f8", offsetof(D, normal)},
                      {"a", "(3,)f8", offsetof(D, a)},
                      {"b", "(3,)f8", offsetof(D, b)},
                      {"status", "u1", offsetof(D, status)},
                      {"error", "f8", offsetof(D, error)}},
                     sizeof(D));
}

py::dtype point_type() {
  using P = ContactPoint<double>;
  return record_type({{"a", "(3,)f8", offsetof(P, a)},
                      {"b", "(3,)f8", offsetof(P, b)},
                      {"distance", "f8", offsetof(P, distance)},
                      {"feature", "u4", offsetof(P, feature)},
                      {"weight", "f8", offsetof(P, weight)}},
                     sizeof(P));
}

void add_answers(py::module_& m) {
  add_distances(m);
  add_hits(m);
  add_contacts(m);
}

}  // namespace graze::python
