// Worlds, simulations and trees are drawn as they are: each body by what it does, joints, and the boxes around them.
#include <gtest/gtest.h>

#include "draw/draw_recorder.hpp"

namespace graze::testing {
namespace {

TEST(DrawnWorlds, AWorldShowsEveryBodyByWhatItDoes) {
  Worldd world;
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  world.add(floor);
  world.add({Box<double>({1, 1, 1}), {{0, 0.49, 0}, {}}});
  world.add({Sphere<double>(0.5), {{5, 5, 0}, {}}});
  Body<double> zone{Sphere<double>(2), {{0, 0, 0}, {}}};
  zone.trigger = zone.fixed = true;
  world.add(zone);
  const BodyId gone = world.add({Sphere<double>(1), {{0, 0, 9}, {}}});
  world.remove(gone);
  world.update();

  DrawRecorder drawn(draw_area(world));
  draw(drawn, world);
  const std::map<DrawMeaning, bool> expected{{DrawMeaning::touched, true}, {DrawMeaning::touching, true},
                                             {DrawMeaning::moving, true},  {DrawMeaning::trigger, true},
                                             {DrawMeaning::fixed, false},  {DrawMeaning::asleep, false}};
  for (const auto& [meaning, there] : expected)
    EXPECT_EQ(count_of(drawn.triangles, DrawLayer::shapes, meaning) > 0, there) << int(meaning);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::contacts, DrawMeaning::contact), world.contacts().points.size());
  EXPECT_EQ(world.contacts().points.size(), 4u);
  EXPECT_EQ(count_of(drawn.lines, DrawLayer::bounds, DrawMeaning::bounds), 3u * 12) << "the floor has no bounds";
  EXPECT_GE(count_of(drawn.lines, DrawLayer::tree, DrawMeaning::bounds), 3u * 12) << "those in the tree, and its nodes";

  DrawRecorder without(draw_area(world));
  without.off = DrawLayer::shapes;
  draw(without, world);
  EXPECT_TRUE(without.triangles.empty());
  EXPECT_EQ(without.points.size(), drawn.points.size());
}

TEST(DrawnWorlds, OneBodyIsDrawnAsItsWorldShowsIt) {
  Simulationd simulation;
  Dynamics<double> heavy;
  heavy.mass = 1;
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  const BodyId ground = simulation.add(floor);
  const BodyId box = simulation.add({Box<double>({1, 1, 1}), {{5, 0.5, 0}, {}}}, heavy);
  const BodyId ball = simulation.add({Sphere<double>(0.5), {{0, 900, 0}, {}}}, heavy);
  const BodyId gone = simulation.add({Sphere<double>(0.5), {{0, 90, 0}, {}}}, heavy);
  for (int i = 0; i < 180; ++i) simulation.step(1.0 / 60);
  simulation.remove(gone);
  const auto expect_parts = [&](const auto& whole_of, bool in_simulation) {
    DrawRecorder whole(DrawArea{{}, 10}), parts(DrawArea{{}, 10});
    whole.off = parts.off = DrawLayer::contacts;
    draw(whole, whole_of);
    for (const BodyId id : {ground, box, ball}) draw(parts, whole_of, id);
    for (int meaning = 0; meaning <= int(DrawMeaning::joint); ++meaning) {
      const auto count = [&](const DrawRecorder& on, DrawLayer layer) {
        return count_of(on.triangles, layer, DrawMeaning(meaning)) + count_of(on.lines, layer, DrawMeaning(meaning));
      };
      EXPECT_EQ(count(parts, DrawLayer::shapes), count(whole, DrawLayer::shapes)) << meaning;
      EXPECT_EQ(count(parts, DrawLayer::bounds), count(whole, DrawLayer::bounds)) << meaning;
    }
    EXPECT_EQ(count_of(parts.triangles, DrawLayer::shapes, DrawMeaning::asleep) > 0, in_simulation);
    EXPECT_GT(count_of(parts.triangles, DrawLayer::shapes, DrawMeaning::moving), 0u);
    EXPECT_THROW(draw(parts, whole_of, gone), InvalidValue);
  };
  expect_parts(simulation, true);
  expect_parts(simulation.world(), false);
}

TEST(DrawnWorlds, ASimulationShowsJointsAndWhatSleeps) {
  Simulationd simulation;
  Dynamics<double> heavy;
  heavy.mass = 1;
  Body<double> floor{HalfSpace<double>()};
  floor.fixed = true;
  const BodyId ground = simulation.add(floor);
  simulation.add({Box<double>({1, 1, 1}), {{5, 0.5, 0}, {}}}, heavy);
  const BodyId bob = simulation.add({Sphere<double>(0.25), {{0, 4, 0}, {}}}, heavy);
  const JointId joint = simulation.add(ball_joint(ground, Posed{{0, 5, 0}, {}}, bob, Posed{{0, 1, 0}, {}}));
  EXPECT_EQ(simulation.joints(), std::vector<JointId>{joint});
  for (int i = 0; i < 180; ++i) simulation.step(1.0 / 60);
  DrawRecorder drawn(draw_area(simulation.world()));
  draw(drawn, simulation);
  EXPECT_EQ(count_of(drawn.lines, DrawLayer::joints, DrawMeaning::joint), 2u);
  ASSERT_EQ(count_of(drawn.points, DrawLayer::joints, DrawMeaning::b), 1u);
  for (const DrawnPart& p : drawn.points)
    if (p.layer == DrawLayer::joints) {
      EXPECT_NEAR(length(p.at[0] - Vec3d{0, 5, 0}), 0, 1e-3);
    }
  EXPECT_GT(count_of(drawn.triangles, DrawLayer::shapes, DrawMeaning::asleep), 0u);
  simulation.remove(joint);
  EXPECT_TRUE(simulation.joints().empty());
}

TEST(DrawnWorlds, AWorldOfThePlaneIsDrawnAtZero) {
  plane::Worldf world;
  plane::Body<float> floor{plane::HalfPlane<float>()};
  floor.fixed = true;
  world.add(floor);
  world.add({plane::Box<float>({1, 1}), {{0, 0.49f}, {}}});
  world.update();
  DrawRecorder drawn(draw_area(world));
  draw(drawn, world);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::contacts, DrawMeaning::contact), 2u);
  EXPECT_EQ(count_of(drawn.lines, DrawLayer::bounds, DrawMeaning::bounds), 4u);
  EXPECT_EQ(count_of(drawn.lines, DrawLayer::tree, DrawMeaning::bounds), 4u) << "the box of the only body with bounds";
  for (const auto* parts : {&drawn.points, &drawn.lines, &drawn.triangles})
    for (const DrawnPart& part : *parts)
      for (const Vec3d& p : part.at) EXPECT_EQ(p.z, 0);
}

TEST(DrawnWorlds, ATreeShowsTheBoxesInItAndThoseAroundThem) {
  DynamicTree<double> tree;
  Aabbd all = Aabbd::empty();
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Vec3d at{double(i % 10), double(i / 10), 0.0};
    const Aabbd box{at, at + Vec3d{0.5, 0.5, 0.5}};
    tree.insert(i, box);
    all = merged(all, box);
  }
  DrawRecorder drawn;
  draw(drawn, tree);
  EXPECT_GT(drawn.lines.size(), 100u * 12) << "a hundred boxes, and nodes";
  Aabbd seen = Aabbd::empty();
  for (const DrawnPart& line : drawn.lines)
    for (const Vec3d& p : line.at) seen = merged(seen, p);
  EXPECT_TRUE(contains(seen, all));
}

}  // namespace
}  // namespace graze::testing
