// What stands on a flat floor of pieces has the contacts of what stands on one half-space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/specimen.hpp"
#include "composite/flat_faces.hpp"
#include "graze/query.hpp"
#include "narrow/pair_table.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

template <class T>
class WholeFaces : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WholeFaces, Scalars);

constexpr int cells = 10;
constexpr double cell = 0.41;

template <class T>
T line(int i) {
  return static_cast<T>((i - cells / 2) * cell);
}

/// A grid of corners that are shared (`welded`) or are each triangle's own, in a random order.
template <class T>
Shape<T> flat_mesh(Random& random, bool welded) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (int z = 0; z <= cells; ++z)
    for (int x = 0; x <= cells; ++x) points.push_back({line<T>(x), T(0), line<T>(z)});
  for (int z = 0; z < cells; ++z)
    for (int x = 0; x < cells; ++x) {
      const auto a = static_cast<std::uint32_t>(z * (cells + 1) + x), b = a + 1, c = a + cells + 1, d = c + 1;
      triangles.push_back({a, d, b});
      triangles.push_back({a, c, d});
    }
  for (std::size_t i = triangles.size(); i > 1; --i) std::swap(triangles[i - 1], triangles[random() % i]);
  if (!welded)
    for (auto& triangle : triangles)
      for (std::uint32_t& corner : triangle) {
        points.push_back(points[corner]);
        corner = static_cast<std::uint32_t>(points.size() - 1);
      }
  return Mesh<T>(std::move(points), std::move(triangles));
}

template <class T>
Shape<T> flat_field() {
  return HeightField<T>(cells + 1, cells + 1, std::vector<T>((cells + 1) * (cells + 1), T(0)), T(cell), T(cell));
}

template <class T>
Shape<T> tiles(int from = 0) {
  std::vector<Placed<T>> children;
  for (int z = 0; z < cells; ++z)
    for (int x = from; x < cells; ++x)
      children.push_back(
          {Box<T>({T(cell), T(1), T(cell)}), {{line<T>(x) + T(cell / 2), T(-0.5), line<T>(z) + T(cell / 2)}, {}}});
  return Compound<T>(std::move(children));
}

template <class T>
struct StandingBody {
  Shape<T> shape;
  T height;
  Quat<T> turn;
  std::size_t points;
};

template <class T>
std::vector<StandingBody<T>> bodies() {
  return {{Box<T>({1, 1, 1}), T(0.5), {}, 4},
          {Shape<T>(Box<T>({T(0.8), T(0.8), T(0.8)}), T(0.1)), T(0.5), {}, 4},
          {Cylinder<T>(1, T(0.5)), T(0.5), {}, 8},
          {Capsule<T>(1, T(0.3)), T(0.3), normalized(Quat<T>{0, 0, 1, 1}), 2}};
}

/// A pose about two thousandths deep, leaning by up to two milliradians.
template <class T>
Pose<T> leaning(const StandingBody<T>& body, Random& random, const Quat<T>& yaw) {
  const double about = static_cast<double>(uniform(random, 0, 6.2831853f)),
               half = static_cast<double>(uniform(random, 0, 0.001f));
  const Quat<T> tilt =
      normalized(Quat<T>{static_cast<T>(std::cos(about) * half), T(0), static_cast<T>(std::sin(about) * half), T(1)});
  return {{T(0.13), body.height - static_cast<T>(uniform(random, 0.0018f, 0.0022f)), T(0.07)},
          normalized(tilt * yaw * body.turn)};
}

template <class T>
void expect_same(const Manifold<T>& found, const Manifold<T>& right, T within) {
  EXPECT_LE(max_abs(found.normal - right.normal), within);
  ASSERT_EQ(found.points.size(), right.points.size());
  std::set<std::uint32_t> numbers;
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    EXPECT_EQ(found.points[i].feature, right.points[i].feature);
    EXPECT_LE(max_abs(found.points[i].a - right.points[i].a), within);
    EXPECT_LE(max_abs(found.points[i].b - right.points[i].b), within);
    EXPECT_LE(std::abs(found.points[i].distance - right.points[i].distance), within);
    numbers.insert(found.points[i].feature);
  }
  EXPECT_EQ(numbers.size(), found.points.size());
}

