#include "mid/internal_edges.hpp"

#include <algorithm>
#include <optional>

#include "graze/geometry.hpp"
#include "mid/pieces.hpp"
#include "narrow/convex_pair.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// Sines below this are none: far above the error of a normal in float (curved depths have half the digits), far below
/// what a slope is made of.
template <class T>
constexpr T same_direction = T(2e-4);
/// A normal is inside a Voronoi region that it leaves by less than this sine: half the above, so that what is left of it
/// on a flat surface is laid along the face.
template <class T>
constexpr T region_slack = same_direction<T> / T(2);
/// A point lies on a piece that is nearer than this, relative to the piece: ten times the tolerance of points in float.
template <class T>
constexpr T on_piece = T(1e-4);

/// What the coordinates of a place in the world may have lost: a pose seen from another takes some thirty roundings.
template <class T>
T place_noise(const Vec3<T>& place) {
  return T(64) * std::numeric_limits<T>::epsilon() * max_abs(place);
}

/// The face normal of a triangle in its own frame; zero without area.
template <class T>
Vec3<T> face_normal(const Triangle<T>& t) {
  return normalized(cross(t.point(1) - t.point(0), t.point(2) - t.point(0)), Vec3<T>{});
}

/// Whether a convex piece touches `point` and rises above the plane through it. World space; `outward` unit.
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

/// The middle of the points of a manifold on one of its sides, taken about the first, which is exact far from the origin.
template <class T>
Vec3<T> middle(const Manifold<T>& manifold, Vec3<T> ContactPoint<T>::*side) {
  const Vec3<T> first = manifold.points[0].*side;
  Vec3<T> sum{};
  for (const ContactPoint<T>& p : manifold.points) sum += p.*side - first;
  return first + sum / static_cast<T>(manifold.points.size());
}

/// Where a manifold stands on one of its sides: the middle of its deepest points, which of an edge's contact is inside
/// the edge and not at an end of it.
template <class T>
Vec3<T> standing_point(const Manifold<T>& manifold, Vec3<T> ContactPoint<T>::*side) {
  const auto deepest =
      std::min_element(manifold.points.begin(), manifold.points.end(),
                       [](const ContactPoint<T>& p, const ContactPoint<T>& q) { return p.distance < q.distance; });
  Vec3<T> sum{};
  T count(0);
  for (const ContactPoint<T>& p : manifold.points) {
    const Vec3<T> from = p.*side - (*deepest).*side;
    if (p.distance - deepest->distance > same_direction<T> * length(from)) continue;
    sum += from;
    count += T(1);
  }
  return (*deepest).*side + sum / count;
}

/// Whether a place lies inside a solid piece of `whole` other than `self`, by more than rounding.
template <class T>
bool is_buried(const Shape<T>& whole, const Pose<T>& pose, const Shape<T>* self, const Vec3<T>& place) {
  bool buried = false;
  const Vec3<T> local = inverse_transform(pose, place);
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t) {
    if (buried || &piece == self) return;
    if (!piece.convex()) {
      buried = is_buried(piece, at, self, place);
      return;
    }
    const Distance<T> d = convex_distance<T>(piece, at, Shape<T>(Sphere<T>(T(0))), Pose<T>{place, {}}, nullptr);
    const T size = max_abs(bounds(piece, Pose<T>{}).extent());
    buried = d.distance < -T(4) * tolerance<T> * size - place_noise(place);
  };
  visit_pieces(
      whole, pose, Aabb<T>{local, local}, [] { return T(0); }, look);
  return buried;
}

/// Calls `f(shape, pose)` for the whole and all that is beside it and holds the point, until it returns true.
template <class T, class F>
bool any_around(const PieceOf<T>& self, const Vec3<T>& point, const F& f) {
  if (!self.whole.convex() && f(self.whole, self.whole_pose)) return true;
  return std::any_of(self.beside.begin(), self.beside.end(), [&](const PlacedRef<T>& other) {
    const Aabb<T> box = bounds(*other.shape, *other.pose);
    const T reach = on_piece<T> * max_abs(box.extent()) + place_noise(point);
    return overlap(inflated(box, reach), Aabb<T>{point, point}) && f(*other.shape, *other.pose);
  });
}

/// Which pieces may be a neighbour that rises: all but the piece itself, or all.
enum class Among { others, all };

/// A neighbour of the piece that rises above the plane through the point.
template <class T>
std::optional<Placed<T>> riser_around(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                      Among among = Among::others) {
  std::optional<Placed<T>> found;
  any_around(self, point, [&](const Shape<T>& shape, const Pose<T>& at) {
    found = riser(shape, at, among == Among::others ? &self.piece : nullptr, point, outward);
    return found.has_value();
  });
  return found;
}

/// Whether the face of a solid lies against a neighbour at the point: a step outward leads into that. First a step
/// towards the middle of the face, since its rim is where the next piece begins.
template <class T>
bool is_covered(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward) {
  const Aabb<T> box = bounds(self.piece, self.pose);
  const T step = on_piece<T> * max_abs(box.extent());
  const Vec3<T> to_center = box.center() - point, inward = to_center - outward * dot(to_center, outward);
  const Vec3<T> place = point + normalized(inward, Vec3<T>{}) * (T(4) * step) + outward * step;
  return any_around(self, point,
                    [&](const Shape<T>& shape, const Pose<T>& at) { return is_buried(shape, at, &self.piece, place); });
}

/// The normal of the triangle's or box's face that `outward` is the normal of, but for rounding; zero if of none.
template <class T>
Vec3<T> face_along(const PieceOf<T>& self, const Vec3<T>& outward) {
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
  if (face == Vec3<T>{} || length(cross(face, local)) > same_direction<T>) return {};
  return rotate(self.pose.rotation, face);
}

