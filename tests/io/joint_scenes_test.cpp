// The subjects of KHR_physics_rigid_bodies' joint scenes, as scenes of our own, against closed forms; and what playing
// a scene promises besides.
#include <gtest/gtest.h>

#include "kept_scene.hpp"

namespace graze::io::joint_scenes_test {
namespace {

using Json = nlohmann::json;

constexpr double g = 9.81;
const double pi = std::acos(-1.0);

/// A fixed box at the origin and a body on it by a joint between two nodes: `pivot`, below the fixed box, and `socket`,
/// below the body, which starts where the two agree.
PhysicsScene jointed(const Json& joint, const Vec3d& pivot, const Vec3d& socket, const Quatd& turn = {},
                     const Json& motion = {{"mass", 2}}, bool collide = false) {
  PhysicsScene scene;
  const auto cube = scene.box(1, 1, 1);
  const Json geometry{{"geometry", {{"shape", cube}}}};
  const auto fixed = scene.node("fixed", {{"collider", geometry}});
  const auto at = pivot - rotate(turn, socket);
  const auto body = scene.node("body", {{"collider", geometry}, {"motion", motion}}, at, turn);
  const auto end = scene.node("socket", nullptr, socket, conjugate(turn) * turn);
  scene.put_below(body, end);
  const auto start = scene.node(
      "pivot", {{"joint", {{"joint", scene.joint(joint)}, {"connectedNode", end}, {"enableCollision", collide}}}},
      pivot, turn);
  scene.put_below(fixed, start);
  return scene;
}

double gap(const Played& played, const SimulationFrame& frame, const Vec3d& pivot, const Vec3d& socket) {
  return length(transform(frame.bodies[played.index("body")].pose, socket) - pivot);
}

TEST(JointScenes, FixedStays) {
  const Played played(kept(jointed({{"limits", {together, straight({0, 1, 2})}}}, {2, 0, 0}, {-1, 0, 0}),
                           "joint-00-fixed", "nothing moves"));
  for (const SimulationFrame& frame : played.frames) {
    EXPECT_LE(gap(played, frame, {2, 0, 0}, {-1, 0, 0}), 1e-3);
    EXPECT_LE(length(frame.bodies[0].pose.translation - Vec3d{3, 0, 0}), 1e-3);
  }
}

/// Energy and place of a body that only a joint holds: kept in each frame, to a hundredth of the energy of its swing.
void expect_swing(const Played& played, const Vec3d& pivot, const Vec3d& socket, double swing) {
  const double first = played.frames.front().kinetic_energy + played.frames.front().potential_energy;
  for (const SimulationFrame& frame : played.frames) {
    ASSERT_LE(gap(played, frame, pivot, socket), 1e-3) << frame.time;
    ASSERT_NEAR(frame.kinetic_energy + frame.potential_energy, first, 0.01 * swing) << frame.time;
  }
}

TEST(JointScenes, ABallTurnsAboutAllAxes) {
  const Vec3d pivot{3, 0, 0}, socket{-0.6, 1, 0.5};
  const Json motion{{"mass", 2}, {"angularVelocity", {0, 1, 0}}, {"linearVelocity", {-0.5, 0, -0.6}}};
  const Played played(
      kept(jointed({{"limits", {together}}}, pivot, socket, {}, motion), "joint-01-ball", "it swings to all sides"));
  expect_swing(played, pivot, socket, 2 * g * (length(socket) - socket.y));
  Vec3d most{};
  for (const SimulationFrame& frame : played.frames)
    for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], std::abs(frame.bodies[0].angular[i]));
  EXPECT_GT(std::min({most.x, most.y, most.z}), 0.5);
}

/// Hinges about each axis: only that one turns. About y nothing pulls, and the turn that it begins with stays.
TEST(JointScenes, HingesTurnAboutTheirAxisAlone) {
  const double d = 0.8, amplitude = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3d pivot{3, 0, 0};
    Vec3d socket{0, d * std::cos(amplitude), 0}, about{};
    about[axis] = 1;
    Json motion{{"mass", 2}};
    if (axis == 0) socket.z = d * std::sin(amplitude);
    if (axis == 2) socket.x = -d * std::sin(amplitude);
    if (axis == 1) {
      socket = {d, 0, 0};
      motion["angularVelocity"] = {0, 2, 0};
      motion["linearVelocity"] = {0, 0, 2 * d};
    }
    std::vector<int> others;
    for (int i = 0; i < 3; ++i)
      if (i != static_cast<int>(axis)) others.push_back(i);
    const char* names[] = {"joint-02-hinge-x", "joint-03-hinge-y", "joint-04-hinge-z"};
    const Played played(kept(jointed({{"limits", {together, straight(others)}}}, pivot, socket, {}, motion),
                             names[axis], "it turns about one axis alone"));
    const double swing = axis == 1 ? 2 * (1 / 6.0 + d * d) * 4 / 2 : 2 * g * d * (1 - std::cos(amplitude));
    expect_swing(played, pivot, socket, swing);
    double fastest = 0;
    for (const SimulationFrame& frame : played.frames) {
      const BodyState& body = frame.bodies[0];
      ASSERT_LE(length(body.angular - about * dot(body.angular, about)), 1e-3) << names[axis] << " " << frame.time;
      ASSERT_GE(dot(rotate(body.pose.rotation, about), about), 1 - 1e-6) << names[axis] << " " << frame.time;
      fastest = std::max(fastest, std::abs(dot(body.angular, about)));
      if (axis == 1) {
        ASSERT_NEAR(body.angular.y, 2, 0.01) << frame.time;
      }
    }
    EXPECT_GT(fastest, 1) << names[axis];
  }
}

