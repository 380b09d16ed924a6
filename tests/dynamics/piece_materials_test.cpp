// Materials of a body's pieces: each point of contact has that of its piece, in space and in the plane.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "dynamics/simulated.hpp"
#include "graze/error.hpp"
#include "graze/plane/simulation.hpp"
#include "graze/state_bytes.hpp"

namespace graze::testing {
namespace {

template <class T>
class PieceMaterialsOf : public ::testing::Test {};
using ScalarsOfPieces = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PieceMaterialsOf, ScalarsOfPieces);

/// Friction that the floor alone decides, and restitution that it alone decides.
template <class Material, class T>
Material floor_of(T friction, T restitution = T(0)) {
  Material m;
  m.static_friction = m.dynamic_friction = friction;
  m.restitution = restitution;
  m.friction_combine = m.restitution_combine = Combine::minimum;
  return m;
}
template <class T>
Material<T> slider_of() {
  return floor_of<Material<T>>(T(1), T(1));
}

/// Floors whose part with z < 0 is piece 0, or pieces 0 and 1: the same plane y = 0.
template <class T>
std::vector<std::pair<Shape<T>, std::vector<std::uint32_t>>> halved_floors() {
  const T far(40);
  const std::vector<Vec3<T>> corners{{-far, T(0), -far}, {far, T(0), -far}, {-far, T(0), T(0)},
                                     {far, T(0), T(0)},  {-far, T(0), far}, {far, T(0), far}};
  const Mesh<T> mesh(corners, {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}});
  const Box<T> slab({T(2) * far, T(1), far});
  const Compound<T> compound(
      std::vector<Placed<T>>{{slab, {{T(0), T(-0.5), -far / T(2)}, {}}}, {slab, {{T(0), T(-0.5), far / T(2)}, {}}}});
  const HeightField<T> field(2, 3, std::vector<T>(6, T(0)), T(2) * far, far);
  return {{mesh, {0, 0, 1, 1}}, {compound, {0, 1}}, {field, {0, 0, 1, 1}}};
}

template <class T>
Body<T> fixed(const Shape<T>& shape) {
  Body<T> body{shape};
  body.fixed = true;
  return body;
}

/// Boxes slide along on either half, one of ice, one that takes 3 m/s in a second.
TYPED_TEST(PieceMaterialsOf, BoxesSlideOnIceAndStopOnFelt) {
  using T = TypeParam;
  for (const auto& [floor, of_piece] : halved_floors<T>()) {
    Simulation<T> s(settings<T>());
    const std::vector<Material<T>> materials{floor_of<Material<T>>(T(0)), floor_of<Material<T>>(T(0.3))};
    s.set_materials(s.add(fixed(floor)), materials, of_piece);
    const auto slide = [&](T z) {
      return s.add({Box<T>({T(2), T(1), T(1)}), {{T(0), T(0.5), z}, {}}, {T(6), T(0), T(0)}}, {}, slider_of<T>());
    };
    const BodyId on_ice = slide(T(-4)), on_felt = slide(T(4));
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    EXPECT_NEAR(s.motion(on_ice).linear.x, T(6), T(1e-3)) << floor.name();
    EXPECT_NEAR(s.motion(on_felt).linear.x, T(3), T(0.03)) << floor.name();
  }
}

