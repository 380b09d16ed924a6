// Many joints at once: the rates of trees against what was wanted, row by row; and what hangs on chains, beams and
// rings for many seconds, where rows that are solved one after the other swing themselves up.
#include "dynamics/joint_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "graze/simulation.hpp"

namespace graze {
namespace {

using At = Pose<double>;

/// Bodies that hang on each other at random: each on one before it or on the world, by a joint of any kind.
struct RandomTree {
  std::mt19937 random;
  std::vector<SolverBody<double>> bodies;
  std::vector<std::uint8_t> movable;
  std::vector<Vec3d> inertias;  ///< of each body, about its own axes
  std::vector<JointInPlace<double>> joints;
  std::vector<JointRows<double>> rows;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  bool all_turn = true;

  explicit RandomTree(unsigned seed, std::size_t loops = 0) : random(seed) {
    const std::size_t count = 2 + random() % 12;
    for (std::size_t i = 0; i < count; ++i) {
      add_body();
      if (i > 0) join(static_cast<std::uint32_t>(random() % i), static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < loops; ++i) {
      const auto a = static_cast<std::uint32_t>(random() % count);
      join(a, static_cast<std::uint32_t>((a + 1 + random() % (count - 1)) % count));
    }
    rows.resize(joints.size());
    for (std::size_t j = 0; j < joints.size(); ++j) {
      rows[j].prepare(joints[j], {0.01, 100, 0.01, true});
      rows[j].refresh(bodies[ends[j].first], bodies[ends[j].second]);
    }
  }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  Vec3d vector() { return {number(), number(), number()}; }
  Quatd turn() {
    const Vec3d axis = normalized(vector());
    return Quatd::from_axis_angle(axis, 3 * number());
  }

  /// One in five does not move, one in twelve does not turn about one axis.
  void add_body() {
    SolverBody<double> body;
    body.center = vector();
    body.rotation = turn();
    body.linear = vector();
    body.angular = vector();
    const bool moves = random() % 5 != 0;
    const Vec3d spread{2 + number(), 2 + number(), 2 + number()};
    Vec3d inertia = Vec3d{spread.y + spread.z, spread.z + spread.x, spread.x + spread.y} / 4.0;
    if (random() % 12 == 0) {
      inertia[random() % 3] = std::numeric_limits<double>::infinity();
      all_turn = false;
    }
    if (moves) body.mass = inverse_mass(std::pow(10.0, 2 * number()), inertia, body.rotation);
    if (!moves) body.linear = body.angular = {};
    bodies.push_back(body);
    movable.push_back(moves ? 1 : 0);
    inertias.push_back(inertia);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    if (random() % 2 == 0) std::swap(a, b);
    const At frame_a{vector(), turn()}, frame_b{vector(), turn()};
    JointInPlace<double> in_place;
    switch (random() % 4) {
    case 0: in_place.joint = fixed_joint({}, frame_a, {}, frame_b); break;
    case 1: in_place.joint = hinge_joint({}, frame_a, {}, frame_b); break;
    case 2: in_place.joint = slider_joint({}, frame_a, {}, frame_b); break;
    default: in_place.joint = ball_joint({}, frame_a, {}, frame_b);
    }
    in_place.a = a;
    in_place.b = b;
    in_place.frame_a = frame_a;
    in_place.frame_b = frame_b;
    joints.push_back(in_place);
    ends.emplace_back(a, b);
  }
};

/// What does not turn about an axis may be asked to by several joints at once, which no impulse can do: there
/// velocities only stay finite.
TEST(JointSystem, RatesOfATreeBecomeWhatIsWanted) {
  std::size_t solved = 0;
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    RandomTree tree(seed);
    JointSystem<double, Space<double>> system;
    system.prepare(tree.rows, tree.ends, tree.movable);
    if (system.loops() > 0) continue;  // two parts of the world are tied by what hangs between them
    system.factor(tree.rows, tree.bodies);
    system.solve(tree.rows, tree.bodies, false);
    for (const SolverBody<double>& body : tree.bodies)
      ASSERT_TRUE(std::isfinite(length(body.linear) + length(body.angular))) << seed;
    for (std::size_t j = 0; tree.all_turn && j < tree.rows.size(); ++j) {
      const auto [a, b] = tree.ends[j];
      if (tree.movable[a] == 0 && tree.movable[b] == 0) continue;
      const auto left = tree.rows[j].wanted(tree.bodies[a], tree.bodies[b], false);
      for (std::size_t i = 0; i < tree.rows[j].locked(); ++i) ASSERT_NEAR(left[i], 0, 1e-8) << seed << ' ' << j;
      ++solved;
    }
  }
  EXPECT_GT(solved, 1000u);
}

/// Joints that close loops ask for no more than standing still fulfils. A pass takes energy and gives none, leaves the
/// rates of the tree as they are wanted, and few passes are enough for those of the loops.
TEST(JointSystem, LoopsAreHeldAndGiveNoEnergy) {
  std::size_t solved = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    RandomTree tree(seed, 1 + seed % 4);
    JointSystem<double, Space<double>> system;
    system.prepare(tree.rows, tree.ends, tree.movable);
    system.factor(tree.rows, tree.bodies);
    if (!tree.all_turn) continue;
    const auto rates = [&] {
      double sum = 0;
      for (std::size_t j = 0; j < tree.rows.size(); ++j) {
        const auto [a, b] = tree.ends[j];
        if (tree.movable[a] == 0 && tree.movable[b] == 0) continue;
        EXPECT_TRUE(system.holds(j)) << seed;
        for (const double rate : tree.rows[j].wanted(tree.bodies[a], tree.bodies[b], false)) sum += rate * rate;
      }
      return std::sqrt(sum);
    };
    const auto energy = [&] {
      double sum = 0;
      for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
        const SolverBody<double>& body = tree.bodies[i];
        if (tree.movable[i] == 0) continue;
        const Vec3d turning = rotate(conjugate(body.rotation), body.angular);
        sum += length_squared(body.linear) / body.mass.mass;
        for (std::size_t k = 0; k < 3; ++k) sum += tree.inertias[i][k] * turning[k] * turning[k];
      }
      return sum;
    };
    const double first_rates = rates();
    double before = energy();
    for (int pass = 0; pass < 10; ++pass) {
      system.solve(tree.rows, tree.bodies, false);
      ASSERT_LE(energy(), before * (1 + 1e-9) + 1e-12) << seed << ' ' << pass;
      before = energy();
    }
    EXPECT_LT(rates(), 2e-2 * first_rates + 1e-9) << seed;
    ++solved;
  }
  EXPECT_GT(solved, 300u);
}