TYPED_TEST(WholeFaces, HaveTheContactsOfAHalfSpaceUnderMilliradians) {
  using T = TypeParam;
  Random random(3);
  const std::vector<Shape<T>> floors{flat_mesh<T>(random, true), flat_mesh<T>(random, false), flat_field<T>(),
                                     tiles<T>()};
  const Shape<T> half_space = HalfSpace<T>();
  for (std::size_t f = 0; f < floors.size(); ++f)
    for (const StandingBody<T>& body : bodies<T>())
      for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(::testing::Message() << "floor " << f << ", " << body.shape.name() << ", frame " << i);
        const Quat<T> yaw = i % 3 == 0 ? Quat<T>{} : normalized(Quat<T>{0, static_cast<T>(i), 0, 20});
        // Upright here, then all of it turned and away from the origin.
        const Pose<T> here = leaning(body, random, yaw);
        const Pose<T> place =
            i % 2 == 0 ? Pose<T>{}
                       : Pose<T>{{T(3), T(-5), T(7)}, normalized(converted<T>(testing::random_rotation(random)))};
        const Pose<T> pose = compose(place, here);
        const T margin = contact_margin(floors[f], body.shape);
        Manifolds<T> right, found, swapped;
        contacts(half_space, place, body.shape, pose, margin, right);
        EXPECT_TRUE(contacts(floors[f], place, body.shape, pose, margin, found));
        contacts(body.shape, pose, floors[f], place, margin, swapped);
        ASSERT_EQ(right.size(), 1u);
        EXPECT_EQ(right[0].points.size(), body.points);
        ASSERT_EQ(found.size(), 1u);
        const T within = T(100) * tolerance<T>;
        expect_same(found[0], right[0], within);
        ASSERT_EQ(swapped.size(), 1u);
        ASSERT_EQ(swapped[0].points.size(), found[0].points.size());
        for (std::size_t k = 0; k < found[0].points.size(); ++k) {
          // Of two boxes, a floor's tile and a body, the first contact and so the plane differ by rounding.
          EXPECT_LE(max_abs(swapped[0].points[k].a - found[0].points[k].b), within);
          EXPECT_LE(std::abs(swapped[0].points[k].distance - found[0].points[k].distance), within);
        }
      }
}

/// Once a body is known to stand on a face, no triangle inside the face is asked about. While it is not known whether
/// the two touch, that holds for a body that is clear of the plane.
TYPED_TEST(WholeFaces, SpareTheTrianglesInsideThem) {
  using T = TypeParam;
  Random random(8);
  const Shape<T> box = Box<T>({1, 1, 1});
  const T margin = T(0.02);
  for (const Shape<T>& floor : {flat_mesh<T>(random, true), flat_field<T>()})
    for (const T height : {T(0.499), T(0.51)}) {
      const Pose<T> ground{{T(3), T(-5), T(7)}, normalized(converted<T>(testing::random_rotation(random)))};
      const Pose<T> pose = compose(ground, {{T(0.13), height, T(0.07)}, {}});
      const Part<T> whole{floor, ground}, body{box, pose};
      FlatFaces<T> faces(whole, body, margin, true), beside_others(whole, body, margin, false);
      std::size_t inside = 0, count = 0;
      with_surface(floor, [&](const auto& surface) {
        const auto stand = [&](std::uint32_t number) {
          const Corners<T> corners = surface.triangle(number);
          const Shape<T> shape = Triangle<T>(corners[0], corners[1], corners[2]);
          const Part<T> piece = whole.piece(shape, ground, number);
          Manifold<T> manifold;
          convex_contacts(shape, ground, box, pose, margin, manifold);
          if (manifold.points.empty()) return;
          EXPECT_FALSE(beside_others.passes_over(piece, body, true));
          EXPECT_EQ(faces.passes_over(piece, body, true), faces.knows_faces() && surface.lies_level(number));
          EXPECT_EQ(faces.passes_over(piece, body, false), faces.passes_over(piece, body, true) && height > T(0.5));
          inside += faces.passes_over(piece, body, true) ? 1 : 0;
          ++count;
          beside_others.stand(piece, body, manifold);
          faces.stand(piece, body, manifold);
        };
        for (std::uint32_t i = 0; i < 2 * cells * cells; ++i) stand(i);
      });
      EXPECT_GT(count, 10u);
      EXPECT_GE(inside + 4, count);
    }
}

