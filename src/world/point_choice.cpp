#include "graze/world/point_choice.hpp"

#include <algorithm>

#include "graze/plane/space.hpp"

namespace graze {

template <class T, class Space>
void PointChoice<T, Space>::choose(std::size_t count) {
  if (count == 0) return;
  if (points_.front().manifold == points_.back().manifold) return choose_of_one(count);
  Candidate& deepest = *std::min_element(points_.begin(), points_.end(),
                                         [](const auto& p, const auto& q) { return p.distance < q.distance; });
  T reach_squared(0);
  for (Candidate& p : points_) reach_squared = greatest(reach_squared, length_squared(p.place - deepest.place));
  const auto apart_squared = [&](const Candidate& p, const Candidate& q) {
    return length_squared(p.place - q.place) + length_squared(p.normal - q.normal) * reach_squared;
  };
  for (Candidate& p : points_) p.apart_squared = apart_squared(p, deepest);
  deepest.kept = true;
  for (std::size_t k = 1; k < count; ++k) {
    Candidate* best = nullptr;
    for (Candidate& p : points_)
      if (!p.kept && (!best || before(p, *best))) best = &p;
    best->kept = true;
    for (Candidate& p : points_) p.apart_squared = least(p.apart_squared, apart_squared(p, *best));
  }
}

/// Whether a point comes before another: it is further from those that are kept, or as far and deeper.
template <class T, class Space>
bool PointChoice<T, Space>::before(const Candidate& p, const Candidate& q) {
  return p.apart_squared > q.apart_squared || (p.apart_squared == q.apart_squared && p.distance < q.distance);
}

/// Chooses among the points of one manifold, by its own `reduce`; `feature` takes a point's number through.
template <class T, class Space>
void PointChoice<T, Space>::choose_of_one(std::size_t count) {
  one_.normal = points_[0].normal;
  one_.points.truncate(0);
  for (std::size_t i = 0; i < points_.size(); ++i)
    one_.points.push_back({points_[i].place, points_[i].place, points_[i].distance, static_cast<std::uint32_t>(i)});
  reduce(one_, count);
  for (const auto& p : one_.points) points_[p.feature].kept = true;
}

template class PointChoice<float>;
template class PointChoice<double>;
template class PointChoice<float, plane::Space<float>>;
template class PointChoice<double, plane::Space<double>>;

}  // namespace graze