/// Bodies that only joints move, and that meet nothing.
struct Hanging {
  Simulation<double> simulation{settings()};
  std::vector<BodyId> bodies;
  double first_energy = 0, most_energy = 0, widest = 0;

  static SimulationSettings<double> settings() {
    SimulationSettings<double> s;
    s.gravity = {0, -10, 0};
    s.sleep = false;
    return s;
  }
  BodyId add(const Vec3d& size, const At& pose, bool fixed = false, bool collides = false) {
    Body<double> body{Box<double>(size), pose};
    if (!collides) body.filter.mask = 0;
    body.fixed = fixed;
    bodies.push_back(simulation.add(body));
    return bodies.back();
  }
  double energy() const { return simulation.report().kinetic_energy + simulation.report().potential_energy; }
  template <class Gap>
  void run(double seconds, const Gap& gap) {
    first_energy = energy();
    most_energy = -std::numeric_limits<double>::infinity();
    widest = 0;
    for (int i = 0; i < std::lround(seconds * 60); ++i) {
      simulation.step(1.0 / 60);
      most_energy = std::max(most_energy, energy());
      widest = std::max(widest, gap());
    }
  }
  Vec3d place(std::size_t i, const Vec3d& at) const { return transform(simulation.poses()[bodies[i].index], at); }
};

