// The general path to the manifold of two convex shapes: the normal from their distance, the points from their support
// faces. Special pairs are in pair_contacts.cpp.
#include <algorithm>

#include "narrow/core/core.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/general.hpp"
#include "narrow/general_contacts.hpp"
#include "narrow/manifold/add_point.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/contact_side.hpp"
#include "narrow/manifold/polygon.hpp"
#include "narrow/manifold/rounded_face.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"
#include "narrow/sat/polyhedral_pair.hpp"
#include "narrow/sat/reference_axis.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// The smaller radius of the two shapes about their own origins.
template <class T>
double smaller_size(const Side<T>& a, const Side<T>& b) {
  return least(a.size(), b.size());
}

/// Distance beside the generator of a cylinder's side within which a place counts as on the side, like `on_surface` for
/// an edge. The side is round across its generator: a place beside that by this much is off the side by half its
/// square. A depth is right to ten digits and its normal, which determines the generator, to five.
constexpr double on_side = 2e-5;

/// The points on the two surfaces over a place where the cores' faces meet, one straight above the other. Two edges
/// that are not quite parallel are also apart across the normal: the gap is shared in the ratio of the radii, so that
/// both points lie on their rounded edges. False when the edges are too sharp for that.
template <class T>
bool on_surfaces(const FaceContact& c, const Side<T>& a, const RoundedFace& face_a, const Side<T>& b,
                 const RoundedFace& face_b, const Vec3d& normal, Vec3d& on_a, Vec3d& on_b) {
  const double apart = dot(c.b - c.a, normal), radii = a.radius() + b.radius();
  const Vec3d across = c.b - c.a - normal * apart;
  on_a = c.a;
  Vec3d from_b = c.b;
  const double beside = length_squared(across), smaller = smaller_size(a, b);
  const auto beside_by_more = [&](double share) { return beside > share * smaller * (share * smaller); };
  if (beside_by_more(on_surface)) {
    if (!(radii > 0) && !((a.round_side() || b.round_side()) && !beside_by_more(on_side))) return false;
    const double share = radii > 0 ? a.radius() / radii : a.round_side() ? 1 : 0;
    on_a += across * share;
    from_b -= across * (1 - share);
  }
  double rises = 0;
  if (a.radius() > 0) {
    const auto rise = a.rise(face_a, on_a, normal);
    if (!rise) return false;
    on_a += normal * *rise;
    rises = *rise;
  }
  if (b.radius() > 0) {
    const auto rise = b.rise(face_b, from_b, -normal);
    if (!rise) return false;
    rises += *rise;
  }
  on_b = on_a + normal * (apart - rises);
  return true;
}

/// Appends to the manifold the points of two faces clipped by each other that are at most `limit` apart. Distances are
/// measured before the points are rounded to T and to the world. Returns the smallest of all.
template <class T>
double add_points(const Side<T>& a, const PlacedFace& face_a, const Side<T>& b, const PlacedFace& face_b,
                  const Vec3d& normal, double limit, const Posed& frame, Manifold<T>& manifold) {
  FaceContacts faces;
  clip_faces(face_a, face_b, normal, normal_rounding<T> * (a.radius() + b.radius() + smaller_size(a, b)), faces);
  const RoundedFace rounded_a(face_a, normal, a.radius()), rounded_b(face_b, -normal, b.radius());
  const T most_merged = tolerance<T> * static_cast<T>(smaller_size(a, b));
  const Mat3d turn = rotation_matrix(frame.rotation);
  const auto in_world = [&](const Vec3d& p) { return converted<T>(turn * p + frame.translation); };
  double nearest = std::numeric_limits<double>::infinity();
  for (const FaceContact& c : faces) {
    Vec3d on_a, on_b;
    if (!on_surfaces(c, a, rounded_a, b, rounded_b, normal, on_a, on_b)) continue;
    const double apart = dot(on_b - on_a, normal);
    nearest = std::min(nearest, apart);
    if (apart > limit) continue;
    add_point<T>({in_world(on_a), in_world(on_b), static_cast<T>(apart), c.feature}, most_merged, manifold);
  }
  manifold.normal = converted<T>(turn * normal);
  return nearest;
}

