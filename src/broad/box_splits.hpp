// The splits of boxes by which a tree of bounds is built from the top.
//
// Guarantee: both sides of every split have boxes; halvings only below `max_uneven` levels, so that the depth of a
// binary tree of such splits is at most max_uneven + log2(n) + 1.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "graze/aabb.hpp"

namespace graze {

template <class T>
class BoxSplits {
 public:
  struct Item {
    Aabb<T> box;
    std::uint32_t leaf;

    /// Halves first: the sum of two large numbers overflows.
    T center(std::size_t axis) const { return box.lower[axis] * T(0.5) + box.upper[axis] * T(0.5); }
    T size() const { return max_abs(box.extent()); }
  };

  std::vector<Item> items;

  /// Sorts the items from `begin` to `end` into two sides and returns where the second begins. There are at least two.
  /// A few items are halved at a multiple of `granule`, so that nodes get filled.
  std::uint32_t operator()(std::uint32_t begin, std::uint32_t end, unsigned depth, std::uint32_t granule) {
    Aabb<T> centers = Aabb<T>::empty();
    double sizes = 0;
    T longest(0);
    for (std::uint32_t i = begin; i < end; ++i) {
      const Item& item = items[i];
      centers = merged(centers, Vec3<T>{item.center(0), item.center(1), item.center(2)});
      longest = greatest(longest, item.size());
      sizes += static_cast<double>(item.size());
    }
    const Vec3<T> spread = centers.extent();
    const std::size_t axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    if (depth < max_uneven) {
      const T limit = greatest(static_cast<T>(long_share * sizes / (end - begin)), spread[axis] / T(4));
      if (longest > limit) {
        const std::uint32_t middle = by_size(begin, end, limit);
        if (middle != end) return middle;
      }
    }
    if (end - begin > few_items && depth < max_uneven) {
      const std::uint32_t middle = by_area(begin, end, axis, centers.lower[axis], spread[axis]);
      if (middle != begin && middle != end) return middle;
    }
    const std::uint32_t half = (end - begin) / 2, rounded = (half + granule - 1) / granule * granule;
    const std::uint32_t middle = begin + (rounded < end - begin ? rounded : half);
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const Item& a, const Item& b) { return a.center(axis) < b.center(axis); });
    return middle;
  }

 private:
  /// The depth from which on parts are halved: twice what even splits of four thousand million boxes need.
  static constexpr unsigned max_uneven = 64;
  /// The number of items up to which they are halved: that fills nodes, which is worth more than parts of less area.
  /// Measured, all pairs take a tenth longer with 64.
  static constexpr std::uint32_t few_items = 512;
  static constexpr std::size_t bins = 16;
  /// A long box has so many times the mean length, and a quarter of what all boxes span: it would make the bounds
  /// of all around it as large as itself, up to the top. Long boxes get a part of their own while they are no
  /// more than one in so many.
  static constexpr double long_share = 4;
  static constexpr std::uint32_t max_long_share = 8;

  auto at(std::uint32_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); }

  /// Puts the long items behind the others and returns where they begin; `end` if they are too many.
  std::uint32_t by_size(std::uint32_t begin, std::uint32_t end, T limit) {
    const auto is_short = [limit](const Item& item) { return !(item.size() > limit); };
    const auto count = static_cast<std::uint32_t>(std::count_if(at(begin), at(end), is_short));
    if (count == 0 || end - begin - count > (end - begin) / max_long_share) return end;
    std::partition(at(begin), at(end), is_short);
    return begin + count;
  }
  /// The split at which the areas of both sides, each times its boxes, sum to the least, of sixteen places (Wald 2007,
  /// "On fast construction of SAH-based bounding volume hierarchies"). `begin` or `end` if there is none.
  std::uint32_t by_area(std::uint32_t begin, std::uint32_t end, std::size_t axis, T low, T spread) {
    // Products with this factor are less than `bins` by more than their rounding.
    const T scale = static_cast<T>(bins) * (T(1) - T(4) * std::numeric_limits<T>::epsilon()) / spread;
    if (!(scale <= std::numeric_limits<T>::max())) return begin;
    const auto bin_of = [&](const Item& item) {
      return std::min(static_cast<std::size_t>((item.center(axis) - low) * scale), bins - 1);
    };
    struct Bin {
      Aabb<T> bounds = Aabb<T>::empty();
      std::uint32_t count = 0;
      void add(const Aabb<T>& box, std::uint32_t n) {
        bounds = merged(bounds, box);
        count += n;
      }
      double cost() const {
        return surface_area(Aabb<double>{converted<double>(bounds.lower), converted<double>(bounds.upper)}) * count;
      }
    };
    std::array<Bin, bins> bin;
    for (std::uint32_t i = begin; i < end; ++i) bin[bin_of(items[i])].add(items[i].box, 1);
    std::array<double, bins> above{};
    Bin sum;
    for (std::size_t i = bins; i-- > 1;) {
      sum.add(bin[i].bounds, bin[i].count);
      above[i] = sum.count > 0 ? sum.cost() : 0;
    }
    sum = {};
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t i = 0; i + 1 < bins; ++i) {
      sum.add(bin[i].bounds, bin[i].count);
      if (sum.count == 0 || sum.count == end - begin) continue;
      const double cost = sum.cost() + above[i + 1];
      if (cost < least) {
        least = cost;
        best = i + 1;
      }
    }
    if (best == 0) return begin;
    const auto middle = std::partition(at(begin), at(end), [&](const Item& item) { return bin_of(item) < best; });
    return static_cast<std::uint32_t>(middle - items.begin());
  }
};

}  // namespace graze
