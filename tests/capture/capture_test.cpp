// What was captured runs again to the same bits; a file that was cut, damaged or forged is told as what it is.
#include "graze/capture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <sstream>

#include "capture/frames.hpp"
#include "graze/error.hpp"

namespace graze::testing {
namespace {

class CaptureDraw {
 public:
  explicit CaptureDraw(unsigned seed) : random_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int count) { return static_cast<int>((*this)(0, count)); }
  template <class T>
  Vec3<T> vector(double reach) {
    const double x = (*this)(-reach, reach), y = (*this)(-reach, reach), z = (*this)(-reach, reach);
    return {T(x), T(y), T(z)};
  }
  template <class T>
  Pose<T> pose(double reach) {
    const Vec3<T> at = vector<T>(reach), v = vector<T>(1);
    return {at + Vec3<T>{T(0), T(reach), T(0)}, normalized(Quat<T>{v.x, v.y, v.z, T((*this)(0.1, 1))})};
  }

 private:
  std::mt19937 random_;
};

/// Every kind of shape that a file can hold; the last four are bounded by nothing or have no volume.
template <class T>
Shape<T> capture_shape(int kind, CaptureDraw& draw) {
  const auto size = [&] { return T(draw(0.2, 1)); };
  switch (kind) {
  case 0: return Sphere<T>(size(), {T(0.1), T(0), T(0)});
  case 1: return Capsule<T>(size(), size(), size());
  case 2: return {Box<T>({size(), size(), size()}), T(draw.below(2)) * T(0.1)};
  case 3: return Cylinder<T>(size(), size(), size());
  case 4: return Ellipsoid<T>({size(), size(), size()});
  case 5: {
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 20; ++i) points.push_back(draw.vector<T>(0.5));
    return ConvexHull<T>(points);
  }
  case 6:
    return Compound<T>({{capture_shape<T>(draw.below(6), draw), draw.pose<T>(0.3)},
                        {Compound<T>({{capture_shape<T>(draw.below(6), draw), draw.pose<T>(0.3)}}), {}}});
  case 7: return HalfSpace<T>();
  case 8: {
    std::vector<T> heights(25);
    for (T& h : heights) h = T(draw(-0.2, 0.2));
    heights[12] = std::numeric_limits<T>::quiet_NaN();
    return HeightField<T>(5, 5, std::move(heights), T(3), T(3), Sides::front);
  }
  case 9:
    return Mesh<T>({{T(-9), T(0), T(-9)}, {T(9), T(0), T(-9)}, {T(9), T(0), T(9)}, {T(-9), T(-1), T(9)}},
                   {{0, 2, 1}, {0, 3, 2}});
  case 10: return Rectangle<T>(T(4), T(5));
  case 11: return Triangle<T>({T(0), T(0), T(0)}, {T(3), T(0), T(0)}, {T(0), T(0), T(3)});
  default: return LineSegment<T>({T(0), T(0), T(0)}, {T(1), T(0), T(0)});
  }
}
constexpr int captured_solids = 7, captured_shapes = 13;

/// A run with every call of a simulation, as a file.
template <class T>
std::string random_simulation(unsigned seed, int frames) {
  CaptureDraw draw(seed);
  std::ostringstream out;
  SimulationSettings<T> settings;
  settings.sub_steps = 2;
  CapturedSimulation<T> s(&out, settings);
  std::vector<BodyId> bodies;
  std::vector<JointId> joints;
  for (int i = captured_solids; i < captured_shapes; ++i) {
    Body<T> floor{capture_shape<T>(i, draw), Pose<T>{{T(0), T(-i), T(0)}, {}}};
    floor.fixed = true;
    s.add(floor);
  }
  const auto body = [&] { return bodies[static_cast<std::size_t>(draw.below(static_cast<int>(bodies.size())))]; };
  for (int frame = 0; frame < frames; ++frame) {
    Dynamics<T> dynamics;
    if (draw.below(2) == 0) dynamics.mass = T(draw(1, 10));
    Body<T> added{capture_shape<T>(draw.below(captured_solids), draw), draw.pose<T>(3), draw.vector<T>(3)};
    added.fast = draw.below(3) == 0;
    bodies.push_back(s.add(added, dynamics, Material<T>{T(0.5), T(0.4), T(0.3)}));
    switch (draw.below(12)) {
    case 0: s.apply_impulse(body(), draw.vector<T>(3), draw.vector<T>(1)); break;
    case 1: s.apply_angular_impulse(body(), draw.vector<T>(1)); break;
    case 2: s.apply_force(body(), draw.vector<T>(30)); break;
    case 3: s.apply_torque(body(), draw.vector<T>(3)); break;
    case 4: s.set_velocity(body(), {draw.vector<T>(3), draw.vector<T>(3)}); break;
    case 5: s.set_pose(body(), draw.pose<T>(3)); break;
    case 6: s.set_material(body(), {}); break;
    case 7:
      if (draw.below(2) == 0)
        s.wake(body());
      else
        s.set_filter(body(), {.category = 1, .mask = draw.below(2) == 0 ? 0u : ~0u});
      break;
    case 8: s.set_gravity(draw.vector<T>(9)); break;
    case 9:
      if (bodies.size() > 2) {
        s.remove(bodies.back());
        bodies.pop_back();
      }
      break;
    case 10: {
      const BodyId a = body(), b = body();
      if (a == b) break;
      Joint<T> joint = distance_joint<T>(a, {}, b, {}, T(0.5), T(3));
      joint.drives.push_back({JointSpace::angular, DriveMode::acceleration, 1, T(0), T(1), T(0), T(2)});
      joints.push_back(s.add(joint));
      joint.drives[0].velocity_target = T(-2);
      if (draw.below(2) == 0) s.set_joint(joints.back(), joint);
      break;
    }
    default:
      if (!joints.empty() && draw.below(2) == 0) {
        try {
          s.remove(joints.back());  // may have gone with its body: what is refused is not written
        } catch (const InvalidValue&) {
        }
        joints.pop_back();
      }
    }
    s.step(T(1) / T(60));
  }
  return out.str();
}

