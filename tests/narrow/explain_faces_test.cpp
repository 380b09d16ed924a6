// The faces that contacts are told to stand on: each cut takes away what lies beyond its side and nothing else, and
// what is left in the end has the points of contact for corners.
#include "narrow/explain_faces.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

/// What of a point is across a normal, so that heights along it do not count.
Vec3d across(const Vec3d& p, const Vec3d& normal) { return p - normal * dot(p, normal); }

double distance_to_corners(const Vec3d& p, const std::vector<Vec3d>& corners, const Vec3d& normal) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3d& c : corners) nearest = std::min(nearest, length(across(p - c, normal)));
  return nearest;
}

/// Seen against the normal; negative when the corners go clockwise.
double area_of(const std::vector<Vec3d>& corners, const Vec3d& normal) {
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return dot(sum, normal) / 2;
}

/// The trace of a pair with contacts that stand on faces, checked. Returns how many cuts there were.
template <class T>
std::size_t expect_cuts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin) {
  Trace trace;
  Manifolds<T> manifolds;
  contacts(a, pose_a, b, pose_b, margin, manifolds, &trace);
  if (trace.face_a.empty()) {
    EXPECT_TRUE(trace.face_b.empty() && trace.cuts.empty());
    return 0;
  }
  EXPECT_EQ(manifolds.size(), 1u);
  const Vec3d normal = normalized(converted<double>(manifolds[0].normal));
  double size = 0;
  for (const auto* face : {&trace.face_a, &trace.face_b})
    for (const Vec3d& corner : *face) size = std::max(size, length(corner - face->front()));
  const double slack = 1e4 * static_cast<double>(std::numeric_limits<T>::epsilon()) *
                       (size + max_abs(trace.face_a[0]) + max_abs(trace.face_b[0]));
  // A's face is cut, unless only B's is an edge.
  const bool b_is_cut = trace.face_b.size() == 2 && trace.face_a.size() > 2;
  const auto& subject = b_is_cut ? trace.face_b : trace.face_a;
  const auto& clip = b_is_cut ? trace.face_a : trace.face_b;
  if (subject.size() > 2) {
    EXPECT_GE(area_of(subject, normal), 0);
  }
  double area = std::abs(area_of(subject, normal));
  for (const TraceCut& cut : trace.cuts) {
    EXPECT_LE(distance_to_corners(cut.from, clip, normal), slack);
    EXPECT_LE(distance_to_corners(cut.to, clip, normal), slack);
    const Vec3d inward = cross(normal, across(cut.to - cut.from, normal));
    for (const Vec3d& left : cut.left) EXPECT_GE(dot(left - cut.from, inward), -slack * size);
    const double rest = std::abs(area_of(cut.left, normal));
    EXPECT_LE(rest, area + slack * size);
    area = rest;
  }
  if (trace.cuts.empty()) return 0;
  EXPECT_LE(trace.cuts.size(), clip.size());
  // Edges that are about parallel are also apart across the normal, by a millionth or so.
  for (const ContactPoint<T>& point : manifolds[0].points)
    EXPECT_LE(distance_to_corners(converted<double>(point.a), trace.cuts.back().left, normal), slack + 1e-5 * size);
  return trace.cuts.size();
}

template <class T>
void expect_cuts_of_all() {
  Random random(5);
  std::size_t cuts = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto kind = [&] { return static_cast<Kind>(random() % bounded_kinds); };
    const Shape<T> a = build<T>(random_specimen(kind(), 1, random)), b = build<T>(random_specimen(kind(), 1, random));
    const Pose<T> pose_a{converted<T>(random_vector(random, 1)), converted<T>(random_rotation(random))};
    Pose<T> pose_b{converted<T>(random_vector(random, 9)), converted<T>(random_rotation(random))};
    const Distance<T> d = distance(a, pose_a, b, pose_b);
    if (d.status != Status::converged) continue;
    // Deep by a little, so that the faces that meet are those of the contacts.
    pose_b.translation = pose_b.translation - d.normal * (d.distance + T(0.01));
    cuts += expect_cuts<T>(a, pose_a, b, pose_b, T(0.02));
  }
  EXPECT_GT(cuts, 50u);
}

TEST(ExplainFaces, CutsOfAnyPairTakeAwayWhatLiesBeyondTheirSide) {
  expect_cuts_of_all<double>();
  expect_cuts_of_all<float>();
}

TEST(ExplainFaces, ABoxThatHangsOverAnothersRimIsCutThere) {
  const Shaped below = Box<double>({2, 1, 2}), above = Box<double>({1, 1, 1});
  Trace trace;
  Manifolds<double> manifolds;
  contacts(below, Posed{}, above, Posed{{0.8, 0.99, 0}, {}}, 0.0, manifolds, &trace);
  ASSERT_EQ(trace.face_a.size(), 4u);
  ASSERT_EQ(trace.face_b.size(), 4u);
  ASSERT_EQ(trace.cuts.size(), 4u);
  for (const TraceCut& cut : trace.cuts) EXPECT_EQ(cut.left.size(), 4u);
  // From 0.3 to the rim of the lower box at 1, on its upper face.
  double low = 1e9, high = -1e9;
  for (const Vec3d& p : trace.cuts.back().left) {
    low = std::min(low, p.x), high = std::max(high, p.x);
    EXPECT_DOUBLE_EQ(p.y, 0.5);
    EXPECT_DOUBLE_EQ(std::abs(p.z), 0.5);
  }
  EXPECT_DOUBLE_EQ(low, 0.3);
  EXPECT_DOUBLE_EQ(high, 1);
  EXPECT_EQ(expect_cuts<double>(below, Posed{}, above, Posed{{0.8, 0.99, 0}, {}}, 0.0), 4u);
}

TEST(ExplainFaces, AnEdgeIsCutByAFaceInEitherOrder) {
  const Shaped capsule = Capsule<double>(2, 0.1), box = Box<double>({1, 1, 1});
  const Posed lying{{0.2, 0.59, 0}, Quatd::from_axis_angle({0, 0, 1}, 1.5707963267948966)};
  EXPECT_EQ(expect_cuts<double>(capsule, lying, box, Posed{}, 0.0), 4u);
  EXPECT_EQ(expect_cuts<double>(box, Posed{}, capsule, lying, 0.0), 4u);
}

TEST(ExplainFaces, NoFacesWhereContactsStandOnNone) {
  Trace trace;
  Manifolds<double> manifolds;
  contacts(Shaped(Sphere<double>(1)), Posed{}, Shaped(Box<double>({1, 1, 1})), Posed{{0, 1.4, 0}, {}}, 0.0, manifolds,
           &trace);
  EXPECT_FALSE(manifolds.empty());
  EXPECT_TRUE(trace.face_a.empty() && trace.face_b.empty() && trace.cuts.empty());
  trace = {};
  contacts(Shaped(HalfSpace<double>{}), Posed{}, Shaped(Box<double>({1, 1, 1})), Posed{{0, 0.4, 0}, {}}, 0.0, manifolds,
           &trace);
  EXPECT_FALSE(manifolds.empty());
  EXPECT_TRUE(trace.face_a.empty() && trace.face_b.empty() && trace.cuts.empty());
}

}  // namespace
}  // namespace graze::testing
