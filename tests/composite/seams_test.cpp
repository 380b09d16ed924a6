// What slides from solids to sheets of triangles and back, over the seam where the one continues the other, meets the
// floor; a step is no seam.
#include <gtest/gtest.h>

#include <cstdlib>

#include "composite/composite.hpp"
#include "composite/sliding.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::furthest;
using testing::lowest;
using testing::Random;
using testing::sliders;
using testing::uniform;

/// On each floor; all floors together see more than ten thousand.
std::size_t slides() {
  const char* asked = std::getenv("GRAZE_TEST_SLIDES");
  return asked ? std::strtoull(asked, nullptr, 10) : 300;
}

/// A square of floor two units wide, its surface at y = 0 about its own origin.
template <class T>
using Tile = Shape<T> (*)();

template <class T>
Shape<T> box_tile() {
  return Box<T>({2, 2, 2});
}
template <class T>
Shape<T> hull_tile() {
  return ConvexHull<T>(std::vector<Vec3<T>>{{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}, {0, -1, 0}});
}
/// A box of triangles.
template <class T>
Shape<T> closed_tile() {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? T(1) : T(-1), i & 2 ? T(1) : T(-1), i & 4 ? T(1) : T(-1)});
  return Mesh<T>(std::move(points), {{0, 4, 6},
                                     {0, 6, 2},
                                     {1, 3, 7},
                                     {1, 7, 5},
                                     {0, 1, 5},
                                     {0, 5, 4},
                                     {2, 6, 7},
                                     {2, 7, 3},
                                     {0, 2, 3},
                                     {0, 3, 1},
                                     {4, 5, 7},
                                     {4, 7, 6}});
}
/// Triangles that share no corners.
template <class T>
Shape<T> mesh_tile() {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const auto n = static_cast<std::uint32_t>(points.size());
      const T x0 = T(i) / 2 - 1, x1 = x0 + T(0.5), z0 = T(j) / 2 - 1, z1 = z0 + T(0.5);
      points.insert(points.end(), {{x0, 1, z0}, {x0, 1, z1}, {x1, 1, z1}, {x1, 1, z0}, {x0, 1, z0}, {x1, 1, z1}});
      triangles.push_back({n, n + 1, n + 2});
      triangles.push_back({n + 4, n + 5, n + 3});
    }
  return Mesh<T>(std::move(points), std::move(triangles));
}
template <class T>
Shape<T> one_sided_tile() {
  return Mesh<T>({{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}}, {{0, 1, 2}, {0, 2, 3}}, Sides::front);
}
template <class T>
Shape<T> height_field_tile() {
  return HeightField<T>(5, 5, std::vector<T>(25, T(1)), T(0.5), T(0.5));
}

/// Ten by ten tiles of two kinds by turns; their surface is y = 0 in the frame where they stand.
template <class T>
std::vector<Placed<T>> chequered(Tile<T> one, Tile<T> other, const Pose<T>& frame) {
  std::vector<Placed<T>> tiles;
  for (int i = -5; i < 5; ++i)
    for (int j = -5; j < 5; ++j)
      tiles.push_back(
          {(i + j) % 2 == 0 ? one() : other(), compose(frame, Pose<T>{{T(2 * i + 1), -1, T(2 * j + 1)}, {}})});
  return tiles;
}

/// Bodies of their own beside each other, as a world asks about them.
template <class T>
struct Ground {
  std::vector<Placed<T>> bodies;
  std::vector<PlacedRef<T>> refs;

  explicit Ground(std::vector<Placed<T>> parts) : bodies(std::move(parts)) {
    for (const Placed<T>& body : bodies) refs.push_back({&body.shape, &body.pose});
  }
  Manifolds<T> contacts(const Shape<T>& slider, const Pose<T>& pose) const {
    Manifolds<T> manifolds;
    const Aabb<T> box = inflated(bounds(slider, pose), T(0.1));
    for (const Placed<T>& body : bodies)
      if (overlap(box, bounds(body.shape, body.pose)))
        any_contacts<T>(body.shape, body.pose, slider, pose, contact_margin(body.shape, slider), manifolds, {refs, {}});
    return manifolds;
  }
};

template <class T>
Manifolds<T> contacts_of(const Shape<T>& floor, const Shape<T>& slider, const Pose<T>& pose, bool swapped) {
  Manifolds<T> manifolds;
  const T margin = contact_margin(floor, slider);
  swapped ? contacts(slider, pose, floor, Pose<T>{}, margin, manifolds)
          : contacts(floor, Pose<T>{}, slider, pose, margin, manifolds);
  if (swapped)
    for (Manifold<T>& m : manifolds) m.normal = -m.normal;
  return manifolds;
}

