// Reduction of a manifold to the points of largest area.

#include "graze/contact.hpp"

namespace graze {

namespace {

/// The kept points as a polygon, counter-clockwise seen against the normal.
template <class T>
class Span {
 public:
  explicit Span(const Vec3<T>& normal) : normal_(normal) {}

  /// Twice the area that the polygon would gain by `p`; for a single point, the squared distance.
  T gain(const Vec3<T>& p) const {
    if (corners_.size() == 1) return across(p - corners_[0]);
    T most(0);
    for (std::size_t i = 0; i < corners_.size(); ++i) most = greatest(most, outside(i, p));
    return most;
  }
  void add(const Vec3<T>& p) {
    std::size_t place = corners_.size();
    for (std::size_t i = 0; corners_.size() > 1 && i < corners_.size(); ++i)
      if (place == corners_.size() || outside(i, p) > outside(place, p)) place = i;
    corners_.push_back(p);
    if (corners_.size() < 3) return;
    for (std::size_t i = corners_.size() - 1; i > place + 1; --i) corners_[i] = corners_[i - 1];
    corners_[place + 1] = p;
  }

 private:
  T across(const Vec3<T>& v) const { return length_squared(v - normal_ * dot(v, normal_)); }
  /// Twice the area of the triangle of `p` and the side from corner i on, where `p` lies outside; else negative.
  T outside(std::size_t i, const Vec3<T>& p) const {
    const Vec3<T>& from = corners_[i];
    const Vec3<T> side = corners_[i + 1 == corners_.size() ? 0 : i + 1] - from;
    return dot(cross(p - from, side), normal_);
  }

  Vec3<T> normal_;
  SmallVector<Vec3<T>, 8> corners_;
};

}  // namespace

template <class T>
void reduce(Manifold<T>& manifold, std::size_t count) {
  auto& points = manifold.points;
  if (points.size() <= count) return;
  SmallVector<unsigned char, 32> kept;
  for (std::size_t i = 0; i < points.size(); ++i) kept.push_back(0);
  Span<T> span(manifold.normal);
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t best = points.size();
    T most(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (kept[i]) continue;
      const T value = k == 0 ? -points[i].distance : span.gain(points[i].position());
      if (best < points.size() && !(value > most)) continue;
      best = i;
      most = value;
    }
    kept[best] = 1;
    span.add(points[best].position());
  }
  std::size_t count_kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) points[count_kept++] = points[i];
  points.truncate(count);
}

template void reduce(Manifold<float>&, std::size_t);
template void reduce(Manifold<double>&, std::size_t);

}  // namespace graze
