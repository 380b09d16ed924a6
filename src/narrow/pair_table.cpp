#include "narrow/pair_table.hpp"

#include <array>
#include <optional>

#include "narrow/general.hpp"
#include "narrow/pair_list.hpp"
#include "simd/flatten.hpp"

namespace graze {

namespace {

template <class T>
struct Body {
  const Shape<T>& shape;
  const Pose<T>& pose;
};

template <class C, class T>
InPlace<C, T> in_place(const Body<T>& body) {
  return {*body.shape.template as<C>(), body.shape.rounding(), body.pose};
}

template <class T>
[[gnu::noinline]] Distance<T> general(const Body<T>& a, const Body<T>& b, T limit) {
  const T radius_a = rounding_radius(a.shape), radius_b = rounding_radius(b.shape);
  const Posed frame = in_double(a.pose), b_in_a = relative(frame, in_double(b.pose));
  const double radii = static_cast<double>(radius_a) + static_cast<double>(radius_b);
  // The limit, increased so that a distance beyond it still exceeds it when rounded to T.
  const double beyond = static_cast<double>(limit) * (1 + 2 * static_cast<double>(std::numeric_limits<T>::epsilon()));
  GeneralDistance g = general_distance(a.shape, b.shape, b_in_a, beyond + radii);
  if (g.core.distance > beyond + radii + g.noise) {  // only proven, without points
    Distance<T> d;
    d.distance = static_cast<T>(g.core.distance - radii);
    d.normal = converted<T>(rotate(frame.rotation, g.core.normal));
    return d;
  }
  // A distance within rounding of zero is zero: the shapes touch.
  if (std::abs(g.core.distance - radii) <= g.noise) g.core.distance = radii;
  Distance<T> d = finished_in_double(g.core, radius_a, radius_b, frame);
  d.error = static_cast<T>(g.error);
  // The general path rates itself by double's tolerance, whichever scalar a support function of the user's answers in.
  const double allowed = static_cast<double>(tolerance<T>) / 2 * pair_size(a.shape, b.shape);
  d.status = g.error <= allowed ? Status::converged : g.status;
  return d;
}

template <class P, class T>
using InPlaceA = InPlace<typename P::template A<T>, T>;
template <class P, class T>
using InPlaceB = InPlace<typename P::template B<T>, T>;

template <class P, class T>
concept HasDistance = requires(const InPlaceA<P, T>& a, const InPlaceB<P, T>& b) {
  P::distance(a, b);
};
template <class P, class T>
concept HasOverlap = requires(const InPlaceA<P, T>& a, const InPlaceB<P, T>& b) {
  P::overlap(a, b);
};
template <class P, class T>
concept HasFirstLook = requires(const InPlaceA<P, T>& a, const InPlaceB<P, T>& b) {
  P::may_overlap(a, b);
};

/// Whether the distance costs no more than a routine for overlap would.
template <class P>
constexpr bool overlaps_by_distance() {
  if constexpr (requires { P::overlaps_by_distance; })
    return P::overlaps_by_distance;
  else
    return false;
}

template <class P, class T>
std::optional<Distance<T>> distance_of_pair(const Body<T>& a, const Body<T>& b) {
  return P::distance(in_place<typename P::template A<T>>(a), in_place<typename P::template B<T>>(b));
}

/// The distance of a pair, written to its destination; returns whether it is known.
template <class P, class T>
GRAZE_FLATTEN bool put_distance_of_pair(const Body<T>& a, const Body<T>& b, Distance<T>& d) {
  const auto found = distance_of_pair<P>(a, b);
  if (found) put(*found, d);
  return found.has_value();
}

/// Overlap by distance, in one function with it, so that its points are not computed.
template <class P, class T>
GRAZE_FLATTEN std::optional<bool> distance_tells_overlap(const Body<T>& a, const Body<T>& b) {
  const auto found = distance_of_pair<P>(a, b);
  return found ? std::optional(found->distance <= T(0)) : std::nullopt;
}

template <class P, class T>
std::optional<bool> overlap_of_pair(const Body<T>& a, const Body<T>& b) {
  if constexpr (HasOverlap<P, T>)
    return P::overlap(in_place<typename P::template A<T>>(a), in_place<typename P::template B<T>>(b));
  else
    return distance_tells_overlap<P>(a, b);
}

template <class P, class T>
bool first_look_of_pair(const Body<T>& a, const Body<T>& b) {
  return P::may_overlap(in_place<typename P::template A<T>>(a), in_place<typename P::template B<T>>(b));
}

/// Overlap by distance, in one function with it, so that its points are not computed: by the table's distance the
/// overlap of a box and a half-space took a quarter longer.
template <class P, class T>
GRAZE_FLATTEN bool overlap_by_distance(const Body<T>& a, const Body<T>& b) {
  if (const auto found = distance_of_pair<P>(a, b)) return found->distance <= T(0);
  return general(a, b, std::numeric_limits<T>::infinity()).distance <= T(0);
}

/// The special routines of two kinds of shape; null where the general path answers for all of their values.
template <class T>
struct Routines {
  bool (*distance)(const Body<T>&, const Body<T>&, Distance<T>&) = nullptr;
  std::optional<bool> (*overlap)(const Body<T>&, const Body<T>&) = nullptr;
  bool (*overlap_by_distance)(const Body<T>&, const Body<T>&) = nullptr;
  bool (*may_overlap)(const Body<T>&, const Body<T>&) = nullptr;
};

template <class P, class T>
constexpr Routines<T> routines_of_pair() {
  Routines<T> routines;
  if constexpr (HasDistance<P, T>) routines.distance = &put_distance_of_pair<P, T>;
  if constexpr (overlaps_by_distance<P>())
    routines.overlap_by_distance = &overlap_by_distance<P, T>;
  else
    routines.overlap = &overlap_of_pair<P, T>;
  if constexpr (HasFirstLook<P, T>) routines.may_overlap = &first_look_of_pair<P, T>;
  return routines;
}

/// The table of routines. Composites are never looked up, since they are taken apart before, nor are pairs against the
/// order of the list of shapes, which are swapped before.
template <class T>
class Table {
 public:
  constexpr Table() {
    PairList::each([this]<class P>() {
      routines_[place(detail::kind_of<typename P::template A<T>, T>(),
                      detail::kind_of<typename P::template B<T>, T>())] = routines_of_pair<P, T>();
    });
  }
  constexpr const Routines<T>& operator()(std::size_t a, std::size_t b) const { return routines_[place(a, b)]; }

