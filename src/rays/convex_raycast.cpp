#include "rays/convex_raycast.hpp"

#include "rays/convex.hpp"

namespace graze {

template <class T>
rays::MaybeHit convex_raycast(const Shape<T>& shape, const rays::LocalRay& ray, BackFaces back) {
  return shape.visit([&](const auto& c) -> rays::MaybeHit {
    using C = std::decay_t<decltype(c)>;
    if constexpr (BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>)
      return rays::hit_convex(c, shape.rounding(), ray, back);
    else
      return {};
  });
}

template rays::MaybeHit convex_raycast(const Shape<float>&, const rays::LocalRay&, BackFaces);
template rays::MaybeHit convex_raycast(const Shape<double>&, const rays::LocalRay&, BackFaces);

}  // namespace graze
