// Random shapes of the plane with a support function of their own in extended precision, and the signed distance that
// follows from it: the largest gap over all directions, which is the distance of shapes that are apart and minus the
// depth of those that overlap. Nothing of what it checks takes part.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "graze/plane/cast.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {

using Wide = long double;
using WideSupport =
    std::function<Wide(Wide, Wide)>;  ///< how far the shape reaches along a unit vector, in its own frame

template <class T>
struct Figure {
  Shape<T> shape;
  WideSupport reach;
};

inline Wide reach_of_points(const std::vector<std::pair<Wide, Wide>>& points, Wide x, Wide y) {
  Wide most = points[0].first * x + points[0].second * y;
  for (const auto& p : points) most = std::max(most, p.first * x + p.second * y);
  return most;
}

/// A support function of the user's own: an ellipse off its origin.
template <class T>
class ShiftedEllipse final : public SupportFunction<T> {
 public:
  ShiftedEllipse(const Vec2<T>& center, const Vec2<T>& radii) : center_(center), radii_(radii) {}
  Vec2<T> support(const Vec2<T>& d) const override {
    const Vec2<T> s = normalized(Vec2<T>{radii_.x * d.x, radii_.y * d.y}, Vec2<T>{});
    return center_ + Vec2<T>{radii_.x * s.x, radii_.y * s.y};
  }

 private:
  Vec2<T> center_, radii_;
};

inline constexpr int figure_kinds = 8;

/// A figure of the given kind, about as large as `scale`.
template <class T>
Figure<T> random_figure(int kind, double scale, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return static_cast<T>(scale * std::uniform_real_distribution<double>(low, high)(random));
  };
  const T rounding = random() % 3 == 0 ? uniform(0, 0.3) : T(0);
  const auto rounded = [rounding](WideSupport core) -> WideSupport {
    return [core, rounding](Wide x, Wide y) { return core(x, y) + Wide(rounding); };
  };
  const auto of_points = [&](auto shape, std::vector<std::pair<Wide, Wide>> points) {
    return Figure<T>{Shape<T>(shape, rounding),
                     rounded([points](Wide x, Wide y) { return reach_of_points(points, x, y); })};
  };
  switch (kind) {
  case 0: {
    const T r = uniform(0.1, 1);
    return {Shape<T>(Circle<T>(r), rounding), rounded([r](Wide, Wide) { return Wide(r); })};
  }
  case 1: {
    const T w = random() % 6 ? uniform(0.2, 2) : T(0), h = uniform(0.2, 2);
    const Wide x = Wide(w) / 2, y = Wide(h) / 2;
    return of_points(Box<T>({w, h}), {{x, y}, {-x, y}, {x, -y}, {-x, -y}});
  }
  case 2: {
    const T h = uniform(0, 2), r = uniform(0, 0.7);
    return {Shape<T>(Capsule<T>(h, r), rounding),
            rounded([h, r](Wide, Wide y) { return std::abs(y) * Wide(h) / 2 + Wide(r); })};
  }
  case 3: {
    const T h = uniform(0, 2), low = uniform(0, 0.7), high = uniform(0, 0.7);
    return {Shape<T>(Capsule<T>(h, low, high), rounding), rounded([h, low, high](Wide, Wide y) {
              return std::max(Wide(low) - y * Wide(h) / 2, Wide(high) + y * Wide(h) / 2);
            })};
  }
  case 4: {
    const Vec2<T> a{uniform(-1, 1), uniform(-1, 1)}, b{uniform(-1, 1), uniform(-1, 1)};
    return of_points(Segment<T>(a, b), {{a.x, a.y}, {b.x, b.y}});
  }
  case 5: {
    std::vector<Vec2<T>> points(1 + random() % 24);
    for (Vec2<T>& p : points) p = {uniform(-1, 1), uniform(-1, 1)};
    std::vector<std::pair<Wide, Wide>> wide;
    for (const Vec2<T>& p : points) wide.push_back({p.x, p.y});
    return of_points(ConvexPolygon<T>(points), wide);
  }
  case 6: {
    const Vec2<T> r{uniform(0.05, 1), uniform(0.05, 1)};
    return {Shape<T>(Ellipse<T>(r), rounding), rounded([r](Wide x, Wide y) {
              return std::sqrt(Wide(r.x) * Wide(r.x) * x * x + Wide(r.y) * Wide(r.y) * y * y);
            })};
  }
  default: {
    const Vec2<T> c{uniform(-0.3, 0.3), uniform(-0.3, 0.3)}, r{uniform(0.05, 1), uniform(0.05, 1)};
    return {Shape<T>(UserConvex<T>(std::make_shared<ShiftedEllipse<T>>(c, r)), rounding),
            rounded([c, r](Wide x, Wide y) {
              return Wide(c.x) * x + Wide(c.y) * y +
                     std::sqrt(Wide(r.x) * Wide(r.x) * x * x + Wide(r.y) * Wide(r.y) * y * y);
            })};
  }
  }
}