/// Whether a body touches is told by the triangles that are asked about, and is what its distance says.
TYPED_TEST(WholeFaces, SayWhetherTheirBodyTouches) {
  using T = TypeParam;
  Random random(12);
  std::size_t touching = 0;
  constexpr std::size_t frames = 200;
  for (const Shape<T>& floor : {flat_mesh<T>(random, true), flat_field<T>()})
    for (const StandingBody<T>& body : bodies<T>())
      for (std::size_t i = 0; i < frames; ++i) {
        Pose<T> pose = leaning(body, random, normalized(Quat<T>{0, static_cast<T>(i), 0, 20}));
        pose.translation.y += static_cast<T>(uniform(random, 0, 0.005f));
        Manifolds<T> found;
        const bool touches = contacts(floor, {}, body.shape, pose, T(0.02), found);
        touching += touches ? 1 : 0;
        const T apart = distance(floor, {}, body.shape, pose).distance;
        if (std::abs(apart) <= T(100) * tolerance<T>) continue;
        EXPECT_EQ(touches, apart < T(0)) << body.shape.name() << ", frame " << i << ", " << apart << " apart";
      }
  EXPECT_GT(touching, 2 * frames);
  EXPECT_LT(touching, 6 * frames);
}

/// A body that hangs over the rim has no point beyond that; it stands on the rim too.
TYPED_TEST(WholeFaces, EndWhereTheirPiecesEnd) {
  using T = TypeParam;
  const Shape<T> floor = tiles<T>(cells / 2), box = Box<T>({1, 1, 1});  // none where x < 0
  const Pose<T> pose{{T(0.13), T(0.499), T(0.07)}, {}};
  Manifolds<T> found;
  contacts(floor, {}, box, pose, contact_margin(floor, box), found);
  ASSERT_EQ(found.size(), 1u);
  T least_x(1), most_x(-1);
  for (const ContactPoint<T>& point : found[0].points) {
    least_x = std::min(least_x, point.a.x);
    most_x = std::max(most_x, point.a.x);
  }
  EXPECT_NEAR(static_cast<double>(least_x), 0, 1e-5);
  EXPECT_NEAR(static_cast<double>(most_x), 0.63, 1e-5);
}

/// Two floors of one height that a body spans, and a step between them that is as high as the body is deep.
TYPED_TEST(WholeFaces, OfOneHeightAreToldFromStepsBetweenThem) {
  using T = TypeParam;
  const Shape<T> box = Box<T>({2, 1, 1});
  const auto tile = [](T x, T top) { return Placed<T>{Box<T>({T(0.5), 1, 2}), {{x, top - T(0.5), T(0)}, {}}}; };
  for (const T step : {T(-0.2), T(0), T(0.05)}) {
    const Shape<T> floor = Compound<T>({tile(T(-1), T(0)), tile(T(0), step), tile(T(1), T(0))});
    const Pose<T> pose{{T(0), T(0.49), T(0)}, {}};
    Manifolds<T> found;
    EXPECT_TRUE(contacts(floor, {}, box, pose, T(0.01), found));
    T deepest(0);
    for (const Manifold<T>& manifold : found)
      for (const ContactPoint<T>& point : manifold.points) deepest = std::min(deepest, point.distance);
    EXPECT_NEAR(static_cast<double>(deepest), -0.01 - std::max(0.0, static_cast<double>(step)), 1e-5) << step;
  }
}

}  // namespace
}  // namespace graze
