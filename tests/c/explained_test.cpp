// What C is told of how an answer was found, and of what a blow does, beside what C++ is told.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

#include "common/specimen.hpp"
#include "graze/graze.h"
#include "graze/graze.hpp"

namespace graze {
namespace {

#define OK(call) ASSERT_EQ(call, GRAZE_OK) << graze_last_error()

void expect_same(const Vec3d& cpp, const double (&c)[3]) { EXPECT_EQ(cpp, (Vec3d{c[0], c[1], c[2]})); }

void expect_same(const std::vector<TraceSupport>& cpp, const GrazeTraceSupport* c, std::size_t count) {
  ASSERT_EQ(cpp.size(), count);
  for (std::size_t i = 0; i < count; ++i) expect_same(cpp[i].a, c[i].a), expect_same(cpp[i].b, c[i].b);
}

void expect_same(const Trace& cpp, const GrazeTraceView& c) {
  EXPECT_EQ(cpp.method, c.method);
  EXPECT_EQ(cpp.winner, c.winner);
  EXPECT_EQ(cpp.reason, c.reason);
  ASSERT_EQ(cpp.axes.size(), c.axis_count);
  for (std::size_t i = 0; i < c.axis_count; ++i) {
    EXPECT_EQ(cpp.axes[i].name, c.axes[i].name);
    expect_same(cpp.axes[i].direction, c.axes[i].direction);
    EXPECT_EQ(cpp.axes[i].a_upper, c.axes[i].a_upper);
    EXPECT_EQ(cpp.axes[i].b_lower, c.axes[i].b_lower);
  }
  ASSERT_EQ(cpp.gjk.size(), c.gjk_count);
  for (std::size_t i = 0; i < c.gjk_count; ++i) {
    expect_same(cpp.gjk[i].simplex, c.gjk[i].simplex, c.gjk[i].simplex_count);
    expect_same(cpp.gjk[i].polygon, c.gjk[i].polygon, c.gjk[i].polygon_count);
    expect_same(cpp.gjk[i].direction, c.gjk[i].direction);
    expect_same(cpp.gjk[i].found.a, c.gjk[i].found.a);
    EXPECT_EQ(cpp.gjk[i].upper, c.gjk[i].upper);
  }
  ASSERT_EQ(cpp.epa.size(), c.epa_count);
  for (std::size_t i = 0; i < c.epa_count; ++i) {
    expect_same(cpp.epa[i].normal, c.epa[i].normal);
    expect_same(cpp.epa[i].found.b, c.epa[i].found.b);
    EXPECT_EQ(cpp.epa[i].found_depth, c.epa[i].found_depth);
    EXPECT_EQ(cpp.epa[i].faces, c.epa[i].faces);
  }
  ASSERT_EQ(cpp.spans.size(), c.span_count);
  for (std::size_t i = 0; i < c.span_count; ++i) {
    EXPECT_EQ(cpp.spans[i].name, c.spans[i].name);
    EXPECT_EQ(cpp.spans[i].leave, c.spans[i].leave);
  }
  ASSERT_EQ(cpp.steps.size(), c.step_count);
  for (std::size_t i = 0; i < c.step_count; ++i) {
    EXPECT_EQ(cpp.steps[i].t, c.steps[i].t);
    expect_same(cpp.steps[i].normal, c.steps[i].normal);
  }
  expect_same(cpp.difference, c.difference, c.difference_count);
  expect_same(cpp.polytope, c.polytope, c.polytope_count);
  ASSERT_EQ(cpp.triangles.size(), c.triangle_count);
  for (std::size_t i = 0; i < c.triangle_count; ++i) EXPECT_EQ(cpp.triangles[i][2], c.triangles[i].corner[2]);
  const auto expect_corners = [](const std::vector<Vec3d>& corners, const double* seen, std::size_t count) {
    ASSERT_EQ(corners.size(), count);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(corners[i], (Vec3d{seen[3 * i], seen[3 * i + 1], seen[3 * i + 2]}));
  };
  expect_corners(cpp.face_a, c.face_a, c.face_a_count);
  expect_corners(cpp.face_b, c.face_b, c.face_b_count);
  ASSERT_EQ(cpp.cuts.size(), c.cut_count);
  for (std::size_t i = 0; i < c.cut_count; ++i) {
    expect_same(cpp.cuts[i].from, c.cuts[i].from);
    expect_same(cpp.cuts[i].to, c.cuts[i].to);
    expect_corners(cpp.cuts[i].left, c.cuts[i].left, c.cuts[i].left_count);
  }
  EXPECT_EQ(cpp.rounding, c.rounding);
  EXPECT_EQ(cpp.nodes, c.nodes);
  EXPECT_EQ(cpp.pieces, c.pieces);
}

/// A box and an ellipsoid that overlap, and a trace that is used again and again.
class ExplainedInC : public ::testing::Test {
 protected:
  void SetUp() override {
    OK(graze_shape_box_d({2, 1, 2}, &box));
    OK(graze_shape_ellipsoid_d({0.5, 1, 0.75}, &egg));
    OK(graze_trace_create(&trace));
    OK(graze_buffer_create_d(&buffer));
  }
  void TearDown() override {
    graze_shape_release_d(box), graze_shape_release_d(egg);
    graze_trace_destroy(trace), graze_buffer_destroy_d(buffer);
  }
  /// The trace of C after a call, beside that of C++.
  void compare(GrazeStatus status, const Trace& cpp) {
    OK(status);
    GrazeTraceView view;
    OK(graze_trace_view(trace, &view));
    expect_same(cpp, view);
    EXPECT_FALSE(cpp.method.empty());
  }

