// Edges and corners that a surface has, and places where two of its faces are met at once, one example each: the
// normals that a solver is to get.
#include <gtest/gtest.h>

#include <algorithm>

#include "composite/composite.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

/// A surface, as it stands and far away and turned, where no normal is free of rounding.
template <class T>
struct StandingSurface {
  Shape<T> shape;
  Pose<T> frame;

  /// Asked with the margin of a body at rest; normals as the surface's own frame sees them, from it to the body.
  std::vector<Vec3<T>> normals(const Shape<T>& body, const Pose<T>& pose) const {
    Manifolds<T> manifolds;
    EXPECT_TRUE(contacts(shape, frame, body, compose(frame, pose), contact_margin(shape, body), manifolds));
    std::vector<Vec3<T>> all;
    for (const Manifold<T>& m : manifolds) all.push_back(rotate(conjugate(frame.rotation), m.normal));
    return all;
  }
  void expect(const Shape<T>& body, const Pose<T>& pose, const std::vector<Vec3<T>>& expected) const {
    const std::vector<Vec3<T>> given = normals(body, pose);
    const auto among = [](const std::vector<Vec3<T>>& all, const Vec3<T>& n) {
      return std::any_of(all.begin(), all.end(), [&](const Vec3<T>& m) { return length(m - normalized(n)) < T(1e-3); });
    };
    for (const Vec3<T>& n : expected)
      EXPECT_TRUE(among(given, n)) << body.name() << " on " << shape.name() << " lacks " << n.x << ' ' << n.y << ' '
                                   << n.z;
    std::vector<Vec3<T>> units;
    for (const Vec3<T>& n : expected) units.push_back(normalized(n));
    for (const Vec3<T>& n : given)
      EXPECT_TRUE(among(units, n)) << body.name() << " on " << shape.name() << " has " << n.x << ' ' << n.y << ' '
                                   << n.z;
  }
};

template <class T>
std::vector<StandingSurface<T>> standing(const Shape<T>& shape) {
  const Quat<T> turn = normalized(Quat<T>{T(0.3), T(0.5), T(-0.2), T(0.7)});
  return {{shape, {}}, {shape, {{}, turn}}, {shape, {{5, -5, 3}, turn}}};
}

template <class T>
Quat<T> about(const Vec3<T>& axis, double angle) {
  return Quat<T>::from_axis_angle(axis, static_cast<T>(angle));
}

/// Where a line along x from -2 to 2 is lifted to `height` over the sides, at z = -1 and 1.
template <class T>
Shape<T> folded(T height) {
  return Mesh<T>({{-2, height, 0}, {2, height, 0}, {-2, 0, -1}, {2, 0, -1}, {-2, 0, 1}, {2, 0, 1}},
                 {{0, 1, 2}, {1, 3, 2}, {0, 4, 5}, {0, 5, 1}});
}

template <class T>
class EdgesAndCorners : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(EdgesAndCorners, Scalars);

/// A ball in a valley is held from both sides; so is what stands on a corner or a rim.
TYPED_TEST(EdgesAndCorners, OfAValleyBothSides) {
  using T = TypeParam;
  for (const StandingSurface<T>& valley : standing(folded<T>(T(-0.5)))) {
    const std::vector<Vec3<T>> both{{0, 1, T(0.5)}, {0, 1, T(-0.5)}};
    const T touching = T(-0.5) + T(0.5) * std::sqrt(T(1.25));  // the middle of a ball of radius 1/2
    valley.expect(Sphere<T>(T(0.5)), {{T(0.1), touching - T(0.01), 0}, {}}, both);
    // Its lower ball alone.
    const Quat<T> lean = about<T>({1, 0, 0}, 0.1);
    const Vec3<T> lower{T(0.1), touching - T(0.01), T(0.002)};
    valley.expect(Capsule<T>(1, T(0.5), T(0.5)), {lower + rotate(lean, Vec3<T>{0, T(0.5), 0}), lean}, both);
    const T below = std::sqrt(T(0.5));
    valley.expect(Box<T>({1, 1, 1}), {{T(0.1), below - T(0.51), 0}, about<T>({1, 0, 0}, 0.7853982)}, both);
  }
}