 private:
  static constexpr std::size_t place(std::size_t a, std::size_t b) { return a * Shape<T>::count + b; }

  std::array<Routines<T>, Shape<T>::count * Shape<T>::count> routines_{};
};

template <class T>
inline constexpr Table<T> table;

/// Whether every convex kind has a routine with half-spaces: the general path takes bounded shapes only.
template <class T, std::size_t... I>
constexpr bool all_meet_half_spaces(std::index_sequence<I...>) {
  const auto meets = []<class C>(std::size_t kind) {
    return !(BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>) ||
           table<T>(kind, detail::kind_of<HalfSpace<T>, T>()).distance != nullptr;
  };
  return (meets.template operator()<std::variant_alternative_t<I, ShapeList<T>>>(I) && ...);
}
static_assert(all_meet_half_spaces<double>(std::make_index_sequence<Shape<double>::count>()),
              "a convex shape is missing among those on half-spaces in the list of pairs");

template <class T>
const Routines<T>& routines(const Shape<T>& a, const Shape<T>& b) {
  return table<T>(a.index(), b.index());
}

}  // namespace

template <class T>
std::optional<Distance<T>> special_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                            const Pose<T>& pose_b) {
  const auto routine = routines(a, b).distance;
  Distance<T> d;
  return routine && routine({a, pose_a}, {b, pose_b}, d) ? std::optional(d) : std::nullopt;
}

template <class T>
std::optional<bool> special_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                    const Pose<T>& pose_b) {
  const auto routine = routines(a, b).overlap;
  return routine ? routine({a, pose_a}, {b, pose_b}) : std::nullopt;
}

template <class T>
Distance<T> ordered_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             T limit) {
  const Body<T> body_a{a, pose_a}, body_b{b, pose_b};
  const auto routine = routines(a, b).distance;
  Distance<T> d;
  if (!routine || !routine(body_a, body_b, d)) d = general(body_a, body_b, limit);
  return d;
}

template <class T>
bool overlaps_by_distance_alone(const Shape<T>& a, const Shape<T>& b) {
  return routines(a, b).overlap_by_distance != nullptr;
}

namespace {

template <class T>
bool ordered_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  const Routines<T>& special = routines(a, b);
  const Body<T> body_a{a, pose_a}, body_b{b, pose_b};
  if (special.overlap)
    if (const auto touch = special.overlap(body_a, body_b)) return *touch;
  if (special.overlap_by_distance) return special.overlap_by_distance(body_a, body_b);
  const auto known = general_overlap(a, b, relative_in_double(pose_a, pose_b),
                                     static_cast<double>(rounding_radius(a)) + static_cast<double>(rounding_radius(b)));
  return known ? *known : general(body_a, body_b, std::numeric_limits<T>::infinity()).distance <= T(0);
}

}  // namespace

template <class T>
Distance<T> convex_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  const T no_limit = std::numeric_limits<T>::infinity();
  return against_order(a, b) ? mirrored(ordered_distance(b, pose_b, a, pose_a, no_limit))
                             : ordered_distance(a, pose_a, b, pose_b, no_limit);
}

template <class T>
bool convex_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  return against_order(a, b) ? ordered_overlap(b, pose_b, a, pose_a) : ordered_overlap(a, pose_a, b, pose_b);
}

template <class T>
bool convex_may_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  if (against_order(a, b)) return convex_may_overlap<T>(b, pose_b, a, pose_a);
  if (const auto first_look = routines(a, b).may_overlap) return first_look({a, pose_a}, {b, pose_b});
  return ordered_overlap(a, pose_a, b, pose_b);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::optional<Distance<T>> special_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&,               \
                                                       const Pose<T>&);                                                \
  template std::optional<bool> special_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);      \
  template bool overlaps_by_distance_alone(const Shape<T>&, const Shape<T>&);                                          \
  template Distance<T> ordered_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&, T);          \
  template Distance<T> convex_distance(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);              \
  template bool convex_may_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);                  \
  template bool convex_overlap(const Shape<T>&, const Pose<T>&, const Shape<T>&, const Pose<T>&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
