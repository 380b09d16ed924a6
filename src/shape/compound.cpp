#include "graze/shape.hpp"

namespace graze {

namespace {

/// From the compound's origin.
template <class T>
T reach_of(const Placed<T>& child) {
  const T reach = child.shape.visit([](const auto& c) { return c.core_extent(); }) + child.shape.margin();
  return length(child.pose.translation) + reach;
}

}  // namespace

template <class T>
Compound<T>::Compound(std::vector<Placed<T>> children) {
  if (children.empty()) throw InvalidValue("children", "at least one child", "none");
  for (std::size_t i = 0; i < children.size(); ++i) {
    const std::string path = "children[" + std::to_string(i) + "]";
    validate::point(children[i].pose.translation, path + ".translation");
    children[i].pose.rotation = validate::rotation(children[i].pose.rotation, path + ".rotation");
    // One in another in another adds up.
    constexpr T furthest = T(8) * largest_magnitude<T>;
    const T reach = reach_of(children[i]);
    if (!(reach <= furthest))
      validate::fail(path, "a child that reaches at most " + validate::number(static_cast<double>(furthest)),
                     static_cast<double>(reach));
  }
  children_ = std::make_shared<const std::vector<Placed<T>>>(std::move(children));
}

template <class T>
std::span<const Placed<T>> Compound<T>::children() const {
  return *children_;
}
template <class T>
T Compound<T>::core_extent() const {
  T extent = T(0);
  for (const Placed<T>& child : *children_) extent = greatest(extent, reach_of(child));
  return extent;
}
template <class T>
Aabb<T> Compound<T>::core_bounds(const Pose<T>& pose) const {
  Aabb<T> all = Aabb<T>::empty();
  for (const Placed<T>& child : *children_) all = merged(all, bounds(child.shape, compose(pose, child.pose)));
  return all;
}

template class Compound<float>;
template class Compound<double>;

}  // namespace graze
