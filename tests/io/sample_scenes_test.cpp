// Scenes in which many joints, limits and motors meet, after the subjects of KHR_physics_rigid_bodies' samples: each
// kind of joint, a water wheel and a robot that walks. They are played for twenty seconds: all hard limits hold, and
// each does what it is made for.
#include <gtest/gtest.h>

#include "kept_scene.hpp"

namespace graze::io::sample_scenes_test {
namespace {

using Json = nlohmann::json;

constexpr double g = 9.81;
const double pi = std::acos(-1.0);

/// A turn about z is free.
Json hinge() { return {{"limits", {together, straight({0, 1})}}}; }
Json solid(std::size_t shape) { return {{"collider", {{"geometry", {{"shape", shape}}}}}}; }
Json moving(std::size_t shape, double mass) {
  Json json = solid(shape);
  json["motion"] = {{"mass", mass}};
  return json;
}

/// Ties two nodes by a joint between places of theirs; their axes are those of the nodes.
void join(PhysicsScene& scene, const Json& joint, std::size_t a, const Vec3d& at_a, std::size_t b, const Vec3d& at_b) {
  const auto end = scene.node("end", nullptr, at_b);
  scene.put_below(b, end);
  const auto start = scene.node("start", {{"joint", {{"joint", scene.joint(joint)}, {"connectedNode", end}}}}, at_a);
  scene.put_below(a, start);
}

/// How far hard limits are passed at most, in metres and radians.
class LimitErrors {
 public:
  explicit LimitErrors(const Played& played) : played_(played) {
    for (const SimulationFrame& frame : played.frames)
      for (const Joint& joint : played.scene.joints) add(joint, frame);
  }
  double worst() const { return worst_; }

 private:
  Pose<double> pose(const std::optional<std::size_t>& body, const SimulationFrame& frame) const {
    if (!body) return {};
    for (std::size_t i = 0; i < played_.moving.size(); ++i)
      if (played_.moving[i] == *body) return frame.bodies[i].pose;
    return played_.scene.bodies[*body].pose;
  }
  void add(const Joint& joint, const SimulationFrame& frame) {
    const Pose<double> a = compose(pose(joint.body_a, frame), joint.frame_a);
    const Pose<double> b = compose(pose(joint.body_b, frame), joint.frame_b);
    const Vec3d way = inverse_transform(a, b.translation);
    Quatd turn = conjugate(a.rotation) * b.rotation;
    if (turn.w < 0) turn = {-turn.x, -turn.y, -turn.z, -turn.w};
    for (const auto& limit : joint.limits)
      if (!limit.stiffness) {
        const double value = limit.angular ? angle(limit.axes, turn) : distance(limit.axes, way);
        const double past = std::max(limit.min - value, value - limit.max);
        worst_ = std::isfinite(value) ? std::max(worst_, past) : std::numeric_limits<double>::infinity();
      }
  }
  static double distance(const std::array<bool, 3>& axes, const Vec3d& way) {
    double square = 0, last = 0;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (axes[i]) ++count, last = way[i], square += last * last;
    return count == 1 ? last : std::sqrt(square);
  }
  static double angle(const std::array<bool, 3>& axes, const Quatd& turn) {
    const int count = axes[0] + axes[1] + axes[2];
    if (count == 3) return 2 * std::atan2(length(turn.vector()), turn.w);
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3d axis{};
      axis[i] = 1;
      if (count == 1 && axes[i]) return 2 * std::atan2(turn.vector()[i], turn.w);
      if (count == 2 && !axes[i]) return std::acos(std::clamp(dot(rotate(turn, axis), axis), -1.0, 1.0));
    }
    return 0;
  }

