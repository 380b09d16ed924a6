// Captures of the plane run again to the same bits, and so does what went back to a state that was kept.
#include "graze/plane/capture.hpp"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "graze/error.hpp"

namespace graze::plane {
namespace {

ReplayReport replayed(const std::string& file) {
  std::istringstream in(file);
  return replay(in, "test");
}

template <class T>
class PlaneCaptureDraw {
 public:
  explicit PlaneCaptureDraw(unsigned seed) : random_(seed) {}
  T operator()(double low, double high) { return T(std::uniform_real_distribution<double>(low, high)(random_)); }
  int below(int count) { return static_cast<int>((*this)(0, count)); }
  Vec2<T> vector(double reach) {
    const T x = (*this)(-reach, reach);
    return {x, (*this)(-reach, reach)};
  }
  Pose2<T> pose(double reach) {
    const Vec2<T> at = vector(reach) + Vec2<T>{T(0), T(reach)};
    return {at, Rot2<T>::from_angle((*this)(-3, 3))};
  }
  /// Every kind of shape that a file can hold; those of the first eight have an inside.
  Shape<T> shape(int kind) {
    const auto size = [&] { return (*this)(0.2, 1); };
    const auto around = [&](int count) {
      std::vector<Vec2<T>> points;
      for (int i = 0; i < count; ++i) {
        const auto turned = Rot2<T>::from_angle(T(6.28) * T(i) / T(count));
        points.push_back(rotate(turned, Vec2<T>{size(), T(0)}));
      }
      return points;
    };
    switch (kind) {
    case 0: return Circle<T>(size());
    case 1: return Capsule<T>(size(), size(), size());
    case 2: return {Box<T>({size(), size()}), T(0.1)};
    case 3: return ConvexPolygon<T>(around(9));
    case 4: return Ellipse<T>({size(), size()});
    case 5: return Polygon<T>(around(7));
    case 6: return Compound<T>({{shape(below(6)), pose(0.3)}, {Compound<T>({{shape(below(6)), pose(0.3)}}), {}}});
    case 7: return Segment<T>({T(0), T(0)}, {T(4), T(0)});
    case 8: return Chain<T>(around(8), below(2) == 0, below(2) == 0 ? ChainSides::one : ChainSides::both);
    default: return HalfPlane<T>();
    }
  }
  static constexpr int solids = 7, shapes = 10;

 private:
  std::mt19937 random_;
};

/// A run with every call of a simulation, as a file. Bodies come until the tenth frame and some go from the thirtieth
/// on; in between, states are kept and brought back.
template <class T>
std::string random_plane_simulation(unsigned seed) {
  using Draw = PlaneCaptureDraw<T>;
  Draw draw(seed);
  std::ostringstream out;
  CapturedSimulation<T> s(&out);
  std::vector<BodyId> bodies;
  JointId joint{};
  for (int i = Draw::solids; i < Draw::shapes; ++i) {
    Body<T> floor{draw.shape(i), Pose2<T>{{T(0), T(-i)}, {}}};
    floor.fixed = true;
    s.add(floor);
  }
  const auto body = [&] { return bodies[static_cast<std::size_t>(draw.below(static_cast<int>(bodies.size())))]; };
  for (int frame = 0; frame < 40; ++frame) {
    if (frame < 10) {
      Dynamics<T> dynamics;
      if (draw.below(2) == 0) dynamics.mass = draw(1, 10);
      Body<T> added{draw.shape(draw.below(Draw::solids)), draw.pose(3), draw.vector(3)};
      added.fast = draw.below(3) == 0;
      bodies.push_back(s.add(added, dynamics, Material<T>{T(0.5), T(0.4), T(0.3)}));
    }
    if (frame == 10) joint = s.add(distance_joint<T>(bodies[0], Pose2<T>{}, bodies[1], Pose2<T>{}, T(0.5), T(3)));
    if (frame == 11) s.save(0);
    if (frame == 12) s.set_joint(joint, distance_joint<T>(bodies[0], Pose2<T>{}, bodies[1], Pose2<T>{}, T(0.4), T(2)));
    if (frame > 11 && frame < 30 && draw.below(3) == 0) s.save(static_cast<std::size_t>(draw.below(3)));
    if (frame > 11 && frame < 30 && draw.below(3) == 0) s.restore(0);
    if (frame == 30) s.remove(joint);
    if (frame > 30 && frame % 3 == 0) s.remove(bodies.back()), bodies.pop_back();
    switch (draw.below(9)) {
    case 0: s.apply_impulse(body(), draw.vector(300), draw.vector(1)); break;
    case 1: s.apply_angular_impulse(body(), draw(-10, 10)); break;
    case 2: s.apply_force(body(), draw.vector(3000)); break;
    case 3: s.apply_torque(body(), draw(-100, 100)); break;
    case 4: s.set_velocity(body(), {draw.vector(3), draw(-3, 3)}); break;
    case 5: s.set_pose(body(), draw.pose(3)); break;
    case 6: s.set_material(body(), {}); break;
    case 7:
      if (draw.below(2) == 0)
        s.wake(body());
      else
        s.set_filter(body(), {.category = 1, .mask = draw.below(2) == 0 ? 0u : ~0u});
      break;
    default: s.set_gravity(draw.vector(9));
    }
    s.step(T(1) / T(60));
  }
  return out.str();
}

template <class T>
std::string random_plane_world(unsigned seed) {
  using Draw = PlaneCaptureDraw<T>;
  Draw draw(seed);
  std::ostringstream out;
  CapturedWorld<T> w(&out, WorldSettings<T>{T(0.05), {}, 1});
  std::vector<BodyId> bodies;
  for (int frame = 0; frame < 30; ++frame) {
    const int kind = draw.below(Draw::shapes);
    Body<T> added{draw.shape(kind), draw.pose(2), draw.vector(3), draw(-3, 3)};
    added.fast = kind < 4;
    added.trigger = draw.below(5) == 0;
    bodies.push_back(w.add(added));
    const BodyId any = bodies[static_cast<std::size_t>(draw.below(static_cast<int>(bodies.size())))];
    switch (draw.below(6)) {
    case 0: w.move(any, draw.pose(2)); break;
    case 1: w.move(any, draw.pose(2), draw.vector(2), draw(-1, 1)); break;
    case 2: w.set_shape(any, draw.shape(draw.below(Draw::solids))); break;
    case 3: w.set_filter(any, {2, ~std::uint64_t{2}, -1}); break;
    case 4: w.set_fast(any, false); break;
    default: w.remove(bodies.back()); bodies.pop_back();
    }
    w.update(T(draw.below(2)) / T(30));
    if (draw.below(3) == 0) w.find_impacts(T(0.1));
  }
  return out.str();
}

TEST(PlaneCapture, RunsAgainToTheSameBits) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const ReplayReport f = replayed(random_plane_simulation<float>(seed));
    EXPECT_TRUE(f.simulation && f.plane && f.single && !f.cut);
    EXPECT_EQ(f.frames, 40u);
    EXPECT_FALSE(f.difference) << seed << ": " << f.difference->what;
    const ReplayReport d = replayed(random_plane_simulation<double>(seed));
    EXPECT_TRUE(d.simulation && d.plane && !d.single);
    EXPECT_FALSE(d.difference) << seed << ": " << d.difference->what;
    const ReplayReport world = replayed(random_plane_world<float>(seed));
    EXPECT_TRUE(!world.simulation && world.plane);
    EXPECT_GE(world.frames, 30u);
    EXPECT_FALSE(world.difference) << seed << ": " << world.difference->what;
    EXPECT_FALSE(replayed(random_plane_world<double>(seed)).difference) << seed;
  }
}

