// Queries of many pairs at once. Poses are read where they stand and answers are not copied; the interpreter's lock is
// released while they are found.
#include "row_batches.hpp"
#include "space_batch.hpp"

namespace graze::python {

namespace {

using Contacts = BatchContacts<double>;
using Compact = CompactContacts<double>;

py::dtype pair_type() {
  using P = Contacts::Pair;
  return record_type({{"overlap", "?", offsetof(P, overlap)},
                      {"first_manifold", "u4", offsetof(P, first_manifold)},
                      {"manifold_count", "u4", offsetof(P, manifold_count)}},
                     sizeof(P));
}
py::dtype group_type() {
  using G = Contacts::Group;
  return record_type({{"normal", "(3,)f8", offsetof(G, normal)},
                      {"piece_a", "u4", offsetof(G, piece_a)},
                      {"piece_b", "u4", offsetof(G, piece_b)},
                      {"first_point", "u4", offsetof(G, first_point)},
                      {"point_count", "u4", offsetof(G, point_count)}},
                     sizeof(G));
}

py::dtype compact_group_type() {
  using G = Compact::Group;
  return record_type({{"normal", "(3,)f8", offsetof(G, normal)},
                      {"pair", "u4", offsetof(G, pair)},
                      {"first_point", "u4", offsetof(G, first_point)},
                      {"point_count", "u4", offsetof(G, point_count)}},
                     sizeof(G));
}
py::dtype compact_point_type() {
  using P = Compact::Point;
  return record_type({{"position", "(3,)f8", offsetof(P, position)}, {"distance", "f8", offsetof(P, distance)}},
                     sizeof(P));
}

constexpr const char* batch_doc = R"(

a, b: a Shape, a sequence of shapes or a ShapeArray (which need not be converted each time).
poses_a, poses_b: an array of shape (n, 7) of translations and unit quaternions (x, y, z, w),
which is read where it stands; matrices of shape (n, 4, 4); a sequence of poses; or one pose.
pairs: shape (m, 2), places in a and b; by default the first with the first and so on, or
the single one of a side with all of the other. threads: how many answer, or a graze.Threads; answers
are the same. The interpreter's lock is released. Raises ValueError
that names the row for poses that are not finite or no rotations, for places that there are not, for
numbers of bodies that do not fit, and for a margin or a duration that is negative.)";

}  // namespace

void add_batches(py::module_& m) {
  py::module_ batch = m.def_submodule(
      "batch", "Many pairs at once, many at a time on the processor's lanes; each with the answer it has alone.");
  batch.def(
      "overlap",
      [](const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
         const py::object& pairs, const ThreadsArgument& threads) {
        const Question<SpaceBatch> question(a, poses_a, b, poses_b, pairs, threads);
        return records(question.found_rows<std::uint8_t>([](const auto& asked, auto& touch) { overlap(asked, touch); }),
                       py::dtype("?"));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("pairs") = py::none(),
      py::arg("threads") = py::none(),
      (std::string("Whether each pair touches: an array of bool.") + batch_doc).c_str());
  batch.def(
      "distance",
      [type = distance_type()](const py::object& a, const py::object& poses_a, const py::object& b,
                               const py::object& poses_b, const py::object& pairs, const ThreadsArgument& threads) {
        const Question<SpaceBatch> question(a, poses_a, b, poses_b, pairs, threads);
        return records(question.found_rows<Distance<double>>(
                           [](const auto& asked, auto& distances) { distance(asked, distances); }),
                       type);
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("pairs") = py::none(),
      py::arg("threads") = py::none(),
      (std::string("The signed distance of each pair: records with the fields distance, normal, a, b, status, error.") +
       batch_doc)
          .c_str());
  batch.def(
      "contacts",
      [pairs_type = pair_type(), groups_type = group_type(), points_type = point_type()](
          const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b, double margin,
          const py::object& pairs, const std::optional<Whole>& most, const ThreadsArgument& threads) {
        const Question<SpaceBatch> question(a, poses_a, b, poses_b, pairs, threads);
        Contacts found = found_contacts<Contacts>(question, margin, most);
        return py::make_tuple(records(std::move(found.pairs), pairs_type),
                              records(std::move(found.manifolds), groups_type),
                              records(std::move(found.points), points_type));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin") = 0.0,
      py::arg("pairs") = py::none(), py::arg("most") = py::none(), py::arg("threads") = py::none(),
      (std::string(
           "Where each pair touches: (pairs, manifolds, points), three arrays of records. A pair's manifolds, which "
           "stand anywhere among those of others, are "
           "`manifold_count` from `first_manifold` on, and likewise a manifold's points. most: at most so many points "
           "a pair, "
           "those that span most.") +
       batch_doc)
          .c_str());
  batch.def(
      "compact_contacts",
      [groups_type = compact_group_type(), points_type = compact_point_type()](
          const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b, double margin,
          const py::object& pairs, const ThreadsArgument& threads) {
        checked_reach(margin, "margin");
        const Question<SpaceBatch> question(a, poses_a, b, poses_b, pairs, threads);
        Compact found = question.found<Compact>(
            [margin](const auto& asked, auto& answers) { contacts(asked, margin, answers); },
            [](Compact& all, const Compact& part, std::size_t begin) { all.append(part, begin); });
        return py::make_tuple(records(std::move(found.manifolds), groups_type),
                              records(std::move(found.points), points_type));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin") = 0.0,
      py::arg("pairs") = py::none(), py::arg("threads") = py::none(),
      (std::string("Contacts in few bytes, of the pairs that have any: (manifolds, points), records with the fields "
                   "normal, pair, first_point, point_count, and position, distance. Those of a pair are together; "
                   "pairs may come in another order than they were given in, and with threads in yet another.") +
       batch_doc)
          .c_str());
  add_near_pieces<SpaceBatch>(batch, batch_doc);
  add_row_batches<SpaceBatch>(batch, batch_doc);
}

}  // namespace graze::python
