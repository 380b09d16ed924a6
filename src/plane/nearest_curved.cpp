#include "plane/curved_search.hpp"

namespace graze::plane {

namespace {

/// Whether a core is made of discs, points among them, and what lies between these.
template <class T>
bool has_discs(const Core<T>& core) {
  return core.kind == CoreKind::polygon || core.kind == CoreKind::tapered;
}

/// The centre of the disc that a support point lies on.
template <class T>
Vec2d disc_center(const Core<T>& core, std::uint32_t feature) {
  if (core.kind == CoreKind::polygon) return core.vertex(vertex_of(core, feature));
  return {0, feature == vertex_feature(0) ? -core.half_height : core.half_height};
}

/// Nearest points whose normal was searched for, and is right within the root of the goal only, with the one that leads
/// from the middle of one disc to that of the other, if they are these discs'. The signed distance of convex shapes is
/// the largest of their gaps along all normals, so that one is right which leaves no less.
template <class T>
Nearest with_disc_normal(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, const Nearest& found) {
  const Vec2d way = transform(b_in_a, disc_center(b, found.b.feature)) - disc_center(a, found.a.feature);
  Nearest exact;
  exact.normal = normalized(way, found.normal);
  exact.a = support(a, exact.normal);
  exact.b = support(b, inverse_rotate(b_in_a.rotation, -exact.normal));
  exact.b.point = transform(b_in_a, exact.b.point);
  exact.distance = dot(exact.b.point - exact.a.point, exact.normal);
  const bool same = exact.a.feature == found.a.feature && exact.b.feature == found.b.feature;
  return same && exact.distance >= found.distance - accuracy(a, b, b_in_a, size) - found.error ? exact : found;
}

}  // namespace

template <class T>
double accuracy(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  const bool users = a.kind == CoreKind::user || b.kind == CoreKind::user;
  const double epsilon = users ? double(std::numeric_limits<T>::epsilon()) : std::numeric_limits<double>::epsilon();
  const double rounding = 8 * epsilon * size + 8 * std::numeric_limits<double>::epsilon() * length(b_in_a.translation);
  return greatest(goal * size, rounding);
}

template <class T>
Nearest nearest_curved(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  const Nearest found = search_curved(a, b, b_in_a, size, [](const auto&...) {});
  return has_discs(a) && has_discs(b) ? with_disc_normal(a, b, b_in_a, size, found) : found;
}

template double accuracy(const Core<float>&, const Core<float>&, const Pose2d&, double);
template double accuracy(const Core<double>&, const Core<double>&, const Pose2d&, double);
template Nearest nearest_curved(const Core<float>&, const Core<float>&, const Pose2d&, double);
template Nearest nearest_curved(const Core<double>&, const Core<double>&, const Pose2d&, double);

}  // namespace graze::plane