template <class T>
Pose2<T> random_pose(double scale, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double x = uniform(random), y = uniform(random);
  // Some upright and in line, so that edges are parallel.
  const double angle = random() % 4 == 0 ? 1.5707963267948966 * double(random() % 4) : 4 * uniform(random);
  return {{static_cast<T>(2 * scale * x), static_cast<T>(2 * scale * y)}, Rot2<T>::from_angle(static_cast<T>(angle))};
}

/// A pose in extended precision, with a rotation of unit length.
struct WidePose {
  Wide x = 0, y = 0, cosine = 1, sine = 0;
};

template <class T>
WidePose wide(const Pose2<T>& pose) {
  const Wide c = pose.rotation.cosine, s = pose.rotation.sine, l = std::sqrt(c * c + s * s);
  return {pose.translation.x, pose.translation.y, c / l, s / l};
}

/// The separation of two placed figures along a unit vector, as a function of its components.
template <class T>
auto separation_of(const Figure<T>& a, const WidePose& at_a, const Figure<T>& b, const WidePose& at_b) {
  return [&a, &b, at_a, at_b](Wide x, Wide y) {
    return (at_b.x - at_a.x) * x + (at_b.y - at_a.y) * y -
           a.reach(at_a.cosine * x + at_a.sine * y, at_a.cosine * y - at_a.sine * x) -
           b.reach(-(at_b.cosine * x + at_b.sine * y), -(at_b.cosine * y - at_b.sine * x));
  };
}
template <class T>
auto separation_of(const Figure<T>& a, const Pose2<T>& pose_a, const Figure<T>& b, const Pose2<T>& pose_b) {
  return separation_of(a, wide(pose_a), b, wide(pose_b));
}

/// The signed distance of two placed figures, by a sweep over directions and a search about each that may be best.
template <class T>
Wide swept_distance(const Figure<T>& a, const WidePose& at_a, const Figure<T>& b, const WidePose& at_b) {
  const auto along = separation_of(a, at_a, b, at_b);
  const auto gap = [&](Wide angle) { return along(std::cos(angle), std::sin(angle)); };
  constexpr int samples = 720;
  const Wide step = 2 * std::acos(Wide(-1)) / samples;
  std::vector<Wide> value(samples);
  for (int i = 0; i < samples; ++i) value[i] = gap(step * i);
  const Wide most = *std::max_element(value.begin(), value.end());
  const Wide between = std::hypot(at_b.x - at_a.x, at_b.y - at_a.y);
  const Wide change = 4 * step * (Wide(extent(a.shape) + extent(b.shape)) + between);
  Wide best = most;
  for (int i = 0; i < samples; ++i) {
    if (value[i] < most - change || value[i] < value[(i + 1) % samples] ||
        value[i] < value[(i + samples - 1) % samples])
      continue;
    Wide low = step * (i - 1), high = step * (i + 1);
    for (int k = 0; k < 100; ++k) {
      const Wide third = (high - low) / 3;
      if (gap(low + third) < gap(high - third))
        low += third;
      else
        high -= third;
    }
    best = std::max(best, gap((low + high) / 2));
  }
  return best;
}

template <class T>
Wide swept_distance(const Figure<T>& a, const Pose2<T>& pose_a, const Figure<T>& b, const Pose2<T>& pose_b) {
  return swept_distance(a, wide(pose_a), b, wide(pose_b));
}

}  // namespace graze::plane
