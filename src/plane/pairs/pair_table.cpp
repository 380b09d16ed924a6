#include "plane/pairs/pair_table.hpp"

#include "plane/pairs/lane_shape.hpp"
#include "plane/pairs/pair_answers.hpp"

namespace graze::plane {

namespace {

/// The kernels of the level that the machine runs at.
const AloneKernels* kernels() {
  static const AloneKernels* const chosen = GRAZE_KERNEL(chosen_isa(), plane_alone_kernels)();
  return chosen;
}

/// Writes the numbers of a shape in place where the kernels read them: copied from elsewhere they would be read in
/// pieces of another size than they were written in, for which processors wait.
template <class T>
bool take_shape(const Shape<T>& shape, const Pose2<T>& pose, double (&columns)[shape_columns][1]) {
  double* const to = &columns[0][0];
  to[0] = double(pose.translation.x);
  to[1] = double(pose.translation.y);
  to[2] = double(pose.rotation.cosine);
  to[3] = double(pose.rotation.sine);
  return shape.visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (lane_core<C>.has_value()) {
      to[shape_columns - 1] = size_numbers(c, to + pose_columns) + double(shape.rounding());
      return accepted(c);
    } else {
      return false;
    }
  });
}

/// Fills `columns` with the pair and returns its entry, if there is one.
template <class T>
std::optional<PairEntry> take_pair(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                                   PairColumns<1>& columns) {
  const std::optional<PairEntry> entry = KindTable<T>::at(a.index(), b.index());
  if (!entry) return {};
  auto &to_a = entry->turned ? columns.b : columns.a, &to_b = entry->turned ? columns.a : columns.b;
  if (!take_shape(a, pose_a, to_a) || !take_shape(b, pose_b, to_b)) return {};
  return entry;
}

}  // namespace

template <class T>
std::optional<bool> special_overlap(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                    const Pose2<T>& pose_b) {
  PairColumns<1> columns;
  const std::optional<PairEntry> entry = take_pair(a, pose_a, b, pose_b, columns);
  if (!entry) return {};
  OverlapColumns<1> found;
  kernels()[entry->place].overlap(columns, found);
  if (found.known[0] == 0) return {};
  return found.overlap[0] != 0;
}

template <class T>
bool special_distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                      Distance<T>& out) {
  PairColumns<1> columns;
  const std::optional<PairEntry> entry = take_pair(a, pose_a, b, pose_b, columns);
  if (!entry) return false;
  DistanceColumns<1> found;
  kernels()[entry->place].distance(columns, found);
  if (found.known[0] == 0) return false;
  out = distance_at<T>(found, 0, entry->turned);
  return true;
}

template <class T>
std::optional<bool> special_contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b,
                                     const Pose2<T>& pose_b, T margin, Manifolds<T>& manifolds) {
  PairColumns<1> columns;
  const std::optional<PairEntry> entry = take_pair(a, pose_a, b, pose_b, columns);
  if (!entry) return {};
  ContactColumns<1> found;
  kernels()[entry->place].contacts(columns, double(margin), found);
  if (found.known[0] == 0) return {};
  if (found.filled[0] != 0) {
    Manifold<T>& m = manifolds.emplace_back();
    m.normal = normal_at<T>(found, 0, entry->turned);
    const auto filled = static_cast<unsigned>(found.filled[0]);
    for (unsigned k = 0; k < 2; ++k)
      if ((filled >> k & 1) != 0) m.points.push_back(point_at<T>(found, 0, k, entry->turned));
  }
  return found.overlap[0] != 0;
}

#define GRAZE_PLANE_SPECIAL(T)                                                                                         \
  template std::optional<bool> special_overlap(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&);    \
  template bool special_distance(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, Distance<T>&);    \
  template std::optional<bool> special_contacts(const Shape<T>&, const Pose2<T>&, const Shape<T>&, const Pose2<T>&, T, \
                                                Manifolds<T>&);
GRAZE_PLANE_SPECIAL(float)
GRAZE_PLANE_SPECIAL(double)
#undef GRAZE_PLANE_SPECIAL

}  // namespace graze::plane
