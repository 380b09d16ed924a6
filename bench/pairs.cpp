#include "pairs.hpp"

#include <algorithm>
#include <cmath>

#include "random.hpp"

namespace graze::bench {

namespace {

/// The triangles of the hull of a few points, no four of them in a plane: those with all other points behind them.
std::vector<std::array<int, 3>> hull_faces(const std::vector<Vec3d>& points) {
  const int n = static_cast<int>(points.size());
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const Vec3d normal = cross(points[j] - points[i], points[k] - points[i]);
        bool before = false, behind = false;
        for (int other = 0; other < n && !(before && behind); ++other) {
          if (other == i || other == j || other == k) continue;
          (dot(normal, points[other] - points[i]) > 0 ? before : behind) = true;
        }
        if (!before) faces.push_back({i, j, k});
        if (before && !behind) faces.push_back({i, k, j});
      }
  return faces;
}

Body make_body(Kind kind, double scale, Random& random) {
  Body body{kind, {}, {}, {}, {}};
  const auto extent = [&] { return random.number(0.25, 1) * scale; };
  const double x = extent(), y = extent(), z = extent();
  if (kind == Kind::box)
    body.size = Vec3d{x, y, z} * 2.0;
  else
    body.size = {x, kind == Kind::ellipsoid ? y : 2 * y, z};
  if (kind == Kind::hull)
    for (int i = 0; i < 32; ++i) body.points.push_back(as_float(scaled(random.direction(), {x, y, z})));
  if (kind == Kind::triangle) {
    Vec3d p[3];
    do {
      for (Vec3d& v : p) v = random.in_cube(scale);
    } while (length(cross(p[1] - p[0], p[2] - p[0])) < 0.5 * scale * scale);  // no slivers: they are a test, not a race
    const Vec3d center = (p[0] + p[1] + p[2]) / 3.0;
    for (const Vec3d& v : p) body.points.push_back(as_float(v - center));
  }
  if (kind == Kind::hull) body.faces = hull_faces(body.points);
  body.size = as_float(body.size);
  body.pose = as_float(Posed{random.in_cube(2 * scale), random.rotation()});
  return body;
}

}  // namespace

double Body::reach() const {
  switch (kind) {
  case Kind::sphere: return size.x;
  case Kind::capsule: return size.x + size.y / 2;
  case Kind::box: return length(size) / 2;
  case Kind::cylinder:
  case Kind::cone: return std::sqrt(size.x * size.x + size.y * size.y / 4);
  case Kind::ellipsoid: return std::max({size.x, size.y, size.z});
  case Kind::half_space: return 0;
  case Kind::hull:
  case Kind::triangle: break;
  }
  double reach = 0;
  for (const Vec3d& p : points) reach = std::max(reach, length(p));
  return reach;
}

double Pair::size() const { return std::max(a.reach(), b.reach()); }

std::vector<Pair> make_pairs(Kind a, Kind b, std::size_t count, double scale, const MakeTouching& make_touching) {
  Random random(1 + static_cast<std::uint64_t>(a) * kind_count + static_cast<std::uint64_t>(b));
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair{make_body(a, scale, random), make_body(b, scale, random)};
    const Touching touching = make_touching(pair.a, pair.b);
    const bool plane = b == Kind::half_space;
    const Vec3d direction = plane ? rotate(pair.b.pose.rotation, Vec3d{0, 1, 0}) : random.direction();
    const auto placed = [&](double away) {
      return Posed{pair.b.pose.translation + direction * away, pair.a.pose.rotation};
    };
    // Convex shapes that hold their origins overlap up to some distance between these, and no further.
    double low = 0, high = pair.a.reach() + pair.b.reach();
    for (int step = 0; step < 16; ++step) {
      const double middle = (low + high) / 2;
      (touching(placed(middle), pair.b.pose) ? low : high) = middle;
    }
    const double push = random.number(0, 0.25) * pair.size();
    Posed pose = placed(i % 2 == 0 ? std::max(0.0, low - push) : high + push);
    if (plane) pose.translation += cross(direction, random.in_cube(scale));
    pair.a.pose = as_float(pose);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace graze::bench
