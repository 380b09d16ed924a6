#include "mid/risers.hpp"

#include "graze/geometry.hpp"
#include "mid/pieces.hpp"
#include "narrow/convex_pair.hpp"
#include "shape/rounding.hpp"

namespace graze {

template <class T>
bool piece_rises_above(const Shape<T>& piece, const Pose<T>& pose, const Vec3<T>& point, const Vec3<T>& outward) {
  const Vec3<T> p = inverse_transform(pose, point), n = rotate(conjugate(pose.rotation), outward);
  const T noise = place_noise(point);
  return piece.visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (std::is_same_v<C, Triangle<T>>) {
      const T size = greatest(length(c.point(0) - p), greatest(length(c.point(1) - p), length(c.point(2) - p)));
      const Vec3<T> nearest = closest_point_on_triangle(c.point(0), c.point(1), c.point(2), p).point;
      if (length(nearest - p) > on_piece<T> * size + noise) return false;
      bool rises = false;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> to = c.point(i) - p;
        rises = rises || dot(to, n) > region_slack<T> * length(to) + noise;
      }
      return rises;
    } else if constexpr (BoundedConvex<C>) {
      const T radius = rounding_radius(c, piece.margin()), size = c.core_extent() + radius;
      const Distance<T> d = convex_distance<T>(piece, pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{point, {}}, nullptr);
      if (std::abs(d.distance) > on_piece<T> * size + noise) return false;
      return dot(c.core_support(n) - p, n) + radius > region_slack<T> * size + noise;
    } else {
      return false;
    }
  });
}

namespace {

/// A convex piece of `whole` other than the solid `self` that touches `point` and rises above the plane through it, if
/// there is one.
template <class T>
std::optional<Placed<T>> riser(const Shape<T>& whole, const Pose<T>& pose, const Shape<T>* self, const Vec3<T>& point,
                               const Vec3<T>& outward) {
  std::optional<Placed<T>> found;
  const Vec3<T> local = inverse_transform(pose, point);
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t) {
    if (found || &piece == self) return;
    if (!piece.convex())
      found = riser(piece, at, self, point, outward);
    else if (piece_rises_above(piece, at, point, outward))
      found.emplace(Placed<T>{piece, at});
  };
  const T reach = on_piece<T> * max_abs(bounds(whole, Pose<T>{}).extent()) + place_noise(point);
  visit_pieces(
      whole, pose, inflated(Aabb<T>{local, local}, reach), [] { return T(0); }, look);
  return found;
}

}  // namespace

template <class T>
std::optional<Placed<T>> riser_around(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                      Among among) {
  std::optional<Placed<T>> found;
  any_around(self, point, [&](const Shape<T>& shape, const Pose<T>& at) {
    found = riser(shape, at, among == Among::others ? &self.piece : nullptr, point, outward);
    return found.has_value();
  });
  return found;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template bool piece_rises_above(const Shape<T>&, const Pose<T>&, const Vec3<T>&, const Vec3<T>&);                    \
  template std::optional<Placed<T>> riser_around(const PieceOf<T>&, const Vec3<T>&, const Vec3<T>&, Among);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
