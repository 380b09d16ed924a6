#include "narrow/convex_pair.hpp"

#include <array>
#include <optional>

#include "narrow/general.hpp"
#include "narrow/pairs/closed_form.hpp"
#include "shape/rounding.hpp"
#include "simd/flatten.hpp"

// The special pairs, one line each. A pair without a line here takes the general path.
#include "narrow/pairs/box_box/distance.hpp"
#include "narrow/pairs/box_box/overlap.hpp"
#include "narrow/pairs/box_triangle/overlap.hpp"
#include "narrow/pairs/capsule_box.hpp"
#include "narrow/pairs/capsule_capsule.hpp"
#include "narrow/pairs/capsule_triangle.hpp"
#include "narrow/pairs/half_space.hpp"
#include "narrow/pairs/sphere_box.hpp"
#include "narrow/pairs/sphere_capsule.hpp"
#include "narrow/pairs/sphere_sphere.hpp"
#include "narrow/pairs/sphere_tapered_capsule.hpp"
#include "narrow/pairs/sphere_triangle.hpp"
#include "narrow/pairs/triangle_triangle/pair.hpp"

namespace graze {

namespace {

template <class T>
struct Body {
  const Shape<T>& shape;
  const Pose<T>& pose;
};

template <class A, class B, class T>
concept ClosedForm = requires(const A& a, const B& b, const Pose<T>& pose) {
  core_distance(core_of(a), moved(core_of(b), pose));
};

/// A routine that answers for most of a pair's values and leaves the others to the general path.
template <class A, class B, class T>
concept OwnDistance = requires(const A& a, const B& b, T margin, const Pose<T>& pose) {
  own_distance(a, margin, pose, b, margin, pose);
};
template <class A, class B, class T>
std::optional<Distance<T>> own_distance_of(const A& ca, const Body<T>& a, const B& cb, const Body<T>& b) {
  return own_distance(ca, a.shape.rounding(), a.pose, cb, b.shape.rounding(), b.pose);
}

/// One that tells whether they touch sooner than how far apart they are.
template <class A, class B, class T>
concept OwnOverlap = requires(const A& a, const B& b, T margin, const Pose<T>& pose) {
  own_overlap(a, margin, pose, b, margin, pose);
};

template <class T>
Distance<T> general(const Body<T>& a, const Body<T>& b, T limit) {
  const T radius_a = rounding_radius(a.shape), radius_b = rounding_radius(b.shape);
  const Posed frame = in_double(a.pose), b_in_a = relative(frame, in_double(b.pose));
  const double radii = static_cast<double>(radius_a) + static_cast<double>(radius_b);
  // By so much more that it still exceeds the limit when rounded to T.
  const double beyond = static_cast<double>(limit) * (1 + 2 * static_cast<double>(std::numeric_limits<T>::epsilon()));
  GeneralDistance g = general_distance(a.shape, b.shape, b_in_a, beyond + radii);
  if (g.core.distance > beyond + radii + g.noise) {  // only proven, without points
    Distance<T> d;
    d.distance = static_cast<T>(g.core.distance - radii);
    d.normal = converted<T>(rotate(frame.rotation, g.core.normal));
    return d;
  }
  // A distance that rounding cannot tell from none is none: the shapes touch.
  if (std::abs(g.core.distance - radii) <= g.noise) g.core.distance = radii;
  Distance<T> d = finished_in_double(g.core, radius_a, radius_b, frame);
  d.error = static_cast<T>(g.error);
  // The general path judges itself by double's tolerance, whichever scalar a support function of the user's answers in.
  const double allowed = static_cast<double>(tolerance<T>) / 2 * pair_size(a.shape, b.shape);
  d.status = g.error <= allowed ? Status::converged : g.status;
  return d;
}

template <class T, class A, class B>
Distance<T> closed_form(const A& core_a, T radius_a, const Pose<T>& pose_a, const B& core_b, T radius_b,
                        const Pose<T>& pose_b) {
  if constexpr (evaluated_in_double<A, B>) {
    const auto b_in_a = moved(converted<double>(core_b), relative_in_double(pose_a, pose_b));
    return finished_in_double(core_distance(converted<double>(core_a), b_in_a), radius_a, radius_b, in_double(pose_a));
  } else {
    return finished(core_distance(core_a, moved(core_b, relative(pose_a, pose_b))), radius_a, radius_b, pose_a);
  }
}

template <class T>
Distance<T> half_spaces(const Body<T>& a, T radius_a, const Body<T>& b, T radius_b) {
  const Pose<T> pose = relative(a.pose, b.pose);
  const Vec3<T> up{T(0), T(1), T(0)};
  Distance<T> d =
      finished<T>({pose.translation.y, up, {pose.translation.x, T(0), pose.translation.z}, pose.translation}, radius_a,
                  radius_b, a.pose);
  if (opposite(rotate(pose.rotation, up))) return d;
  d.distance = -std::numeric_limits<T>::infinity();
  d.status = Status::unbounded;
  return d;
}

template <class A, class B, class T>
auto round_pair_of(const A& ca, const Body<T>& a, const B& cb, const Body<T>& b) {
  return sphere_capsule_pair(rounded_core(ca, a.shape.rounding()), a.pose, rounded_core(cb, b.shape.rounding()),
                             b.pose);
}

/// Both are boxes, or rectangles, which are boxes of no thickness.
template <class A, class B, class T>
concept Boxes = std::is_same_v<decltype(core_of(std::declval<A>())), BoxCore<T>> &&
    std::is_same_v<decltype(core_of(std::declval<B>())), BoxCore<T>>;

/// One is, and the other a box or a capsule: `box_distance` answers.
template <class A, class B, class T>
concept BoxAndSuch = (Boxes<A, A, T> || Boxes<B, B, T>)&&requires(const A& a, const B& b, const Pose<T>& pose) {
  placed_box(rounded_core(a, T()), pose);
  placed_box(rounded_core(b, T()), pose);
};
template <class C, class T>
PlacedBox<double> placed(const C& concrete, const Body<T>& body) {
  return converted<double>(placed_box(rounded_core(concrete, body.shape.rounding()), body.pose));
}

/// Shapes with a closed form, and whether these values of theirs have it.
template <class A, class B, class T>
std::optional<Distance<T>> closed_form_of(const A& ca, const Body<T>& a, const B& cb, const Body<T>& b) {
  const T ra = rounding_radius(ca, a.shape.rounding()), rb = rounding_radius(cb, b.shape.rounding());
  if constexpr (is_sphere_capsule_pair<A, B>) {
    if (has_core(ca) && has_core(cb)) {
      const auto pair = round_pair_of(ca, a, cb, b);
      const CoreDistance<T> d = pair.in_world(pair.core(pair.nearest()));
      return Distance<T>{d.distance, d.normal, d.a, d.b};
    }
  } else if constexpr (ClosedForm<A, B, T>) {
    if (has_core(ca) && has_core(cb)) return closed_form(core_of(ca), ra, a.pose, core_of(cb), rb, b.pose);
  } else if constexpr (ClosedForm<B, A, T>) {
    if (has_core(ca) && has_core(cb)) return mirrored(closed_form(core_of(cb), rb, b.pose, core_of(ca), ra, a.pose));
  }
  return std::nullopt;
}

/// The routine for the concrete shapes A and B, which has an answer for most of their values.
template <class A, class B, class T>
std::optional<Distance<T>> special_distance(const Body<T>& a, const Body<T>& b) {
  const A& ca = *a.shape.template as<A>();
  const B& cb = *b.shape.template as<B>();
  constexpr bool half_a = std::is_same_v<A, HalfSpace<T>>, half_b = std::is_same_v<B, HalfSpace<T>>;
  if constexpr (half_b) {
    const T ra = rounding_radius(ca, a.shape.rounding()), rb = rounding_radius(cb, b.shape.rounding());
    if constexpr (half_a)
      return half_spaces(a, ra, b, rb);
    else
      return mirrored(finished(half_space_distance(ca, relative(b.pose, a.pose)), rb, ra, b.pose));
  } else {
    if constexpr (BoxAndSuch<A, B, T>) {
      if (has_core(ca) && has_core(cb))
        if (const auto found = box_distance(placed(ca, a), placed(cb, b)); found.proven) return rounded<T>(found.at);
    }
    if constexpr (OwnDistance<A, B, T>)
      if (const auto own = own_distance_of(ca, a, cb, b)) return own;
    return closed_form_of(ca, a, cb, b);
  }
}

/// Whether there is one at all.
template <class A, class B, class T>
inline constexpr bool has_special_distance =
    std::is_same_v<B, HalfSpace<T>> || BoxAndSuch<A, B, T> || OwnDistance<A, B, T> || is_sphere_capsule_pair<A, B> ||
    ClosedForm<A, B, T> || ClosedForm<B, A, T>;

/// Of boxes that are rounded or not regular.
template <class A, class B, class T>
[[gnu::noinline]] GRAZE_FLATTEN std::optional<bool> other_boxes_overlap(const A& ca, const B& cb, const Body<T>& a,
                                                                        const Body<T>& b, bool faces_only) {
  using Row = Packed<double, 3>;
  const ScaledBoxes<double> boxes(Row(converted<double>(core_of(ca).half)), PoseRows<double>(in_double(a.pose)),
                                  Row(converted<double>(core_of(cb).half)), PoseRows<double>(in_double(b.pose)));
  const Row& between = boxes.rows.translation;
  const double reach = static_cast<double>(a.shape.rounding()) + static_cast<double>(b.shape.rounding());
  const double noise = noise_of(a.shape, b.shape, Vec3d{between[0], between[1], between[2]} / boxes.scale);
  if (boxes_apart(boxes, (reach + noise) * boxes.scale, faces_only)) return false;
  if (faces_only || reach == 0 || !boxes_apart(boxes, noise * boxes.scale)) return true;
  return std::nullopt;
}

/// Whether two boxes touch, from their axes; nothing where their rounding may bridge a gap that no axis measures.
template <class A, class B, class T>
std::optional<bool> boxes_overlap(const A& ca, const B& cb, const Body<T>& a, const Body<T>& b, bool faces_only) {
  // A rectangle is never regular.
  if constexpr (std::is_same_v<A, Box<T>> && std::is_same_v<B, Box<T>>) {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), boxes_touch<T>);
    if (a.shape.rounding() == T(0) && b.shape.rounding() == T(0))
      if (const auto touch = kernel(ca, a.pose, cb, b.pose, faces_only)) return touch;
  }
  return other_boxes_overlap(ca, cb, a, b, faces_only);
}

