#include "composite/internal_edges/occluders.hpp"

#include "composite/internal_edges/voronoi_neighbours.hpp"
#include "composite/leaves.hpp"
#include "graze/geometry.hpp"
#include "narrow/pair_table.hpp"
#include "rays/convex_raycast.hpp"

namespace graze {

namespace {

/// The depth to which a shape reaches below the plane of a surface.
template <class T>
T depth_below(const OnSurface<T>& surface, const LeafInContext<T>& other) {
  return dot(surface.point - furthest(other.piece, other.pose, -surface.normal), surface.normal);
}

/// The way from a contact to the middle of what touches it.
template <class T>
struct Sight {
  const LeafInContext<T>& self;
  Vec3<T> from, to, outward;
  T slack;  ///< what lies nearer is on it
};

template <class T>
Sight<T> sight_of(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                  const LeafInContext<T>& other) {
  const Aabb<T> box = bounds(self.piece, self.pose);
  const T size = least(max_abs(box.extent()), max_abs(bounds(other.piece, other.pose).extent()));
  return {self, point, middle_of(other), outward,
          on_piece<T> * size + place_noise(self, point) + place_noise(box.extent())};
}

/// Whether the piece goes on above what may cover it, which then is the floor of a wall: at four times what counts as
/// on the floor, along the wall. `above`: of the contact over the floor.
template <class T>
bool goes_on_above(const Sight<T>& sight, const Vec3<T>& normal, T above, T slack) {
  const Vec3<T> along_wall = normal - sight.outward * dot(sight.outward, normal);
  const T squared = length_squared(along_wall), rise = T(4) * slack;
  if (!(squared > region_slack<T> * region_slack<T>)) return true;  // one that faces the other cannot cover it
  const Vec3<T> place = sight.from + along_wall * ((rise - above) / squared);
  return distance_to(sight.self, place) < rise / T(2);
}

/// The crossing of the sight with a triangle that covers its beginning.
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

/// The point at which the sight, seen from its end, enters a solid that it goes through or that it begins on.
template <class T>
std::optional<OnSurface<T>> entry(const Shape<T>& solid, const Pose<T>& pose, const Sight<T>& sight) {
  // A little further in, so that what begins on the solid up to rounding meets it.
  const Vec3<T> inward = normalized(bounds(solid, pose).center() - sight.from, Vec3<T>{}) * sight.slack;
  const Quatd back = conjugate(converted<double>(pose.rotation));
  const auto local = [&](const Vec3<T>& place) { return rotate(back, converted<double>(place - pose.translation)); };
  const Vec3d eye = local(sight.to), way = local(sight.from + inward) - eye;
  if (way == Vec3d{}) return std::nullopt;
  // The sight begins on the very plane of a flat solid.
  const double end = length(way) + static_cast<double>(sight.slack);
  const rays::MaybeHit hit = convex_raycast(solid, {eye, normalized(way), 0, end, 0}, BackFaces::hit);
  if (!hit || !(hit->t > 0)) return std::nullopt;  // not met, or its middle is inside too
  return OnSurface<T>{transform(pose, converted<T>(hit->point)), rotate(pose.rotation, converted<T>(hit->normal))};
}

/// The entry into a solid that covers the beginning of the sight.
template <class T>
std::optional<OnSurface<T>> covering_entry(const Shape<T>& solid, const Pose<T>& pose, const Sight<T>& sight) {
  // The plane through a place further along lies no lower.
  const T ahead = dot(sight.to - sight.from, sight.outward);
  const T highest = dot(furthest(solid, pose, sight.outward) - sight.from, sight.outward);
  if (ahead >= T(0) && highest <= place_noise(sight.from)) return std::nullopt;
  std::optional<OnSurface<T>> seen = entry(solid, pose, sight);
  if (!seen) return std::nullopt;
  const T above = dot(seen->normal, sight.from - seen->point);
  if (above > sight.slack || !piece_rises_above(solid, pose, seen->point, sight.outward) ||
      goes_on_above(sight, seen->normal, above, sight.slack))
    return std::nullopt;
  // An entry so near is the same place, but on this surface: below that by what counts as on it, its own solid would
  // rise.
  if (length(seen->point - sight.from) <= T(4) * sight.slack) seen->point = sight.from - seen->normal * above;
  return seen;
}

/// The point at which the sight comes up from a half-space that covers its beginning.
template <class T>
std::optional<OnSurface<T>> emergence(const Shape<T>& ground, const Pose<T>& pose, const Sight<T>& sight) {
  const Vec3<T> normal = plane_normal(pose);
  const T above = height_above(ground, pose, sight.from), end = height_above(ground, pose, sight.to);
  const T slack = sight.slack + place_noise(pose.translation);
  if (!(end > slack) || above > slack || leads_along(sight.outward, normal)) return std::nullopt;
  if (goes_on_above(sight, normal, above, slack)) return std::nullopt;
  const Vec3<T> at = above < T(0) ? (sight.to - sight.from) * (above / (above - end)) : Vec3<T>{};
  return OnSurface<T>{sight.from + at, normal};
}

/// The choice among surfaces that cover the beginning of a sight: one that nothing rises above, then the one nearest
/// to the sight's end, then the one below which the other shape is least deep. Beneath the corner of a floor the walls
/// that hold it up hide each other too.
template <class T>
struct BestCover {
  const LeafInContext<T>& other;
  std::optional<OnSurface<T>> surface = {};
  bool outside_region = true;
  T along = T(0), depth = std::numeric_limits<T>::infinity();