template <class T>
std::string random_world(unsigned seed, int frames) {
  CaptureDraw draw(seed);
  std::ostringstream out;
  CapturedWorld<T> w(&out, WorldSettings<T>{T(0.05), {}, 6});
  std::vector<BodyId> bodies;
  for (int frame = 0; frame < frames; ++frame) {
    Body<T> added{capture_shape<T>(draw.below(captured_shapes), draw), draw.pose<T>(2), draw.vector<T>(3)};
    added.fast = draw.below(2) == 0 && added.shape.convex();
    added.trigger = draw.below(5) == 0;
    bodies.push_back(w.add(added));
    const BodyId any = bodies[static_cast<std::size_t>(draw.below(static_cast<int>(bodies.size())))];
    switch (draw.below(6)) {
    case 0: w.move(any, draw.pose<T>(2)); break;
    case 1: w.move(any, draw.pose<T>(2), draw.vector<T>(2), draw.vector<T>(1)); break;
    case 2: w.set_shape(any, capture_shape<T>(draw.below(captured_solids), draw)); break;
    case 3: w.set_filter(any, {2, ~std::uint64_t{2}, -1}); break;
    case 4: w.set_fast(any, false); break;
    default: w.remove(bodies.back()); bodies.pop_back();
    }
    if (!bodies.empty() && draw.below(3) == 0)
      w.set_name(bodies.back(), std::string(static_cast<std::size_t>(draw.below(9)), 'n'));
    w.update(T(draw.below(2)) / T(30));
    if (draw.below(3) == 0) w.find_impacts(T(0.1));
  }
  return out.str();
}

ReplayReport replayed(const std::string& file) {
  std::istringstream in(file);
  return replay(in, "test");
}

TEST(Capture, ASimulationRunsAgainToTheSameBits) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const ReplayReport f = replayed(random_simulation<float>(seed, 40));
    EXPECT_TRUE(f.simulation && f.single && !f.cut);
    EXPECT_EQ(f.frames, 40u);
    EXPECT_FALSE(f.difference) << seed << ": " << f.difference->what;
    const ReplayReport d = replayed(random_simulation<double>(seed, 40));
    EXPECT_TRUE(d.simulation && !d.single);
    EXPECT_FALSE(d.difference) << seed << ": " << d.difference->what;
  }
}

TEST(Capture, AWorldRunsAgainToTheSameBits) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const ReplayReport f = replayed(random_world<float>(seed, 30));
    EXPECT_TRUE(!f.simulation && f.single && !f.cut);
    EXPECT_GE(f.frames, 30u);
    EXPECT_FALSE(f.difference) << seed << ": " << f.difference->what;
    const ReplayReport d = replayed(random_world<double>(seed, 30));
    EXPECT_FALSE(d.difference) << seed << ": " << d.difference->what;
  }
}

