// The manifold of two convex shapes: their distance gives the normal, their support faces the points.
#include <algorithm>

#include "narrow/convex_pair.hpp"
#include "narrow/general.hpp"
#include "narrow/manifold.hpp"
#include "narrow/minkowski.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// How much deeper the normal of a face may be than the least depth and still be chosen, relative to the smaller
/// shape. A resting box of size 1 leans by milliradians and sinks in by millimetres; the least depth then changes
/// between faces and edges from frame to frame, and a solver needs the face. It is no part of the decision whether
/// shapes overlap, and every point carries its true distance along the chosen normal.
constexpr double face_preference = 1.0 / 200;

/// One of the two shapes, seen from the frame of A.
template <class T>
class Side {
 public:
  Side(const Shape<T>& shape, const Posed& pose) : shape_(shape), pose_(pose) {
    shape.visit([&](const auto& c) {
      radius_ = static_cast<double>(rounding_radius(c, shape.margin()));
      size_ = static_cast<double>(c.core_extent()) + radius_;
    });
  }

  double radius() const { return radius_; }
  double size() const { return size_; }

  Vec3d core_support(const Vec3d& direction) const {
    return transform(pose_, ShapeCore<T>(shape_).core_support(rotate(conjugate(pose_.rotation), direction)));
  }
  PlacedFace face(const Vec3d& direction) const {
    Face<T> face;
    shape_.visit([&](const auto& c) {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
        c.core_face(cast<T>(rotate(conjugate(pose_.rotation), direction)), face);
    });
    PlacedFace placed;
    placed.id = face.id;
    for (const Vec3<T>& v : face.vertices) placed.vertices.push_back(transform(pose_, cast<double>(v)));
    for (const std::uint32_t id : face.ids) placed.ids.push_back(id);
    return placed;
  }

 private:
  const Shape<T>& shape_;
  Posed pose_;
  double radius_ = 0, size_ = 0;
};

template <class T>
double separation(const Side<T>& a, const Side<T>& b, const Vec3d& normal) {
  return dot(b.core_support(-normal) - a.core_support(normal), normal) - a.radius() - b.radius();
}

/// The normal of one of the two support faces if it is about as good as the least depth's, else that one.
template <class T>
Vec3d preferred_normal(const Side<T>& a, const Side<T>& b, const Vec3d& normal, double distance) {
  Vec3d best = normal;
  double most = distance - face_preference * least(a.size(), b.size());
  for (const Vec3d& candidate : {polygon_normal(a.face(normal)), -polygon_normal(b.face(-normal))}) {
    if (candidate == Vec3d{}) continue;
    const double along = separation(a, b, candidate);
    if (along < most) continue;
    most = along;
    best = candidate;
  }
  return best;
}

/// What is left to the closest points: a vertex, crossing edges, or faces that do not lie over each other.
template <class T>
std::uint32_t closest_feature(const Side<T>& a, const Side<T>& b, const Vec3d& normal) {
  const auto name = [](const PlacedFace& f) {
    if (f.vertices.size() == 1) return vertex_feature(f.ids[0]);
    return f.vertices.size() == 2 ? edge_feature(f.ids[0], f.ids[1]) : face_feature(f.id);
  };
  return feature_id(name(a.face(normal)), name(b.face(-normal)));
}

/// Where between a and b the solver's point lies: for two balls in the ratio of their radii, else in the middle.
template <class T>
T position_weight(const Shape<T>& a, const Shape<T>& b) {
  const auto *sa = a.template as<Sphere<T>>(), *sb = b.template as<Sphere<T>>();
  if (!sa || !sb) return T(0.5);
  const T ra = sa->radius() + a.margin(), rb = sb->radius() + b.margin();
  return ra + rb > T(0) ? ra / (ra + rb) : T(0.5);
}