/// A box that slides along the seam has half of its weight on either material: points of one normal are of two pieces.
/// It does not turn, so that it stays on the seam.
TYPED_TEST(PieceMaterialsOf, BothSidesOfASeamCount) {
  using T = TypeParam;
  constexpr T inf = std::numeric_limits<T>::infinity();
  for (const auto& [floor, of_piece] : halved_floors<T>())
    for (const T turned : {T(0), T(1)}) {  // the floor's seam along x, and the other way round
      Simulation<T> s(settings<T>());
      const std::vector<Material<T>> materials{floor_of<Material<T>>(turned == T(0) ? T(0) : T(0.3)),
                                               floor_of<Material<T>>(turned == T(0) ? T(0.3) : T(0))};
      s.set_materials(s.add(fixed(floor)), materials, of_piece);
      Dynamics<T> upright;
      upright.inertia_diagonal = Vec3<T>{inf, inf, inf};
      const BodyId box =
          s.add({Box<T>({T(2), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}, {T(6), T(0), T(0)}}, upright, slider_of<T>());
      for (int i = 0; i < 64; ++i) s.step(T(dt));
      EXPECT_NEAR(s.motion(box).linear.x, T(4.5), T(0.05)) << floor.name() << " " << turned;
    }
}

/// A sled on two skids, of one compound: what one skid rubs the other does not.
TYPED_TEST(PieceMaterialsOf, SkidsRubEachByItself) {
  using T = TypeParam;
  constexpr T inf = std::numeric_limits<T>::infinity();
  for (const bool first_rubs : {true, false}) {
    Simulation<T> s(settings<T>());
    add_floor<T>(s, slider_of<T>());
    const Box<T> skid({T(2), T(0.2), T(0.2)});
    const Compound<T> sled(
        std::vector<Placed<T>>{{skid, {{T(0), T(0), T(-0.5)}, {}}}, {skid, {{T(0), T(0), T(0.5)}, {}}}});
    Dynamics<T> upright;
    upright.inertia_diagonal = Vec3<T>{inf, inf, inf};
    const BodyId id = s.add({sled, {{T(0), T(0.1), T(0)}, {}}, {T(6), T(0), T(0)}}, upright);
    const std::vector<Material<T>> materials{floor_of<Material<T>>(T(0)), floor_of<Material<T>>(T(0.3))};
    s.set_materials(id, materials, std::vector<std::uint32_t>{first_rubs ? 1u : 0u, first_rubs ? 0u : 1u});
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    EXPECT_NEAR(s.motion(id).linear.x, T(4.5), T(0.05)) << first_rubs;
  }
}

/// Restitution, rolling friction and a surface's velocity are the piece's too.
TYPED_TEST(PieceMaterialsOf, PiecesBounceBrakeAndRun) {
  using T = TypeParam;
  for (const auto& [floor, of_piece] : halved_floors<T>()) {
    Simulation<T> s(settings<T>());
    const BodyId ground = s.add(fixed(floor));
    std::vector<Material<T>> materials{floor_of<Material<T>>(T(0.5), T(1)), floor_of<Material<T>>(T(0.5), T(0))};
    materials[0].rolling_friction = T(0.07);
    s.set_materials(ground, materials, of_piece);
    const auto drop = [&](T z) { return s.add({Sphere<T>(T(0.5)), {{T(-8), T(1.75), z}, {}}}, {}, slider_of<T>()); };
    const auto roll = [&](T z) {
      return s.add({Sphere<T>(T(0.5)), {{T(8), T(0.5), z}, {}}, {T(4), T(0), T(0)}, {T(0), T(0), T(-8)}}, {},
                   slider_of<T>());
    };
    const BodyId bounces = drop(T(-4)), stays = drop(T(4)), slower = roll(T(-4)), rolls = roll(T(4));
    for (int i = 0; i < 64; ++i) s.step(T(dt));  // half a second down, half a second up
    EXPECT_NEAR(s.poses()[bounces.index].translation.y, T(1.75), T(0.02)) << floor.name();
    EXPECT_NEAR(s.poses()[stays.index].translation.y, T(0.5), T(0.01)) << floor.name();
    EXPECT_NEAR(s.motion(slower).linear.x, T(3), T(0.02)) << floor.name();
    EXPECT_NEAR(s.motion(rolls).linear.x, T(4), T(0.02)) << floor.name();
    materials[1].surface_velocity = {T(0), T(0), T(2)};
    s.set_materials(ground, materials, of_piece);
    for (int i = 0; i < 128; ++i) s.step(T(dt));
    EXPECT_GT(s.motion(rolls).linear.z, T(0.5)) << floor.name();
    EXPECT_NEAR(s.motion(slower).linear.z, T(0), T(0.01)) << floor.name();
    s.set_material(ground, floor_of<Material<T>>(T(0.5), T(0)));
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    // Without the belt it comes to rest: about the line of contact it never got any angular momentum.
    EXPECT_NEAR(s.motion(rolls).linear.z, T(0), T(0.01)) << "one material again";
  }
}

/// Materials of pieces belong to the state: `restore` brings them back, the hash and the bytes hold them.
TYPED_TEST(PieceMaterialsOf, StatesHoldThem) {
  using T = TypeParam;
  const auto [floor, of_piece] = halved_floors<T>()[0];
  Simulation<T> s(settings<T>());
  const BodyId ground = s.add(fixed(floor));
  const std::uint64_t plain = s.state_hash();
  std::vector<Material<T>> materials{floor_of<Material<T>>(T(0.1)), floor_of<Material<T>>(T(0.3))};
  materials[1].rolling_friction = T(0.1);
  s.set_materials(ground, materials, of_piece);
  EXPECT_NE(s.state_hash(), plain);
  for (int i = 0; i < 9; ++i)
    s.add({Cylinder<T>(T(1), T(0.5)), {{T(0), T(0.5) + T(i), T(i - 4) / T(8)}, {}}, {T(2), T(0), T(0)}}, {},
          slider_of<T>());
  poses_after(s, 20);
  const State<T> state = s.save(), again = read_state<T, Space<T>>(state_bytes(state));
  const auto once = poses_after(s, 40);
  const std::uint64_t hash = s.state_hash();
  s.set_material(ground, {});
  for (const State<T>& from : {state, again}) {
    s.restore(from);
    EXPECT_EQ(poses_after(s, 40), once);
    EXPECT_EQ(s.state_hash(), hash);
  }
}

TYPED_TEST(PieceMaterialsOf, BadOnesAreRefused) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  const auto [floor, of_piece] = halved_floors<T>()[0];
  const BodyId ground = s.add(fixed(floor)), ball = s.add({Sphere<T>(T(1)), {{T(0), T(4), T(0)}, {}}});
  const std::vector<Material<T>> two(2);
  const auto refused = [&](const std::string& path, BodyId id, std::vector<Material<T>> materials,
                           std::vector<std::uint32_t> pieces) {
    const std::uint64_t before = s.state_hash();
    try {
      s.set_materials(id, materials, pieces);
      ADD_FAILURE() << path;
    } catch (const InvalidValue& e) {
      EXPECT_EQ(e.path(), path) << e.what();
    }
    EXPECT_EQ(s.state_hash(), before);
  };
  refused("of_piece", ground, two, {0, 1, 1});
  refused("of_piece[2]", ground, two, {0, 1, 2, 0});
  refused("of_piece", ground, two, {});
  refused("body", ball, two, {0});
  refused("body", BodyId{}, two, {0});
  refused("materials[1].restitution", ground, {{}, {T(0.6), T(0.6), T(2)}}, {0, 1, 1, 0});
}