TEST(Capture, AStateIsBroughtBackInAReplayToo) {
  std::ostringstream out;
  CapturedSimulation<float> s(&out);
  Body<float> floor{HalfSpace<float>()};
  floor.fixed = true;
  s.add(floor);
  for (int i = 0; i < 4; ++i)
    s.add({Box<float>({1, 1, 1}), {{0.1f * static_cast<float>(i), 1.2f * static_cast<float>(i) + 1, 0}, {}}});
  for (int i = 0; i < 60; ++i) {
    if (i == 20) s.save(1);
    if (i == 40 || i == 50) s.restore(1);
    s.step(1.0f / 60);
  }
  const ReplayReport report = replayed(out.str());
  EXPECT_EQ(report.frames, 60u);
  EXPECT_FALSE(report.difference) << report.difference->what;
}

TEST(Capture, MaterialsOfPiecesComeBackInAReplay) {
  std::ostringstream out;
  CapturedSimulation<float> s(&out, {});
  const Shape<float> slab = Box<float>({8, 1, 4});
  Body<float> floor{Compound<float>({{slab, {{0, -0.5f, -2}, {}}}, {slab, {{0, -0.5f, 2}, {}}}})};
  floor.fixed = true;
  const BodyId ground = s.add(floor);
  Material<float> ice{0, 0}, belt;
  ice.friction_combine = Combine::minimum;
  belt.surface_velocity = {-3, 0, 0};
  s.set_materials(ground, std::vector<Material<float>>{ice, belt}, std::vector<std::uint32_t>{0, 1});
  const BodyId on_ice = s.add({Box<float>({1, 1, 1}), {{0, 0.5f, -2}, {}}});
  const BodyId on_belt = s.add({Box<float>({1, 1, 1}), {{0, 0.5f, 2}, {}}});
  for (int i = 0; i < 30; ++i) s.step(1.0f / 60);
  EXPECT_EQ(s.simulation().motion(on_ice).linear.x, 0);
  EXPECT_LT(s.simulation().motion(on_belt).linear.x, -1);
  const ReplayReport report = replayed(out.str());
  EXPECT_EQ(report.frames, 30u);
  EXPECT_FALSE(report.difference) << report.difference->what;
}

TEST(Capture, WithoutAStreamItIsOnlyASimulation) {
  Simulationd plain;
  CapturedSimulation<double> captured(nullptr);
  for (int i = 0; i < 3; ++i) {
    const Body<double> box{Box<double>({1, 1, 1}), {{0.1 * i, 1.1 * i, 0}, {}}};
    plain.add(box);
    captured.add(box);
  }
  for (int i = 0; i < 30; ++i) plain.step(0.01), captured.step(0.01);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(plain.poses()[i], captured.simulation().poses()[i]);
}

TEST(Capture, AFrameIsInTheStreamWhenItsCallReturns) {
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  world.add({Sphere<double>(1)});
  world.update();
  EXPECT_EQ(replayed(out.str()).frames, 1u);
  world.add({Sphere<double>(1)});
  EXPECT_EQ(replayed(out.str()).frames, 1u);
  world.update();
  EXPECT_EQ(replayed(out.str()).frames, 2u);
}

/// Two balls that are apart, of which one is called something, and later something else.
std::string named_world() {
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  const BodyId door = world.add({Sphere<double>(1)}), other = world.add({Sphere<double>(1), {{9, 0, 0}, {}}});
  world.set_name(door, "door");
  world.update();
  world.set_name(door, "window");
  world.remove(other);
  EXPECT_THROW(world.set_name(other, "gone"), InvalidValue);
  world.update();
  return out.str();
}

TEST(Capture, BodiesHaveTheNamesThatTheyWereGiven) {
  std::istringstream in(named_world());
  std::vector<std::string> names;
  const ReplayReport report = replay(in, "test", [&](std::size_t, const Replayed& played, const BodyNames& of) {
    EXPECT_TRUE(std::holds_alternative<const Worldd*>(played));
    names.emplace_back(of.of({0, 0}));
    EXPECT_EQ(of.of({1, 0}), "");
  });
  EXPECT_EQ(names, (std::vector<std::string>{"door", "window"}));
  EXPECT_EQ(report.calls, 8u) << "a shape, two bodies, a name, an update, and a name, a removal and an update";
  ASSERT_EQ(report.names.all().size(), 1u);
  EXPECT_EQ(report.names.all().begin()->second, "window");

  std::ostringstream out;
  CapturedSimulation<float> simulation(&out), plain(nullptr);
  for (auto* s : {&simulation, &plain}) s->set_name(s->add({Sphere<float>(1)}), "ball");
  EXPECT_THROW(plain.set_name({5, 0}, "none"), InvalidValue);
  simulation.step(0.01f);
  EXPECT_EQ(replayed(out.str()).names.of({0, 0}), "ball");
}

