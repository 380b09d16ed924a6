// Rows of what moves: slopes, bounces, spins, what comes to rest, and bullets.
#include "resolution_measures.hpp"

#include <algorithm>
#include <cmath>

#include "random.hpp"
#include "resolution_run.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

/// What lies on a plane under gravity that is turned, which is a slope without turning the plane.
struct Slope {
  Slope(const EngineKind& kind, double share, bool plate)
      : run(kind, things(share, plate), {.gravity = {g * std::sin(angle), -g * std::cos(angle), 0}}) {}
  static std::vector<Thing> things(double share, bool plate) {
    const double friction = share * std::tan(angle), height = plate ? 0.1 : 1;
    Thing sliding = box({0, height / 2, 0}, {1, height, 1});
    sliding.friction = friction;
    return {floor_with(friction), sliding};
  }
  static constexpr double angle = 0.5235987755982988;  // 30 degrees
  Run run;
};

}  // namespace

std::string creep(const EngineKind& kind, bool plate) {
  Slope slope(kind, 1.02, plate);
  slope.run.steps(seconds / 5);
  const double early = slope.run.at(1).x;
  slope.run.steps(2 * seconds - seconds / 5);
  const double end = slope.run.at(1).x;
  return millimetres(std::abs(end)) + ", " + millimetres(std::abs(end - early));
}

std::string sliding(const EngineKind& kind, double share, bool plate, bool way) {
  Slope slope(kind, share, plate);
  slope.run.steps(2 * seconds);
  const double a = g * std::sin(Slope::angle) * (1 - share);
  return printed("%.4f", way ? slope.run.at(1).x / (2 * a) : slope.run.moving(1).linear.x / (2 * a));
}

std::string stopping(const EngineKind& kind) {
  Thing plate = box({0, 0.05, 0}, {1, 0.1, 1});
  plate.friction = 0.5;
  plate.linear = {10, 0, 0};
  Run run(kind, {floor_with(0.5), plate});
  run.steps(4 * seconds);
  return printed("%.3f m", run.at(1).x);
}

namespace {

std::vector<Thing> dropped(bool ball, double restitution) {
  Thing thing = ball ? round(Form::ball, {0, 5.5, 0}, 0.5) : box({0, 5.5, 0});
  thing.friction = 0;
  thing.restitution = restitution;
  return {floor_with(0, restitution), thing};
}

}  // namespace

std::string rebound(const EngineKind& kind) {
  Run run(kind, dropped(true, 0.5));
  double top = 0;
  bool struck = false;
  for (int i = 0; i < 3 * seconds; ++i) {
    run.steps(1);
    const double speed = run.moving(1).linear.y;
    if (speed > 0) struck = true;
    // Between steps the top is above what is seen, by v²/2g.
    if (struck) top = std::max(top, run.at(1).y - 0.5 + (speed > 0 ? speed * speed / (2 * g) : 0));
    if (struck && speed < 0) break;
  }
  return printed("%.3f", top / 1.25);
}

std::string elastic(const EngineKind& kind, bool ball) {
  Run run(kind, dropped(ball, 1));
  const double floor_level = mass_of(run.things()[1]).mass * g * 0.5, before = run.potential_energy() - floor_level;
  run.steps(20 * seconds);
  return printed("%.4f", (run.potential_energy() - floor_level + run.kinetic_energy()) / before);
}

std::string cradle(const EngineKind& kind) {
  std::vector<Thing> things;
  for (int i = 0; i < 6; ++i) {
    Thing ball = round(Form::ball, {i == 0 ? -2.0 : i - 1.0, 0, 0}, 0.5);
    ball.friction = 0;
    ball.restitution = 1;
    if (i == 0) ball.linear = {5, 0, 0};
    things.push_back(ball);
  }
  Run run(kind, things, {.gravity = {}});
  const double before = run.kinetic_energy();
  run.steps(1 * seconds);
  double others = 0;
  for (std::size_t i = 0; i < 5; ++i) others = std::max(others, length(run.moving(i).linear));
  return printed("%.3f m/s", run.moving(5).linear.x) + printed(", %.3f m/s", others) +
         printed(", %.3f", run.kinetic_energy() / before);
}

