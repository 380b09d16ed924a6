#include "composite/flat_faces.hpp"

#include "composite/composite.hpp"
#include "composite/internal_edges/face_contact.hpp"
#include "composite/internal_edges/occluders.hpp"
#include "composite/merge_manifolds.hpp"
#include "narrow/pair_table.hpp"
#include "shape/mesh_topology.hpp"

namespace graze {

namespace {

template <class T>
bool is_surface(const Shape<T>& shape) {
  return shape.template as<Mesh<T>>() || shape.template as<HeightField<T>>();
}

template <class T>
bool may_stand(const Shape<T>& shape) {
  return shape.convex() && is_solid(shape);
}

/// Whether a mesh bounds a body, whose front is its outside.
template <class T>
bool is_skin(const Shape<T>& shape) {
  const auto* mesh = shape.template as<Mesh<T>>();
  return mesh && mesh->data().outward;
}

template <class T>
T width_of(const Shape<T>& shape) {
  return max_abs(bounds(shape, Pose<T>{}).extent());
}

/// The half-space whose surface is the plane through `point`, `normal` (unit) leading out of it. That straight up is
/// not turned at all.
template <class T>
Pose<T> half_space_below(const Vec3<T>& normal, const Vec3<T>& point) {
  const bool down = normal.y < T(0);
  const Vec3<T> n = down ? -normal : normal;
  const Quat<T> up_to_n = normalized(Quat<T>{n.z, T(0), -n.x, T(1) + n.y}), flip{T(1), T(0), T(0), T(0)};
  return {point, down ? up_to_n * flip : up_to_n};
}

/// The largest distance of a piece's bounds from a point that lies on it.
template <class T>
T reach_of_pieces(const Shape<T>& whole) {
  if (const auto* mesh = whole.template as<Mesh<T>>()) return reach_on(mesh->data(), T(0));
  if (const auto* compound = whole.template as<Compound<T>>()) return on_piece<T> * T(2) * compound->core_extent();
  return on_piece<T> * max_abs(bounds(whole, Pose<T>{}).extent());
}

/// Whether a convex piece has a face in the plane through `place`, and `place` on it. `noise`: how far it may be off.
template <class T>
bool has_in_face(const LeafInContext<T>& self, bool front_only, const Vec3<T>& normal, const Vec3<T>& place, T noise) {
  const Vec3<T> face = face_along(self, normal);
  if (face == Vec3<T>{} || max_abs(face - normal) > level_sine<T>) return false;
  if (const auto* triangle = front_only ? self.piece.template as<Triangle<T>>() : nullptr)
    if (dot(rotate(self.pose.rotation, face_normal(*triangle)), normal) < T(0)) return false;
  const T size = max_abs(bounds(self.piece, self.pose).extent());
  if (std::abs(dot(furthest(self.piece, self.pose, face) - place, face)) > noise + coordinate_noise(size)) return false;
  return std::abs(distance_to(self, place)) <= on_piece<T> * size + noise;
}

/// The number of a piece of `whole` that has a face in the plane through `place`, and `place` on it.
template <class T>
std::optional<std::uint32_t> piece_below(const Shape<T>& whole, const Pose<T>& pose, const Vec3<T>& normal,
                                         const Vec3<T>& place, T noise) {
  std::optional<std::uint32_t> found;
  const Vec3<T> local = inverse_transform(pose, place);
  const Aabb<T> region = inflated(Aabb<T>{local, local}, reach_of_pieces(whole) + noise);
  const bool front_only = one_sided(whole);
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t number) {
    const bool below = piece.convex() ? has_in_face<T>({whole, pose, piece, at}, front_only, normal, place, noise)
                                      : piece_below(piece, at, normal, place, noise).has_value();
    if (below) found = number;
    return !found;
  };
  visit_pieces(
      whole, pose, region, [] { return T(0); }, look);
  return found;
}

/// The rounding error of coordinates of a body's size.
template <class T>
T size_noise(const Part<T>& body) {
  return coordinate_noise(max_abs(bounds(body.shape, Pose<T>{}).extent()));
}

}  // namespace

template <class T>
FlatFaces<T>::FlatFaces(const Part<T>& a, const Part<T>& b, T margin, bool alone) : alone_(alone), margin_(margin) {
  const auto floor = [](const Shape<T>& one, const Shape<T>& other) {
    if (is_surface(one) && is_surface(other)) return is_skin(other) && width_of(one) >= width_of(other);
    if (is_surface(one)) return may_stand(other) || other.template as<Compound<T>>() != nullptr;
    return one.template as<Compound<T>>() && may_stand(other);
  };
  surface_is_a_ = floor(a.shape, b.shape);
  if (surface_is_a_ || floor(b.shape, a.shape)) surface_ = surface_is_a_ ? &a : &b;
  if (surface_ && is_surface(a.shape) && is_surface(b.shape)) skin_ = surface_is_a_ ? &b : &a;
}

template <class T>
bool FlatFaces<T>::is_level_with(const Face& face, const Vec3<T>& normal, const Vec3<T>& place, T noise) const {
  const Vec3<T> from = place - face.point;
  return max_abs(normal - face.normal) <= level_sine<T> &&
         std::abs(dot(from, face.normal)) <= level_sine<T> * length(from) + noise;
}

