// Many rays at one shape. The interpreter's lock is released while they are cast.
#include "answers.hpp"
#include "shapes.hpp"

namespace graze::python {

namespace {

/// A hit as a row of an array.
struct RayRow {
  RayHit<double> hit{std::numeric_limits<double>::infinity(), {}, {}, 0};
  bool there = false;
};

py::dtype ray_row_type() {
  using H = RayHit<double>;
  constexpr std::size_t hit = offsetof(RayRow, hit);
  return record_type({{"t", "f8", hit + offsetof(H, t)},
                      {"point", "(3,)f8", hit + offsetof(H, point)},
                      {"normal", "(3,)f8", hit + offsetof(H, normal)},
                      {"piece", "u4", hit + offsetof(H, piece)},
                      {"hit", "?", offsetof(RayRow, there)}},
                     sizeof(RayRow));
}

/// Rows of three numbers, or one row for all.
std::vector<Vec3d> vectors_of(const py::object& from, const char* name) {
  Vec3d one;
  if (read_vector(from, one)) return {validate::point(one, name)};
  std::vector<Vec3d> all = points_of(rows(from, 3, name));
  for (std::size_t i = 0; i < all.size(); ++i)
    validate::point(all[i], std::string(name) + "[" + std::to_string(i) + "]");
  return all;
}

std::vector<Ray<double>> rays_of(const py::object& origins, const py::object& directions) {
  const std::vector<Vec3d> from = vectors_of(origins, "origins"), to = vectors_of(directions, "directions");
  if (from.size() != to.size() && from.size() != 1 && to.size() != 1)
    validate::fail("directions", "as many as origins, or one of either", static_cast<double>(to.size()));
  std::vector<Ray<double>> rays(from.empty() || to.empty() ? 0 : std::max(from.size(), to.size()));
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = {from[from.size() == 1 ? 0 : i], to[to.size() == 1 ? 0 : i]};
  return rays;
}

double checked_length(double length) {
  if (!(length >= 0)) validate::fail("length", "a number >= 0", length);
  return length;
}

constexpr const char* rays_doc = R"(

origins, directions: shape (n, 3), or three numbers for all rays; a direction need not be of unit
length. length: what is further along is not met. back_faces: whether a triangle is met from behind.
Raises ValueError for what is not finite.)";

}  // namespace

void add_ray_batches(py::module_& batch) {
  batch.def(
      "raycast",
      [type = ray_row_type()](const Shaped& shape, const Placement& pose, const py::object& origins,
                              const py::object& directions, double length, bool back_faces) {
        const std::vector<Ray<double>> rays = rays_of(origins, directions);
        std::vector<std::optional<RayHit<double>>> hits(rays.size());
        checked_length(length);
        std::vector<RayRow> found(rays.size());
        {
          const py::gil_scoped_release free;
          raycast<double>(shape, pose.value, rays, hits, length, back_faces ? BackFaces::hit : BackFaces::ignored);
          for (std::size_t i = 0; i < hits.size(); ++i)
            if (hits[i]) found[i] = {*hits[i], true};
        }
        return records(std::move(found), type);
      },
      py::arg("shape"), py::arg("pose"), py::arg("origins"), py::arg("directions"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
      (std::string("What each of many rays hits first: records with the fields t (inf where nothing is hit), point, "
                   "normal, piece, hit.") +
       rays_doc)
          .c_str());
  batch.def(
      "raycast_any",
      [](const Shaped& shape, const Placement& pose, const py::object& origins, const py::object& directions,
         double length, bool back_faces) {
        const std::vector<Ray<double>> rays = rays_of(origins, directions);
        checked_length(length);
        std::vector<std::uint8_t> found(rays.size());
        {
          const py::gil_scoped_release free;
          raycast_any<double>(shape, pose.value, rays, {reinterpret_cast<bool*>(found.data()), found.size()}, length,
                              back_faces ? BackFaces::hit : BackFaces::ignored);
        }
        return records(std::move(found), py::dtype("?"));
      },
      py::arg("shape"), py::arg("pose"), py::arg("origins"), py::arg("directions"),
      py::arg("length") = std::numeric_limits<double>::infinity(), py::arg("back_faces") = true,
      (std::string("Whether each of many rays hits anything: an array of bool.") + rays_doc).c_str());
}

}  // namespace graze::python
