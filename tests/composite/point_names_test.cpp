// Feature numbers of contacts of composites: single within a manifold, whose points several pieces may have, so that a
// solver can carry impulses by them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "common/cube_mesh.hpp"
#include "composite/merge_manifolds.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::cube_mesh;

template <class T>
Manifolds<T> contacts_of(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  Manifolds<T> manifolds;
  contacts(a, pose_a, b, pose_b, T(0.01), manifolds);
  return manifolds;
}

/// Points that stay where they are, and those of them that change their numbers.
struct Steadiness {
  int stay = 0, changed = 0;
};

/// Whether any point of the manifolds is at the place of one of this manifold, and has this number if one is given.
template <class T>
bool has_near(const Manifolds<T>& manifolds, const Manifold<T>& manifold, const ContactPoint<T>& point,
              bool of_its_number) {
  constexpr T near = T(1e-3), alike = T(0.999);
  for (const Manifold<T>& m : manifolds)
    for (const ContactPoint<T>& p : m.points)
      if (dot(m.normal, manifold.normal) > alike && max_abs(p.a - point.a) < near && max_abs(p.b - point.b) < near &&
          (!of_its_number || p.feature == point.feature))
        return true;
  return false;
}

template <class T>
class PointNumbers : public ::testing::Test {
 protected:
  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// A sheet of 4 x 4 cells, 1 wide, with bumps.
  Shape<T> sheet(double width, double bump) {
    constexpr std::uint32_t n = 4;
    std::vector<Vec3<T>> points;
    std::vector<typename Mesh<T>::Index> triangles;
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t k = 0; k <= n; ++k)
        points.push_back({T(width * (i / 4.0 - 0.5)), T(draw(-bump, bump)), T(width * (k / 4.0 - 0.5))});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t at = i * (n + 1) + k;
        triangles.push_back({at, at + 1, at + n + 2});
        triangles.push_back({at, at + n + 2, at + n + 1});
      }
    return Mesh<T>(points, triangles);
  }
  Shape<T> field(double width, double bump) {
    std::vector<T> heights;
    for (int i = 0; i < 25; ++i) heights.push_back(T(draw(-bump, bump)));
    return HeightField<T>(5, 5, heights, T(width / 4), T(width / 4));
  }
  Shape<T> tiles(double width) {
    std::vector<Placed<T>> children;
    for (const double x : {-0.25, 0.25})
      for (const double z : {-0.25, 0.25})
        children.push_back({Box<T>({T(width / 2), T(0.1), T(width / 2)}), {{T(x * width), T(0), T(z * width)}, {}}});
    return Compound<T>(children);
  }
  /// A table of five boxes.
  Shape<T> table() {
    std::vector<Placed<T>> children;
    for (const double x : {-0.3, 0.3})
      for (const double z : {-0.3, 0.3})
        children.push_back({Box<T>({T(0.2), T(0.5), T(0.2)}), {{T(x), T(-0.25), T(z)}, {}}});
    children.push_back({Box<T>({T(1), T(0.1), T(1)}), {{T(0), T(0.05), T(0)}, {}}});
    return Compound<T>(children);
  }
  std::vector<Shape<T>> floors() {
    return {sheet(4, 0),
            sheet(4, 0.05),
            field(4, 0),
            field(4, 0.05),
            tiles(4),
            table(),
            cube_mesh<T>(T(0.5), false),
            cube_mesh<T>(T(0.5), true)};
  }
  std::vector<Shape<T>> bodies() {
    return {Box<T>({T(1), T(1), T(1)}),  Cylinder<T>(T(1), T(0.5)),  tiles(1),     table(),
            cube_mesh<T>(T(0.5), false), cube_mesh<T>(T(0.5), true), sheet(1, .1), field(1, .1)};
  }
  /// A body up to 3 cm deep in the top of a floor or up to 1 cm above it, upright or leaning.
  Pose<T> on(const Shape<T>& floor, const Shape<T>& body, int i) {
    const double lean = i % 4 == 0 ? 0 : i % 2 == 0 ? 2e-3 * draw(-1, 1) : draw(-3, 3), about = draw(-3, 3);
    const Quatd leans = Quatd::from_axis_angle({std::cos(about), 0, std::sin(about)}, lean);
    const Quatd turn = Quatd::from_axis_angle({0, 1, 0}, i % 8 == 0 ? 0 : draw(-3, 3));
    Pose<T> pose{{T(draw(-0.5, 0.5)), 0, T(draw(-0.5, 0.5))}, converted<T>(normalized(leans * turn))};
    pose.translation.y = bounds(floor, Pose<T>{}).upper.y - bounds(body, pose).lower.y - T(draw(-0.01, 0.03));
    return pose;
  }
  /// How numbers stay from frame to frame while a body jitters on a floor, by a hundredth of the way that counts as
  /// staying and by as little a turn.
  Steadiness steadiness(const Shape<T>& floor, const Shape<T>& body) {
    random_.seed(11);
    Steadiness found;
    for (int i = 0; i < 400; ++i) {
      Pose<T> rest{{T(draw(-0.5, 0.5)), 0, T(draw(-0.5, 0.5))},
                   converted<T>(normalized(Quatd::from_axis_angle({0, 1, 0}, draw(-3, 3))))};
      rest.translation.y = bounds(floor, Pose<T>{}).upper.y - bounds(body, rest).lower.y - T(draw(-0.005, 0.03));
      Manifolds<T> before;
      for (int frame = 0; frame < 8; ++frame) {
        const double about = draw(-3, 3);
        const Quatd turn = Quatd::from_axis_angle({std::cos(about), 0, std::sin(about)}, draw(-2e-4, 2e-4));
        const Vec3d step{draw(-1e-5, 1e-5), draw(-1e-5, 1e-5), draw(-1e-5, 1e-5)};
        const Manifolds<T> now =
            contacts_of(floor, Pose<T>{}, body,
                        Pose<T>{rest.translation + converted<T>(step),
                                converted<T>(normalized(turn * converted<double>(rest.rotation)))});
        for (const Manifold<T>& m : now)
          for (const ContactPoint<T>& p : m.points) {
            if (!has_near(before, m, p, false)) continue;
            ++found.stay;
            found.changed += !has_near(before, m, p, true);
          }
        before = now;
      }
    }
    return found;
  }

 private:
  std::mt19937 random_{7};
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PointNumbers, Scalars);