std::string spin(const EngineKind& kind, double rate) {
  // Edges of a box whose moments are as 0.417 : 0.337 : 0.087.
  Thing book = box({0, 0, 0}, {std::sqrt(0.007), std::sqrt(0.167), std::sqrt(0.667)}, 1000);
  book.angular = {rate * 1e-3, rate, 0};
  Run run(kind, {book}, {.gravity = {}});
  const Vec3d before = run.angular_momentum(0);
  const double energy = run.kinetic_energy();
  const auto upright = [&] {
    const Moving m = run.moving(0);
    return rotate(conjugate(m.pose.rotation), m.angular).y > 0;
  };
  int flips = 0;
  for (int i = 0; i < 20 * seconds; ++i) {
    const bool was = upright();
    run.steps(1);
    flips += upright() != was ? 1 : 0;
  }
  const Vec3d after = run.angular_momentum(0);
  const double turned = std::atan2(length(cross(before, after)), dot(before, after)) * 57.29577951308232;
  return printed("%+.1e", length(after) / length(before) - 1) + printed(", %.1e°", turned) +
         printed(", %+.1e, ", run.kinetic_energy() / energy - 1) + std::to_string(flips);
}

std::string free_fall(const EngineKind& kind) {
  Run run(kind, {box({0, 100, 0})});
  run.steps(1 * seconds);
  return printed("%.5f m", 100 - run.at(0).y);
}

namespace {

/// Twenty seconds of bodies that may sleep: how many do, since when all, and how deep they are in each other.
std::string coming_to_rest(const EngineKind& kind, const std::vector<Thing>& things) {
  Run run(kind, things, {.sleep = true});
  int last = -1;
  for (int i = 1; i <= 20 * seconds; ++i) {
    run.steps(1);
    bool all = true;
    for (std::size_t k = 1; k < run.things().size(); ++k) all = all && run.engine().asleep(k);
    if (all && last < 0) last = i;
    if (!all) last = -1;
  }
  int asleep = 0;
  for (std::size_t k = 1; k < run.things().size(); ++k) asleep += run.engine().asleep(k) ? 1 : 0;
  return std::to_string(asleep) + (last < 0 ? ", -" : printed(", %.1f s", last * dt)) + ", " +
         millimetres(run.deepest());
}

}  // namespace

std::string cylinders(const EngineKind& kind) {
  std::vector<Thing> things{floor_with()};
  for (int i = 0; i < 10; ++i) {
    Thing lying = round(Form::cylinder, {3.0 * i, 0.5, 0}, 0.5, 1);
    lying.pose.rotation = about({1, 0, 0}, 1.5707963267948966);
    things.push_back(lying);
    things.push_back(round(Form::cylinder, {3.0 * i, 0.5, 4}, 0.5, 1));
    Thing falling = round(Form::cylinder, {3.0 * i, 2, 8}, 0.5, 1);
    falling.pose.rotation = about({0.6, 0, 0.8}, 0.15 * i);
    things.push_back(falling);
  }
  return coming_to_rest(kind, things);
}

std::string balls_in_bowl(const EngineKind& kind) {
  Thing bowl = round(Form::bowl, {0, 3, 0}, 3);
  bowl.density = 0;
  std::vector<Thing> things{bowl};
  for (int i = 0; i < 20; ++i)
    things.push_back(
        round(Form::ball, {0.7 * (i % 3 - 1) + 0.05 * i, 2 + 0.6 * (i / 6), 0.7 * (i / 3 % 2) - 0.35}, 0.25));
  return coming_to_rest(kind, things);
}