template <class T>
bool FlatFaces<T>::passes_over(std::uint32_t triangle, const Corners<T>& corners, const Part<T>& body,
                               bool touching) const {
  if (!knows_faces()) return false;
  bool level = false;
  with_surface(surface_->shape, [&](const auto& surface) { level = surface.lies_level(triangle); });
  if (!level) return false;
  const Vec3<T> across = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Vec3<T> normal = rotate(surface_->pose.rotation, normalized(across, Vec3<T>{}));
  const Vec3<T> place = transform(surface_->pose, corners[0]);
  return std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
    return face.whole && (touching || face.clear) && of_body(face, body) &&
           is_level_with(face, normal, place, place_noise(place) + face.body_noise);
  });
}

template <class T>
bool FlatFaces<T>::passes_over(const Part<T>& a, const Part<T>& b, bool touching) const {
  if (!knows_faces() || !is_surface(surface_->shape)) return false;
  const Part<T>& piece = piece_of(a, b);
  const auto& triangle = *piece.shape.template as<Triangle<T>>();
  return passes_over(piece.number, {triangle.point(0), triangle.point(1), triangle.point(2)}, body_of(a, b), touching);
}

template <class T>
bool FlatFaces<T>::meets_plane(const Face& face, const Part<T>& body, Manifold<T>& manifold) const {
  const Shape<T> below = HalfSpace<T>();
  const Pose<T> pose = half_space_below(face.normal, face.point);
  const Shape<T>&a = surface_is_a_ ? below : body.shape, &b = surface_is_a_ ? body.shape : below;
  const Pose<T>&pose_a = surface_is_a_ ? pose : body.pose, &pose_b = surface_is_a_ ? body.pose : pose;
  if (!skin_) {  // nothing is allocated for one
    convex_contacts<T>(a, pose_a, b, pose_b, margin_, manifold);
    return true;
  }
  Manifolds<T> found;
  any_contacts<T>(a, pose_a, b, pose_b, margin_, found);
  if (found.size() != 1) return false;
  manifold = std::move(found[0]);
  return true;
}

template <class T>
bool FlatFaces<T>::rests_on(const Face& face, const Part<T>& body, Manifold<T>& manifold) const {
  // A body that has been let through is pushed to the other side.
  if (dot(bounds(body.shape, body.pose).center() - face.point, face.normal) <= T(0)) return false;
  if (!meets_plane(face, body, manifold)) return false;
  const auto side = surface_is_a_ ? &ContactPoint<T>::a : &ContactPoint<T>::b;
  std::optional<std::uint32_t> first;
  for (const ContactPoint<T>& point : manifold.points) {
    const Vec3<T>& foot = point.*side;
    const T noise = place_noise(foot) + face.body_noise + level_sine<T> * length(foot - face.point);
    const auto number = piece_below(surface_->shape, surface_->pose, face.normal, foot, noise);
    if (!number) return false;
    if (!first) first = number;
  }
  if (!first) return false;
  (surface_is_a_ ? manifold.piece_a : manifold.piece_b) = *first;
  if (!skin_) (surface_is_a_ ? manifold.piece_b : manifold.piece_a) = body.number;
  return true;
}

template <class T>
typename FlatFaces<T>::Standing FlatFaces<T>::stand(const Part<T>& a, const Part<T>& b, Manifold<T>& manifold) {
  if (!surface_) return Standing::on_piece;
  const Part<T>&piece = piece_of(a, b), &body = body_of(a, b);
  if (!skin_ && !may_stand(body.shape)) return Standing::on_piece;
  const Vec3<T> outward = surface_is_a_ ? manifold.normal : -manifold.normal;
  const LeafInContext<T> leaf{surface_->shape, surface_->pose, piece.shape, piece.pose};
  const Vec3<T> normal = face_along(leaf, outward, standing_lean<T>);
  if (normal == Vec3<T>{}) return Standing::on_piece;
  const Vec3<T> touched = manifold.points[0].*(surface_is_a_ ? &ContactPoint<T>::a : &ContactPoint<T>::b);
  const Vec3<T> place = touched + normal * dot(furthest(piece.shape, piece.pose, normal) - touched, normal);
  for (const Face& face : faces_)
    if (of_body(face, body) && is_level_with(face, normal, place, place_noise(place) + face.body_noise))
      return face.whole ? Standing::on_known_face : Standing::on_piece;
  if (faces_.size() == most) return Standing::on_piece;
  Face face{normal, place, &body.shape, body.pose, size_noise(body)};
  Manifold<T> resting;
  face.whole = rests_on(face, body, resting);
  const T noise = place_noise(place) + face.body_noise;
  face.clear = std::all_of(resting.points.begin(), resting.points.end(),
                           [&](const ContactPoint<T>& point) { return point.distance > noise; });
  faces_.push_back(face);
  if (!face.whole) return Standing::on_piece;
  manifold = resting;
  return Standing::on_face;
}

template class FlatFaces<float>;
template class FlatFaces<double>;

}  // namespace graze