/// A capture of a simulation without the last of its settings.
std::string without_warm_start(std::string file) {
  constexpr std::size_t length_at = 20, sum_at = 28, settings_at = 36;
  std::uint64_t size = 0;
  std::memcpy(&size, file.data() + length_at, sizeof(size));
  file.erase(settings_at + static_cast<std::size_t>(--size), 1);
  const std::uint64_t sum =
      capture::checksum(std::string_view(file).substr(settings_at, static_cast<std::size_t>(size)));
  std::memcpy(file.data() + length_at, &size, sizeof(size));
  std::memcpy(file.data() + sum_at, &sum, sizeof(sum));
  return file;
}

/// A capture as an earlier version wrote it: without the calls that came later it is the same but for its number and,
/// of a simulation, the last setting.
std::string of_version(char version, std::string file) {
  EXPECT_EQ(file[16], 6);
  const bool simulation = file[18] % 2 == 1;
  file[16] = version;
  return version < 5 && simulation ? without_warm_start(file) : file;
}

TEST(Capture, VersionsBeforeAreRead) {
  for (const char version : {'\2', '\3', '\4', '\5'}) {
    const ReplayReport report = replayed(of_version(version, random_simulation<float>(2, 10)));
    EXPECT_EQ(report.frames, 10u);
    EXPECT_FALSE(report.difference);
  }
  // Version 2 has no call that names a body.
  EXPECT_THROW(replayed(of_version(2, named_world())), InvalidValue);
  EXPECT_NO_THROW(replayed(of_version(3, named_world())));
}

TEST(Capture, EqualShapesAreWrittenOnce) {
  const auto size = [](int bodies) {
    std::ostringstream out;
    CapturedWorld<float> world(&out);
    std::vector<Vec3f> points;
    CaptureDraw draw(7);
    for (int i = 0; i < 200; ++i) points.push_back(normalized(draw.vector<float>(1)));
    const Shapef hull = ConvexHull<float>(points);
    for (int i = 0; i < bodies; ++i) world.add({hull, {{3.0f * static_cast<float>(i), 0, 0}, {}}});
    world.update();
    return out.str().size();
  };
  EXPECT_LT(size(100) - size(1), 99u * 100) << "a hundred bytes a body";
}

TEST(Capture, AFileThatWasCutHasItsWholeFrames) {
  const std::string whole = random_world<double>(3, 6);
  std::map<std::size_t, std::size_t> cuts;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      const ReplayReport report = replayed(whole.substr(0, length));
      EXPECT_FALSE(report.difference);
      ++cuts[report.frames];
    } catch (const InvalidValue& e) {
      EXPECT_LT(length, 20u) << "only what has no beginning is no capture";
      EXPECT_NE(std::string(e.what()).find("test"), std::string::npos);
    }
  }
  EXPECT_GE(cuts.size(), 6u);
  std::istringstream in(whole.substr(0, whole.size() - 1));
  EXPECT_TRUE(replay(in, "test").cut);
}

TEST(Capture, DamageIsFoundAndNamedByItsFrame) {
  const std::string whole = random_world<double>(4, 4);
  std::size_t named = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    try {
      // Of a length that grew so far that the file ends before it, it can only be said that it is cut.
      EXPECT_TRUE(replayed(damaged).cut) << "byte " << at;
    } catch (const InvalidValue& e) {
      named += std::string(e.what()).find("frame") != std::string::npos ? 1 : 0;
    }
  }
  EXPECT_GT(named, whole.size() / 2);
}

/// A frame of a file with a checksum that fits.
std::string forged(const std::string& file, std::size_t frame, const std::function<void(std::string&)>& change) {
  std::size_t at = 20;
  const auto length_at = [&](std::size_t from) {
    std::uint64_t length = 0;
    std::memcpy(&length, file.data() + from, 8);
    return static_cast<std::size_t>(length);
  };
  for (; frame > 0; --frame) at += 16 + length_at(at);
  std::string bytes = file.substr(at + 16, length_at(at));
  const std::string rest = file.substr(at + 16 + bytes.size());
  change(bytes);
  std::uint64_t sum = 0xcbf29ce484222325u, length = bytes.size();
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  std::string head(16, '\0');
  std::memcpy(head.data(), &length, 8);
  std::memcpy(head.data() + 8, &sum, 8);
  return file.substr(0, at) + head + bytes + rest;
}