  const Shape<double> cpp_box = Box<double>({2, 1, 2}), cpp_egg = Ellipsoid<double>({0.5, 1, 0.75});
  const Posed here{}, there{{1.2, 0.4, 0.1}, {0, 0, 0.6, 0.8}};
  const GrazePosed c_here = std::bit_cast<GrazePosed>(here), c_there = std::bit_cast<GrazePosed>(there);
  GrazeShaped *box = nullptr, *egg = nullptr;
  GrazeTrace* trace = nullptr;
  GrazeBufferd* buffer = nullptr;
};

TEST_F(ExplainedInC, EveryQuestionTellsWhatItTellsCpp) {
  Trace cpp;
  bool yes = false;
  overlap(cpp_box, here, cpp_egg, there, &cpp);
  compare(graze_overlap_explained_d(box, &c_here, egg, &c_there, &yes, trace), cpp);
  cpp = {};
  GrazeDistanced d, unexplained;
  distance(cpp_box, here, cpp_egg, there, &cpp);
  compare(graze_distance_explained_d(box, &c_here, egg, &c_there, &d, trace), cpp);
  OK(graze_distance_d(box, &c_here, egg, &c_there, &unexplained));
  EXPECT_EQ(d.distance, unexplained.distance);
  cpp = {};
  Manifolds<double> manifolds;
  contacts(cpp_box, here, cpp_egg, there, 0.1, manifolds, &cpp);
  GrazeContactsd found;
  compare(graze_contacts_explained_d(box, &c_here, egg, &c_there, 0.1, buffer, &found, trace), cpp);
  cpp = {};
  closest(cpp_egg, there, Vec3d{3, 0, 0}, &cpp);
  GrazeClosestd nearest;
  compare(graze_closest_explained_d(egg, &c_there, {3, 0, 0}, &nearest, trace), cpp);
  cpp = {};
  const GrazeRayd ray{{-5, 0.25, 0}, {1, 0, 0}};
  GrazeRayHitd hit;
  raycast(cpp_box, here, std::bit_cast<Ray<double>>(ray), 9.0, BackFaces::hit, &cpp);
  compare(graze_raycast_explained_d(box, &c_here, &ray, 9, GRAZE_BACK_FACES_HIT, &yes, &hit, trace), cpp);
  cpp = {};
  const GrazeMovingd standing{box, c_here, {}}, moving{egg, {{5, 0, 0}, {0, 0, 0, 1}}, {{-4, 0, 0}, {0, 0, 2}}};
  GrazeCastHitd blow;
  cast(cpp_box, here, {}, cpp_egg, {{5, 0, 0}, {}}, {{-4, 0, 0}, {0, 0, 2}}, 2.0, {}, &cpp);
  compare(graze_cast_explained_d(&standing, &moving, 2, GRAZE_SEPARATING_HIT, &yes, &blow, trace), cpp);
  EXPECT_TRUE(yes);
}

TEST_F(ExplainedInC, ThePlaneTellsItsPolygons) {
  GrazePlaneShaped *square, *circle;
  OK(graze_plane_shape_box_d({2, 2}, &square));
  OK(graze_plane_shape_circle_d(0.5, &circle));
  const plane::Shape<double> cpp_square = plane::Box<double>({2, 2}), cpp_circle = plane::Circle<double>(0.5);
  const plane::Pose2<double> at{{1.75, 0.5}, {}};
  const auto c_at = std::bit_cast<GrazePose2d>(at), c_origin = graze_plane_pose_d(0, 0, 0);
  Trace cpp;
  plane::distance(cpp_square, {}, cpp_circle, at, &cpp);
  GrazePlaneDistanced d;
  compare(graze_plane_distance_explained_d(square, &c_origin, circle, &c_at, &d, trace), cpp);
  EXPECT_GT(cpp.difference.size(), 3u);
  cpp = {};
  const GrazePlaneMovingd standing{square, c_origin, {}}, moving{circle, c_at, {{-1, 0}, 0}};
  GrazePlaneCastHitd blow;
  bool yes = false;
  plane::cast(cpp_square, {}, {}, cpp_circle, at, plane::Velocity<double>{{-1, 0}, 0}, 2.0, {}, &cpp);
  compare(graze_plane_cast_explained_d(&standing, &moving, 2, GRAZE_SEPARATING_HIT, &yes, &blow, trace), cpp);
  cpp = {};
  plane::overlap(cpp_square, {}, cpp_circle, at, &cpp);
  compare(graze_plane_overlap_explained_d(square, &c_origin, circle, &c_at, &yes, trace), cpp);
  cpp = {};
  plane::Manifolds<double> manifolds;
  plane::contacts(cpp_square, {}, cpp_circle, at, 1.0, manifolds, &cpp);
  GrazePlaneContactsd found;
  compare(graze_plane_contacts_explained_d(square, &c_origin, circle, &c_at, 1, buffer, &found, trace), cpp);
  cpp = {};
  plane::closest(cpp_square, {}, plane::Vec2d{3, 0.5}, &cpp);
  GrazePlaneClosestd nearest;
  compare(graze_plane_closest_explained_d(square, &c_origin, {3, 0.5}, &nearest, trace), cpp);
  cpp = {};
  const GrazePlaneRayd ray{{-5, 0.25}, {1, 0}};
  GrazePlaneRayHitd hit;
  plane::raycast(cpp_square, {}, std::bit_cast<plane::Ray<double>>(ray), 9.0, &cpp);
  compare(graze_plane_raycast_explained_d(square, &c_origin, &ray, 9, &yes, &hit, trace), cpp);
  graze_plane_shape_release_d(square), graze_plane_shape_release_d(circle);
}

TEST_F(ExplainedInC, ContactsTellTheFacesAndTheCuts) {
  Trace cpp;
  Manifolds<double> manifolds;
  const Posed on{{0.5, 0.95, 0.25}, {}};
  const GrazePosed c_on = std::bit_cast<GrazePosed>(on);
  contacts(cpp_box, here, cpp_box, on, 0.0, manifolds, &cpp);
  GrazeContactsd found;
  compare(graze_contacts_explained_d(box, &c_here, box, &c_on, 0, buffer, &found, trace), cpp);
  EXPECT_EQ(cpp.cuts.size(), 4u);
}

TEST_F(ExplainedInC, OfAnotherHandleIsRefused) {
  GrazeTraceView view;
  EXPECT_EQ(graze_trace_view(nullptr, &view), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "trace: expected a pointer, got null");
  EXPECT_EQ(graze_trace_view(reinterpret_cast<GrazeTrace*>(box), &view), GRAZE_INVALID_VALUE);
  bool yes = false;
  EXPECT_EQ(graze_overlap_explained_d(box, &c_here, egg, &c_there, &yes, reinterpret_cast<GrazeTrace*>(buffer)),
            GRAZE_INVALID_VALUE);
}

TEST(BlowsInC, AreThoseOfCpp) {
  GrazeShaped* crate;
  OK(graze_shape_box_d({1, 2, 1}, &crate));
  GrazeInverseMassd inverse;
  OK(graze_inverse_mass_of_shape_d(crate, 12, {0, 0, 0, 1}, &inverse));
  EXPECT_DOUBLE_EQ(inverse.mass, 1.0 / 12);
  EXPECT_DOUBLE_EQ(inverse.inertia.row[2].z, 1.0 / 5);
  const GrazeMat3d tensor{{{5, 0, 0}, {0, 2, 0}, {0, 0, 5}}}, lopsided{{{5, 1, 0}, {0, 2, 0}, {0, 0, 5}}};
  GrazeInverseMassd of_tensor;
  OK(graze_inverse_mass_of_tensor_d(12, &tensor, {0, 0, 0, 1}, &of_tensor));
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(of_tensor.inertia.row[i].x, inverse.inertia.row[i].x, 1e-14);
    EXPECT_NEAR(of_tensor.inertia.row[i].y, inverse.inertia.row[i].y, 1e-14);
    EXPECT_NEAR(of_tensor.inertia.row[i].z, inverse.inertia.row[i].z, 1e-14);
  }
  EXPECT_EQ(graze_inverse_mass_of_tensor_d(12, &lopsided, {0, 0, 0, 1}, &of_tensor), GRAZE_INVALID_VALUE);
  const GrazeStruckBodyd ground{}, falling{{{1, -3, 0}, {0, 0, 0.5}, {-0.5, 1, 0}}, inverse};
  const GrazeStruckContactd contact{{0, 0, 0}, {0, 1, 0}, 0.25, 0.6};
  GrazeResponsed c;
  OK(graze_response_d(&contact, &ground, &falling, &c));
  const StruckBody<double> body{{{1, -3, 0}, {0, 0, 0.5}, {-0.5, 1, 0}},
                                inverse_mass(12.0, inertia_of(Shape<double>(Box<double>({1, 2, 1})), 12.0))};
  const Response<double> cpp = response(StruckContact<double>{{}, {0, 1, 0}, 0.25, 0.6}, {}, body);
  EXPECT_EQ(c.normal_impulse, cpp.normal_impulse);
  EXPECT_GT(c.normal_impulse, 0);
  EXPECT_EQ(static_cast<int>(c.at_fault), static_cast<int>(cpp.at_fault));
  EXPECT_EQ(c.approach_along_normal, cpp.approach.normal);
  EXPECT_EQ(c.friction_limit, cpp.friction_limit);
  EXPECT_EQ(c.b.angular.z, cpp.b.angular.z);
  GrazeMotiond pushed;
  OK(graze_apply_impulse_d(&falling, c.impulse, {0, 0, 0}, &pushed));
  EXPECT_EQ(pushed.linear.y, apply_impulse(body, cpp.impulse, Vec3d{}).linear.y);

