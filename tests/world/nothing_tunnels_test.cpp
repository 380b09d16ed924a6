// Small fast bodies above large floors: none gets through, none is stopped before it is there, and none is held by the
// seams when it slides.
//
// 2,160 ways down: balls, boxes and capsules of 1 cm to 0.4 m; floors 10 m to 5 km wide, of two triangles, of 64 x 64
// cells, and a plate of 0.2 m; straight down and at a slant, over seams and off them, in long steps and in short ones.
// The floor being flat, the time of contact is that at which the lowest point of the body reaches its height.
#include <gtest/gtest.h>

#include <random>

#include "graze/slide.hpp"
#include "graze/world.hpp"

namespace graze {
namespace {

template <class T>
class NothingTunnels : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(NothingTunnels, Scalars);

template <class T>
Shape<T> grid(int cells, T width) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k)
      points.push_back({(T(k) / T(cells) - T(0.5)) * width, T(0), (T(i) / T(cells) - T(0.5)) * width});
  for (std::uint32_t i = 0; i + 1 < row; ++i)
    for (std::uint32_t k = 0; k + 1 < row; ++k) {
      const std::uint32_t p = i * row + k;
      triangles.push_back({p, p + row, p + row + 1});
      triangles.push_back({p, p + row + 1, p + 1});
    }
  return {Mesh<T>(points, triangles)};
}

template <class T>
Body<T> fixed(const Shape<T>& shape, T lower = T(0)) {
  Body<T> body{shape, {{T(0), -lower, T(0)}, {}}};
  body.fixed = true;
  return body;
}

/// Floors whose surface is at y = 0, the ones of the 2,160 first.
template <class T>
std::vector<Body<T>> plain_floors(T width) {
  return {fixed(grid<T>(1, width)), fixed(grid<T>(64, width)), fixed<T>(Box<T>({width, T(0.2), width}), T(0.1))};
}
template <class T>
std::vector<Body<T>> other_floors(T width) {
  std::vector<Vec3<T>> corners;
  for (const T x : {-width, width})
    for (const T y : {T(-0.3), T(0)})
      for (const T z : {-width, width}) corners.push_back({x, y, z});
  std::vector<Placed<T>> tiles;
  for (const T x : {T(-0.5), T(0.5)})
    for (const T z : {T(-0.5), T(0.5)})
      tiles.push_back({Shape<T>(Box<T>({width, T(0.2), width})), {{x * width, T(-0.1), z * width}, {}}});
  return {fixed<T>(HalfSpace<T>()), fixed<T>(Rectangle<T>(width, width)), fixed<T>(ConvexHull<T>(corners)),
          fixed<T>(Compound<T>(std::move(tiles))),
          fixed<T>(HeightField<T>(17, 17, std::vector<T>(17 * 17, T(0)), width / T(16), width / T(16)))};
}

/// A body of a kind and a size.
template <class T>
struct Falling {
  Shape<T> shape;
  Quat<T> rotation = normalized(Quat<T>{T(0.3), T(0.1), T(-0.2), T(0.9)});
  int kind;
  double size;

  Falling(int of_kind, double of_size)
      : shape(made(of_kind, T(of_size))), kind(of_kind), size(static_cast<double>(T(of_size))) {}

  static Shape<T> made(int kind, T size) {
    if (kind == 0) return Sphere<T>(size);
    if (kind == 1) return Box<T>({size, size * T(1.5), size * T(2)});
    return Capsule<T>(size * T(2), size, size);
  }
  /// How far below its origin its lowest point is.
  double below(const Quat<T>& turned) const {
    const Vec3d up = abs(rotation_matrix(normalized(converted<double>(turned))).row[1]);
    return kind == 0 ? size : kind == 1 ? dot(up, Vec3d{size / 2, size * 0.75, size}) : size + size * up.y;
  }
};

template <class T>
struct Way {
  Pose<T> start;
  Velocity<T> velocity;
};

/// How high the lowest point stands at a time.
template <class T>
double height_at(const Falling<T>& body, const Way<T>& way, T t) {
  const double y = static_cast<double>(way.start.translation.y) +
                   static_cast<double>(way.velocity.linear.y) * static_cast<double>(t);
  return y - body.below(pose_at(way.start, way.velocity, t).rotation);
}

