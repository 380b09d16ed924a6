#include "narrow/sat/polyhedral_pair.hpp"

#include "narrow/core/scanned_shape.hpp"

namespace graze {

namespace {

/// Whether the test on lanes applies: to two such shapes, of which one at least is a hull, since all others have
/// routines of their own.
template <class T>
bool have_facets(const Shape<T>& a, const Shape<T>& b) {
  if constexpr (std::is_same_v<T, float>) return (is_hull(a) || is_hull(b)) && has_facets(a) && has_facets(b);
  return false;
}

template <class T>
const Box<T>* as_box(const Shape<T>& shape) {
  if (const auto* box = shape.template as<Box<T>>()) return box;
  const auto* rectangle = shape.template as<Rectangle<T>>();
  return rectangle ? &rectangle->as_box() : nullptr;
}

/// The face of a box across an axis known at compile time, which leaves no cyclic index to run time.
template <std::size_t major>
void box_face_across(const Vec3d& half, const Vec3d& direction, PlacedFace& face) {
  constexpr std::size_t u = (major + 1) % 3, v = (major + 2) % 3;
  const bool positive = direction[major] >= 0, wide = half[u] != 0, high = half[v] != 0;
  face.id = static_cast<std::uint32_t>(2 * major + positive);
  const auto corner = [&](bool at_u, bool at_v) {
    if ((!wide && at_u != (direction[u] >= 0)) || (!high && at_v != (direction[v] >= 0))) return;
    Vec3d p;
    p[major] = positive ? half[major] : -half[major];
    p[u] = at_u ? half[u] : -half[u];
    p[v] = at_v ? half[v] : -half[v];
    face.vertices.push_back(p);
    face.ids.push_back(
        static_cast<std::uint32_t>((positive << major) | ((at_u && half[u] > 0) << u) | ((at_v && half[v] > 0) << v)));
  };
  corner(false, false);
  corner(positive, !positive);  // u, v, major are right-handed
  corner(true, true);
  corner(!positive, positive);
}

SeparatingAxis axis_of(AxisKind kind, const BoxAxis<double>& axis) {
  const auto number = static_cast<std::size_t>(axis.number);
  if (kind == AxisKind::edges) return {kind, axis.separation, axis.normal, (number - 6) / 3, (number - 6) % 3};
  return {kind, axis.separation, axis.normal, number % 3, number % 3};
}

std::string box_axis_name(const SeparatingAxis& axis) {
  if (axis.kind == AxisKind::edges) return numbered(numbered("A", axis.a) + "×B", axis.b);
  return axis.kind == AxisKind::face_a ? numbered("A", axis.a) : numbered("B", axis.b);
}

std::vector<AxisIntervals> box_intervals(const BoxPair<double>& p) {
  std::vector<AxisIntervals> axes;
  const auto add = [&](AxisKind kind, std::size_t a, std::size_t b, const Vec3d& direction) {
    const double middle = dot(p.translation, direction);
    const Vec3d n = middle < 0 ? -direction : direction;
    const double reach_a = dot(abs(n), p.half_a), reach_b = dot(abs(transposed_times(p.rotation, n)), p.half_b);
    const double distance = std::abs(middle), separation = distance - reach_b - reach_a;
    axes.push_back({{kind, separation, n, a, b}, -reach_a, reach_a, distance - reach_b, distance + reach_b});
  };
  for (std::size_t i = 0; i < 3; ++i) add(AxisKind::face_a, i, i, detail::unit_axis<double>(i));
  for (std::size_t j = 0; j < 3; ++j) add(AxisKind::face_b, j, j, p.rotation.column(j));
  any_of_three([&](auto i) {
    const BoxEdgeAxes<double> edges = box_edges<i>(BoxRows<double>(p));
    for (int j = 0; j < 3; ++j) {
      BoxAxis<double> axis = detail::no_axis<double>();
      keep_edge<i>(edges, j, axis);
      if (axis.normal != Vec3d{}) add(AxisKind::edges, i, static_cast<std::size_t>(j), axis.normal);  // not parallel
    }
    return false;
  });
  return axes;
}

std::vector<AxisIntervals> polyhedra_intervals(const Polyhedron& a, const Polyhedron& b) {
  std::vector<AxisIntervals> axes;
  for (const SeparatingAxis& axis : all_separating_axes(a, b)) {
    const Vec3d& n = axis.normal;
    axes.push_back(
        {axis, lowest(a.vertices(), n), -lowest(a.vertices(), -n), lowest(b.vertices(), n), -lowest(b.vertices(), -n)});
  }
  return axes;
}

}  // namespace

PlacedFace box_face(const Vec3d& half, const Vec3d& direction) {
  const Vec3d a = abs(direction);
  PlacedFace face;
  if (a.x >= a.y && a.x >= a.z)
    box_face_across<0>(half, direction, face);
  else if (a.y >= a.z)
    box_face_across<1>(half, direction, face);
  else
    box_face_across<2>(half, direction, face);
  return face;
}

template <class T>
bool has_separating_axes(const Shape<T>& a, const Shape<T>& b) {
  if (as_box(a) && as_box(b)) return true;
  const std::size_t edges = Polyhedron::edge_count(a);
  return edges > 0 && edges * Polyhedron::edge_count(b) - 1 < most_edge_pairs;
}

template <class T>
std::optional<BoxPair<double>> as_boxes(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a) {
  const Box<T>*box_a = as_box(a), *box_b = as_box(b);
  if (!box_a || !box_b) return std::nullopt;
  return BoxPair<double>{converted<double>(box_a->half_extents()), converted<double>(box_b->half_extents()),
                         b_in_a.translation, rotation_matrix(b_in_a.rotation)};
}

template <class T>
PolyhedralPair<T>::PolyhedralPair(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a)
    : shape_a_(a), shape_b_(b), b_in_a_(b_in_a), boxes_(as_boxes(a, b, b_in_a)) {
  if (boxes_) return;
  if constexpr (std::is_same_v<T, float>) {
    if (have_facets(a, b)) {
      facets_a_.emplace(a);
      facets_b_.emplace(b);
      return;
    }
  }
  set_polyhedra(a_.emplace(), b_.emplace());
}

template <class T>
void PolyhedralPair<T>::set_polyhedra(Polyhedron& a, Polyhedron& b) const {
  a.set(shape_a_);
  b.set(shape_b_, rotation_matrix(b_in_a_.rotation), b_in_a_.translation);
}

template <class T>
std::optional<SeparatingAxes> PolyhedralPair<T>::axes(double enough) const {
  if (facets_a_) {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), hull_axes);
    const FacetedPair pair{facets_a_->view(), facets_b_->view(), rotation_matrix(b_in_a_.rotation),
                           b_in_a_.translation};
    std::optional<SeparatingAxes> axes(std::in_place);
    if (!kernel(pair, enough, *axes)) axes.reset();
    return axes;
  }
  if (!boxes_) return separating_axes(*a_, *b_, enough);
  const BoxAxes<double> axes = box_axes(*boxes_, enough);
  return SeparatingAxes{axis_of(AxisKind::face_a, axes.face_a), axis_of(AxisKind::face_b, axes.face_b),
                        axis_of(AxisKind::edges, axes.edge)};
}

