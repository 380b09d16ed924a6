#include "composite/solid.hpp"

#include <algorithm>

#include "composite/surface_point.hpp"
#include "narrow/general.hpp"
#include "narrow/pair_table.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

/// A body against a solid mesh, neither of them a compound.
template <class T>
struct Inside {
  const Part<T>&body, &mesh;
  const MeshData<T>& solid;

  /// Whether some connected part of the body, placed by `pose`, has a point inside. Where the surfaces do not touch it
  /// is then wholly inside.
  bool at(const Pose<T>& pose) const {
    const Posed seen = relative(in_double(mesh.pose), in_double(pose));
    const auto inside = [&](const Vec3<T>& p) { return encloses(solid, transform(seen, converted<double>(p))); };
    if (const auto* other = body.shape.template as<Mesh<T>>()) {
      const MeshData<T>& data = other->data();
      return std::any_of(data.islands.begin(), data.islands.end(),
                         [&](std::uint32_t i) { return inside(data.points[i]); });
    }
    if (const auto* field = body.shape.template as<HeightField<T>>()) {
      const Aabb<T> region = bounds(mesh.shape, relative(pose, mesh.pose));
      return !visit_pieces(
          body.shape, Pose<T>{}, region, [] { return T(0); },
          [&](const Shape<T>&, const Pose<T>&, std::uint32_t i) { return !inside(field->triangle(i)[0]); });
    }
    if (body.shape.template as<HalfSpace<T>>()) return false;
    return inside(support(body.shape, Vec3<T>{T(1), T(0), T(0)}));
  }

  /// The nearest points of the two surfaces; the normal leads from the body to the mesh.
  Enclosed<T> surface(const Pose<T>& pose) const {
    Enclosed<T> best;
    best.distance.distance = std::numeric_limits<T>::infinity();
    auto nearer = [&](const Part<T>& p, const Part<T>& triangle) {
      const Distance<T> d = convex_distance(p.shape, p.pose, triangle.shape, triangle.pose);
      if (d.distance < best.distance.distance) best = {d, p.number, triangle.number};
    };
    visit_convex_pairs<T>({body.shape, pose, body.number, body.outermost}, mesh,
                          {best.distance.distance, &best.distance.normal}, PairVisitor<T>(nearer));
    return best;
  }

  /// The points of the body that reach least and furthest along a direction of the world.
  std::array<Vec3<T>, 2> ends_along(const Vec3<T>& direction) const {
    const Vec3<T> local = rotate(conjugate(body.pose.rotation), direction);
    std::array<Vec3<T>, 2> ends;
    if (body.shape.convex()) {
      ends = {support(body.shape, -local), support(body.shape, local)};
    } else {
      T low = std::numeric_limits<T>::infinity(), high = -low;
      visit_pieces(
          body.shape, Pose<T>{}, Aabb<T>::everything(), [] { return T(0); },
          [&](const Shape<T>& triangle, const Pose<T>&, std::uint32_t) {
            for (std::size_t k = 0; k < 3; ++k) {
              const Vec3<T> p = triangle.template as<Triangle<T>>()->point(k);
              const T along = dot(p, local);
              if (along < low) ends[0] = p, low = along;
              if (along > high) ends[1] = p, high = along;
            }
          });
    }
    return {transform(body.pose, ends[0]), transform(body.pose, ends[1])};
  }

  /// A translation of the body: a unit vector of the world, how far, and the point of the body that is last to leave.
  struct Way {
    Vec3<T> along;
    T length;
    Vec3<T> last;
  };

