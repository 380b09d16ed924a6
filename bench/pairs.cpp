#include "pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

Corners make_corners(Kind kind, const Vec3d& extent, double scale, std::size_t vertices, Random& random) {
  Corners corners;
  if (kind == Kind::hull) {
    for (std::size_t i = 0; i < vertices; ++i) corners.points.push_back(as_float(scaled(random.direction(), extent)));
    corners.faces = hull_faces(corners.points);
    return corners;
  }
  Vec3d p[3];
  do {
    for (Vec3d& v : p) v = random.in_cube(scale);
  } while (length(cross(p[1] - p[0], p[2] - p[0])) < 0.5 * scale * scale);  // no slivers: they are a test, not a race
  const Vec3d center = (p[0] + p[1] + p[2]) / 3.0;
  for (const Vec3d& v : p) corners.points.push_back(as_float(v - center));
  corners.faces = {{0, 1, 2}};
  return corners;
}

/// Bodies one after the other, of which hulls and triangles come again from a number on.
class Bodies {
 public:
  Bodies(double scale, std::size_t different, Random& random, std::size_t vertices = 32)
      : scale_(scale), different_(different), vertices_(vertices), random_(random) {}

  Body next(Kind kind) {
    Body body{kind};
    const auto extent = [&] { return random_.number(0.25, 1) * scale_; };
    const double x = extent(), y = extent(), z = extent();
    body.size = as_float(kind == Kind::box         ? Vec3d{x, y, z} * 2.0
                         : kind == Kind::ellipsoid ? Vec3d{x, y, z}
                                                   : Vec3d{x, 2 * y, z});
    if (kind == Kind::hull || kind == Kind::triangle) body.corners = corners(kind, {x, y, z});
    body.pose = as_float(Posed{random_.in_cube(2 * scale_), random_.rotation()});
    return body;
  }

 private:
  using Shared = std::shared_ptr<const Corners>;

  Shared corners(Kind kind, const Vec3d& extent) {
    std::vector<Shared>& made = kind == Kind::hull ? hulls_ : triangles_;
    if (made.size() < different_) {
      made.push_back(std::make_shared<const Corners>(make_corners(kind, extent, scale_, vertices_, random_)));
      return made.back();
    }
    return made[static_cast<std::size_t>(random_.number(0, 1) * static_cast<double>(made.size()))];
  }

  double scale_;
  std::size_t different_, vertices_;
  Random& random_;
  std::vector<Shared> hulls_, triangles_;
};

}  // namespace

double Body::reach() const {
  switch (kind) {
  case Kind::sphere: return size.x;
  case Kind::capsule: return size.x + size.y / 2;
  case Kind::box: return length(size) / 2;
  case Kind::cylinder:
  case Kind::cone: return std::sqrt(size.x * size.x + size.y * size.y / 4);
  case Kind::ellipsoid: return std::max({size.x, size.y, size.z});
  case Kind::half_space:
  case Kind::mesh: return 0;
  case Kind::hull:
  case Kind::triangle: break;
  }
  double reach = 0;
  for (const Vec3d& p : corners->points) reach = std::max(reach, length(p));
  return reach;
}

double Pair::size() const { return std::max(a.reach(), b.reach()); }

namespace {

std::vector<Pair> half_touching(Kind a, Kind b, std::size_t count, double scale, const MakeTouching& make_touching,
                                Bodies& bodies, Random& random) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair{bodies.next(a), bodies.next(b)};
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

}  // namespace

std::vector<Pair> make_pairs(Kind a, Kind b, std::size_t count, double scale, const MakeTouching& make_touching,
                             std::size_t different) {
  Random random(1 + static_cast<std::uint64_t>(a) * kind_count + static_cast<std::uint64_t>(b));
  Bodies bodies(scale, different, random);
  return half_touching(a, b, count, scale, make_touching, bodies, random);
}

std::vector<Pair> make_hull_pairs(std::size_t vertices, std::size_t count, const MakeTouching& make_touching,
                                  std::size_t different) {
  Random random(23 + vertices);
  Bodies bodies(1, different, random, vertices);
  return half_touching(Kind::hull, Kind::hull, count, 1, make_touching, bodies, random);
}

