// Box against box, the points of contact: the face of one clipped by the face of the other along a normal, across
// lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are the corners of the intersection of the
// faces, as `clip_faces` gives them, up to rounding; `known` is 0 where the boxes are nearer to each other elsewhere by
// more than `face_preference`.
#pragma once

#include "graze/contact.hpp"
#include "narrow/manifold/features.hpp"
#include "narrow/pairs/box_box/outline.hpp"
#include "narrow/pairs/box_box/reference_frame.hpp"
#include "simd/axis_permutation.hpp"

namespace graze {

/// A point of contact of one pair.
template <class T>
struct ContactSlot {
  Vec3<T> a, b;
  T distance, part_a, part_b;
};

/// The points of contact, a slot each; each lane fills different slots.
template <class S>
struct ContactSlots {
  using Column = S[most_contact_slots];

  Vec3<S> normal;               ///< unit, from A to B, in the world
  Column a[3], b[3], distance;  ///< coordinates of the points and their distances, each by slot
  Column part_a, part_b;        ///< parts of A and of B that the points lie on: indices into `box_features`
  S filled;                     ///< slot i holds a point: bit i of this number
  S known;                      ///< not 0: the nearest points are among these, or nearer by less than `face_preference`

  ContactSlot<S> slot(std::size_t i) const {
    return {{a[0][i], a[1][i], a[2][i]}, {b[0][i], b[1][i], b[2][i]}, distance[i], part_a[i], part_b[i]};
  }
  void put(std::size_t i, const ContactSlot<S>& slot) {
    for (std::size_t k = 0; k < 3; ++k) a[k][i] = slot.a[k], b[k][i] = slot.b[k];
    distance[i] = slot.distance, part_a[i] = slot.part_a, part_b[i] = slot.part_b;
  }
};

/// Number of parts of a box in `part_a` and `part_b`: 9 times the number of a face, plus 3 times the place along the
/// second of the axes that follow the face's, plus the place along the first: 0 within, 1 at the negative side, 2 at
/// the positive.
inline constexpr std::size_t box_part_count = 54;
struct BoxFeatures {
  std::uint32_t of[most_parts]{};
  constexpr BoxFeatures() {
    for (std::uint32_t part = 0; part < box_part_count; ++part) {
      const std::uint32_t face = part / 9, at_u = part % 3, at_v = part % 9 / 3;
      const std::uint32_t axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::uint32_t corner = (face % 2) << axis | std::uint32_t{at_u == 2} << u | std::uint32_t{at_v == 2} << v;
      of[part] = at_u != 0 && at_v != 0 ? vertex_feature(corner)
                 : at_u != 0            ? edge_feature(corner, corner | 1u << v)
                 : at_v != 0            ? edge_feature(corner, corner | 1u << u)
                                        : face_feature(face);
    }
  }
};
static constexpr BoxFeatures box_features;  // not inline: kernels of different instruction sets share nothing

/// The part number of a face, the one across `axis` on its negative or positive side.
template <class Axis, class M>
auto face_part(const Axis& axis, const M& positive) {
  using S = typename Axis::Number;
  return axis.pick(S(0), S(18), S(36)) + S(9) * one_where<S>(positive);
}
/// The place along an axis of the face: 1 or 2 beyond `rim` either way, 0 within. For one number or for several.
template <class S, class Some>
Some part_along(const Some& at, const Some& rim) {
  return select(at >= rim, Some(S(2)), select(at <= -rim, Some(S(1)), Some(S(0))));
}

/// Makes points of contact of positions on the reference face.
template <class S>
struct BoxFaces {
  using Condition = decltype(S() < S());

  S origin[3], x[3], y[3], up[3];  ///< in the world: the middle of its box, the directions of the face's sides, the
                                   ///< face's middle from the box's
  S across[3];                     ///< unit, towards the other box
  S center[2], to_uv[4];           ///< middle of the incident face, and the map from there to units of its sides
  S rim[2], rim_uv[2];             ///< bounds beyond which a position is at the end of a side
  S face, other_face;              ///< part numbers of the two faces
  Condition by_b;                  ///< the reference face is one of B's