/// Twenty links that fall from lying straight, the last one up to a hundred times as heavy.
TEST(JointSystem, ChainsSwingWithoutGainingEnergy) {
  for (const double heavy : {1.0, 10.0, 100.0}) {
    Hanging h;
    h.add({0.2, 0.2, 0.2}, {}, true);
    const std::size_t links = 20;
    for (std::size_t i = 1; i <= links; ++i) {
      h.add({0.2, 0.2, i == links ? 0.2 * heavy : 0.2}, {{0.2 * static_cast<double>(i), 0, 0}, {}});
      h.simulation.add(ball_joint(h.bodies[i - 1], At{{0.1, 0, 0}, {}}, h.bodies[i], At{{-0.1, 0, 0}, {}}));
    }
    h.run(20, [&] {
      double gap = 0;
      for (std::size_t i = 1; i <= links; ++i)
        gap = std::max(gap, length(h.place(i - 1, {0.1, 0, 0}) - h.place(i, {-0.1, 0, 0})));
      return gap;
    });
    EXPECT_LT(h.most_energy, h.first_energy + 1e-2 * heavy) << heavy;
    EXPECT_LT(h.widest, 0.02) << heavy;
  }
}

/// The same chains, whose links collide: with all but their neighbours, or with these too, which are levers then. Where
/// continuous collision holds a link back, the chain is held back with it.
TEST(JointSystem, ChainsThatCollideGainNoEnergy) {
  std::size_t stopped = 0;
  for (const bool neighbours : {false, true})
    for (const double heavy : {1.0, 10.0, 100.0}) {
      Hanging h;
      const std::size_t links = 20;
      for (std::size_t i = 0; i <= links; ++i)
        h.add({0.18, 0.2, i == links ? 0.2 * heavy : 0.2}, {{0.2 * static_cast<double>(i), 0, 0}, {}}, i == 0, true);
      for (std::size_t i = 1; i <= links; ++i) {
        auto joint = ball_joint(h.bodies[i - 1], At{{0.1, 0, 0}, {}}, h.bodies[i], At{{-0.1, 0, 0}, {}});
        joint.enable_collision = neighbours;
        h.simulation.add(joint);
      }
      h.run(10, [&] {
        stopped += h.simulation.report().stopped;
        double gap = 0;
        for (std::size_t i = 1; i <= links; ++i)
          gap = std::max(gap, length(h.place(i - 1, {0.1, 0, 0}) - h.place(i, {-0.1, 0, 0})));
        return gap;
      });
      const double fall = 10 * 1000 * 0.2 * 0.2 * 0.18 * heavy * 0.2 * static_cast<double>(links);
      EXPECT_LT(h.most_energy, h.first_energy + 1e-3 * fall) << heavy << ' ' << neighbours;
      EXPECT_LT(h.widest, 0.02) << heavy << ' ' << neighbours;
    }
  EXPECT_GT(stopped, 0u);
}

/// Five blocks in a row on a wall do not sag.
TEST(JointSystem, FixedJointsHoldABeam) {
  Hanging h;
  h.add({0.2, 0.2, 0.2}, {}, true);
  for (std::size_t i = 1; i <= 5; ++i) {
    h.add({0.2, 0.2, 0.2}, {{0.2 * static_cast<double>(i), 0, 0}, {}});
    h.simulation.add(fixed_joint(h.bodies[i - 1], At{{0.1, 0, 0}, {}}, h.bodies[i], At{{-0.1, 0, 0}, {}}));
  }
  h.run(10, [&] { return length(h.place(5, {}) - Vec3d{1, 0, 0}); });
  EXPECT_LT(h.widest, 1e-4);
}

