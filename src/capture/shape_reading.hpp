// The parts that readers of shapes share: numbers, lists, compounds, and the choice of the kind.
#pragma once

#include <variant>

#include "capture/shape_bytes.hpp"

namespace graze::capture {

template <class V>
std::vector<V> copied(std::span<const V> values) {
  return {values.begin(), values.end()};
}

template <class T>
class ShapeReading {
 public:
  ShapeReading(Reading& io, int depth) : io_(io), depth_(depth) {}

 protected:
  template <class V = T>
  V number() {
    V value{};
    io_(value);
    return value;
  }
  template <class V>
  std::vector<V> list(std::size_t least_bytes) {
    std::vector<V> values;
    fields(io_, values, least_bytes);
    return values;
  }
  template <class Child, class AnyShape, class AnyPose>
  std::vector<Child> children() {
    if (depth_ == deepest_compound) throw Damaged{"compounds within compounds without an end"};
    const auto count = number<std::uint64_t>();
    if (count > io_.left()) throw Damaged{"more children than it has bytes for"};
    std::vector<Child> all;
    for (std::uint64_t i = 0; i < count; ++i) {
      AnyShape child = read_shape<AnyShape>(io_, depth_ + 1);
      all.push_back({std::move(child), number<AnyPose>()});
    }
    return all;
  }

  Reading& io_;
  int depth_;
};

/// The shape of the kind with that number in `List`, by `one.concrete` of its type.
template <class AnyShape, class List, std::size_t I = 0, class One, class T>
AnyShape shape_of_kind(std::size_t kind, T rounding, One& one) {
  if constexpr (I < std::variant_size_v<List>) {
    using Concrete = std::variant_alternative_t<I, List>;
    if (kind == I) return AnyShape(one.concrete(std::type_identity<Concrete>{}), rounding);
    return shape_of_kind<AnyShape, List, I + 1>(kind, rounding, one);
  } else {
    throw Damaged{"a shape of no kind"};
  }
}

}  // namespace graze::capture