/// In the plane: the children of a compound, and the segments of a chain.
TYPED_TEST(PieceMaterialsOf, InThePlane) {
  using T = TypeParam;
  const T far(40);
  using Material = plane::Material<T>;
  const std::vector<plane::Vec2<T>> line{{far, T(0)}, {T(0), T(0)}, {-far, T(0)}};
  const plane::Box<T> slab({far, T(1)});
  const plane::Compound<T> slabs(std::vector<plane::Placed<T>>{{plane::Shape<T>(slab), {{far / T(2), T(-0.5)}, {}}},
                                                               {plane::Shape<T>(slab), {{-far / T(2), T(-0.5)}, {}}}});
  const std::vector<plane::Shape<T>> floors{plane::Chain<T>(line), slabs};
  for (const plane::Shape<T>& floor : floors) {
    plane::SimulationSettings<T> settings;
    settings.gravity = {T(0), T(-10)};
    settings.sleep = false;
    plane::Simulation<T> s(settings);
    plane::Body<T> ground{floor};
    ground.fixed = true;
    const BodyId id = s.add(ground);
    s.set_materials(id, std::vector<Material>{floor_of<Material>(T(0)), floor_of<Material>(T(0.3))},
                    std::vector<std::uint32_t>{0, 1});
    const auto slide = [&](T x) {
      return s.add({plane::Box<T>({T(2), T(1)}), {{x, T(0.5)}, {}}, {T(6), T(0)}}, {}, floor_of<Material>(T(1)));
    };
    const BodyId on_ice = slide(T(4)), on_felt = slide(T(-12));
    for (int i = 0; i < 64; ++i) s.step(T(dt));
    EXPECT_NEAR(s.motion(on_ice).linear.x, T(6), T(1e-3)) << floor.name();
    EXPECT_NEAR(s.motion(on_felt).linear.x, T(3), T(0.03)) << floor.name();
  }
  plane::Simulation<T> s;
  const BodyId ball = s.add({plane::Circle<T>(T(1))});
  EXPECT_THROW(s.set_materials(ball, std::vector<Material>(1), std::vector<std::uint32_t>{0}), InvalidValue);
}

}  // namespace
}  // namespace graze::testing
