// Queries of many pairs of the plane at once. Poses are read where they stand and answers are not copied; the
// interpreter's lock is released while they are found.
#include "plane_batch.hpp"
#include "row_batches.hpp"

namespace graze::python {

namespace {

using Contacts = plane::BatchContacts<double>;

py::dtype plane_distance_type() {
  using D = plane::Distance<double>;
  return record_type({{"distance", "f8", offsetof(D, distance)},
                      {"normal", "(2,)f8", offsetof(D, normal)},
                      {"a", "(2,)f8", offsetof(D, a)},
                      {"b", "(2,)f8", offsetof(D, b)},
                      {"status", "u1", offsetof(D, status)},
                      {"error", "f8", offsetof(D, error)}},
                     sizeof(D));
}
py::dtype pair_type() {
  using P = Contacts::Pair;
  return record_type({{"overlap", "?", offsetof(P, overlap)},
                      {"first_manifold", "u4", offsetof(P, first_manifold)},
                      {"manifold_count", "u4", offsetof(P, manifold_count)}},
                     sizeof(P));
}
py::dtype group_type() {
  using G = Contacts::Group;
  return record_type({{"normal", "(2,)f8", offsetof(G, normal)},
                      {"piece_a", "u4", offsetof(G, piece_a)},
                      {"piece_b", "u4", offsetof(G, piece_b)},
                      {"first_point", "u4", offsetof(G, first_point)},
                      {"point_count", "u4", offsetof(G, point_count)}},
                     sizeof(G));
}
py::dtype plane_point_type() {
  using P = plane::ContactPoint<double>;
  return record_type({{"a", "(2,)f8", offsetof(P, a)},
                      {"b", "(2,)f8", offsetof(P, b)},
                      {"distance", "f8", offsetof(P, distance)},
                      {"feature", "u4", offsetof(P, feature)},
                      {"weight", "f8", offsetof(P, weight)}},
                     sizeof(P));
}

const std::string batch_doc = R"(

a, b: a Shape or a sequence of shapes. poses_a, poses_b: an array of shape (n, 4) of rows
(x, y, cosine, sine), which is read where it stands; a sequence of poses; or one pose.
pairs: shape (m, 2), places in a and b; by default the first with the first and so on, or
the single one of a side with all of the other. threads: how many answer, or a graze.Threads; answers
are the same. The interpreter's lock is released. Raises ValueError
that names the row for poses that are not finite or no rotations, for places that there are not, for
numbers of bodies that do not fit, and for a margin or a duration that is negative.)";

}  // namespace

void add_plane_batches(py::module_& m) {
  py::module_ batch = m.def_submodule("batch", "Many pairs at once; each with the answer it has alone.");
  batch.attr("__name__") = "graze.plane.batch";
  const auto define = [&](const char* name, const auto& ask, const std::string& doc) {
    batch.def(name, ask, py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"),
              py::arg("pairs") = py::none(), py::arg("threads") = py::none(), (doc + batch_doc).c_str());
  };
  using Object = const py::object&;
  define(
      "overlap",
      [](Object a, Object poses_a, Object b, Object poses_b, Object pairs, const ThreadsArgument& threads) {
        const Question<PlaneBatch> question(a, poses_a, b, poses_b, pairs, threads);
        return records(
            question.found_rows<std::uint8_t>([](const auto& asked, auto& answers) { overlap(asked, answers); }),
            py::dtype("?"));
      },
      "Whether each pair touches: an array of bool.");
  define(
      "distance",
      [type = plane_distance_type()](Object a, Object poses_a, Object b, Object poses_b, Object pairs,
                                     const ThreadsArgument& threads) {
        const Question<PlaneBatch> question(a, poses_a, b, poses_b, pairs, threads);
        return records(question.found_rows<plane::Distance<double>>(
                           [](const auto& asked, auto& answers) { distance(asked, answers); }),
                       type);
      },
      "The signed distance of each pair: records with the fields distance, normal, a, b, status, error.");
  batch.def(
      "contacts",
      [pairs_type = pair_type(), groups_type = group_type(), points_type = plane_point_type()](
          Object a, Object poses_a, Object b, Object poses_b, double margin, Object pairs,
          const std::optional<Whole>& most, const ThreadsArgument& threads) {
        const Question<PlaneBatch> question(a, poses_a, b, poses_b, pairs, threads);
        Contacts found = found_contacts<Contacts>(question, margin, most);
        return py::make_tuple(records(std::move(found.pairs), pairs_type),
                              records(std::move(found.manifolds), groups_type),
                              records(std::move(found.points), points_type));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin") = 0.0,
      py::arg("pairs") = py::none(), py::arg("most") = py::none(), py::arg("threads") = py::none(),
      ("Where each pair touches: (pairs, manifolds, points), three arrays of records. A pair's manifolds, which "
       "stand anywhere among those of others, are "
       "`manifold_count` from `first_manifold` on, and likewise a manifold's points. most: at most so many "
       "points a pair, those that span most." +
       batch_doc)
          .c_str());
  add_near_pieces<PlaneBatch>(batch, batch_doc);
  add_row_batches<PlaneBatch>(batch, batch_doc);
}

}  // namespace graze::python
