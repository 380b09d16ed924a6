#include <algorithm>
#include <numeric>

#include "shape/mesh_data.hpp"
#include "shape/mesh_topology.hpp"
#include "shape/placed_bounds.hpp"

namespace graze {

namespace {

template <class T>
PackedLeaf packed_leaf(const MeshData<T>& mesh, const TreeNode<T>& node, std::size_t lane) {
  PackedLeaf leaf;
  const std::uint32_t first = node.first_of(lane), last = node.pieces_of(lane) - 1;
  for (std::uint32_t i = 0; i < PackedLeaf::lanes; ++i) {
    const std::array<Vec3<T>, 3> corners = mesh.triangle(mesh.tree.order()[first + least(i, last)]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto origin = static_cast<double>(node.origin[axis]), step = static_cast<double>(node.step[axis]);
      const double parts_per_length = step > 0 ? PackedLeaf::parts / step : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double parts = (static_cast<double>(corners[k][axis]) - origin) * parts_per_length + 0.5;
        leaf.at[axis][k][i] = static_cast<std::uint16_t>(clamp(parts, 0.0, 65535.0));
      }
    }
  }
  return leaf;
}

template <class T>
std::vector<PackedLeaf> packed_leaves(const MeshData<T>& mesh) {
  static_assert(PackedLeaf::lanes == TreeNode<T>::leaf_size);
  std::vector<PackedLeaf> leaves;
  leaves.reserve(mesh.tree.leaves());
  for (const TreeNode<T>& node : mesh.tree.nodes())
    for (std::size_t lane = node.inner; lane < node.count; ++lane) leaves.push_back(packed_leaf(mesh, node, lane));
  return leaves;
}

template <class T>
T longest_side(const MeshData<T>& data) {
  T longest(0);
  for (std::uint32_t i = 0; i < data.triangles.size(); ++i) {
    const auto [a, b, c] = data.triangle(i);
    longest = greatest(longest, greatest(length(b - a), greatest(length(c - b), length(a - c))));
  }
  return longest;
}

/// Whether the volume that a closed mesh bounds by its windings is positive. The sum is taken about a point of the
/// mesh, since far from the origin its digits would be lost.
template <class T>
bool leads_outward(const MeshData<T>& data) {
  const Vec3d origin = converted<double>(data.points[data.triangles[0][0]]);
  double volume = 0;
  for (std::uint32_t i = 0; i < data.triangles.size(); ++i) {
    const auto [a, b, c] = data.triangle(i);
    const Vec3d u = converted<double>(a) - origin, v = converted<double>(b) - origin, w = converted<double>(c) - origin;
    volume += dot(u, cross(v, w));
  }
  return volume > 0;
}

/// A point of each connected part: triangles are connected that share a point by its number.
template <class T>
std::vector<std::uint32_t> islands(std::size_t points, std::span<const typename Mesh<T>::Index> triangles) {
  std::vector<std::uint32_t> parent(points);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : triangles) {
    const std::uint32_t a = root(t[0]), b = root(t[1]), c = root(t[2]);
    const std::uint32_t first = least(a, least(b, c));
    parent[a] = parent[b] = parent[c] = first;
  }
  std::vector<std::uint32_t> found;
  std::vector<bool> seen(points, false);
  for (const auto& t : triangles) {
    const std::uint32_t first = root(t[0]);
    if (!seen[first]) found.push_back(first);
    seen[first] = true;
  }
  return found;
}

}  // namespace

template <class T>
Mesh<T>::Mesh(std::vector<Vec3<T>> points, std::vector<Index> triangles, Sides sides, bool solid) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(std::isfinite(points[i].x) && std::isfinite(points[i].y) && std::isfinite(points[i].z)))
      validate::point(points[i], "points[" + std::to_string(i) + "]");
  if (triangles.empty()) throw InvalidValue("triangles", "at least one triangle", "none");
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles[i][k] >= points.size())
        throw InvalidValue("triangles[" + std::to_string(i) + "][" + std::to_string(k) + "]",
                           "an index below " + std::to_string(points.size()), std::to_string(triangles[i][k]));
  auto data = std::make_shared<MeshData<T>>();
  for (Vec3<T>& p : points) p = validate::resolved(p);
  for (const Vec3<T>& p : points) data->extent = greatest(data->extent, length(p));
  data->sides = sides;
  {
    const EdgeUses edges(triangles, points.size());
    data->closed = edges.bound_solid();
    if (solid && !data->closed)
      throw InvalidValue("solid", "triangles that bound a solid", "a mesh that is not closed");
    data->solid = solid;
    data->level = level_triangles<T>(points, triangles, edges);
    data->neighbours = edges.across(triangles);
  }
  data->points = std::move(points);
  data->triangles = std::move(triangles);
  data->longest = longest_side(*data);
  data->outward = data->closed && leads_outward(*data);
  data->islands = islands<T>(data->points.size(), data->triangles);
  std::vector<TreePiece<T>> pieces;
  pieces.reserve(data->triangles.size());
  for (const std::uint32_t i : different_triangles<T>(data->points, data->triangles))
    pieces.push_back({bounds_of(data->triangle(i)), i});
  data->tree = WideTree<T>(std::move(pieces));
  data->leaves = packed_leaves(*data);
  data->radius = ball_radius(data->tree.bounds());
  data_ = std::move(data);
}

template <class T>
std::span<const Vec3<T>> Mesh<T>::points() const {
  return data_->points;
}
template <class T>
std::span<const typename Mesh<T>::Index> Mesh<T>::triangles() const {
  return data_->triangles;
}
template <class T>
bool Mesh<T>::closed() const {
  return data_->closed;
}
template <class T>
Sides Mesh<T>::sides() const {
  return data_->sides;
}
template <class T>
bool Mesh<T>::solid() const {
  return data_->solid;
}
template <class T>
std::size_t Mesh<T>::memory() const {
  return data_->memory();
}
template <class T>
T Mesh<T>::core_extent() const {
  return data_->extent;
}
template <class T>
Aabb<T> Mesh<T>::core_bounds(const Pose<T>& pose) const {
  return placed_bounds(data_->tree, pose, [&](std::uint32_t i) {
    std::array<Vec3<T>, 3> corners = data_->triangle(i);
    for (Vec3<T>& p : corners) p = transform(pose, p);
    return bounds_of(corners);
  });
}

template class Mesh<float>;
template class Mesh<double>;

}  // namespace graze