TEST(Capture, WhatComesOutOtherwiseIsToldByFrameAndCall) {
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  const BodyId ball = world.add({Sphere<double>(1)});
  world.update();
  world.move(ball, {{1, 0, 0}, {}});
  world.update();
  world.update();
  // The first number of the place that the body is moved to: behind the call and the handle.
  const ReplayReport report = replayed(forged(out.str(), 2, [](std::string& bytes) {
    const double other = 2;
    std::memcpy(bytes.data() + 1 + 8, &other, 8);
  }));
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.frames, 1u);
  EXPECT_EQ(report.difference->frame, 2u);
  EXPECT_EQ(report.difference->call, 2u);
  EXPECT_EQ(report.difference->what, "update: other poses");
}

TEST(Capture, ACallThatIsRefusedIsADifference) {
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  const BodyId ball = world.add({Sphere<double>(1)});
  world.update();
  world.remove(ball);
  world.update();
  const ReplayReport report = replayed(forged(out.str(), 2, [](std::string& bytes) { bytes[1] = 77; }));
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.difference->call, 1u);
  EXPECT_TRUE(report.difference->what.starts_with("remove is refused")) << report.difference->what;
  EXPECT_EQ(report.difference->body->index, 77u);
}

TEST(Capture, ALongerNameThanTheFileHasIsDamage) {
  // The count of the first name: behind the shape's number, one ball, two bodies, the call and the handle.
  const std::string file = named_world();
  const std::size_t at = file.find("door") - 8;
  std::size_t begin = 20;
  std::uint64_t settings = 0;
  std::memcpy(&settings, file.data() + begin, 8);
  const std::size_t in_frame = at - (begin + 16 + static_cast<std::size_t>(settings)) - 16;
  for (const std::uint64_t count : {std::uint64_t{1} << 20, ~std::uint64_t{0}}) {
    const std::string bad = forged(file, 1, [&](std::string& bytes) { std::memcpy(&bytes[in_frame], &count, 8); });
    try {
      replayed(bad);
      FAIL();
    } catch (const InvalidValue& e) {
      EXPECT_NE(std::string(e.what()).find("longer than its frame"), std::string::npos) << e.what();
    }
  }
  // A name for a body that is not there is something that the run did not say.
  const ReplayReport report = replayed(forged(file, 1, [&](std::string& bytes) { bytes[in_frame - 8] = 77; }));
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.difference->what, "set_name: no such body");
  EXPECT_EQ(report.difference->body, (BodyId{77, 0}));
}

TEST(Capture, ForgedFramesAreRefusedOrPlayedAndNeverMore) {
  CaptureDraw draw(11);
  const std::string world = random_world<float>(5, 8), simulation = random_simulation<double>(5, 6);
  for (int i = 0; i < 3000; ++i) {
    const std::string& file = i % 2 ? world : simulation;
    const std::string bad = forged(file, static_cast<std::size_t>(draw.below(6)), [&](std::string& bytes) {
      for (int k = 0; k < 3 && !bytes.empty(); ++k)
        bytes[static_cast<std::size_t>(draw.below(static_cast<int>(bytes.size())))] =
            static_cast<char>(draw.below(256));
      if (draw.below(4) == 0) bytes.resize(static_cast<std::size_t>(draw.below(static_cast<int>(bytes.size()) + 1)));
    });
    try {
      replayed(bad);
    } catch (const InvalidValue&) {
    }
  }
}

TEST(Capture, WhatIsNoCaptureIsSaidToBeNone) {
  for (const std::string& text : {std::string(), std::string("graze capture"), std::string(1000, 'x')})
    EXPECT_THROW(replayed(text), InvalidValue);
  std::string later = random_world<double>(0, 1);
  later[16] = 9;
  try {
    replayed(later);
    FAIL();
  } catch (const InvalidValue& e) {
    EXPECT_NE(std::string(e.what()).find("version 9"), std::string::npos) << e.what();
  }
}

TEST(Capture, WhatAFileCannotHoldIsRefused) {
  class Point final : public SupportFunction<double> {
   public:
    Vec3d support(const Vec3d&) const override { return {}; }
  };
  std::ostringstream out;
  CapturedWorld<double> world(&out);
  EXPECT_THROW(world.add({UserConvex<double>(std::make_shared<Point>())}), InvalidValue);
  EXPECT_EQ(world.world().bodies().count(), 0u);
  WorldSettings<double> settings;
  settings.allow = [](BodyId, BodyId) { return true; };
  EXPECT_THROW(CapturedWorld<double>(&out, settings), InvalidValue);
  out.setstate(std::ios::badbit);
  world.add({Sphere<double>(1)});
  EXPECT_THROW(world.update(), InvalidValue);
}

}  // namespace
}  // namespace graze::testing
