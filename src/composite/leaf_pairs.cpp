#include "composite/leaf_pairs.hpp"

#include "composite/near_convex.hpp"
#include "composite/triangle_run.hpp"

namespace graze {

namespace {

/// The rounding error of the corners of two bodies seen from one of them, doubled: the pairs' own routines take so
/// much for touching, which must not be ruled out before.
template <class T>
T corner_rounding(T extent_a, T extent_b, const Vec3<T>& translation) {
  return T(64) * std::numeric_limits<T>::epsilon() * (extent_a + extent_b + max_abs(translation));
}

/// Whether a mesh bounds a body that `other`, seen from the mesh, is not within: the middle of what is lies in the
/// mesh's bounds, and it is no wider than these. Not of a half-space, whose normal is right wherever it is met.
template <class T>
bool comes_from_outside(const Shape<T>& surface, const Shape<T>& other, const Pose<T>& seen) {
  const auto* mesh = surface.template as<Mesh<T>>();
  if (!mesh || !mesh->data().outward || other.template as<HalfSpace<T>>()) return false;
  const Aabb<T>&box = mesh->data().tree.bounds(), of_other = bounds(other, seen);
  const Vec3<T> center = of_other.center(), size = of_other.extent(), own = box.extent();
  return !contains(box, {center, center}) || size.x > own.x || size.y > own.y || size.z > own.z;
}

/// A composite about to be opened where `other` meets it.
template <class T>
Part<T> met_by(const Part<T>& whole, const Shape<T>& other, const Pose<T>& seen) {
  Part<T> met = whole;
  met.pushes = one_sided(whole.shape)                         ? Pushes::frontward
               : comes_from_outside(whole.shape, other, seen) ? Pushes::outward
                                                              : Pushes::either_way;
  if (const auto* mesh = whole.shape.template as<Mesh<T>>(); mesh && mesh->solid()) met.solid = &mesh->data();
  return met;
}

/// Two meshes or height fields.
template <class T>
bool visit_triangle_pairs(const Part<T>& whole_a, const Part<T>& whole_b, const Nearness<T>& limit,
                          const PairVisitor<T>& f) {
  const Pose<T> b_in_a = relative(whole_a.pose, whole_b.pose);
  const Part<T> a = met_by(whole_a, whole_b.shape, b_in_a);
  const Part<T> b = met_by(whole_b, whole_a.shape, relative(whole_b.pose, whole_a.pose));
  const Mat3<T> rotation = rotation_matrix(b_in_a.rotation);
  bool whole = true;
  with_surface(a.shape, [&](const auto& surface_a) {
    with_surface(b.shape, [&](const auto& surface_b) {
      const T slack = corner_rounding(surface_a.extent, surface_b.extent, b_in_a.translation);
      const auto pair = [&](std::uint32_t i, std::uint32_t j) {
        const Corners<T> corners_a = surface_a.triangle(i), own_b = surface_b.triangle(j);
        Corners<T> corners_b = own_b;
        for (Vec3<T>& p : corners_b) p = rotation * p + b_in_a.translation;
        if (limit.direction) {
          const Vec3<T> direction = rotate(conjugate(a.pose.rotation), *limit.direction);
          if (!may_come_within_along(corners_a, corners_b, direction, limit(), slack)) return true;
        }
        if (!may_come_within(corners_a, corners_b, limit(), slack)) return true;
        const Shape<T> shape_a = triangle_shape(corners_a), shape_b = triangle_shape(own_b);
        return f(a.piece(shape_a, a.pose, i), b.piece(shape_b, b.pose, j));
      };
      whole = visit_pairs(surface_a.hierarchy(), surface_b.hierarchy(), b_in_a, limit, pair);
    });
  });
  return whole;
}

/// The triangles whose bounds come near a body, shown as runs.
template <class T>
bool visit_runs(TriangleRun<T>& run, const Nearness<T>& limit, const PairVisitor<T>& f) {
  const auto near = [&](const Aabb<T>& box) { return run.question(box) <= run.question.key(limit()); };
  const auto show = [&] {
    const bool whole = f(run);
    run.count = 0;
    return whole;
  };
  bool whole = true;
  with_surface(run.surface.shape, [&](const auto& surface) {
    const auto add = [&](const Corners<T>& corners, std::uint32_t number) {
      run.add(corners, number);
      return run.count < run.most || show();
    };
    if (run.patch)
      whole = run.patch->each(near, [&](std::uint32_t i) { return add(surface.triangle(i), i); });
    else
      whole = visit(surface.hierarchy(), run.question, limit, [&](std::uint32_t i) {
        const Corners<T> corners = surface.triangle(i);
        return !near(bounds_of(corners)) || add(corners, i);
      });
  });
  return whole && (run.count == 0 || show());
}

/// The triangles of `opened`, a mesh or height field, that come near the convex and bounded `other`. By itself:
/// compounds within compounds have no room for its question and patch at each level.
template <class T>
[[gnu::noinline]] bool visit_triangles_near(const Part<T>& opened, const Part<T>& other, bool is_a, const Pose<T>& seen,
                                            T slack, const Nearness<T>& limit, const PairVisitor<T>& f) {
  const NearConvex<T> question(other.shape, seen, slack);
  MeshPatch<T> patch;
  const auto* mesh = limit.with_patches ? opened.shape.template as<Mesh<T>>() : nullptr;
  const bool has_patch = mesh && patch.fill(*mesh, question, limit());
  const auto visit_piece = [&](const Shape<T>& shape, const Pose<T>& pose, std::uint32_t number) {
    Part<T> piece = opened.piece(shape, pose, number);
    if (has_patch) piece.patch = &patch;
    return is_a ? f(piece, other) : f(other, piece);
  };
  const auto near = [&](const Aabb<T>& box) { return question(box) <= question.key(limit()); };
  if (f.takes_runs() && concrete_for_runs(other.shape)) {
    TriangleRun<T> run(opened, other, is_a, has_patch ? &patch : nullptr, question);
    return visit_runs(run, limit, f);
  }
  if (!has_patch) return visit_pieces(opened.shape, opened.pose, question, limit, visit_piece);
  return patch.each(near, [&](std::uint32_t i) {
    return visit_near_triangle<T>(mesh->data(), i, opened.pose, question, limit(), visit_piece);
  });
}

/// The pieces of `whole`, a composite, that come near all of `other`; `is_a`: whether it is the first of the two.
template <class T>
bool visit_pieces_near(const Part<T>& whole, const Part<T>& other, bool is_a, const Nearness<T>& limit,
                       const PairVisitor<T>& f) {
  const Pose<T> seen = relative(whole.pose, other.pose);
  const Part<T> opened = met_by(whole, other.shape, seen);
  const auto visit_piece = [&](const Shape<T>& shape, const Pose<T>& pose, std::uint32_t number) {
    const Part<T> piece = opened.piece(shape, pose, number);
    return is_a ? visit_convex_pairs(piece, other, limit, f) : visit_convex_pairs(other, piece, limit, f);
  };
  const auto extent = [](const Shape<T>& shape) { return shape.visit([](const auto& c) { return c.core_extent(); }); };
  const T slack = corner_rounding(extent(opened.shape), extent(other.shape) + other.shape.rounding(), seen.translation);
  if (!other.shape.template as<HalfSpace<T>>()) {
    if (!opened.shape.template as<Compound<T>>())
      return visit_triangles_near(opened, other, is_a, seen, slack, limit, f);
    return visit_pieces(opened.shape, opened.pose, inflated(bounds(other.shape, seen), slack), limit, visit_piece);
  }
  // A tilted half-space has no bounds, but is as easily asked about.
  const Vec3<T> up = rotate(seen.rotation, Vec3<T>{T(0), T(1), T(0)});
  const T surface = dot(up, seen.translation) + other.shape.rounding();
  return visit_pieces(opened.shape, opened.pose, PlaneQuestion<T>{up, surface + slack}, limit, visit_piece);
}

template <class T>
const CompoundData<T>* compound_data(const Shape<T>& shape) {
  const auto* compound = shape.template as<Compound<T>>();
  return compound ? &compound->data() : nullptr;
}

/// Two compounds: both trees at once, and what is in no tree against everything.
template <class T>
bool visit_child_pairs(const CompoundData<T>& data_a, const Part<T>& a, const CompoundData<T>& data_b, const Part<T>& b,
                       const Nearness<T>& limit, const PairVisitor<T>& f) {
  for (const std::uint32_t i : data_a.unbounded) {
    const Placed<T>& child = data_a.children[i];
    const Pose<T> pose = compose(a.pose, child.pose);
    if (!visit_convex_pairs(a.piece(child.shape, pose, i), b, limit, f)) return false;
  }
  const Pose<T> b_in_a = relative(a.pose, b.pose);
  const auto pair = [&](std::uint32_t i, std::uint32_t j) {
    const Placed<T>&child_a = data_a.children[i], &child_b = data_b.children[j];
    const Aabb<T> box_b = bounds(child_b.shape, compose(b_in_a, child_b.pose));
    if (BoxQuestion<T>{box_b}(data_a.boxes[i]) > signed_square(limit())) return true;
    const Pose<T> pose_a = compose(a.pose, child_a.pose), pose_b = compose(b.pose, child_b.pose);
    return visit_convex_pairs(a.piece(child_a.shape, pose_a, i), b.piece(child_b.shape, pose_b, j), limit, f);
  };
  for (const std::uint32_t j : data_b.unbounded) {
    const Placed<T>& child = data_b.children[j];
    const Pose<T> pose = compose(b.pose, child.pose);
    const Part<T> part = b.piece(child.shape, pose, j);
    const auto of_tree = [&](std::uint32_t i) {
      const Placed<T>& child_a = data_a.children[i];
      const Pose<T> pose_a = compose(a.pose, child_a.pose);
      return visit_convex_pairs(a.piece(child_a.shape, pose_a, i), part, limit, f);
    };
    if (!visit(data_a.tree, Aabb<T>::everything(), limit, of_tree)) return false;
  }
  return visit_pairs(data_a.tree, data_b.tree, b_in_a, limit, pair);
}

}  // namespace

template <class T>
bool visit_convex_pairs(const Part<T>& a, const Part<T>& b, const Nearness<T>& limit, const PairVisitor<T>& f) {
  const bool convex_a = a.shape.convex(), convex_b = b.shape.convex();
  if (convex_a && convex_b) return f(a, b);
  const CompoundData<T>*compound_a = compound_data(a.shape), *compound_b = compound_data(b.shape);
  if (compound_a && compound_b) return visit_child_pairs(*compound_a, a, *compound_b, b, limit, f);
  if (!compound_a && !compound_b && !convex_a && !convex_b) return visit_triangle_pairs(a, b, limit, f);
  // One is left to be opened: a compound before a mesh, whose tree then meets each child as a whole.
  const bool open_a = compound_a || (!convex_a && !compound_b);
  return open_a ? visit_pieces_near(a, b, true, limit, f) : visit_pieces_near(b, a, false, limit, f);
}

template bool visit_convex_pairs(const Part<float>&, const Part<float>&, const Nearness<float>&,
                                 const PairVisitor<float>&);
template bool visit_convex_pairs(const Part<double>&, const Part<double>&, const Nearness<double>&,
                                 const PairVisitor<double>&);

}  // namespace graze