/// The largest distance of points to keep: those level with the nearest up to rounding are kept with it, so that
/// touching faces touch whole.
template <class T>
double furthest_kept(const Side<T>& a, const Side<T>& b, T margin, double distance) {
  return greatest(static_cast<double>(margin), distance + rounding_error * (a.size() + b.size() + std::abs(distance)));
}

/// Whether two directions have the same support face, being equal in the shapes' scalar but for some roundings, far
/// fewer than those within which a vertex counts as level with another.
template <class T>
bool same_direction(const Vec3d& one, const Vec3d& other) {
  return max_abs(one - other) <= 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
}

/// The normal of one of the two support faces if it is about as good as that of least depth, else the latter. A face
/// whose normal is that of least depth already, as is common for polyhedra, is best. A face of a flat-sided shape, in
/// front of which no vertex lies, needs no support query of its own.
template <class T>
Vec3d preferred_normal(const Side<T>& a, const PlacedFace& face_a, const Side<T>& b, const PlacedFace& face_b,
                       const Vec3d& normal, double distance) {
  PreferredNormal<double> preferred(distance, normal, smaller_size(a, b));
  const auto highest = [](const Side<T>& side, const PlacedFace& face, const Vec3d& outward) {
    return side.flat_sided() ? face.vertices[0] : side.core_support(outward);
  };
  const auto consider = [&](const Vec3d& candidate, const Vec3d& on_a, const Vec3d& on_b) {
    preferred.consider(true, candidate, dot(on_b - on_a, candidate) - a.radius() - b.radius());
  };
  const Vec3d of_a = polygon_normal(face_a), of_b = polygon_normal(face_b);
  if (same_direction<T>(of_a, normal)) return of_a;
  if (same_direction<T>(of_b, -normal)) return -of_b;
  if (of_a != Vec3d{}) consider(of_a, highest(a, face_a, of_a), b.core_support(-of_a));
  if (of_b != Vec3d{}) consider(-of_b, a.core_support(-of_b), highest(b, face_b, of_b));
  return preferred.best;
}

/// The face of a side along `outward` when `known` is its face along a nearby direction: the same where that is the
/// face's own normal, or the directions are the same; else another, written to `other`.
template <class T>
const PlacedFace& face_again(const Side<T>& side, const PlacedFace& known, bool same, const Vec3d& outward,
                             PlacedFace& other) {
  if (same || (side.flat_sided() && same_direction<T>(polygon_normal(known), outward))) return known;
  return other = side.face(outward, true);
}

/// Position of the solver's point between a and b: for two balls in the ratio of their radii, else the middle.
template <class T>
T position_weight(const Shape<T>& a, const Shape<T>& b) {
  const auto *sa = a.template as<Sphere<T>>(), *sb = b.template as<Sphere<T>>();
  if (!sa || !sb) return T(0.5);
  const T ra = sa->radius() + a.rounding(), rb = sb->radius() + b.rounding();
  return ra + rb > T(0) ? ra / (ra + rb) : T(0.5);
}