template <class T>
SeparatingAxes PolyhedralPair<T>::all_axes() const {
  constexpr double all = std::numeric_limits<double>::infinity();
  if (boxes_) return *axes(all);
  Polyhedron a, b;
  set_polyhedra(a, b);
  return separating_axes(a, b, all);
}

template <class T>
std::vector<AxisIntervals> PolyhedralPair<T>::intervals() const {
  if (boxes_) return box_intervals(*boxes_);
  Polyhedron a, b;
  set_polyhedra(a, b);
  return polyhedra_intervals(a, b);
}

template <class T>
std::string PolyhedralPair<T>::name(const SeparatingAxis& axis) const {
  return boxes_ ? box_axis_name(axis) : axis_name(axis);
}

template <class T>
PlacedFace PolyhedralPair<T>::face_a(const Side<T>& side, const Vec3d& normal) const {
  if (facets_a_) return side.face(normal, true);
  return boxes_ ? box_face(boxes_->half_a, normal) : a_->support_face(normal);
}

template <class T>
PlacedFace PolyhedralPair<T>::face_b(const Side<T>& side, const Vec3d& normal) const {
  if (facets_a_) return side.face(-normal, true);
  if (!boxes_) return b_->support_face(-normal);
  PlacedFace face = box_face(boxes_->half_b, -transposed_times(boxes_->rotation, normal));
  for (Vec3d& v : face.vertices) v = boxes_->rotation * v + boxes_->translation;
  return face;
}

template class PolyhedralPair<float>;
template class PolyhedralPair<double>;
template bool has_separating_axes(const Shape<float>&, const Shape<float>&);
template bool has_separating_axes(const Shape<double>&, const Shape<double>&);
template std::optional<BoxPair<double>> as_boxes(const Shape<float>&, const Shape<float>&, const Posed&);
template std::optional<BoxPair<double>> as_boxes(const Shape<double>&, const Shape<double>&, const Posed&);

}  // namespace graze
