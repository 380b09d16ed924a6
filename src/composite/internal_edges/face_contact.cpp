#include "composite/internal_edges/face_contact.hpp"

#include "composite/merge_manifolds.hpp"

namespace graze {

template <class T>
Vec3<T> face_along(const LeafInContext<T>& self, const Vec3<T>& outward, T lean) {
  Vec3<T> face{};
  const Vec3<T> local = rotate(conjugate(self.pose.rotation), outward);
  if (const auto* triangle = self.piece.template as<Triangle<T>>()) {
    face = face_normal(*triangle);
    if (dot(face, local) < T(0)) face = -face;
  } else if (self.piece.template as<Box<T>>()) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::abs(local[axis]) >= max_abs(local)) {
        face = {};
        face[axis] = local[axis] < T(0) ? T(-1) : T(1);
      }
  }
  if (face == Vec3<T>{} || length(cross(face, local)) > lean) return {};
  return rotate(self.pose.rotation, face);
}

template <class T>
bool stands_clear(const LeafInContext<T>& self, const LeafInContext<T>& other, const Vec3<T>& outward,
                  const Vec3<T>& point) {
  if (is_ground(self.piece)) return true;
  const Vec3<T> face = face_along(self, outward);
  if (face == Vec3<T>{} || max_abs(face - outward) > same_normal<T>) return false;
  const Vec3<T> middle = middle_of(other);
  if (dot(middle - point, outward) < T(0)) return false;
  const Aabb<T> sight{least(point, middle), greatest(point, middle)};
  const T noise = place_noise(self, point) + place_noise(middle);
  return std::all_of(self.beside.begin(), self.beside.end(), [&](const PlacedRef<T>& beside) {
    if (beside.shape == &self.whole) return true;
    if (is_ground(*beside.shape)) {
      const T height = height_above(*beside.shape, *beside.pose, point);
      const T slack = on_piece<T> * max_abs(bounds(self.piece, self.pose).extent()) + T(4) * noise;
      return height > slack || leads_along(outward, plane_normal(*beside.pose));
    }
    if (!beside.shape->convex()) return false;
    if (dot(furthest(*beside.shape, *beside.pose, outward) - point, outward) <= place_noise(self, point)) return true;
    const Aabb<T> box = bounds(*beside.shape, *beside.pose);
    return !overlap(inflated(sight, on_piece<T> * max_abs(box.extent()) + T(4) * noise), box);
  });
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Vec3<T> face_along(const LeafInContext<T>&, const Vec3<T>&, T);                                             \
  template bool stands_clear(const LeafInContext<T>&, const LeafInContext<T>&, const Vec3<T>&, const Vec3<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