std::string through_wall(const EngineKind& kind, double size, bool moving_wall) {
  Random random(7);
  int through = 0;
  for (int i = 0; i < 100; ++i) {
    Thing bullet = box({random.number(-20, -10), 0, 0}, {size, size, size});
    bullet.pose.rotation = random.rotation();
    bullet.linear = {300, 0, 0};
    bullet.angular = random.in_cube(20);
    Thing wall = box({0, 0, 0}, {0.01, 20, 20}, moving_wall ? 1e6 : 0);
    if (moving_wall) wall.linear = {-1, 0, 0};
    Run run(kind, {wall, bullet}, {.gravity = {}, .continuous = true});
    run.steps(30);
    if (!(run.at(1).x < run.at(0).x)) ++through;
  }
  return std::to_string(through);
}

std::string past_post(const EngineKind& kind, double rate, bool moving_post) {
  Random random(9);
  int unnoticed = 0;
  for (int i = 0; i < 100; ++i) {
    Thing rod = box({0, 0, 0}, {4, 0.04, 0.04});
    rod.pose.rotation = about({0, 0, 1}, random.number(-1.2, -0.1));
    rod.angular = {0, 0, rate};
    Thing post = box({1.9, 0.02, 0}, {0.04, 0.04, 2}, moving_post ? 1e6 : 0);
    if (moving_post) post.linear = {0, -1, 0};
    Run run(kind, {post, rod}, {.gravity = {}, .continuous = true});
    run.steps(static_cast<int>(std::ceil(1.5 / rate / dt)) + 1);
    const Moving m = run.moving(1);
    if (length(m.angular - rod.angular) < 1e-3 * rate) ++unnoticed;
  }
  return std::to_string(unnoticed);
}

namespace {

/// Two things of a metre or less, of which the second comes at the first at 10 m/s, as a rule not through its middle.
std::vector<Thing> meeting_pair(Random& random, double restitution, double friction) {
  std::vector<Thing> things;
  for (int k = 0; k < 2; ++k) {
    const double kind = random.number(0, 3), a = random.number(0.2, 1), b = random.number(0.2, 1);
    Thing thing = kind < 1   ? box({}, {a, b, random.number(0.2, 1)})
                  : kind < 2 ? round(Form::ball, {}, a / 2)
                             : round(Form::cylinder, {}, a / 2, b);
    thing.pose.rotation = random.rotation();
    thing.angular = random.in_cube(3);
    thing.restitution = restitution;
    thing.friction = friction;
    things.push_back(thing);
  }
  const Vec3d way = random.direction(), aside = random.in_cube(0.3);
  things[1].pose.translation = aside - way * 3.0;
  things[1].linear = way * 10.0;
  return things;
}

}  // namespace

std::string meeting(const EngineKind& kind, double restitution, double friction) {
  Random random(11);
  double momentum = 0, most = 0, sum = 0;
  const int pairs = 600;
  for (int i = 0; i < pairs; ++i) {
    Run run(kind, meeting_pair(random, restitution, friction), {.gravity = {}, .continuous = true});
    const double m[] = {mass_of(run.things()[0]).mass, mass_of(run.things()[1]).mass};
    const auto linear = [&] { return run.moving(0).linear * m[0] + run.moving(1).linear * m[1]; };
    const auto angular = [&] {
      Vec3d all{};
      for (std::size_t k = 0; k < 2; ++k)
        all += cross(run.at(k), run.moving(k).linear) * m[k] + run.angular_momentum(k);
      return all;
    };
    const Vec3d p = linear(), l = angular();
    run.steps(1 * seconds);
    // A metre at 10 m/s of the mass that two bodies have in their motion against each other.
    const double scale = 10 * m[0] * m[1] / (m[0] + m[1]), change = length(angular() - l) / scale;
    momentum = std::max(momentum, length(linear() - p) / scale);
    most = std::max(most, change);
    sum += change;
  }
  return printed("%.0e", momentum) + printed(", %.0e", most) + printed(", %.0e", sum / pairs);
}

}  // namespace graze::bench
