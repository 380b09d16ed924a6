// Shapes for a batch, of space or of the plane.
//
// Guarantee: where all shapes are of one of `Kinds`, and none is rounded, they stand in an array of that kind, of which
// less has to be read and whose pairs need not be told apart. Answers are the same either way.
#pragma once

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

namespace graze::python {

template <class Any, class... Kinds>
class ShapesOf {
 public:
  ShapesOf() = default;
  explicit ShapesOf(std::vector<Any> shapes) : all_(std::move(shapes)) {
    if (!std::get<0>(all_).empty()) static_cast<void>((narrow<Kinds>() || ...));
  }
  template <class C>
  explicit ShapesOf(std::vector<C> shapes) : all_(std::move(shapes)) {}

  std::size_t size() const {
    return std::visit([](const auto& shapes) { return shapes.size(); }, all_);
  }
  Any operator[](std::size_t i) const {
    return std::visit([i](const auto& shapes) { return Any(shapes[i]); }, all_);
  }
  /// The shapes at poses. Throws `InvalidValue` for numbers that do not match.
  template <class Bodies, class Pose>
  Bodies bodies(std::span<const Pose> poses) const {
    return std::visit([&](const auto& shapes) { return Bodies(std::span(shapes), poses); }, all_);
  }

 private:
  template <class C>
  bool narrow() {
    const std::vector<Any>& any = std::get<0>(all_);
    const auto plain = [](const Any& shape) { return shape.template as<C>() != nullptr && shape.rounding() == 0; };
    if (!std::all_of(any.begin(), any.end(), plain)) return false;
    std::vector<C> shapes;
    shapes.reserve(any.size());
    for (const Any& shape : any) shapes.push_back(*shape.template as<C>());
    all_ = std::move(shapes);
    return true;
  }

  std::variant<std::vector<Any>, std::vector<Kinds>...> all_;
};

}  // namespace graze::python
