// The separating axes of small polyhedra on lanes: those of the test one by one, at every level of the instruction set
// the same bits; and what boxes and triangles are made to for it.
#include "narrow/sat/hull_axes.hpp"

#include <gtest/gtest.h>

#include <iterator>

#include "common/specimen.hpp"
#include "narrow/core/faceted_shape.hpp"
#include "narrow/general.hpp"
#include "narrow/sat/separating_axes.hpp"

namespace graze::testing {
namespace {

constexpr double all_axes = std::numeric_limits<double>::infinity();

Specimen random_polyhedron(int i, float scale, Random& random) {
  static constexpr Kind kinds[] = {Kind::hull, Kind::box, Kind::hull, Kind::triangle, Kind::hull, Kind::rectangle};
  Specimen s = random_specimen(kinds[i % std::size(kinds)], scale, random);
  s.margin = 0;
  if (s.kind != Kind::hull) return s;
  s.points.resize(4 + random() % 9);
  for (Vec3f& p : s.points) p = random_vector(random, scale);
  return s;
}

struct TwoPolyhedra {
  TwoPolyhedra(const Specimen& first, const Specimen& second, float apart, Random& random)
      : TwoPolyhedra(first, second,
                     {converted<double>(random_vector(random, apart)),
                      normalized(converted<double>(random_rotation(random)))}) {}
  TwoPolyhedra(const Specimen& first, const Specimen& second, const Posed& b_in_a)
      : a(build<float>(first)), b(build<float>(second)), facets_a(a), facets_b(b), pose(b_in_a) {
    one_by_one_a.set(a);
    one_by_one_b.set(b, rotation_matrix(pose.rotation), pose.translation);
  }

  double size() const { return static_cast<double>(facets_a.view().corners.extent + facets_b.view().corners.extent); }
  SeparatingAxes one_by_one() const { return separating_axes(one_by_one_a, one_by_one_b, all_axes); }
  /// At all levels, which are the same; false where they have no answer.
  bool on_lanes(double enough, SeparatingAxes& axes) const {
    const FacetedPair pair{facets_a.view(), facets_b.view(), rotation_matrix(pose.rotation), pose.translation};
    const bool answered = GRAZE_KERNEL(Isa::baseline, hull_axes)(pair, enough, axes);
    for (const Isa level : {Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      SeparatingAxes again;
      EXPECT_EQ(GRAZE_KERNEL(level, hull_axes)(pair, enough, again), answered);
      for (const auto& [one, other] : {std::pair{axes.face_a, again.face_a}, std::pair{axes.face_b, again.face_b},
                                       std::pair{axes.edge, again.edge}}) {
        EXPECT_EQ(one.separation, other.separation);
        EXPECT_EQ(one.normal, other.normal);
        EXPECT_EQ(one.a, other.a);
        EXPECT_EQ(one.b, other.b);
      }
    }
    return answered;
  }

  Shape<float> a, b;
  FacetedShape facets_a, facets_b;
  Posed pose;
  Polyhedron one_by_one_a, one_by_one_b;
};

class HullAxes : public ::testing::Test {
 protected:
  /// The test one by one takes a hull's planes rounded to float.
  static constexpr double tolerance = 1e-6;

  /// The best of all is as good, and its normal shows it.
  void expect_best(const TwoPolyhedra& two) {
    SeparatingAxes found;
    ++asked_;
    if (!two.on_lanes(all_axes, found)) return;
    ++answered_;
    const double allowed = tolerance * (two.size() + max_abs(two.pose.translation));
    const SeparatingAxis best = found.best(0), expected = two.one_by_one().best(0);
    ASSERT_NEAR(best.separation, expected.separation, allowed);
    EXPECT_NEAR(length(best.normal), 1, 1e-12);
    const Vec3d on_a = two.one_by_one_a.vertices()[two.one_by_one_a.support_vertex(best.normal)];
    const Vec3d on_b = two.one_by_one_b.vertices()[two.one_by_one_b.support_vertex(-best.normal)];
    EXPECT_NEAR(dot(on_b - on_a, best.normal), best.separation, allowed);
    by_edges_ += best.kind == AxisKind::edges;
    apart_ += best.separation > 0;
  }