/// The outward normal that a surface has instead of one that leaves the Voronoi region of its feature. Of a triangle its
/// own face's, on the side where the other shape is; of a solid piece that of the neighbour which rises above it, as far
/// as the other shape touches that, or of a face of its own, if nothing rises above those.
template <class T>
std::optional<Vec3<T>> normal_of_surface(const PieceOf<T>& self, const Placed<T>& neighbour, const PieceOf<T>& other,
                                         const Vec3<T>& point, T margin) {
  if (const auto* triangle = self.piece.template as<Triangle<T>>()) {
    const Vec3<T> face = rotate(self.pose.rotation, face_normal(*triangle));
    if (face == Vec3<T>{}) return std::nullopt;
    return dot(face, bounds(other.piece, other.pose).center() - point) < T(0) ? -face : face;
  }
  Manifold<T> beside;
  convex_contacts(neighbour.shape, neighbour.pose, other.piece, other.pose, margin, beside, nullptr);
  if (!beside.points.empty() &&
      !riser_around(self, standing_point(beside, &ContactPoint<T>::a), beside.normal, Among::all))
    return beside.normal;
  if (self.piece.template as<Box<T>>())
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const T sign : {T(1), T(-1)}) {
        Vec3<T> face{};
        face[axis] = sign;
        face = rotate(self.pose.rotation, face);
        // At the place on the face that is over the point or under it.
        const Vec3<T> corner = transform(self.pose, support(self.piece, rotate(conjugate(self.pose.rotation), face)));
        if (!riser_around(self, point + face * dot(corner - point, face), face)) return face;
      }
  return std::nullopt;
}

/// A manifold without points between the pieces that another is between.
template <class T>
Manifold<T> between_same_pieces(const Manifold<T>& like) {
  Manifold<T> manifold;
  manifold.piece_a = like.piece_a;
  manifold.piece_b = like.piece_b;
  return manifold;
}

/// The manifold of two pieces along `outward`, a normal of A or B. Where their faces do not meet, as of a thing that
/// stands beside the piece on the continuation of its face, it has no points.
template <class T>
Manifold<T> laid_along(const PieceOf<T>& a, const PieceOf<T>& b, bool of_a, const Vec3<T>& outward, T margin,
                       const Manifold<T>& like) {
  Manifold<T> manifold = between_same_pieces(like);
  contacts_along(a.piece, a.pose, b.piece, b.pose, of_a ? outward : -outward, margin, manifold);
  return manifold;
}

/// One point: where the other shape reaches furthest below the plane of the piece's face.
template <class T>
Manifold<T> furthest_below(const PieceOf<T>& self, const PieceOf<T>& other, bool of_a, const Vec3<T>& outward,
                           const Manifold<T>& like) {
  const auto reach = [&](const PieceOf<T>& of, const Vec3<T>& along) {
    return transform(of.pose, support(of.piece, rotate(conjugate(of.pose.rotation), along)));
  };
  const Vec3<T> lowest = reach(other, -outward);
  const T distance = dot(lowest - reach(self, outward), outward);
  const Vec3<T> above = lowest - outward * distance;
  Manifold<T> manifold = between_same_pieces(like);
  manifold.normal = of_a ? outward : -outward;
  manifold.points.push_back({of_a ? above : lowest, of_a ? lowest : above, distance, like.points[0].feature});
  return manifold;
}

}  // namespace

template <class T>
Settled<T> settle_normal(const PieceOf<T>& a, const PieceOf<T>& b, T margin, const Manifold<T>& manifold) {
  Settled<T> settled{manifold, {}};
  Manifold<T>& now = settled.manifold;
  for (const bool of_a : {true, false}) {
    const PieceOf<T>&self = of_a ? a : b, &other = of_a ? b : a;
    if ((self.whole.convex() && self.beside.empty()) || now.points.empty() || !is_solid(other.piece)) continue;
    const Vec3<T> face = face_along(self, of_a ? now.normal : -now.normal);
    if (face != Vec3<T>{} && face != (of_a ? now.normal : -now.normal)) {
      const Manifold<T> tilted = now;
      now = laid_along(a, b, of_a, face, margin, tilted);
      if (now.points.empty()) settled.instead = tilted;  // rounding may leave a sliver without points
    }
    if (now.points.empty()) continue;
    // A triangle's face is part of the surface; a solid's may lie against its neighbour's.
    if (face != Vec3<T>{} && self.piece.template as<Triangle<T>>()) continue;
    const Vec3<T> outward = of_a ? now.normal : -now.normal;
    const auto side = of_a ? &ContactPoint<T>::a : &ContactPoint<T>::b;
    if (face != Vec3<T>{} && !is_covered(self, middle(now, side), outward)) continue;
    // Of a solid's edge or corner the points may lie a little beside it, on a face; the nearest points are on it.
    const bool beside_edge = face == Vec3<T>{} && !self.piece.template as<Triangle<T>>();
    const Vec3<T> point = beside_edge ? convex_distance<T>(self.piece, self.pose, other.piece, other.pose, nullptr).a
                                      : standing_point(now, side);
    const std::optional<Placed<T>> neighbour = riser_around(self, point, outward);
    if (!neighbour) continue;
    const auto normal = normal_of_surface(self, *neighbour, other, point, margin);
    if (!normal) continue;
    const Manifold<T> before = now;
    now = laid_along(a, b, of_a, *normal, margin, before);
    if (now.points.empty()) settled.instead = furthest_below(self, other, of_a, *normal, before);
  }
  return settled;
}

template Settled<float> settle_normal(const PieceOf<float>&, const PieceOf<float>&, float, const Manifold<float>&);
template Settled<double> settle_normal(const PieceOf<double>&, const PieceOf<double>&, double, const Manifold<double>&);

}  // namespace graze
