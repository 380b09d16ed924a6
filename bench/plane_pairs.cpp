#include "plane_pairs.hpp"

#include <algorithm>

#include "measure.hpp"

namespace graze::plane {

namespace {

/// PCG32 (O'Neill 2014, "PCG: a family of simple fast space-efficient statistically good algorithms").
class Pcg {
 public:
  Pcg() {
    next();
    next();
  }
  double between(double low, double high) { return low + (high - low) * (next() >> 8) * 0x1p-24; }

 private:
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + 1442695040888963407u;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27),
               turn = static_cast<std::uint32_t>(old >> 59);
    return (mixed >> turn) | (mixed << ((32 - turn) & 31));
  }
  std::uint64_t state_ = 42;
};

Item make(Kind kind, Pcg& random) {
  const double h = random.between(0.25, 1), w = random.between(0.25, 1);
  const auto number = [](double x) { return static_cast<float>(x); };
  switch (kind) {
  case Kind::circle: return {Circle<float>(number(h)), h, {h, h}, {}};
  case Kind::capsule: return {Capsule<float>(number(2 * h), number(w / 2)), h + w / 2, {h, w}, {}};
  case Kind::box: return {Box<float>({number(2 * h), number(2 * w)}), std::hypot(h, w), {h, w}, {}};
  case Kind::rounded_box:
    return {{Box<float>({number(2 * h), number(2 * w)}), 0.1f}, std::hypot(h, w) + 0.1, {h, w}, {}};
  case Kind::segment: return {Segment<float>({number(-h), 0}, {number(h), 0}), h, {h, 0}, {}};
  case Kind::hexagon:
  case Kind::octagon: break;
  }
  const int count = kind == Kind::hexagon ? 6 : 8;
  const double step = 6.283185307179586 / count, start = random.between(0, step);
  std::vector<Vec2f> points;
  for (int i = 0; i < count; ++i) {
    const double angle = start + step * (i + random.between(-0.2, 0.2));
    points.push_back({number(h * std::cos(angle)), number(h * std::sin(angle))});
  }
  const ConvexPolygon<float> polygon(points);
  const auto vertices = polygon.vertices();
  return {polygon, h, {h, h}, {vertices.begin(), vertices.end()}};
}

}  // namespace

Pairs make_pairs(Kind kind_a, Kind kind_b, double spread, bool stacked, std::size_t count) {
  Pcg random;
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const Item a = make(kind_a, random), b = make(kind_b, random);
    const double apart = random.between(0, spread) * (a.radius + b.radius), bearing = random.between(-3.14159, 3.14159);
    const Vec2d offset{random.between(-10, 10), random.between(-10, 10)};
    double angle_a = random.between(-3.14159, 3.14159), angle_b = random.between(-3.14159, 3.14159);
    const double t = random.between(-3, 3), s = random.between(-3, 3), turn = random.between(-0.7, 0.7);
    Vec2d between{apart * std::cos(bearing), apart * std::sin(bearing)};
    if (stacked) {
      angle_b = angle_a + turn / 0.7 * 0.01;
      const Vec2d own{t / 6 * (a.half.x + b.half.x), a.half.y + b.half.y + s / 3 * 0.005};
      between = {std::cos(angle_a) * own.x - std::sin(angle_a) * own.y,
                 std::sin(angle_a) * own.x + std::cos(angle_a) * own.y};
    }
    const auto pose = [](const Vec2d& at, double angle) {
      return Pose2f{plane::converted<float>(at), plane::converted<float>(Rot2d::from_angle(angle))};
    };
    pairs.items_a.push_back(a);
    pairs.items_b.push_back(b);
    pairs.a.push_back(a.shape);
    pairs.b.push_back(b.shape);
    pairs.pose_a.push_back(pose(offset, angle_a));
    pairs.pose_b.push_back(pose(offset + between, angle_b));
    const Vec2d along{std::cos(bearing), std::sin(bearing)}, aside{-along.y, along.x};
    pairs.start_b.push_back(pose(offset - along * 4.0 + aside * (0.6 * t), angle_b));
    pairs.motion_b.push_back({plane::converted<float>(along * 8.0), static_cast<float>(turn)});
  }
  return pairs;
}

double least_time(const Options& options, std::size_t count, std::size_t turns, const std::function<void()>& pass) {
  double best = 1e300;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const double start = bench::processor_seconds();
    for (std::size_t k = 0; k < turns; ++k) pass();
    best = std::min(best, bench::processor_seconds() - start);
  }
  return best * 1e9 / static_cast<double>(count * turns);
}

}  // namespace graze::plane