struct Outcome {
  int asked = 0, passed = 0, early = 0, late = 0;

  /// By so much the lowest point may be off the floor at a hit: the tolerance of a cast, and what rounding the time and
  /// the pose to T moves the body.
  template <class T>
  void judge(const Falling<T>& body, double width, const Way<T>& way, T t) {
    const double moved =
        length(converted<double>(way.velocity.linear)) + body.size * length(converted<double>(way.velocity.angular));
    const double allowed = 16 * static_cast<double>(cast_tolerance<T>) * body.size +
                           4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * moved + 2e-10 * width;
    early += height_at(body, way, t) > allowed;
    late += height_at(body, way, t) < -allowed;
  }
  void expect_perfect(int count) const {
    EXPECT_EQ(asked, count);
    EXPECT_EQ(passed, 0);
    EXPECT_EQ(early, 0);
    EXPECT_EQ(late, 0);
  }
};

/// Calls `f(body, floor, way, width)` for all ways down to the floors: 2,160 of the plain ones.
template <class T, class Floors, class F>
void each_way(const Floors& floors_of, const Vec3<T>& angular, const F& f) {
  for (const double width : {10, 24, 100, 500, 1000, 5000})
    for (const Body<T>& floor : floors_of(T(width)))
      for (const int kind : {0, 1, 2})
        for (const double size : {0.01, 0.05, 0.1, 0.2, 0.4}) {
          const Falling<T> body(kind, size);
          for (int variant = 0; variant < 8; ++variant) {
            const T step = variant & 1 ? T(1) : T(8 * size);
            // Over a corner of cells and the diagonal of the two triangles, or over none.
            const T x = T(width * 0.25), z = variant & 2 ? T(width * 0.25) : T(width * -0.1173);
            const Vec3<T> motion =
                variant & 4 ? Vec3<T>{step * T(0.6), -step, step * T(0.3)} : Vec3<T>{T(0), -step, T(0)};
            const T high = T((angular == Vec3<T>{} ? body.below(body.rotation) : 2.25 * size) + size / 2);
            f(body, floor, Way<T>{{{x, high, z}, body.rotation}, {motion, angular}}, width);
          }
        }
}

template <class T, class Floors>
Outcome cast_all_ways(const Floors& floors, Separating separating, const Vec3<T>& angular = {}) {
  Outcome outcome;
  each_way<T>(floors, angular, [&](const Falling<T>& body, const Body<T>& floor, const Way<T>& way, double width) {
    ++outcome.asked;
    const auto hit =
        graze::cast<T>(floor.shape, floor.pose, {}, body.shape, way.start, way.velocity, T(1), CastOptions{separating});
    if (!hit) return void(++outcome.passed);
    // What `overlap` calls touching at the start hits there, and that is known in float to a part of the floor's size.
    if (hit->t > T(0) || !overlap(floor.shape, floor.pose, body.shape, way.start))
      outcome.judge(body, width, way, hit->t);
  });
  return outcome;
}

TYPED_TEST(NothingTunnels, ByCast) {
  using T = TypeParam;
  for (const Separating separating : {Separating::hit, Separating::ignored}) {
    cast_all_ways<T>(plain_floors<T>, separating).expect_perfect(2160);
    cast_all_ways<T>(other_floors<T>, separating).expect_perfect(3600);
  }
}

TYPED_TEST(NothingTunnels, ByCastOfWhatTurns) {
  using T = TypeParam;
  for (const Separating separating : {Separating::hit, Separating::ignored})
    for (const Vec3<T>& angular : {Vec3<T>{T(1), T(-2), T(0.5)}, Vec3<T>{T(0), T(9), T(-20)}}) {
      cast_all_ways<T>(plain_floors<T>, separating, angular).expect_perfect(2160);
      cast_all_ways<T>(other_floors<T>, separating, angular).expect_perfect(3600);
    }
}

TYPED_TEST(NothingTunnels, ByImpactsOfAWorld) {
  using T = TypeParam;
  Outcome outcome;
  each_way<T>(plain_floors<T>, {}, [&](const Falling<T>& body, const Body<T>& floor, const Way<T>& way, double width) {
    ++outcome.asked;
    World<T> world;
    world.add(floor);
    Body<T> falling{body.shape, way.start, way.velocity.linear};
    falling.fast = true;
    world.add(falling);
    world.update(T(1));
    world.impacts().empty() ? void(++outcome.passed) : outcome.judge(body, width, way, world.impacts()[0].hit.t);
  });
  outcome.expect_perfect(2160);
}

