#include "composite/closest.hpp"

#include "composite/surface_point.hpp"
#include "narrow/general.hpp"
#include "narrow/pair_table.hpp"

namespace graze {

namespace {

template <class T>
bool bounds_solid(const MeshData<T>& mesh) {
  return mesh.closed;
}
template <class T>
bool bounds_solid(const HeightFieldData<T>&) {
  return false;
}

template <class T, class Surface>
Closest<T> surface_closest(const Surface& surface, const Pose<T>& pose, const Vec3<T>& point) {
  // Divided by its length, since that of a T is one in T alone.
  const Posed frame = in_double(pose);
  const Vec3d p = inverse_transform(frame, converted<double>(point));
  const SurfacePoint nearest = nearest_point<T>(surface, p, std::numeric_limits<double>::infinity());
  const Vec3d away = p - nearest.place.point, around = pseudonormal<T>(surface, nearest);
  const double noise = rounding_error * (static_cast<double>(surface.extent) + max_abs(p));
  const bool inside = bounds_solid(surface) && dot(around, away) < 0;
  // On the surface, where the way to it has no direction, it is the surface's own.
  const Vec3d normal = nearest.distance > noise ? normalized(inside ? -away : away) : normalized(around);
  return {static_cast<T>(inside ? -nearest.distance : nearest.distance),
          converted<T>(transform(frame, nearest.place.point)), converted<T>(rotate(frame.rotation, normal)),
          Status::converged, T(0)};
}

template <class T>
Closest<T> convex_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point) {
  const Distance<T> d = convex_distance(shape, pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{point, {}});
  return {d.distance, d.a, d.normal, d.status, d.error};
}

template <class T>
Closest<T> compound_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point) {
  Closest<T> best;
  best.distance = std::numeric_limits<T>::infinity();
  const Aabb<T> region = bounds(Shape<T>(Sphere<T>(T(0))), Pose<T>{inverse_transform(pose, point), {}});
  visit_pieces(
      shape, pose, region, [&] { return best.distance; },
      [&](const Shape<T>& child, const Pose<T>& child_pose, std::uint32_t) {
        const Closest<T> found = any_closest(child, child_pose, point);
        if (found.distance < best.distance) best = found;
      });
  return best;
}

}  // namespace

template <class T>
Closest<T> any_closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point) {
  if (shape.convex()) return convex_closest(shape, pose, point);
  Closest<T> closest;
  const auto of_surface = [&](const auto& surface) { closest = surface_closest(surface, pose, point); };
  if (with_surface(shape, of_surface)) return closest;
  return compound_closest(shape, pose, point);
}

template Closest<float> any_closest(const Shape<float>&, const Pose<float>&, const Vec3f&);
template Closest<double> any_closest(const Shape<double>&, const Pose<double>&, const Vec3d&);

}  // namespace graze