/// A slider a little deep in the floor, half of the times just over a seam, so that the least way out of what lies
/// there leads sideways.
template <class T>
Pose<T> over_a_seam(const Shape<T>& slider, Random& random) {
  const auto number = [&](float low, float high) { return static_cast<T>(uniform(random, low, high)); };
  const Quat<T> turn = random() % 3 == 0
                           ? normalized(converted<T>(testing::random_rotation(random)))
                           : Quat<T>::from_axis_angle({0, 1, 0}, random() % 2 == 0 ? T(0) : number(-3, 3));
  Vec3<T> at{number(-4, 4), -lowest(slider, turn) - number(0.0005f, 0.02f), number(-4, 4)};
  const std::size_t axis = random() % 2 == 0 ? 0 : 2;
  Vec3<T> along{};
  along[axis] = random() % 2 == 0 ? T(1) : T(-1);
  if (random() % 2 == 0)
    at[axis] = T(2) * std::round(at[axis] / 2) - furthest(slider, turn, along)[axis] + number(-0.02f, 0.02f);
  return {at, turn};
}

template <class T>
class Seams : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Seams, Scalars);

/// Every two kinds of floor of which one is no plain sheet, where they stand and turned, away from the origin.
TYPED_TEST(Seams, OfSolidsAndSheetsAreNotFelt) {
  using T = TypeParam;
  Random random(7);
  const std::pair<Tile<T>, Tile<T>> kinds[] = {
      {box_tile<T>, mesh_tile<T>},   {box_tile<T>, height_field_tile<T>}, {box_tile<T>, one_sided_tile<T>},
      {hull_tile<T>, mesh_tile<T>},  {closed_tile<T>, mesh_tile<T>},      {closed_tile<T>, closed_tile<T>},
      {closed_tile<T>, box_tile<T>}, {hull_tile<T>, box_tile<T>},         {hull_tile<T>, closed_tile<T>}};
  const T away = std::is_same_v<T, float> ? T(5) : T(1e4);
  const Pose<T> frames[] = {{}, {{away, -away, away / 2}, normalized(Quat<T>{T(0.3), T(0.5), T(-0.2), T(0.7)})}};
  const std::vector<Shape<T>> movers = sliders<T>(random);
  for (const auto& [one, other] : kinds)
    for (const Pose<T>& frame : frames) {
      const Ground<T> ground(chequered<T>(one, other, frame));
      const Shape<T> whole = Compound<T>(ground.bodies);
      const Vec3<T> up = rotate(frame.rotation, Vec3<T>{0, 1, 0});
      for (std::size_t i = 0; i < slides(); ++i) {
        const Shape<T>& slider = movers[i % movers.size()];
        const Pose<T> local = over_a_seam(slider, random), pose = compose(frame, local);
        for (const bool of_bodies : {false, true}) {
          const Manifolds<T> manifolds =
              of_bodies ? ground.contacts(slider, pose) : contacts_of(whole, slider, pose, i % 2 == 0);
          EXPECT_FALSE(manifolds.empty());
          for (const Manifold<T>& m : manifolds)
            // Far away a normal is the floor's as far as the points that it stands on are.
            ASSERT_LT(length(m.normal - up), frame == Pose<T>{} ? T(2e-4) : T(1e-3))
                << slider.name() << ' ' << i << " on " << ground.bodies[0].shape.name() << " and "
                << ground.bodies[1].shape.name() << (of_bodies ? ", bodies, at " : ", children, at ")
                << local.translation.x << ' ' << local.translation.y << ' ' << local.translation.z << " piece "
                << m.piece_a << '/' << m.piece_b;
        }
      }
    }
}

/// Blocks as large as the tiles, their sides exactly on the seams or a hair or a rounding beside, the whole turned by
/// the angles that scenes are made with: each side of a block touches the sides of tiles that it does not stand on.
TYPED_TEST(Seams, OfBlocksExactlyOnThemAreNotFelt) {
  using T = TypeParam;
  const std::pair<Tile<T>, Tile<T>> kinds[] = {{box_tile<T>, box_tile<T>},
                                               {hull_tile<T>, mesh_tile<T>},
                                               {closed_tile<T>, mesh_tile<T>},
                                               {closed_tile<T>, closed_tile<T>}};
  const Shape<T> blocks[] = {Box<T>({2, 2, 2}), Shape<T>(Box<T>({2, 2, 2}), T(0.2))};
  for (const auto& [one, other] : kinds)
    for (const Vec3<T>& axis : {Vec3<T>{1, 0, 0}, Vec3<T>{1, 1, 0}})
      for (const T angle : {T(0), T(45), T(210)}) {
        const Pose<T> frame{Vec3<T>{5, -5, 3} * (angle == 210 ? T(1) : T(0)),
                            Quat<T>::from_axis_angle(normalized(axis), angle * T(0.017453292519943295))};
        const Ground<T> ground(chequered<T>(one, other, frame));
        const Shape<T> whole = Compound<T>(ground.bodies);
        const Vec3<T> up = rotate(frame.rotation, Vec3<T>{0, 1, 0});
        for (const Shape<T>& block : blocks)
          for (const T aside : {T(0), T(1e-7), T(0.006)})
            for (const T along : {T(0), T(1)})
              for (const T depth : {T(0), T(1e-6), T(1.8e-4), T(0.006)}) {
                const Pose<T> local{{aside + T(1), -lowest(block, Quat<T>{}) - depth, along}, {}};
                const Pose<T> pose = compose(frame, local);
                for (const bool of_bodies : {false, true})
                  for (const Manifold<T>& m :
                       of_bodies ? ground.contacts(block, pose) : contacts_of(whole, block, pose, along == 0))
                    ASSERT_LT(length(m.normal - up), T(1e-3))
                        << block.name() << " on " << ground.bodies[0].shape.name() << ", turned by " << angle
                        << (of_bodies ? ", bodies" : ", children") << ", beside by " << aside << ' ' << along
                        << ", deep " << depth;
              }
      }
}

