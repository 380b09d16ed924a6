// Bodies of the plane that slide over floors made of pieces, and how often the seams are felt.
//
// A floor is the line y = 0 within 5 of the origin in its own frame, in pieces of many lengths: chains, solid polygons
// that are cut, and compounds of chains end to end and of tiles, some of them rounded or within further compounds. A
// body slides along it, some ten thousandths of a radian tilted, its lowest point 20 mm deep to 5 mm above; a step is
// up to 20 mm, some to where a side stands right over a seam. What it has to meet is a half-plane: its points along its
// normal. Whatever else is told is a bump.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "graze/plane/query.hpp"

namespace graze::plane::slides {

using Random = std::mt19937_64;
inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

inline constexpr double reach = 5;         ///< of floors, to both sides
inline constexpr double most_lean = 1e-3;  ///< of a normal, in radians: more is a bump
inline constexpr double most_off = 1e-4;   ///< of points, which are searched for on curved bodies
inline constexpr double margin = 0.01;     ///< up to which points are asked for

template <class T>
struct Floor {
  const char* name;
  Shape<T> shape;
  std::vector<double> seams{};
};
template <class T>
struct Slider {
  const char* name;
  Shape<T> shape;
  double turn = 0;  ///< in which it stands
};

/// Where pieces end, from right to left: above a chain that runs so is its front.
inline std::vector<double> random_seams(Random& random, double least, double most) {
  std::vector<double> x{reach};
  while (x.back() > -reach) x.push_back(std::max(-reach, x.back() - uniform(random, least, most)));
  return x;
}
/// Beside each of some another one, as near as tools leave them.
inline std::vector<double> sliver_seams() {
  std::vector<double> x;
  for (int i = 0; i <= 2 * int(reach); ++i) {
    x.push_back(reach - i);
    if (i < 2 * int(reach)) x.push_back(reach - i - 0.01 * std::pow(0.3, i % 6));
  }
  return x;
}

template <class T>
std::vector<Vec2<T>> on_line(const std::vector<double>& seams) {
  std::vector<Vec2<T>> points;
  for (const double x : seams) points.push_back({static_cast<T>(x), T(0)});
  return points;
}
/// A comb with its back up, which is cut into many pieces below the line.
template <class T>
Shape<T> comb() {
  std::vector<Vec2<T>> points{{T(reach), T(0)}, {T(-reach), T(0)}};
  for (int i = 0; i < 2 * int(reach); ++i) {
    const T x = T(-reach) + T(i);
    const T deep = T(-1) - T(i % 3) / T(2);
    points.push_back({x, deep}), points.push_back({x + T(0.4), deep}), points.push_back({x + T(0.6), T(-0.5)});
  }
  points.push_back({T(reach), T(-1)});
  return Polygon<T>(points);
}

/// Chains of up to four segments, each of which begins where another ends.
template <class T>
Shape<T> chains_end_to_end(const std::vector<double>& seams, Random& random) {
  std::vector<Placed<T>> chains;
  for (std::size_t i = 0; i + 1 < seams.size();) {
    const std::size_t end = std::min(seams.size() - 1, i + 1 + random() % 4);
    chains.push_back(
        {Chain<T>(on_line<T>({seams.begin() + std::ptrdiff_t(i), seams.begin() + std::ptrdiff_t(end) + 1})), {}});
    i = end;
  }
  return Compound<T>(chains);
}

/// A tile whose core lies between two places and whose rounding reaches up to the line.
template <class T>
Placed<T> tile(double right, double left, double rounding) {
  const double width = right - left, height = 0.5;
  return {{Box<T>({static_cast<T>(width), static_cast<T>(height)}), static_cast<T>(rounding)},
          {{static_cast<T>((left + right) / 2), static_cast<T>(-rounding - height / 2)}, {}}};
}
template <class T>
std::vector<Placed<T>> tiles(const std::vector<double>& seams, double rounding) {
  std::vector<Placed<T>> all;
  for (std::size_t i = 0; i + 1 < seams.size(); ++i) all.push_back(tile<T>(seams[i], seams[i + 1], rounding));
  return all;
}
/// Tiles in compounds of up to three, some of these in another one.
template <class T>
Shape<T> nested_tiles(const std::vector<double>& seams, double rounding, Random& random) {
  const std::vector<Placed<T>> all = tiles<T>(seams, rounding);
  std::vector<Placed<T>> groups;
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t end = std::min(all.size(), i + 1 + random() % 3);
    Shape<T> group =
        Compound<T>(std::vector<Placed<T>>(all.begin() + std::ptrdiff_t(i), all.begin() + std::ptrdiff_t(end)));
    if (random() % 2 == 0) group = Compound<T>(std::vector<Placed<T>>{{group, {}}});
    groups.push_back({group, {}});
    i = end;
  }
  return Compound<T>(groups);
}
template <class T>
std::vector<Floor<T>> floors(Random& random) {
  const std::vector<double> any = random_seams(random, 0.05, 1.5), fine = random_seams(random, 0.01, 0.05),
                            sliver = sliver_seams();
  std::vector<double> backward = any;
  std::reverse(backward.begin(), backward.end());
  return {{"chain", Chain<T>(on_line<T>(any)), any},
          {"chain of one side", Chain<T>(on_line<T>(any), false, ChainSides::one), any},
          {"chain that runs back", Chain<T>(on_line<T>(backward)), any},
          {"fine chain", Chain<T>(on_line<T>(fine)), fine},
          {"chain with slivers", Chain<T>(on_line<T>(sliver)), sliver},
          {"comb, a solid polygon", comb<T>(), {-3, -2, -1, 0, 1, 2, 3}},
          {"chains end to end", chains_end_to_end<T>(any, random), any},
          {"fine chains end to end", chains_end_to_end<T>(fine, random), fine},
          {"rounded tiles", Compound<T>(tiles<T>(any, 0.1)), any},
          {"nested tiles", nested_tiles<T>(any, 0, random), any},
          {"nested rounded tiles", nested_tiles<T>(any, 0.1, random), any}};
}

