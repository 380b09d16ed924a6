// A scene made of a seed: a ground of one of three kinds between four walls, and bodies of any shape that fall on it.
//
// Guarantee: the same scene from every standard library. No body overlaps another or the ground when it begins.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "graze/plane/vec2.hpp"
#include "graze/shape/convex_hull.hpp"
#include "graze/shape/mesh.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {

template <class T>
class RandomScene {
 public:
  /// Bodies are `size` across, or little more. With `meshes` every third of them is a closed mesh with an inside.
  RandomScene(Simulation<T>& simulation, unsigned seed, bool meshes = false)
      : s_(simulation), random_(seed), meshes_(meshes) {
    add_ground();
    add_walls();
    const int count = 6 + static_cast<int>(random_() % 10);
    for (int i = 0; i < count; ++i) add_body(i);
  }

  const std::vector<BodyId>& bodies() const { return bodies_; }
  /// What the ground is, and where.
  const Shape<T>& ground() const { return s_.world().bodies().shapes()[ground_.index]; }
  static constexpr T half = T(4);  ///< of the floor between the walls

 private:
  T number(T low, T high) { return low + (high - low) * (static_cast<T>(random_() >> 8) / T(1 << 24)); }
  Vec3<T> vector(T low, T high) {
    const T x = number(low, high), y = number(low, high);
    return {x, y, number(low, high)};
  }
  Quat<T> rotation() {
    const Vec3<T> axis = vector(T(-1), T(1));
    return normalized(Quat<T>{axis.x, axis.y, axis.z, number(T(0.1), T(1))});
  }
  Material<T> material() {
    Material<T> m;
    m.static_friction = m.dynamic_friction = number(T(0.3), T(1));
    m.restitution = random_() % 3 == 0 ? number(T(0), T(0.8)) : T(0);
    m.rolling_friction = number(T(0.05), T(0.1));  // what rolls comes to rest by nothing else
    return m;
  }

  /// A half-space, or hills of half a body's size as a height field or as a mesh.
  void add_ground() {
    constexpr std::uint32_t across = 12;
    constexpr T spacing = T(1);
    std::vector<T> heights;
    for (std::size_t i = 0; i < across * across; ++i) heights.push_back(number(T(-0.25), T(0.25)));
    const auto shape = [&]() -> Shape<T> {
      switch (random_() % 3) {
      case 0: return HalfSpace<T>();
      case 1: return HeightField<T>(across, across, heights, spacing, spacing);
      default: break;
      }
      std::vector<Vec3<T>> points;
      std::vector<typename Mesh<T>::Index> triangles;
      const T middle = T(across - 1) / T(2);
      for (std::size_t i = 0; i < across * across; ++i)
        points.push_back({(T(i % across) - middle) * spacing, heights[i], (T(i / across) - middle) * spacing});
      for (std::uint32_t r = 0; r + 1 < across; ++r)
        for (std::uint32_t c = 0; c + 1 < across; ++c) {
          const std::uint32_t at = r * across + c;
          triangles.push_back({at, at + across, at + 1});
          triangles.push_back({at + 1, at + across, at + across + 1});
        }
      return Mesh<T>(std::move(points), std::move(triangles));
    };
    Body<T> body{shape()};
    body.fixed = true;
    ground_ = s_.add(body, {}, material());
  }

  void add_walls() {
    constexpr T high = T(40), thick = T(1);
    for (const T side : {T(-1), T(1)})
      for (const bool along_x : {true, false}) {
        const Vec3<T> size =
            along_x ? Vec3<T>{thick, high, 2 * half + 2 * thick} : Vec3<T>{2 * half + 2 * thick, high, thick};
        const Vec3<T> at = along_x ? Vec3<T>{side * (half + thick / 2), high / 2 - 1, T(0)}
                                   : Vec3<T>{T(0), high / 2 - 1, side * (half + thick / 2)};
        Body<T> wall{Box<T>(size), {at, {}}};
        wall.fixed = true;
        s_.add(wall, {}, material());
      }
  }

