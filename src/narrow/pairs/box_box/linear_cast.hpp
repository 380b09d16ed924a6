// Box against box moving without turning: the ray from the origin against their Minkowski difference, whose facets are
// all normal to one of the fifteen axes, is clipped by one slab an axis (Kay, Kajiya 1986, "Ray tracing complex
// scenes").
//
// Guarantee: until the returned time some axis separates the boxes by at least the given gap; where that time is
// infinite, the axes prove it.
#pragma once

#include <optional>

#include "narrow/pairs/box_box/distance.hpp"

namespace graze {

struct BoxTranslation {
  double t;                                    ///< infinity when the boxes stay apart throughout
  std::optional<CoreDistance<double>> impact;  ///< witness points at that time, where the axis gives them
};

namespace detail {

/// The interval of time in which no axis separates the boxes.
class SlabClip {
 public:
  SlabClip(double gap, double duration) : gap_(gap), end_(duration) {}

  /// Clips by an axis of squared length `squared` along which the centres are `middle` apart and move by `pace`, the
  /// boxes being `reach` wide from centre to centre.
  void clip(double middle, double pace, double reach, double squared, int number) {
    const double rate = std::abs(pace), against = pace > 0 ? -middle : middle;
    if (!(rate > 0)) {
      if (std::abs(middle) > reach + gap_) begin_ = std::numeric_limits<double>::infinity();
      return;
    }
    const double scale = 1 / rate;
    // An end later than the exact one by less than the time to cross the gap, since no axis is longer than a unit
    // vector: saves the square root.
    end_ = least(end_, (against + reach + gap_) * scale);
    if ((against - reach) * scale <= begin_) return;
    const double norm = squared == 1 ? 1 : std::sqrt(squared), enters = (against - reach - gap_ * norm) * scale;
    if (enters <= begin_) return;
    begin_ = enters;
    number_ = number;
  }
  bool never() const { return begin_ > end_; }
  /// Whether some axis separates the boxes at time 0.
  bool apart() const { return number_ >= 0; }
  double begin() const { return begin_; }
  int number() const { return number_; }

 private:
  double gap_, begin_ = 0, end_;
  int number_ = -1;
};

/// The separation of the boxes in their present poses along the axis with this number.
inline double separation_along(const BoxPair<double>& p, int number) {
  const auto k = static_cast<std::size_t>(number);
  Vec3d n = k < 3 ? unit_axis<double>(k) : p.rotation.column(k % 3);
  if (k >= 6) n = unit(cross(unit_axis<double>((k - 6) / 3), n));
  const double middle = dot(p.translation, n);
  const double reach = dot(abs(n), p.half_a) + dot(abs(transposed_times(p.rotation, n)), p.half_b);
  return std::abs(middle) - reach;
}

}  // namespace detail

/// The time until which B, which moves by `velocity` for `duration`, stays `gap` > 0 away from A. Nothing when no axis
/// separates them by that at the beginning. Witness points of an impact may be off their boxes by `slack`.
inline std::optional<BoxTranslation> box_translation(BoxPair<double> p, const Vec3d& velocity, double gap,
                                                     double duration, double slack) {
  const Mat3d absolute = abs(p.rotation);
  detail::SlabClip slabs(gap, duration);
  for (std::size_t i = 0; i < 3; ++i)
    slabs.clip(p.translation[i], velocity[i], p.half_a[i] + dot(absolute.row[i], p.half_b), 1, static_cast<int>(i));
  for (std::size_t j = 0; j < 3 && !slabs.never(); ++j) {
    const Vec3d axis = p.rotation.column(j);
    slabs.clip(dot(p.translation, axis), dot(velocity, axis), p.half_b[j] + dot(absolute.column(j), p.half_a), 1,
               static_cast<int>(3 + j));
  }
  const BoxRows<double> rows(p);
  any_of_three([&](auto i) {
    const BoxEdgeAxes<double> edges = box_edges<i>(rows);
    const auto squares = edges.length_squared();
    for (int j = 0; j < 3; ++j) {
      if (slabs.never()) return true;
      if (!(squares[j] > parallel_edges<double>)) continue;
      const double pace = edges.along_1[j] * velocity[(i + 1) % 3] + edges.along_2[j] * velocity[(i + 2) % 3];
      slabs.clip(edges.middle[j], pace, edges.reach[j], squares[j], static_cast<int>(6 + 3 * i) + j);
    }
    return false;
  });
  if (slabs.never()) return BoxTranslation{std::numeric_limits<double>::infinity(), std::nullopt};
  if (!slabs.apart()) return std::nullopt;
  p.translation += velocity * slabs.begin();
  const BoxNearest<double> impact =
      along_axis(p, static_cast<double>(slabs.number()), detail::separation_along(p, slabs.number()), slack);
  return BoxTranslation{slabs.begin(), impact.proven ? std::optional(impact.core) : std::nullopt};
}

}  // namespace graze
