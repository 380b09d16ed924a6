// Contacts and overlaps of boxes and triangles against the naive separating-axis test in extended precision: whether
// they touch, how deep, and points on both surfaces; thin triangles, seen from the side, and far from their origins
// too.
#include <algorithm>
#include <cmath>

#include "common/specimen.hpp"
#include "manifold_of.hpp"
#include "narrow/manifold/features.hpp"
#include "reference/separating_axes.hpp"

namespace graze::testing {
namespace {

using reference::Real;

reference::Polyhedron placed(const reference::Polyhedron& p, const PlacedSpecimen& s) {
  const Quatf& q = s.rotation;
  return moved(p, vector_of(s.translation), {q.x, q.y, q.z, q.w});
}

PlacedSpecimen random_box(float scale, Random& random) {
  PlacedSpecimen s{random_specimen(Kind::box, scale, random), random_vector(random, scale * 0.2f),
                   random_rotation(random)};
  s.specimen.margin = 0;
  return s;
}

/// Every other one is between any and a sliver; every third lies away from its own origin.
PlacedSpecimen random_triangle(int i, float scale, Random& random) {
  PlacedSpecimen s{random_specimen(Kind::triangle, scale, random), random_vector(random, scale * 0.2f),
                   random_rotation(random)};
  s.specimen.margin = 0;
  auto& p = s.specimen.points;
  if (i % 2 == 0) {
    const float thin = std::exp2(-uniform(random, 0, 12));
    p[2] = p[0] + (p[1] - p[0]) * uniform(random, -0.5f, 1.5f) + (p[2] - p[0]) * thin;
  }
  if (i % 3 == 0) {
    const Vec3f away = random_vector(random, 8 * scale);
    for (Vec3f& corner : p) corner += away;
    s.translation -= rotate(normalized(s.rotation), away);
  }
  return s;
}

template <class T>
void check(const PlacedSpecimen& a, const PlacedSpecimen& b, const reference::AxisResult& truth, int& compared) {
  const Shape<T> sa = build<T>(a.specimen), sb = build<T>(b.specimen);
  const Pose<T> pa = pose_of<T>(a), pb = pose_of<T>(b);
  const auto size = static_cast<double>(reference::size(reference_of(a), reference_of(b)));
  const double allowed = (std::is_same_v<T, float> ? 2e-5 : 1e-9) * size;
  Manifolds<T> manifolds;
  const bool touch = contacts(sa, pa, sb, pb, T(0), manifolds);
  const auto depth = static_cast<double>(truth.depth);
  if (std::abs(depth) <= allowed) return;
  ASSERT_EQ(touch, truth.overlap) << describe(a) << "\n" << describe(b);
  ASSERT_EQ(overlap(sa, pa, sb, pb), truth.overlap) << describe(a) << "\n" << describe(b);
  ASSERT_EQ(manifolds.size(), truth.overlap ? 1u : 0u) << describe(a) << "\n" << describe(b);
  if (!touch) return;
  ++compared;
  const Manifold<T>& m = manifolds[0];
  const Vec3d normal = converted<double>(m.normal);
  ASSERT_NEAR(length(normal), 1, 1e-5);
  double nearest = 0;
  for (const auto& p : m.points) {
    nearest = std::min(nearest, static_cast<double>(p.distance));
    ASSERT_LE(length(converted<double>(p.b) - converted<double>(p.a) - normal * static_cast<double>(p.distance)),
              allowed);
    ASSERT_LE(std::abs(static_cast<double>(closest(sa, pa, p.a).distance)), allowed) << describe(a) << describe(b);
    ASSERT_LE(std::abs(static_cast<double>(closest(sb, pb, p.b).distance)), allowed) << describe(a) << describe(b);
  }
  // A face is preferred to what is less deep by up to a two-hundredth of the smaller shape, and points to those nearer
  // by as much.
  ASSERT_NEAR(nearest, -depth, size / 100 + allowed) << describe(a) << "\n" << describe(b);
}

TEST(BoxTriangle, AgreesWithTheNaiveTest) {
  Random random(31);
  int compared = 0;
  for (int i = 0; i < 10000; ++i) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1, 1e2f, 1e4f};
    const float scale = scales[i % 6];
    const PlacedSpecimen a = random_box(scale, random), b = random_triangle(i, scale, random);
    std::vector<reference::Vector> corners;
    for (const Vec3f& p : b.specimen.points) corners.push_back(vector_of(p));
    const auto& half = a.specimen.size;
    const auto truth =
        separating_axes(placed(reference::polyhedron_of_box(vector_of(Vec3f{half[0], half[1], half[2]})), a),
                        placed(reference::polyhedron_of_polygon(corners), b));
    check<double>(a, b, truth, compared);
    check<float>(a, b, truth, compared);
  }
  EXPECT_GT(compared, 5000);
}

// A corner, an edge and the whole of a triangle on the upper side of a box: the names tell which.
TEST(BoxTriangle, NamesWhatTouches) {
  const Shaped box = Box<double>({1, 1, 1});
  const auto features = [&](const Triangle<double>& triangle) {
    std::vector<std::uint32_t> of_triangle;
    for (const auto& p : only_manifold(box, {}, triangle, at(0, 0.5, 0), 0.01).points) {
      EXPECT_EQ(p.feature >> 16, face_feature(3));
      EXPECT_NEAR(p.distance, 0, 1e-12);
      of_triangle.push_back(p.feature & 0xffff);
    }
    std::sort(of_triangle.begin(), of_triangle.end());
    return of_triangle;
  };
  using Features = std::vector<std::uint32_t>;
  EXPECT_EQ(features({{0.1, 0, 0}, {0.4, 0.5, 0}, {-0.4, 0.5, 0}}), (Features{vertex_feature(0)}));
  EXPECT_EQ(features({{0.4, 0, 0}, {0.1, 0.5, 0}, {-0.4, 0, 0}}), (Features{vertex_feature(0), vertex_feature(2)}));
  EXPECT_EQ(features({{0.4, 0, 0}, {0, 0, 0.4}, {-0.4, 0, 0}}),
            (Features{vertex_feature(0), vertex_feature(1), vertex_feature(2)}));
}

}  // namespace
}  // namespace graze::testing