  void offer(const OnSurface<T>& seen, const Sight<T>& sight) {
    const bool now = neighbour_outside_region(sight.self, seen.point, seen.normal, Among::all).has_value();
    const T now_along = length(seen.point - sight.from), deep = depth_below(seen, other);
    const T nearer = now_along - along;
    const bool better = !surface || (now != outside_region                   ? outside_region
                                     : std::abs(nearer) > T(8) * sight.slack ? nearer > T(0)
                                                                             : deep < depth);
    if (!better) return;
    surface = seen;
    surface->outside_region = outside_region = now;
    along = now_along;
    depth = deep;
  }
};

/// The boxes along a sight, in the frame of what is looked at.
template <class T>
RayQuestion<T> boxes_along(const Sight<T>& sight, const Pose<T>& pose) {
  const Vec3<T> from = inverse_transform(pose, sight.from), to = inverse_transform(pose, sight.to), way = to - from;
  return {
      from, {T(1) / way.x, T(1) / way.y, T(1) / way.z}, T(0), T(1), sight.slack + place_noise(from) + place_noise(to)};
}

/// Offers all pieces of `whole` that cover the beginning of the sight.
template <class T>
void look_along(const Shape<T>& whole, const Pose<T>& pose, const Sight<T>& sight, BestCover<T>& best) {
  const RayQuestion<T> question = boxes_along(sight, pose);
  if (whole.convex() && question(bounds(whole, Pose<T>{})) > T(1)) return;  // of others the hierarchy tells
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t) {
    if (!piece.convex()) {
      look_along(piece, at, sight, best);
    } else if (const auto* triangle = piece.template as<Triangle<T>>()) {
      if (const auto seen = crossing(*triangle, at, one_sided(whole), sight)) best.offer(*seen, sight);
    } else if (is_ground(piece)) {
      if (const auto seen = emergence(piece, at, sight)) best.offer(*seen, sight);
    } else if (&piece != &sight.self.piece && is_solid(piece)) {
      if (const auto seen = covering_entry(piece, at, sight)) best.offer(*seen, sight);
    }
  };
  visit_pieces(
      whole, pose, question, [] { return T(1); }, look);
}

}  // namespace

template <class T>
T distance_to(const LeafInContext<T>& self, const Vec3<T>& place) {
  if (const auto* triangle = self.piece.template as<Triangle<T>>()) {
    const Vec3<T> p = inverse_transform(self.pose, place);
    const auto nearest = closest_point_on_triangle(triangle->point(0), triangle->point(1), triangle->point(2), p);
    return length(nearest.point - p);
  }
  return convex_distance<T>(self.piece, self.pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{place, {}}).distance;
}

template <class T>
std::optional<OnSurface<T>> surface_over(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                         const LeafInContext<T>& other) {
  const Sight<T> sight = sight_of(self, point, outward, other);
  BestCover<T> best{other};
  if (!self.whole.convex()) look_along(self.whole, self.whole_pose, sight, best);
  for (const PlacedRef<T>& beside : self.beside) look_along(*beside.shape, *beside.pose, sight, best);
  return best.surface;
}

template <class T>
bool is_covered(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                const LeafInContext<T>& other) {
  const Sight<T> sight = sight_of(self, point, outward, other);
  const RayQuestion<T> question = boxes_along(sight, self.whole_pose);
  bool covered = false;
  with_surface(self.whole, [&](const auto& surface) {
    const auto covers = [&](std::uint32_t number) {
      const auto [a, b, c] = surface.triangle(number);
      covered = crossing(Triangle<T>(a, b, c), self.whole_pose, surface.sides == Sides::front, sight).has_value();
      return covered;
    };
    for (const std::uint32_t next : surface.across(self.number))
      if (next != no_triangle && covers(next)) return;
    visit(
        surface.hierarchy(), question, [] { return T(1); },
        [&](std::uint32_t number) { return question(bounds_of(surface.triangle(number))) > T(1) || !covers(number); });
  });
  return covered;
}

template <class T>
std::optional<OnSurface<T>> own_surface(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                        const LeafInContext<T>& other) {
  const auto seen = entry(self.piece, self.pose, sight_of(self, point, outward, other));
  return seen && !neighbour_outside_region(self, point, seen->normal, Among::all) ? seen : std::nullopt;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template T distance_to(const LeafInContext<T>&, const Vec3<T>&);                                                     \
  template std::optional<OnSurface<T>> surface_over(const LeafInContext<T>&, const Vec3<T>&, const Vec3<T>&,           \
                                                    const LeafInContext<T>&);                                          \
  template bool is_covered(const LeafInContext<T>&, const Vec3<T>&, const Vec3<T>&, const LeafInContext<T>&);          \
  template std::optional<OnSurface<T>> own_surface(const LeafInContext<T>&, const Vec3<T>&, const Vec3<T>&,            \
                                                   const LeafInContext<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
