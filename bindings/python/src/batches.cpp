// The questions about many pairs at once. Poses are read where they stand and answers are not copied; the interpreter's
// lock is released while they are found.
#include "answers.hpp"
#include "shapes.hpp"

#include <pybind11/stl.h>

namespace graze::python {

namespace {

static_assert(sizeof(Posed) == 7 * sizeof(double), "seven numbers a pose, as NumPy's rows have them");
static_assert(sizeof(IdPair) == 2 * sizeof(std::uint32_t));

/// One side of a batch: shapes and poses, and the Python objects whose memory they stand in.
class Side {
 public:
  Side(const py::object& shapes, const py::object& poses, const char* name) {
    if (py::isinstance<ShapeArray>(shapes)) {
      array_ = shapes;
      shapes_ = shapes.cast<const ShapeArray&>().shapes;
    } else if (py::isinstance<Shaped>(shapes)) {
      own_shapes_.push_back(shapes.cast<const Shaped&>());
      shapes_ = own_shapes_;
    } else {
      for (const py::handle shape : shapes) own_shapes_.push_back(shape.cast<const Shaped&>());
      shapes_ = own_shapes_;
    }
    read_poses(poses, std::string("poses_") + name);
  }
  Bodies<double> bodies() const { return {shapes_, poses_}; }

 private:
  void read_poses(const py::object& poses, const std::string& name) {
    Posed one;
    if (py::isinstance<py::array>(poses) && py::array::ensure(poses).ndim() == 2 &&
        py::array::ensure(poses).shape(1) == 7) {
      rows_ = rows(poses, 7, name.c_str());
      const auto* first = reinterpret_cast<const Posed*>(rows_.data());
      poses_ = {first, static_cast<std::size_t>(rows_.shape(0))};
      check(name);
    } else if (py::isinstance<py::array>(poses) && py::array::ensure(poses).ndim() == 3) {
      for (const py::handle matrix : poses) add(matrix, name);
      poses_ = own_poses_;
    } else if (!py::isinstance<py::list>(poses) && read_pose(poses, one)) {
      own_poses_.push_back(one);
      poses_ = own_poses_;
    } else {
      for (const py::handle pose : poses) add(pose, name);
      poses_ = own_poses_;
    }
  }
  void add(py::handle pose, const std::string& name) {
    Posed read;
    try {
      if (!read_pose(pose, read))
        throw py::type_error(name + "[" + std::to_string(own_poses_.size()) + "]: expected a pose");
    } catch (const InvalidValue& error) {
      throw error.below(name + "[" + std::to_string(own_poses_.size()) + "]");
    }
    own_poses_.push_back(read);
  }
  /// What stands in an array is used as it is: a quaternion has to be of unit length already.
  void check(const std::string& name) const {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const Posed& p = poses_[i];
      const Quatd& q = p.rotation;
      const double square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
      const bool sound = max_abs(p.translation) <= largest_magnitude<double> && std::abs(square - 1) <= unit_slack;
      if (sound) continue;
      const std::string path = name + "[" + std::to_string(i) + "]";
      validate::point(p.translation, path + ".translation");
      validate::fail(path + ".rotation", "a quaternion of unit length (within 1e-6)", std::sqrt(square));
    }
  }

  py::object array_;
  Rows rows_;
  std::vector<Shaped> own_shapes_;
  std::vector<Posed> own_poses_;
  std::span<const Shaped> shapes_;
  std::span<const Posed> poses_;
};

/// Both sides and the places of the pairs.
class Question {
 public:
  Question(const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
           const py::object& pairs)
      : a_(a, poses_a, "a"), b_(b, poses_b, "b") {
    if (pairs.is_none()) {
      batch_.emplace(a_.bodies(), b_.bodies());
    } else {
      pairs_ = index_rows(pairs, 2, "pairs");
      const auto* first = reinterpret_cast<const IdPair*>(pairs_.data());
      batch_.emplace(a_.bodies(), b_.bodies(),
                     std::span<const IdPair>(first, static_cast<std::size_t>(pairs_.shape(0))));
    }
  }
  const Batch<double>& batch() const { return *batch_; }

 private:
  Side a_, b_;
  IndexRows pairs_;
  std::optional<Batch<double>> batch_;
};

using Contacts = BatchContacts<double>;

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

constexpr const char* batch_doc = R"(

a, b: a Shape, a sequence of shapes or a ShapeArray (which need not be converted each time).
poses_a, poses_b: an array of shape (n, 7) of translations and unit quaternions (x, y, z, w),
which is read where it stands; matrices of shape (n, 4, 4); a sequence of poses; or one pose.
pairs: shape (m, 2), places in a and b; by default the first with the first and so on, or
the single one of a side with all of the other. The interpreter's lock is released.)";

}  // namespace

void add_batches(py::module_& m) {
  py::module_ batch = m.def_submodule(
      "batch", "Many pairs at once, many at a time on the processor's lanes; each with the answer it has alone.");
  batch.def(
      "overlap",
      [](const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
         const py::object& pairs) {
        const Question question(a, poses_a, b, poses_b, pairs);
        std::vector<std::uint8_t> touch;
        {
          const py::gil_scoped_release free;
          overlap(question.batch(), touch);
        }
        return records(std::move(touch), py::dtype("?"));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("pairs") = py::none(),
      (std::string("Whether each pair touches: an array of bool.") + batch_doc).c_str());
  batch.def(
      "distance",
      [type = distance_type()](const py::object& a, const py::object& poses_a, const py::object& b,
                               const py::object& poses_b, const py::object& pairs) {
        const Question question(a, poses_a, b, poses_b, pairs);
        std::vector<Distance<double>> distances;
        {
          const py::gil_scoped_release free;
          distance(question.batch(), distances);
        }
        return records(std::move(distances), type);
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("pairs") = py::none(),
      (std::string("The signed distance of each pair: records with the fields distance, normal, a, b, status, error.") +
       batch_doc)
          .c_str());
  batch.def(
      "contacts",
      [pairs_type = pair_type(), groups_type = group_type(),
       points_type = point_type()](const py::object& a, const py::object& poses_a, const py::object& b,
                                   const py::object& poses_b, double margin, const py::object& pairs) {
        if (!(margin >= 0)) validate::fail("margin", "a number >= 0", margin);
        const Question question(a, poses_a, b, poses_b, pairs);
        Contacts found;
        {
          const py::gil_scoped_release free;
          contacts(question.batch(), margin, found);
        }
        return py::make_tuple(records(std::move(found.pairs), pairs_type),
                              records(std::move(found.manifolds), groups_type),
                              records(std::move(found.points), points_type));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin") = 0.0,
      py::arg("pairs") = py::none(),
      (std::string(
           "Where each pair touches: (pairs, manifolds, points), three arrays of records. A pair's manifolds are "
           "`manifold_count` from `first_manifold` on, and likewise a manifold's points.") +
       batch_doc)
          .c_str());
  add_ray_batches(batch);
}

}  // namespace graze::python
