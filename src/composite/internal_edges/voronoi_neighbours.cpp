#include "composite/internal_edges/voronoi_neighbours.hpp"

#include "composite/leaves.hpp"
#include "composite/mesh_patch.hpp"
#include "graze/geometry.hpp"
#include "narrow/pair_table.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// Whether a triangle touches `p` and rises above the plane through it. `at_place`: what the coordinates of `p` may be
/// off by for where it is; near the origin they are off by what those of the triangle are.
template <class T>
bool rises_above(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& p, const Vec3<T>& n, T at_place) {
  const T to_a = length(a - p), to_b = length(b - p), to_c = length(c - p);
  const T size = greatest(to_a, greatest(to_b, to_c)), noise = at_place + coordinate_noise(size);
  const auto rises = [&](const Vec3<T>& corner, T away) { return dot(corner - p, n) > region_slack<T> * away + noise; };
  if (!rises(a, to_a) && !rises(b, to_b) && !rises(c, to_c)) return false;
  return length(closest_point_on_triangle(a, b, c, p).point - p) <= on_piece<T> * size + noise;
}

/// Calls `look(number)` for the triangles that come near `region`, until it returns false. Those of a patch are at
/// hand.
template <class T, class F>
void each_near(const MeshData<T>& mesh, const Aabb<T>& region, const MeshPatch<T>* patch, F& look) {
  if (patch && patch->covers(mesh, region))
    patch->each([&](const Aabb<T>& box) { return overlap(box, region); }, look);
  else
    visit(
        mesh.tree, region, [] { return T(0); }, look);
}
template <class T, class F>
void each_near(const HeightFieldData<T>& field, const Aabb<T>& region, const MeshPatch<T>*, F& look) {
  field.each_at(region, look);
}

/// The largest distance of a triangle's bounds from a point that lies on it.
template <class T>
T reach_on(const HeightFieldData<T>& field, T noise) {
  return on_piece<T> * max_abs(field.hierarchy().bounds().extent()) + noise;
}

/// Whether the edge from `a` to `b` touches `p` and the third corner of a triangle at it rises there: then
/// `rises_above` says so of that triangle.
template <class T>
bool rises_beyond(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& corner, const Vec3<T>& p, const Vec3<T>& n,
                  T at_place) {
  const Vec3<T> to_corner = corner - p;
  const T away = length(to_corner);
  const T size = std::sqrt(greatest(away * away, greatest(length_squared(a - p), length_squared(b - p))));
  const T noise = at_place + coordinate_noise(size), reach = on_piece<T> * size + noise;
  return dot(to_corner, n) > region_slack<T> * away + noise &&
         length_squared(closest_point<T>({a, b}, p) - p) <= reach * reach;
}

/// The triangle across an edge of triangle `number` that `p` lies on, if it rises there: nearly all contacts on edges
/// end here, without a search.
template <class T, class Surface>
std::optional<std::uint32_t> rising_across(const Surface& surface, std::uint32_t number, const Vec3<T>& p,
                                           const Vec3<T>& n, T noise) {
  const std::array<Vec3<T>, 3> own = surface.triangle(number);
  const TrianglesAcross& across = surface.across(number);
  for (std::size_t i = 0; i < 3; ++i) {
    if (across[i] == no_triangle) continue;
    const Vec3<T>&from = own[i], &to = own[(i + 1) % 3];
    const std::array<Vec3<T>, 3> next = surface.triangle(across[i]);
    const auto* corner =
        std::find_if(next.begin(), next.end() - 1, [&](const auto& q) { return q != from && q != to; });
    if (rises_beyond(from, to, *corner, p, n, noise)) return across[i];
  }
  return std::nullopt;
}

/// A triangle of a mesh or height field that touches `p` and rises there. `near`: one that `p` may lie on, if known.
template <class T, class Surface>
std::optional<std::uint32_t> rising_triangle(const Surface& surface, std::optional<std::uint32_t> near,
                                             const MeshPatch<T>* patch, const Vec3<T>& p, const Vec3<T>& n, T noise) {
  std::optional<std::uint32_t> found;
  if (near) found = rising_across(surface, *near, p, n, noise);
  if (found) return found;
  const Aabb<T> region = inflated(Aabb<T>{p, p}, reach_on(surface, noise));
  const auto look = [&](std::uint32_t number) {
    const std::array<Vec3<T>, 3> t = surface.triangle(number);
    if (overlap(bounds_of(t), region) && rises_above(t[0], t[1], t[2], p, n, noise)) found = number;
    return !found;
  };
  each_near(surface, region, patch, look);
  return found;
}

/// Whether the surface of a half-space goes through `point`, on a piece of this extent, and crosses the plane through
/// it: as it has no end, it rises above every plane but its own.
template <class T>
bool ground_rises_above(const Shape<T>& ground, const Pose<T>& pose, const Vec3<T>& extent, const Vec3<T>& point,
                        const Vec3<T>& outward) {
  const Vec3<T> up = plane_normal(pose);
  const T slack = on_piece<T> * max_abs(extent) + place_noise(point) + place_noise(pose.translation);
  return std::abs(height_above(ground, pose, point)) <= slack && !leads_along(outward, up);
}