  const GrazeStruckContactd leaning{{0, 0, 0}, {0, 2, 0}, 0, 0};
  EXPECT_EQ(graze_response_d(&leaning, &ground, &falling, &c), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "contact.normal: expected a vector of unit length, got 2");
  EXPECT_EQ(graze_inverse_mass_d(-1, {1, 1, 1}, {0, 0, 0, 1}, &inverse), GRAZE_INVALID_VALUE);
  EXPECT_EQ(graze_inverse_mass_d(1, {1, 1, 1}, {0, 0, 0, 2}, &inverse), GRAZE_INVALID_VALUE);
  EXPECT_STREQ(graze_last_error(), "rotation: expected a quaternion of unit length, got 2");
  graze_shape_release_d(crate);
}

TEST(BlowsInC, AreTheSameInFloat) {
  GrazeInverseMassf inverse;
  OK(graze_inverse_mass_f(2, {0.2f, 0.2f, 0.2f}, {0, 0, 0, 1}, &inverse));
  const GrazeStruckBodyf ground{}, ball{{{3, -4, 0}, {0, 0, 0}, {0, 0.5f, 0}}, inverse};
  const GrazeStruckContactf contact{{0, 0, 0}, {0, 1, 0}, 0.5f, 0.6f};
  GrazeResponsef c;
  OK(graze_response_f(&contact, &ground, &ball, &c));
  EXPECT_EQ(c.normal_impulse, 12);
  EXPECT_EQ(c.b.linear.y, 2);
}

}  // namespace
}  // namespace graze
