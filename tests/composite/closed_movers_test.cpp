// A closed mesh as the body that moves: it meets a floor as the solid that it bounds would, and its inner side pushes
// nothing that comes from outside.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "composite/sliding.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::lowest;
using testing::Random;
using testing::uniform;

template <class T>
class ClosedMovers : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ClosedMovers, Scalars);

enum class Facing { outward, inward };

/// A box of twelve triangles, given by half its sides.
template <class T>
Shape<T> box_of_triangles(const Vec3<T>& half, Sides sides = Sides::both, bool solid = false,
                          Facing facing = Facing::outward) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  std::vector<typename Mesh<T>::Index> triangles{{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                                                 {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  if (facing == Facing::inward)
    for (auto& t : triangles) std::swap(t[1], t[2]);
  return Mesh<T>(std::move(points), std::move(triangles), sides, solid);
}

/// A flat square of triangles, twelve wide.
template <class T>
Shape<T> flat_mesh(T cell) {
  const auto n = static_cast<std::uint32_t>(std::ceil(T(12) / cell));
  const T first = -static_cast<T>(n) * cell / 2;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      points.push_back({first + static_cast<T>(i) * cell, 0, first + static_cast<T>(j) * cell});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + 1, c = a + n + 1, d = c + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({a, d, c});
    }
  return Mesh<T>(std::move(points), std::move(triangles));
}

/// A floor whose top is y = 0.
template <class T>
struct Floor {
  const char* name;
  Shape<T> shape;
  Pose<T> pose = {};
};

template <class T>
std::vector<Floor<T>> floors() {
  return {{"half-space", HalfSpace<T>()},
          {"box", Box<T>({20, 2, 20}), {{0, -1, 0}, {}}},
          {"flat mesh, cells of 3", flat_mesh<T>(3)},
          {"flat mesh, cells of 0.37", flat_mesh<T>(T(0.37))},
          {"height field", HeightField<T>(31, 31, std::vector<T>(961, T(0)), T(0.4), T(0.4))},
          {"box of triangles", box_of_triangles<T>({10, 1, 10}), {{0, -1, 0}, {}}}};
}

/// The box's size, as a box and as triangles.
template <class T>
constexpr Vec3<T> half{T(0.5), T(0.25), T(0.75)};

/// Lying on a face, leaning by up to a milliradian or two, or anyhow; a little deep.
template <class T>
Pose<T> on_the_floor(Random& random, int k, T depth) {
  const auto number = [&](float low, float high) { return static_cast<T>(uniform(random, low, high)); };
  const T turn = number(-3, 3), lean_x = number(-5e-4f, 5e-4f), lean_z = number(-5e-4f, 5e-4f);
  Quat<T> rotation{0, std::sin(turn), 0, std::cos(turn)};
  if (k % 4 == 1) rotation = normalized(rotation * Quat<T>{lean_x, 0, lean_z, 1});
  if (k % 2 == 0) rotation = normalized(Quat<T>{turn, number(-3, 3), number(-3, 3), number(-3, 3)});
  const T low = lowest(Shape<T>(Box<T>(half<T> * T(2))), rotation);
  const T x = number(-1, 1), z = number(-1, 1);
  return {{x, -low - depth, z}, rotation};
}

template <class T>
Manifolds<T> contacts_of(const Floor<T>& floor, const Shape<T>& mover, const Pose<T>& pose, const Pose<T>& frame,
                         bool swapped) {
  Manifolds<T> manifolds;
  const T margin = contact_margin(floor.shape, mover);
  const Pose<T> of_floor = compose(frame, floor.pose), of_mover = compose(frame, pose);
  swapped ? contacts(mover, of_mover, floor.shape, of_floor, margin, manifolds)
          : contacts(floor.shape, of_floor, mover, of_mover, margin, manifolds);
  if (swapped)
    for (Manifold<T>& m : manifolds) m.normal = -m.normal;
  return manifolds;
}

template <class T>
T deepest(const Manifolds<T>& manifolds) {
  T depth = -std::numeric_limits<T>::infinity();
  for (const Manifold<T>& m : manifolds)
    for (const ContactPoint<T>& p : m.points) depth = std::max(depth, -p.distance);
  return depth;
}

/// What all contacts of a box of triangles are like on a floor whose normal is `up`.
template <class T>
void expect_a_box_on_a_floor(const Manifolds<T>& manifolds, const Vec3<T>& up, T depth, T noise) {
  ASSERT_FALSE(manifolds.empty());
  for (const Manifold<T>& m : manifolds)
    EXPECT_LT(length(m.normal - up), T(2e-3)) << m.normal.x << ' ' << m.normal.y << ' ' << m.normal.z;
  EXPECT_NEAR(deepest(manifolds), depth, T(0.02) * depth + noise);
}

TYPED_TEST(ClosedMovers, AreHeldByTheFloorsNormalAsDeepAsTheyAre) {
  using T = TypeParam;
  Random random(23);
  const std::array frames{Pose<T>{}, Pose<T>{{T(80), T(-30), T(50)}, normalized(Quat<T>{T(0.3), T(-0.5), T(0.2), 1})}};
  const std::array movers{box_of_triangles<T>(half<T>), box_of_triangles<T>(half<T>, Sides::front),
                          box_of_triangles<T>(half<T>, Sides::both, true),
                          box_of_triangles<T>(half<T>, Sides::front, true)};
  for (const Floor<T>& floor : floors<T>())
    for (int k = 0; k < 400; ++k) {
      const T depth = static_cast<T>(uniform(random, 5e-4f, 0.02f));
      const Pose<T> pose = on_the_floor<T>(random, k, depth);
      const std::size_t which = static_cast<std::size_t>(k) / 4 % movers.size();
      const Pose<T>& frame = frames[static_cast<std::size_t>(k) / 16 % 2];
      SCOPED_TRACE(std::string(floor.name) + ", pose " + std::to_string(k) + ", mover " + std::to_string(which));
      const T noise = T(64) * std::numeric_limits<T>::epsilon() * (T(20) + max_abs(frame.translation));
      expect_a_box_on_a_floor(contacts_of(floor, movers[which], pose, frame, k / 8 % 2 != 0),
                              rotate(frame.rotation, Vec3<T>{0, 1, 0}), depth, noise);
    }
}

/// Where a floor is flat the body stands on it, however it is cut: with the points of the solid.
TYPED_TEST(ClosedMovers, StandOnTheCornersOfTheSolid) {
  using T = TypeParam;
  Random random(24);
  const Shape<T> solid = Box<T>(half<T> * T(2)), skin = box_of_triangles<T>(half<T>);
  for (const Floor<T>& floor : floors<T>())
    for (int k = 1; k < 200; k += 2) {
      const Pose<T> pose = on_the_floor<T>(random, k, T(0.002));
      SCOPED_TRACE(std::string(floor.name) + ", pose " + std::to_string(k));
      const Manifolds<T> expected = contacts_of(floor, solid, pose, {}, false);
      ASSERT_EQ(expected.size(), 1u);
      ASSERT_EQ(expected[0].points.size(), 4u);
      const Manifolds<T> found = contacts_of(floor, skin, pose, {}, k % 4 == 3);
      for (const ContactPoint<T>& corner : expected[0].points) {
        T nearest = std::numeric_limits<T>::infinity();
        for (const Manifold<T>& m : found)
          for (const ContactPoint<T>& p : m.points)
            nearest = std::min(nearest, length(k % 4 == 3 ? p.a - corner.b : p.b - corner.b));
        EXPECT_LT(nearest, T(2e-3));  // what a lean of a milliradian moves a foot
      }
    }
}

/// A skin is no solid unless asked: what is within it is pushed inward, by the side that it meets.
TYPED_TEST(ClosedMovers, HoldWithinWhatIsWithin) {
  using T = TypeParam;
  const Shape<T> ball = Sphere<T>(T(0.1));
  for (const Facing facing : {Facing::outward, Facing::inward}) {
    const Shape<T> room = box_of_triangles<T>(half<T>, Sides::both, false, facing);
    Manifolds<T> manifolds;
    contacts(room, Pose<T>{}, ball, Pose<T>{{T(0.1), T(-0.16), T(0.2)}, {}}, T(0), manifolds);
    ASSERT_EQ(manifolds.size(), 1u);
    EXPECT_NEAR(manifolds[0].normal.y, T(1), T(1e-5));
    EXPECT_NEAR(manifolds[0].points[0].distance, T(-0.01), T(1e-6));
  }
}

/// What is wound the wrong way round has its inner side in front, and is met from outside all the same.
TYPED_TEST(ClosedMovers, ThatAreInsideOutKeepTheirContacts) {
  using T = TypeParam;
  const Shape<T> wrong = box_of_triangles<T>(half<T>, Sides::both, false, Facing::inward);
  const Shape<T> ball = Sphere<T>(T(0.1));
  Manifolds<T> manifolds;
  contacts(wrong, Pose<T>{}, ball, Pose<T>{{T(0.1), T(0.34), T(0.2)}, {}}, T(0), manifolds);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_NEAR(manifolds[0].normal.y, T(1), T(1e-5));
}

/// A body that has gone deeper than its middle is still told to have touched, if no longer which way out is right.
TYPED_TEST(ClosedMovers, ThatTouchAreNotLeftWithoutAPoint) {
  using T = TypeParam;
  Random random(25);
  const Shape<T> skin = box_of_triangles<T>(half<T>);
  for (const Floor<T>& floor : floors<T>())
    for (int k = 0; k < 200; ++k) {
      const Pose<T> pose = on_the_floor<T>(random, k, static_cast<T>(uniform(random, 0.02f, 0.6f)));
      Manifolds<T> manifolds;
      const bool touch = contacts(floor.shape, floor.pose, skin, pose, T(0), manifolds);
      EXPECT_EQ(touch, overlap(floor.shape, floor.pose, skin, pose)) << floor.name << ' ' << k;
      EXPECT_EQ(touch, !manifolds.empty()) << floor.name << ' ' << k;
    }
}

}  // namespace
}  // namespace graze