/// The points of a bounded pair. Distances are measured before the points are rounded to T and to the world.
template <class T>
void bounded_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                      const Distance<T>& d, Manifold<T>& manifold) {
  const Posed frame = in_double(pose_a);
  const Side<T> side_a(a, Posed{}), side_b(b, relative_in_double(pose_a, pose_b));
  const Vec3d closest_normal = normalized(rotate(conjugate(frame.rotation), cast<double>(d.normal)));
  const double distance = static_cast<double>(d.distance);
  const Vec3d normal = preferred_normal(side_a, side_b, closest_normal, distance);

  FaceContacts faces;
  lay_over(side_a.face(normal), side_b.face(-normal), normal, faces);
  // What lies as near as the nearest point up to rounding is kept with it, so that touching faces touch whole.
  const double reach = side_a.size() + side_b.size() + std::abs(distance);
  const double limit = greatest(static_cast<double>(margin), distance + rounding * reach);
  double nearest = std::numeric_limits<double>::infinity();
  for (const FaceContact& c : faces) {
    const double apart = dot(c.b - c.a, normal) - side_a.radius() - side_b.radius();
    nearest = std::min(nearest, apart);
    if (apart > limit) continue;
    const Vec3d on_a = c.a + normal * side_a.radius(), on_b = on_a + normal * apart;
    manifold.points.push_back(
        {cast<T>(transform(frame, on_a)), cast<T>(transform(frame, on_b)), static_cast<T>(apart), c.feature});
  }
  manifold.normal = cast<T>(rotate(frame.rotation, normal));
  // Faces that miss what is nearest serve worse than the closest points.
  if (nearest <= distance + face_preference * least(side_a.size(), side_b.size()) && !manifold.points.empty()) return;
  manifold.points.clear();
  manifold.normal = d.normal;
  const std::uint32_t feature = closest_feature(side_a, side_b, closest_normal);
  manifold.points.push_back({d.a, d.b, d.distance, feature, position_weight(a, b)});
}

/// The support face of a body that lies on a half-space: each vertex with its own height.
template <class T>
void rest_on_half_space(const Shape<T>& plane, const Pose<T>& plane_pose, const Shape<T>& body, const Pose<T>& pose,
                        T margin, Manifold<T>& manifold) {
  const Posed frame = in_double(plane_pose);
  const Side<T> side(body, relative_in_double(plane_pose, pose));
  const Vec3d up{0, 1, 0};
  const double lift = static_cast<double>(plane.margin());
  const PlacedFace face = side.face(-up);
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    const Vec3d low = face.vertices[i] - up * side.radius();
    const double apart = low.y - lift;
    if (apart > static_cast<double>(margin)) continue;
    manifold.points.push_back({cast<T>(transform(frame, Vec3d{low.x, lift, low.z})), cast<T>(transform(frame, low)),
                               static_cast<T>(apart), feature_id(face_feature(0), vertex_feature(face.ids[i]))});
  }
  manifold.normal = cast<T>(rotate(frame.rotation, up));
}

template <class T>
void mirror(Manifold<T>& manifold) {
  manifold.normal = -manifold.normal;
  for (ContactPoint<T>& p : manifold.points) {
    std::swap(p.a, p.b);
    p.feature = (p.feature << 16) | (p.feature >> 16);
  }
}

}  // namespace

template <class T>
Distance<T> convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            T margin, Manifold<T>& manifold, Trace* trace) {
  const Distance<T> d = convex_distance(a, pose_a, b, pose_b, trace);
  if (d.status == Status::unbounded || !(d.distance <= margin)) return d;
  const bool half_a = a.template as<HalfSpace<T>>() != nullptr, half_b = b.template as<HalfSpace<T>>() != nullptr;
  if (half_a && half_b) {
    manifold.normal = d.normal;
    manifold.points.push_back({d.a, d.b, d.distance, feature_id(face_feature(0), face_feature(0))});
  } else if (half_a) {
    rest_on_half_space(a, pose_a, b, pose_b, margin, manifold);
  } else if (half_b) {
    rest_on_half_space(b, pose_b, a, pose_a, margin, manifold);
    mirror(manifold);
  } else {
    bounded_contacts(a, pose_a, b, pose_b, margin, d, manifold);
  }
  return d;
}

template Distance<float> convex_contacts(const Shape<float>&, const Pose<float>&, const Shape<float>&,
                                         const Pose<float>&, float, Manifold<float>&, Trace*);
template Distance<double> convex_contacts(const Shape<double>&, const Pose<double>&, const Shape<double>&,
                                          const Pose<double>&, double, Manifold<double>&, Trace*);

}  // namespace graze
