// Contacts of balls and untapered capsules with each other, and of balls with boxes, in closed form: one point, or two
// where capsules lie side by side; across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone: those of `distance`, with the features that faces give.
#pragma once

#include <iterator>
#include <optional>

#include "narrow/pairs/box_box/clip_box_faces.hpp"
#include "narrow/pairs/closed_form_pair.hpp"
#include "narrow/pairs/segment_contact.hpp"
#include "narrow/pairs/triangle_parts.hpp"

namespace graze {

/// The closest points of two shapes as their one point of contact.
template <class S>
struct OneContact {
  CoreDistance<S> at;
  S part_a, part_b;  ///< parts of A and of B: indices into `sphere_capsule_features`, for a box into `box_features`
  S known;           ///< 1: the only point; 0: there may be two, found by `side_contact`; -1: nothing is known
};

template <class T, class S>
OneContact<T> converted(const OneContact<S>& c) {
  const CoreDistance<S>& at = c.at;
  return {{static_cast<T>(at.distance), converted<T>(at.normal), converted<T>(at.a), converted<T>(at.b)},
          static_cast<T>(c.part_a),
          static_cast<T>(c.part_b),
          static_cast<T>(c.known)};
}

/// Features of the parts of a ball or a capsule.
inline constexpr std::uint16_t sphere_capsule_features[] = {static_cast<std::uint16_t>(vertex_feature(0)),
                                                            static_cast<std::uint16_t>(vertex_feature(1)),
                                                            static_cast<std::uint16_t>(edge_feature(0, 1))};

namespace sphere_capsule {

/// A capsule's segment as a face seen along a unit vector: the side where that leans little from the normal plane of
/// the axis, else an end.
template <class S>
struct SegmentFace {
  using Mask = decltype(S() < S());

  Mask side;
  Mask top;          ///< the end is the upper one, where it is no side
  S seen;            ///< square of a unit of its length as seen
  S length_squared;  ///< squared length of the side as seen
  S beside_squared;  ///< squared distance of the given point from the nearer end, as seen
  Mask nearer_top;

  SegmentFace(const TurnedAxis<S>& segment, const Vec3<S>& outward, const Vec3<S>& point) {
    using std::abs;
    const S lean(face_lean<typename LaneOf<S>::type>), up = dot(segment.axis, outward), up_squared = up * up;
    side = up_squared <= lean * lean;
    top = up > S(0);
    seen = S(1) - up_squared;
    length_squared = S(4) * segment.half * segment.half * seen;
    const S along = dot(point - segment.middle, segment.axis), beside = segment.half - abs(along);
    nearer_top = along > S(0);
    beside_squared = beside * beside * seen;
  }

