// Casts without turning in a batch have the bits of each alone, and go to the kernels but for what rounding decides.
// CMake runs these at every level of the instruction set (lanes.plane_*).
#include <gtest/gtest.h>

#include <cstring>

#include "graze/plane/batch.hpp"
#include "plane/figures.hpp"
#include "plane/pairs/cast_kernels.hpp"
#include "plane/pairs/pair_queues.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneBatchCasts : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneBatchCasts, Scalars);

/// Shapes that have vertices, rounded or not. On a `grid` all numbers are whole ones, some widths are zero and
/// edges are parallel.
template <class T>
Shape<T> random_polygon_shape(double scale, bool grid, std::mt19937& random) {
  const auto number = [&](double low, double high) {
    const double x = std::uniform_real_distribution<double>(low, high)(random);
    return static_cast<T>(scale * (grid ? std::ceil(x) : x));
  };
  const T rounding = random() % 3 == 0 ? number(0, 0.4) : T(0);
  const auto width = [&] { return grid && random() % 16 == 0 ? T(0) : number(0.2, 2); };
  switch (random() % 5) {
  case 0: return {Circle<T>(grid && random() % 8 == 0 ? T(0) : number(0.1, 1)), rounding};
  case 1: {
    const T h = width();
    return {Capsule<T>(h, random() % 4 == 0 ? T(0) : number(0.1, 0.8)), rounding};
  }
  case 2: {
    const T x = number(-1, 1), y = number(-1, 1), u = number(-1, 1);
    return {Segment<T>({x, y}, {u, number(-1, 1)}), rounding};
  }
  case 3: {
    const T w = width();
    return {Box<T>({w, width()}), rounding};
  }
  default: {
    std::vector<Vec2<T>> points(3 + random() % 6);
    const double start = std::uniform_real_distribution<double>(0, 6)(random);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = start + 6.283185307179586 * double(i) / double(points.size());
      const T x = grid ? number(-2, 2) : static_cast<T>(scale * std::cos(angle));
      points[i] = {x, grid ? number(-2, 2) : static_cast<T>(scale * std::sin(angle))};
    }
    return {ConvexPolygon<T>(points), rounding};
  }
  }
}

/// Bodies that fly at, beside and away from each other, none of which turns. On a grid some zeros are negative ones.
template <class T>
struct Flight {
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  std::vector<Velocity<T>> velocities;
  std::vector<IdPair> pairs;

  Flight(std::size_t bodies, std::size_t count, double scale, bool grid, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-6, 6);
    const auto number = [&] {
      const double x = uniform(random);
      if (grid && random() % 4 == 0) return T(-0.0);
      return static_cast<T>(scale * (grid ? std::round(x) : x));
    };
    const auto vector = [&] {
      const T x = number();
      return Vec2<T>{x, number()};
    };
    for (std::size_t i = 0; i < bodies; ++i) {
      shapes.push_back(random_polygon_shape<T>(scale, grid, random));
      Pose2<T> pose = random_pose<T>(scale, random);
      if (grid) pose.rotation = random() % 2 ? Rot2<T>{T(1), T(0)} : Rot2<T>{T(0), T(-1)};
      poses.push_back({vector(), pose.rotation});
      const Vec2<T> to_the_middle = -poses.back().translation, aside = vector() * T(grid ? 1 : 0.3);
      const Vec2<T> way = random() % 4 == 0 ? aside : to_the_middle + aside;
      velocities.push_back({random() % 32 == 0 ? Vec2<T>{} : way * T(random() % 8 == 0 ? 1000 : 1), T(0)});
    }
    for (std::size_t i = 0; i < count; ++i)
      pairs.push_back({static_cast<std::uint32_t>(random() % bodies), static_cast<std::uint32_t>(random() % bodies)});
  }
};

template <class T>
bool same_number_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T>
bool same_hit(const CastHit<T>& a, const CastHit<T>& b) {
  return same_number_bits(a.t, b.t) && same_number_bits(a.point, b.point) && same_number_bits(a.normal, b.normal) &&
         same_number_bits(a.depth, b.depth) && a.status == b.status && a.piece_a == b.piece_a && a.piece_b == b.piece_b;
}