/// Nothing where the axes do not tell.
template <class T>
GRAZE_FLATTEN std::optional<bool> axes_overlap(const Box<T>& box, const Triangle<T>& triangle, const Body<T>& a,
                                               const Body<T>& b) {
  if (a.shape.rounding() != T(0) || b.shape.rounding() != T(0)) return std::nullopt;
  const BoxTouchesTriangle<T> found(core_of(box), a.pose, rounded_core(triangle, T(0)).core, b.pose);
  if (!found.known) return std::nullopt;
  return found.touch;
}

/// Pairs whose distance costs no more than a routine for overlap would.
template <class A, class B, class T>
inline constexpr bool overlaps_by_distance =
    std::is_same_v<B, HalfSpace<T>> || ClosedForm<A, B, T> || ClosedForm<B, A, T>;

template <class A, class B, class T>
inline constexpr bool has_special_overlap = (std::is_same_v<A, Sphere<T>> && std::is_same_v<B, Sphere<T>>) ||
                                            (!overlaps_by_distance<A, B, T> &&
                                             (OwnOverlap<A, B, T> || OwnDistance<A, B, T> || Boxes<A, B, T> ||
                                              (std::is_same_v<A, Box<T>> && std::is_same_v<B, Triangle<T>>)));

template <class A, class B, class T>
std::optional<bool> special_overlap(const Body<T>& a, const Body<T>& b) {
  const A& ca = *a.shape.template as<A>();
  const B& cb = *b.shape.template as<B>();
  if constexpr (std::is_same_v<A, Sphere<T>> && std::is_same_v<B, Sphere<T>>) {
    const auto pair = round_pair_of(ca, a, cb, b);
    return spheres_overlap(pair.a.point, rounding_radius(ca, a.shape.rounding()), pair.b.point,
                           rounding_radius(cb, b.shape.rounding()));
  } else {
    if constexpr (OwnOverlap<A, B, T>) {
      if (const auto own = own_overlap(ca, a.shape.rounding(), a.pose, cb, b.shape.rounding(), b.pose)) return *own;
    } else if constexpr (OwnDistance<A, B, T>) {
      if (const auto own = own_distance_of(ca, a, cb, b)) return own->distance <= T(0);
    }
    if constexpr (Boxes<A, B, T>)
      return boxes_overlap(ca, cb, a, b, false);
    else if constexpr (std::is_same_v<A, Box<T>> && std::is_same_v<B, Triangle<T>>)
      return axes_overlap(ca, cb, a, b);
    else
      return std::nullopt;
  }
}

