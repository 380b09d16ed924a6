// Points joined by edges, in extended precision: the nearest point of them, the first hit of a ray, and whether a point
// is inside, edge by edge.
#pragma once

#include <limits>
#include <vector>

#include "plane/figures.hpp"

namespace graze::plane {

struct WidePoint {
  Wide x = 0, y = 0;
};
inline WidePoint operator-(const WidePoint& a, const WidePoint& b) { return {a.x - b.x, a.y - b.y}; }
inline Wide wide_cross(const WidePoint& a, const WidePoint& b) { return a.x * b.y - a.y * b.x; }
inline Wide wide_dot(const WidePoint& a, const WidePoint& b) { return a.x * b.x + a.y * b.y; }

/// A point of the world, in the frame of a pose.
template <class T>
WidePoint into_frame(const WidePose& at, const Vec2<T>& p) {
  const Wide x = Wide(p.x) - at.x, y = Wide(p.y) - at.y;
  return {at.cosine * x + at.sine * y, at.cosine * y - at.sine * x};
}

class WideOutline {
 public:
  template <class T>
  WideOutline(const std::vector<Vec2<T>>& points, bool closed) : closed_(closed) {
    for (const Vec2<T>& p : points) points_.push_back({p.x, p.y});
  }

  /// The distance to the nearest edge.
  Wide to_edges(const WidePoint& p) const {
    Wide nearest = std::numeric_limits<Wide>::infinity();
    each_edge([&](const WidePoint& from, const WidePoint& edge) {
      const WidePoint to = p - from;
      const Wide along = std::min(std::max(wide_dot(to, edge) / wide_dot(edge, edge), Wide(0)), Wide(1));
      nearest = std::min(nearest, std::hypot(to.x - along * edge.x, to.y - along * edge.y));
    });
    return nearest;
  }
  /// Whether the edges go around the point.
  bool inside(const WidePoint& p) const {
    bool in = false;
    each_edge([&](const WidePoint& from, const WidePoint& edge) {
      const bool up = from.y + edge.y > p.y;
      if ((from.y > p.y) == up) return;
      if ((wide_cross(edge, p - from) > 0) == up) in = !in;
    });
    return in;
  }
  /// The distance to the nearest edge, negative inside.
  Wide signed_distance(const WidePoint& p) const { return inside(p) ? -to_edges(p) : to_edges(p); }
  /// Where a ray along a unit vector first crosses an edge; infinite if it crosses none.
  Wide first_crossing(const WidePoint& from, const WidePoint& direction) const {
    Wide first = std::numeric_limits<Wide>::infinity();
    each_edge([&](const WidePoint& start, const WidePoint& edge) {
      const Wide across = wide_cross(direction, edge);
      if (across == 0) return;
      const WidePoint to = start - from;
      const Wide t = wide_cross(to, edge) / across, s = wide_cross(to, direction) / across;
      if (t >= 0 && s >= 0 && s <= 1) first = std::min(first, t);
    });
    return first;
  }

 private:
  template <class F>
  void each_edge(const F& f) const {
    for (std::size_t i = 0; i + (closed_ ? 0 : 1) < points_.size(); ++i)
      f(points_[i], points_[(i + 1) % points_.size()] - points_[i]);
  }

  std::vector<WidePoint> points_;
  bool closed_;
};

}  // namespace graze::plane
