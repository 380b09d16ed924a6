// Bodies that move over fixed bodies side by side in a world of the plane: they meet these as one ground.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "common/plane_slides.hpp"
#include "graze/plane/simulation.hpp"
#include "graze/plane/world.hpp"

namespace graze::plane::testing {
namespace {

using slides::Random;
using slides::uniform;

/// Kinds of ground along the x axis, its surface at y = 0.
enum class Tiles {
  boxes,
  segments,
  polygons,
  overlapping,
  slabs_in_half_plane,
  foundation,
  mixed,
  rounded,
  chains,
  fine,              ///< boxes of 1 to 5 cm
  fine_rounded,      ///< with a rounding of 1 cm
  fine_unlike,       ///< with different roundings, most of which reach over the next few boxes
  fine_overlapping,  ///< these, of which each begins within the one before
  unlike             ///< large boxes with different roundings, one begun within the other
};
constexpr Tiles all_tiles[] = {
    Tiles::boxes,        Tiles::segments,    Tiles::polygons,         Tiles::overlapping, Tiles::slabs_in_half_plane,
    Tiles::foundation,   Tiles::mixed,       Tiles::rounded,          Tiles::chains,      Tiles::fine,
    Tiles::fine_rounded, Tiles::fine_unlike, Tiles::fine_overlapping, Tiles::unlike};

bool is_fine(Tiles tiles) {
  return tiles == Tiles::fine || tiles == Tiles::fine_rounded || tiles == Tiles::fine_unlike ||
         tiles == Tiles::fine_overlapping;
}
bool overlap(Tiles tiles) {
  return tiles == Tiles::overlapping || tiles == Tiles::fine_overlapping || tiles == Tiles::unlike;
}

/// Radius of one of the tiles, for those that are rounded boxes.
double radius_of(Tiles tiles, Random& random) {
  switch (tiles) {
  case Tiles::fine: return 0;
  case Tiles::fine_rounded: return 0.01;
  case Tiles::unlike: return uniform(random, 0.02, 0.15);
  default: return uniform(random, 0.001, 0.1);
  }
}

/// Radius of rounded tiles.
constexpr double rounding = 0.1;

template <class T>
class Scene {
 public:
  /// The ground turned by `angle` about the origin and moved by `to`; `whole`: of one body, a compound.
  Scene(Tiles tiles, double angle, Vec2d to, Random& random, bool whole = false)
      : angle_(angle), to_(to), whole_(whole) {
    const double end = is_fine(tiles) ? 1.2 : 3;
    double x = -end;
    if (tiles == Tiles::slabs_in_half_plane) fix(HalfPlane<T>(), {0, 0});
    if (tiles == Tiles::foundation) {
      fix(HalfPlane<T>(), {0, 0});
      for (int i = 0; i < 3; ++i) fix(Box<T>({T(0.7), T(0.4)}), {-1.0 + 0.9 * i, -0.205});
    }
    while (tiles != Tiles::foundation && x < end) {
      const double width = is_fine(tiles) ? uniform(random, 0.01, 0.05) : uniform(random, 0.2, 1.5),
                   height = uniform(random, 0.2, 1), middle = x + width / 2;
      const int kind = tiles == Tiles::mixed ? int(uniform(random, 0, 3)) : int(tiles);
      if (kind == int(Tiles::segments)) {
        fix(Segment<T>({T(-width / 2), T(0)}, {T(width / 2), T(0)}), {middle, 0});
      } else if (kind == int(Tiles::rounded)) {
        fix({Box<T>({T(width), T(height)}), T(rounding)}, {middle, -height / 2 - rounding});
      } else if (is_fine(tiles) || tiles == Tiles::unlike) {
        const double radius = radius_of(tiles, random);
        fix({Box<T>({T(width), T(height)}), T(radius)}, {middle, -height / 2 - radius});
      } else if (kind == int(Tiles::chains)) {
        const double bend = uniform(random, -width / 3, width / 3);
        fix(Chain<T>(std::vector<Vec2<T>>{{T(width / 2), T(0)}, {T(bend), T(0)}, {T(-width / 2), T(0)}}), {middle, 0});
      } else if (kind == int(Tiles::polygons)) {
        fix(ConvexPolygon<T>(std::vector<Vec2<T>>{{T(-width / 2), T(0)}, {T(0), T(-height)}, {T(width / 2), T(0)}}),
            {middle, 0});
      } else {
        fix(Box<T>({T(width), T(height)}), {middle, -height / 2});
      }
      x += overlap(tiles) ? 0.7 * width : width;
    }
  }
  Scene() = default;
  void fix(Shape<T> shape, Vec2d at) {
    if (whole_)
      children_.push_back({std::move(shape), {converted<T>(at), {}}});
    else
      add(std::move(shape), at, 0, true);
  }
  /// Lays the ground, where it is one body, of all that was fixed.
  void lay() {
    if (whole_) add(Compound<T>(children_), {0, 0}, 0, true);
  }
  BodyId add(Shape<T> shape, Vec2d at, double turn, bool fixed = false) {
    Body<T> body{std::move(shape)};
    body.pose = pose(at, turn);
    body.fixed = fixed;
    return world.add(std::move(body));
  }
  Pose2<T> pose(Vec2d at, double turn) const {
    return {converted<T>(rotate(Rot2d::from_angle(angle_), at) + to_), converted<T>(Rot2d::from_angle(angle_ + turn))};
  }
  Vec2d up() const { return rotate(Rot2d::from_angle(angle_), Vec2d{0, 1}); }