/// On 45 degrees, 2 m either way: the block ends at -2 m; where the two collide, at the fixed box.
TEST(JointScenes, SliderSlidesToItsStop) {
  const Quatd slope = Quatd::from_axis_angle({0, 0, 1}, pi / 4);
  const Json slider{{"limits",
                     {{{"linearAxes", {1, 2}}, {"min", 0}, {"max", 0}},
                      straight({0, 1, 2}),
                      {{"linearAxes", {0}}, {"min", -2}, {"max", 2}}}}};
  const Played free(kept(jointed(slider, {}, {}, slope), "joint-05-slider", "it slides to its stop, 2 m down"));
  const Vec3d axis = rotate(slope, Vec3d{1, 0, 0});
  EXPECT_LE(length(free.end("body").pose.translation + axis * 2.0), 1e-3);
  // From above along the axis: the cubes, both 1 m wide, meet. The fixed one is not turned, so the gap is found at
  // rest.
  PhysicsScene scene = jointed(slider, {}, {}, slope, {{"mass", 2}}, true);
  scene.at(1)["translation"] = {axis.x * 1.9, axis.y * 1.9, 0};
  const Played colliding(kept(scene, "joint-06-slider-collides", "it slides to the fixed box"));
  const double way = dot(colliding.end("body").pose.translation, axis);
  EXPECT_NEAR(way, 0.5 + std::sqrt(0.5), 2e-3);
}

/// No further than 1 m apart, ever.
TEST(JointScenes, DistanceIsNeverLonger) {
  const Played played(
      kept(jointed({{"limits", {{{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 1}}}}}, {3, 0, 0}, {0.5, 0.5, 0.5}),
           "joint-07-distance", "a corner is never further than 1 m away"));
  for (const SimulationFrame& frame : played.frames)
    ASSERT_LE(gap(played, frame, {3, 0, 0}, {0.5, 0.5, 0.5}), 1.001) << frame.time;
}

