#include "common/specimen.hpp"

#include <cstdio>

namespace graze::testing {

namespace {

constexpr const char* names[kind_count] = {
    "sphere",         "capsule",   "tapered_capsule", "box",      "rectangle", "cylinder", "cone",
    "truncated_cone", "ellipsoid", "segment",         "triangle", "hull",      "user",     "half_space"};

/// An ellipsoid as a user would write it.
template <class T>
class UserEllipsoid final : public SupportFunction<T> {
 public:
  explicit UserEllipsoid(const Vec3<T>& radii) : radii_(radii) {}
  Vec3<T> support(const Vec3<T>& d) const override {
    const Vec3<T> r = scaled(radii_, d);
    const T l = length(r);
    return l > T(0) ? scaled(radii_, r) / l : Vec3<T>{};
  }

 private:
  Vec3<T> radii_;
};

reference::Vector vector_of(const Vec3f& v) {
  return {static_cast<reference::Real>(v.x), static_cast<reference::Real>(v.y), static_cast<reference::Real>(v.z)};
}

}  // namespace

const char* name_of(Kind kind) { return names[static_cast<int>(kind)]; }

bool curved(Kind kind) {
  switch (kind) {
  case Kind::tapered_capsule:
  case Kind::cylinder:
  case Kind::cone:
  case Kind::truncated_cone:
  case Kind::ellipsoid:
  case Kind::user: return true;
  default: return false;
  }
}

float uniform(Random& random, float low, float high) {
  // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
  return low + (high - low) * static_cast<float>(static_cast<double>(random() >> 11) * 0x1p-53);
}

Vec3f random_vector(Random& random, float reach) {
  const float x = uniform(random, -reach, reach), y = uniform(random, -reach, reach);
  return {x, y, uniform(random, -reach, reach)};
}

Quatf random_rotation(Random& random) {
  for (;;) {
    const Vec3f v = random_vector(random, 1);
    const float w = uniform(random, -1, 1);
    const float l = dot(v, v) + w * w;
    if (l < 0.01f || l > 1) continue;
    return {v.x, v.y, v.z, w};
  }
}

Specimen random_specimen(Kind kind, float scale, Random& random) {
  Specimen s;
  s.kind = kind;
  for (float& size : s.size) size = scale * uniform(random, 0.1f, 1);
  std::size_t points = kind == Kind::segment ? 2 : kind == Kind::triangle ? 3 : 0;
  if (kind == Kind::hull) points = 4 + random() % 29;
  for (std::size_t i = 0; i < points; ++i) s.points.push_back(random_vector(random, scale * 0.7f));
  if (random() % 3 == 0) s.margin = scale * uniform(random, 0, 0.3f);
  return s;
}

Specimen degenerate_specimen(Kind kind, float scale, Random& random) {
  static constexpr float sizes[] = {0, 1e-4f, 0.5f, 1, 1, 2};
  static constexpr float steps[] = {0, 0, 0.5f, 1, 1, -1, -0.5f};
  Specimen s;
  s.kind = kind;
  for (float& size : s.size) size = scale * sizes[random() % 6];
  std::size_t points = kind == Kind::segment ? 2 : kind == Kind::triangle ? 3 : 0;
  if (kind == Kind::hull) points = 1 + random() % 9;
  for (std::size_t i = 0; i < points; ++i)
    s.points.push_back(Vec3f{steps[random() % 7], steps[random() % 7], steps[random() % 7]} * scale);
  if (random() % 4 == 0) s.margin = scale * 0.25f;
  return s;
}

PlacedSpecimen on_lattice(Specimen specimen, float scale, Random& random) {
  static constexpr float steps[] = {0, 0, 0, 0.5f, 1, 1, 2, -1, -0.5f};
  static constexpr float parts[] = {0, 0, 1, -1};
  PlacedSpecimen p{std::move(specimen), {}, {}};
  p.translation = Vec3f{steps[random() % 9], steps[random() % 9], steps[random() % 9]} * scale;
  p.rotation = {parts[random() % 4], parts[random() % 4], parts[random() % 4], parts[random() % 4]};
  if (p.rotation == Quatf{0, 0, 0, 0}) p.rotation = {};
  return p;
}

template <class T>
Shape<T> build(const Specimen& s, T scale) {
  const T a = T(s.size[0]) * scale, b = T(s.size[1]) * scale, c = T(s.size[2]) * scale, margin = T(s.margin) * scale;
  std::vector<Vec3<T>> points;
  for (const Vec3f& p : s.points) points.push_back(converted<T>(p) * scale);
  switch (s.kind) {
  case Kind::sphere: return {Sphere<T>(a), margin};
  case Kind::capsule: return {Capsule<T>(a, b), margin};
  case Kind::tapered_capsule: return {Capsule<T>(a, b, c), margin};
  case Kind::box: return {Box<T>({a, b, c}), margin};
  case Kind::rectangle: return {Rectangle<T>(a, b), margin};
  case Kind::cylinder: return {Cylinder<T>(a, b), margin};
  case Kind::cone: return {Cylinder<T>(a, b, T(0)), margin};
  case Kind::truncated_cone: return {Cylinder<T>(a, b, c), margin};
  case Kind::ellipsoid: return {Ellipsoid<T>({a, b, c}), margin};
  case Kind::segment: return {LineSegment<T>(points[0], points[1]), margin};
  case Kind::triangle: return {Triangle<T>(points[0], points[1], points[2]), margin};
  case Kind::hull: return {ConvexHull<T>(points), margin};
  case Kind::user: return {UserConvex<T>(std::make_shared<UserEllipsoid<T>>(Vec3<T>{a, b, c})), margin};
  default: return {HalfSpace<T>(), margin};
  }
}
template Shape<float> build(const Specimen&, float);
template Shape<double> build(const Specimen&, double);

template <class T>
Pose<T> pose_of(const PlacedSpecimen& p, T scale) {
  return {converted<T>(p.translation) * scale, normalized(converted<T>(p.rotation))};
}
template Pose<float> pose_of(const PlacedSpecimen&, float);
template Pose<double> pose_of(const PlacedSpecimen&, double);

reference::Placed reference_of(const PlacedSpecimen& p) {
  using namespace reference;
  const Specimen& s = p.specimen;
  const Real a(s.size[0]), b(s.size[1]), c(s.size[2]), margin(s.margin);
  std::vector<Vector> points;
  for (const Vec3f& v : s.points) points.push_back(vector_of(v));
  const auto shape = [&]() -> reference::Shape {
    switch (s.kind) {
    case testing::Kind::sphere: return sphere(a + margin);
    case testing::Kind::capsule: return capsule(a, b, b, margin);
    case testing::Kind::tapered_capsule: return capsule(a, b, c, margin);
    case testing::Kind::box: return box({a, b, c}, margin);
    case testing::Kind::rectangle: return box({a, 0, b}, margin);
    case testing::Kind::cylinder: return cylinder(a, b, b, margin);
    case testing::Kind::cone: return cylinder(a, b, 0, margin);
    case testing::Kind::truncated_cone: return cylinder(a, b, c, margin);
    case testing::Kind::ellipsoid:
    case testing::Kind::user: return ellipsoid({a, b, c}, margin);
    case testing::Kind::half_space: return halfspace(margin);
    default: return polytope(points, margin);
    }
  };
  const Quatf& q = p.rotation;
  return place(shape(), vector_of(p.translation),
               {static_cast<Real>(q.x), static_cast<Real>(q.y), static_cast<Real>(q.z), static_cast<Real>(q.w)});
}

std::string describe(const PlacedSpecimen& p) {
  const Specimen& s = p.specimen;
  char text[400];
  std::snprintf(text, sizeof text, "%s sizes %.9g %.9g %.9g margin %.9g at %.9g %.9g %.9g turned %.9g %.9g %.9g %.9g",
                name_of(s.kind), static_cast<double>(s.size[0]), static_cast<double>(s.size[1]),
                static_cast<double>(s.size[2]), static_cast<double>(s.margin), static_cast<double>(p.translation.x),
                static_cast<double>(p.translation.y), static_cast<double>(p.translation.z),
                static_cast<double>(p.rotation.x), static_cast<double>(p.rotation.y), static_cast<double>(p.rotation.z),
                static_cast<double>(p.rotation.w));
  std::string all = text;
  for (const Vec3f& v : s.points) {
    std::snprintf(text, sizeof text, " (%.9g %.9g %.9g)", static_cast<double>(v.x), static_cast<double>(v.y),
                  static_cast<double>(v.z));
    all += text;
  }
  return all;
}

}  // namespace graze::testing
