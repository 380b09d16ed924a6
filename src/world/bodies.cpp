#include "graze/world/bodies.hpp"

#include <algorithm>
#include <string>

#include "graze/plane/space.hpp"

namespace graze {

namespace {

/// The share of bodies that changed, one in so many, from which on a pass over all of them costs
/// less than sorting those.
constexpr std::size_t many = 16;

}  // namespace

template <class T, class Space>
T BodyArrays<T, Space>::margin_of(const Shape& shape, const std::optional<T>& margin) {
  if (margin) return *margin;
  const auto box = bounds(shape, Pose{});
  // Shapes without bounds leave the margin to the other one.
  return max_abs(box.upper - box.lower) < std::numeric_limits<T>::infinity() ? contact_margin(shape, shape)
                                                                             : std::numeric_limits<T>::infinity();
}

template <class T, class Space>
std::uint32_t BodyArrays<T, Space>::checked(BodyId id) const {
  if (!contains(id)) refuse_missing("body", "a body of the world", id);
  return id.index;
}

template <class T, class Space>
void BodyArrays<T, Space>::change(std::uint32_t index) {
  ++revision_;
  if (changed_[index] == 0) changes_.push_back(index);
  changed_[index] = 1;
}

template <class T, class Space>
void BodyArrays<T, Space>::reserve(std::size_t bodies) {
  shapes_.reserve(bodies);
  poses_.reserve(bodies);
  linear_.reserve(bodies);
  angular_.reserve(bodies);
  filters_.reserve(bodies);
  margins_.reserve(bodies);
  for (auto* flags : {&alive_, &fixed_, &triggers_, &fast_, &changed_}) flags->reserve(bodies);
  generations_.reserve(bodies);
  changes_.reserve(bodies);
}

template <class T, class Space>
BodyId BodyArrays<T, Space>::add(Body<T, Space> body) {
  const Pose pose = Space::checked(body.pose);
  Space::check(body.linear, body.angular);
  const T margin = margin_of(body.shape, margin_);
  std::uint32_t index{};
  if (free_.empty()) {
    index = static_cast<std::uint32_t>(shapes_.size());
    shapes_.push_back(std::move(body.shape));
    poses_.emplace_back();
    linear_.emplace_back();
    angular_.emplace_back();
    filters_.emplace_back();
    margins_.emplace_back();
    for (auto* flags : {&alive_, &fixed_, &triggers_, &fast_, &changed_}) flags->push_back(0);
    generations_.push_back(0);
  } else {
    index = free_.back();
    free_.pop_back();
    shapes_[index] = std::move(body.shape);
  }
  poses_[index] = pose;
  linear_[index] = body.linear;
  angular_[index] = body.angular;
  filters_[index] = body.filter;
  filtered_ |= body.filter != Filter{};
  margins_[index] = margin;
  alive_[index] = 1;
  fixed_[index] = body.fixed ? 1 : 0;
  triggers_[index] = body.trigger ? 1 : 0;
  fast_[index] = body.fast ? 1 : 0;
  change(index);
  return id(index);
}

template <class T, class Space>
void BodyArrays<T, Space>::remove(BodyId id) {
  const std::uint32_t index = checked(id);
  alive_[index] = 0;
  ++generations_[index];
  shapes_[index] = Space::nothing();  // lets go of what the shape shares
  free_.push_back(index);
  change(index);
}

template <class T, class Space>
void BodyArrays<T, Space>::move(BodyId id, const Pose& pose) {
  const std::uint32_t index = checked(id);
  move(id, pose, linear_[index], angular_[index]);
}

template <class T, class Space>
void BodyArrays<T, Space>::move(BodyId id, const Pose& pose, const Vec& linear, const Turning& angular) {
  const std::uint32_t index = checked(id);
  const Pose to = Space::checked(pose);
  Space::check(linear, angular);
  linear_[index] = linear;
  angular_[index] = angular;
  put(index, to);
}

template <class T, class Space>
void BodyArrays<T, Space>::put(std::uint32_t index, const Pose& pose) {
  if (pose == poses_[index]) return;
  poses_[index] = pose;
  change(index);
}

template <class T, class Space>
void BodyArrays<T, Space>::move(std::span<const BodyId> ids, std::span<const Pose> poses, std::span<const Vec> linear,
                                std::span<const Turning> angular) {
  const auto check_length = [&](const char* path, std::size_t length) {
    if (length != ids.size())
      throw InvalidValue(path, "as many as ids, " + std::to_string(ids.size()), std::to_string(length));
  };
  check_length("poses", poses.size());
  const bool with_velocities = !linear.empty() || !angular.empty();
  if (with_velocities) {
    check_length("linear", linear.size());
    check_length("angular", angular.size());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    checked(ids[i]);
    Space::checked(poses[i]);
    if (with_velocities) Space::check(linear[i], angular[i]);
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t index = ids[i].index;
    if (with_velocities) {
      linear_[index] = linear[i];
      angular_[index] = angular[i];
    }
    put(index, Space::checked(poses[i]));
  }
}

template <class T, class Space>
void BodyArrays<T, Space>::set_shape(BodyId id, Shape shape) {
  const std::uint32_t index = checked(id);
  margins_[index] = margin_of(shape, margin_);
  shapes_[index] = std::move(shape);
  change(index);
}

template <class T, class Space>
void BodyArrays<T, Space>::set_filter(BodyId id, const Filter& filter) {
  filters_[checked(id)] = filter;
  filtered_ |= filter != Filter{};
}

template <class T, class Space>
void BodyArrays<T, Space>::set_fast(BodyId id, bool fast) {
  fast_[checked(id)] = fast ? 1 : 0;
}

template <class T, class Space>
Body<T, Space> BodyArrays<T, Space>::body(BodyId id) const {
  const std::uint32_t i = checked(id);
  return {shapes_[i],  poses_[i],      linear_[i],        angular_[i],
          filters_[i], fixed_[i] != 0, triggers_[i] != 0, fast_[i] != 0};
}

template <class T, class Space>
std::span<const std::uint32_t> BodyArrays<T, Space>::changes() {
  if (std::is_sorted(changes_.begin(), changes_.end())) return changes_;
  if (changes_.size() < changed_.size() / many) {
    std::sort(changes_.begin(), changes_.end());
    return changes_;
  }
  changes_.clear();
  for (std::uint32_t i = 0; i < changed_.size(); ++i)
    if (changed_[i] != 0) changes_.push_back(i);
  return changes_;
}

template <class T, class Space>
void BodyArrays<T, Space>::settle() {
  for (const std::uint32_t index : changes_) changed_[index] = 0;
  changes_.clear();
}

template <class T, class Space>
std::size_t BodyArrays<T, Space>::memory() const {
  const std::size_t each = sizeof(Shape) + sizeof(Pose) + sizeof(Vec) + sizeof(Turning) + sizeof(Filter) + sizeof(T) +
                           5 + sizeof(std::uint32_t);
  return shapes_.capacity() * each + (free_.capacity() + changes_.capacity()) * sizeof(std::uint32_t);
}

template class BodyArrays<float>;
template class BodyArrays<double>;
template class BodyArrays<float, plane::Space<float>>;
template class BodyArrays<double, plane::Space<double>>;

}  // namespace graze