/// A hinge off the centre of mass is a pendulum of period 2 pi sqrt(I / m g d), I about the hinge, a little longer for
/// a swing that is not small: (1 + a^2 / 16) of an amplitude a.
TEST(JointScenes, AHingeOffTheCentreSwings) {
  const double d = 0.5, amplitude = 0.3;
  const Vec3d pivot{3, 0, 0}, socket{-d * std::sin(amplitude), d * std::cos(amplitude), 0};
  const Played played(kept(jointed({{"limits", {together, straight({0, 1})}}}, pivot, socket), "joint-08-hinge",
                           "a pendulum, whose hinge is off the centre of mass"));
  const double first = played.frames.front().potential_energy, deep = 2 * g * d * (1 - std::cos(amplitude));
  std::vector<double> crossings;
  double before = d * std::sin(amplitude);
  for (const SimulationFrame& frame : played.frames) {
    const BodyState& body = frame.bodies[0];
    EXPECT_LE(gap(played, frame, pivot, socket), 1e-3) << frame.time;
    EXPECT_NEAR(body.angular.x, 0, 1e-6);
    EXPECT_NEAR(body.angular.y, 0, 1e-6);
    EXPECT_NEAR(frame.kinetic_energy + frame.potential_energy, first, 0.01 * deep) << frame.time;
    const double beside = body.pose.translation.x - pivot.x;
    if ((beside < 0) != (before < 0)) crossings.push_back(frame.time - beside / (beside - before) / 60);
    before = beside;
  }
  ASSERT_GE(crossings.size(), 3u);
  const double period = 2 * pi * std::sqrt((1 / 6.0 + d * d) / (g * d)) * (1 + amplitude * amplitude / 16);
  const double measured = 2 * (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  EXPECT_NEAR(measured / period, 1, 0.003);
}

TEST(JointScenes, AngularDriveReachesItsSpeed) {
  const Json drive{
      {"type", "angular"}, {"mode", "acceleration"}, {"axis", 0}, {"velocityTarget", pi / 2}, {"damping", 1}};
  const Played played(kept(jointed({{"limits", {together, straight({1, 2})}}, {"drives", {drive}}}, {3, 0, 0}, {}),
                           "joint-09-angular-drive", "it comes to a quarter turn a second"));
  for (const SimulationFrame& frame : played.frames)
    EXPECT_NEAR(frame.bodies[0].angular.x, pi / 2 * (1 - std::exp(-frame.time)), 0.005) << frame.time;
}

TEST(JointScenes, LinearDriveRestsUnderItsWeight) {
  const Json drive{{"type", "linear"},    {"mode", "acceleration"}, {"axis", 1},
                   {"positionTarget", 2}, {"stiffness", 100},       {"damping", 1}};
  const Json limits{{{"linearAxes", {0, 2}}, {"min", 0}, {"max", 0}}, straight({0, 1, 2})};
  const Played played(kept(jointed({{"limits", limits}, {"drives", {drive}}}, {3, 0, 0}, {}), "joint-10-linear-drive",
                           "it swings and rests under its weight, at 1.902 m"),
                      20);
  const double rest = 2 - g / 100, w = std::sqrt(99.75);
  for (const SimulationFrame& frame : played.frames) {
    const double t = frame.time;
    if (t > 2) break;
    const double exact = rest - rest * std::exp(-t / 2) * (std::cos(w * t) + std::sin(w * t) / (2 * w));
    EXPECT_NEAR(frame.bodies[0].pose.translation.y, exact, 0.03) << t;
  }
  EXPECT_NEAR(played.end("body").pose.translation.y, rest, 1e-3);
}

/// A pile with a joint, played twice, with other threads, and in float: the first three to the last bit.
TEST(JointScenes, SameFramesEveryTime) {
  const PhysicsScene scene = jointed({{"limits", {together}}}, {0.2, 2, 0}, {0.4, 0.3, 0.2}, {}, {{"mass", 1}}, true);
  class Backwards final : public Executor {
   public:
    std::size_t concurrency() const override { return 4; }
    void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
      while (count-- > 0) task(count);
    }
  } backwards;
  SimulateOptions other;
  other.executor = &backwards;
  const Played one(scene, 3), two(scene, 3), three(scene, 3, other);
  other.precision = Precision::single_precision;
  const Played single(scene, 3, other);
  ASSERT_EQ(one.frames.size(), 181u);
  for (std::size_t i = 0; i < one.frames.size(); ++i) {
    EXPECT_EQ(one.frames[i].bodies[0].pose, two.frames[i].bodies[0].pose);
    EXPECT_EQ(one.frames[i].bodies[0].pose, three.frames[i].bodies[0].pose);
    if (one.frames[i].time > 0.5) continue;
    EXPECT_LE(length(one.frames[i].bodies[0].pose.translation - single.frames[i].bodies[0].pose.translation), 1e-3);
  }
}

/// What the file's animation moves follows it, and carries what lies on it.
TEST(JointScenes, AnimatedNodesLead) {
  PhysicsScene scene;
  const auto plate = scene.box(6, 1, 6), cube = scene.box(1, 1, 1);
  const auto lift = scene.node("lift", {{"collider", {{"geometry", {{"shape", plate}}}}}}, {0, -0.5, 0});
  scene.node("crate", {{"collider", {{"geometry", {{"shape", cube}}}}}, {"motion", {{"mass", 1}}}}, {0, 0.5, 0});
  scene.animate(lift, {0, 2}, {0, -0.5f, 0, 0, 1.5f, 0});
  const Played played(scene, 3);
  EXPECT_NEAR(played.place("crate", 1).y, 1.5, 0.005);
  EXPECT_NEAR(played.end("crate").pose.translation.y, 2.5, 0.01);
}

/// A collider begins where its animation has it at time 0, not at rest, and so sweeps through nothing on its way there.
TEST(JointScenes, AnimationsBeginAtTheirFirstKey) {
  for (const bool kinematic : {false, true}) {
    PhysicsScene scene;
    const auto cube = scene.box(1, 1, 1), ball = scene.ball(0.5);
    Json physics{{"collider", {{"geometry", {{"shape", cube}}}}}};
    if (kinematic) physics["motion"] = {{"isKinematic", true}};
    const auto pusher = scene.node("pusher", physics);
    scene.node("ball", {{"collider", {{"geometry", {{"shape", ball}}}}}, {"motion", {{"gravityFactor", 0}}}},
               {0, 5, 0});
    scene.animate(pusher, {0, 1}, {0, 10, 0, 0, 10, 0});
    const Played played(scene, 0.1);
    for (const double time : {0.0, 0.1}) {
      EXPECT_EQ(played.place("ball", time), (Vec3d{0, 5, 0})) << kinematic;
      if (!kinematic) continue;  // the pusher is no moving body then
      EXPECT_EQ(played.place("pusher", time), (Vec3d{0, 10, 0}));
    }
  }
}