/// A ring of links hung by one, another up to a hundred times as heavy.
TEST(JointSystem, RingsHold) {
  for (const double heavy : {1.0, 100.0}) {
    Hanging h;
    const std::size_t links = 8;
    const double radius = 0.2 * static_cast<double>(links) / (2 * std::numbers::pi);
    for (std::size_t i = 0; i < links; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(links);
      h.add({0.2, i == links / 2 ? 0.05 * heavy : 0.05, 0.05},
            {{radius * std::cos(angle), radius * std::sin(angle), 0},
             Quatd::from_axis_angle({0, 0, 1}, angle + std::numbers::pi / 2)});
    }
    for (std::size_t i = 0; i < links; ++i)
      h.simulation.add(ball_joint(h.bodies[i], At{{0.1, 0, 0}, {}}, h.bodies[(i + 1) % links], At{{-0.1, 0, 0}, {}}));
    h.add({0.1, 0.1, 0.1}, {}, true);
    h.simulation.add(ball_joint(h.bodies[links], At{{radius, 0, 0}, {}}, h.bodies[0], At{}));
    const auto gap = [&] {
      double most = 0;
      for (std::size_t i = 0; i < links; ++i)
        most = std::max(most, length(h.place(i, {0.1, 0, 0}) - h.place((i + 1) % links, {-0.1, 0, 0})));
      return most;
    };
    h.run(1, gap);  // links are put together a little apart
    h.run(20, gap);
    EXPECT_LT(h.widest, 0.01) << heavy;
    // Of what it can fall, its width.
    const double fall = 10 * 1000 * 0.2 * 0.05 * 0.05 * (static_cast<double>(links - 1) + heavy) * 2 * radius;
    EXPECT_LT(h.most_energy, h.first_energy + 5e-3 * fall) << heavy;
  }
}

/// Planks between two posts, each tied to the next by two ball joints or by a hinge: all pairs and the whole are loops.
/// Sagging, and stretched out, where no force upright holds them.
TEST(JointSystem, BridgesHangStill) {
  constexpr std::size_t planks = 6;
  for (const bool pairs : {false, true})
    for (const double sag : {0.0, 0.5}) {
      Hanging h;
      const auto knot = [&](std::size_t i) {
        const double u = 2 * static_cast<double>(i) / planks - 1;
        return Vec3d{1.5 * u, sag * (u * u - 1), 0};
      };
      h.add({0.4, 0.4, 1}, {{-1.7, 0, 0}, {}}, true);
      for (std::size_t i = 0; i < planks; ++i) {
        const Vec3d way = knot(i + 1) - knot(i);
        h.add({0.9 * length(way), 0.08, 1},
              {(knot(i) + knot(i + 1)) / 2, Quatd::from_axis_angle({0, 0, 1}, std::atan2(way.y, way.x))});
      }
      h.add({0.4, 0.4, 1}, {{1.7, 0, 0}, {}}, true);
      const double half = std::sqrt(0.5);
      std::vector<std::pair<Vec3d, Vec3d>> arms;
      for (std::size_t i = 0; i <= planks; ++i)
        for (const double z : pairs ? std::vector{-0.4, 0.4} : std::vector{0.0}) {
          const auto frame = [&](std::size_t body) {
            const Pose<double>& pose = h.simulation.poses()[h.bodies[body].index];
            return At{inverse_transform(pose, knot(i) + Vec3d{0, 0, z}),
                      conjugate(pose.rotation) * Quatd{0, -half, 0, half}};
          };
          const At a = frame(i), b = frame(i + 1);
          h.simulation.add(pairs ? ball_joint(h.bodies[i], a, h.bodies[i + 1], b)
                                 : hinge_joint(h.bodies[i], a, h.bodies[i + 1], b));
          arms.emplace_back(a.translation, b.translation);
        }
      const auto gap = [&] {
        double most = 0;
        for (std::size_t j = 0; j < arms.size(); ++j) {
          const std::size_t i = pairs ? j / 2 : j;
          most = std::max(most, length(h.place(i, arms[j].first) - h.place(i + 1, arms[j].second)));
        }
        return most;
      };
      h.run(3, gap);
      SCOPED_TRACE(::testing::Message() << (pairs ? "pairs of balls" : "hinges") << ", sag " << sag);
      // From where it begins it falls at most by its sag.
      const double weight = 1000 * 2.8 * 0.08 * 10;
      EXPECT_LT(h.most_energy, h.first_energy + 1e-3 * weight);
      EXPECT_LT(h.widest, 0.02);
      EXPECT_LT(h.simulation.report().kinetic_energy, 0.05 * weight);
    }
}