  int asked_ = 0, answered_ = 0, by_edges_ = 0, apart_ = 0;
};

TEST_F(HullAxes, AreThoseOfTheTestOneByOne) {
  Random random(31);
  for (int i = 0; i < 1200; ++i) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
    const float scale = scales[i % std::size(scales)];
    const Specimen a = random_polyhedron(i, scale, random), b = random_polyhedron(i / 6, scale, random);
    expect_best({a, b, 1.2f * scale, random});
  }
  EXPECT_GT(answered_, asked_ * 19 / 20);
  EXPECT_GT(by_edges_, asked_ / 5);
  EXPECT_GT(apart_, asked_ / 5);
  EXPECT_LT(apart_, asked_ * 4 / 5);
}

/// Deep in each other, alike and about one centre, where hardly an axis can be ruled out.
TEST_F(HullAxes, AreThoseOfTheTestOneByOneDeepInside) {
  Random random(32);
  for (int i = 0; i < 400; ++i) {
    const Specimen a = random_polyhedron(i, 1, random), b = i % 4 == 0 ? a : random_polyhedron(i / 6, 1, random);
    expect_best({a, b, i % 3 == 0 ? 0.0f : 0.1f, random});
  }
  EXPECT_GT(answered_, asked_ / 2);
}

/// Faces on faces and edges along edges: every axis is one of many.
TEST_F(HullAxes, AreThoseOfTheTestOneByOneOnALattice) {
  Random random(33);
  for (int i = 0; i < 600; ++i) {
    static constexpr Kind kinds[] = {Kind::box, Kind::hull, Kind::triangle, Kind::rectangle};
    PlacedSpecimen a = on_lattice(degenerate_specimen(kinds[i % 4], 1, random), 1, random);
    PlacedSpecimen b = on_lattice(degenerate_specimen(kinds[i / 4 % 4], 1, random), 1, random);
    a.specimen.margin = b.specimen.margin = 0;
    if (!has_facets(build<float>(a.specimen)) || !has_facets(build<float>(b.specimen))) continue;
    const TwoPolyhedra two(a.specimen, b.specimen, relative(pose_of<double>(a), pose_of<double>(b)));
    if (two.size() > 0) expect_best(two);
  }
  EXPECT_GT(asked_, 200);
  EXPECT_GT(answered_, asked_ * 3 / 4);
}

/// Far from each other one axis is enough, and it holds.
TEST_F(HullAxes, EndWithOneThatSeparatesByEnough) {
  Random random(34);
  int enough = 0;
  for (int i = 0; i < 300; ++i) {
    const Specimen a = random_polyhedron(i, 1, random), b = random_polyhedron(i / 6, 1, random);
    const TwoPolyhedra two(a, b, 4, random);
    SeparatingAxes found;
    if (!two.on_lanes(0.1, found)) continue;
    const double best = two.one_by_one().best(0).separation, shown = found.best(0).separation;
    EXPECT_EQ(shown > 0.1, best > 0.1);
    EXPECT_LE(shown, best + 1e-6);
    enough += shown > 0.1;
  }
  EXPECT_GT(enough, 150);
}

TEST_F(HullAxes, LeaveSizesWhoseSquaresNoFloatHoldsToOthers) {
  Random random(35);
  const Specimen tiny = random_polyhedron(1, 1e-17f, random);
  SeparatingAxes found;
  EXPECT_FALSE(TwoPolyhedra(tiny, tiny, Posed{}).on_lanes(all_axes, found));
}

/// What lanes read is what the shape is: no vertex beyond a plane, a ball inside, edges with their faces.
TEST_F(HullAxes, RowsHoldWhatTheirShapeDoes) {
  Random random(36);
  for (int i = 0; i < 200; ++i) {
    const Shape<float> shape = build<float>(random_polyhedron(i, 1, random));
    const FacetedShape facets(shape);
    const FacetedHull& view = facets.view();
    Polyhedron polyhedron;
    polyhedron.set(shape);
    ASSERT_EQ(view.corners.count, polyhedron.vertices().size());
    ASSERT_EQ(view.face_count, polyhedron.normals().size());
    ASSERT_EQ(view.edge_count, polyhedron.edges().size());
    for (std::uint32_t f = 0; f < view.face_count; ++f) {
      const Plane<double>& plane = view.planes[f];
      EXPECT_LE(length(plane.normal - polyhedron.normals()[f]), tolerance);
      EXPECT_NEAR(plane.offset, polyhedron.offset(f), tolerance);
      for (const Vec3d& v : polyhedron.vertices()) EXPECT_LE(signed_distance(plane, v), 0);
      EXPECT_LE(signed_distance(plane, converted<double>(view.ball.middle)),
                -static_cast<double>(view.ball.radius) + 1e-7);
      const FaceBlock& block = view.faces[f / FaceBlock::size];
      const std::size_t k = f % FaceBlock::size;
      EXPECT_EQ((Vec3f{block.x[k], block.y[k], block.z[k]}), converted<float>(plane.normal));
      EXPECT_EQ(block.offset[k], static_cast<float>(plane.offset));
      EXPECT_NEAR(signed_distance(plane, corner(view, block.vertex[k])), 0, tolerance);
    }
    for (std::uint32_t e = 0; e < view.edge_count; ++e) {
      const HullEdge &edge = view.edges[e], &expected = polyhedron.edges()[e];
      const EdgeBlock& block = view.edge_blocks[e / EdgeBlock::size];
      for (const std::size_t k : {0, 1}) {
        EXPECT_EQ(edge.vertex[k], expected.vertex[k]);
        EXPECT_EQ(edge.face[k], expected.face[k]);
      }
      EXPECT_EQ(block.left[e % EdgeBlock::size], expected.face[0]);
      EXPECT_EQ(block.right[e % EdgeBlock::size], expected.face[1]);
      EXPECT_NEAR(static_cast<double>(block.cosine[e % EdgeBlock::size]),
                  dot(polyhedron.normals()[expected.face[0]], polyhedron.normals()[expected.face[1]]), tolerance);
    }
    for (std::uint32_t v = 0; v < view.corners.count; ++v) {
      const VertexBlock& block = view.corners.blocks[v / VertexBlock::size];
      const std::size_t k = v % VertexBlock::size;
      EXPECT_EQ((Vec3f{block.x[k], block.y[k], block.z[k]}), view.corners.vertices[v]);
    }
  }
}

}  // namespace
}  // namespace graze::testing