namespace {

/// The distance of the bumpy ball's surface from its centre, in a direction: waves by Chebyshev's polynomials, which
/// need no function that differs between libraries.
double bumpy_radius(const Vec3d& direction) {
  const auto wave = [](int order, double x) {
    double before = 1, now = x;
    for (int i = 1; i < order; ++i) {
      const double next = 2 * x * now - before;
      before = now;
      now = next;
    }
    return now;
  };
  return 10 * (1 + 0.01 * wave(15, direction.x) * wave(12, direction.y));
}

/// An octahedron each of whose sides is cut into as many triangles as the square of `cuts`, blown up to the bumpy ball.
Corners bumpy_ball(int cuts) {
  Corners mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto number_of = [&](const std::array<int, 3>& grid) {
    const auto [at, is_new] = numbers.try_emplace(grid, static_cast<int>(mesh.points.size()));
    if (is_new) {
      const Vec3d d = normalized(Vec3d{double(grid[0]), double(grid[1]), double(grid[2])});
      mesh.points.push_back(as_float(d * bumpy_radius(d)));
    }
    return at->second;
  };
  for (int side = 0; side < 8; ++side) {
    const int x = side & 1 ? -1 : 1, y = side & 2 ? -1 : 1, z = side & 4 ? -1 : 1;
    const auto at = [&](int i, int j) { return number_of({x * i, y * j, z * (cuts - i - j)}); };
    const auto add = [&](int a, int b, int c) {
      mesh.faces.push_back(x * y * z > 0 ? std::array{a, b, c} : std::array{a, c, b});
    };
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; i + j < cuts; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < cuts) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return mesh;
}

double least_half_edge(const Body& body) {
  const Vec3d& s = body.size;
  switch (body.kind) {
  case Kind::box: return std::min({s.x, s.y, s.z}) / 2;
  case Kind::hull: return body.reach() / 2;
  default: return s.x;
  }
}

}  // namespace

std::vector<Pair> make_on_mesh(Kind kind, std::size_t count, std::size_t different) {
  Random random(29 + static_cast<std::uint64_t>(kind));
  Bodies bodies(1, different, random);
  Body mesh{Kind::mesh};
  mesh.corners = std::make_shared<const Corners>(bumpy_ball(94));
  mesh.pose = as_float(Posed{random.in_cube(2), random.rotation()});
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair{bodies.next(kind), mesh};
    const Vec3d direction = random.direction();
    const double away = bumpy_radius(direction) + random.number(-0.5, 1.5) * least_half_edge(pair.a);
    pair.a.pose.translation = as_float(transform(mesh.pose, direction * away));
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<Pair> make_stacked(std::size_t count) {
  constexpr double degree = 0.017453292519943295;
  Random random(3);
  const auto box = [&] {
    Body body{Kind::box};
    body.size = as_float(Vec3d{random.number(0.4, 2), random.number(0.4, 2), random.number(0.4, 2)});
    return body;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair{box(), box()};
    // Half the angle is half the vector part of the quaternion, to a part in ten thousand at a degree.
    const double turn = random.number(0, 1.5707963267948966), lean = random.number(0, degree) / 2;
    const double toward = random.number(0, 1) * 6.283185307179586;
    const Quatd tilt = normalized(Quatd{lean * std::cos(toward), 0, lean * std::sin(toward), 1});
    const Quatd yaw{0, std::sin(turn / 2), 0, std::cos(turn / 2)};
    // The centre of A stands over the face of B.
    const Vec3d above = Vec3d{random.number(-0.5, 0.5) * pair.b.size.x,
                              (pair.a.size.y + pair.b.size.y) / 2 + random.number(-0.02, 0.01),
                              random.number(-0.5, 0.5) * pair.b.size.z};
    pair.b.pose = {random.in_cube(2), random.rotation()};
    pair.a.pose = as_float(Posed{pair.b.pose.translation + rotate(pair.b.pose.rotation, above),
                                 normalized(pair.b.pose.rotation * (tilt * yaw))});
    pair.b.pose = as_float(pair.b.pose);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<Pair> make_ways(Kind kind, std::size_t count, std::size_t different) {
  Random random(11);
  Bodies bodies(1, different, random);
  std::vector<Pair> ways;
  for (std::size_t i = 0; i < count; ++i) {
    Pair way{bodies.next(kind), bodies.next(kind)};
    const double apart = way.a.reach() + way.b.reach();
    const Vec3d from = way.b.pose.translation + random.direction() * (1.5 * apart);
    way.a.pose.translation = as_float(from);
    way.motion = as_float((way.b.pose.translation + random.in_cube(1.1 * apart) - from) * 2.0);
    ways.push_back(std::move(way));
  }
  return ways;
}

std::vector<Pair> make_rays(Kind kind, std::size_t count, std::size_t different) {
  Random random(17);
  Bodies bodies(1, different, random);
  std::vector<Pair> rays;
  for (std::size_t i = 0; i < count; ++i) {
    Pair ray{bodies.next(kind), Body{Kind::sphere, {0.01, 0, 0}}};
    const double reach = ray.a.reach();
    const Vec3d from = ray.a.pose.translation + random.direction() * (3 * reach);
    ray.b.pose.translation = as_float(from);
    ray.motion = as_float((ray.a.pose.translation + random.in_cube(0.75 * reach) - from) * 2.0);
    rays.push_back(std::move(ray));
  }
  return rays;
}

}  // namespace graze::bench