  /// The part that the point lies on. `near_squared`: squared distance within which an end counts.
  S part(const S& near_squared) const {
    const auto end = [](const Mask& upper) { return select(upper, S(1), S(0)); };
    return select(side, select(beside_squared <= near_squared, end(nearer_top), S(sphere_capsule::side_part)),
                  end(top));
  }
};

/// The squared distance, as seen along `n`, within which the rim of a box's face counts. The face's axis comes last.
template <class S>
S near_rim(const Vec3<S>& h, const Vec3<S>& n) {
  const S one(1), seen_u = one - n.x * n.x, seen_v = one - n.y * n.y;
  return S(4) * S(near_end<S>) * least(h.x * h.x * seen_u, h.y * h.y * seen_v);
}
/// The part of the face that a point lies on: rims count within the squared distance `near`.
template <class S>
S rims_part(const Vec3<S>& h, const Vec3<S>& n, const Vec3<S>& p, const S& near) {
  const S one(1), zero(0), seen_u = one - n.x * n.x, seen_v = one - n.y * n.y, facing = n.z * n.z;
  const auto at = [&](const S& reach, const S& from, const S& seen_across) {
    using std::abs;
    const S beside = reach - abs(from);
    const auto on_rim = (beside <= zero) | (beside * beside * facing <= near * seen_across);
    return one_where<S>(on_rim) * (one + one_where<S>(from > zero));
  };
  // The rim across u runs along v.
  return S(3) * at(h.y, p.y, seen_u) + at(h.x, p.x, seen_v);
}
/// The part of a box that `point` lies on, within the face that leans least from `outward`, as seen along `outward`.
/// `near_other`: the squared distance within which parts of the other shape count.
template <class S>
S box_part(const Vec3<S>& half, const Vec3<S>& outward, const Vec3<S>& point, const S& near_other) {
  const auto face = AxisPermutation<S>::longest(outward);
  const Vec3<S> n = face.turned(outward), h = face.turned(half);
  return face_part(face, n.z >= S(0)) + rims_part(h, n, face.turned(point), least(near_rim(h, n), near_other));
}
template <class S>
S box_part(const Vec3<S>& half, const Vec3<S>& outward, const Vec3<S>& point) {
  return box_part(half, outward, point, S(std::numeric_limits<typename LaneOf<S>::type>::infinity()));
}

template <class S>
void find_parts(const SphereCapsulePair<PointCore<S>, PointCore<S>, S>&, const CoreDistance<S>&, OneContact<S>& c) {
  c.part_a = c.part_b = S(0);
}
template <class S>
void find_parts(const SphereCapsulePair<PointCore<S>, AxisCore<S>, S>& p, const CoreDistance<S>& core,
                OneContact<S>& c) {
  const SegmentFace<S> face(p.b, -core.normal, core.b);
  c.part_a = S(0);
  c.part_b = face.part(S(near_end<S>) * face.length_squared);
}
template <class S>
void find_parts(const SphereCapsulePair<AxisCore<S>, AxisCore<S>, S>& p, const CoreDistance<S>& core,
                OneContact<S>& c) {
  using T = typename LaneOf<S>::type;
  const SegmentFace<S> a(p.a, core.normal, core.a), b(p.b, -core.normal, core.b);
  const S across = dot(cross(p.a.axis, p.b.axis), core.normal);
  const auto parallel = across * across <= S(face_lean<T> * face_lean<T>) * a.seen * b.seen;
  c.known = select(a.side & b.side & parallel, S(0), S(1));
  const S infinite(std::numeric_limits<T>::infinity());
  const S near =
      S(near_end<S>) * least(select(a.side, a.length_squared, infinite), select(b.side, b.length_squared, infinite));
  c.part_a = a.part(near);
  c.part_b = b.part(near);
}
template <class S>
void find_parts(const BallAndBox<S>& p, const CoreDistance<S>& core, OneContact<S>& c) {
  c.part_a = S(0);
  c.part_b = box_part(p.box.half, core.normal, core.a);
}

/// Whether `closest_contact` takes the shape.
template <class T>
bool regular(const Sphere<T>&) {
  return true;
}
template <class T>
bool regular(const Capsule<T>& capsule) {
  return has_untapered_side(capsule);
}
template <class T>
bool regular(const Box<T>& box) {
  const Vec3<T>& half = box.half_extents();
  return least(half.x, least(half.y, half.z)) > T(0);
}

}  // namespace sphere_capsule

/// The index of the features of two parts in `ContactFeatureIds`, exact in any number type.
template <class S>
S feature_place(const S& part_a, const S& part_b) {
  return part_a * S(typename LaneOf<S>::type(box_part_count)) + part_b;
}

/// The contact at the closest points. Pairs further apart than `margin` get only a distance and its normal. Only for
/// capsules with a length and boxes with one along every side.
template <class A, class B, class S>
OneContact<S> closest_contact(const Rounded<A, S>& a, const Pose<S>& pose_a, const Rounded<B, S>& b,
                              const Pose<S>& pose_b, const S& margin) {
  // Not `const`: g++ keeps a constant structure in memory, and a wide load of numbers that were stored one by one waits
  // for the stores.
  auto pair = sphere_capsule_pair(a, pose_a, b, pose_b);
  CorePoints<S> nearest = pair.nearest();
  const Vec3<S> between = nearest.b - nearest.a;
  const S gap = length(between);
  if (!any(gap - pair.radii() <= margin))
    return {pair.in_world({gap, direction_of(between, gap), nearest.a, nearest.b}), S(0), S(0), S(1)};
  CoreDistance<S> core = pair.core(nearest);
  OneContact<S> contact{pair.in_world(core), S(0), S(0), S(1)};
  sphere_capsule::find_parts(pair, core, contact);
  return contact;
}

/// The contacts of capsules side by side: the ends of the stretch along which both run (`clip_faces`), up to `margin`
/// apart; `closest`, the closest points, where there is no such stretch.
template <class S>
SegmentContact<S> side_contact(const Rounded<AxisCore<S>, S>& of_a, const Pose<S>& pose_a,
                               const Rounded<AxisCore<S>, S>& of_b, const Pose<S>& pose_b,
                               const CoreDistance<S>& closest, const S& margin) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const auto pair = sphere_capsule_pair(of_a, pose_a, of_b, pose_b);
  const TurnedAxis<S>&a = pair.a, &b = pair.b;
  const Vec3<S>& n = closest.normal;
  const sphere_capsule::SidesAlong<S> sides(a, pair.radius_a, b, pair.radius_b, n);
  const S smaller = least(a.half + pair.radius_a, b.half + pair.radius_b);
  SegmentContact<S> found;
  found.distance = closest.distance;
  found.normal = n;
  Mask first, second;
  const auto place = [](const S& part_a, const S& part_b) { return feature_place(part_a, part_b); };
  sides.put_ends(pair.origin, S(T(on_surface)) * smaller, place, found, first, second);