  const Played& played_;
  double worst_ = 0;
};

bool is_finite(const Played& played) {
  for (const SimulationFrame& frame : played.frames)
    for (const BodyState& body : frame.bodies)
      if (!std::isfinite(length(body.pose.translation) + length(body.linear) + length(body.angular))) return false;
  return true;
}

/// Eleven boxes of 2 kg, each on a post of its own by another kind of joint.
TEST(SampleScenes, JointTypes) {
  PhysicsScene scene;
  const auto post = scene.box(0.2, 0.2, 0.2), cube = scene.box(0.5, 0.5, 0.5);
  const auto about_z = [](double min, double max) { return Json{{"angularAxes", {2}}, {"min", min}, {"max", max}}; };
  const auto along_y = [](double min, double max) { return Json{{"linearAxes", {1}}, {"min", min}, {"max", max}}; };
  const auto drive = [](const char* type, int axis, const Json& more) {
    Json json{{"type", type}, {"mode", "acceleration"}, {"axis", axis}};
    json.update(more);
    return Json::array({json});
  };
  const Json spring{{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 0.5}, {"stiffness", 200}, {"damping", 10}};
  const Json across{{"linearAxes", {0, 2}}, {"min", 0}, {"max", 0}};
  const std::vector<std::pair<const char*, Json>> kinds{
      {"fixed", {{"limits", {together, straight({0, 1, 2})}}}},
      {"ball", {{"limits", {together}}}},
      {"hinge", hinge()},
      {"hinge with bounds", {{"limits", {together, straight({0, 1}), about_z(-0.5, 0.25)}}}},
      {"cone", {{"limits", {together, {{"angularAxes", {1, 2}}, {"min", 0}, {"max", 0.4}}, straight({0})}}}},
      {"slider", {{"limits", {across, straight({0, 1, 2}), along_y(-1, 0)}}}},
      {"plane", {{"limits", {{{"linearAxes", {1}}, {"min", 0}, {"max", 0}}, straight({0, 2})}}}},
      {"distance", {{"limits", {{{"linearAxes", {0, 1, 2}}, {"min", 0.2}, {"max", 0.8}}}}}},
      {"spring", {{"limits", {spring}}}},
      {"motor",
       {{"limits", {together, straight({0, 1})}},
        {"drives", drive("angular", 2, {{"velocityTarget", 3}, {"damping", 20}})}}},
      {"lift",
       {{"limits", {across, straight({0, 1, 2})}},
        {"drives", drive("linear", 1, {{"positionTarget", 1}, {"stiffness", 100}, {"damping", 10}})}}},
  };
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Vec3d at{1.5 * static_cast<double>(i), 3, 0};
    const auto a = scene.node("post " + std::to_string(i), solid(post), at);
    const double apart = kinds[i].first == std::string("distance") ? 0.5 : 0;
    const auto b = scene.node(kinds[i].first, moving(cube, 2), at + Vec3d{0.35 + apart, 0, 0});
    join(scene, kinds[i].second, a, {}, b, {-0.35, 0, 0});
  }
  const Played played(kept(scene, "sample-joint-types", "eleven kinds of joints hold, swing, stop and drive"), 20);
  EXPECT_TRUE(is_finite(played));
  EXPECT_LE(LimitErrors(played).worst(), 1e-3);
  const auto off = [&](const char* name) {
    const auto body = played.index(name);
    return played.frames.back().bodies[body].pose.translation - played.frames.front().bodies[body].pose.translation;
  };
  EXPECT_LE(length(off("fixed")), 1e-3);
  EXPECT_NEAR(off("slider").y, -1, 1e-3);
  EXPECT_NEAR(off("plane").y, 0, 1e-3);
  EXPECT_NEAR(off("lift").y, 1 - g / 100, 1e-3);
  // Along the arm, which is turned down by half a radian.
  EXPECT_NEAR(off("hinge with bounds").y, -0.35 * std::sin(0.5), 1e-3);
  EXPECT_NEAR(off("cone").y, -0.35 * std::sin(0.4), 1e-3);
  EXPECT_NEAR(off("spring").y, -0.5 - 2 * g / 200, 0.4);  // it swings
}

/// Twelve balls of 1 kg fall on the paddles of one side: the wheel turns to that side and is slowed by its bearing.
TEST(SampleScenes, WaterWheel) {
  PhysicsScene scene;
  const auto axle = scene.box(0.1, 0.1, 1.5), ball = scene.ball(0.15), floor = scene.box(20, 1, 20);
  const auto paddle = scene.box(1, 0.06, 1);
  scene.node("floor", solid(floor), {0, -2.5, 0});
  const auto post = scene.node("post", solid(axle));
  const auto wheel = scene.node("wheel", {{"motion", {{"mass", 5}}}});
  for (int i = 0; i < 8; ++i) {
    const Quatd turn = Quatd::from_axis_angle({0, 0, 1}, i * pi / 4);
    scene.put_below(wheel,
                    scene.node("paddle " + std::to_string(i), solid(paddle), rotate(turn, Vec3d{0.8, 0, 0}), turn));
  }
  Json bearing = hinge();
  bearing["drives"] = {{{"type", "angular"}, {"mode", "force"}, {"axis", 2}, {"velocityTarget", 0}, {"damping", 2}}};
  join(scene, bearing, post, {}, wheel, {});
  for (int i = 0; i < 12; ++i)
    scene.node("drop " + std::to_string(i), moving(ball, 1), {0.9, 2 + 0.8 * i, i % 2 ? 0.2 : -0.2});
  const Played played(kept(scene, "sample-water-wheel", "falling balls turn the wheel"), 20);
  EXPECT_TRUE(is_finite(played));
  EXPECT_LE(LimitErrors(played).worst(), 1e-3);
  double turned = 0;
  for (const SimulationFrame& frame : played.frames) turned += frame.bodies[played.index("wheel")].angular.z / 60;
  EXPECT_LT(turned, -pi);
  EXPECT_NEAR(played.end("wheel").angular.z, 0, 0.1);
}