/// In one function with the distance, of which it then needs no points: by the table's distance the overlap of a box
/// and a half-space took a quarter longer.
template <class A, class B, class T>
bool overlap_by_distance(const Body<T>& a, const Body<T>& b) {
  if (const auto found = special_distance<A, B, T>(a, b)) return found->distance <= T(0);
  return general(a, b, std::numeric_limits<T>::infinity()).distance <= T(0);
}

/// The special routines of two kinds of shape; none where the general path has all their values.
template <class T>
struct Routines {
  std::optional<Distance<T>> (*distance)(const Body<T>&, const Body<T>&) = nullptr;
  std::optional<bool> (*overlap)(const Body<T>&, const Body<T>&) = nullptr;
  bool (*overlap_by_distance)(const Body<T>&, const Body<T>&) = nullptr;
};

/// Composites never come here: the mid phase takes them apart first. Nor does a pair against the order of the list: it
/// is asked the other way round.
template <class T, class C>
inline constexpr bool is_convex = BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>;

template <class T, std::size_t A, std::size_t B>
constexpr Routines<T> routines_of() {
  using CA = std::variant_alternative_t<A, ShapeList<T>>;
  using CB = std::variant_alternative_t<B, ShapeList<T>>;
  Routines<T> routines;
  if constexpr (A <= B && is_convex<T, CA> && is_convex<T, CB>) {
    if constexpr (has_special_distance<CA, CB, T>) routines.distance = &special_distance<CA, CB, T>;
    if constexpr (has_special_overlap<CA, CB, T>) routines.overlap = &special_overlap<CA, CB, T>;
    if constexpr (overlaps_by_distance<CA, CB, T> && !has_special_overlap<CA, CB, T>)
      routines.overlap_by_distance = &overlap_by_distance<CA, CB, T>;
  }
  return routines;
}