/// The points of a bounded pair whose closest points are known.
template <class T>
void bounded_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                      const Distance<T>& d, Manifold<T>& manifold) {
  const Posed frame = in_double(pose_a);
  const Side<T> side_a(a, Posed{}), side_b(b, relative_in_double(pose_a, pose_b));
  const Vec3d closest_normal = unit(rotate(conjugate(frame.rotation), converted<double>(d.normal)));
  const auto distance = static_cast<double>(d.distance);
  const PlacedFace closest_a = side_a.face(closest_normal, true), closest_b = side_b.face(-closest_normal, true);
  if (closest_a.vertices.size() > 1 && closest_b.vertices.size() > 1) {
    const Vec3d normal = preferred_normal(side_a, closest_a, side_b, closest_b, closest_normal, distance);
    const bool same = same_direction<T>(normal, closest_normal);
    const double limit = furthest_kept(side_a, side_b, margin, distance);
    PlacedFace other_a, other_b;
    double nearest = add_points(side_a, face_again(side_a, closest_a, same, normal, other_a), side_b,
                                face_again(side_b, closest_b, same, -normal, other_b), normal, limit, frame, manifold);
    if (manifold.points.empty() && (side_a.round_side() || side_b.round_side())) {
      // A generator along the edge of a side, beside the side by less than the error of the normal, still meets that
      // edge.
      const PlacedFace edge_a = side_a.face(normal), edge_b = side_b.face(-normal);
      if (edge_a.vertices.size() == 2 && edge_b.vertices.size() == 2)
        nearest = add_points(side_a, edge_a, side_b, edge_b, normal, limit, frame, manifold);
    }
    // Faces away from the nearest points serve worse than the closest points.
    if (nearest <= distance + face_preference * smaller_size(side_a, side_b) && !manifold.points.empty()) return;
    manifold.points.clear();
  }
  const std::uint32_t feature = feature_at(closest_a, inverse_transform(frame, converted<double>(d.a)), closest_b,
                                           inverse_transform(frame, converted<double>(d.b)), closest_normal);
  manifold.normal = d.normal;
  manifold.points.push_back({d.a, d.b, d.distance, feature, position_weight(a, b)});
}

/// The points of faces that meet along an axis; false, without points, where the nearest points are not on these faces.
template <class T>
bool lay_faces(const Side<T>& a, const Side<T>& b, const MeetingFaces& faces, T margin, const Posed& frame,
               Manifold<T>& manifold) {
  const double nearest =
      add_points(a, faces.a, b, faces.b, faces.normal, furthest_kept(a, b, margin, faces.distance), frame, manifold);
  const double allowed = faces.apart ? laid_slack * faces.noise : face_preference * smaller_size(a, b);
  if (nearest <= faces.distance + allowed && !manifold.points.empty() && (!faces.apart || faces.best)) return true;
  manifold.points.clear();
  return false;
}

/// The face of a body on a half-space that leans least from it, each vertex with its own height.
template <class T>
void rest_on_half_space(const Shape<T>& plane, const Pose<T>& plane_pose, const Shape<T>& body, const Pose<T>& pose,
                        T margin, Manifold<T>& manifold) {
  const Posed frame = in_double(plane_pose);
  const Side<T> side(body, relative_in_double(plane_pose, pose));
  const Vec3d up{0, 1, 0};
  const auto lift = static_cast<double>(plane.rounding());
  const PlacedFace face = side.face_on_plane(-up);
  const RoundedFace rounded(face, -up, side.radius());
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    const double rise = side.radius() > 0 ? side.rise(rounded, face.vertices[i], -up).value_or(side.radius()) : 0;
    const Vec3d low = face.vertices[i] - up * rise;
    const double apart = low.y - lift;
    if (apart > static_cast<double>(margin)) continue;
    add_point<T>({converted<T>(transform(frame, Vec3d{low.x, lift, low.z})), converted<T>(transform(frame, low)),
                  static_cast<T>(apart), feature_id(face_feature(0), vertex_feature(face.ids[i]))},
                 tolerance<T> * static_cast<T>(side.size()), manifold);
  }
  manifold.normal = converted<T>(rotate(frame.rotation, up));
}

}  // namespace

template <class T>
std::optional<T> polyhedral_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                     T margin, Manifold<T>& manifold) {
  const Posed frame = in_double(pose_a), b_in_a = relative(frame, in_double(pose_b));
  const Side<T> side_a(a, Posed{}), side_b(b, b_in_a);
  const double noise =
      rounding_error * (greatest(side_a.size(), side_b.size()) + max_abs(b_in_a.translation));  // `noise_of`
  const PolyhedralPair pair(a, b, b_in_a);
  const double radii = side_a.radius() + side_b.radius();
  const auto found = pair.axes(static_cast<double>(margin) + radii + noise);
  if (!found) return std::nullopt;
  const SeparatingAxes& axes = *found;
  const SeparatingAxis& best = axes.best(noise);
  const double signed_distance = best.separation - radii;
  const double distance = std::abs(signed_distance) <= noise ? 0 : signed_distance;
  if (distance > static_cast<double>(margin)) {
    manifold.normal = converted<T>(rotate(frame.rotation, best.normal));
    return static_cast<T>(distance);
  }

  const SeparatingAxis& axis = reference_axis(axes, smaller_size(side_a, side_b));
  const MeetingFaces faces{axis.normal,
                           pair.face_a(side_a, axis.normal),
                           pair.face_b(side_b, axis.normal),
                           &axis == &best,
                           distance,
                           best.separation > noise,
                           noise};
  if (!lay_faces(side_a, side_b, faces, margin, frame, manifold)) return std::nullopt;
  return static_cast<T>(distance);
}

