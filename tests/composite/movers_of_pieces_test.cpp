// Movers that are made of pieces, on floors that are: both surfaces have seams, and a contact has the floor's normal
// all the same. The poses are those that a survey of a million found wrong.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "composite/composite.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

template <class T>
class MoversOfPieces : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MoversOfPieces, Scalars);

/// A box of triangles, given by half its sides.
template <class T>
Shape<T> crate(const Vec3<T>& half) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  return Mesh<T>(std::move(points), {{0, 4, 6},
                                     {0, 6, 2},
                                     {1, 3, 7},
                                     {1, 7, 5},
                                     {0, 1, 5},
                                     {0, 5, 4},
                                     {2, 6, 7},
                                     {2, 7, 3},
                                     {0, 2, 3},
                                     {0, 3, 1},
                                     {4, 5, 7},
                                     {4, 7, 6}});
}

/// A top on two legs.
template <class T>
Shape<T> table() {
  return Compound<T>({{Box<T>({T(1.2), T(0.1), T(0.8)}), {{0, T(0.4), 0}, {}}},
                      {Box<T>({T(0.1), T(0.8), T(0.8)}), {{T(-0.55), 0, 0}, {}}},
                      {Box<T>({T(0.1), T(0.8), T(0.8)}), {{T(0.55), 0, 0}, {}}}});
}

// Squares of floor two units wide, their surface 0.5 above their own origin.
template <class T>
Shape<T> block_of_floor() {
  return Box<T>({2, 1, 2});
}
template <class T>
Shape<T> pyramid_of_floor() {
  return ConvexHull<T>(
      std::vector<Vec3<T>>{{-1, T(0.5), -1}, {1, T(0.5), -1}, {1, T(0.5), 1}, {-1, T(0.5), 1}, {0, -1, 0}});
}
template <class T>
Shape<T> plate_of_floor() {
  return Compound<T>({{Rectangle<T>(2, 2), {{0, T(0.5), 0}, {}}}});
}
template <class T>
Shape<T> sheet_of_floor() {
  return ConvexHull<T>(std::vector<Vec3<T>>{{-1, T(0.5), -1}, {1, T(0.5), -1}, {1, T(0.5), 1}, {-1, T(0.5), 1}});
}
template <class T>
Shape<T> crate_of_floor() {
  return crate<T>({1, T(0.5), 1});
}

template <class T>
using Square = Shape<T> (*)();

/// Six by six squares of two kinds by turns, their surface at y = 0.
template <class T>
std::vector<Placed<T>> squares_of(Square<T> one, Square<T> other) {
  std::vector<Placed<T>> all;
  for (int i = -3; i < 3; ++i)
    for (int j = -3; j < 3; ++j)
      all.push_back({(i + j) % 2 == 0 ? one() : other(), {{T(2 * i + 1), T(-0.5), T(2 * j + 1)}, {}}});
  return all;
}

/// A mover where a contact of it was wrong.
template <class T>
struct Mover {
  const char* name;
  Shape<T> shape;
  std::array<double, 7> place;  ///< x, y, z and the turn's x, y, z, w

  Pose<T> pose() const {
    const auto& p = place;
    return {{T(p[0]), T(p[1]), T(p[2])}, normalized(Quat<T>{T(p[3]), T(p[4]), T(p[5]), T(p[6])})};
  }
};

