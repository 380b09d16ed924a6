// Bodies that stand close together, block by block, each with all others whose boxes its own ones overlap.
//
// Guarantee: every body of `moving` is at home in one block, once. Of two such bodies whose boxes overlap, that of the
// smaller size class, or of two of one class either, has the other one beside it. Memory besides an index a body is in
// proportion to one block and the borders of those that it was cut out of, whatever the sizes of the bodies: large ones
// have blocks of their own, beside which small ones do not stand.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "graze/aabb.hpp"

namespace graze::mpi {

/// The class of a body's size: the longest sides of the boxes of one class are within a factor of four. A body without
/// end is in the last class.
template <class T>
int size_class(const Aabb<T>& box) {
  const Vec3<T> e = box.extent();
  const T longest = greatest(e.x, greatest(e.y, e.z));
  return longest > T(0) ? std::ilogb(longest) >> 1 : std::ilogb(T(0)) >> 1;
}

/// Cuts bodies into blocks by halves, across the axis along which their boxes reach furthest.
template <class T>
class Blocks {
 public:
  /// Blocks of about `most` bodies, those beside them included.
  Blocks(std::span<const Aabb<T>> boxes, std::size_t most) : boxes_(boxes), most_(most) {}

  /// Calls `f(home, beside)` for all blocks; both are places in the boxes, in any order. At home are those of `moving`;
  /// `standing` are only beside others.
  template <class F>
  void each(std::vector<std::uint32_t> moving, const std::vector<std::uint32_t>& standing, const F& f) {
    for (auto begin = moving.begin(); begin != moving.end();) {
      int smallest = size_class(boxes_[*begin]);
      for (auto i = begin; i != moving.end(); ++i) smallest = std::min(smallest, size_class(boxes_[*i]));
      const auto end =
          std::partition(begin, moving.end(), [&](std::uint32_t i) { return size_class(boxes_[i]) == smallest; });
      const std::span<std::uint32_t> home(begin, end);
      std::vector<std::uint32_t> beside;
      const Aabb<T> around = bounds_of(home);
      add_those_in(around, standing, beside);
      add_those_in(around, {end, moving.end()}, beside);
      cut(home, std::move(beside), f);
      begin = end;
    }
  }

 private:
  /// The least gain of a cut, as a part of the bodies. Halves that have hardly fewer bodies beside them than the whole,
  /// where much overlaps everything, are of no use: cutting on would only find the same bodies again and again.
  static constexpr std::size_t least_gain = 8;

  Aabb<T> bounds_of(std::span<const std::uint32_t> some) const {
    Aabb<T> all = Aabb<T>::empty();
    for (const std::uint32_t i : some) all = {least(all.lower, boxes_[i].lower), greatest(all.upper, boxes_[i].upper)};
    return all;
  }
  void add_those_in(const Aabb<T>& box, std::span<const std::uint32_t> some, std::vector<std::uint32_t>& out) const {
    for (const std::uint32_t i : some)
      if (overlap(boxes_[i], box)) out.push_back(i);
  }

  template <class F>
  void cut(std::span<std::uint32_t> home, std::vector<std::uint32_t> beside, const F& f) {
    const std::size_t all = home.size() + beside.size();
    if (all <= most_ || home.size() < 2) return f(home, beside);
    const Vec3<T> e = bounds_of(home).extent();
    const std::size_t axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    const auto middle = home.begin() + static_cast<std::ptrdiff_t>(home.size() / 2);
    // Bodies are divided by lower corners, as sums of both corners may overflow.
    std::nth_element(home.begin(), middle, home.end(), [&](std::uint32_t i, std::uint32_t j) {
      return std::pair(boxes_[i].lower[axis], i) < std::pair(boxes_[j].lower[axis], j);
    });
    const std::span<std::uint32_t> halves[] = {{home.begin(), middle}, {middle, home.end()}};
    std::vector<std::uint32_t> others[2];
    for (std::size_t half = 0; half < 2; ++half) {
      const Aabb<T> around = bounds_of(halves[half]);
      add_those_in(around, beside, others[half]);
      add_those_in(around, halves[1 - half], others[half]);
    }
    const std::size_t larger = home.size() - home.size() / 2 + std::max(others[0].size(), others[1].size());
    if (larger > all - all / least_gain) return f(home, beside);
    beside = {};
    for (std::size_t half = 0; half < 2; ++half) cut(halves[half], std::move(others[half]), f);
  }

  std::span<const Aabb<T>> boxes_;
  std::size_t most_;
};

}  // namespace graze::mpi
