#include "shapes.hpp"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include "bounded_convex.hpp"
#include "collected.hpp"
#include "python_support.hpp"
#include "renamed.hpp"

namespace graze::python {

namespace {

/// A shape of one kind, so that Python has a class for each.
template <class C>
struct Of : Shaped {
  using Shaped::Shaped;
  explicit Of(const Shaped& shape) : Shaped(shape) {}
  const C& concrete() const { return *as<C>(); }
};

struct SpaceSupport {
  using Function = SupportFunction<double>;
  using Vector = Vec3d;
  static constexpr const char* expected = "three numbers";
  static py::object object_of(const Vec3d& v) { return array_of(v); }
  static bool read(const py::object& from, Vec3d& to) { return read_vector(from, to); }
};

PyObject* held_by(const Of<UserConvex<double>>& shape) {
  const auto* support = python_support_of<SpaceSupport>(shape.concrete());
  return support != nullptr ? support->held_alone() : nullptr;
}
void let_go(const Of<UserConvex<double>>& shape) {
  if (const auto* support = python_support_of<SpaceSupport>(shape.concrete())) support->let_go();
}

// The arguments that make a shape anew, by name.

py::dict arguments(const Sphere<double>& s) {
  py::dict a;
  a["radius"] = s.radius();
  if (s.center() != Vec3d{}) a["center"] = tuple_of(s.center());
  return a;
}
template <class C>
py::dict tapered_arguments(const C& c) {
  py::dict a;
  a["height"] = 2 * c.half_height();
  a["radius"] = c.radius_bottom();
  if (c.radius_top() != c.radius_bottom()) a["radius_top"] = c.radius_top();
  return a;
}
py::dict arguments(const Capsule<double>& c) { return tapered_arguments(c); }
py::dict arguments(const Cylinder<double>& c) { return tapered_arguments(c); }
py::dict arguments(const Box<double>& b) {
  py::dict a;
  a["size"] = tuple_of(b.half_extents() * 2.0);
  return a;
}
py::dict arguments(const Rectangle<double>& r) {
  py::dict a;
  a["size_x"] = 2 * r.as_box().half_extents().x;
  a["size_z"] = 2 * r.as_box().half_extents().z;
  return a;
}
py::dict arguments(const Ellipsoid<double>& e) {
  py::dict a;
  a["radii"] = tuple_of(e.radii());
  return a;
}
py::dict arguments(const LineSegment<double>& s) {
  py::dict a;
  a["a"] = tuple_of(s.point(0));
  a["b"] = tuple_of(s.point(1));
  return a;
}
py::dict arguments(const Triangle<double>& t) {
  py::dict a;
  a["a"] = tuple_of(t.point(0));
  a["b"] = tuple_of(t.point(1));
  a["c"] = tuple_of(t.point(2));
  return a;
}
py::array_t<std::uint32_t> array_of_triangles(std::span<const Mesh<double>::Index> triangles) {
  py::array_t<std::uint32_t> array({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  std::uint32_t* out = array.mutable_data();
  for (const auto& t : triangles) out = std::copy(t.begin(), t.end(), out);
  return array;
}
py::dict arguments(const ConvexHull<double>& hull) {
  py::dict a;
  a["points"] = array_of_points(hull.data().vertices);
  return a;
}
py::dict arguments(const UserConvex<double>& user) {
  py::dict a;
  if (const auto* python = python_support_of<SpaceSupport>(user)) a["support"] = python->function();
  return a;
}
py::dict arguments(const HalfSpace<double>&) { return {}; }
py::dict counts_of(const MeshFindings& found) {
  py::dict counts;
  counts["triangles"] = found.triangles;
  counts["repeated_triangles"] = found.repeated_triangles;
  counts["without_area"] = found.without_area;
  counts["slivers"] = found.slivers;
  counts["repeated_points"] = found.repeated_points;
  counts["flat_edges"] = found.flat_edges;
  counts["convex_edges"] = found.convex_edges;
  counts["concave_edges"] = found.concave_edges;
  counts["open_edges"] = found.open_edges;
  counts["irregular_edges"] = found.irregular_edges;
  counts["t_junctions"] = found.t_junctions;
  return counts;
}

py::dict arguments(const Mesh<double>& mesh) {
  py::dict a;
  a["vertices"] = array_of_points(mesh.points());
  a["faces"] = array_of_triangles(mesh.triangles());
  if (mesh.sides() == Sides::front) a["front_only"] = true;
  if (mesh.solid()) a["solid"] = true;
  return a;
}
py::array_t<double> array_of_heights(const HeightField<double>& field) {
  py::array_t<double> heights({static_cast<py::ssize_t>(field.rows()), static_cast<py::ssize_t>(field.columns())});
  std::copy(field.heights().begin(), field.heights().end(), heights.mutable_data());
  return heights;
}
py::dict arguments(const HeightField<double>& field) {
  py::dict a;
  a["heights"] = array_of_heights(field);
  a["spacing_x"] = field.spacing_x();
  a["spacing_z"] = field.spacing_z();
  if (field.sides() == Sides::front) a["front_only"] = true;
  return a;
}
py::dict arguments(const Compound<double>& compound) {
  py::list children;
  for (const auto& child : compound.children()) children.append(py::make_tuple(object_of(child.shape), child.pose));
  py::dict a;
  a["children"] = children;
  return a;
}

/// An argument in the text of `repr`: of an array only its shape.
std::string text_of_argument(py::handle value) {
  if (py::isinstance<py::array>(value)) return "<array of shape " + std::string(py::str(value.attr("shape"))) + ">";
  return py::str(py::repr(value));
}

template <class C>
py::dict all_arguments(const Of<C>& shape) {
  py::dict a = arguments(shape.concrete());
  if (shape.rounding() != 0) a["rounding"] = shape.rounding();
  return a;
}

/// A class of one kind of shape, which still lacks its constructor.
template <class C>
py::class_<Of<C>, Shaped> shape_class(py::module_& m, const char* name, const char* doc, const auto&... more) {
  py::class_<Of<C>, Shaped> type(m, name, doc, more...);
  type.def("__repr__",
           [name](const Of<C>& shape) {
             std::string text = std::string("graze.") + name + "(";
             const char* comma = "";
             for (const auto& [key, value] : all_arguments(shape)) {
               text += comma + std::string(py::str(key)) + "=" + text_of_argument(value);
               comma = ", ";
             }
             return text + ")";
           })
      .def("__reduce__", [m, name](const Of<C>& shape) {
        const py::object make = py::module_::import("graze").attr("_make_shape");
        const py::dict given = all_arguments(shape);
        if (std::is_same_v<C, UserConvex<double>> && !given.contains("support"))
          throw py::type_error("UserConvex: expected a support function in Python; a swept shape is not pickled");
        return py::make_tuple(make, py::make_tuple(name, given));
      });
  return type;
}

template <class C>
py::class_<Of<C>, Shaped> tapered_class(py::module_& m, const char* name, const char* doc) {
  auto type = shape_class<C>(m, name, doc);
  type.def(py::init([](double height, double radius, std::optional<double> radius_top, double rounding) {
             return renamed(tapered_names,
                            [&] { return Of<C>(C(height, radius, radius_top.value_or(radius)), rounding); });
           }),
           py::arg("height"), py::arg("radius"), py::arg("radius_top") = py::none(), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "height", [](const Of<C>& s) { return 2 * s.concrete().half_height(); },
          "Between the centres of a capsule's balls, full of a cylinder; a length.")
      .def_property_readonly(
          "radius", [](const Of<C>& s) { return s.concrete().radius_bottom(); }, "Of the lower end, a length.")
      .def_property_readonly(
          "radius_top", [](const Of<C>& s) { return s.concrete().radius_top(); }, "Of the upper end, a length.");
  return type;
}

void add_round(py::module_& m) {
  shape_class<Sphere<double>>(m, "Sphere", "A ball of `radius` >= 0 about `center` in its own frame.")
      .def(py::init([](double radius, const Vector& center) {
             return Of<Sphere<double>>(Sphere<double>(radius, center.value));
           }),
           py::arg("radius"), py::arg("center") = Vector{})
      .def_property_readonly(
          "radius", [](const Of<Sphere<double>>& s) { return s.concrete().radius(); }, "A length.")
      .def_property_readonly(
          "center", [](const Of<Sphere<double>>& s) { return array_of(s.concrete().center()); },
          "In the shape's frame.");
  tapered_class<Capsule<double>>(m, "Capsule", R"(Two balls and all between them, about the origin along Y.

height: between the centres of the balls. radius: of the lower, and of the upper one too
unless `radius_top` is given. All >= 0.)");
  tapered_class<Cylinder<double>>(m, "Cylinder", R"(A cylinder, cone or truncated cone about the origin along Y.

height: full. radius: of the lower cap, and of the upper one too unless `radius_top` is
given (0 makes a cone). rounding: the radius of a ball that is added. All >= 0.)");
  shape_class<Ellipsoid<double>>(m, "Ellipsoid", "An ellipsoid about the origin; `radii` along the axes, each >= 0.")
      .def(py::init([](const Vector& radii, double rounding) {
             return Of<Ellipsoid<double>>(Ellipsoid<double>(radii.value), rounding);
           }),
           py::arg("radii"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "radii", [](const Of<Ellipsoid<double>>& e) { return array_of(e.concrete().radii()); },
          "The half axes, lengths.");
}

/// Defines the corners of a shape that is made of them, by these names.
template <class C>
void add_corners(py::class_<Of<C>, Shaped>& type, std::initializer_list<const char*> names) {
  int place = 0;
  for (const char* name : names) {
    type.def_property_readonly(
        name, [place](const Of<C>& shape) { return array_of(shape.concrete().point(place)); },
        "A corner, in the shape's frame.");
    ++place;
  }
}

void add_flat(py::module_& m) {
  shape_class<Box<double>>(m, "Box", R"(A solid box about the origin, its edges along the axes.

size: the full edge lengths, each >= 0. rounding: the radius of a ball that is added (the
Minkowski sum), >= 0. Raises ValueError.

>>> import graze
>>> graze.Box((2, 2, 1), rounding=0.1)
graze.Box(size=(2.0, 2.0, 1.0), rounding=0.1)
)")
      .def(py::init(
               [](const Vector& size, double rounding) { return Of<Box<double>>(Box<double>(size.value), rounding); }),
           py::arg("size"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "size", [](const Of<Box<double>>& b) { return array_of(b.concrete().half_extents() * 2.0); },
          "The full edge lengths.");
  shape_class<Rectangle<double>>(m, "Rectangle",
                                 "A rectangle about the origin in the plane y = 0; full edge lengths >= 0.")
      .def(py::init([](double x, double z, double rounding) {
             return renamed({{"sizeX", "size_x"}, {"sizeZ", "size_z"}},
                            [&] { return Of<Rectangle<double>>(Rectangle<double>(x, z), rounding); });
           }),
           py::arg("size_x"), py::arg("size_z"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "size_x", [](const Of<Rectangle<double>>& r) { return 2 * r.concrete().as_box().half_extents().x; },
          "The full edge length along x.")
      .def_property_readonly(
          "size_z", [](const Of<Rectangle<double>>& r) { return 2 * r.concrete().as_box().half_extents().z; },
          "The full edge length along z.");
  auto triangle = shape_class<Triangle<double>>(m, "Triangle",
                                                "A triangle; seen from its front the corners run counter-clockwise.");
  triangle.def(py::init([](const Vector& a, const Vector& b, const Vector& c, double rounding) {
                 return renamed(corner_names, [&] {
                   return Of<Triangle<double>>(Triangle<double>(a.value, b.value, c.value), rounding);
                 });
               }),
               py::arg("a"), py::arg("b"), py::arg("c"), py::arg("rounding") = 0.0);
  add_corners<Triangle<double>>(triangle, {"a", "b", "c"});
  auto segment = shape_class<LineSegment<double>>(m, "Segment",
                                                  "The straight piece between two points; with a rounding a capsule.");
  segment.def(py::init([](const Vector& a, const Vector& b, double rounding) {
                return renamed(corner_names, [&] {
                  return Of<LineSegment<double>>(LineSegment<double>(a.value, b.value), rounding);
                });
              }),
              py::arg("a"), py::arg("b"), py::arg("rounding") = 0.0);
  add_corners<LineSegment<double>>(segment, {"a", "b"});
  shape_class<HalfSpace<double>>(m, "HalfSpace",
                                 "All points with y <= 0 in its own frame; a rounding moves its surface up.")
      .def(py::init([](double rounding) { return Of<HalfSpace<double>>(HalfSpace<double>(), rounding); }),
           py::arg("rounding") = 0.0);
}

void add_convex(py::module_& m) {
  shape_class<ConvexHull<double>>(m, "ConvexHull", "The hull of at least one point: `points` of shape (n, 3).")
      .def(py::init([](const py::object& points, double rounding) {
             const std::vector<Vec3d> given = points_of(rows(points, 3, "points"));
             return Of<ConvexHull<double>>(ConvexHull<double>(given), rounding);
           }),
           py::arg("points"), py::arg("rounding") = 0.0)
      .def_property_readonly(
          "vertices", [](const Of<ConvexHull<double>>& h) { return array_of_points(h.concrete().data().vertices); },
          "Of the hull, in the shape's frame: shape (n, 3).");
  shape_class<UserConvex<double>>(m, "UserConvex", R"(Your own convex shape: one support function.

support: takes a direction (an array of three numbers, not zero) and returns the point of the
set that lies furthest along it. Called from any query, so it has to be a function of its
argument alone. What it raises, and a TypeError for what is no point, is raised by the call that
asked it, when that returns; its answer is lost. A method of what holds the shape keeps both alive
as long as something else, a world for instance, has the shape too.)",
                                  collected<Of<UserConvex<double>>>())
      .def(py::init([](py::function support, double rounding) {
             return Of<UserConvex<double>>(
                 UserConvex<double>(std::make_shared<PythonSupport<SpaceSupport>>(std::move(support))), rounding);
           }),
           py::arg("support"), py::arg("rounding") = 0.0);
}

void add_composites(py::module_& m) {
  shape_class<Mesh<double>>(m, "Mesh", R"(Triangles that share vertices.

vertices: shape (n, 3). faces: shape (m, 3) of indices, counter-clockwise seen from outside, as
trimesh has them. solid: the inside counts as well; the mesh has to be closed. front_only:
contacts push out of the front alone. Raises ValueError that names the index or coordinate.)")
      .def(py::init([](const py::object& vertices, const py::object& faces, bool solid, bool front_only) {
             const IndexRows indices = index_rows(faces, 3, "faces");
             std::vector<Mesh<double>::Index> triangles(static_cast<std::size_t>(indices.shape(0)));
             for (std::size_t i = 0; i < triangles.size(); ++i)
               std::copy_n(indices.data() + 3 * i, 3, triangles[i].begin());
             const auto sides = front_only ? Sides::front : Sides::both;
             return renamed({{"points", "vertices"}, {"triangles", "faces"}}, [&] {
               return Of<Mesh<double>>(
                   Mesh<double>(points_of(rows(vertices, 3, "vertices")), std::move(triangles), sides, solid));
             });
           }),
           py::arg("vertices"), py::arg("faces"), py::arg("solid") = false, py::arg("front_only") = false)
      .def_property_readonly(
          "vertices", [](const Of<Mesh<double>>& m) { return array_of_points(m.concrete().points()); },
          "In the shape's frame, shape (n, 3).")
      .def_property_readonly(
          "faces", [](const Of<Mesh<double>>& m) { return array_of_triangles(m.concrete().triangles()); },
          "Indices of the vertices, shape (m, 3).")
      .def_property_readonly(
          "closed", [](const Of<Mesh<double>>& m) { return m.concrete().closed(); },
          "Whether each edge belongs to two triangles that run through it in opposite directions.")
      .def_property_readonly(
          "solid", [](const Of<Mesh<double>>& m) { return m.concrete().solid(); }, "Whether the inside counts as well.")
      .def_property_readonly(
          "front_only", [](const Of<Mesh<double>>& m) { return m.concrete().sides() == Sides::front; },
          "Whether contacts push out of the front alone.")
      .def(
          "findings", [](const Of<Mesh<double>>& m) { return counts_of(findings(m.concrete())); },
          R"(What the mesh is like: counts of its triangles and edges by name, as a dictionary.

open_edges are rims, and seams that do not meet; t_junctions corners that lie inside another's open
edge; slivers triangles lower than 1/1000 of their longest side. None of it is an error.)");
  shape_class<HeightField<double>>(m, "HeightField",
                                   R"(Heights over a grid in the plane of x and z, centred on the origin.

heights: shape (rows, columns); heights[r, c] stands at x = (c - (columns - 1) / 2) spacing_x and
z = (r - (rows - 1) / 2) spacing_z; NaN is a hole.)")
      .def(py::init([](const py::object& given, double spacing_x, double spacing_z, bool front_only) {
             const py::array any =
                 py::isinstance<py::array>(given) ? py::reinterpret_borrow<py::array>(given) : py::array::ensure(given);
             if (!any || any.ndim() != 2)
               validate::fail("heights", "an array of two dimensions", any ? static_cast<double>(any.ndim()) : 0);
             const Rows heights = rows(any, any.shape(1), "heights");
             return renamed({{"spacing[0]", "spacing_x"}, {"spacing[1]", "spacing_z"}}, [&] {
               return Of<HeightField<double>>(HeightField<double>(
                   static_cast<std::size_t>(heights.shape(1)), static_cast<std::size_t>(heights.shape(0)),
                   std::vector<double>(heights.data(), heights.data() + heights.size()), spacing_x, spacing_z,
                   front_only ? Sides::front : Sides::both));
             });
           }),
           py::arg("heights"), py::arg("spacing_x") = 1.0, py::arg("spacing_z") = 1.0, py::arg("front_only") = false)
      .def_property_readonly(
          "heights", [](const Of<HeightField<double>>& f) { return array_of_heights(f.concrete()); },
          "A copy of the heights, shape (rows, columns); NaN is a hole.")
      .def_property_readonly(
          "spacing_x", [](const Of<HeightField<double>>& f) { return f.concrete().spacing_x(); },
          "Between columns, a length.")
      .def_property_readonly(
          "spacing_z", [](const Of<HeightField<double>>& f) { return f.concrete().spacing_z(); },
          "Between rows, a length.")
      .def_property_readonly(
          "front_only", [](const Of<HeightField<double>>& f) { return f.concrete().sides() == Sides::front; },
          "Whether contacts push out of the front alone.");
  shape_class<Compound<double>>(m, "Compound", "Several shapes as one: `children`, pairs (shape, pose), at least one.")
      .def(py::init([](const std::vector<std::pair<std::reference_wrapper<const Shaped>, Placement>>& children) {
             std::vector<Placed<double>> placed;
             for (const auto& [shape, pose] : children) placed.push_back({shape.get(), pose.value});
             return Of<Compound<double>>(Compound<double>(std::move(placed)));
           }),
           py::arg("children"))
      .def_property_readonly(
          "children",
          [](const Of<Compound<double>>& c) { return arguments(c.concrete())["children"].cast<py::list>(); },
          "The pairs (shape, pose) it was made of.");
}

/// `count` shapes of a kind. Throws `InvalidValue` that names the place of a refused one below `path`.
template <class Make>
ShapeArray shapes_of(std::size_t count, const std::string& path, const Make& make) {
  std::vector<decltype(make(count))> shapes;
  shapes.reserve(count);
  for (std::size_t i = 0; i < count; ++i) try {
      shapes.emplace_back(make(i));
    } catch (const InvalidValue& error) {
      throw error.below(path + "[" + std::to_string(i) + "]");
    }
  return ShapeArray(std::move(shapes));
}

}  // namespace

py::object object_of(const Shaped& shape) {
  return shape.visit([&]<class C>(const C&) { return py::cast(Of<C>(shape)); });
}

void add_shapes(py::module_& m) {
  py::class_<Shaped>(m, "Shape", "Any shape: immutable, and cheap to copy, since big ones share their data.")
      .def_property_readonly("rounding", &Shaped::rounding, "The radius of the ball that is added to it.")
      .def_property_readonly(
          "convex", &Shaped::convex,
          "Whether the shape is convex, as a half-space is; meshes, height fields and compounds are not.")
      .def(
          "bounds",
          [](const Shaped& shape, const Placement& pose) {
            const Aabb<double> box = bounds(shape, pose.value);
            return py::make_tuple(array_of(box.lower), array_of(box.upper));
          },
          py::arg("pose") = py::none(),
          "The lower and upper corner of a box about the shape; not less than the true one.")
      .def(
          "support",
          [](const Shaped& shape, const Vector& direction) {
            return array_of(support(bounded_convex(shape), validate::point(direction.value, "direction")));
          },
          py::arg("direction"), "The point of a bounded convex shape furthest along a direction in its frame.")
      .def(
          "swept",
          [](const Shaped& shape, const Placement& pose, const Vector& motion) {
            return ShapeObject{object_of(swept(shape, pose.value, motion.value))};
          },
          py::arg("pose"), py::arg("motion"),
          R"(The volume that a bounded convex shape, standing at `pose`, sweeps while it moves by `motion`.

Without turning; the result stands at the same pose. Raises ValueError.

>>> import graze
>>> path = graze.Sphere(0.5).swept((3, 0, 0), (2, 0, 0))
>>> graze.distance(path, (3, 0, 0), graze.Sphere(0.5), (4, 2, 0)).distance
1.0
)")
      .def(
          "mass_properties",
          [](const Shaped& shape) {
            const MassProperties<double> mass = mass_properties(shape);
            py::array_t<double> inertia({3, 3});
            for (std::size_t i = 0; i < 3; ++i)
              for (std::size_t j = 0; j < 3; ++j) inertia.mutable_data()[3 * i + j] = mass.inertia.row[i][j];
            return py::make_tuple(mass.volume, array_of(mass.center), inertia);
          },
          "(volume, centre of mass, inertia about it) of density one; volume 0 for what is no solid.");
  add_round(m);
  add_flat(m);
  add_convex(m);
  add_composites(m);

  py::class_<ShapeArray>(m, "ShapeArray", "Shapes for a batch: converted once, used many times.")
      .def(py::init([](const std::vector<std::reference_wrapper<const Shaped>>& shapes) {
             return ShapeArray(std::vector<Shaped>(shapes.begin(), shapes.end()));
           }),
           py::arg("shapes"))
      .def_static(
          "boxes",
          [](const py::object& sizes) {
            const std::vector<Vec3d> given = points_of(rows(sizes, 3, "sizes"));
            return shapes_of(given.size(), "sizes", [&](std::size_t i) { return Box<double>(given[i]); });
          },
          py::arg("sizes"), "Boxes of the full edge lengths of each row.")
      .def_static(
          "spheres",
          [](const py::object& radii) {
            const py::object any = py::isinstance<py::array>(radii) ? radii : py::array::ensure(radii);
            if (!any) throw py::type_error("radii: expected an array of numbers");
            const Rows given = rows(any.attr("reshape")(-1, 1), 1, "radii");
            const auto count = static_cast<std::size_t>(given.size());
            return shapes_of(count, "radii", [&](std::size_t i) { return Sphere<double>(given.data()[i]); });
          },
          py::arg("radii"))
      .def("__len__", [](const ShapeArray& a) { return a.size(); })
      .def("__repr__",
           [](const ShapeArray& a) { return "<graze.ShapeArray of " + std::to_string(a.size()) + " shapes>"; })
      .def("__reduce__",
           [](const py::object& self) { return py::make_tuple(py::type::of(self), py::make_tuple(py::list(self))); })
      .def("__getitem__",
           [](const ShapeArray& a, py::ssize_t i) {
             const auto count = static_cast<py::ssize_t>(a.size());
             if (i < -count || i >= count)
               throw py::index_error("index " + std::to_string(i) + " of " + std::to_string(count) + " shapes");
             return ShapeObject{object_of(a[static_cast<std::size_t>(i < 0 ? i + count : i)])};
           })
      .def("__getitem__", [](const ShapeArray& a, const py::slice& part) {
        py::ssize_t first = 0, end = 0, step = 0, count = 0;
        if (!part.compute(static_cast<py::ssize_t>(a.size()), &first, &end, &step, &count))
          throw py::error_already_set();
        std::vector<Shaped> found;
        for (py::ssize_t i = 0; i < count; ++i) found.push_back(a[static_cast<std::size_t>(first + i * step)]);
        return ShapeArray(std::move(found));
      });
}

}  // namespace graze::python