  const S& distance = closest.distance;
  const S noise = S(box_rounding<T>) * (a.half + b.half + pair.radii() + abs(distance));
  const Mask faces = sphere_capsule::keep_points(found, first, second, greatest(margin, distance + noise),
                                                 S(tolerance<T>) * smaller, distance + S(T(face_preference)) * smaller);
  if (!all(faces)) {
    const S on_a = dot(closest.a - pair.origin - n * pair.radius_a, a.axis),
            on_b = dot(closest.b - pose_b.translation + n * pair.radius_b, b.axis);
    sphere_capsule::put_closest(found, faces, closest, place(sides.part_a(on_a), sides.part_b(on_b)));
  }
  return found;
}

/// The position of a contact between its point on A and that on B: the middle, or for two balls the radius-weighted
/// point.
template <class A, class B, class S>
S contact_weight(const Rounded<A, S>&, const Rounded<B, S>&) {
  return S(0.5f);
}
template <class S>
S contact_weight(const Rounded<PointCore<S>, S>& a, const Rounded<PointCore<S>, S>& b) {
  const S sum = a.radius + b.radius;
  return select(sum > S(0), a.radius / select(sum > S(0), sum, S(1)), S(0.5f));
}

/// Whether shapes of a kind may touch others with their sides, in two points that `side_contact` finds.
template <class C>
inline constexpr bool lies_on_sides = false;
template <class T>
inline constexpr bool lies_on_sides<Capsule<T>> = true;

/// Whether every pair of two kinds has a single point of contact, whatever the shapes.
template <class A, class B>
inline constexpr bool always_one_point = false;
template <class T>
inline constexpr bool always_one_point<Sphere<T>, Sphere<T>> = true;

/// The features of a sphere or capsule with another shape: those of the parts i and j are at index 54 i + j. Not
/// inline: kernels of different instruction sets share nothing.
struct ContactFeatureIds {
  std::uint32_t of[std::size(sphere_capsule_features) * box_part_count]{};
  template <class Name, std::size_t size>
  constexpr explicit ContactFeatureIds(const Name (&parts_b)[size]) {
    for (std::size_t i = 0; i < std::size(sphere_capsule_features); ++i)
      for (std::size_t j = 0; j < box_part_count; ++j)
        of[i * box_part_count + j] = feature_id(sphere_capsule_features[i], parts_b[j % size]);
  }
};
static constexpr ContactFeatureIds ids_with_sphere_capsule(sphere_capsule_features), ids_with_box(box_features.of),
    ids_with_triangle(triangle_features);