/// Two cranks of 1 m and the bar between them, which go round through the pose in which all three lie in a line. There
/// the two cranks may as well turn against each other, and no row holds them for a moment.
TEST(JointSystem, AParallelogramKeepsItsEnergyThroughItsFlatPose) {
  for (const auto& [base, start] : {std::pair(1.0, 1.5), std::pair(2.0, 0.3)}) {
    Hanging h;
    const double half = std::sqrt(0.5);
    const auto at = [&](const Vec3d& place) { return At{place, {0, -half, 0, half}}; };
    const Vec3d tip{std::cos(start), std::sin(start), 0}, over{base, 0, 0};
    const Quatd lean = Quatd::from_axis_angle({0, 0, 1}, start);
    h.add({0.1, 0.1, 0.1}, {}, true);
    h.add({1, 0.1, 0.1}, {tip / 2, lean});
    h.add({1, 0.1, 0.1}, {tip / 2 + over, lean});
    h.add({base, 0.1, 0.1}, {tip + over / 2, {}});
    const auto tie = [&](std::size_t a, const Vec3d& on_a, std::size_t b, const Vec3d& on_b) {
      h.simulation.add(hinge_joint(h.bodies[a], at(on_a), h.bodies[b], at(on_b)));
    };
    const Vec3d crank{0.5, 0, 0};
    tie(0, {}, 1, -crank);
    tie(0, over, 2, -crank);
    tie(1, crank, 3, -over / 2);
    tie(2, crank, 3, over / 2);
    h.run(20, [&] { return length(h.place(2, crank) - h.place(3, over / 2)); });
    SCOPED_TRACE(::testing::Message() << "base " << base << ", start " << start);
    const double swing = 10 * (1.0 + base) * 10;  // masses of 10 kg a metre, g = 10, from top to bottom
    EXPECT_LT(h.most_energy, h.first_energy + 2e-3 * swing);
    EXPECT_GT(h.energy(), h.first_energy - 1e-2 * swing);
    EXPECT_LT(h.widest, 1e-3);
  }
}

/// A door on two hinges, which are a loop.
TEST(JointSystem, ADoorTurnsOnTwoHinges) {
  Hanging h;
  h.add({0.2, 2, 0.2}, {}, true);
  Body<double> door{Box<double>({1, 2, 0.05}), {{0.6, 0, 0}, {}}, {0, 0, -0.5}, {0, 1, 0}};
  door.filter.mask = 0;
  h.bodies.push_back(h.simulation.add(door));
  const double half = std::sqrt(0.5);
  const Quatd upright{0, 0, half, half};
  for (const double y : {0.8, -0.8})
    h.simulation.add(hinge_joint(h.bodies[0], At{{0.1, y, 0}, upright}, h.bodies[1], At{{-0.5, y, 0}, upright}));
  h.run(10, [&] { return length(h.place(1, {-0.5, 0.8, 0}) - Vec3d{0.1, 0.8, 0}); });
  EXPECT_LT(h.widest, 1e-4);
  EXPECT_NEAR(h.simulation.motion(h.bodies[1]).angular.y, 1, 0.02);
}

}  // namespace
}  // namespace graze
