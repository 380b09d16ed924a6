// The questions about many pairs of the plane at once. Poses are read where they stand and answers are not copied; the
// interpreter's lock is released while they are found.
#include "plane_convert.hpp"

namespace graze::python {

namespace {

using plane::Pose2d, plane::Shaped;

static_assert(sizeof(Pose2d) == 4 * sizeof(double), "four numbers a pose, as NumPy's rows have them");
static_assert(sizeof(IdPair) == 2 * sizeof(std::uint32_t));

/// One side of a batch: shapes and poses, and the array whose memory they stand in.
class Side {
 public:
  Side(const py::object& shapes, const py::object& poses, const std::string& name) {
    read_shapes(shapes, name);
    read_poses(poses, "poses_" + name);
  }
  plane::Bodies<double> bodies() const { return {std::span<const Shaped>(shapes_), poses_}; }

 private:
  void read_shapes(const py::object& shapes, const std::string& name) {
    if (py::isinstance<Shaped>(shapes)) {
      shapes_.push_back(shapes.cast<const Shaped&>());
      return;
    }
    for (const py::handle shape : shapes) {
      if (!py::isinstance<Shaped>(shape))
        throw py::type_error(name + "[" + std::to_string(shapes_.size()) + "]: expected a graze.plane.Shape");
      shapes_.push_back(shape.cast<const Shaped&>());
    }
  }
  void read_poses(const py::object& poses, const std::string& name) {
    Pose2d one;
    if (py::isinstance<py::array>(poses) && py::array(poses).ndim() == 2 && py::array(poses).shape(1) == 4) {
      rows_ = rows(poses, 4, name.c_str());
      poses_ = {reinterpret_cast<const Pose2d*>(rows_.data()), static_cast<std::size_t>(rows_.shape(0))};
      check(name);
      return;
    }
    if (!py::isinstance<py::list>(poses) && read_pose(poses, one))
      own_poses_.push_back(one);
    else
      for (const py::handle pose : poses) add(pose, name);
    poses_ = own_poses_;
  }
  void add(py::handle pose, const std::string& name) {
    const std::string path = name + "[" + std::to_string(own_poses_.size()) + "]";
    Pose2d read;
    try {
      if (!read_pose(pose, read)) throw py::type_error(path + ": expected a pose");
    } catch (const InvalidValue& error) {
      throw error.below(path);
    }
    own_poses_.push_back(read);
  }
  /// What stands in an array is used as it is: its rotations have to be of unit length already.
  void check(const std::string& name) const {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const Pose2d& p = poses_[i];
      const double square = p.rotation.cosine * p.rotation.cosine + p.rotation.sine * p.rotation.sine;
      if (max_abs(p.translation) <= largest_magnitude<double> && std::abs(square - 1) <= unit_slack) continue;
      const std::string path = name + "[" + std::to_string(i) + "]";
      static_cast<void>(plane::detail::checked_point(p.translation, path + ".translation"));
      validate::fail(path + ".rotation", "a cosine and a sine of unit length (within 1e-6)", std::sqrt(square));
    }
  }

  Rows rows_;
  std::vector<Shaped> shapes_;
  std::vector<Pose2d> own_poses_;
  std::span<const Pose2d> poses_;
};

/// Both sides and the places of the pairs.
class Question {
 public:
  Question(const py::object& a, const py::object& poses_a, const py::object& b, const py::object& poses_b,
           const py::object& pairs)
      : a_(a, poses_a, "a"),
        b_(b, poses_b, "b"),
        pairs_(pairs.is_none() ? IndexRows() : index_rows(pairs, 2, "pairs")),
        batch_(pairs.is_none() ? plane::Batch<double>(a_.bodies(), b_.bodies())
                               : plane::Batch<double>(a_.bodies(), b_.bodies(), places())) {}

  /// The answers to all, found while other threads of Python run.
  template <class Answers, class F>
  Answers found(F&& ask) const {
    const py::gil_scoped_release free;
    Answers answers;
    ask(batch_, answers);
    return answers;
  }

 private:
  std::span<const IdPair> places() const {
    return {reinterpret_cast<const IdPair*>(pairs_.data()), static_cast<std::size_t>(pairs_.shape(0))};
  }

  Side a_, b_;
  IndexRows pairs_;
  plane::Batch<double> batch_;
};

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
the single one of a side with all of the other. The interpreter's lock is released.)";

}  // namespace

void add_plane_batches(py::module_& m) {
  py::module_ batch = m.def_submodule("batch", "Many pairs at once; each with the answer it has alone.");
  batch.attr("__name__") = "graze.plane.batch";
  const auto define = [&](const char* name, const auto& ask, const std::string& doc) {
    batch.def(name, ask, py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"),
              py::arg("pairs") = py::none(), (doc + batch_doc).c_str());
  };
  using Object = const py::object&;
  define(
      "overlap",
      [](Object a, Object poses_a, Object b, Object poses_b, Object pairs) {
        const Question question(a, poses_a, b, poses_b, pairs);
        return records(question.found<std::vector<std::uint8_t>>(
                           [](const auto& asked, auto& answers) { overlap(asked, answers); }),
                       py::dtype("?"));
      },
      "Whether each pair touches: an array of bool.");
  define(
      "distance",
      [type = plane_distance_type()](Object a, Object poses_a, Object b, Object poses_b, Object pairs) {
        const Question question(a, poses_a, b, poses_b, pairs);
        return records(question.found<std::vector<plane::Distance<double>>>(
                           [](const auto& asked, auto& answers) { distance(asked, answers); }),
                       type);
      },
      "The signed distance of each pair: records with the fields distance, normal, a, b, status, error.");
  batch.def(
      "contacts",
      [pairs_type = pair_type(), groups_type = group_type(), points_type = plane_point_type()](
          Object a, Object poses_a, Object b, Object poses_b, double margin, Object pairs) {
        if (!(margin >= 0)) validate::fail("margin", "a number >= 0", margin);
        const Question question(a, poses_a, b, poses_b, pairs);
        Contacts found =
            question.found<Contacts>([margin](const auto& asked, auto& answers) { contacts(asked, margin, answers); });
        return py::make_tuple(records(std::move(found.pairs), pairs_type),
                              records(std::move(found.manifolds), groups_type),
                              records(std::move(found.points), points_type));
      },
      py::arg("a"), py::arg("poses_a"), py::arg("b"), py::arg("poses_b"), py::arg("margin") = 0.0,
      py::arg("pairs") = py::none(),
      ("Where each pair touches: (pairs, manifolds, points), three arrays of records. A pair's manifolds are "
       "`manifold_count` from `first_manifold` on, and likewise a manifold's points." +
       batch_doc)
          .c_str());
}

}  // namespace graze::python
