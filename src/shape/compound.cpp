#include "shape/compound_data.hpp"
#include "shape/hierarchy_pairs.hpp"
#include "shape/placed_bounds.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace {

constexpr std::size_t few_children = 256;

template <class T>
bool finite(const Aabb<T>& box) {
  return max_abs(box.lower) < std::numeric_limits<T>::infinity() &&
         max_abs(box.upper) < std::numeric_limits<T>::infinity();
}

}  // namespace

template <class T>
Compound<T>::Compound(std::vector<Placed<T>> children) {
  if (children.empty()) throw InvalidValue("children", "at least one child", "none");
  auto data = std::make_shared<CompoundData<T>>();
  std::vector<TreePiece<T>> pieces;
  for (std::uint32_t i = 0; i < children.size(); ++i) {
    Placed<T>& child = children[i];
    const std::string path = "children[" + std::to_string(i) + "]";
    validate::point(child.pose.translation, path + ".translation");
    child.pose.translation = validate::resolved(child.pose.translation);
    child.pose.rotation = validate::rotation(child.pose.rotation, path + ".rotation");

    const T reach = length(child.pose.translation) + rounding_radius(child.shape) +
                    child.shape.visit([](const auto& c) { return c.core_extent(); });
    // The reaches of compounds within compounds add up.
    constexpr T furthest = T(8) * largest_magnitude<T>;
    if (!(reach <= furthest))
      validate::fail(path, "a child that reaches at most " + validate::number(static_cast<double>(furthest)),
                     static_cast<double>(reach));
    data->extent = greatest(data->extent, reach);
    data->nesting.add_child(bounded_nesting<Compound<T>>(child, path));
    if (const auto* mesh = child.shape.template as<Mesh<T>>()) data->solid = data->solid || mesh->solid();
    if (const auto* inner = child.shape.template as<Compound<T>>()) data->solid = data->solid || inner->data().solid;
    data->boxes.push_back(bounds(child.shape, child.pose));
    if (finite(data->boxes[i]))
      pieces.push_back({data->boxes[i], i});
    else
      data->unbounded.push_back(i);
  }
  data->children = std::move(children);
  data->tree = WideTree<T>(std::move(pieces));
  data_ = std::move(data);
}

template <class T>
std::span<const Placed<T>> Compound<T>::children() const {
  return data_->children;
}
template <class T>
T Compound<T>::core_extent() const {
  return data_->extent;
}
template <class T>
Aabb<T> Compound<T>::core_bounds(const Pose<T>& pose) const {
  const auto placed = [&](std::uint32_t i) {
    const Placed<T>& child = data_->children[i];
    return bounds(child.shape, compose(pose, child.pose));
  };
  // Each child is visited once, since a compound among them visits its own in turn; of very many, the boxes have to do.
  Aabb<T> all = Aabb<T>::empty();
  if (data_->tree.size() <= few_children) {
    for (std::uint32_t i = 0; i < data_->children.size(); ++i) all = merged(all, placed(i));
    return all;
  }
  const TurnedBoxes<T> turned(pose, data_->tree.bounds());
  all = placed_bounds(data_->tree, pose, [&](std::uint32_t i) { return turned(data_->boxes[i]); });
  for (const std::uint32_t i : data_->unbounded) all = merged(all, placed(i));
  return all;
}

template class Compound<float>;
template class Compound<double>;

}  // namespace graze
