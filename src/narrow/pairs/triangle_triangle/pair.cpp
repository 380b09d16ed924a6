#include "narrow/pairs/triangle_triangle/pair.hpp"

#include "narrow/alike_order.hpp"
#include "narrow/batch/box_batch.hpp"
#include "narrow/general_contacts.hpp"
#include "narrow/manifold/polygon.hpp"
#include "narrow/pairs/triangle_triangle/contacts.hpp"

namespace graze {

namespace {

/// The support face of a triangle along a direction, as `Polyhedron::support_face` has it: either side of it; seen from
/// the side, the edge at the highest corner that falls off least, or the corner.
PlacedFace face_along(const Vec3d (&point)[3], const Vec3d& direction) {
  PlacedFace face;
  const auto push = [&](std::uint32_t i) {
    face.vertices.push_back(point[i]);
    face.ids.push_back(i);
  };
  const double facing = dot(unit(cross(point[1] - point[0], point[2] - point[0])), direction);
  if (std::abs(facing) >= furthest_lean) {
    face.id = facing > 0 ? 0 : 1;
    for (std::uint32_t i = 0; i < 3; ++i) push(facing > 0 ? i : 2 - i);
    return face;
  }
  const auto top = static_cast<std::uint32_t>(detail::furthest(point, 3, direction));
  double least_fall = 1 - furthest_lean;
  std::uint32_t other = top;
  for (std::uint32_t first = 0; first < 3; ++first) {
    const std::uint32_t second = first == 2 ? 0 : first + 1;
    if (first != top && second != top) continue;
    const std::uint32_t end = first == top ? second : first;
    const Vec3d along = point[top] - point[end];
    const double fall = dot(along, direction) / length(along);
    if (fall > least_fall) continue;
    least_fall = fall;
    other = end;
  }
  push(std::min(top, other));
  if (other != top) push(std::max(top, other));
  return face;
}

/// The contacts by the general path's clipping, from the axes and the distance.
template <class T>
void contacts_by_faces(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                       const TriangleAxes<double>& axes, const Distance<T>& d, Manifold<T>& manifold) {
  const PlacedTriangle<double> placed_a = placed_triangle(a), placed_b = placed_triangle(b);
  const TriangleAxis<double>&face = axes.face, &edge = axes.edge;
  const AxisChoice<double> choice = choose_axis(face.separation, edge.separation, axes.noise, axes.smaller);
  const double separation = choice.separation, apart = separation - placed_a.radius - placed_b.radius;
  const Posed frame = in_double(a.pose), b_in_a = relative(frame, in_double(b.pose));
  const Mat3d turn_b = rotation_matrix(b_in_a.rotation);
  const Vec3d normal = unit(rotate(conjugate(frame.rotation), choice.edge_chosen ? edge.normal : face.normal));
  Vec3d points_b[3];
  for (std::size_t i = 0; i < 3; ++i) points_b[i] = turn_b * placed_b.core.point[i] + b_in_a.translation;
  const MeetingFaces faces{normal,
                           face_along(placed_a.core.point, normal),
                           face_along(points_b, -normal),
                           choice.edge_chosen == choice.edge_best,
                           std::abs(apart) <= axes.noise ? 0 : apart,
                           separation > axes.noise,
                           axes.noise};
  contacts_of_faces(Shape<T>(a.shape, a.rounding()), a.pose, Shape<T>(b.shape, b.rounding()), b.pose, margin, faces, d,
                    manifold);
}

/// The answer of the kernel about two triangles.
struct KernelContacts {
  TriangleDistance<double> found;
  TriangleAxes<double> axes;
  ContactSlots<double> points;
};

template <class T>
KernelContacts kernel_contacts(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), triangle_pair_contact);
  KernelContacts answer;
  const auto up_to = static_cast<double>(margin);
  kernel(placed_triangle(a), placed_triangle(b), before_rounding<T>(up_to), up_to, answer_rounding<T>(), answer.found,
         answer.axes, answer.points);
  return answer;
}

/// The axes for the shapes in reverse order.
TriangleAxes<double> mirrored_axes(TriangleAxes<double> axes) {
  axes.face.normal = -axes.face.normal;
  axes.edge.normal = -axes.edge.normal;
  return axes;
}

}  // namespace

template <class T>
std::optional<T> triangle_pair_contacts(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                        Manifold<T>& manifold) {
  const auto [found, axes, points] = kernel_contacts(a, b, margin);
  if (!found.proven) return std::nullopt;
  const Distance<T> d = rounded<T>(found.at);
  manifold.normal = d.normal;
  if (d.distance > margin) return d.distance;
  if (points.known != 0) {
    manifold.normal = converted<T>(points.normal);
    const auto slot = [&points = points](std::size_t i) {
      const ContactSlot<double> of = points.slot(i);
      return ContactSlot<T>{converted<T>(of.a), converted<T>(of.b), static_cast<T>(of.distance),
                            static_cast<T>(of.part_a), static_cast<T>(of.part_b)};
    };
    take_points<T>(static_cast<unsigned>(points.filled), slot, triangle_features, triangle_features, manifold.points,
                   IsDeeperTilted());
    return d.distance;
  }

  const Shape<T> whole_a(a.shape, a.rounding()), whole_b(b.shape, b.rounding());
  if (!stands_second(whole_a, a.pose, whole_b, b.pose)) {
    contacts_by_faces(a, b, margin, axes, d, manifold);
    return d.distance;
  }
  TriangleAxes<double> back = mirrored_axes(axes);
  // Rounding takes another of two equally good axes in the other order, which is the one that counts.
  if (std::abs(axes.face.separation - axes.edge.separation) <= axes.noise) back = kernel_contacts(b, a, margin).axes;
  contacts_by_faces(b, a, margin, back, mirrored(d), manifold);
  mirror(manifold);
  return d.distance;
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::optional<T> triangle_pair_contacts(const InPlace<Triangle<T>, T>&, const InPlace<Triangle<T>, T>&, T,  \
                                                   Manifold<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
