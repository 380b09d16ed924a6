// What touches a surface of triangles has exactly the surface's contacts: none that is right is lost, none is given
// that is not right.
//
// What is right is told here from the triangles alone, each asked by itself, and from which corners they share: a
// normal is the surface's if it is inside the Voronoi region of the face, edge or corner that it stands on (Mirtich
// 1998, "V-Clip", section 2), which is to say that no triangle around that feature rises above the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "composite/brute_force.hpp"
#include "composite/composite.hpp"
#include "composite/sliding.hpp"
#include "graze/geometry.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::sliders;
using testing::uniform;

/// Sines. What is off a face by less than 2e-4 is laid along it, and half of that leaves a region without being felt:
/// below the first a normal is the face's, up to the second it may be, below the third it is inside a region.
constexpr double surely_same = 1e-4, maybe_same = 4e-4, surely_inside = 1e-5;
/// Places nearer than this are one, in units of the cells: four times what the library takes for lying on a piece of
/// that size; and how far a point may be beside where others span, which a normal turned by the above moves it.
constexpr double same_spot = 4e-4, span_noise = 1e-3;

/// A surface as the test knows it.
template <class T>
struct KnownSurface {
  std::vector<Vec3<T>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> numbers;  ///< by which the library calls the triangles
  Shape<T> shape;

  Vec3d point(std::uint32_t i) const { return converted<double>(points[i]); }
  Vec3d face_normal(std::size_t t) const {
    const auto& [a, b, c] = triangles[t];
    return normalized(cross(point(b) - point(a), point(c) - point(a)));
  }
  Shape<T> piece(std::size_t t) const {
    const auto& [a, b, c] = triangles[t];
    return Triangle<T>(points[a], points[b], points[c]);
  }
};

/// The corners of a triangle that lie furthest along a direction: one of a corner, two of an edge, three of a face.
using FeatureCorners = std::vector<std::uint32_t>;

template <class T>
FeatureCorners corners_along(const KnownSurface<T>& s, std::size_t t, const Vec3d& n, double sine) {
  double most = -std::numeric_limits<double>::infinity(), size = 0;
  const Vec3d origin = s.point(s.triangles[t][0]);
  for (const std::uint32_t c : s.triangles[t]) {
    most = std::max(most, dot(s.point(c) - origin, n));
    size = std::max(size, length(s.point(c) - origin));
  }
  FeatureCorners corners;
  for (const std::uint32_t c : s.triangles[t])
    if (dot(s.point(c) - origin, n) >= most - sine * size) corners.push_back(c);
  return corners;
}

template <class Range>
bool has(const Range& range, std::uint32_t i) {
  return std::find(range.begin(), range.end(), i) != range.end();
}

/// The sine by which what lies around a feature rises highest above the plane through a place on it. `noise`: what the
/// place may be off by, which is no rise.
template <class T>
double rise_around(const KnownSurface<T>& s, const FeatureCorners& feature, const Vec3d& place, const Vec3d& n,
                   double noise = 0) {
  double most = -1;
  for (const auto& triangle : s.triangles) {
    if (!std::all_of(feature.begin(), feature.end(), [&](std::uint32_t c) { return has(triangle, c); })) continue;
    for (const std::uint32_t c : triangle)
      if (!has(feature, c)) most = std::max(most, (dot(s.point(c) - place, n) - noise) / length(s.point(c) - place));
  }
  return most;
}

template <class T>
double away_from(const KnownSurface<T>& s, const FeatureCorners& feature, const Vec3d& place) {
  const auto at = [&](std::size_t i) { return s.point(feature[std::min(i, feature.size() - 1)]); };
  return length(closest_point_on_triangle(at(0), at(1), at(2), place).point - place);
}

/// Whether a place on a feature is at one that bounds it, whose neighbours count there too.
template <class T>
bool at_the_rim(const KnownSurface<T>& s, const FeatureCorners& feature, const Vec3d& place) {
  for (std::size_t i = 0; feature.size() > 1 && i < feature.size(); ++i) {
    const FeatureCorners rim =
        feature.size() == 3 ? FeatureCorners{feature[i], feature[(i + 1) % 3]} : FeatureCorners{feature[i]};
    if (away_from(s, rim, place) < same_spot) return true;
  }
  return false;
}

