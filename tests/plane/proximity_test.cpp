// What is near, against the distances of everything.
#include "graze/plane/proximity.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

/// Every kind of shape there is, those made of pieces among them.
template <class T>
Shape<T> any_shape(std::uint32_t kind, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random));
  };
  if (kind < figure_kinds) return random_figure<T>(static_cast<int>(kind), 1, random).shape;
  std::vector<Vec2<T>> star;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    const T reach = uniform(0.3, 1.5);
    star.push_back({reach * static_cast<T>(std::cos(angle)), reach * static_cast<T>(std::sin(angle))});
  }
  const T rounding = random() % 2 ? uniform(0, 0.2) : T(0);
  switch (kind - figure_kinds) {
  case 0: return {Polygon<T>(star), rounding};
  case 1: return {Chain<T>(star, random() % 2 == 0), rounding};
  case 2: {
    std::vector<Placed<T>> children;
    for (int i = 0; i < 4; ++i) {
      const auto child = static_cast<std::uint32_t>(random()) % (figure_kinds + 2);
      Shape<T> shape = any_shape<T>(child, random);
      children.push_back({std::move(shape), random_pose<T>(0.5, random)});
    }
    return Compound<T>(std::move(children));
  }
  default: return {HalfPlane<T>(), rounding};
  }
}
constexpr std::uint32_t all_kinds = figure_kinds + 4;

template <class T>
bool same(const Distance<T>& a, const Distance<T>& b) {
  return a.distance == b.distance && a.normal == b.normal && a.a == b.a && a.b == b.b && a.status == b.status &&
         a.error == b.error;
}

template <class T>
class PlaneProximity : public ::testing::Test {};
using ProximityScalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneProximity, ProximityScalars);

TYPED_TEST(PlaneProximity, IsWhatDistancesSay) {
  using T = TypeParam;
  std::mt19937 random(24);
  std::vector<PieceDistance<T>> near, all;
  int within_limit = 0, beyond = 0, several = 0;
  for (std::uint32_t i = 0; i < all_kinds * all_kinds * 20; ++i) {
    const std::uint32_t kind_a = i % all_kinds, kind_b = i / all_kinds % all_kinds;
    const Shape<T> a = any_shape<T>(kind_a, random), b = any_shape<T>(kind_b, random);
    const Pose2<T> at_a = random_pose<T>(1, random), at_b = random_pose<T>(1, random);
    const Distance<T> d = distance(a, at_a, b, at_b);
    const T any = static_cast<T>(std::uniform_real_distribution<double>(0, 2)(random));
    // The distance itself and its neighbours, too: the limit belongs to what is within.
    std::vector<T> limits{T(0), any, std::numeric_limits<T>::infinity()};
    if (d.distance > T(0))
      limits.insert(limits.end(), {d.distance, std::nextafter(d.distance, T(0)), std::nextafter(d.distance, T(99))});
    for (const T limit : limits) {
      const bool expected = d.distance <= limit;
      ++(expected ? within_limit : beyond);
      ASSERT_EQ(within(a, at_a, b, at_b, limit), expected) << kind_a << ' ' << kind_b << ' ' << limit;
      const auto found = distance_up_to(a, at_a, b, at_b, limit);
      ASSERT_EQ(found.has_value(), expected) << kind_a << ' ' << kind_b << ' ' << limit;
      if (found) {
        ASSERT_TRUE(same(*found, d)) << kind_a << ' ' << kind_b << ' ' << limit;
      }
    }
    all.clear(), near.clear();
    near_pieces(a, at_a, b, at_b, std::numeric_limits<T>::infinity(), all);
    near_pieces(a, at_a, b, at_b, any, near);
    std::erase_if(all, [&](const PieceDistance<T>& p) { return p.distance.distance > any; });
    ASSERT_EQ(near.size(), all.size()) << kind_a << ' ' << kind_b;
    T least = std::numeric_limits<T>::infinity();
    for (std::size_t k = 0; k < near.size(); ++k) {
      ASSERT_EQ(near[k].piece_a, all[k].piece_a);
      ASSERT_EQ(near[k].piece_b, all[k].piece_b);
      ASSERT_TRUE(same(near[k].distance, all[k].distance));
      least = std::min(least, near[k].distance.distance);
    }
    // The depth of a polygon's piece is an upper bound, of which `distance` leaves out what discs show to be too deep.
    const auto has_polygon = [](std::uint32_t kind) { return kind == figure_kinds || kind == figure_kinds + 2; };
    if (d.distance < T(0) && (has_polygon(kind_a) || has_polygon(kind_b))) {
      ASSERT_LE(least, d.distance) << kind_a << ' ' << kind_b;
    } else if (d.distance <= any) {
      ASSERT_EQ(least, d.distance) << kind_a << ' ' << kind_b;
    }
    several += near.size() > 1;
  }
  EXPECT_GT(within_limit, 5000);
  EXPECT_GT(beyond, 1000);
  EXPECT_GT(several, 200);
}

TEST(PlaneNearPieces, NameTheChildOfTheOutermostCompound) {
  const Shape<double> ball(Circle<double>(1));
  const Shape<double> two(Compound<double>({{ball, {{0, 0}, {}}}, {ball, {{10, 0}, {}}}}));
  const Shape<double> four(Compound<double>({{two, {{0, 0}, {}}}, {two, {{100, 0}, {}}}}));
  std::vector<PieceDistance<double>> near;
  near_pieces(four, {}, ball, {{110, 2.5}, {}}, 1.0, near);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].piece_a, 1u);
  EXPECT_DOUBLE_EQ(near[0].distance.distance, 0.5);
}

}  // namespace
}  // namespace graze::plane
