// Pairs whose cores have a signed distance in closed form (`core_distance`), and no form of their own for contacts.
#pragma once

#include <optional>

#include "narrow/core/point_box.hpp"
#include "narrow/core/point_point.hpp"
#include "narrow/core/point_segment.hpp"
#include "narrow/core/segment_box.hpp"
#include "narrow/core/segment_segment.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "narrow/pairs/pair.hpp"

namespace graze {

namespace detail {

template <class T, class A, class B>
Distance<T> distance_in_a(const A& core_a, T radius_a, const Pose<T>& pose_a, const B& core_b, T radius_b,
                          const Pose<T>& pose_b) {
  if constexpr (evaluated_in_double<A, B>) {
    const auto b_in_a = moved(converted<double>(core_b), relative_in_double(pose_a, pose_b));
    return finished_in_double(core_distance(converted<double>(core_a), b_in_a), radius_a, radius_b, in_double(pose_a));
  } else {
    return finished(core_distance(core_a, moved(core_b, relative(pose_a, pose_b))), radius_a, radius_b, pose_a);
  }
}

}  // namespace detail

/// The distance by the closed form of the cores, in whichever order there is one; nothing for shapes without such a
/// core, such as tapered capsules.
template <class A, class B, class T>
std::optional<Distance<T>> closed_form_distance(const InPlace<A, T>& a, const InPlace<B, T>& b) {
  if (!has_core(a.shape) || !has_core(b.shape)) return std::nullopt;
  if constexpr (requires { core_distance(core_of(a.shape), moved(core_of(b.shape), b.pose)); }) {
    return detail::distance_in_a(core_of(a.shape), a.radius(), a.pose, core_of(b.shape), b.radius(), b.pose);
  } else {
    return mirrored(detail::distance_in_a(core_of(b.shape), b.radius(), b.pose, core_of(a.shape), a.radius(), a.pose));
  }
}

template <template <class> class KindA, template <class> class KindB>
struct ClosedFormPair : PairOfKinds<KindA, KindB> {
  static constexpr bool overlaps_by_distance = true;

  template <class T>
  static std::optional<Distance<T>> distance(const InPlace<KindA<T>, T>& a, const InPlace<KindB<T>, T>& b) {
    return closed_form_distance(a, b);
  }
};

}  // namespace graze