  /// The least of the ways along the sides of the box about the mesh, in its frame, beyond that: all lead out.
  Way beyond_bounds() const {
    const Aabb<T>& box = solid.tree.bounds();
    Way least_way{{}, std::numeric_limits<T>::infinity(), {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool up : {false, true}) {
        Vec3<T> local{};
        local[axis] = up ? T(1) : T(-1);
        const Vec3<T> along = rotate(mesh.pose.rotation, local);
        const Vec3<T> last = ends_along(along)[0];
        const T end = up ? box.upper[axis] : -box.lower[axis];
        const T way = end - dot(inverse_transform(mesh.pose, last), local);
        if (way < least_way.length) least_way = {along, way, last};
      }
    return least_way;
  }

  /// The way out, where the body is wholly inside.
  std::optional<Enclosed<T>> way_out() const {
    if (!at(body.pose)) return {};
    Enclosed<T> found = surface(body.pose);
    if (!(found.distance.distance > T(0))) return {};
    Way way = beyond_bounds();
    // Through what is nearest, if nothing else of the mesh is behind it.
    const Vec3<T>& out = found.distance.normal;
    const std::array<Vec3<T>, 2> ends = ends_along(out);
    const T through = found.distance.distance + dot(ends[1] - ends[0], out);
    if (through < way.length) {
      // Touching is out; the tolerance of a distance tells it from being in.
      const T slack = T(4) * tolerance<T> * (solid.extent + through);
      const Pose<T> moved{body.pose.translation + out * (through + slack), body.pose.rotation};
      if (surface(moved).distance.distance > T(0) && !at(moved)) way = {out, through, ends[0]};
    }
    found.distance = {-way.length, -way.along, way.last, way.last + way.along * way.length, Status::converged, T(0)};
    return found;
  }
};

/// Calls `f(part_a, part_b)` for the children of A and B that come near each other, neither of them a compound, until
/// it returns false.
template <class T, class F>
bool visit_children(const Part<T>& a, const Part<T>& b, F& f) {
  const bool open_a = a.shape.template as<Compound<T>>() != nullptr;
  if (!open_a && !b.shape.template as<Compound<T>>()) return f(a, b);
  const Part<T>&opened = open_a ? a : b, &other = open_a ? b : a;
  const Aabb<T> region = bounds(other.shape, relative(opened.pose, other.pose));
  return visit_pieces(
      opened.shape, opened.pose, region, [] { return T(0); },
      [&](const Shape<T>& child, const Pose<T>& pose, std::uint32_t number) {
        const Part<T> piece = opened.piece(child, pose, number);
        return open_a ? visit_children(piece, other, f) : visit_children(other, piece, f);
      });
}

template <class T>
const MeshData<T>* solid_mesh(const Shape<T>& shape) {
  const auto* mesh = shape.template as<Mesh<T>>();
  return mesh && mesh->solid() ? &mesh->data() : nullptr;
}

template <class T>
Enclosed<T> exchanged(const Enclosed<T>& e) {
  const Distance<T>& d = e.distance;
  return {{d.distance, -d.normal, d.b, d.a, d.status, d.error}, e.piece_b, e.piece_a};
}

}  // namespace

template <class T>
bool encloses(const MeshData<T>& mesh, const Vec3d& point) {
  const Aabb<T>& box = mesh.tree.bounds();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (point[axis] < static_cast<double>(box.lower[axis]) || point[axis] > static_cast<double>(box.upper[axis]))
      return false;
  const SurfacePoint nearest = nearest_point<T>(mesh, point, std::numeric_limits<double>::infinity());
  return dot(pseudonormal<T>(mesh, nearest), point - nearest.place.point) < 0;
}

template <class T>
bool any_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  if (!has_solid_mesh(a) && !has_solid_mesh(b)) return false;
  auto outside = [](const Part<T>& pa, const Part<T>& pb) {
    const MeshData<T>*solid_a = solid_mesh(pa.shape), *solid_b = solid_mesh(pb.shape);
    return !(solid_b && Inside<T>{pa, pb, *solid_b}.at(pa.pose)) &&
           !(solid_a && Inside<T>{pb, pa, *solid_a}.at(pb.pose));
  };
  return !visit_children<T>({a, pose_a}, {b, pose_b}, outside);
}

template <class T>
std::optional<Enclosed<T>> deepest_enclosed(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                            const Pose<T>& pose_b) {
  std::optional<Enclosed<T>> deepest;
  if (!has_solid_mesh(a) && !has_solid_mesh(b)) return deepest;
  auto deeper = [&](const Part<T>& pa, const Part<T>& pb) {
    const auto take = [&](const Enclosed<T>& found) {
      if (!deepest || found.distance.distance < deepest->distance.distance) deepest = found;
    };
    if (const MeshData<T>* solid = solid_mesh(pb.shape))
      if (const auto found = Inside<T>{pa, pb, *solid}.way_out()) take(*found);
    if (const MeshData<T>* solid = solid_mesh(pa.shape))
      if (const auto found = Inside<T>{pb, pa, *solid}.way_out()) take(exchanged(*found));
    return true;
  };
  visit_children<T>({a, pose_a}, {b, pose_b}, deeper);
  return deepest;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template bool encloses(const MeshData<T>&, const Vec3d&);                                                            \
  template bool any_enclosed(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);                        \
  template std::optional<Enclosed<T>> deepest_enclosed(const Shape<T>&, const Pose<T>&, const Shape<T>&,               \
                                                       const Pose<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