/// How many contacts were found, by what they stand on.
struct Tally {
  std::size_t poses = 0, corners = 0, edges = 0, faces = 0, unclear = 0;
};

/// A body at a surface, and the answer, as from the surface to the body whichever was asked first.
template <class T>
struct Meeting {
  const KnownSurface<T>& surface;
  const Pose<T>& frame;
  const Shape<T>& body;
  const Pose<T>& pose;
  bool front;  ///< the side of the surface that the body is on
  T margin;
  Manifolds<T> given;

  Meeting(const KnownSurface<T>& s, const Pose<T>& at, const Shape<T>& b, const Pose<T>& p, bool from_front,
          bool swapped)
      : surface(s), frame(at), body(b), pose(p), front(from_front), margin(contact_margin(s.shape, b)) {
    swapped ? contacts(body, pose, surface.shape, frame, margin, given)
            : contacts(surface.shape, frame, body, pose, margin, given);
    if (!swapped) return;
    for (Manifold<T>& m : given) {
      m.normal = -m.normal;
      std::swap(m.piece_a, m.piece_b);
      for (ContactPoint<T>& p2 : m.points) std::swap(p2.a, p2.b);
    }
  }

  Vec3d way(const Vec3<T>& v) const {
    return rotate(conjugate(converted<double>(frame.rotation)), converted<double>(v));
  }
  Vec3d place(const Vec3<T>& p) const {
    return rotate(conjugate(converted<double>(frame.rotation)),
                  converted<double>(p) - converted<double>(frame.translation));
  }
  /// What places of the surface's frame may be off by far from the world's origin.
  double noise() const { return static_cast<double>(coordinate_noise(max_abs(frame.translation))); }
  /// Whether the answer has a manifold of about this normal that spans the point.
  bool has_contact(const Vec3<T>& normal, const ContactPoint<T>& point) const {
    Manifold<T> all;
    all.normal = normal;
    for (const Manifold<T>& m : given)
      if (length(converted<double>(m.normal - normal)) < maybe_same)
        for (const ContactPoint<T>& p : m.points) all.points.push_back(p);
    Random random(1);
    return testing::spanned(point, all, random, static_cast<T>(span_noise));
  }
  std::string text(const Vec3d& n) const {
    std::string all = body.name();
    all.append(" on ").append(surface.shape.name()).append(front ? ", front" : ", back");
    for (const double x : {n.x, n.y, n.z}) all.append(" ").append(std::to_string(x));
    return all;
  }
};

template <class T>
ContactPoint<T> deepest_point(const Manifold<T>& m) {
  return *std::min_element(m.points.begin(), m.points.end(),
                           [](const auto& p, const auto& q) { return p.distance < q.distance; });
}

/// Whether a contact leads to the back of all that meets where it stands, and the surface lies between it and the
/// middle of the body: it is from within, below what is met.
template <class T>
bool is_from_within(const Meeting<T>& meeting, const FeatureCorners& feature, const Vec3d& at, const Vec3d& n) {
  const KnownSurface<T>& s = meeting.surface;
  const Vec3d middle = meeting.place(bounds(meeting.body, meeting.pose).center());
  bool behind = true, covered = false;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto& [a, b, c] = s.triangles[t];
    const Vec3d face = s.face_normal(t) * (meeting.front ? 1.0 : -1.0);
    if (std::all_of(feature.begin(), feature.end(), [&](std::uint32_t i) { return has(s.triangles[t], i); })) {
      behind = behind && dot(face, n) < 0;
      continue;
    }
    const double from = dot(at - s.point(a), face), to = dot(middle - s.point(a), face);
    if (!(from < 0 && to > 0)) continue;
    const Vec3d on = at + (middle - at) * (from / (from - to));
    covered =
        covered || length(closest_point_on_triangle(s.point(a), s.point(b), s.point(c), on).point - on) < same_spot;
  }
  return behind && covered;
}

