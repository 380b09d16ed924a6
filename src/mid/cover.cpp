#include "mid/cover.hpp"

#include "graze/geometry.hpp"
#include "mid/pieces.hpp"
#include "mid/risers.hpp"
#include "narrow/convex_pair.hpp"

namespace graze {

namespace {

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

/// The way from a contact to the middle of what touches it.
template <class T>
struct Sight {
  const PieceOf<T>& self;
  Vec3<T> from, to, outward;
  T slack;  ///< what lies nearer is on it
};

/// Whether the piece goes on above the sheet, which then is the floor of a wall and does not hide it: at four times what
/// counts as on the sheet, along the wall. `above`: of the contact over the sheet.
template <class T>
bool goes_on_above(const Sight<T>& sight, const Vec3<T>& normal, T above, T slack) {
  const Vec3<T> along_wall = normal - sight.outward * dot(sight.outward, normal);
  const T rise = T(4) * slack;
  const Vec3<T> place = sight.from + along_wall * ((rise - above) / length_squared(along_wall));
  return convex_distance<T>(sight.self.piece, sight.self.pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{place, {}}, nullptr)
             .distance < rise / T(2);
}

/// Where the sight crosses a triangle that covers its beginning.
template <class T>
std::optional<OnSurface<T>> crossing(const Triangle<T>& triangle, const Pose<T>& pose, bool front_only,
                                     const Sight<T>& sight) {
  // About where the sight begins, which is exact far from the origin.
  Vec3<T> corners[3];
  T reach(0);
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = rotate(pose.rotation, triangle.point(i)) + (pose.translation - sight.from);
    reach = greatest(reach, max_abs(corners[i]));
  }
  const T slack = sight.slack + coordinate_noise(reach);
  Vec3<T> normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]), Vec3<T>{});
  const Vec3<T> way = sight.to - sight.from;
  T above = -dot(normal, corners[0]), end = above + dot(normal, way);
  if (end < T(0) && !front_only) {
    normal = -normal;
    above = -above;
    end = -end;
  }
  if (!(end > slack) || above > slack) return std::nullopt;
  const Vec3<T> at = above < T(0) ? way * (above / (above - end)) : Vec3<T>{};
  if (length(closest_point_on_triangle(corners[0], corners[1], corners[2], at).point - at) > slack) return std::nullopt;
  const bool rises = std::any_of(corners, corners + 3, [&](const Vec3<T>& corner) {
    return dot(corner - at, sight.outward) > region_slack<T> * length(corner - at) + slack;
  });
  if (!rises || goes_on_above(sight, normal, above, slack)) return std::nullopt;
  return OnSurface<T>{sight.from + at, normal};
}

/// What covers the beginning of a sight, of those seen so far: first one that nothing rises above, then one that the
/// other shape is least deep below. Beneath the corner of a floor the walls that hold it up hide each other too.
template <class T>
struct BestCover {
  const PieceOf<T>& other;
  std::optional<OnSurface<T>> surface = {};
  bool risen = true;
  T depth = std::numeric_limits<T>::infinity();

  void offer(const OnSurface<T>& seen, const PieceOf<T>& self) {
    const Vec3<T> down = rotate(conjugate(other.pose.rotation), -seen.normal);
    const T deep = dot(seen.point - transform(other.pose, support(other.piece, down)), seen.normal);
    const bool risen_above = riser_around(self, seen.point, seen.normal, Among::all).has_value();
    if (surface && (risen_above != risen ? risen_above : deep >= depth)) return;
    surface = seen;
    risen = risen_above;
    depth = deep;
  }
};

/// Offers all triangles of `whole` that cover the beginning of the sight.
template <class T>
void look_along(const Shape<T>& whole, const Pose<T>& pose, const Sight<T>& sight, BestCover<T>& best) {
  const Vec3<T> from = inverse_transform(pose, sight.from), to = inverse_transform(pose, sight.to), way = to - from;
  const RayQuestion<T> question{
      from, {T(1) / way.x, T(1) / way.y, T(1) / way.z}, T(0), T(1), sight.slack + place_noise(from) + place_noise(to)};
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t) {
    if (!piece.convex()) {
      look_along(piece, at, sight, best);
    } else if (const auto* triangle = piece.template as<Triangle<T>>()) {
      if (const auto seen = crossing(*triangle, at, one_sided(whole), sight)) best.offer(*seen, sight.self);
    }
  };
  visit_pieces(
      whole, pose, question, [] { return T(1); }, look);
}

}  // namespace

template <class T>
bool is_covered(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward) {
  const Aabb<T> box = bounds(self.piece, self.pose);
  const T step = on_piece<T> * max_abs(box.extent());
  const Vec3<T> to_center = box.center() - point, inward = to_center - outward * dot(to_center, outward);
  const Vec3<T> place = point + normalized(inward, Vec3<T>{}) * (T(4) * step) + outward * step;
  return any_around(self, point,
                    [&](const Shape<T>& shape, const Pose<T>& at) { return is_buried(shape, at, &self.piece, place); });
}

template <class T>
std::optional<OnSurface<T>> surface_over(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                         const PieceOf<T>& other) {
  const Aabb<T> box = bounds(self.piece, self.pose), of_other = bounds(other.piece, other.pose);
  const T size = least(max_abs(box.extent()), max_abs(of_other.extent()));
  const Sight<T> sight{self, point, of_other.center(), outward,
                       on_piece<T> * size + place_noise(point) + place_noise(box.extent())};
  BestCover<T> best{other};
  if (!self.whole.convex()) look_along(self.whole, self.whole_pose, sight, best);
  const Aabb<T> seen = inflated(Aabb<T>{least(sight.from, sight.to), greatest(sight.from, sight.to)}, sight.slack);
  for (const PlacedRef<T>& beside : self.beside)
    if (overlap(seen, bounds(*beside.shape, *beside.pose))) look_along(*beside.shape, *beside.pose, sight, best);
  return best.surface;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template bool is_covered(const PieceOf<T>&, const Vec3<T>&, const Vec3<T>&);                                         \
  template std::optional<OnSurface<T>> surface_over(const PieceOf<T>&, const Vec3<T>&, const Vec3<T>&,                 \
                                                    const PieceOf<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