template <class T, std::size_t... I>
constexpr auto make_table(std::index_sequence<I...>) {
  constexpr std::size_t n = Shape<T>::count;
  return std::array<Routines<T>, n * n>{routines_of<T, I / n, I % n>()...};
}

template <class T>
const Routines<T>& routines(const Shape<T>& a, const Shape<T>& b) {
  static constexpr auto table = make_table<T>(std::make_index_sequence<Shape<T>::count * Shape<T>::count>());
  return table[a.index() * Shape<T>::count + b.index()];
}

}  // namespace

template <class T>
std::optional<Distance<T>> special_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                            const Pose<T>& pose_b) {
  const auto routine = routines(a, b).distance;
  return routine ? routine({a, pose_a}, {b, pose_b}) : std::nullopt;
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
  if (const auto routine = routines(a, b).distance)
    if (const auto special = routine(body_a, body_b)) return *special;
  return general(body_a, body_b, limit);
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
  return general_overlap(a, b, relative_in_double(pose_a, pose_b),
                         static_cast<double>(rounding_radius(a)) + static_cast<double>(rounding_radius(b)));
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
  if (const auto* box_a = a.template as<Box<T>>(), *box_b = b.template as<Box<T>>(); box_a && box_b)
    return *boxes_overlap(*box_a, *box_b, Body<T>{a, pose_a}, Body<T>{b, pose_b}, true);
  return convex_overlap<T>(a, pose_a, b, pose_b);
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