  /// A copy with `f` applied to every number.
  template <class F>
  BoxFaces each(const F& f) const {
    BoxFaces r;
    const auto put = [&](const auto& from, auto& to) {
      for (std::size_t k = 0; k < sizeof from / sizeof from[0]; ++k) to[k] = f(from[k]);
    };
    put(origin, r.origin), put(x, r.x), put(y, r.y), put(up, r.up), put(across, r.across);
    put(center, r.center), put(to_uv, r.to_uv), put(rim, r.rim), put(rim_uv, r.rim_uv);
    r.face = f(face), r.other_face = f(other_face);
    r.by_b = f(one_where<S>(by_b)) > S(0);
    return r;
  }

  /// Points of contact without the distance of the boxes there; one position or several.
  template <class Some>
  struct Points {
    Some a[3], b[3], part_a, part_b;
  };
  template <class Some>
  Points<Some> at(const Some& x_at, const Some& y_at, const Some& apart) const {
    Points<Some> points;
    const auto b_clips = Some::Mask::of(by_b);
    const auto put = [&](const Some& of_clip, const Some& of_other, Some& of_a, Some& of_b) {
      of_a = select(b_clips, of_other, of_clip);
      of_b = select(b_clips, of_clip, of_other);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const Some on_clip = Some(x[k]) * x_at + Some(y[k]) * y_at + Some(up[k]),
                 on_other = on_clip + Some(across[k]) * apart;
      put(Some(origin[k]) + on_clip, Some(origin[k]) + on_other, points.a[k], points.b[k]);
    }
    const auto part = [](const S& of_face, const Some& u, const Some& v, const S(&edge)[2]) {
      return Some(of_face) + part_along<S>(u, Some(edge[0])) + part_along<S>(v, Some(edge[1])) * Some(S(3));
    };
    const Some from_x = x_at - Some(center[0]), from_y = y_at - Some(center[1]);
    const Some u_at = from_x * Some(to_uv[0]) + from_y * Some(to_uv[1]),
               v_at = from_x * Some(to_uv[2]) + from_y * Some(to_uv[3]);
    put(part(face, x_at, y_at, rim), part(other_face, u_at, v_at, rim_uv), points.part_a, points.part_b);
    return points;
  }
};

/// Two boxes in contact: the corners of the intersection of their faces, and the data to make points of them.
template <class S>
struct BoxMeeting {
  const detail::ContactPolygon<S>& corners;
  BoxFaces<S> faces;
  Vec3<S> normal;            ///< unit, from A to B, in the world
  S limit;                   ///< corners further apart give no points
  decltype(S() < S()) near;  ///< the nearest points are among the corners, or nearer by less than `face_preference`
};

/// Data for the points along a reference axis, apart from the axis itself.
template <class S>
struct BoxLimits {
  S axis;     ///< as in `BoxReferenceAxis`
  S noise;    ///< rounding of a position
  S margin;   ///< corners further apart give no points
  S nearest;  ///< distance up to which a corner has to lie for the points to be known
};
template <class S>
BoxLimits<S> box_limits(const BoxesInPlace<S>& p, const BoxReferenceAxis<S>& choice, const S& margin) {
  using T = typename LaneOf<S>::type;
  const S size_a = length(p.rows.half_a), size_b = length(p.rows.half_b), noise = box_noise(p, size_a, size_b),
          allowed = S(T(face_preference)) * least(size_a, size_b);
  return {choice.axis, noise, greatest(margin, choice.distance + noise), choice.distance + allowed};
}

/// Calls `f` with the `BoxMeeting` along the chosen axis of two boxes seen from the one whose face clips, which is
/// `at` a position; `turn_of()` returns its rotation in the world. Only for boxes within the margin of each other.
template <class S, class TurnOf, class F>
void with_box_meeting(const BoxRows<S>& p, const BoxLimits<S>& limits, const Packed<S, 3>& at, const TurnOf& turn_of,
                      const F& f) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Row = Packed<S, 3>;
  const S &noise = limits.noise, one(1), zero(0);
  const detail::ReferenceFrame<S> seen(p, limits.axis);
  const auto& face = seen.face;
  const Row &n = seen.normal, &half = seen.half;

  // The incident box's axes permuted too, until that of its face comes last.
  const Row lean = transposed_times(seen.rotation, n);
  const auto other = detail::PackedPermutation<S>::longest(lean);
  const Row half_other = other(seen.half_other), z = other(seen.rotation.row[2]);
  const Rows<S> axes = transposed(Rows<S>{other(seen.rotation.row[0]), other(seen.rotation.row[1]), z});
  const auto plus = spread<2>(n) >= Row(zero), other_plus = spread<2>(other(lean)) < Row(zero);
  const auto end = [](const auto& positive, const Row& h) {
    const Row last = spread<2>(h);
    return select(positive, last, -last);
  };
  const S height = end(plus, half)[0];