/// What a triangle by itself has to do with the body is in the answer if it is right. Returns whether it has.
template <class T>
bool expect_kept(const Meeting<T>& meeting, std::size_t t, Tally& tally) {
  const KnownSurface<T>& s = meeting.surface;
  const Shape<T> piece = s.piece(t);
  Manifolds<T> own;
  contacts(piece, meeting.frame, meeting.body, meeting.pose, meeting.margin, own);
  if (own.empty()) return false;
  const Vec3<T> normal = own[0].normal;
  const ContactPoint<T> deepest = deepest_point(own[0]);
  const Vec3d face = s.face_normal(t) * (meeting.front ? 1.0 : -1.0);
  if (length(cross(face, meeting.way(normal))) < maybe_same) {
    if (dot(face, meeting.way(normal)) < 0) return true;  // from within, below another that is met
    const bool clear = length(cross(face, meeting.way(normal))) < surely_same &&
                       !at_the_rim(s, {s.triangles[t].begin(), s.triangles[t].end()}, meeting.place(deepest.a));
    ++(clear ? tally.faces : tally.unclear);
    EXPECT_TRUE(!clear || meeting.has_contact(normal, deepest)) << meeting.text(face);
    return true;
  }
  // A contact may stand on a face of the body that leans over the edge; the least way out does not.
  const Distance<T> least = distance(piece, meeting.frame, meeting.body, meeting.pose);
  const Vec3d n = meeting.way(least.normal), at = meeting.place(least.a);
  const FeatureCorners feature = corners_along(s, t, n, surely_inside);
  const double rise = rise_around(s, feature, at, n);
  if (rise > maybe_same || is_from_within(meeting, feature, at, n)) return true;
  if (rise > surely_inside || feature.size() == 3 || away_from(s, feature, at) > same_spot / 4 ||
      at_the_rim(s, feature, at)) {
    ++tally.unclear;
    return true;
  }
  ++(feature.size() == 1 ? tally.corners : tally.edges);
  EXPECT_TRUE(meeting.has_contact(normal, deepest) ||
              meeting.has_contact(least.normal, {least.a, least.b, least.distance}))
      << meeting.text(n) << ", triangle " << t << " of " << feature.size() << " corners, " << least.distance
      << " apart";
  return true;
}

/// Whether a triangle has a place, and the normal is right there: nothing around the feature that it is of rises.
template <class T>
bool is_right_on(const Meeting<T>& meeting, std::size_t t, const Vec3d& at, const Vec3d& n) {
  const KnownSurface<T>& s = meeting.surface;
  const FeatureCorners feature = corners_along(s, t, n, maybe_same);
  return away_from(s, {s.triangles[t].begin(), s.triangles[t].end()}, at) < same_spot &&
         dot(s.point(feature[0]) - at, n) < same_spot && rise_around(s, feature, at, n, meeting.noise()) < maybe_same;
}

/// A manifold of the answer is right: it stands on a face, or inside a region. Of triangles that share a normal it has
/// the points of all and the number of one.
template <class T>
void expect_right(const Meeting<T>& meeting, const Manifold<T>& m) {
  const KnownSurface<T>& s = meeting.surface;
  const Vec3d n = meeting.way(m.normal), at = meeting.place(deepest_point(m).a);
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (length(cross(s.face_normal(t), n)) < maybe_same) return;
  const auto number = std::find(s.numbers.begin(), s.numbers.end(), m.piece_a);
  ASSERT_NE(number, s.numbers.end());
  const auto named = static_cast<std::size_t>(number - s.numbers.begin());
  const FeatureCorners all(s.triangles[named].begin(), s.triangles[named].end());
  bool right = false;
  if (away_from(s, all, at) < same_spot)
    right = is_right_on(meeting, named, at, n);
  else
    for (std::size_t t = 0; t < s.triangles.size() && !right; ++t) right = is_right_on(meeting, t, at, n);
  EXPECT_TRUE(right) << meeting.text(n) << ", triangle " << named;
}