template <class T>
std::vector<std::uint32_t> numbers_of(const Manifold<T>& manifold) {
  std::vector<std::uint32_t> numbers;
  for (const ContactPoint<T>& p : manifold.points) numbers.push_back(p.feature);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

template <class T>
Shape<T> in_compound(const Shape<T>& shape) {
  return Compound<T>({{shape, {}}});
}

TYPED_TEST(PointNumbers, OfAClosedMeshOnAFlatFloorStay) {
  using T = TypeParam;
  const Shape<T> floor = this->sheet(4, 0), cube = cube_mesh<T>(T(0.5), true);
  const Steadiness found = this->steadiness(floor, cube);
  EXPECT_GT(found.stay, 1000);
  EXPECT_EQ(found.changed, 0);
}

/// On bumps a corner of the cube comes off one triangle and onto another: that changes its number in one point of
/// twenty.
TYPED_TEST(PointNumbers, OfAMeshOnBumpsMostlyStay) {
  using T = TypeParam;
  const Shape<T> floor = this->sheet(4, 0.05), cube = cube_mesh<T>(T(0.5), true);
  for (const Shape<T>& ground : {floor, in_compound(floor)})
    for (const Shape<T>& body : {cube, in_compound(cube)}) {
      const Steadiness found = this->steadiness(ground, body);
      EXPECT_GT(found.stay, 1000);
      EXPECT_LT(20 * found.changed, found.stay) << body.name() << " on " << ground.name();
    }
}

/// A mesh is about as steady as a child.
TYPED_TEST(PointNumbers, AreAsSteadyInACompound) {
  using T = TypeParam;
  const Shape<T> floor = this->sheet(4, 0.05), sheet = this->sheet(1, 0);
  const Steadiness alone = this->steadiness(floor, sheet);
  EXPECT_GT(alone.stay, 1000);
  for (const Shape<T>& ground : {floor, in_compound(floor)})
    for (const Shape<T>& body : {sheet, in_compound(sheet)})
      EXPECT_LE(2 * this->steadiness(ground, body).changed, 3 * alone.changed)
          << body.name() << " on " << ground.name();
}

TYPED_TEST(PointNumbers, AreSingleWithinAManifold) {
  using T = TypeParam;
  int of_several_points = 0;
  for (const Shape<T>& floor : this->floors())
    for (const Shape<T>& body : this->bodies())
      for (int i = 0; i < 40; ++i)
        for (const Manifold<T>& manifold : contacts_of(floor, Pose<T>{}, body, this->on(floor, body, i))) {
          const std::vector<std::uint32_t> numbers = numbers_of(manifold);
          of_several_points += numbers.size() > 1;
          EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end())
              << body.name() << " on " << floor.name() << ' ' << i;
        }
  EXPECT_GT(of_several_points, 1000);
}

Manifold<double> row_of_points(std::uint32_t piece, std::uint32_t features) {
  Manifold<double> manifold;
  manifold.normal = {0, 1, 0};
  manifold.piece_a = piece;
  for (std::uint32_t i = 0; i < features; ++i) {
    const Vec3d place{double(piece), 0, double(i)};
    manifold.points.push_back({place, place, 0, feature_id(face_feature(0), vertex_feature(i)), 0.5});
  }
  return manifold;
}