/// Seventeen bodies: two feet on each side, which four cranks carry round without turning them, half a turn apart, so
/// that one of a side stands while the other is lifted and put forward; and arms, head and tail that dangle.
class Robot {
 public:
  static constexpr double crank = 0.1, axle = 0.35, high = 0.25;
  /// A motor turns a crank by so much in a second.
  static constexpr double speed = 3;

  PhysicsScene scene;

  Robot() {
    scene.node("floor", solid(scene.box(40, 1, 10)), {0, -0.5, 0});
    torso_ = scene.node("torso", moving(scene.box(1, 0.2, 0.4), 10), {0, high + 0.2, 0});
    for (const double side : {-1.0, 1.0}) add_feet(side), add_arm(side);
    const auto head = scene.node("head", moving(scene.ball(0.12), 1), {0.55, high + 0.5, 0});
    join(scene, {{"limits", {together, straight({0, 1, 2})}}}, torso_, {0.4, 0.1, 0}, head, {-0.15, -0.2, 0});
    const auto tail = scene.node("tail", moving(scene.box(0.4, 0.05, 0.05), 0.2), {-0.72, high + 0.25, 0});
    Json sprung = hinge();
    sprung["drives"] = {
        {{"type", "angular"}, {"mode", "acceleration"}, {"axis", 2}, {"stiffness", 100}, {"damping", 2}}};
    join(scene, sprung, torso_, {-0.51, 0.05, 0}, tail, {0.21, 0, 0});
  }

 private:
  void add_feet(double side) {
    const auto arm = scene.box(2 * crank, 0.04, 0.04), foot = scene.box(0.9, 0.3, 0.06);
    const std::string where = side < 0 ? "left " : "right ";
    std::size_t feet[2];
    for (const int half : {0, 1}) {
      const double out = side * (half ? 0.38 : 0.3), ahead = half ? -crank : crank;
      feet[half] = scene.node(where + (half ? "second foot" : "first foot"), moving(foot, 1), {ahead, high - 0.1, out});
    }
    for (const double x : {-axle, axle}) {
      const auto turning =
          scene.node(where + (x < 0 ? "rear crank" : "front crank"), moving(arm, 0.5), {x, high, side * 0.25});
      Json motor = hinge();
      motor["drives"] = {
          {{"type", "angular"}, {"mode", "force"}, {"axis", 2}, {"velocityTarget", -speed}, {"damping", 100}}};
      join(scene, motor, torso_, {x, -0.2, side * 0.25}, turning, {});
      for (const int half : {0, 1}) {
        const double out = side * (half ? 0.13 : 0.05), ahead = half ? -crank : crank;
        join(scene, hinge(), turning, {ahead, 0, out}, feet[half], {x, 0.1, 0});
      }
    }
  }
  void add_arm(double side) {
    const auto part = scene.box(0.05, 0.16, 0.05), palm = scene.ball(0.04);
    const std::string where = side < 0 ? "left " : "right ";
    const Vec3d shoulder{0.2, high + 0.35, side * 0.55};
    const auto upper = scene.node(where + "upper arm", moving(part, 0.3), shoulder - Vec3d{0, 0.1, 0});
    const auto lower = scene.node(where + "lower arm", moving(part, 0.3), shoulder - Vec3d{0, 0.3, 0});
    const auto hand = scene.node(where + "hand", moving(palm, 0.2), shoulder - Vec3d{0, 0.42, 0});
    const Json cone{{"angularAxes", {0, 2}}, {"min", 0}, {"max", 0.6}},
        bend{{"angularAxes", {2}}, {"min", 0}, {"max", 1.5}};
    join(scene, {{"limits", {together, cone, straight({1})}}}, torso_, {0.2, 0.15, side * 0.55}, upper, {0, 0.1, 0});
    join(scene, {{"limits", {together, straight({0, 1}), bend}}}, upper, {0, -0.1, 0}, lower, {0, 0.1, 0});
    join(scene, {{"limits", {together, straight({0, 1, 2})}}}, lower, {0, -0.1, 0}, hand, {0, 0.02, 0});
  }

  std::size_t torso_ = 0;
};

/// A step is as long as a foot goes back on the ground, twice a crank; there are two in a turn.
TEST(SampleScenes, ARobotWalks) {
  const Played played(kept(Robot().scene, "sample-robot", "it walks on"), 20);
  EXPECT_EQ(played.moving.size(), 17u);
  EXPECT_TRUE(is_finite(played));
  EXPECT_LE(LimitErrors(played).worst(), 1e-3);
  const double way = 4 * Robot::crank * 20 * Robot::speed / (2 * pi);
  EXPECT_NEAR(played.end("torso").pose.translation.x, way, 0.1 * way);
  for (const SimulationFrame& frame : played.frames)
    ASSERT_GT(rotate(frame.bodies[played.index("torso")].pose.rotation, Vec3d{0, 1, 0}).y, 0.95) << frame.time;
}

}  // namespace
}  // namespace graze::io::sample_scenes_test