template <class T>
std::vector<Slider<T>> sliders() {
  const auto number = [](double x) { return static_cast<T>(x); };
  /// On one of its edges.
  const auto regular = [&](int count, double radius) {
    std::vector<Vec2<T>> points;
    for (int i = 0; i < count; ++i) {
      const double angle = std::numbers::pi * ((2 * i + 1.0) / count - 0.5);
      points.push_back({number(radius * std::cos(angle)), number(radius * std::sin(angle))});
    }
    return points;
  };
  const ConvexPolygon<T> hexagon(regular(6, 0.5)), many(regular(20, 0.6));
  const std::vector<Vec2<T>> triangle{{number(-0.5), number(-0.3)}, {number(0.4), number(-0.3)}, {number(0.1), T(1)}};
  return {{"box", Box<T>({T(1), T(1)})},
          {"small box", Box<T>({number(0.1), number(0.1)})},
          {"rounded box", {Box<T>({T(1), number(0.6)}), number(0.1)}},
          {"circle", Circle<T>(number(0.5))},
          {"lying capsule", Capsule<T>(number(0.8), number(0.2)), std::numbers::pi / 2},
          {"standing capsule", Capsule<T>(number(0.8), number(0.2))},
          {"triangle", ConvexPolygon<T>(triangle)},
          {"hexagon", hexagon},
          {"rounded hexagon", {hexagon, number(0.05)}},
          {"polygon of 20", many},
          {"ellipse", Ellipse<T>({number(0.5), number(0.3)})},
          {"tapered capsule", Capsule<T>(number(0.6), number(0.3), number(0.1))}};
}

/// Poses, and those of them with a normal that leans, without any contact, or with other points than a half-plane has.
struct Faults {
  std::size_t poses = 0, leaning = 0, nothing = 0, other = 0;
  std::size_t all() const { return leaning + nothing + other; }
};

/// Whether the points are those on a half-plane, in any order; of more than two manifolds they are not.
template <class T>
bool same_points(const Manifolds<T>& found, const Manifolds<T>& expected) {
  if (found.size() != expected.size()) return false;
  if (found.empty()) return true;
  const auto &there = found[0].points, &points = expected[0].points;
  if (there.size() != points.size()) return false;
  return std::all_of(points.begin(), points.end(), [&](const ContactPoint<T>& p) {
    return std::any_of(there.begin(), there.end(),
                       [&](const ContactPoint<T>& q) { return double(length(p.a - q.a)) <= most_off; });
  });
}

/// Slides a body for so many poses. `report(pose in the floor's frame)` is told of each at fault.
template <class T, class Report>
Faults slide(const Floor<T>& floor, const Slider<T>& slider, const Pose2<T>& frame, std::size_t poses, Random& random,
             const Report& report) {
  Faults faults;
  const Shape<T> ground = HalfPlane<T>();
  const Vec2<T> up = rotate(frame.rotation, Vec2<T>{T(0), T(1)});
  double x = -3.5, tilt = 0, height = 0;
  Manifolds<T> found, expected;
  for (std::size_t i = 0; i < poses; ++i) {
    if (i % 256 == 0) tilt = i % 3 == 0 ? 0 : uniform(random, -2e-4, 2e-4), height = uniform(random, -0.02, 0.005);
    x += uniform(random, 0, 0.02);
    if (x > 3.5) x = -3.5;
    const Rot2<T> turn = Rot2<T>::from_angle(static_cast<T>(slider.turn + tilt));
    const Aabb2<T> box = bounds(slider.shape, Pose2<T>{{}, turn});
    double at = x;
    if (random() % 4 == 0) {
      const double side = random() % 2 == 0 ? double(box.lower.x) : double(box.upper.x);
      at = *std::min_element(floor.seams.begin(), floor.seams.end(), [&](double s, double t) {
        return std::abs(s - x - side) < std::abs(t - x - side);
      }) - side;
      if (std::abs(at) > 3.6) at = x;
    }
    const Pose2<T> own{{static_cast<T>(at), static_cast<T>(height) - box.lower.y}, turn};
    const Pose2<T> pose = compose(frame, own);
    found.clear(), expected.clear();
    contacts(floor.shape, frame, slider.shape, pose, static_cast<T>(margin), found);
    contacts(ground, frame, slider.shape, pose, static_cast<T>(margin), expected);
    ++faults.poses;
    const bool leaning = std::any_of(found.begin(), found.end(), [&](const Manifold<T>& m) {
      return !(double(length(m.normal - up)) <= most_lean);
    });
    const bool nothing = found.empty() && !expected.empty();
    const bool other = !leaning && !nothing && !same_points(found, expected);
    faults.leaning += leaning, faults.nothing += nothing, faults.other += other;
    if (leaning || nothing || other) report(own);
  }
  return faults;
}

}  // namespace graze::plane::slides
