// A value of one of several kinds of shapes, and its rounding: what shapes of space and of the plane have in common.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "graze/detail/standard.hpp"

namespace graze {

/// A shape of one of the kinds in `List`, a `std::variant`, with its rounding radius.
template <class List, class T>
class ListedShape {
 public:
  static constexpr std::size_t count = std::variant_size_v<List>;  ///< number of kinds

  /// The index of a kind in the list.
  template <class C>
  static constexpr std::size_t index_of() {
    return []<std::size_t... I>(std::index_sequence<I...>) {
      std::size_t place = 0;
      static_cast<void>(((place = I, std::is_same_v<std::variant_alternative_t<I, List>, C>) || ...));
      return place;
    }
    (std::make_index_sequence<count>());
  }

  /// The rounding radius: that of the ball, in the plane the disc, in the Minkowski sum.
  T rounding() const { return rounding_; }
  /// The kind of the shape: its index in the list.
  std::size_t index() const { return list_.index(); }
  /// The name of the kind in files and messages.
  const char* name() const {
    return visit([](const auto& c) { return std::decay_t<decltype(c)>::name; });
  }

  /// The shape as `C`, or null when it is of another kind.
  template <class C>
  const C* as() const {
    return std::get_if<C>(&list_);
  }
  /// Calls `f` with the shape as an object of the class of its kind.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return visit_from<0>(std::forward<F>(f));
  }

 protected:
  template <class C>
  ListedShape(C concrete, T rounding) : list_(std::move(concrete)), rounding_(rounding) {}

 private:
  /// A chain of comparisons that compilers turn into one jump, where `std::visit` calls through a table.
  template <std::size_t I, class F>
  decltype(auto) visit_from(F&& f) const {
    if constexpr (I + 1 == count) {
      return f(*std::get_if<I>(&list_));
    } else {
      if (list_.index() == I) return f(*std::get_if<I>(&list_));
      return visit_from<I + 1>(std::forward<F>(f));
    }
  }

  List list_;
  T rounding_;
};

}  // namespace graze