TEST(PlaneCapture, WhatIsPlayedIsHandedOut) {
  std::istringstream in(random_plane_simulation<double>(3));
  std::size_t bodies = 0;
  replay(in, "test", [&](std::size_t, const Replayed& played, const BodyNames&) {
    bodies = std::get<const Simulationd*>(played)->world().bodies().count();
  });
  EXPECT_GT(bodies, 5u);
}

/// A ball that falls, with its state kept at the height of 10.
struct PlaneFall {
  std::ostringstream out;
  CapturedSimulation<double> simulation{&out};
  BodyId ball = simulation.add({Circle<double>(1), {{0, 10}, {}}});

  double height() const { return simulation.simulation().poses()[ball.index].translation.y; }
};

TEST(PlaneCapture, AStateIsKeptUnderANumberAndBroughtBack) {
  PlaneFall fall;
  fall.simulation.save(15);
  for (int i = 0; i < 10; ++i) fall.simulation.step(0.1);
  EXPECT_LT(fall.height(), 6);
  fall.simulation.restore(15);
  EXPECT_EQ(fall.height(), 10);
  fall.simulation.step(0.1);
  EXPECT_FALSE(replayed(fall.out.str()).difference);
}

TEST(PlaneCapture, AStateThatThereIsNotIsRefusedAndNotWritten) {
  PlaneFall fall;
  EXPECT_THROW(fall.simulation.save(16), InvalidValue);
  EXPECT_THROW(fall.simulation.restore(16), InvalidValue);
  EXPECT_THROW(fall.simulation.restore(0), InvalidValue);
  fall.simulation.save(0);
  fall.simulation.remove(fall.ball);
  EXPECT_THROW(fall.simulation.restore(0), InvalidValue);
  fall.simulation.step(0.1);
  const ReplayReport report = replayed(fall.out.str());
  EXPECT_EQ(report.calls, 5u) << "shape, add, save, remove, step";
  EXPECT_FALSE(report.difference);
}

TEST(PlaneCapture, AShapeOfTheUsersOwnIsRefused) {
  class Point final : public SupportFunction<double> {
   public:
    Vec2d support(const Vec2d&) const override { return {}; }
  };
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  EXPECT_THROW(world.add({UserConvex<double>(std::make_shared<Point>())}), InvalidValue);
  EXPECT_EQ(world.world().bodies().count(), 0u);
}

}  // namespace
}  // namespace graze::plane