  detail::ClippedFaces<S> faces;
  const S& steep = seen.steep;
  const Row rise = z * half_other * Row(steep), arm = seen.translation + axes.row[2] * end(other_plus, half_other);
  faces.half = {half[0], half[1]};
  faces.apart = (arm[2] - height) * steep;
  const Row center = arm - n * Row(faces.apart), side_u = axes.row[0] * spread<0>(half_other) - n * spread<0>(rise),
            side_v = axes.row[1] * spread<1>(half_other) - n * spread<1>(rise);
  using Four = Packed<S, 4>;
  const Four sides = pairs(side_u, side_v), products = sides * permuted<3, 2, 1, 0>(sides), squares = sides * sides,
             lengths = sqrt(squares + permuted<1, 0, 3, 2>(squares));
  faces.center = {center[0], center[1]};
  faces.sides = sides;
  faces.turn = products[0] - products[1];
  const S inverse = one / faces.turn, length_u = lengths[0], length_v = lengths[2];
  faces.to_uv = mixed<3, 6, 5, 0>(sides, -sides) * Four(inverse);
  const Four slopes = faces.to_uv * permuted<0, 0, 1, 1>(pairs(rise, rise)),
             slope = slopes + permuted<2, 3, 0, 1>(slopes);
  faces.slope = {slope[0], slope[1]};
  const FlatPoint<S> per_length{length_v * abs(inverse), length_u * abs(inverse)};
  const S near = S(T(2 * same_place)) * least(least(half[0], half[1]), least(length_u, length_v));
  faces.slack = noise;
  faces.slack_uv = {noise * per_length.x, noise * per_length.y};

  detail::ContactPolygon<S> corners = faces.shared();
  const S nearest = corners.find_deepest();
  detail::simplify(corners, near);

  // Transform from the frame of the clipping box to the world.
  const Rows<S> turn = face(transposed(turn_of()));
  const Row &wx = turn.row[0], &wy = turn.row[1], &wz = turn.row[2],
            across = wx * spread<0>(n) + wy * spread<1>(n) + wz * spread<2>(n), up = wz * Row(height),
            normal = select(seen.by_b, -across, across);
  BoxMeeting<S> meeting{corners, {}, {normal[0], normal[1], normal[2]}, limits.margin, nearest <= limits.nearest};
  BoxFaces<S>& points = meeting.faces;
  for (int k = 0; k < 3; ++k) {
    points.origin[k] = at[k];
    points.x[k] = wx[k];
    points.y[k] = wy[k];
    points.up[k] = up[k];
    points.across[k] = across[k];
  }
  points.center[0] = faces.center.x, points.center[1] = faces.center.y;
  for (int k = 0; k < 4; ++k) points.to_uv[k] = faces.to_uv[k];
  points.rim[0] = half[0] - near, points.rim[1] = half[1] - near;
  points.rim_uv[0] = one - near * per_length.x, points.rim_uv[1] = one - near * per_length.y;
  points.face = face_part(face, plus[0]), points.other_face = face_part(other, other_plus[0]);
  points.by_b = seen.by_b[0];
  f(meeting);
}

/// Writes the points of a meeting, in the world.
template <class S>
void put_points(const BoxMeeting<S>& meeting, ContactSlots<S>& found) {
  using Some = typename detail::ContactPolygon<S>::Some;
  const auto& corners = meeting.corners;
  found.normal = meeting.normal;
  found.filled = S(0);
  for (std::size_t i = 0; i < corners.size(); i += detail::ContactPolygon<S>::step) {
    const Some apart = corners.some(corners.apart, i);
    const auto here = corners.are(i) & (apart <= Some(meeting.limit));
    if (!any(here)) continue;
    const auto points = meeting.faces.at(corners.some(corners.x, i), corners.some(corners.y, i), apart);
    for (std::size_t k = 0; k < 3; ++k) {
      points.a[k].store(found.a[k] + i);
      points.b[k].store(found.b[k] + i);
    }
    points.part_a.store(found.part_a + i);
    points.part_b.store(found.part_b + i);
    apart.store(found.distance + i);
    found.filled = found.filled + corners.as_bits(i, here);
  }
  found.known = one_where<S>((found.filled > S(0)) & meeting.near);
}

}  // namespace graze
