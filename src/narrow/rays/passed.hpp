// Which of a few triangles a ray passes for certain, side by side and in the triangles' own scalar.
//
// Guarantee: a triangle that `crossing` finds crossed, or seen edge-on, is never said to be passed. What is not passed is
// left to `crossing`: that is one triangle in a leaf, rarely two.
#pragma once

#include "narrow/rays/sheared.hpp"
#include "shape/tree_ray.hpp"

namespace graze::rays {

template <class T>
class PassedFilter {
 public:
  static constexpr std::size_t lanes = 16 / sizeof(T);

  /// For triangles within `extent` of the frame's origin.
  PassedFilter(const Sheared& sheared, double extent) {
    for (std::size_t i = 0; i < 3; ++i) {
      axis_[i] = sheared.axis(i);
      origin_[i] = static_cast<T>(sheared.origin()[axis_[i]]);
    }
    shear_x_ = static_cast<T>(sheared.shear().x);
    shear_y_ = static_cast<T>(sheared.shear().y);
    // A coordinate of the frame is off by half an epsilon of M, the sum below, for the origin, its difference and the last
    // one (twice the size), and twice the first two and two more along z: less than 5 epsilon M with the 1e-16 of doubles.
    constexpr double off = 8 * static_cast<double>(std::numeric_limits<T>::epsilon());
    off_ = static_cast<T>(off * (extent + max_abs(sheared.origin())));
  }

  /// One bit a triangle that may be crossed, of up to `lanes` from the place `first` in the tree's order on.
  template <class Mesh>
  [[gnu::always_inline]] std::uint32_t left(const Mesh& mesh, std::size_t first, std::size_t count) const {
    Lane x[3], y[3];
    const std::uint32_t* corners[lanes];
    for (std::size_t i = 0; i < lanes; ++i) corners[i] = mesh.corners[first + least(i, count - 1)].data();
    Lane size(T(0));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto coordinate = [&](std::size_t axis) {
        const auto of = [&](std::size_t i) { return mesh.points[corners[i][k]][axis_[axis]]; };
        if constexpr (lanes == 4)
          return Lane::of(typename Lane::Vector{of(0), of(1), of(2), of(3)}) - Lane(origin_[axis]);
        else
          return Lane::of(typename Lane::Vector{of(0), of(1)}) - Lane(origin_[axis]);
      };
      const Lane z = coordinate(2);
      x[k] = coordinate(0) - Lane(shear_x_) * z;
      y[k] = coordinate(1) - Lane(shear_y_) * z;
      size = larger<T>(size, larger<T>(abs(x[k]), abs(y[k])));
    }
    const auto side = [&](std::size_t p, std::size_t q) { return x[q] * y[p] - y[q] * x[p]; };
    const Lane u = side(1, 2), v = side(2, 0), w = side(0, 1);
    // With coordinates off by e and of size s, a difference of two products is off by 4 e s + 2 e e, and by its own
    // roundings, 2 epsilon s s <= e s since s is at most 2 M; where they underflow,
    // by less than the least normal number.
    const Lane off = Lane(T(8) * off_) * (size + Lane(off_)) + Lane(std::numeric_limits<T>::min());
    const auto passed = (lesser<T>(u, lesser<T>(v, w)) < -off) & (larger<T>(u, larger<T>(v, w)) > off);
    return ~bits_of<T>(passed) & ((1u << count) - 1);
  }

 private:
  using Lane = RayLanes<T>;
  std::size_t axis_[3];
  T origin_[3], shear_x_, shear_y_, off_;
};

}  // namespace graze::rays