template <class T>
void expect_the_surfaces_contacts(const Meeting<T>& meeting, Tally& tally) {
  ++tally.poses;
  bool touched = false;
  for (std::size_t t = 0; t < meeting.surface.triangles.size(); ++t)
    touched = expect_kept(meeting, t, tally) || touched;
  EXPECT_EQ(meeting.given.empty(), !touched) << meeting.body.name();
  for (const Manifold<T>& m : meeting.given) expect_right(meeting, m);
}

/// Bodies from above or below, or with `around` from anywhere outside, moved until they touch and then a little in.
template <class T>
void drop_bodies(const KnownSurface<T>& s, bool around, bool far, int count, Random& random, Tally& tally) {
  const T away = !far ? T(0) : std::is_same_v<T, float> ? T(30) : T(1e5);
  const Quat<T> turned = normalized(converted<T>(testing::random_rotation(random)));
  const Pose<T> frame{{away, away, -away}, far ? turned : Quat<T>{}};
  for (const Shape<T>& body : sliders<T>(random))
    for (int i = 0; i < count; ++i) {
      const bool front = around || i % 3 != 0;
      Vec3<T> from = converted<T>(testing::random_vector(random, 2));
      from.y = front ? T(4) : T(-4);
      Vec3<T> down{0, front ? T(-1) : T(1), 0};
      if (around) {
        down = normalized(converted<T>(testing::random_vector(random, 1)));
        from = down * T(-6);
      }
      Pose<T> pose = compose(frame, Pose<T>{from, normalized(converted<T>(testing::random_rotation(random)))});
      const Vec3<T> along = rotate(frame.rotation, down);
      T apart(1);
      for (int step = 0; step < 40 && apart > T(1e-3); ++step) {
        apart = std::numeric_limits<T>::max();
        for (std::size_t t = 0; t < s.triangles.size(); ++t)
          apart = std::min(apart, distance(s.piece(t), frame, body, pose).distance);
        pose.translation += along * apart;
      }
      if (apart > T(0.01)) continue;  // through a hole
      pose.translation += along * static_cast<T>(uniform(random, 0, i % 4 == 0 ? 0.1f : 0.02f));
      expect_the_surfaces_contacts(Meeting<T>(s, frame, body, pose, front, i % 2 == 0), tally);
    }
}

constexpr std::uint32_t cells = 6;

/// The triangles of a grid of cells, each cut along one of its diagonals.
template <class T, class Cut>
KnownSurface<T> grid_of(const std::vector<T>& heights, const Cut& cut) {
  KnownSurface<T> s{{}, {}, {}, Shape<T>(Sphere<T>(T(0)))};
  for (std::uint32_t i = 0; i < heights.size(); ++i)
    s.points.push_back({T(i % (cells + 1)) - T(cells) / 2, heights[i], T(i / (cells + 1)) - T(cells) / 2});
  for (std::uint32_t i = 0; i < cells * cells; ++i) {
    const std::uint32_t a = i / cells * (cells + 1) + i % cells, b = a + 1, c = a + cells + 1, d = c + 1;
    const int way = cut(a, b, c, d);
    if (way < 0) continue;
    s.numbers.insert(s.numbers.end(), {2 * i, 2 * i + 1});
    if (way == 0)
      s.triangles.insert(s.triangles.end(), {{a, d, b}, {a, c, d}});
    else
      s.triangles.insert(s.triangles.end(), {{a, c, b}, {b, c, d}});
  }
  return s;
}

template <class T>
std::vector<T> rough_heights(Random& random, float height) {
  std::vector<T> heights((cells + 1) * (cells + 1));
  for (T& h : heights) h = static_cast<T>(uniform(random, -height, height));
  return heights;
}