/// The manifold of pieces found in this order, those of one child of a compound.
Manifold<double> joined(const std::vector<std::uint32_t>& pieces) {
  Manifolds<double> manifolds;
  ManifoldGroups<double> groups(manifolds);
  for (const std::uint32_t piece : pieces) {
    Manifold<double> manifold = row_of_points(piece, 3);
    manifold.piece_a = 0;
    groups.add(manifold, {piece + 1, 0});
  }
  groups.finish();
  groups.name_points();
  return manifolds.at(0);
}

/// Which piece is found first changes from frame to frame.
TEST(PointNames, DoNotDependOnTheOrderOfThePieces) {
  const Manifold<double> one = joined({3, 7, 5}), other = joined({7, 5, 3});
  ASSERT_EQ(one.points.size(), 9u);
  EXPECT_EQ(numbers_of(one), numbers_of(other));
  for (const ContactPoint<double>& p : one.points)
    for (const ContactPoint<double>& q : other.points) {
      if (!(p.a == q.a)) continue;
      EXPECT_EQ(p.feature, q.feature);
      EXPECT_EQ(p.feature & 0xffff, vertex_feature(static_cast<std::uint32_t>(p.a.z)));
    }
}

/// A corner that several triangles have is one point, whichever of them is found first.
TEST(PointNames, OfPointsAtOnePlaceAreThoseOfTheLowestPiece) {
  const auto numbers = [](const std::vector<std::uint32_t>& pieces, std::uint32_t copies) {
    Manifolds<double> manifolds;
    ManifoldGroups<double> groups(manifolds);
    for (const std::uint32_t piece : pieces) {
      Manifold<double> manifold = row_of_points(0, copies);
      for (ContactPoint<double>& p : manifold.points) p.feature += piece;
      groups.add(manifold, {piece + 1, 0});
    }
    groups.finish();
    groups.name_points();
    EXPECT_EQ(manifolds.at(0).points.size(), copies);
    return numbers_of(manifolds[0]);
  };
  for (const std::uint32_t copies : {3u, 30u}) {  // few, and more than are compared with each other
    EXPECT_EQ(numbers({3, 7, 5}, copies), numbers({7, 5, 3}, copies));
    EXPECT_EQ(numbers({3, 7, 5}, copies), numbers({3}, copies));
  }
}

/// The numbers of B come first where it is A.
TEST(PointNames, AreMirroredWhereShapesAreSwapped) {
  Manifolds<double> there, back;
  ManifoldGroups<double> groups_there(there), groups_back(back);
  for (const std::uint32_t piece : {2u, 8u, 6u}) {
    Manifold<double> manifold = row_of_points(piece, 3);
    groups_there.add(manifold, {piece + 1, 0});
    for (ContactPoint<double>& p : manifold.points) p = mirrored(p);
    std::swap(manifold.piece_a, manifold.piece_b);
    groups_back.add(manifold, {0, piece + 1});
  }
  for (ManifoldGroups<double>* groups : {&groups_there, &groups_back}) {
    groups->finish();
    groups->name_points();
  }
  ASSERT_EQ(there.size(), 1u);
  ASSERT_EQ(back.size(), 1u);
  for (std::size_t i = 0; i < there[0].points.size(); ++i)
    EXPECT_EQ(there[0].points[i].feature, swapped_feature_id(back[0].points[i].feature)) << i;
}

/// A number that nobody else has, and that of the lowest piece, is the pieces' own.
TEST(PointNames, AreThoseOfThePiecesWhereTheyCan) {
  Manifolds<double> manifolds;
  ManifoldGroups<double> groups(manifolds);
  groups.add(row_of_points(9, 3), {10, 0});
  groups.add(row_of_points(4, 2), {5, 0});
  groups.finish();
  groups.name_points();
  ASSERT_EQ(manifolds.size(), 1u);
  for (const ContactPoint<double>& p : manifolds[0].points) {
    const bool own = p.feature == feature_id(face_feature(0), vertex_feature(static_cast<std::uint32_t>(p.a.z)));
    EXPECT_EQ(own, p.a.x == 4 || p.a.z == 2);
  }
}

/// More than are held without a join, and more than fourteen bits can tell apart in one half.
TEST(PointNames, AreSingleAmongThousands) {
  Manifolds<double> manifolds;
  ManifoldGroups<double> groups(manifolds);
  for (std::uint32_t piece = 0; piece < 20000; ++piece) groups.add(row_of_points(piece, 1), {piece + 1, 0});
  groups.finish();
  groups.name_points();
  ASSERT_EQ(manifolds.size(), 1u);
  const std::vector<std::uint32_t> numbers = numbers_of(manifolds[0]);
  ASSERT_EQ(numbers.size(), 20000u);
  EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace
}  // namespace graze
