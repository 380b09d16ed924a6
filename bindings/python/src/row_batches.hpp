// Many rays or points at one shape, and many moving pairs, in space and in the plane, which differ in their `Words`.
// The interpreter's lock is released while they are answered, on threads if these are given.
#pragma once

#include <pybind11/stl.h>

#include "graze/plane/reduce.hpp"
#include "graze/world/reduce.hpp"
#include "sides.hpp"
#include "whole.hpp"

namespace graze::python {

/// A hit as a row of an array; a miss has an infinite t.
template <class Hit>
struct HitRow {
  Hit hit = missed();
  bool there = false;

  HitRow() = default;
  HitRow(const std::optional<Hit>& found) : hit(found.value_or(missed())), there(found.has_value()) {}
  static Hit missed() {
    Hit none;
    none.t = std::numeric_limits<double>::infinity();
    return none;
  }
};

/// Rows of a vector's or a turning's numbers, or the numbers of one for all.
template <class Value, class Read>
std::vector<Value> values_of(const py::object& from, py::ssize_t columns, const std::string& name, const Read& read) {
  double one[3];
  const bool number = columns == 1 && !py::isinstance<py::array>(from) && PyNumber_Check(from.ptr()) != 0;
  if (number ? read_numbers(py::make_tuple(from), one, 1) : read_numbers(from, one, columns)) return {read(one, name)};
  const bool flat = columns == 1 && py::array::ensure(from).ndim() == 1;
  const Rows array = rows(flat ? py::array::ensure(from).reshape({-1, 1}) : from, columns, name.c_str());
  std::vector<Value> all(static_cast<std::size_t>(array.shape(0)));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = read(array.data(static_cast<py::ssize_t>(i), 0), name + "[" + std::to_string(i) + "]");
  return all;
}
template <class Words>
std::vector<typename Words::Vector> vectors_of(const py::object& from, const std::string& name) {
  return values_of<typename Words::Vector>(from, Words::vector_size, name, [](const double* row, const auto& path) {
    const auto v = Words::vector_of(row);
    Words::check(v, path);
    return v;
  });
}
template <class Words>
std::vector<typename Words::Turning> turnings_of(const py::object& from, const std::string& name) {
  return values_of<typename Words::Turning>(from, Words::turning_size, name, [](const double* row, const auto& path) {
    const auto turning = Words::turning_of(row);
    Words::check(turning, path);
    return turning;
  });
}

/// The i-th of all, or the single one.
template <class Value>
const Value& at_or_only(const std::vector<Value>& values, std::size_t i) {
  return values[values.size() == 1 ? 0 : i];
}
template <class Value>
void check_count(const std::vector<Value>& values, std::size_t count, const std::string& name, const char* whose) {
  if (values.size() != count && values.size() != 1)
    validate::fail(name, std::string("as many as ") + whose + ", or one", static_cast<double>(values.size()));
}

template <class Words>
std::vector<typename Words::Ray> rays_of(const py::object& origins, const py::object& directions) {
  const auto from = vectors_of<Words>(origins, "origins"), to = vectors_of<Words>(directions, "directions");
  if (from.size() != 1) check_count(to, from.size(), "directions", "origins");
  std::vector<typename Words::Ray> rays(from.empty() || to.empty() ? 0 : std::max(from.size(), to.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = {at_or_only(from, i), at_or_only(to, i)};
  return rays;
}

/// The velocities of the bodies of a side.
template <class Words>
class Velocities {
 public:
  Velocities(const py::object& linear, const py::object& angular, std::size_t bodies, const std::string& name)
      : linear_(vectors_of<Words>(linear, "linear_" + name)), angular_(turnings_of<Words>(angular, "angular_" + name)) {
    check_count(linear_, bodies, "linear_" + name, "bodies");
    check_count(angular_, bodies, "angular_" + name, "bodies");
  }
  typename Words::Velocity operator[](std::size_t body) const {
    return {at_or_only(linear_, body), at_or_only(angular_, body)};
  }

 private:
  std::vector<typename Words::Vector> linear_;
  std::vector<typename Words::Turning> angular_;
};

/// The contacts of all pairs of a question, of each of which at most `most` points are kept.
template <class Contacts, class Asked>
Contacts found_contacts(const Asked& question, double margin, const std::optional<Whole>& most) {
  checked_reach(margin, "margin");
  std::optional<std::size_t> count;
  if (most) count = most->at_least<std::size_t>(1, "most");
  return question.template found<Contacts>(
      [margin, count](const auto& asked, Contacts& answers) {
        contacts(asked, margin, answers);
        if (count) reduce(answers, *count);
      },
      [](Contacts& all, const Contacts& part, std::size_t) { all.append(part); });
}

template <class Words>
py::dtype ray_row_type() {
  using Row = HitRow<typename Words::RayHit>;
  using H = typename Words::RayHit;
  return record_type({{"t", "f8", offsetof(Row, hit) + offsetof(H, t)},
                      {"point", Words::vector_type, offsetof(Row, hit) + offsetof(H, point)},
                      {"normal", Words::vector_type, offsetof(Row, hit) + offsetof(H, normal)},
                      {"piece", "u4", offsetof(Row, hit) + offsetof(H, piece)},
                      {"hit", "?", offsetof(Row, there)}},
                     sizeof(Row));
}
template <class Words>
py::dtype cast_row_type() {
  using Row = HitRow<typename Words::CastHit>;
  using H = typename Words::CastHit;
  return record_type({{"t", "f8", offsetof(Row, hit) + offsetof(H, t)},
                      {"point", Words::vector_type, offsetof(Row, hit) + offsetof(H, point)},
                      {"normal", Words::vector_type, offsetof(Row, hit) + offsetof(H, normal)},
                      {"depth", "f8", offsetof(Row, hit) + offsetof(H, depth)},
                      {"status", "u1", offsetof(Row, hit) + offsetof(H, status)},
                      {"piece_a", "u4", offsetof(Row, hit) + offsetof(H, piece_a)},
                      {"piece_b", "u4", offsetof(Row, hit) + offsetof(H, piece_b)},
                      {"hit", "?", offsetof(Row, there)}},
                     sizeof(Row));
}
template <class Words>
py::dtype closest_type() {
  using C = typename Words::Closest;
  return record_type({{"distance", "f8", offsetof(C, distance)},
                      {"point", Words::vector_type, offsetof(C, point)},
                      {"normal", Words::vector_type, offsetof(C, normal)},
                      {"status", "u1", offsetof(C, status)},
                      {"error", "f8", offsetof(C, error)}},
                     sizeof(C));
}

template <class Words>
py::dtype piece_type() {
  using P = typename Words::PieceDistance;
  using D = typename Words::Distance;
  constexpr std::size_t distance = offsetof(P, distance);
  return record_type({{"piece_a", "u4", offsetof(P, piece_a)},
                      {"piece_b", "u4", offsetof(P, piece_b)},
                      {"distance", "f8", distance + offsetof(D, distance)},
                      {"normal", Words::vector_type, distance + offsetof(D, normal)},
                      {"a", Words::vector_type, distance + offsetof(D, a)},
                      {"b", Words::vector_type, distance + offsetof(D, b)},
                      {"status", "u1", distance + offsetof(D, status)},
                      {"error", "f8", distance + offsetof(D, error)}},
                     sizeof(P));
}

/// The near pieces of all pairs, and where those of each pair end.
template <class Words>
struct NearPieces {
  std::vector<typename Words::PieceDistance> all;
  std::vector<std::uint64_t> ends;
};

/// `batch.near_pieces`.
template <class Words>
void add_near_pieces(py::module_& batch, const std::string& sides_doc) {
  using Object = const py::object&;
  using Shape = typename Words::Shape;
  using Pieces = NearPieces<Words>;
  batch.def(
      "near_pieces",
      [type = piece_type<Words>()](Object a, Object poses_a, Object b, Object poses_b, double margin, Object pairs,
                                   const ThreadsArgument& threads) {
        const Question<Words> question(a, poses_a, b, poses_b, pairs, threads);
        checked_reach(margin, "margin");
        Pieces found = question.template found<Pieces>(
            [margin](const typename Words::Batch& asked, Pieces& pieces) {
              each_array(pieces, [](auto& array) { array.clear(); });
              for (std::size_t i = 0; i < asked.size(); ++i) {
                const IdPair pair = asked[i];
                asked.a().visit(pair.a, [&](const Shape& p) {
                  asked.b().visit(pair.b, [&](const Shape& q) {
                    near_pieces(p, asked.a().pose(pair.a), q, asked.b().pose(pair.b), margin, pieces.all);
                  });
                });
                pieces.ends.push_back(pieces.all.size());
              }
            },
            [](Pieces& all, const Pieces& part, std::size_t) {
              for (const std::uint64_t end : part.ends) all.ends.push_back(all.all.size() + end);
              behind(all.all, part.all);
            });
        return py::make_tuple(records(std::move(found.all), type), records(std::move(found.ends), py::dtype("u8")));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin"),
      py::arg("pairs") = py::none(), py::arg("threads") = py::none(),
      ("The pairs of convex pieces within `margin` >= 0 of each pair: (pieces, ends), an array of records with the "
       "fields piece_a, piece_b, distance, normal, a, b, status, error, and where those of each pair end in it." +
       sides_doc)
          .c_str());
}

/// `batch.closest`, `batch.raycast`, `batch.raycast_any` and `batch.cast`.
template <class Words>
void add_row_batches(py::module_& batch, const std::string& sides_doc) {
  using Shape = typename Words::Shape;
  using Placement = typename Words::Placement;
  using Object = const py::object&;
  batch.def(
      "closest",
      [type = closest_type<Words>()](const Shape& shape, const Placement& pose, Object points,
                                     const ThreadsArgument& threads) {
        const auto asked = vectors_of<Words>(points, "points");
        const auto on = threads.of_call();
        return records(each_of<typename Words::Closest>(
                           on.get(), asked.size(), [&](std::size_t i) { return closest(shape, pose.value, asked[i]); }),
                       type);
      },
      py::arg("shape"), py::arg("pose"), py::arg("points"), py::arg("threads") = py::none(),
      (std::string("The point of a shape's surface nearest to each of many: records with the fields distance (negative "
                   "inside a solid), point, normal, status, error.\n\npoints: ") +
       Words::vectors + ". threads: how many answer, or a graze.Threads.")
          .c_str());

  const std::string rays_doc =
      std::string("\n\norigins, directions: ") + Words::vectors +
      " for all rays; a direction need not be of unit\nlength. length: what is further along is not met." +
      (Words::back_faces ? " back_faces: whether a triangle is met from behind." : "") +
      "\nthreads: how many answer, or a graze.Threads. Raises ValueError for what is not finite.";
  const auto define_rays = [&](const char* name, const auto& ask, const char* doc) {
    if constexpr (Words::back_faces)
      batch.def(
          name,
          [ask](const Shape& shape, const Placement& pose, Object origins, Object directions, double length, bool back,
                const ThreadsArgument& threads) {
            return ask(threads.of_call(), shape, pose, rays_of<Words>(origins, directions),
                       checked_reach(length, "length"), back ? BackFaces::hit : BackFaces::ignored);
          },
          py::arg("shape"), py::arg("pose"), py::arg("origins"), py::arg("directions"),
          py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
          py::arg("threads") = py::none(), (doc + rays_doc).c_str());
    else
      batch.def(
          name,
          [ask](const Shape& shape, const Placement& pose, Object origins, Object directions, double length,
                const ThreadsArgument& threads) {
            return ask(threads.of_call(), shape, pose, rays_of<Words>(origins, directions),
                       checked_reach(length, "length"));
          },
          py::arg("shape"), py::arg("pose"), py::arg("origins"), py::arg("directions"),
          py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("threads") = py::none(),
          (doc + rays_doc).c_str());
  };
  using Rays = std::vector<typename Words::Ray>;
  using On = std::shared_ptr<Threads>;
  const auto no_parts = [](std::size_t, std::size_t) {};
  define_rays(
      "raycast",
      [type = ray_row_type<Words>(), no_parts](const On& on, const Shape& shape, const Placement& pose,
                                               const Rays& rays, const auto&... how) {
        auto found = spare_of<std::vector<HitRow<typename Words::RayHit>>>();
        found.resize(rays.size());
        cut(on.get(), rays.size(), no_parts, [&](std::size_t begin, std::size_t end, std::size_t) {
          std::vector<std::optional<typename Words::RayHit>> hits(end - begin);
          raycast<double>(shape, pose.value, std::span(rays).subspan(begin, end - begin), hits, how...);
          std::copy(hits.begin(), hits.end(), found.begin() + static_cast<std::ptrdiff_t>(begin));
        });
        return records(std::move(found), type);
      },
      "What each of many rays hits first: records with the fields t (inf where nothing is hit), point, normal, piece, "
      "hit.");
  define_rays(
      "raycast_any",
      [no_parts](const On& on, const Shape& shape, const Placement& pose, const Rays& rays, const auto&... how) {
        auto found = spare_of<std::vector<std::uint8_t>>();
        found.resize(rays.size());
        const std::span<bool> hits(reinterpret_cast<bool*>(found.data()), found.size());
        cut(on.get(), rays.size(), no_parts, [&](std::size_t begin, std::size_t end, std::size_t) {
          const std::size_t count = end - begin;
          raycast_any<double>(shape, pose.value, std::span(rays).subspan(begin, count), hits.subspan(begin, count),
                              how...);
        });
        return records(std::move(found), py::dtype("?"));
      },
      "Whether each of many rays hits anything: an array of bool.");

  const py::object still =
      Words::turning_size == 1 ? py::object(py::float_(0.0)) : py::object(py::make_tuple(0.0, 0.0, 0.0));
  batch.def(
      "cast",
      [type = cast_row_type<Words>()](Object a, Object poses_a, Object linear_a, Object b, Object poses_b,
                                      Object linear_b, double duration, Object angular_a, Object angular_b,
                                      bool ignore_separating, Object pairs, const ThreadsArgument& threads) {
        if (!(checked_reach(duration, "duration") <= largest_magnitude<double>))
          validate::fail("duration", "a finite number >= 0", duration);
        const Question<Words> question(a, poses_a, b, poses_b, pairs, threads);
        const Velocities<Words> v(linear_a, angular_a, question.batch().a().size(), "a");
        const Velocities<Words> w(linear_b, angular_b, question.batch().b().size(), "b");
        const CastOptions options{ignore_separating ? Separating::ignored : Separating::hit};
        using Row = HitRow<typename Words::CastHit>;
        const typename Words::Batch& asked = question.batch();
        return records(question.template found_each<Row>([&](std::size_t i) {
          const IdPair pair = asked[i];
          return asked.a().visit(pair.a, [&](const Shape& p) {
            return asked.b().visit(pair.b, [&](const Shape& q) {
              return Row(
                  cast(p, asked.a().pose(pair.a), v[pair.a], q, asked.b().pose(pair.b), w[pair.b], duration, options));
            });
          });
        }),
                       type);
      },
      py::arg("a"), py::arg("poses_a"), py::arg("linear_a"), py::arg("b"), py::arg("poses_b"), py::arg("linear_b"),
      py::arg("duration") = 1.0, py::arg("angular_a") = still, py::arg("angular_b") = still,
      py::arg("ignore_separating") = false, py::arg("pairs") = py::none(), py::arg("threads") = py::none(),
      (std::string("When each pair of moving bodies first touches within `duration`: records with the fields t (inf "
                   "where they do not meet), point, normal, depth, status, piece_a, piece_b, hit.\n\n"
                   "linear_a, linear_b: ") +
       Words::vectors + " for all bodies of a side. angular_a, angular_b: " + Words::turnings + ", in radians." +
       sides_doc)
          .c_str());
}

}  // namespace graze::python
