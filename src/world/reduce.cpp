// The closing up of arrays behind points that are left out.

#include "graze/world/reduce.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "graze/plane/reduce.hpp"
#include "graze/plane/space.hpp"
#include "graze/world/point_choice.hpp"

namespace graze {

namespace {

/// Contacts in three arrays: pairs, manifolds and points, the latter two in one order.
template <class T, class Space, class Arrays>
void reduce_arrays(Arrays& arrays, std::size_t count) {
  std::vector<unsigned char> left_out;  // of the points; made when the first is
  PointChoice<T, Space> choice;
  for (const auto& pair : arrays.pairs) {
    const auto manifolds = std::span(arrays.manifolds).subspan(pair.first_manifold, pair.manifold_count);
    std::size_t points = 0;
    for (const auto& m : manifolds) points += m.point_count;
    if (points <= count) continue;
    choice.clear();
    for (const auto& m : manifolds)
      for (const auto& p : arrays.points_of(m)) choice.add(p, m.normal, m.first_point);
    choice.choose(count);
    if (left_out.empty()) left_out.resize(arrays.points.size(), 0);
    std::size_t i = 0;
    for (const auto& m : manifolds)
      for (std::size_t k = 0; k < m.point_count; ++k, ++i) left_out[m.first_point + k] = !choice.kept(i);
  }
  if (left_out.empty()) return;
  std::vector<std::uint32_t> places;  // of the manifolds before, among those that are left
  places.reserve(arrays.manifolds.size() + 1);
  std::uint32_t manifolds = 0, points = 0;
  for (auto m : arrays.manifolds) {
    places.push_back(manifolds);
    const std::uint32_t first = points;
    for (std::uint32_t k = m.first_point; k < m.first_point + m.point_count; ++k)
      if (!left_out[k]) arrays.points[points++] = arrays.points[k];
    m.first_point = first;
    m.point_count = points - first;
    if (m.point_count != 0) arrays.manifolds[manifolds++] = m;
  }
  places.push_back(manifolds);
  arrays.manifolds.resize(manifolds);
  arrays.points.resize(points);
  for (auto& pair : arrays.pairs) {
    const std::uint32_t first = pair.first_manifold, end = first + pair.manifold_count;
    pair.first_manifold = places[first];
    pair.manifold_count = places[end] - places[first];
  }
}

/// The manifolds of one pair.
template <class T, class Space>
void reduce_manifolds(std::vector<typename Space::Manifold>& manifolds, std::size_t count) {
  PointChoice<T, Space> choice;
  for (std::size_t i = 0; i < manifolds.size(); ++i)
    for (const auto& p : manifolds[i].points) choice.add(p, manifolds[i].normal, i);
  if (choice.size() <= count) return;
  choice.choose(count);
  std::size_t place = 0;
  for (auto& m : manifolds) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < m.points.size(); ++k, ++place)
      if (choice.kept(place)) m.points[kept++] = m.points[k];
    m.points.truncate(kept);
  }
  manifolds.erase(std::remove_if(manifolds.begin(), manifolds.end(), [](const auto& m) { return m.points.empty(); }),
                  manifolds.end());
}

}  // namespace

template <class T>
void reduce(Manifolds<T>& manifolds, std::size_t count) {
  reduce_manifolds<T, Space<T>>(manifolds, count);
}

template <class T>
void reduce(BatchContacts<T>& contacts, std::size_t count) {
  reduce_arrays<T, Space<T>>(contacts, count);
}

template <class T, class Space>
void reduce(ContactArrays<T, Space>& contacts, std::size_t count) {
  reduce_arrays<T, Space>(contacts, count);
}

template <class T>
void plane::reduce(Manifolds<T>& manifolds, std::size_t count) {
  reduce_manifolds<T, Space<T>>(manifolds, count);
}

template <class T>
void plane::reduce(BatchContacts<T>& contacts, std::size_t count) {
  reduce_arrays<T, Space<T>>(contacts, count);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void reduce(Manifolds<T>&, std::size_t);                                                                    \
  template void reduce(BatchContacts<T>&, std::size_t);                                                                \
  template void reduce(ContactArrays<T>&, std::size_t);                                                                \
  template void reduce(ContactArrays<T, plane::Space<T>>&, std::size_t);                                               \
  template void plane::reduce(plane::Manifolds<T>&, std::size_t);                                                      \
  template void plane::reduce(plane::BatchContacts<T>&, std::size_t);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