TYPED_TEST(NothingTunnels, BySliding) {
  using T = TypeParam;
  Outcome outcome;
  each_way<T>(plain_floors<T>, {}, [&](const Falling<T>& body, const Body<T>& floor, const Way<T>& way, double width) {
    ++outcome.asked;
    World<T> world;
    world.add(floor);
    const auto result = slide(body.shape, way.start, way.velocity.linear, world);
    if (result.touched.empty()) return void(++outcome.passed);
    outcome.judge(body, width, way, result.touched[0].hit.t);
    Way<T> end = way;
    end.start = result.pose;
    outcome.judge(body, width, end, T(0));
  });
  outcome.expect_perfect(2160);
}

/// However small the steps: a body that falls a part of its size at a time stays on the floor.
TYPED_TEST(NothingTunnels, InManyShortSteps) {
  using T = TypeParam;
  for (const double width : {10, 500, 5000})
    for (const auto& floors : {plain_floors<T>(T(width)), other_floors<T>(T(width))})
      for (const Body<T>& floor : floors)
        for (const int kind : {0, 1, 2})
          for (const double step : {1e-6, 1e-4, 3e-3, 0.3}) {
            const Falling<T> body(kind, 0.05);
            const double start = body.below(body.rotation) + 3 * step * body.size;
            Way<T> way{{{T(width * 0.25), T(start), T(width * 0.1)}, body.rotation},
                       {{T(0), T(-step * body.size), T(0)}, {}}};
            for (int i = 0; i < 60; ++i) {
              const auto hit = graze::cast<T>(floor.shape, floor.pose, {}, body.shape, way.start, way.velocity, T(1),
                                              CastOptions{Separating::ignored});
              way.start.translation += way.velocity.linear * (hit ? hit->t : T(1));
            }
            const double lowest = height_at(body, way, T(0));
            EXPECT_GE(lowest, -4e-5 * body.size - 1e-9 * width)
                << width << ' ' << floor.shape.name() << ' ' << kind << ' ' << step;
            EXPECT_LE(lowest, 4e-5 * body.size + 1e-9 * width + 1e-4 * step)
                << width << ' ' << floor.shape.name() << ' ' << kind << ' ' << step;
          }
}

/// What lies on a large floor, a few roundings deep, slides over its seams.
TYPED_TEST(NothingTunnels, AndNothingIsHeldBySeams) {
  using T = TypeParam;
  int asked = 0, held = 0;
  for (const double width : {10, 24, 100, 500, 1000, 5000})
    for (const auto& floors : {plain_floors<T>(T(width)), other_floors<T>(T(width))})
      for (Body<T> floor : floors)
        for (const int kind : {0, 1, 2})
          for (const double size : {0.01, 0.1, 0.4})
            for (const double tilt : {0.0, 0.3})
              for (const double sunk : {0.0, 4.0, -4.0}) {
                const Falling<T> body(kind, size);
                const Quat<T> q = Quat<T>::from_axis_angle(normalized(Vec3<T>{T(1), T(0), T(2)}), T(tilt));
                const double height = body.below(body.rotation) - sunk * static_cast<double>(cast_tolerance<T>) * size;
                const Vec3<T> at{T(width * 0.21), T(height), T(width * 0.13)};
                floor.pose = {rotate(q, floor.pose.translation), q};
                const Vec3<T> along = rotate(q, Vec3<T>{T(width * -0.05 - 1), T(0), T(0.7 - width * 0.03)});
                const auto hit = graze::cast<T>(floor.shape, floor.pose, {}, body.shape,
                                                {rotate(q, at), normalized(q * body.rotation)}, {along, {}}, T(1),
                                                CastOptions{Separating::ignored});
                ++asked;
                held += hit.has_value();
              }
  EXPECT_EQ(asked, 2592);
  EXPECT_EQ(held, 0);
}