/// The features of a sphere or capsule with a shape of the pointer's kind.
template <class C>
constexpr const ContactFeatureIds& feature_ids_with(const C*) {
  return ids_with_sphere_capsule;
}
template <class T>
constexpr const ContactFeatureIds& feature_ids_with(const Box<T>*) {
  return ids_with_box;
}
template <class T>
constexpr const ContactFeatureIds& feature_ids_with(const Triangle<T>*) {
  return ids_with_triangle;
}
/// Features of the parts of one shape, in a table that fits in registers.
template <std::size_t room>
struct PartNames {
  std::uint32_t of[room]{};
  template <class Name, std::size_t size>
  constexpr explicit PartNames(const Name (&names)[size]) {
    constexpr std::size_t count = size < room ? size : room;
    for (std::size_t i = 0; i < count; ++i) of[i] = names[i];
  }
};
static constexpr PartNames<16> sphere_capsule_part_names(sphere_capsule_features),
    triangle_part_names(triangle_features);
/// The features of the parts of a shape of the pointer's kind.
template <class C>
constexpr const auto& part_names_of(const C*) {
  return sphere_capsule_part_names.of;
}
template <class T>
constexpr const auto& part_names_of(const Box<T>*) {
  return box_features.of;
}
template <class T>
constexpr const auto& part_names_of(const Triangle<T>*) {
  return triangle_part_names.of;
}

template <class T, class M>
std::optional<T> put_sides(const SegmentContact<T>& found, const ContactFeatureIds& features, M& manifold) {
  if (found.filled == T(0)) return std::nullopt;
  const SegmentPoints<T> points{found, features.of, false};
  manifold.normal = points.normal();
  points.append(manifold.points);
  return found.distance;
}

/// Takes the closest points of two shapes, the single point of a manifold, out of it.
template <class M>
auto take_closest(M& manifold) {
  const auto point = manifold.points[0];
  manifold.points.clear();
  return CoreDistance<std::remove_cvref_t<decltype(point.distance)>>{point.distance, manifold.normal, point.a, point.b};
}

/// The single point of contact of shapes in place, which `closest_contact` must take. Nothing where the answer is
/// incomplete; where there may be two points, the manifold then holds the closest points.
template <class A, class B, class T, class M>
std::optional<T> one_contact(const InPlace<A, T>& a, const InPlace<B, T>& b, T margin, M& manifold) {
  const auto of_a = rounded_core(a.shape, a.rounding());
  const auto of_b = rounded_core(b.shape, b.rounding());
  OneContact<T> found = closest_contact(of_a, a.pose, of_b, b.pose, margin);
  if (found.known < T(0)) return std::nullopt;
  const CoreDistance<T>& at = found.at;
  // The direction between disjoint shapes is of use only to queries on composites.
  const bool apart = !(at.distance <= margin);
  if (std::is_same_v<M, Manifold<T>> || !apart) put(at.normal, manifold.normal);
  if (apart) return at.distance;
  ContactPoint<T>& point = manifold.points.emplace_back();
  put(at.a, point.a);
  put(at.b, point.b);
  point.distance = at.distance;
  point.feature = feature_ids_with(&b.shape).of[static_cast<std::size_t>(feature_place(found.part_a, found.part_b))];
  point.weight = contact_weight(of_a, of_b);
  if (found.known == T(0)) return std::nullopt;
  return at.distance;
}

/// `one_contact` for shapes that `closest_contact` takes; nothing for others.
template <class A, class B, class T, class M>
std::optional<T> regular_contact(const InPlace<A, T>& a, const InPlace<B, T>& b, T margin, M& manifold) {
  if (!sphere_capsule::regular(a.shape) || !sphere_capsule::regular(b.shape)) return std::nullopt;
  return one_contact(a, b, margin, manifold);
}

}  // namespace graze
