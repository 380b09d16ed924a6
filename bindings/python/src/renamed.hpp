// The names of arguments in the errors of shapes, which are C++'s where Python's differ.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "graze/error.hpp"

namespace graze::python {

/// The beginning of a path in an error, and what an argument of Python is called in its place.
struct Renamed {
  std::string_view from, to;
};

/// The names of a shape with two radii along Y.
inline constexpr Renamed tapered_names[] = {{"radiusBottom", "radius"}, {"radiusTop", "radius_top"}};
/// The names of shapes made of corners.
inline constexpr Renamed corner_names[] = {{"points[0]", "a"}, {"points[1]", "b"}, {"points[2]", "c"}};

/// The result of `make`, whose errors name values as Python does.
template <std::size_t count, class Make>
auto renamed(const Renamed (&names)[count], const Make& make) {
  try {
    return make();
  } catch (const InvalidValue& error) {
    for (const Renamed& name : names)
      if (std::string_view(error.path()).substr(0, name.from.size()) == name.from)
        throw InvalidValue(std::string(name.to) + error.path().substr(name.from.size()), error.expectation(),
                           error.found());
    throw;
  }
}

}  // namespace graze::python