/// A cone that has slid down one side until its rim pokes through the other is held from there too, though the shortest
/// way out of that is along it.
TYPED_TEST(EdgesAndCorners, OfAValleyBothSidesWhereARimPokes) {
  using T = TypeParam;
  const T radius = T(0.34), height = T(0.46), past = T(0.01), deep = T(1e-4);
  const Vec3<T> up = normalized(Vec3<T>{0, 1, T(0.5)}), down = normalized(Vec3<T>{0, T(-0.5), 1});
  const Quat<T> lean = about<T>({1, 0, 0}, std::atan(0.5));
  for (const StandingSurface<T>& valley : standing(folded<T>(T(-0.5))))
    valley.expect(Cylinder<T>(height, radius, T(0)),
                  {Vec3<T>{T(0.1), T(-0.5), 0} + down * (past - radius) + up * (height / T(2) - deep), lean},
                  {{0, 1, T(0.5)}, {0, 1, T(-0.5)}});
}

/// The tip of a pyramid pushes a ball away from itself, and a box that lies on it up; the edges likewise.
TYPED_TEST(EdgesAndCorners, OfAPyramidTheTip) {
  using T = TypeParam;
  const Shape<T> pyramid = Mesh<T>({{0, 1, 0}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {-1, 0, 1}},
                                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}});
  for (const StandingSurface<T>& tip : standing(pyramid)) {
    for (const Vec3<T>& way : {Vec3<T>{0, 1, 0}, Vec3<T>{T(0.3), 1, T(0.4)}, Vec3<T>{T(-0.5), 1, 0}})
      tip.expect(Sphere<T>(T(0.5)), {Vec3<T>{0, 1, 0} + normalized(way) * T(0.49), {}}, {way});
    for (const double lean : {0.0, 0.2})
      tip.expect(Box<T>({1, 1, 1}),
                 {Vec3<T>{0, 1, 0} + rotate(about<T>({0, 0, 1}, lean), Vec3<T>{T(0.1), T(0.499), T(0.1)}),
                  about<T>({0, 0, 1}, lean)},
                 {rotate(about<T>({0, 0, 1}, lean), Vec3<T>{0, 1, 0})});
    // The edge from the tip to (1, 0, 1), met in the middle of its region.
    const Vec3<T> way = normalized(Vec3<T>{1, 2, 1});
    tip.expect(Sphere<T>(T(0.5)), {Vec3<T>{T(0.4), T(0.6), T(0.4)} + way * T(0.495), {}}, {way});
  }
}

/// A floor, a wall one high along z, and the floor above: sides of a mesh or of two boxes.
template <class T>
std::vector<Shape<T>> steps() {
  const Shape<T> box = Box<T>({2, 2, 4});
  return {Mesh<T>({{-2, 0, -2}, {-2, 0, 2}, {0, 0, -2}, {0, 0, 2}, {0, 1, -2}, {0, 1, 2}, {2, 1, -2}, {2, 1, 2}},
                  {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}, {4, 5, 7}, {4, 7, 6}}),
          Compound<T>({{box, {{-1, -1, 0}, {}}}, {box, {{1, 0, 0}, {}}}})};
}

TYPED_TEST(EdgesAndCorners, OfAStepTheWallAndTheFloorAndTheEdge) {
  using T = TypeParam;
  const Vec3<T> up{0, 1, 0}, back{-1, 0, 0}, over{-1, 1, 0};
  for (const Shape<T>& step : steps<T>())
    for (const StandingSurface<T>& at : standing(step)) {
      const Shape<T> ball = Sphere<T>(T(0.4)), box = Box<T>({T(0.5), T(0.5), T(0.5)}),
                     hull = ConvexHull<T>(std::vector<Vec3<T>>{{T(-0.4), 0, 0},
                                                               {T(0.4), 0, 0},
                                                               {0, T(-0.4), 0},
                                                               {0, T(0.4), 0},
                                                               {0, 0, T(-0.4)},
                                                               {0, 0, T(0.4)}});
      at.expect(ball, {{T(-0.395), T(0.395), T(0.1)}, {}}, {up, back});
      at.expect(box, {{T(-0.245), T(0.245), T(0.1)}, {}}, {up, back});
      at.expect(hull, {{T(-0.395), T(0.395), T(0.1)}, {}}, {up, back});
      at.expect(ball, {{-1, T(0.395), T(0.1)}, {}}, {up});
      at.expect(ball, {{T(-0.395), T(0.6), T(0.1)}, {}}, {back});
      at.expect(ball, {Vec3<T>{0, 1, T(0.1)} + normalized(over) * T(0.395), {}}, {over});
      at.expect(ball, {{T(0.5), T(1.395), T(0.1)}, {}}, {up});
    }
}

