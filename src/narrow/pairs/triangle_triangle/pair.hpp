// Triangle against triangle.
//
// Guarantee: `distance`, `overlap` and `contacts` share this answer, so that they agree on touching. An answer is given
// only with its proof, see `triangle_distance`; for slivers, and where rounding hides the proof, the general path
// answers.
#pragma once

#include <limits>
#include <optional>

#include "narrow/batch/triangle_batch.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/pair.hpp"
#include "narrow/pairs/triangle_triangle/distance.hpp"

namespace graze {

template <class T>
PlacedTriangle<double> placed_triangle(const InPlace<Triangle<T>, T>& triangle) {
  const auto corner = [&](std::size_t i) { return converted<double>(triangle.shape.point(i)); };
  return {
      {{corner(0), corner(1), corner(2)}}, static_cast<double>(triangle.rounding()), converted<double>(triangle.pose)};
}

/// The contacts of a pair, see `TriangleTriangle::contacts`.
template <class T>
std::optional<T> triangle_pair_contacts(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                        Manifold<T>& manifold);

struct TriangleTriangle : PairOfKinds<Triangle, Triangle> {
  static constexpr bool overlaps_by_mpr = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b) {
    const auto found = up_to(a, b, std::numeric_limits<double>::infinity());
    if (!found.proven) return std::nullopt;
    return rounded<T>(found.at);
  }
  template <class T>
  static std::optional<bool> overlap(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b) {
    const auto found = up_to(a, b, 0);
    if (!found.proven) return std::nullopt;
    return static_cast<T>(found.at.distance) <= T(0);
  }
  /// The signed distance, or where nothing is within the margin a lower bound that exceeds it.
  template <class T>
  static std::optional<T> contacts(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b, T margin,
                                   Manifold<T>& manifold) {
    return triangle_pair_contacts(a, b, margin, manifold);
  }

  template <class T>
  static auto distance_rows() {
    return GRAZE_KERNEL(chosen_isa(), triangle_row_distances<T>);
  }
  template <class T, class Sink>
  static void visit_contacts(const PairRef<T>* pairs, std::size_t count, bool, Sink& sink) {
    visit_triangle_pair_contacts(
        pairs, count, [&](std::size_t i) { sink.apart(i); }, [&](const MetPairs<T>& met) { sink.met(met, false); },
        [&](std::size_t i) { sink.unknown(i); });
  }

 private:
  /// The distance up to `enough`, see `triangle_distance`.
  template <class T>
  static TriangleDistance<double> up_to(const InPlace<Triangle<T>, T>& a, const InPlace<Triangle<T>, T>& b,
                                        double enough) {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), triangle_pair);
    TriangleDistance<double> found;
    kernel(placed_triangle(a), placed_triangle(b), enough, found);
    return found;
  }
};

}  // namespace graze
