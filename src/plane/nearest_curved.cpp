#include "plane/curved_search.hpp"

namespace graze::plane {

template <class T>
double accuracy(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  const bool users = a.kind == CoreKind::user || b.kind == CoreKind::user;
  const double epsilon = users ? double(std::numeric_limits<T>::epsilon()) : std::numeric_limits<double>::epsilon();
  const double rounding = 8 * epsilon * size + 8 * std::numeric_limits<double>::epsilon() * length(b_in_a.translation);
  return greatest(goal * size, rounding);
}

template <class T>
Nearest nearest_curved(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  return search_curved(a, b, b_in_a, size, [](const auto&...) {});
}

template double accuracy(const Core<float>&, const Core<float>&, const Pose2d&, double);
template double accuracy(const Core<double>&, const Core<double>&, const Pose2d&, double);
template Nearest nearest_curved(const Core<float>&, const Core<float>&, const Pose2d&, double);
template Nearest nearest_curved(const Core<double>&, const Core<double>&, const Pose2d&, double);

}  // namespace graze::plane
