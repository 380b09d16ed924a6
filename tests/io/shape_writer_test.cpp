// What the query protocol reads is the shape that was written.
#include "io/shape_writer.hpp"

#include <gtest/gtest.h>

#include "capture/shape_bytes.hpp"
#include "graze/error.hpp"
#include "io/json_value.hpp"
#include "io/question.hpp"

namespace graze::io {
namespace {

template <class S>
std::string shape_text(const S& shape) {
  JsonWriter out;
  write_shape(out, shape);
  return out.take();
}
/// All measures, as a capture holds them.
template <class S>
std::string measures_of(const S& shape) {
  capture::Writing out;
  capture::write_shape(out, shape);
  return out.bytes;
}
Shaped read_again(const Shaped& shape) {
  const Json json = parse_json(shape_text(shape));
  return read_shape<double>(JsonValue(json, "shape"));
}

/// One of each kind of convex shape but a segment, of sizes that no short decimal has.
template <class T>
std::vector<Shape<T>> convex_shapes() {
  const T third = T(1) / T(3), seventh = T(1) / T(7), tenth = T(0.1f);
  const std::vector<Vec3<T>> corners = {
      {T(0), T(0), T(0)}, {third, T(0), T(0)}, {T(0), seventh, T(0)}, {T(0), T(0), T(1)}};
  return {Sphere<T>(third),
          {Capsule<T>(third, seventh, tenth), tenth},
          {Box<T>({third, seventh, tenth}), seventh},
          Rectangle<T>(third, T(2)),
          Cylinder<T>(third, seventh, tenth),
          Cylinder<T>(third, seventh, T(0)),
          Ellipsoid<T>({third, seventh, tenth}),
          {ConvexHull<T>(corners), tenth},
          Triangle<T>(corners[1], corners[2], corners[3]),
          HalfSpace<T>()};
}

TEST(ShapeWriter, WhatIsReadHasTheSameMeasures) {
  for (const Shaped& shape : convex_shapes<double>())
    EXPECT_EQ(measures_of(read_again(shape)), measures_of(shape)) << shape_text(shape);
  const Shaped segment = read_again({LineSegment<double>({0.1, 0.2, 0.3}, {3, 2, 1}), 0.5});
  EXPECT_EQ(segment.rounding(), 0.5);
  ASSERT_NE(segment.as<ConvexHull<double>>(), nullptr);
  EXPECT_EQ(segment.as<ConvexHull<double>>()->data().vertices.size(), 2u);
}

TEST(ShapeWriter, FloatsAreWidened) {
  for (const Shapef& shape : convex_shapes<float>()) {
    const Json json = parse_json(shape_text(shape));
    EXPECT_EQ(measures_of(read_shape<float>(JsonValue(json, "shape"))), measures_of(shape)) << shape_text(shape);
  }
  EXPECT_EQ(shape_text(Shapef(Sphere<float>(0.1f))), shape_text(Shaped(Sphere<double>(double(0.1f)))));
}

TEST(ShapeWriter, SurfacesAndCompounds) {
  const double hole = std::numeric_limits<double>::quiet_NaN();
  const Shaped field = HeightField<double>(3, 2, {0, 0.5, hole, 1, 2, 3}, 0.5, 2);
  const Shaped mesh = Mesh<double>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, Sides::both, true);
  const Quatd turn = normalized(Quatd{0.1, 0.2, 0.3, 0.9});
  const Shaped compound = Compound<double>({{{Box<double>({1, 2, 3}), 0.25}, {{1, 2, 3}, turn}}, {mesh, {}}});
  for (const Shaped& shape : {field, mesh, compound}) EXPECT_EQ(measures_of(read_again(shape)), measures_of(shape));
  const Shaped beside = read_again(Sphere<double>(2, {3, 0, 0}));
  ASSERT_NE(beside.as<Compound<double>>(), nullptr);
  EXPECT_EQ(beside.as<Compound<double>>()->children()[0].pose.translation, (Vec3d{3, 0, 0}));
}

TEST(ShapeWriter, WhatTheProtocolHasNoWordsForIsRefused) {
  const Shaped mesh = Mesh<double>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, Sides::front);
  EXPECT_THROW(shape_text(mesh), InvalidValue);
  EXPECT_THROW(shape_text(Shaped(HeightField<double>(2, 2, {0, 0, 0, 0}, 1, 1, Sides::front))), InvalidValue);
}

}  // namespace
}  // namespace graze::io