template <class T>
std::vector<Mover<T>> movers_found_wrong() {
  const Shape<T> of_triangles = crate<T>({T(0.4), T(0.3), T(0.5)});
  return {
      // An edge of the mover over a seam, where the second surface asked had taken a normal that the first refuses.
      {"crate",
       of_triangles,
       {0.317898333, 0.480565995, -1.48318207, 0.515856981, -0.059572991, 0.826845407, -0.216030777}},
      {"crate",
       of_triangles,
       {2.24299407, 0.651238263, 1.64926219, 0.301691324, -0.823547423, -0.247963265, -0.411419779}},
      {"crate",
       of_triangles,
       {-0.316550463, 0.486939192, -2.2472024, 0.877695322, -0.398849368, -0.244678885, 0.103452057}},
      {"table", table<T>(), {2.45688748, 0.683292925, 2.44870305, 0.724058449, -0.639795661, 0.140228644, -0.21618703}},
      {"table",
       table<T>(),
       {-2.40906143, 0.726146698, 1.72617269, 0.427920431, 0.645099759, -0.632944643, 0.0105664684}},
      {"table", table<T>(), {0.938617408, 0.545482159, 2.62619925, 0.695396721, -0.320244551, 0.4580203, 0.451756835}},
      // A wall of the mover a little beside a seam: the least way out of flat pieces is over their rim.
      {"table", table<T>(), {-1.70549273, 0.389119476, -2.937747, 0, 0.977168262, 0, 0.21246697}},
      {"crate", of_triangles, {2.14888024, 0.291830629, -1.50177276, 0, 0, 0, 1}},
      {"crate", of_triangles, {-2.23225784, 0.287493169, -3.50325918, 0, 0, 0, 1}},
      {"crate", of_triangles, {-0.101855733, 0.286099821, -0.49148953, 0, 0, 0, 1}},
      {"crate", of_triangles, {0.407588184, 0.284758896, 1.60776615, 0, -0.00304113375, 0, 0.999995351}},
      // One piece, at the corner or the rim of flat ones.
      {"capsule",
       Capsule<T>(1, T(0.3), T(0.3)),
       {0.0516004972, 0.782153547, 2.08685851, 0, -0.759296179, 0, 0.650745153}},
      {"box",
       Box<T>({1, T(0.5), T(1.5)}),
       {1.82598686, 0.895043433, 0.561003983, 0.768773079, 0.00475433422, 0.26757592, -0.58083427}},
      {"ellipsoid", Ellipsoid<T>({T(0.5), T(0.3), T(0.4)}), {-2.13634014, 0.281650811, -1.74669933, 0, 0, 0, 1}},
  };
}

/// How far a mover reaches below y = 0.
template <class T>
T depth_of(const Mover<T>& mover) {
  Manifolds<T> on_plane;
  contacts(Shape<T>(HalfSpace<T>()), Pose<T>{}, mover.shape, mover.pose(), T(0), on_plane);
  T deepest(0);
  for (const Manifold<T>& m : on_plane)
    for (const ContactPoint<T>& p : m.points) deepest = std::max(deepest, -p.distance);
  return deepest;
}

/// The contacts of a mover with all squares: children of one body, or bodies beside each other, as a world asks.
template <class T>
Manifolds<T> contacts_with(const std::vector<Placed<T>>& floor, bool as_bodies, const Shape<T>& shape,
                           const Pose<T>& pose) {
  Manifolds<T> found;
  if (!as_bodies) {
    const Shape<T> whole = Compound<T>(floor);
    contacts(whole, Pose<T>{}, shape, pose, contact_margin(whole, shape), found);
    return found;
  }
  std::vector<PlacedRef<T>> beside;
  for (const Placed<T>& square : floor) beside.push_back({&square.shape, &square.pose});
  for (const Placed<T>& square : floor)
    any_contacts<T>(square.shape, square.pose, shape, pose, contact_margin(square.shape, shape), found, {beside, {}});
  return found;
}

TYPED_TEST(MoversOfPieces, HaveTheNormalOfFloorsOfPiecesAndTheirWholeDepth) {
  using T = TypeParam;
  const std::pair<Square<T>, Square<T>> kinds[] = {
      {block_of_floor<T>, block_of_floor<T>},  {pyramid_of_floor<T>, pyramid_of_floor<T>},
      {plate_of_floor<T>, plate_of_floor<T>},  {sheet_of_floor<T>, sheet_of_floor<T>},
      {crate_of_floor<T>, crate_of_floor<T>},  {sheet_of_floor<T>, crate_of_floor<T>},
      {crate_of_floor<T>, pyramid_of_floor<T>}};
  for (const auto& [one, other] : kinds) {
    const std::vector<Placed<T>> floor = squares_of<T>(one, other);
    for (const Mover<T>& mover : movers_found_wrong<T>())
      for (const bool as_bodies : {false, true}) {
        SCOPED_TRACE(std::string(mover.name) + " at " + std::to_string(mover.place[0]) + " on " +
                     floor[0].shape.name() + " and " + floor[1].shape.name() + (as_bodies ? ", bodies" : ", children"));
        T deepest(0);
        for (const Manifold<T>& m : contacts_with(floor, as_bodies, mover.shape, mover.pose())) {
          EXPECT_LT(length(m.normal - Vec3<T>{0, 1, 0}), T(1e-3))
              << m.normal.x << ' ' << m.normal.y << ' ' << m.normal.z << ", pieces " << m.piece_a << '/' << m.piece_b;
          for (const ContactPoint<T>& p : m.points) deepest = std::max(deepest, -p.distance);
        }
        EXPECT_NEAR(deepest, depth_of(mover), T(1e-4));
      }
  }
}

}  // namespace
}  // namespace graze