/// A collider whose animation scales it at time 0 begins with that size, too: the crate stands on a plate of 2 x 2 x 2.
TEST(JointScenes, AnimationsBeginWithTheirFirstScale) {
  PhysicsScene scene;
  const auto cube = scene.box(1, 1, 1);
  const auto plate = scene.node("plate", {{"collider", {{"geometry", {{"shape", cube}}}}}});
  scene.node("crate", {{"collider", {{"geometry", {{"shape", cube}}}}}, {"motion", {{"mass", 1}}}}, {0, 1.5, 0});
  scene.animate(plate, {0, 1}, {2, 2, 2, 2, 2, 2}, "scale");
  EXPECT_NEAR(Played(scene, 1).end("crate").pose.translation.y, 1.5, 0.005);
}

/// A body without a collider follows its animation, and what hangs on it by a joint goes along.
TEST(JointScenes, AnimatedNodesWithoutCollidersLead) {
  for (const bool trigger : {false, true}) {
    PhysicsScene scene;
    const auto pole = scene.box(0.2, 1, 0.2);
    const auto held = scene.joint({{"limits", {together}}});
    Json physics{{"motion", {{"isKinematic", true}}}};
    if (trigger) physics["trigger"] = {{"geometry", {{"shape", pole}}}};
    const auto anchor = scene.node("anchor", physics);
    const auto rod =
        scene.node("rod", {{"collider", {{"geometry", {{"shape", pole}}}}}, {"motion", {{"mass", 2}}}}, {0, -0.5, 0});
    const auto end = scene.node("end", nullptr, {0, 0.5, 0});
    scene.put_below(rod, end);
    scene.at(anchor)["extensions"]["KHR_physics_rigid_bodies"]["joint"] = {{"connectedNode", end}, {"joint", held}};
    scene.animate(anchor, {0, 1}, {1, 0, 0, 6, 0, 0});
    scene.at(rod)["translation"] = {1, -0.5, 0};
    const Played played(scene, 1);
    EXPECT_EQ(played.place("anchor", 0), (Vec3d{1, 0, 0}));
    EXPECT_LE(length(played.place("anchor", 0.5) - Vec3d{3.5, 0, 0}), 1e-9);
    EXPECT_LE(length(played.end("anchor").pose.translation - Vec3d{6, 0, 0}), 1e-9);
    EXPECT_LE(length(transform(played.end("rod").pose, Vec3d{0, 0.5, 0}) - Vec3d{6, 0, 0}), 0.01);
  }
}

/// Files that are put together keep which bodies their animations move.
TEST(JointScenes, AnimatedBodiesOfASecondFileFollow) {
  PhysicsScene still, moved;
  still.node("still", {{"motion", {{"isKinematic", true}}}}, {0, 1, 0});
  const auto anchor = moved.node("anchor", {{"motion", {{"isKinematic", true}}}});
  moved.animate(anchor, {0, 1}, {1, 0, 0, 6, 0, 0});
  Scene scene = still.load();
  append(scene, moved.load());
  SimulateOptions options;
  options.seconds = 1;
  SimulationFrame last;
  simulate(scene, options, [&](const SimulationFrame& frame) { last = frame; });
  EXPECT_EQ(last.bodies.at(0).pose.translation, (Vec3d{0, 1, 0}));
  EXPECT_LE(length(last.bodies.at(1).pose.translation - Vec3d{6, 0, 0}), 1e-9);
}

TEST(JointScenes, WhatCannotBePlayedIsNamed) {
  const auto refusal = [](const PhysicsScene& scene, const SimulateOptions& options = {}) -> std::string {
    try {
      simulate(scene.load(), options, [](const SimulationFrame&) {});
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "played";
  };
  PhysicsScene scene;
  const auto flat = scene.shape({{"type", "plane"}, {"plane", {{"sizeX", 1}, {"sizeZ", 1}}}});
  scene.node("leaf", {{"collider", {{"geometry", {{"shape", flat}}}}}, {"motion", Json::object()}});
  EXPECT_EQ(refusal(scene), "scene.gltf: leaf.motion.mass: expected a value, of a body without volume, got nothing");
  SimulateOptions options;
  options.seconds = -1;
  EXPECT_EQ(refusal(scene, options), "seconds: expected a finite number >= 0, got -1");
  options = {};
  options.rate = 0;
  EXPECT_EQ(refusal(scene, options), "rate: expected a finite number >= 1, got 0");
}

}  // namespace
}  // namespace graze::io::joint_scenes_test