/// A wall that is a body beside the floor's: each is asked by itself and told of the other, and neither is lost. What
/// of the floor is below the wall may answer for the wall that covers it.
TYPED_TEST(EdgesAndCorners, OfAFloorAndAWallThatAreBodies) {
  using T = TypeParam;
  const Shape<T> flat = Mesh<T>({{-2, 0, -2}, {-2, 0, 2}, {2, 0, -2}, {2, 0, 2}}, {{0, 1, 3}, {0, 3, 2}});
  const Shape<T> slab = Box<T>({2, 2, 4}), level = HeightField<T>(5, 5, std::vector<T>(25, T(0)));
  for (const StandingSurface<T>& where : standing(flat))
    for (const Shape<T>& floor : {flat, slab, level}) {
      const bool solid = floor.template as<Box<T>>() != nullptr;
      const Pose<T> floor_pose = compose(where.frame, Pose<T>{solid ? Vec3<T>{-1, -1, 0} : Vec3<T>{}, {}});
      const Pose<T> wall_pose = compose(where.frame, Pose<T>{{1, 0, 0}, {}});
      const PlacedRef<T> bodies[] = {{&floor, &floor_pose}, {&slab, &wall_pose}};
      for (const Shape<T>& ball : {Shape<T>(Sphere<T>(T(0.4))), Shape<T>(Box<T>({T(0.8), T(0.8), T(0.8)}))}) {
        const Pose<T> pose = compose(where.frame, Pose<T>{{T(-0.395), T(0.395), T(0.1)}, {}});
        for (std::size_t i = 0; i < 2; ++i) {
          Manifolds<T> manifolds;
          any_contacts<T>(*bodies[i].shape, *bodies[i].pose, ball, pose, contact_margin(floor, ball), manifolds,
                          {bodies, {}});
          bool own = false;
          for (const Manifold<T>& m : manifolds) {
            const Vec3<T> n = rotate(conjugate(where.frame.rotation), m.normal);
            const bool up = length(n - Vec3<T>{0, 1, 0}) < T(1e-3), back = length(n - Vec3<T>{-1, 0, 0}) < T(1e-3);
            EXPECT_TRUE(up || back) << ball.name() << ' ' << n.x << ' ' << n.y << ' ' << n.z;
            own = own || (i == 0 ? up : back);
          }
          EXPECT_TRUE(own) << ball.name() << (i == 0 ? " on the floor, " : " at the wall, ") << floor.name();
        }
      }
    }
}

/// On a ridge the way from it, wherever between its sides' normals; a box that rests on it along its own face, or
/// nearly so.
TYPED_TEST(EdgesAndCorners, OfARidgeItsOwn) {
  using T = TypeParam;
  for (const T height : {T(0.1), T(0.5), T(2)})
    for (const StandingSurface<T>& ridge : standing(folded<T>(height))) {
      for (const T side : {T(-0.9), T(0), T(0.5)}) {
        const Vec3<T> way = normalized(Vec3<T>{0, 1, side * height});
        ridge.expect(Sphere<T>(T(0.5)), {Vec3<T>{T(0.1), height, 0} + way * T(0.49), {}}, {way});
      }
      const Shape<T> box = Box<T>({1, 1, 1});
      ridge.expect(box, {{T(0.1), height + T(0.495), 0}, {}}, {{0, 1, 0}});
      // By less than what makes a face be preferred: the ridge still is one edge, and not the two sides.
      for (const double lean : {0.001, 0.003, 0.005})
        ridge.expect(box, {{T(0.1), height + T(0.495), 0}, about<T>({0, 0, 1}, lean)}, {{0, 1, 0}});
    }
}

/// A ball on the seams of a level floor, or where six triangles meet, stands on one point, whatever rounding makes of
/// the floor's normals.
TYPED_TEST(EdgesAndCorners, OfALevelFloorNone) {
  using T = TypeParam;
  const Shape<T> floor = HeightField<T>(5, 5, std::vector<T>(25, T(0)));
  const Shape<T> ball = Sphere<T>(T(0.5));
  for (const StandingSurface<T>& at : standing(floor))
    for (const Vec3<T>& place :
         {Vec3<T>{0, 0, 0}, Vec3<T>{1, 0, T(0.3)}, Vec3<T>{T(0.4), 0, T(0.4)}, Vec3<T>{T(0.3), 0, 1}}) {
      const Pose<T> pose = compose(at.frame, Pose<T>{place + Vec3<T>{0, T(0.49), 0}, {}});
      Manifolds<T> manifolds;
      contacts(floor, at.frame, ball, pose, contact_margin(floor, ball), manifolds);
      ASSERT_EQ(manifolds.size(), 1u);
      EXPECT_EQ(manifolds[0].points.size(), 1u) << place.x << ' ' << place.z;
    }
}

}  // namespace
}  // namespace graze
