// Thin faces on the face of another shape: all their points, whichever way up and however little they lean.
#include <random>

#include "graze/query.hpp"
#include "graze/shape.hpp"
#include "gtest/gtest.h"

namespace graze::testing {
namespace {

constexpr double half_height = 0.5, half_turn = 3.14159265358979323846;

/// A prism whose top lies half_height above its middle.
template <class T>
Shape<T> prism(int corners, double radius) {
  std::vector<Vec3<T>> vertices;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * half_turn * i / corners + 0.1;
    for (const double y : {-half_height, half_height})
      vertices.push_back(converted<T>(Vec3d{radius * std::cos(angle), y, radius * std::sin(angle)}));
  }
  return ConvexHull<T>(vertices);
}

template <class T>
std::vector<Shape<T>> ground() {
  const std::vector<Vec3<T>> sheet{{-1, T(0.5), -1}, {1, T(0.5), -1}, {1, T(0.5), 1}, {-1, T(0.5), 1}};
  return {prism<T>(4, 1.4),  prism<T>(5, 1),    prism<T>(12, 1),
          Box<T>({2, 1, 2}), Cylinder<T>(1, 1), ConvexHull<T>(sheet)};
}

template <class T>
std::vector<Shape<T>> thin_faces() {
  const std::vector<Vec3<T>> sheet{
      {T(-0.5), 0, T(-0.4)}, {T(0.5), 0, T(-0.4)}, {T(0.5), 0, T(0.4)}, {T(-0.5), 0, T(0.4)}};
  return {Rectangle<T>(1, T(0.8)), Box<T>({1, 0, T(0.8)}), ConvexHull<T>(sheet),
          Triangle<T>({T(-0.5), 0, T(-0.5)}, {T(0.5), 0, T(-0.4)}, {T(0.1), 0, T(0.6)})};
}

/// Lays each thin face on each ground, leaning by `lean` about some axis, either way up, the pair turned as one.
template <class T>
void expect_whole_faces(double lean) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const Shape<T>& below : ground<T>())
    for (const Shape<T>& thin : thin_faces<T>())
      for (int i = 0; i < 40; ++i) {
        const Vec3d axis = normalized(Vec3d{unit(random), unit(random), unit(random)});
        const Quatd up = i % 2 == 0 ? Quatd{} : Quatd{1, 0, 0, 0};
        const Quatd leans = Quatd::from_axis_angle(axis, lean),
                    turned = Quatd::from_axis_angle({0, 1, 0}, 3 * unit(random));
        const double depth = i % 4 == 0 ? 0 : std::pow(10, -2 - 4 * std::abs(unit(random)));
        const Vec3d place{unit(random) * 0.3, half_height - depth, unit(random) * 0.3};
        const Quatd frame = normalized(Quatd{unit(random), unit(random), unit(random), unit(random)});
        const Pose<T> pose_below{{}, converted<T>(frame)};
        const Pose<T> pose_thin{converted<T>(rotate(frame, place)),
                                converted<T>(normalized(frame * leans * turned * up))};
        for (const bool swapped : {false, true}) {
          Manifolds<T> manifolds;
          swapped ? contacts(thin, pose_thin, below, pose_below, T(0.02), manifolds)
                  : contacts(below, pose_below, thin, pose_thin, T(0.02), manifolds);
          SCOPED_TRACE(::testing::Message()
                       << below.name() << " below " << thin.name() << ", " << i << ", leaning " << lean);
          ASSERT_EQ(manifolds.size(), 1u);
          EXPECT_GE(manifolds[0].points.size(), 3u);
          EXPECT_GT(std::abs(rotate(conjugate(pose_below.rotation), manifolds[0].normal).y), T(0.9999));
        }
      }
}

TEST(LyingFaces, AreMetWholeEitherWayUpHoweverLittleTheyLean) {
  for (const double lean : {0.0, 1e-9, 1e-7, 1e-5, 5e-5, 1e-4, 1e-3}) {
    expect_whole_faces<double>(lean);
    expect_whole_faces<float>(lean);
  }
}

}  // namespace
}  // namespace graze::testing