  Shape<T> convex() {
    switch (random_() % 7) {
    case 0: return Sphere<T>(number(T(0.2), T(0.5)));
    case 1: return Capsule<T>(number(T(0.15), T(0.3)), number(T(0.2), T(0.8)));
    case 2: return Cylinder<T>(number(T(0.3), T(0.8)), number(T(0.2), T(0.5)));
    case 3: return Cylinder<T>(number(T(0.4), T(0.8)), number(T(0.3), T(0.5)), T(0));  // a cone
    case 4: return Ellipsoid<T>(vector(T(0.2), T(0.5)));
    case 5: {
      std::vector<Vec3<T>> points;
      for (int i = 0; i < 12; ++i) points.push_back(vector(T(-0.5), T(0.5)));
      return ConvexHull<T>(points);
    }
    default: return Box<T>(vector(T(0.3), T(1)));
    }
  }
  /// A prism over an outline that is seen counter-clockwise from above, `high` and about the origin. `top`: the
  /// triangles of its upper face.
  static Mesh<T> prism(const std::vector<plane::Vec2<T>>& outline, const std::vector<typename Mesh<T>::Index>& top,
                       T high) {
    const auto n = static_cast<std::uint32_t>(outline.size());
    std::vector<Vec3<T>> points;
    for (const T y : {-high / 2, high / 2})
      for (const auto& p : outline) points.push_back({p.x, y, -p.y});
    std::vector<typename Mesh<T>::Index> triangles;
    for (const auto& t : top) {
      triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
      triangles.push_back({t[0], t[2], t[1]});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      triangles.push_back({i, next, next + n});
      triangles.push_back({i, next + n, i + n});
    }
    return Mesh<T>(std::move(points), std::move(triangles), Sides::both, true);
  }
  /// A brick, a wedge, or an angle, which is not convex.
  Mesh<T> mesh() {
    const T a = number(T(0.3), T(0.5)), b = number(T(0.3), T(0.5)), high = number(T(0.4), T(0.8));
    switch (random_() % 3) {
    case 0: return prism({{-a, -b}, {a, -b}, {a, b}, {-a, b}}, {{0, 1, 2}, {0, 2, 3}}, high);
    case 1: return prism({{-a, -b}, {a, -b}, {T(0), b}}, {{0, 1, 2}}, high);
    default: break;
    }
    return prism({{-a, -b}, {a, -b}, {a, T(0)}, {T(0), T(0)}, {T(0), b}, {-a, b}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, high);
  }
  Shape<T> shape() {
    if (meshes_ && random_() % 3 == 0) return mesh();
    switch (random_() % 8) {
    case 0: {  // a hammer, or an angle
      const Shape<T> handle = Box<T>({T(0.2), T(0.8), T(0.2)}), head = Box<T>({T(0.6), T(0.2), T(0.3)});
      return Compound<T>({{handle, {}}, {head, {{number(T(-0.2), T(0.2)), T(0.4), T(0)}, {}}}});
    }
    default: return convex();
    }
  }

  /// Four on a level, two sizes apart.
  void add_body(int i) {
    const Vec3<T> at{T(i % 2 * 2 - 1) * T(1.2), T(1.5) + T(i / 4) * T(2), T(i / 2 % 2 * 2 - 1) * T(1.2)};
    const Vec3<T> off = vector(T(-0.2), T(0.2));
    Body<T> body{shape(), {at + off, rotation()}, vector(T(-2), T(2)), vector(T(-5), T(5))};
    bodies_.push_back(s_.add(body, {}, material()));
  }

  Simulation<T>& s_;
  std::mt19937 random_;
  bool meshes_;
  BodyId ground_;
  std::vector<BodyId> bodies_;
};

}  // namespace graze::testing
