#include "narrow/depth/ball_hulls.hpp"

#include <array>
#include <limits>

#include "narrow/core/minkowski.hpp"

namespace graze {

namespace {

/// A ball of the difference B - A, and the two balls whose difference it is.
struct Term {
  Vec3d center;
  double radius;
  std::size_t a, b;

  double along(const Vec3d& n) const { return dot(center, n) - radius; }
};

class DifferenceOfHulls {
 public:
  DifferenceOfHulls(const BallHull& a, const BallHull& b) : a_(a), b_(b) {
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        term_[2 * i + j] = {b.ball[j].center - a.ball[i].center, b.ball[j].radius + a.ball[i].radius, i, j};
    Vec3d other;
    tangents_at(unit(term_[3].center - term_[0].center), across_, other);
    for (std::size_t i = 0; i < 4; ++i) {
      try_one(term_[i]);
      for (std::size_t j = i + 1; j < 4; ++j) {
        try_two(term_[i], term_[j]);
        for (std::size_t k = j + 1; k < 4; ++k) try_three(term_[i], term_[j], term_[k]);
      }
    }
  }

  CoreDistance<double> answer() const {
    Weights best = least_residual();
    Vec3d on_a{}, on_b{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Ball &a = a_.ball[term_[i].a], &b = b_.ball[term_[i].b];
      on_a += (a.center + normal_ * a.radius) * best.of[i];
      on_b += (b.center - normal_ * b.radius) * best.of[i];
    }
    const Vec3d middle = (on_a + on_b) * 0.5, half = normal_ * (distance_ * 0.5);
    return {distance_, normal_, middle - half, middle + half};
  }

 private:
  /// Weights of the terms' support points in the point of the difference that is the answer, and the squared distance
  /// of that point from the line along the normal.
  struct Weights {
    std::array<double, 4> of{};
    double residual = std::numeric_limits<double>::infinity();
  };

  void try_direction(const Vec3d& n) {
    double least = term_[0].along(n);
    for (std::size_t i = 1; i < 4; ++i) least = graze::least(least, term_[i].along(n));
    if (least > distance_) distance_ = least, normal_ = n;
  }

  void try_one(const Term& t) { try_direction(unit(t.center, across_)); }

  /// Tries the directions where both terms are equal and largest. Where the origin lies on the line through both
  /// centres, every point of the circle is equally good for the two: then those toward and away from the others'
  /// centres are tried.
  void try_two(const Term& p, const Term& q) {
    const Vec3d way = p.center - q.center;
    const double l = length(way);
    if (!(l > 0)) return;
    const Vec3d axis = way / l;
    const double height = (p.radius - q.radius) / l;
    if (!(height * height <= 1)) return;
    const double out = std::sqrt(1 - height * height);
    Vec3d u, v;
    tangents_at(axis, u, v);
    const auto beside = [&](const Term& t) { return u * dot(t.center, u) + v * dot(t.center, v); };
    const Vec3d toward = beside(p);
    try_direction(axis * height + unit(toward, u) * out);
    if (length(toward) > equal_within * max_abs(p.center)) return;
    for (const Term& t : term_) {
      const Vec3d side = unit(beside(t), v);
      try_direction(axis * height + side * out);
      try_direction(axis * height - side * out);
    }
  }

  /// Tries the directions where all three terms are equal: two points of the sphere, on the line normal to the plane of
  /// the centres.
  void try_three(const Term& p, const Term& q, const Term& r) {
    const Vec3d first = p.center - q.center, second = p.center - r.center, normal = cross(first, second);
    const double squared = length_squared(normal);
    if (!(squared > 0)) return;
    const Vec3d in_plane =
        (cross(second, normal) * (p.radius - q.radius) + cross(normal, first) * (p.radius - r.radius)) / squared;
    const double left = 1 - length_squared(in_plane);
    if (!(left >= 0)) return;
    const Vec3d off = unit(normal) * std::sqrt(left);
    try_direction(unit(in_plane + off));
    try_direction(unit(in_plane - off));
  }

  /// Among the terms that are least along the normal, within rounding, the mixture whose point lies on the normal's
  /// line: of one, two or three terms, which suffice in the two dimensions across the normal (Carathéodory 1907).
  Weights least_residual() const {
    Vec3d u, v;
    tangents_at(normal_, u, v);
    double reach = 0;
    for (const Term& t : term_) reach = greatest(reach, max_abs(t.center) + t.radius);
    std::array<std::pair<double, double>, 4> at;
    std::array<bool, 4> active;
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] = {dot(term_[i].center, u), dot(term_[i].center, v)};
      active[i] = term_[i].along(normal_) - distance_ <= equal_within * reach;
    }
    Weights best;
    const auto take = [&](std::size_t i, double wi, std::size_t j, double wj, std::size_t k, double wk) {
      const double x = at[i].first * wi + at[j].first * wj + at[k].first * wk,
                   y = at[i].second * wi + at[j].second * wj + at[k].second * wk, off = x * x + y * y;
      if (!(off < best.residual)) return;
      best = {{}, off};
      best.of[i] += wi, best.of[j] += wj, best.of[k] += wk;
    };
    for (std::size_t i = 0; i < 4; ++i) {
      if (!active[i]) continue;
      take(i, 1, i, 0, i, 0);
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (!active[j]) continue;
        const double x = at[j].first - at[i].first, y = at[j].second - at[i].second, squared = x * x + y * y;
        if (squared > 0) {
          const double part = clamp(-(at[i].first * x + at[i].second * y) / squared, 0.0, 1.0);
          take(i, 1 - part, j, part, j, 0);
        }
        for (std::size_t k = j + 1; k < 4; ++k) {
          if (!active[k]) continue;
          const auto area = [&](std::size_t p, std::size_t q) {
            return at[p].first * at[q].second - at[p].second * at[q].first;
          };
          const double wi = area(j, k), wj = area(k, i), wk = area(i, j), sum = wi + wj + wk;
          if (wi * sum >= 0 && wj * sum >= 0 && wk * sum >= 0 && sum != 0) take(i, wi / sum, j, wj / sum, k, wk / sum);
        }
      }
    }
    return best;
  }

  /// Terms and positions this close, relative to the largest coordinate, are equal: some tens of roundings.
  static constexpr double equal_within = 64 * std::numeric_limits<double>::epsilon();

  const BallHull &a_, &b_;
  Term term_[4];
  Vec3d across_;  ///< a direction perpendicular to the line from one term to its opposite
  double distance_ = -std::numeric_limits<double>::infinity();
  Vec3d normal_{0, 1, 0};
};

}  // namespace

template <class T>
std::optional<BallHull> ball_hull_of(const Shape<T>& shape) {
  if (const auto* capsule = shape.template as<Capsule<T>>()) {
    const auto half = static_cast<double>(capsule->half_height()), core = static_cast<double>(capsule->core_radius());
    return BallHull{{{{0, -half, 0}, static_cast<double>(capsule->radius_bottom()) - core},
                     {{0, half, 0}, static_cast<double>(capsule->radius_top()) - core}}};
  }
  if (const auto* segment = shape.template as<LineSegment<T>>())
    return BallHull{{{converted<double>(segment->point(0)), 0}, {converted<double>(segment->point(1)), 0}}};
  return std::nullopt;
}

CoreDistance<double> distance_of(const BallHull& a, const BallHull& b) { return DifferenceOfHulls(a, b).answer(); }

template std::optional<BallHull> ball_hull_of(const Shape<float>&);
template std::optional<BallHull> ball_hull_of(const Shape<double>&);

}  // namespace graze