/// A block of triangles, both sides of which count: what stands on it and over its rim meets the top and not the back
/// of its walls.
TYPED_TEST(Seams, OfTheTopAndTheWallsOfABlockAreNotFelt) {
  using T = TypeParam;
  Random random(11);
  const Shape<T> block = closed_tile<T>();
  std::vector<Shape<T>> movers = sliders<T>(random);
  movers.pop_back();  // a pebble leans over the rim, which has normals of its own
  for (const Shape<T>& slider : movers)
    for (std::size_t i = 0; i < slides(); ++i) {
      const auto number = [&](float low, float high) { return static_cast<T>(uniform(random, low, high)); };
      const Quat<T> turn = Quat<T>::from_axis_angle({0, 1, 0}, random() % 2 == 0 ? T(0) : number(-3, 3));
      Vec3<T> at{number(-0.9f, 0.9f), T(1) - lowest(slider, turn) - number(0.0005f, 0.02f), number(-0.9f, 0.9f)};
      // Over the rim by less than it is deep.
      if (i % 2 == 0) at.x = T(1) - furthest(slider, turn, Vec3<T>{1, 0, 0}).x + number(0, 0.02f);
      for (const Manifold<T>& m : contacts_of(block, slider, Pose<T>{at, turn}, i % 4 < 2))
        ASSERT_LT(length(m.normal - Vec3<T>{0, 1, 0}), T(2e-4))
            << slider.name() << ' ' << i << " at " << at.x << ' ' << at.y << ' ' << at.z << " piece " << m.piece_a
            << '/' << m.piece_b << ' ' << m.normal.x << ' ' << m.normal.y << ' ' << m.normal.z;
    }
}

/// A sheet about the origin and a solid beside it or upon it that is higher: its side is a wall, and felt as one.
TYPED_TEST(Seams, OfStepsAreFelt) {
  using T = TypeParam;
  for (const Tile<T> sheet : {mesh_tile<T>, one_sided_tile<T>, height_field_tile<T>})
    for (const bool upon : {false, true})
      for (const T step : {T(0.001), T(0.01), T(0.1), T(1)}) {
        // The wall begins at x = 0 on the middle of the sheet, or at its end.
        const T wall = upon ? T(0) : T(1), bottom = upon ? T(0) : T(-1);
        const Ground<T> ground(
            {{sheet(), {{0, -1, 0}, {}}}, {Box<T>({2, step - bottom, 2}), {{wall + 1, (step + bottom) / 2, 0}, {}}}});
        const Shape<T> whole = Compound<T>(ground.bodies);
        const T depth = step / 20, into = step / 5;
        const auto expect_wall = [&](const Shape<T>& slider, const Quat<T>& turn, const Vec3<T>& expected) {
          const Vec3<T> front = furthest(slider, turn, Vec3<T>{1, 0, 0});
          const Pose<T> pose{{wall - front.x + into, -lowest(slider, turn) - depth, T(0.1)}, turn};
          for (const bool of_bodies : {false, true}) {
            const Manifolds<T> manifolds =
                of_bodies ? ground.contacts(slider, pose) : contacts_of(whole, slider, pose, false);
            EXPECT_TRUE(std::any_of(manifolds.begin(), manifolds.end(),
                                    [&](const Manifold<T>& m) { return length(m.normal - expected) < T(1e-3); }))
                << slider.name() << " before a step of " << step << (upon ? " upon " : " beside ")
                << ground.bodies[0].shape.name() << (of_bodies ? ", bodies" : ", children");
            EXPECT_TRUE(std::any_of(manifolds.begin(), manifolds.end(), [&](const Manifold<T>& m) {
              return length(m.normal - Vec3<T>{0, 1, 0}) < T(1e-3);
            })) << slider.name();
          }
        };
        const Vec3<T> back{-1, 0, 0};
        expect_wall(Box<T>({1, T(0.5), T(1.5)}), {}, back);
        expect_wall(Box<T>({1, T(0.5), T(1.5)}), Quat<T>::from_axis_angle({0, 1, 0}, T(0.3)), back);
        expect_wall(Cylinder<T>(T(0.8), T(0.5), T(0.5)), {}, back);
        // What leans over its foremost point is pushed from a high wall's foot another way.
        if (step < T(0.5))
          expect_wall(ConvexHull<T>(std::vector<Vec3<T>>{{-1, 0, 0}, {0, 0, -1}, {0, 0, 1}, {T(0.5), 0, 0}, {0, 1, 0}}),
                      {}, back);
        if (step > T(0.5)) expect_wall(Sphere<T>(T(0.5)), {}, back);
      }
}

}  // namespace
}  // namespace graze
