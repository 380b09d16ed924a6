// Fixed bodies in and on a half-space: the ground is a neighbour as any other. What lies over the rim of a slab that is
// flush with it, or of a foundation below it, is pushed up and never aside; a wall and a curb remain what they are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graze/world.hpp"

namespace graze::testing {
namespace {

class GroundDraw {
 public:
  explicit GroundDraw(unsigned seed) : random_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int count) { return static_cast<int>((*this)(0, count)); }

 private:
  std::mt19937 random_;
};

/// The corners of a block, top last.
template <class T>
std::vector<Vec3<T>> ground_block_corners(const Vec3d& size) {
  std::vector<Vec3<T>> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        converted<T>(Vec3d{i & 1 ? size.x : -size.x, i & 4 ? size.y : -size.y, i & 2 ? size.z : -size.z} * 0.5));
  return corners;
}

/// A block about the origin: as a box, a hull, the triangles of its surface, or round.
template <class T>
Shape<T> random_ground_block(const Vec3d& size, GroundDraw& draw) {
  const int kind = draw.below(4);
  if (kind == 0) return Box<T>(converted<T>(size));
  if (kind == 1) return ConvexHull<T>(ground_block_corners<T>(size));
  if (kind == 2)
    return Mesh<T>(ground_block_corners<T>(size), {{0, 1, 2},
                                                   {1, 3, 2},
                                                   {4, 6, 5},
                                                   {5, 6, 7},
                                                   {0, 4, 1},
                                                   {1, 4, 5},
                                                   {2, 3, 6},
                                                   {3, 7, 6},
                                                   {0, 2, 4},
                                                   {2, 6, 4},
                                                   {1, 5, 3},
                                                   {3, 5, 7}});
  return Cylinder<T>(static_cast<T>(size.y), static_cast<T>(size.x / 2));
}

template <class T>
Shape<T> random_ground_slider(double size, GroundDraw& draw) {
  const double x = size, y = size * draw(0.3, 1), z = size * draw(0.3, 1.2);
  const T margin = draw.below(2) == 0 ? T(0) : static_cast<T>(draw(0.02, 0.25) * size);
  switch (draw.below(5)) {
  case 0: return Shape<T>(Box<T>({T(x), T(y), T(z)}), margin);
  case 1: return Shape<T>(Cylinder<T>(T(y), T(x / 2)), margin);
  case 2: return Capsule<T>(T(x), T(y / 2));
  case 3: return Sphere<T>(T(x / 2));
  default: break;
  }
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 10; ++i) points.push_back({T(draw(-x, x)), T(draw(-y, y)), T(draw(-z, z))});
  return Shape<T>(ConvexHull<T>(points), margin);
}

template <class T>
Quat<T> about_y(double angle) {
  return converted<T>(Quatd::from_axis_angle({0, 1, 0}, angle));
}

/// A world with a ground, as it lies in `frame`.
template <class T>
struct OnGround {
  Pose<T> frame;
  World<T> world{};

  explicit OnGround(const Pose<T>& f) : frame(f) { add(HalfSpace<T>(), {}, true); }
  void add(const Shape<T>& shape, const Pose<T>& pose, bool fixed) {
    Body<T> body{shape, compose(frame, pose)};
    body.fixed = fixed;
    world.add(body);
  }
  Vec3<T> up() const { return rotate(frame.rotation, Vec3<T>{T(0), T(1), T(0)}); }
  /// The sine by which the normal leans that leans most from the way up.
  T most_lean() {
    world.update();
    T most(0);
    for (const auto& m : world.contacts().manifolds) most = greatest(most, length(cross(m.normal, up())));
    return most;
  }
};

template <class T>
Pose<T> random_ground_frame(GroundDraw& draw) {
  if (draw.below(2) == 0) return {};
  const Vec3d axis = normalized(Vec3d{draw(-1, 1), draw(-1, 1), draw(-1, 1)});
  return converted<T>(Posed{{draw(-9, 9), draw(-9, 9), draw(-9, 9)}, Quatd::from_axis_angle(axis, draw(-3, 3))});
}

template <class T>
class Ground : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Ground, Scalars);

TYPED_TEST(Ground, SlabsInItAreNotFelt) {
  using T = TypeParam;
  int wrong = 0, met = 0;
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    GroundDraw draw(seed);
    OnGround<T> on(random_ground_frame<T>(draw));
    const Vec3d size{draw(0.5, 2), draw(0.1, 0.6), draw(0.5, 2)};
    const double top = draw.below(2) == 0 ? 0 : -draw(0, 0.02);
    on.add(random_ground_block<T>(size, draw), {{T(0), T(top - size.y / 2), T(0)}, about_y<T>(draw(-3, 3))}, true);
    const double length = draw(0.05, 0.8), about = draw(-3, 3);
    const Shape<T> slider = random_ground_slider<T>(length, draw);
    const Quatd lean = Quatd::from_axis_angle({std::cos(about), 0, std::sin(about)}, draw.below(2) * draw(0, 0.02));
    Pose<T> pose{{T(draw(-1, 1) * size.x), T(0), T(draw(-1, 1) * size.z)},
                 normalized(converted<T>(lean) * about_y<T>(draw(-3, 3)))};
    pose.translation.y = -bounds(slider, pose).lower.y - T(draw(0, 0.04) * length);
    on.add(slider, pose, false);
    if (on.most_lean() > T(1e-3)) {
      ++wrong;
      if (wrong < 5) ADD_FAILURE() << seed << ' ' << slider.name() << " is pushed aside by " << on.most_lean();
    }
    met += on.world.contacts().pairs.size() > 1 ? 1 : 0;  // the slab as well
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(met, 1000);
}

// What stands on or through the ground and is higher is a wall.
TYPED_TEST(Ground, WallsAndCurbsOnItAre) {
  using T = TypeParam;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    GroundDraw draw(seed);
    OnGround<T> on(random_ground_frame<T>(draw));
    const Vec3d size{draw(0.5, 2), draw(0.1, 0.6), draw(0.5, 2)};
    const double step = draw.below(2) == 0 ? draw(0.02, 0.05) : draw(0.05, 1) * size.y;
    const Shape<T> block = random_ground_block<T>(size, draw);
    on.add(block, {{T(0), T(step - size.y / 2), T(0)}, {}}, true);
    const double edge = draw(0.1, 0.8), into = draw(0.05, 0.4) * least(step, edge), sunk = draw(0, 0.005);
    on.add(Box<T>({T(edge), T(edge), T(edge)}), {{T((size.x + edge) / 2 - into), T(edge / 2 - sunk), T(0)}, {}}, false);
    EXPECT_GT(on.most_lean(), T(0.99)) << seed << ' ' << block.name() << ' ' << step << ' ' << into;
  }
}

}  // namespace
}  // namespace graze::testing