template <class T>
T general_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                   Manifold<T>& manifold) {
  const bool asked_as_boxes = plain_box(a) && plain_box(b);
  if (!asked_as_boxes && has_separating_axes(a, b))
    if (const auto distance = polyhedral_contacts(a, pose_a, b, pose_b, margin, manifold)) return *distance;
  const Distance<T> d = ordered_distance(a, pose_a, b, pose_b, margin);
  manifold.normal = d.normal;
  if (d.status == Status::unbounded || !(d.distance <= margin)) return d.distance;
  if (d.status == Status::bounded) {
    manifold.status = d.status;
    manifold.error = d.error;
  }
  const bool half_a = a.template as<HalfSpace<T>>() != nullptr, half_b = b.template as<HalfSpace<T>>() != nullptr;
  if (half_a && half_b) {
    manifold.normal = d.normal;
    manifold.points.push_back({d.a, d.b, d.distance, feature_id(face_feature(0), face_feature(0))});
  } else if (half_b) {
    rest_on_half_space(b, pose_b, a, pose_a, margin, manifold);
    mirror(manifold);
  } else {
    bounded_contacts(a, pose_a, b, pose_b, margin, d, manifold);
  }
  return d.distance;
}

template <class T>
void contacts_of_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                       const MeetingFaces& faces, const Distance<T>& d, Manifold<T>& manifold) {
  const Side<T> side_a(a, Posed{}), side_b(b, relative_in_double(pose_a, pose_b));
  if (!lay_faces(side_a, side_b, faces, margin, in_double(pose_a), manifold))
    bounded_contacts(a, pose_a, b, pose_b, margin, d, manifold);
}

template <class T>
void contacts_along(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, T margin, Manifold<T>& manifold) {
  if (against_order(a, b)) {
    contacts_along(b, pose_b, a, pose_a, -normal, margin, manifold);
    mirror(manifold);
    return;
  }
  if (a.template as<Sphere<T>>()) {  // no face to be clipped
    manifold.normal = normal;
    return;
  }
  const Posed frame = in_double(pose_a);
  const Side<T> side_a(a, Posed{}), side_b(b, relative_in_double(pose_a, pose_b));
  const Vec3d n = normalized(rotate(conjugate(frame.rotation), converted<double>(normal)));
  add_points(side_a, side_a.face(n, true), side_b, side_b.face(-n, true), n, static_cast<double>(margin), frame,
             manifold);
  manifold.normal = normal;
}

template void contacts_along(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&,
                             const Vec3<float>&, float, Manifold<float>&);
template void contacts_along(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                             const Vec3<double>&, double, Manifold<double>&);
template void contacts_of_faces(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&, float,
                                const MeetingFaces&, const Distance<float>&, Manifold<float>&);
template void contacts_of_faces(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                                double, const MeetingFaces&, const Distance<double>&, Manifold<double>&);
template float general_contacts(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&, float,
                                Manifold<float>&);
template double general_contacts(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                                 double, Manifold<double>&);
template std::optional<float> polyhedral_contacts(const Shape<float>&, const Pose<float>&, const Shape<float>&,
                                                  const Pose<float>&, float, Manifold<float>&);
template std::optional<double> polyhedral_contacts(const Shape<double>&, const Pose<double>&, const Shape<double>&,
                                                   const Pose<double>&, double, Manifold<double>&);

}  // namespace graze