  World<T> world;

 private:
  double angle_ = 0;
  Vec2d to_{};
  bool whole_ = false;
  std::vector<Placed<T>> children_;
};

template <class T>
std::vector<Shape<T>> bodies_to_slide() {
  return {Box<T>({1, 1}),
          Shape<T>(Box<T>({T(0.8), T(0.8)}), T(0.1)),
          Circle<T>(T(0.5)),
          Capsule<T>(T(0.5), T(0.25), T(0.25)),
          ConvexPolygon<T>(std::vector<Vec2<T>>{
              {T(-0.4), T(-0.5)}, {T(0.4), T(-0.5)}, {T(0.6), T(0.1)}, {0, T(0.5)}, {T(-0.6), T(0.1)}}),
          Ellipse<T>({T(0.7), T(0.5)}),
          Polygon<T>(std::vector<Vec2<T>>{
              {T(-0.6), T(-0.5)}, {T(0.6), T(-0.5)}, {T(0.6), T(0.5)}, {0, T(0.1)}, {T(-0.6), T(0.5)}})};
}

template <class T>
class PlaneGround : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneGround, Scalars);

/// The normals of all contacts of a body, towards it and as the ground is turned, with the depth of each point.
template <class T>
struct Push {
  Vec2d normal;
  double depth;
};
template <class T>
std::vector<Push<T>> pushes(const Scene<T>& scene, BodyId body) {
  std::vector<Push<T>> all;
  const auto& found = scene.world.contacts();
  for (const auto& pair : found.pairs)
    for (const auto& m : found.manifolds_of(pair))
      for (const auto& p : found.points_of(m)) {
        const Vec2d n = converted<double>(m.normal) * (pair.a == body.index ? -1.0 : 1.0);
        all.push_back({{cross(n, scene.up()), dot(n, scene.up())}, -double(p.distance)});
      }
  return all;
}
/// The greatest depth of the points that push along a direction, within a milliradian.
template <class T>
double depth_along(const std::vector<Push<T>>& pushes, Vec2d direction) {
  double deepest = 0;
  for (const Push<T>& push : pushes)
    if (dot(push.normal, direction) > 0 && std::abs(cross(push.normal, direction)) < 1e-3)
      deepest = std::max(deepest, push.depth);
  return deepest;
}

/// How high a shape's origin is over a half-plane in which it is `sunk` deep.
template <class T>
double height_of(const Shape<T>& shape, double turn, double sunk) {
  const Pose2<T> above{{T(0), T(5)}, Rot2<T>::from_angle(T(turn))};
  return 5 - double(distance<T>(HalfPlane<T>(), {}, shape, above).distance) - sunk;
}

/// Whatever tiles it lies on, a body is pushed straight up but for `most_lean`, and as deep as on a half-plane. Tiles
/// are fixed bodies, or the children of one.
template <class T>
std::size_t expect_no_seams(bool whole, const std::vector<Shape<T>>& sliders, double most_lean = 1e-3) {
  Random random(7);
  std::size_t poses = 0;
  for (const Tiles tiles : all_tiles)
    for (const auto& [angle, at] :
         {std::pair(0.0, Vec2d{0, 0}), std::pair(0.7, Vec2d{0, 0}), std::pair(2.0, Vec2d{100, -70})})
      for (std::size_t s = 0; s < sliders.size(); ++s)
        for (int k = 0; k < (is_fine(tiles) ? 15 : 30); ++k) {
          // Tiles that meet in a point leave a gap below it, in which a part of a body finds a side to push. Segments
          // in one compound miss a corner that lies on the end of two.
          const Shape<T> slider = sliders[s];
          const bool parts = slider.template as<Polygon<T>>() || slider.template as<Compound<T>>();
          if (parts && (tiles == Tiles::polygons || tiles == Tiles::mixed)) continue;
          if ((whole || slider.template as<Compound<T>>()) && (tiles == Tiles::segments || tiles == Tiles::mixed))
            continue;
          Scene<T> scene(tiles, angle, at, random, whole);
          scene.lay();
          const double lean = k % 3 == 0 ? 0 : uniform(random, -0.03, 0.03), sunk = uniform(random, 0, 0.02),
                       middle = is_fine(tiles) ? 0.3 : 1.5, x = uniform(random, -middle, middle);
          const BodyId body = scene.add(slider, {x, height_of(slider, lean, sunk)}, lean);
          scene.world.update();
          ++poses;
          SCOPED_TRACE("tiles " + std::to_string(int(tiles)) + " angle " + std::to_string(angle) + " slider " +
                       std::to_string(s) + " case " + std::to_string(k));
          double deepest = 0;
          for (const Push<T>& push : pushes(scene, body)) {
            EXPECT_GT(push.normal.y, 0);
            EXPECT_NEAR(push.normal.x, 0, most_lean);
            deepest = std::max(deepest, push.depth);
          }
          // The foundation lies half a centimetre below the half-plane.
          EXPECT_NEAR(deepest, sunk, tiles == Tiles::foundation ? 0.006 : 1e-4);
        }
  return poses;
}

/// A crate of halves that touch, and one of parts that overlap.
template <class T>
std::vector<Shape<T>> crates() {
  const Shape<T> half = Box<T>({T(0.5), T(1)}), part = Box<T>({T(0.6), T(1)});
  const auto placed = [](const Shape<T>& shape, double x) { return Placed<T>{shape, {{T(x), T(0)}, {}}}; };
  return {Compound<T>({placed(half, -0.25), placed(half, 0.25)}), Compound<T>({placed(part, -0.2), placed(part, 0.2)})};
}

TYPED_TEST(PlaneGround, HasNoSeams) { EXPECT_GT(expect_no_seams(false, bodies_to_slide<TypeParam>()), 4000u); }
TYPED_TEST(PlaneGround, HasNoSeamsWithinACompound) {
  EXPECT_GT(expect_no_seams(true, bodies_to_slide<TypeParam>()), 3000u);
}

/// A part of a crate that leans may have the crate's own normal, as a box on a tile narrower than itself has.
TYPED_TEST(PlaneGround, HasNoSeamsForCratesOfParts) {
  for (const bool whole : {false, true}) EXPECT_GT(expect_no_seams(whole, crates<TypeParam>(), 0.03), 700u);
}

/// What stands on the ground, or higher than it, pushes as it does alone.
TYPED_TEST(PlaneGround, KeepsWallsAndSteps) {
  using T = TypeParam;
  Random random(8);
  for (const bool whole : {false, true})
    for (const double high : {2.0, 0.2, 0.05})
      for (const auto& [beside, radius] : {std::pair(false, 0.0), {true, 0.0}, {false, rounding}, {true, rounding}})
        for (std::size_t s = 0; s < bodies_to_slide<T>().size(); ++s)
          for (int k = 0; k < 10; ++k) {
            Scene<T> scene(radius > 0 ? Tiles::rounded : Tiles::boxes, 0.7, {1, 2}, random, whole);
            // A wall that stands on the tiles, or a block beside a last tile that is higher than it.
            const double wall = uniform(random, -0.5, 0.5);
            scene.fix({Box<T>({T(1), T(beside ? high + 1 : high)}), T(radius)},
                      {wall + radius + 0.5, beside ? (high - 1) / 2 : high / 2});
            scene.lay();
            const Shape<T> slider = bodies_to_slide<T>()[s];
            const bool is_box = s == 0;
            if (!is_box && high < 1) continue;  // round sides meet a step's edge
            const Aabb2<T> box = bounds(slider, Pose2<T>{});
            const double sunk = uniform(random, 0.001, 0.01), pressed = uniform(random, 0.001, 0.01);
            const BodyId body =
                scene.add(slider, {wall + pressed - double(box.upper.x), height_of(slider, 0, sunk)}, 0);
            scene.world.update();
            SCOPED_TRACE("high " + std::to_string(high) + " slider " + std::to_string(s) + " case " +
                         std::to_string(k));
            const auto found = pushes(scene, body);
            EXPECT_NEAR(depth_along(found, {0, 1}), sunk, 1e-4);
            EXPECT_NEAR(depth_along(found, {-1, 0}), pressed, 1e-4);
            for (const Push<T>& push : found) EXPECT_LT(std::abs(push.normal.x * push.normal.y), 1e-3);
          }
}

/// Tiles without a size are no ground, and spoil none.
TYPED_TEST(PlaneGround, BearsTilesWithoutSize) {
  using T = TypeParam;
  for (const Shape<T>& slider : bodies_to_slide<T>()) {
    Scene<T> scene;
    for (const double x : {-0.5, 0.5}) scene.fix(Box<T>({1, 1}), {x, -0.5});
    for (const double x : {-1.0, -0.2, 0.0, 0.4}) {
      scene.fix(Box<T>({T(0.5), 0}), {x, 0});
      scene.fix(Box<T>({0, 0}), {x, 0});
      scene.fix(Segment<T>({0, 0}, {0, 0}), {x, 0});
      scene.fix(Capsule<T>(0, 0), {x, 0});
      scene.fix(Circle<T>(0), {x, 0});
    }
    const BodyId body = scene.add(slider, {T(0.1), height_of(slider, 0, 0.01)}, 0);
    scene.world.update();
    const auto found = pushes(scene, body);
    EXPECT_NEAR(depth_along(found, {0, 1}), 0.01, 1e-4);
    for (const Push<T>& push : found) EXPECT_TRUE(std::isfinite(push.depth) && std::isfinite(push.normal.x));
  }
}

/// Without friction a box keeps its speed over tiles of all kinds.
TYPED_TEST(PlaneGround, IsSmoothToSlideOn) {
  using T = TypeParam;
  Random random(9);
  for (const Tiles tiles : {Tiles::boxes, Tiles::segments, Tiles::polygons, Tiles::slabs_in_half_plane, Tiles::mixed}) {
    Simulation<T> simulation;
    const Material<T> ice{T(0), T(0)};
    const Scene<T> scene(tiles, 0, {0, 0}, random);
    for (std::uint32_t i = 0; i < scene.world.bodies().size(); ++i) {
      Body<T> tile{scene.world.bodies().shapes()[i], scene.world.bodies().poses()[i]};
      tile.fixed = true;
      simulation.add(tile, {}, ice);
    }
    const BodyId box = simulation.add({Box<T>({T(0.5), T(0.5)}), {{T(-2.5), T(0.25)}, {}}, {T(2), T(0)}}, {}, ice);
    for (int i = 0; i < 120; ++i) {
      simulation.step(T(1) / 60);
      ASSERT_NEAR(simulation.motion(box).linear.x, 2, 1e-3) << "tiles " << int(tiles) << " step " << i;
      ASSERT_NEAR(simulation.poses()[box.index].translation.y, 0.25, 2e-3);
    }
  }
}

}  // namespace
}  // namespace graze::plane::testing
