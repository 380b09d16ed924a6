// The shapes of the plane as Python classes.
#include <pybind11/stl.h>

#include "bounded_convex.hpp"
#include "collected.hpp"
#include "graze/plane/mass.hpp"
#include "plane_convert.hpp"
#include "python_support.hpp"
#include "renamed.hpp"
#include "shapes.hpp"

namespace graze::python {

namespace {

using plane::Shaped;

/// A shape of one kind, so that Python has a class for each.
template <class C>
struct Of : Shaped {
  using Shaped::Shaped;
  explicit Of(const Shaped& shape) : Shaped(shape) {}
  const C& concrete() const { return *as<C>(); }
};

using Circle = plane::Circle<double>;
using Capsule = plane::Capsule<double>;
using Box = plane::Box<double>;
using Segment = plane::Segment<double>;
using ConvexPolygon = plane::ConvexPolygon<double>;
using Ellipse = plane::Ellipse<double>;
using UserConvex = plane::UserConvex<double>;
using HalfPlane = plane::HalfPlane<double>;
using Polygon = plane::Polygon<double>;
using Chain = plane::Chain<double>;
using Compound = plane::Compound<double>;

struct PlaneSupport {
  using Function = plane::SupportFunction<double>;
  using Vector = plane::Vec2d;
  static constexpr const char* expected = "two numbers";
  static py::object object_of(const plane::Vec2d& v) { return array_of(v); }
  static bool read(const py::object& from, plane::Vec2d& to) { return read_vector(from, to); }
};

PyObject* held_by(const Of<UserConvex>& shape) {
  const auto* support = python_support_of<PlaneSupport>(shape.concrete());
  return support != nullptr ? support->held_alone() : nullptr;
}
void let_go(const Of<UserConvex>& shape) {
  if (const auto* support = python_support_of<PlaneSupport>(shape.concrete())) support->let_go();
}

// Polygons and chains hold their pieces, not their points: their classes keep the points besides.

template <class C>
std::vector<plane::Vec2d> outline_of(const C& shape) {
  return shape.pieces().outline_vertices();
}

struct OfPolygon : Of<Polygon> {
  OfPolygon(std::vector<plane::Vec2d> given, double rounding)
      : Of<Polygon>(Polygon(given), rounding), points(std::make_shared<std::vector<plane::Vec2d>>(std::move(given))) {}
  explicit OfPolygon(const Shaped& shape)
      : Of<Polygon>(shape), points(std::make_shared<std::vector<plane::Vec2d>>(outline_of(concrete()))) {}
  std::shared_ptr<const std::vector<plane::Vec2d>> points;
};

struct OfChain : Of<Chain> {
  OfChain(std::vector<plane::Vec2d> given, bool closed, plane::ChainSides sides, double rounding)
      : Of<Chain>(Chain(given, closed, sides), rounding),
        points(std::make_shared<std::vector<plane::Vec2d>>(std::move(given))) {}
  explicit OfChain(const Shaped& shape)
      : Of<Chain>(shape), points(std::make_shared<std::vector<plane::Vec2d>>(outline_of(concrete()))) {}
  std::shared_ptr<const std::vector<plane::Vec2d>> points;
};

// The arguments that make a shape anew, by name.

py::dict arguments(const Of<Circle>& s) {
  py::dict a;
  a["radius"] = s.concrete().radius();
  return a;
}
py::dict arguments(const Of<Capsule>& s) {
  py::dict a;
  a["height"] = 2 * s.concrete().half_height();
  a["radius"] = s.concrete().radius_bottom();
  if (s.concrete().tapered()) a["radius_top"] = s.concrete().radius_top();
  return a;
}
py::dict arguments(const Of<Box>& s) {
  py::dict a;
  a["size"] = tuple_of(s.concrete().half_extents() * 2.0);
  return a;
}
py::dict arguments(const Of<Segment>& s) {
  py::dict a;
  a["a"] = tuple_of(s.concrete().a());
  a["b"] = tuple_of(s.concrete().b());
  return a;
}
py::dict arguments(const Of<ConvexPolygon>& s) {
  py::dict a;
  a["points"] = array_of_points(s.concrete().vertices());
  return a;
}
py::dict arguments(const Of<Ellipse>& s) {
  py::dict a;
  a["radii"] = tuple_of(s.concrete().radii());
  return a;
}
py::dict arguments(const Of<UserConvex>& s) {
  py::dict a;
  if (const auto* python = python_support_of<PlaneSupport>(s.concrete())) a["support"] = python->function();
  return a;
}
py::dict arguments(const Of<HalfPlane>&) { return {}; }
py::dict arguments(const OfPolygon& s) {
  py::dict a;
  a["points"] = array_of_points(*s.points);
  return a;
}
py::dict arguments(const OfChain& s) {
  py::dict a;
  a["points"] = array_of_points(*s.points);
  if (s.concrete().closed()) a["closed"] = true;
  if (s.concrete().sides() == plane::ChainSides::one) a["one_sided"] = true;
  return a;
}

template <class Class>
py::dict all_arguments(const Class& shape) {
  py::dict a = arguments(shape);
  if (shape.rounding() != 0) a["rounding"] = shape.rounding();
  return a;
}

/// An argument in the text of `repr`: of an array only its shape.
std::string text_of_argument(py::handle value) {
  if (py::isinstance<py::array>(value)) return "<array of shape " + std::string(py::str(value.attr("shape"))) + ">";
  return std::string(py::str(py::repr(value)));
}

/// A class of one kind of shape, which still lacks its constructor.
template <class Class>
py::class_<Class, Shaped> shape_class(py::module_& m, const char* name, const char* doc, const auto&... more) {
  py::class_<Class, Shaped> type(m, name, doc, more...);
  type.def("__repr__",
           [name](const Class& shape) {
             std::string text = std::string("graze.plane.") + name + "(";
             const char* comma = "";
             for (const auto& [key, value] : all_arguments(shape)) {
               text += comma + std::string(py::str(key)) + "=" + text_of_argument(value);
               comma = ", ";
             }
             return text + ")";
           })
      .def("__reduce__", [name](const Class& shape) {
        const py::module_ functools = py::module_::import("functools");
        const py::object make = py::module_::import("graze.plane").attr(name);
        const py::dict given = all_arguments(shape);
        if (std::is_same_v<Class, Of<UserConvex>> && !given.contains("support"))
          throw py::type_error("UserConvex: expected a support function in Python; a swept shape is not pickled");
        return py::make_tuple(functools.attr("partial")(make, **given), py::tuple());
      });
  return type;
}

void add_round(py::module_& m) {
  shape_class<Of<Circle>>(m, "Circle", "A disc of `radius` >= 0 about the origin.")
      .def(py::init([](double radius) { return Of<Circle>(Circle(radius)); }), py::arg("radius"))
      .def_property_readonly(
          "radius", [](const Of<Circle>& s) { return s.concrete().radius(); }, "A length.");
  shape_class<Of<Capsule>>(m, "Capsule", R"(Two discs and all between them, about the origin along Y.

height: between the centres of the discs. radius: of the lower, and of the upper one too
unless `radius_top` is given. All >= 0.)")
      .def(py::init([](double height, double radius, std::optional<double> top, double rounding) {
             return renamed(tapered_names,
                            [&] { return Of<Capsule>(Capsule(height, radius, top.value_or(radius)), rounding); });
           }),
           py::arg("height"), py::arg("radius"), py::arg("radius_top") = py::none(), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "height", [](const Of<Capsule>& s) { return 2 * s.concrete().half_height(); },
          "Between the centres of the discs, a length.")
      .def_property_readonly(
          "radius", [](const Of<Capsule>& s) { return s.concrete().radius_bottom(); }, "Of the lower end, a length.")
      .def_property_readonly(
          "radius_top", [](const Of<Capsule>& s) { return s.concrete().radius_top(); }, "Of the upper end, a length.");
  shape_class<Of<Ellipse>>(m, "Ellipse", "An ellipse about the origin; `radii` along the axes, each >= 0.")
      .def(py::init([](const Vector2& radii, double rounding) { return Of<Ellipse>(Ellipse(radii.value), rounding); }),
           py::arg("radii"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "radii", [](const Of<Ellipse>& s) { return array_of(s.concrete().radii()); }, "The half axes, lengths.");
}

void add_flat(py::module_& m) {
  shape_class<Of<Box>>(m, "Box", R"(A solid rectangle about the origin, its edges along the axes.

size: the full edge lengths, each >= 0. rounding: the radius of a disc that is added, >= 0.

>>> from graze import plane
>>> plane.Box((2, 1), rounding=0.1)
graze.plane.Box(size=(2.0, 1.0), rounding=0.1)
)")
      .def(py::init([](const Vector2& size, double rounding) { return Of<Box>(Box(size.value), rounding); }),
           py::arg("size"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "size", [](const Of<Box>& s) { return array_of(s.concrete().half_extents() * 2.0); },
          "The full edge lengths.");
  shape_class<Of<Segment>>(m, "Segment", "The straight piece between two points; with a rounding a capsule.")
      .def(py::init([](const Vector2& a, const Vector2& b, double rounding) {
             return renamed(corner_names, [&] { return Of<Segment>(Segment(a.value, b.value), rounding); });
           }),
           py::arg("a"), py::arg("b"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "a", [](const Of<Segment>& s) { return array_of(s.concrete().a()); }, "The first end, in the shape's frame.")
      .def_property_readonly(
          "b", [](const Of<Segment>& s) { return array_of(s.concrete().b()); }, "The other end.");
  shape_class<Of<HalfPlane>>(m, "HalfPlane",
                             "All points with y <= 0 in its own frame; a rounding moves its surface up.")
      .def(py::init([](double rounding) { return Of<HalfPlane>(HalfPlane(), rounding); }), py::arg("rounding") = 0.0);
  shape_class<Of<ConvexPolygon>>(m, "ConvexPolygon", "The convex hull of at least one point: `points` of shape (n, 2).")
      .def(py::init([](const py::object& points, double rounding) {
             return Of<ConvexPolygon>(ConvexPolygon(points_of_plane(points, "points")), rounding);
           }),
           py::arg("points"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "vertices", [](const Of<ConvexPolygon>& s) { return array_of_points(s.concrete().vertices()); },
          "Of the hull, counter-clockwise: an array of shape (m, 2).");
  shape_class<Of<UserConvex>>(m, "UserConvex", R"(Your own convex shape: one support function.

support: takes a direction (an array of two numbers, not zero) and returns the point of the set
that lies furthest along it. It has to be a function of its argument alone. What it raises, and a
TypeError for what is no point, is raised by the call that asked it, when that returns; its answer
is lost. A method of what holds the shape keeps both alive as long as something else has the shape.)",
                              collected<Of<UserConvex>>())
      .def(py::init([](py::function support, double rounding) {
             return Of<UserConvex>(UserConvex(std::make_shared<PythonSupport<PlaneSupport>>(std::move(support))),
                                   rounding);
           }),
           py::arg("support"), py::arg("rounding") = 0.0);
}

void add_outlined(py::module_& m) {
  shape_class<OfPolygon>(m, "Polygon", R"(A solid polygon, convex or not, without holes.

points: shape (n, 2) with n >= 3, around the polygon either way. Raises ValueError that names the
point where the outline turns back on itself, crosses or touches itself.)")
      .def(py::init([](const py::object& points, double rounding) {
             return OfPolygon(points_of_plane(points, "points"), rounding);
           }),
           py::arg("points"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "points", [](const OfPolygon& s) { return array_of_points(*s.points); }, "The corners, shape (n, 2).");
  shape_class<OfChain>(m, "Chain", R"(Segments joined end to end, without an inside.

points: shape (n, 2) with n >= 2, no two in a row the same. closed: it goes on from the last to
the first. one_sided: contacts push to the right of its segments alone.)")
      .def(py::init([](const py::object& points, bool closed, bool one_sided, double rounding) {
             return OfChain(points_of_plane(points, "points"), closed,
                            one_sided ? plane::ChainSides::one : plane::ChainSides::both, rounding);
           }),
           py::arg("points"), py::arg("closed") = false, py::arg("one_sided") = false, py::arg("rounding") = 0.0)
      .def_property_readonly(
          "points", [](const OfChain& s) { return array_of_points(*s.points); }, "The corners, shape (n, 2).")
      .def_property_readonly(
          "closed", [](const OfChain& s) { return s.concrete().closed(); },
          "Whether it goes on from the last point to the first.");
}

/// A compound, and the Python objects of its children.
struct OfCompound : Of<Compound> {
  OfCompound(std::vector<plane::Placed<double>> placed, py::list given, double rounding)
      : Of<Compound>(Compound(std::move(placed)), rounding), children(std::move(given)) {}
  explicit OfCompound(const Shaped& shape) : Of<Compound>(shape) {
    for (const auto& child : concrete().children()) children.append(py::make_tuple(object_of(child.shape), child.pose));
  }
  py::list children;
};

template <class C>
struct ClassOf {
  using type = Of<C>;
};
template <>
struct ClassOf<Polygon> {
  using type = OfPolygon;
};
template <>
struct ClassOf<Chain> {
  using type = OfChain;
};
template <>
struct ClassOf<Compound> {
  using type = OfCompound;
};

py::dict arguments(const OfCompound& s) {
  py::dict a;
  a["children"] = s.children;
  return a;
}

OfCompound compound_of(const py::iterable& children, double rounding) {
  std::vector<plane::Placed<double>> placed;
  py::list kept;
  for (const py::handle child : children) {
    const std::string name = "children[" + std::to_string(placed.size()) + "]";
    plane::Pose2d pose;
    const auto pair = py::reinterpret_borrow<py::object>(child);
    if (!py::isinstance<py::tuple>(pair) || py::len(pair) != 2 || !py::isinstance<Shaped>(pair[py::int_(0)]))
      throw py::type_error(name + ": expected a pair (shape, pose)");
    try {
      if (!read_pose(py::object(pair[py::int_(1)]), pose)) throw py::type_error(name + "[1]: expected a pose");
    } catch (const InvalidValue& error) {
      throw error.below(name);
    }
    placed.push_back({py::object(pair[py::int_(0)]).cast<const Shaped&>(), pose});
    kept.append(py::make_tuple(py::object(pair[py::int_(0)]), pose));
  }
  return {std::move(placed), std::move(kept), rounding};
}

}  // namespace

py::object object_of(const plane::Shaped& shape) {
  return shape.visit([&]<class C>(const C&) { return py::cast(typename ClassOf<C>::type(shape)); });
}

void add_plane_shapes(py::module_& m) {
  py::class_<Shaped>(m, "Shape", "Any shape of the plane: immutable, and cheap to copy.")
      .def_property_readonly("rounding", &Shaped::rounding, "The radius of the disc that is added to it.")
      .def_property_readonly("convex", &Shaped::convex,
                             "Whether the shape is convex, as a half-plane is; polygons, chains and compounds are not.")
      .def(
          "bounds",
          [](const Shaped& shape, const Placement2& pose) {
            const plane::Aabb2<double> box = bounds(shape, pose.value);
            return py::make_tuple(array_of(box.lower), array_of(box.upper));
          },
          py::arg("pose") = py::none(),
          "The lower and upper corner of a rectangle about the shape; not less than the true one.")
      .def(
          "support",
          [](const Shaped& shape, const Vector2& direction) {
            return array_of(support(bounded_convex(shape), checked(direction.value, "direction")));
          },
          py::arg("direction"), "The point of a bounded convex shape furthest along a direction in its frame.")
      .def(
          "swept",
          [](const Shaped& shape, const Placement2& pose, const Vector2& motion) {
            return ShapeObject{object_of(swept(shape, pose.value, motion.value))};
          },
          py::arg("pose"), py::arg("motion"),
          R"(The region that a bounded convex shape, standing at `pose`, sweeps while it moves by `motion`.

Without turning; the result stands at the same pose. Raises ValueError.

>>> from graze import plane
>>> plane.Circle(0.5).swept((3, 0), (2, 0))
graze.plane.Segment(a=(0.0, 0.0), b=(2.0, 0.0), rounding=0.5)
)")
      .def(
          "mass_properties",
          [](const Shaped& shape) {
            const plane::MassProperties<double> mass = mass_properties(shape);
            return py::make_tuple(mass.area, array_of(mass.center), mass.inertia);
          },
          R"((area, its centre, inertia about that) of density one; area 0 for what has none.

The centre is in the shape's frame; a body of mass m has the inertia m * inertia / area. Costs what
the shape has of vertices.

>>> from graze import plane
>>> area, center, inertia = plane.Box((2, 1)).mass_properties()
>>> area, center, round(inertia, 12)
(2.0, array([0., 0.]), 0.833333333333)
)");
  add_round(m);
  add_flat(m);
  add_outlined(m);
  shape_class<OfCompound>(m, "Compound", R"(Several shapes as one.

children: pairs (shape, pose), at least one. rounding: the radius by which each of them grows.)")
      .def(py::init(&compound_of), py::arg("children"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "children", [](const OfCompound& s) { return py::list(s.children); },
          "The pairs (shape, pose) it was made of.");
}

}  // namespace graze::python
