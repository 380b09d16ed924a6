#include "draw/cut_polygon.hpp"

#include <cmath>

namespace graze {

namespace {

struct Corner {
  double x, y;
  std::size_t before, after;
};

/// Cuts ears off: corners whose triangle holds no other corner. A simple polygon always has two (Meisters 1975,
/// "Polygons have ears").
class EarCutter {
 public:
  EarCutter(std::span<const Vec3d> points, std::span<const std::uint32_t> loop) : loop_(loop) {
    const std::size_t n = loop.size();
    Vec3d normal{};  // Newell's: twice the area, seen along each axis
    for (std::size_t i = 0; i < n; ++i)
      normal += cross(points[loop[i]] - points[loop[0]], points[loop[(i + 1) % n]] - points[loop[0]]);
    const Vec3d a = abs(normal);
    const std::size_t drop = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const std::size_t u = (drop + 1) % 3, v = (drop + 2) % 3;
    const double sign = normal[drop] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d p = points[loop[i]] - points[loop[0]];
      corners_.push_back({sign * p[u], p[v], (i + n - 1) % n, (i + 1) % n});
    }
    for (std::size_t i = 0; i < n; ++i) ears_.push_back(is_ear(i) ? 1 : 0);
  }

  void cut(std::vector<Mesh<double>::Index>& triangles) {
    std::size_t at = 1;
    for (std::size_t left = loop_.size(); left >= 3; --left) {
      // The rest has no area or crosses itself where no ear is left, and any corner does.
      for (std::size_t tried = 0; tried < left && !ears_[at]; ++tried) at = corners_[at].after;
      const auto [x, y, before, after] = corners_[at];
      triangles.push_back({loop_[before], loop_[at], loop_[after]});
      corners_[before].after = after;
      corners_[after].before = before;
      ears_[before] = is_ear(before) ? 1 : 0;
      ears_[after] = is_ear(after) ? 1 : 0;
      at = after;
    }
  }

 private:
  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    const Corner &p = corners_[a], &q = corners_[b], &r = corners_[c];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  bool same(std::size_t a, std::size_t b) const {
    return corners_[a].x == corners_[b].x && corners_[a].y == corners_[b].y;
  }
  bool is_ear(std::size_t at) const {
    const std::size_t before = corners_[at].before, after = corners_[at].after;
    if (!(turn(before, at, after) > 0)) return false;
    for (std::size_t i = corners_[after].after; i != before; i = corners_[i].after) {
      if (same(i, before) || same(i, at) || same(i, after)) continue;
      if (turn(before, at, i) >= 0 && turn(at, after, i) >= 0 && turn(after, before, i) >= 0) return false;
    }
    return true;
  }

  std::span<const std::uint32_t> loop_;
  std::vector<Corner> corners_;
  std::vector<char> ears_;
};

}  // namespace

void cut_polygon(std::span<const Vec3d> points, std::span<const std::uint32_t> loop,
                 std::vector<Mesh<double>::Index>& triangles) {
  if (loop.size() < 3) return;
  if (loop.size() == 3)
    triangles.push_back({loop[0], loop[1], loop[2]});
  else
    EarCutter(points, loop).cut(triangles);
}

}  // namespace graze
