// The scalar that a scalar or a lane type is made of.
#pragma once

namespace graze {

template <class S>
struct LaneOf {
  using type = S;
};
template <class S>
requires requires { typename S::Lane; }
struct LaneOf<S> {
  using type = typename S::Lane;
};

}  // namespace graze