template <class T>
KnownSurface<T> rough_sheet(Random& random, float height) {
  KnownSurface<T> s = grid_of<T>(rough_heights<T>(random, height), [&](auto...) { return random() % 2 == 0 ? 0 : 1; });
  for (std::uint32_t i = 0; i < s.numbers.size(); ++i) s.numbers[i] = i;
  s.shape = Mesh<T>(s.points, s.triangles);
  return s;
}

/// One height in twelve is a hole.
template <class T>
KnownSurface<T> rough_height_field(Random& random, float height) {
  const std::vector<T> heights = rough_heights<T>(random, height);
  std::vector<std::uint8_t> holes;
  for (std::size_t i = 0; i < heights.size(); ++i) holes.push_back(random() % 12 == 0 ? 1 : 0);
  KnownSurface<T> s = grid_of<T>(heights, [&](auto... corners) { return ((holes[corners] != 0) || ...) ? -1 : 0; });
  s.shape = HeightField<T>(cells + 1, cells + 1, heights, std::span<const std::uint8_t>(holes));
  return s;
}

/// An octahedron whose faces are cut in four twice, its corners about two from the middle.
template <class T>
KnownSurface<T> rough_ball(Random& random, float height) {
  KnownSurface<T> s{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}, {}, Shape<T>(Sphere<T>(T(0)))};
  s.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int cut = 0; cut < 2; ++cut) {
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const Vec3<T> p = normalized(s.points[a] + s.points[b]);
      const auto at =
          std::find_if(s.points.begin(), s.points.end(), [&](const auto& q) { return length(q - p) < T(1e-3); });
      const auto i = static_cast<std::uint32_t>(at - s.points.begin());
      if (at == s.points.end()) s.points.push_back(p);
      return i;
    };
    const auto whole = std::move(s.triangles);
    s.triangles.clear();
    for (const auto& [a, b, c] : whole) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      s.triangles.insert(s.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }
  for (Vec3<T>& p : s.points) p *= static_cast<T>(uniform(random, 2 - height, 2 + height));
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) s.numbers.push_back(i);
  s.shape = Mesh<T>(s.points, s.triangles);
  return s;
}

template <class T>
class KeptContacts : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(KeptContacts, Scalars);

/// How often a test goes over its surfaces, each time over others; once is some 1,300 poses.
int rounds() {
  const char* asked = std::getenv("GRAZE_TEST_ROUNDS");
  return asked ? std::atoi(asked) : 2;
}

/// There were enough of each kind, and of hardly any it could not be told.
void expect_plenty(const Tally& tally) {
  EXPECT_GT(tally.poses, 1000u);
  EXPECT_GT(tally.corners, 100u);
  EXPECT_GT(tally.edges, 600u);
  EXPECT_GT(tally.faces, 600u);
  EXPECT_LT(tally.unclear * 10, tally.corners + tally.edges + tally.faces);
}

TYPED_TEST(KeptContacts, OfRoughSheets) {
  using T = TypeParam;
  Random random(31);
  Tally tally;
  for (const float height : {0.05f, 0.3f, 0.8f})
    for (const bool far : {false, true})
      for (int sheet = 0; sheet < 3 * rounds(); ++sheet)
        drop_bodies(rough_sheet<T>(random, height), false, far, 12, random, tally);
  expect_plenty(tally);
}

TYPED_TEST(KeptContacts, OfHeightFieldsWithHoles) {
  using T = TypeParam;
  Random random(32);
  Tally tally;
  for (const float height : {0.05f, 0.3f, 0.8f})
    for (const bool far : {false, true})
      for (int field = 0; field < 3 * rounds(); ++field)
        drop_bodies(rough_height_field<T>(random, height), false, far, 12, random, tally);
  expect_plenty(tally);
}

TYPED_TEST(KeptContacts, OfRoughBalls) {
  using T = TypeParam;
  Random random(33);
  Tally tally;
  for (const float height : {0.0f, 0.1f, 0.4f})
    for (const bool far : {false, true})
      for (int ball = 0; ball < 3 * rounds(); ++ball)
        drop_bodies(rough_ball<T>(random, height), true, far, 12, random, tally);
  expect_plenty(tally);
}

}  // namespace
}  // namespace graze