/// A rim ends a surface wherever it is met, whatever lies beyond the other sides of its triangle: bodies that come at
/// open meshes of two triangles are stopped, though they may slide.
TYPED_TEST(NothingTunnels, NotEvenAtTheRims) {
  using T = TypeParam;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto place = [&] { return Vec3<T>{T(any(random)), T(any(random)), T(any(random))}; };
  int met = 0, inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3<T> p = place(), q = place(), r = place(), s = place();
    const Shape<T> surface = Mesh<T>({p, q, r, s}, {{0, 1, 2}, {1, 0, 3}});
    const Shape<T> body = i % 2 == 0 ? Shape<T>(Sphere<T>(T(0.3))) : Box<T>({T(0.4), T(0.3), T(0.5)});
    const Pose<T> from{normalized(place()) * T(3), normalized(Quat<T>{T(any(random)), T(any(random)), T(0.3), T(1)})};
    const Vec3<T> motion = (p + q) * T(0.5) + place() - from.translation;
    World<T> world;
    world.add(fixed(surface));
    const SlideResult<T> result = slide(body, from, motion, world);
    met += !result.touched.empty();
    inside += distance(body, result.pose, surface, Pose<T>{}).distance < T(-4) * cast_tolerance<T>;
  }
  EXPECT_GT(met, 500);
  EXPECT_EQ(inside, 0);
}

/// A rim ends a surface at its corners too, where a seam ends with it: boxes that met one there, and slid on into the
/// triangle behind.
TYPED_TEST(NothingTunnels, NorOverCornersInWhichARimAndASeamEnd) {
  using T = TypeParam;
  struct Met {
    Vec3d p, q, r, s, from;
    Quatd rotation;
    Vec3d motion;
  };
  const Met all[] = {{{0.89425210424212809, -0.43880035382332117, -0.43492531669572565},
                      {0.65304092630586741, -0.3345493896222278, -0.22754906564809652},
                      {0.4143744681934558, 0.22621897862646767, 0.4977906646766681},
                      {0.74082794576754885, -0.54081021813497987, -0.6936394185018987},
                      {-1.3149268502319713, -1.3369569741747553, -2.3416902928748944},
                      {-0.050373408258121449, -0.66651289006391867, 0.21372639166951923, 0.71242130556506411},
                      {2.6181008894767763, 1.3030091222201312, 2.9051762967347794}},
                     {{0.083109684364478298, 0.49014304953849286, 0.78400787333507016},
                      {0.22219446311417612, 0.53610324871304038, 0.82573728525718559},
                      {0.06882295445247677, -0.8671586879168881, 0.68257743838401086},
                      {0.46236372187756669, 0.81775608217222739, -0.84068192026446398},
                      {-2.1783803762769489, 0.92710068286780078, -1.8425914522968883},
                      {0.26085735158298851, 0.1205962217765497, 0.27522617789346238, 0.91742059297820799},
                      {2.0355292509955709, -0.3851822008817285, 2.4934335807757479}},
                     {{0.84463219902306208, 0.13873089034224284, 0.79010784438043236},
                      {0.096991456284691857, 0.27898286546592588, 0.80355020804988952},
                      {-0.57183036035293644, -0.30807221514712346, 0.8483129362744033},
                      {0.3441273577024242, 0.73263556063724455, -0.57612078587614202},
                      {-2.059044214810291, 2.1803377305552334, -0.080400884158852867},
                      {-0.34078581098900551, -0.61684977162673194, 0.20386748062292079, 0.67955826874306924},
                      {3.3017060315529112, -2.6204593725656076, 1.1926061531421441}}};
  for (const Met& m : all) {
    const Shape<T> surface =
        Mesh<T>({converted<T>(m.p), converted<T>(m.q), converted<T>(m.r), converted<T>(m.s)}, {{0, 1, 2}, {1, 0, 3}});
    const Shape<T> body = Box<T>({T(0.4), T(0.3), T(0.5)});
    World<T> world;
    world.add(fixed(surface));
    const SlideResult<T> result =
        slide(body, Pose<T>{converted<T>(m.from), normalized(converted<T>(m.rotation))}, converted<T>(m.motion), world);
    EXPECT_FALSE(result.touched.empty());
    EXPECT_GT(distance(body, result.pose, surface, Pose<T>{}).distance, T(-4) * cast_tolerance<T>);
  }
}

}  // namespace
}  // namespace graze
