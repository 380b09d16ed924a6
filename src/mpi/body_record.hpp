// A body on its way from rank to rank.
//
// Guarantee: a body arrives with the same bits. Shapes that are plain values are sent as they are; shapes with data of
// their own, or with a user's code, are sent as the number by which all ranks share them.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "graze/error.hpp"
#include "graze/mpi/world.hpp"

namespace graze::mpi {

/// Whether a shape of this class is a plain value.
template <class C>
constexpr bool goes_as_it_is = std::is_trivially_copyable_v<C>;

template <class T, std::size_t... i>
constexpr std::size_t largest_value(std::index_sequence<i...>) {
  std::size_t largest = 0;
  const auto look = [&]<class C>(std::type_identity<C>) {
    if (goes_as_it_is<C> && sizeof(C) > largest) largest = sizeof(C);
  };
  (look(std::type_identity<std::variant_alternative_t<i, ShapeList<T>>>{}), ...);
  return largest;
}

template <class T>
struct BodyRecord {
  Key key;
  Pose<T> pose;
  Vec3<T> linear, angular;
  Filter filter;
  T rounding;
  float cost;
  std::uint64_t shared;  ///< number of a shared shape, where it is one
  std::uint32_t type;    ///< place in `ShapeList`
  std::uint8_t fixed, trigger, fast;
  std::uint8_t reshaped;  ///< since the last update
  std::uint8_t near;      ///< only near the region: gets a place there, for the time when it comes
  alignas(16) std::byte value[largest_value<T>(std::make_index_sequence<Shape<T>::count>())];
};

/// The shapes that ranks share by number: some that all of them hold, and some that each rank gets where it needs them.
template <class T>
class SharedShapes {
 public:
  using Source = std::function<Shape<T>(std::uint64_t)>;

  void add(const Shape<T>& shape) { keep(added_++, shape); }
  void set_source(Source source) { source_ = std::move(source); }
  std::uint64_t added() const { return added_; }

  /// The shape of a number. Throws `InvalidValue` for a number that no shape has, and the errors of the source.
  const Shape<T>& operator[](std::uint64_t number) {
    const auto found = shapes_.find(number);
    if (found != shapes_.end()) return found->second;
    if (!source_) throw InvalidValue("number", "that of a shared shape", std::to_string(number));
    return keep(number, source_(number));
  }

  /// The number of a shape that shares its data with a shared one. Throws `InvalidValue`.
  std::uint64_t number_of(const Shape<T>& shape) const {
    const auto found = numbers_.find(name_of(shape));
    if (found != numbers_.end()) return found->second;
    throw InvalidValue("body.shape", "a shape that all ranks share, or one of plain numbers", shape.name());
  }

 private:
  using Name = std::tuple<std::size_t, const void*, T>;

  static Name name_of(const Shape<T>& shape) { return {shape.index(), data_of(shape), shape.rounding()}; }

  /// Keeps a shape. The first of several that are the same gives the number.
  const Shape<T>& keep(std::uint64_t number, const Shape<T>& shape) {
    numbers_.emplace(name_of(shape), number);
    return shapes_.emplace(number, shape).first->second;
  }

  static const void* data_of(const Shape<T>& shape) {
    return shape.visit([](const auto& c) -> const void* {
      using C = std::decay_t<decltype(c)>;
      if constexpr (std::is_same_v<C, UserConvex<T>>)
        return &c.function();
      else if constexpr (std::is_same_v<C, Mesh<T>>)
        return c.points().data();
      else if constexpr (std::is_same_v<C, HeightField<T>> || std::is_same_v<C, ConvexHull<T>> ||
                         std::is_same_v<C, Compound<T>>)
        return &c.data();
      else
        return nullptr;
    });
  }

  std::map<std::uint64_t, Shape<T>> shapes_;
  std::map<Name, std::uint64_t> numbers_;
  Source source_;
  std::uint64_t added_ = 0;
};

template <class T>
BodyRecord<T> record_of(Key key, const Body<T>& body, float cost, const SharedShapes<T>& shared) {
  BodyRecord<T> out{};
  out.key = key;
  out.pose = body.pose;
  out.linear = body.linear;
  out.angular = body.angular;
  out.filter = body.filter;
  out.rounding = body.shape.rounding();
  out.cost = cost;
  out.type = static_cast<std::uint32_t>(body.shape.index());
  out.fixed = body.fixed;
  out.trigger = body.trigger;
  out.fast = body.fast;
  body.shape.visit([&](const auto& c) {
    if constexpr (goes_as_it_is<std::decay_t<decltype(c)>>)
      std::memcpy(out.value, &c, sizeof c);
    else
      out.shared = shared.number_of(body.shape);
  });
  return out;
}

template <class T, std::size_t... i>
Shape<T> shape_of(const BodyRecord<T>& record, SharedShapes<T>& shared, std::index_sequence<i...>) {
  Shape<T> shape = Sphere<T>(T(0));
  const auto take = [&]<class C>(std::type_identity<C>) {
    if constexpr (goes_as_it_is<C>) {
      alignas(C) std::byte bytes[sizeof(C)];
      std::memcpy(bytes, record.value, sizeof(C));
      shape = Shape<T>(*reinterpret_cast<const C*>(bytes), record.rounding);
    } else {
      shape = shared[record.shared];
    }
  };
  ((record.type == i ? take(std::type_identity<std::variant_alternative_t<i, ShapeList<T>>>{}) : void()), ...);
  return shape;
}

template <class T>
Body<T> body_of(const BodyRecord<T>& r, SharedShapes<T>& shared) {
  return {shape_of(r, shared, std::make_index_sequence<Shape<T>::count>()),
          r.pose,
          r.linear,
          r.angular,
          r.filter,
          r.fixed != 0,
          r.trigger != 0,
          r.fast != 0};
}

}  // namespace graze::mpi