TYPED_TEST(PlaneBatchCasts, HaveTheBitsOfEachPairAlone) {
  using T = TypeParam;
  std::mt19937 random(21);
  std::size_t met = 0, all = 0;
  for (const double scale : {1e-4, 1.0, 1e5})
    for (const bool grid : {false, true})
      for (int round = 0; round < 6; ++round) {
        const Flight<T> flight(200, 2500, scale, grid, random);
        const Bodies<T> bodies(flight.shapes, flight.poses);
        const T duration = round % 3 == 0 ? std::numeric_limits<T>::infinity() : T(1);
        std::vector<std::optional<CastHit<T>>> hits;
        cast(Batch<T>(bodies, bodies, flight.pairs), flight.velocities, flight.velocities, duration, hits);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const IdPair p = flight.pairs[i];
          const auto alone = cast(flight.shapes[p.a], flight.poses[p.a], flight.velocities[p.a], flight.shapes[p.b],
                                  flight.poses[p.b], flight.velocities[p.b], duration);
          ++all;
          met += alone.has_value();
          ASSERT_EQ(hits[i].has_value(), alone.has_value())
              << flight.shapes[p.a].name() << " and " << flight.shapes[p.b].name() << ", pair " << i;
          ASSERT_TRUE(!alone || same_hit(*hits[i], *alone))
              << flight.shapes[p.a].name() << " and " << flight.shapes[p.b].name() << ", pair " << i;
        }
      }
  EXPECT_GT(met, all / 4);
  EXPECT_LT(met, all * 3 / 4);
}

/// How many of the pairs that are apart at the start the kernels answer.
template <class T>
double known_part(const Flight<T>& flight) {
  const Bodies<T> bodies(flight.shapes, flight.poses);
  const Batch<T> batch(bodies, bodies, flight.pairs);
  const CastKernels& kernels = GRAZE_KERNEL(chosen_isa(), plane_cast_kernels)();
  PairQueues<T> queues;
  CastColumns found;
  MotionColumns motion{};
  std::size_t apart = 0, known = 0;
  const auto block = [&](const PairBlock& pairs) {
    for (std::size_t k = 0; k < pairs.count; ++k) {
      const IdPair p = batch[pairs.place[k]];
      const Vec2<T> a = flight.velocities[p.a].linear, b = flight.velocities[p.b].linear;
      motion.a[0][k] = double(a.x), motion.a[1][k] = double(a.y);
      motion.b[0][k] = double(b.x), motion.b[1][k] = double(b.y);
    }
    if (pairs.polygons)
      kernels.polygons(*pairs.polygons, motion, pairs.count, found);
    else
      kernels.entries[pairs.entry.place][pairs.entry.turned ? 1 : 0](*pairs.columns, motion, pairs.count, found);
    for (std::size_t k = 0; k < pairs.count; ++k) {
      const IdPair p = batch[pairs.place[k]];
      if (overlap(flight.shapes[p.a], flight.poses[p.a], flight.shapes[p.b], flight.poses[p.b])) continue;
      if (same_number_bits(flight.velocities[p.a].linear, flight.velocities[p.b].linear)) continue;
      ++apart;
      known += found.known[k] != 0;
    }
  };
  for (std::size_t i = 0; i < batch.size(); ++i) queues.add(batch, i, true, block);
  queues.finish(block);
  EXPECT_GT(apart, batch.size() / 2);
  return double(known) / double(apart);
}

/// Circles that graze each other, by a hair more or less than they touch: what is left out alone, as nothing presses,
/// is left out of a batch.
TYPED_TEST(PlaneBatchCasts, LeaveOutWhatSeparatesAsEachPairAlone) {
  using T = TypeParam;
  std::vector<Circle<T>> circles;
  std::vector<Pose2<T>> here, there;
  for (int i = -200; i < 200; ++i) {
    circles.emplace_back(T(1));
    here.push_back({{T(-3), T(0)}, {}});
    there.push_back({{T(0), T(2) + T(i) * T(1e-6)}, {}});
  }
  const std::vector<Velocity<T>> moving{{{T(6), T(0)}, T(0)}}, still{{}};
  const Batch<T> batch(Bodies<T>(circles, here), Bodies<T>(circles, there));
  std::size_t grazing = 0;
  for (const Separating separating : {Separating::hit, Separating::ignored}) {
    CastOptions options;
    options.separating = separating;
    std::vector<std::optional<CastHit<T>>> hits;
    cast(batch, moving, still, T(1), hits, options);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const auto alone = cast<T>(circles[i], here[i], moving[0], circles[i], there[i], still[0], T(1), options);
      ASSERT_EQ(hits[i].has_value(), alone.has_value()) << i;
      ASSERT_TRUE(!alone || same_hit(*hits[i], *alone)) << i;
      grazing += separating == Separating::hit ? alone.has_value() : 0;
    }
  }
  EXPECT_GT(grazing, circles.size() / 3);
}

TYPED_TEST(PlaneBatchCasts, GoToTheKernels) {
  using T = TypeParam;
  std::mt19937 random(22);
  EXPECT_GT(known_part(Flight<T>(400, 20000, 1, false, random)), 0.99);
  EXPECT_GT(known_part(Flight<T>(400, 20000, 1, true, random)), 0.8);
}

}  // namespace
}  // namespace graze::plane
