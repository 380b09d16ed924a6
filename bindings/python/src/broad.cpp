// Broad phases and changes of their pairs by themselves, and the vertices that a convex hull's support query looks at.
#include "broad_phase_kinds.hpp"
#include "graze/pair_changes.hpp"
#include "graze/shape/support_trace.hpp"
#include "shapes.hpp"
#include "whole.hpp"

namespace graze::python {

namespace {

using Broad = BroadPhase<double>;
using Changes = PairChanges<double>;

std::unique_ptr<Broad> broad_phase_of(const std::string& kind) {
  for (const BroadPhaseKind<double>& known : broad_phase_kinds<double>)
    if (kind == known.name) return known.make();
  validate::fail("kind", "dynamic_tree, sort_and_sweep, sweep_and_prune, hashed_grid, loose_octree or bsp", kind);
}

/// A box for a query, whose corners are the right way round; numbers may be infinite.
Aabb<double> box_of(const Vector& lower, const Vector& upper) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(lower.value[i] <= upper.value[i]))
      validate::fail("box", "lower <= upper on every axis",
                     validate::number(lower.value[i]) + " and " + validate::number(upper.value[i]));
  return {lower.value, upper.value};
}

py::array_t<std::uint32_t> array_of_pairs(const std::vector<IdPair>& pairs) {
  py::array_t<std::uint32_t> out({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::uint32_t* to = out.mutable_data();
  for (const IdPair& pair : pairs) {
    *to++ = pair.a;
    *to++ = pair.b;
  }
  return out;
}

template <class Number>
py::array_t<Number> array_of_numbers(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

const ConvexHull<double>& hull_of(const Shaped& shape) {
  const auto* hull = shape.as<ConvexHull<double>>();
  if (hull == nullptr) validate::fail("shape", "a convex hull", shape.name());
  return *hull;
}

py::array_t<double> vertices_of(const Shaped& shape) {
  const auto& vertices = hull_of(shape).data().vertices;
  py::array_t<double> out({static_cast<py::ssize_t>(vertices.size()), py::ssize_t{3}});
  double* to = out.mutable_data();
  for (const Vec3d& v : vertices)
    for (std::size_t i = 0; i < 3; ++i) *to++ = v[i];
  return out;
}

py::list layers_of(const Shaped& shape) {
  py::list out;
  for (const HullLayer& layer : hull_layers(hull_of(shape))) {
    py::array_t<std::uint32_t> edges({static_cast<py::ssize_t>(layer.edges.size()), py::ssize_t{2}});
    std::uint32_t* to = edges.mutable_data();
    for (const auto& edge : layer.edges) to = std::copy(edge.begin(), edge.end(), to);
    out.append(py::make_tuple(array_of_numbers(layer.vertices), edges));
  }
  return out;
}

py::dict steps_of(const Shaped& shape, const Vector& direction) {
  const SupportTrace trace = explain_support(hull_of(shape), validate::point(direction.value, "direction"));
  py::list layers;
  for (const SupportLayer& layer : trace.layers) {
    py::dict told;
    told["vertices"] = layer.vertices;
    told["looked_at"] = array_of_numbers(layer.looked_at);
    told["along"] = array_of_numbers(layer.along);
    told["winner"] = layer.winner;
    layers.append(told);
  }
  py::dict out;
  out["vertex"] = trace.vertex;
  out["scanned"] = trace.scanned;
  out["products"] = trace.products;
  out["layers"] = layers;
  return out;
}

std::uint32_t id_of(const Whole& id) { return id.as<std::uint32_t>("id"); }

/// The methods that change boxes.
template <class Boxes>
void add_boxes(py::class_<Boxes>& boxes) {
  boxes
      .def(
          "insert",
          [](Boxes& b, const Whole& id, const Vector& l, const Vector& u) { b.insert(id_of(id), box_of(l, u)); },
          py::arg("id"), py::arg("lower"), py::arg("upper"), "Adds a box; its sides may be infinite.")
      .def(
          "move", [](Boxes& b, const Whole& id, const Vector& l, const Vector& u) { b.move(id_of(id), box_of(l, u)); },
          py::arg("id"), py::arg("lower"), py::arg("upper"), "Replaces a box.")
      .def(
          "remove", [](Boxes& b, const Whole& id) { b.remove(id_of(id)); }, py::arg("id"), "Removes a box.");
}

void add_broad_phase(py::module_& m) {
  py::class_<Broad> broad(m, "BroadPhase",
                          R"(Which of many boxes overlap: boxes under whole numbers of your own, no shapes.

kind: dynamic_tree, sort_and_sweep, sweep_and_prune, hashed_grid, loose_octree or bsp; all find the
same, sorted. Raises ValueError for another kind, an id that is in use or unknown, and a box whose
corners are the wrong way round.

>>> import graze
>>> broad = graze.BroadPhase()
>>> for i in range(3):
...     broad.insert(i, (0.8 * i, 0, 0), (0.8 * i + 1, 1, 1))
>>> broad.pairs().tolist(), broad.query((0.9, 0, 0), (1.5, 1, 1)).tolist()
([[0, 1], [1, 2]], [0, 1])
)");
  add_boxes(broad);
  broad.def(py::init(&broad_phase_of), py::arg("kind") = "dynamic_tree")
      .def("__repr__",
           [](const Broad& b) {
             return "graze.BroadPhase(tests=" + std::to_string(b.tests()) + ", memory=" + std::to_string(b.memory()) +
                    ")";
           })
      .def(
          "pairs",
          [](Broad& b) {
            std::vector<IdPair> found;
            b.pairs(found);
            return array_of_pairs(found);
          },
          "All overlapping pairs, the smaller id first: shape (n, 2).")
      .def(
          "moved_pairs",
          [](Broad& b) {
            std::vector<IdPair> found;
            b.moved_pairs(found);
            return array_of_pairs(found);
          },
          "Those of which one was inserted or moved since pairs were last asked for: shape (n, 2).")
      .def(
          "query",
          [](const Broad& b, const Vector& lower, const Vector& upper) {
            std::vector<std::uint32_t> found;
            b.query(box_of(lower, upper), found);
            return array_of_numbers(found);
          },
          py::arg("lower"), py::arg("upper"), "The ids of all boxes that overlap this one: shape (n,).")
      .def(
          "sweep",
          [](const Broad& b, const Vector& lower, const Vector& upper, const Vector& motion) {
            std::vector<std::uint32_t> found;
            b.sweep(box_of(lower, upper), validate::point(motion.value, "motion"), found);
            return array_of_numbers(found);
          },
          py::arg("lower"), py::arg("upper"), py::arg("motion"),
          "The ids of all boxes that this one touches while it moves by `motion`: shape (n,).")
      .def(
          "parts",
          [](const Broad& b) {
            std::vector<BroadPhasePart<double>> found;
            b.parts(found);
            py::list out;
            for (const auto& part : found)
              out.append(py::make_tuple(array_of(part.box.lower), array_of(part.box.upper), part.depth));
            return out;
          },
          "The structure as it is now, for drawing: (lower, upper, depth) of each node or cell, parents first.")
      .def_property_readonly("tests", &Broad::tests, "How many boxes the last search for pairs compared.")
      .def_property_readonly("memory", &Broad::memory, "Bytes that the structure holds.");
}

void add_pair_changes(py::module_& m) {
  py::class_<Changes> changes(m, "PairChanges",
                              R"(Changes of overlapping pairs from call to call, for data that is kept for each pair.

kind: that of the BroadPhase behind it, which boxes are put into as into one by itself.

>>> import graze
>>> changes = graze.PairChanges()
>>> for i in range(3):
...     changes.insert(i, (0.8 * i, 0, 0), (0.8 * i + 1, 1, 1))
>>> begun, ended = changes.find()
>>> begun.tolist(), ended.tolist()
([[0, 1], [1, 2]], [])
>>> changes.remove(0)
>>> [pairs.tolist() for pairs in changes.find()]
[[], [[0, 1]]]
)");
  add_boxes(changes);
  changes
      .def(py::init([](const std::string& kind) { return std::make_unique<Changes>(broad_phase_of(kind)); }),
           py::arg("kind") = "dynamic_tree")
      .def(
          "find",
          [](Changes& c) {
            std::vector<IdPair> begun, ended;
            c.find(begun, ended);
            return py::make_tuple(array_of_pairs(begun), array_of_pairs(ended));
          },
          "(begun, ended) since the last call: pairs that overlap and did not, those that did and do not; shape (n, "
          "2).")
      .def_property_readonly("memory", &Changes::memory, "Bytes that are held.")
      .def("__repr__", [](const Changes& c) { return "graze.PairChanges(memory=" + std::to_string(c.memory()) + ")"; });
}

}  // namespace

void add_broad(py::module_& m) {
  add_broad_phase(m);
  add_pair_changes(m);
  m.def("hull_vertices", &vertices_of, py::arg("hull"), "The corners of a ConvexHull: shape (n, 3).");
  m.def("hull_layers", &layers_of, py::arg("hull"),
        R"(The layers of a ConvexHull's hierarchy, the coarsest first: (vertices, edges) by numbers of its vertices.)");
  m.def("explain_support", &steps_of, py::arg("hull"), py::arg("direction"),
        R"(What the support query of a ConvexHull looked at, layer by layer: a dictionary.)");
}

}  // namespace graze::python
