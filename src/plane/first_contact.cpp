#include "plane/first_contact.hpp"

#include "plane/straight_contact.hpp"

namespace graze::plane {

template <class T>
bool surely_apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double near) {
  const double radius = a.radius + b.radius + near;
  bool apart = a.count == 1 && b.count == 1 &&
               length_squared(a.vertex(0) - transform(b_in_a, b.vertex(0))) * (1 - 0x1p-40) > radius * radius;
  for_each_difference_edge(a, b, b_in_a,
                           [&](const DifferenceEdge& e) { apart = apart || surely_above(e.start, e.edge, radius); });
  return apart;
}

template <class T>
std::optional<FirstContact> contact_of_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                                const Vec2d& velocity, double duration, double size) {
  return straight_contact(a, b, b_in_a, velocity, duration, size);
}

template bool surely_apart(const Core<float>&, const Core<float>&, const Pose2d&, double);
template bool surely_apart(const Core<double>&, const Core<double>&, const Pose2d&, double);
template std::optional<FirstContact> contact_of_polygons(const Core<float>&, const Core<float>&, const Pose2d&,
                                                         const Vec2d&, double, double);
template std::optional<FirstContact> contact_of_polygons(const Core<double>&, const Core<double>&, const Pose2d&,
                                                         const Vec2d&, double, double);

}  // namespace graze::plane
