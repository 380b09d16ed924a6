// Every shape alone: support points, support faces, bounds, and what constructors refuse.
#include "graze/shape.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

using reference::Real;

reference::Vector vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

TEST(Shape, SupportAgreesWithTheReference) {
  Random random(1);
  for (int kind = 0; kind < bounded_kinds; ++kind)
    for (int i = 0; i < 300; ++i) {
      const PlacedSpecimen s{i % 2 ? random_specimen(static_cast<Kind>(kind), 1, random)
                                   : degenerate_specimen(static_cast<Kind>(kind), 1, random),
                             {},
                             {}};
      const Shaped shape = build<double>(s.specimen);
      const reference::Placed placed = reference_of(s);
      const Vec3d d = converted<double>(random_vector(random, 1));
      const Vec3d point = support(shape, d);
      EXPECT_NEAR(dot(point, normalized(d)), static_cast<double>(reference::support_value(placed, vector_of(d))), 1e-12)
          << describe(s);
      EXPECT_LT(reference::outside_distance(placed, vector_of(point)), 1e-12L) << describe(s);
      EXPECT_NEAR(dot(support(shape, d * 1e-20), d), dot(point, d), 1e-12);  // the length of a direction says nothing
    }
}

TEST(Shape, FacesLieOnTheirShapeAndFaceTheirDirection) {
  Random random(2);
  for (int kind = 0; kind < bounded_kinds; ++kind)
    for (int i = 0; i < 300; ++i) {
      PlacedSpecimen s{random_specimen(static_cast<Kind>(kind), 1, random), {}, {}};
      s.specimen.margin = 0;
      const Shaped shape = build<double>(s.specimen);
      const reference::Placed placed = reference_of(s);
      Vec3d d = normalized(converted<double>(random_vector(random, 1)));
      if (i % 3 == 0) d = normalized(Vec3d{std::round(d.x), std::round(d.y), std::round(d.z)});
      shape.visit([&](const auto& c) {
        if constexpr (BoundedConvex<std::decay_t<decltype(c)>>) {
          Face<double> face;
          c.core_face(d, face);
          ASSERT_GE(face.vertices.size(), 1u);
          EXPECT_EQ(face.vertices.size(), face.ids.size());
          const double most = dot(c.core_support(d), d), r = c.core_radius();
          for (const Vec3d& v : face.vertices) {
            EXPECT_LE(reference::outside_distance(placed, vector_of(v)), 1e-12L) << describe(s);
            EXPECT_GE(dot(v, d), most - 0.2 - r) << describe(s);
          }
          Vec3d turned;
          for (std::size_t k = 1; k + 1 < face.vertices.size(); ++k)
            turned += cross(face.vertices[k] - face.vertices[0], face.vertices[k + 1] - face.vertices[0]);
          if (face.vertices.size() > 2) {
            EXPECT_GT(dot(turned, d), 0) << describe(s);  // counter-clockwise from outside
          }
        }
      });
    }
}

TEST(Shape, BoundsHoldTheShapeAndTouchIt) {
  Random random(3);
  for (int kind = 0; kind < bounded_kinds; ++kind)
    for (int i = 0; i < 200; ++i) {
      const PlacedSpecimen s{random_specimen(static_cast<Kind>(kind), 1, random), random_vector(random, 10),
                             random_rotation(random)};
      const reference::Placed placed = reference_of(s);
      const Aabbd box = bounds(build<double>(s.specimen), pose_of<double>(s));
      const Aabbf single = bounds(build<float>(s.specimen), pose_of<float>(s));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec3d d;
        d[axis] = 1;
        const double upper = static_cast<double>(reference::support_value(placed, vector_of(d)));
        const double lower = -static_cast<double>(reference::support_value(placed, vector_of(-d)));
        EXPECT_GE(box.upper[axis], upper);
        EXPECT_LE(box.lower[axis], lower);
        EXPECT_NEAR(box.upper[axis], upper, 1e-12);
        EXPECT_NEAR(box.lower[axis], lower, 1e-12);
        EXPECT_GE(static_cast<double>(single.upper[axis]), upper) << describe(s);
        EXPECT_LE(static_cast<double>(single.lower[axis]), lower) << describe(s);
        EXPECT_NEAR(static_cast<double>(single.upper[axis]), upper, 1e-4);
      }
    }
  EXPECT_EQ(bounds<double>(HalfSpace<double>(), {}).lower.y, -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(bounds<double>({HalfSpace<double>(), 0.5}, {}).upper.y, 0.5, 1e-14);
}

template <class F>
std::string refusal(const F& make) {
  try {
    make();
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Shape, ConstructorsNameWhatTheyRefuse) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal([] { Sphere<double>(-2); }), "radius: expected a finite number >= 0, got -2");
  EXPECT_EQ(refusal([&] { return Sphere<double>(inf); }), "radius: expected a finite number >= 0, got inf");
  EXPECT_EQ(refusal([] { Box<double>({1, std::nan(""), 1}); }), "size[1]: expected a finite number >= 0, got nan");
  EXPECT_EQ(refusal([] { Capsule<double>(1, 2, -1); }), "radiusTop: expected a finite number >= 0, got -1");
  EXPECT_EQ(refusal([] { Cylinder<double>(-1, 2); }), "height: expected a finite number >= 0, got -1");
  EXPECT_EQ(refusal([] { Rectangle<double>(1, -1); }), "sizeZ: expected a finite number >= 0, got -1");
  EXPECT_EQ(refusal([] { Shaped(Sphere<double>(1), -1); }), "rounding: expected a finite number >= 0, got -1");
  EXPECT_EQ(refusal([] { UserConvex<double>(nullptr); }), "function: expected a support function, got null");
  EXPECT_EQ(refusal([&] {
              Triangle<double>({0, 0, 0}, {1, 0, 0}, {0, inf, 0});
            }),
            "points[2][1]: expected a finite number, got inf");
  EXPECT_EQ(refusal([] { Sphere<double>(0); }), "accepted");
}

}  // namespace
}  // namespace graze::testing
