// A scene of the plane made of a seed: a ground of one of three kinds between two walls, and bodies of any shape that
// fall on it.
//
// Guarantee: the same scene from every standard library. No body overlaps another or the ground when it begins.
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

#include "graze/plane/simulation.hpp"

namespace graze::plane::testing {

template <class T>
class RandomScene {
 public:
  /// Bodies are `size` across, or little more.
  RandomScene(Simulation<T>& simulation, unsigned seed) : s_(simulation), random_(seed) {
    add_ground();
    add_walls();
    const int count = 6 + static_cast<int>(random_() % 10);
    for (int i = 0; i < count; ++i) add_body(i);
  }

  const std::vector<BodyId>& bodies() const { return bodies_; }
  /// The height of the ground's surface at a place between the walls.
  T ground_at(T x) const {
    const T along = (x - surface_.front().x) / spacing;
    const auto i = std::min(static_cast<std::size_t>(greatest(along, T(0))), surface_.size() - 2);
    const T part = along - T(i);
    return surface_[i].y * (T(1) - part) + surface_[i + 1].y * part;
  }
  static constexpr T half = T(4);        ///< of the floor between the walls
  static constexpr T smallest = T(0.2);  ///< no body is narrower

 private:
  static constexpr T spacing = T(1);  ///< of the ground's corners

  T number(T low, T high) { return low + (high - low) * (static_cast<T>(random_() >> 8) / T(1 << 24)); }
  Vec2<T> vector(T low, T high) {
    const T x = number(low, high);
    return {x, number(low, high)};
  }
  Rot2<T> rotation() {
    const Vec2<T> x = vector(T(-1), T(1));
    return length(x) > T(0.01) ? Rot2<T>{normalized(x).x, normalized(x).y} : Rot2<T>{};
  }
  Material<T> material() {
    Material<T> m;
    m.static_friction = m.dynamic_friction = number(T(0.3), T(1));
    m.restitution = random_() % 3 == 0 ? number(T(0), T(0.8)) : T(0);
    m.rolling_friction = number(T(0.05), T(0.1));  // what rolls comes to rest by nothing else
    return m;
  }

  /// A half-plane, or hills of half a body's size: a chain of one side or of both, or a solid with valleys.
  void add_ground() {
    constexpr int across = 12;
    const unsigned kind = random_() % 4;
    for (int i = 0; i < across; ++i)
      surface_.push_back({(T(i) - T(across - 1) / T(2)) * spacing, kind == 0 ? T(0) : number(T(-0.25), T(0.25))});
    const auto shape = [&]() -> Shape<T> {
      // The right of a chain is up where it runs to the left.
      const std::vector<Vec2<T>> leftwards(surface_.rbegin(), surface_.rend());
      switch (kind) {
      case 0: return HalfPlane<T>();
      case 1: return Chain<T>(leftwards, false, ChainSides::one);
      case 2: return Chain<T>(surface_, false, ChainSides::both);
      default: break;
      }
      std::vector<Vec2<T>> outline = leftwards;
      outline.push_back({outline.back().x, T(-2)});
      outline.push_back({outline.front().x, T(-2)});
      return Polygon<T>(outline);
    };
    Body<T> body{shape()};
    body.fixed = true;
    s_.add(body, {}, material());
  }

  void add_walls() {
    constexpr T high = T(40), thick = T(1);
    for (const T side : {T(-1), T(1)}) {
      Body<T> wall{Box<T>({thick, high}), {{side * (half + thick / 2), high / 2 - 1}, {}}};
      wall.fixed = true;
      s_.add(wall, {}, material());
    }
  }

  Shape<T> convex() {
    switch (random_() % 7) {
    case 0: return Circle<T>(number(T(0.2), T(0.5)));
    case 1: {
      const T height = number(T(0.2), T(0.8));
      return Capsule<T>(height, number(T(0.15), T(0.3)));
    }
    case 2: {  // tapered
      const T height = number(T(0.3), T(0.7)), lower = number(T(0.2), T(0.3));
      return Capsule<T>(height, lower, number(T(0.1), T(0.2)));
    }
    case 3: return Ellipse<T>(vector(T(0.2), T(0.5)));
    case 4: {
      std::vector<Vec2<T>> points{{T(-0.1), T(-0.1)}, {T(0.1), T(-0.1)}, {T(0), T(0.2)}};
      for (int i = 0; i < 6; ++i) points.push_back(vector(T(-0.5), T(0.5)));
      return ConvexPolygon<T>(points);
    }
    case 5: {
      const Vec2<T> core = vector(T(0.2), T(0.8));
      return {Box<T>(core), number(T(0.02), T(0.1))};
    }
    default: return Box<T>(vector(T(0.3), T(1)));
    }
  }
  Shape<T> shape() {
    switch (random_() % 8) {
    case 0: {  // a hammer, or an angle
      const Shape<T> handle = Box<T>({T(0.2), T(0.8)}), head = Box<T>({T(0.6), T(0.2)});
      return Compound<T>({{handle, {}}, {head, {{number(T(-0.2), T(0.2)), T(0.4)}, {}}}});
    }
    case 1: {  // a bracket, open upwards
      const T wall = number(T(0.2), T(0.3));
      return Polygon<T>(std::vector<Vec2<T>>{{T(-0.5), T(-0.4)},
                                             {T(0.5), T(-0.4)},
                                             {T(0.5), T(0.4)},
                                             {T(0.5) - wall, T(0.4)},
                                             {T(0.5) - wall, T(-0.4) + wall},
                                             {T(-0.5) + wall, T(-0.4) + wall},
                                             {T(-0.5) + wall, T(0.4)},
                                             {T(-0.5), T(0.4)}});
    }
    default: return convex();
    }
  }

  /// Two on a level, two sizes apart.
  void add_body(int i) {
    const Vec2<T> at{T(i % 2 * 2 - 1) * T(1.2), T(1.5) + T(i / 2) * T(2)};
    const Vec2<T> off = vector(T(-0.2), T(0.2));
    const Shape<T> what = shape();
    const Pose2<T> pose{at + off, rotation()};
    const Vec2<T> linear = vector(T(-2), T(2));
    const Material<T> of = material();  // before the last number, whatever the compiler's order of arguments
    bodies_.push_back(s_.add({what, pose, linear, number(T(-5), T(5))}, {}, of));
  }

  Simulation<T>& s_;
  std::mt19937 random_;
  std::vector<Vec2<T>> surface_;  ///< of the ground, from left to right
  std::vector<BodyId> bodies_;
};

}  // namespace graze::plane::testing
