#include "shape/mesh_data.hpp"

namespace graze {

namespace {

template <class T>
std::vector<Aabb<T>> triangle_bounds(const std::vector<Vec3<T>>& points,
                                     const std::vector<typename Mesh<T>::Index>& triangles) {
  std::vector<Aabb<T>> boxes;
  boxes.reserve(triangles.size());
  for (const auto& t : triangles) {
    const Vec3<T>&a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    boxes.push_back({least(a, least(b, c)), greatest(a, greatest(b, c))});
  }
  return boxes;
}

}  // namespace

template <class T>
Mesh<T>::Mesh(std::vector<Vec3<T>> points, std::vector<Index> triangles) {
  for (std::size_t i = 0; i < points.size(); ++i) validate::point(points[i], "points[" + std::to_string(i) + "]");
  if (triangles.empty()) throw InvalidValue("triangles", "at least one triangle", "none");
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangles[i][k] >= points.size())
        throw InvalidValue("triangles[" + std::to_string(i) + "][" + std::to_string(k) + "]",
                           "an index below " + std::to_string(points.size()), std::to_string(triangles[i][k]));
  auto data = std::make_shared<MeshData<T>>();
  data->tree = BoundsTree<T>(triangle_bounds<T>(points, triangles));
  for (const Vec3<T>& p : points) data->extent = greatest(data->extent, length(p));
  data->points = std::move(points);
  data->triangles = std::move(triangles);
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
T Mesh<T>::core_extent() const {
  return data_->extent;
}
template <class T>
Aabb<T> Mesh<T>::core_bounds(const Pose<T>& pose) const {
  Aabb<T> bounds = Aabb<T>::empty();
  for (const Index& t : data_->triangles)
    for (const std::uint32_t i : t) bounds = merged(bounds, transform(pose, data_->points[i]));
  return bounds;
}

template class Mesh<float>;
template class Mesh<double>;

}  // namespace graze