/// A convex piece of `whole` that touches `point` and rises above the plane through it, if there is one.
template <class T>
std::optional<Placed<T>> outside_region(const Shape<T>& whole, const Pose<T>& pose, const LeafInContext<T>& self,
                                        Among among, const Vec3<T>& point, const Vec3<T>& outward) {
  std::optional<Placed<T>> found;
  const Vec3<T> local = inverse_transform(pose, point);
  const T noise = place_noise(point, local);
  const auto of_surface = [&](const auto& surface) {
    const bool own = &whole == &self.whole && self.piece.template as<Triangle<T>>();
    const auto near = own ? std::optional(self.number) : std::nullopt;
    const Vec3<T> n = rotate(conjugate(pose.rotation), outward);
    const auto number = rising_triangle(surface, near, self.patch, local, n, noise);
    if (number) found.emplace(Placed<T>{triangle_shape(surface.triangle(*number)), pose});
  };
  if (with_surface(whole, of_surface)) return found;
  const auto look = [&](const Shape<T>& piece, const Pose<T>& at, std::uint32_t) {
    if (among == Among::others && &piece == &self.piece) return true;
    if (!piece.convex())
      found = outside_region(piece, at, self, among, point, outward);
    else if (is_ground(piece) ? ground_rises_above(piece, at, bounds(self.piece, self.pose).extent(), point, outward)
                              : piece_rises_above(piece, at, point, outward))
      found.emplace(Placed<T>{piece, at});
    return !found;
  };
  // No piece is larger than the whole: of a compound its bounds would cost a look at every child.
  const auto* compound = whole.template as<Compound<T>>();
  const T size = compound ? T(2) * compound->core_extent() : max_abs(bounds(whole, Pose<T>{}).extent());
  const Aabb<T> region = inflated(Aabb<T>{local, local}, on_piece<T> * size + noise);
  visit_pieces(
      whole, pose, region, [] { return T(0); }, look);
  return found;
}

}  // namespace

template <class T>
bool piece_rises_above(const Shape<T>& piece, const Pose<T>& pose, const Vec3<T>& point, const Vec3<T>& outward) {
  const Vec3<T> p = inverse_transform(pose, point), n = rotate(conjugate(pose.rotation), outward);
  const T noise = place_noise(point, p);
  return piece.visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (std::is_same_v<C, Triangle<T>>) {
      return rises_above(c.point(0), c.point(1), c.point(2), p, n, noise);
    } else if constexpr (BoundedConvex<C>) {
      const T radius = rounding_radius(c, piece.rounding()), size = c.core_extent() + radius;
      const Distance<T> d = convex_distance<T>(piece, pose, Shape<T>(Sphere<T>(T(0))), Pose<T>{point, {}});
      if (std::abs(d.distance) > on_piece<T> * size + noise) return false;
      return dot(c.core_support(n) - p, n) + radius > region_slack<T> * size + noise;
    } else {
      return false;
    }
  });
}

template <class T>
std::optional<Placed<T>> neighbour_outside_region(const LeafInContext<T>& self, const Vec3<T>& point,
                                                  const Vec3<T>& outward, Among among) {
  std::optional<Placed<T>> found;
  any_around(self, point, [&](const Shape<T>& shape, const Pose<T>& at) {
    found = outside_region(shape, at, self, among, point, outward);
    return found.has_value();
  });
  return found;
}

template <class T>
bool rises_across_edge(const Shape<T>& surface, std::uint32_t triangle, const Vec3<T>& point, const Vec3<T>& outward,
                       T noise) {
  bool rises = false;
  with_surface(surface,
               [&](const auto& data) { rises = rising_across(data, triangle, point, outward, noise).has_value(); });
  return rises;
}

template <class T>
FixedVector<Vec3<T>, 16> faces_around(const LeafInContext<T>& self, const Vec3<T>& point) {
  FixedVector<Vec3<T>, 16> faces;
  const auto* mesh = self.whole.template as<Mesh<T>>();
  if (!mesh) return faces;
  const Vec3<T> local = inverse_transform(self.whole_pose, point);
  const T noise = place_noise(point, local);
  const Aabb<T> region = inflated(Aabb<T>{local, local}, reach_on(mesh->data(), noise));
  const auto look = [&](std::uint32_t number) {
    const std::array<Vec3<T>, 3> corners = mesh->data().triangle(number);
    const auto& [a, b, c] = corners;
    const T slack = on_piece<T> * max_abs(bounds_of(corners).extent()) + noise;
    if (length(closest_point_on_triangle(a, b, c, local).point - local) > slack) return true;
    const Vec3<T> face = rotate(self.whole_pose.rotation, face_normal(Triangle<T>(a, b, c)));
    const bool known = std::any_of(faces.begin(), faces.end(), [&](const Vec3<T>& f) { return leads_along(f, face); });
    if (face != Vec3<T>{} && !known) faces.push_back(face);
    return !faces.full();
  };
  each_near(mesh->data(), region, self.patch, look);
  return faces;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template bool piece_rises_above(const Shape<T>&, const Pose<T>&, const Vec3<T>&, const Vec3<T>&);                    \
  template std::optional<Placed<T>> neighbour_outside_region(const LeafInContext<T>&, const Vec3<T>&, const Vec3<T>&,  \
                                                             Among);                                                   \
  template bool rises_across_edge(const Shape<T>&, std::uint32_t, const Vec3<T>&, const Vec3<T>&, T);                  \
  template FixedVector<Vec3<T>, 16> faces_around(const LeafInContext<T>&, const Vec3<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
