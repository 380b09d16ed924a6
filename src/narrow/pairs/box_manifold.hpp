// Box against box, the points of contact: the face of one laid over the face of the other along a normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are the corners of the area that the faces
// share, as `lay_over` gives them, up to rounding; where what is nearest lies nearer than these by more than
// `face_preference`, `known` says so.
#pragma once

#include "graze/contact.hpp"
#include "narrow/features.hpp"
#include "narrow/pairs/box_choice.hpp"
#include "narrow/pairs/box_outline.hpp"

namespace graze {

/// The points of contact, a slot each; which of the slots hold one is another matter in every lane.
template <class S>
struct BoxManifold {
  Vec3<S> normal;  ///< unit, from A to B, in the world
  struct Slot {
    Vec3<S> a, b;
    S distance;
    S part_a, part_b;  ///< of A and of B: a number of `box_features`
  } slots[most_box_points];
  S filled;  ///< slot i holds a point: bit i of this number
  S known;   ///< not 0: what is nearest is among them, or hardly nearer
};

/// What of a box `part_a` and `part_b` name: 9 times the number of a face, and 3 times where along the second of the axes
/// that follow the face's and where along the first: 0 within, 1 at the negative side, 2 at the positive.
inline constexpr std::size_t box_part_count = 54;
struct BoxFeatures {
  std::uint16_t of[box_part_count];
  constexpr BoxFeatures() : of{} {
    for (std::uint32_t part = 0; part < box_part_count; ++part) {
      const std::uint32_t face = part / 9, at_u = part % 3, at_v = part % 9 / 3;
      const std::uint32_t axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
      const std::uint32_t corner = (face % 2) << axis | std::uint32_t{at_u == 2} << u | std::uint32_t{at_v == 2} << v;
      of[part] = static_cast<std::uint16_t>(at_u != 0 && at_v != 0 ? vertex_feature(corner)
                                            : at_u != 0            ? edge_feature(corner, corner | 1u << v)
                                            : at_v != 0            ? edge_feature(corner, corner | 1u << u)
                                                                   : face_feature(face));
    }
  }
};
inline constexpr BoxFeatures box_features{};

namespace detail {

/// The i-th of three, where exactly one of the masks is set.
template <class M>
struct OneOfThree {
  M first, second;
  template <class V>
  V pick(const V& x, const V& y, const V& z) const {
    return select(first, x, select(second, y, z));
  }
  template <class S>
  S pick(const Vec3<S>& v) const {
    return pick(v.x, v.y, v.z);
  }
  /// The vector's component along this axis last, the ones along those that follow it before.
  template <class S>
  Vec3<S> turned(const Vec3<S>& v) const {
    return {pick(v.y, v.z, v.x), pick(v.z, v.x, v.y), pick(v)};
  }
};

template <class S>
auto longest_axis(const Vec3<S>& v) {
  const Vec3<S> a = abs(v);
  using Mask = decltype(S() < S());
  const Mask first = (a.x >= a.y) & (a.x >= a.z), second = (!first) & (a.y >= a.z);
  return OneOfThree<Mask>{first, second};
}

/// Two boxes as they meet along an axis, seen from the one whose face is a rectangle then.
template <class S>
struct MeetingBoxes {
  using Mask = decltype(S() < S());

  Mask by_b;       ///< that one is B
  Vec3<S> normal;  ///< from it to the other; of a face exactly one of its axes
  Vec3<S> half_clip, half_other, translation;
  Mat3<S> rotation;

  MeetingBoxes(const BoxPair<S>& p, const S& axis) {
    using std::sqrt;
    const S zero(0), one(1), edge = axis - S(6), before = select(edge < S(3), zero, select(edge < S(6), S(3), S(6)));
    const Mask of_a = axis < S(3), of_edges = edge >= zero;
    by_b = (!of_a) & (!of_edges);
    const S i = select(of_a, axis, axis - S(3)), j = select(of_edges, edge - before, i);
    const Mask j0 = j == zero, j1 = j == one;
    const Vec3<S> along =
        OneOfThree<Mask>{j0, j1}.pick(p.rotation.column(0), p.rotation.column(1), p.rotation.column(2));
    // A's unit vector times B's axis, and a unit vector for the face of either.
    const Vec3<S> product = OneOfThree<Mask>{before == zero, before == S(3)}.pick(
        Vec3<S>{zero, -along.z, along.y}, Vec3<S>{along.z, zero, -along.x}, Vec3<S>{-along.y, along.x, zero});
    const Vec3<S> unit{select(i == zero, one, zero), select(i == one, one, zero), select(i == S(2), one, zero)};
    const S scale = one / sqrt(select(of_edges, length_squared(product), one));
    const S side = dot(p.translation, select(by_b, along, select(of_a, unit, product)));
    const S toward = select(side < zero, S(-1), one), sign = select(by_b, -toward, toward);
    normal = select(of_edges, product * (scale * toward), unit * sign);
    half_clip = select(by_b, p.half_b, p.half_a);
    half_other = select(by_b, p.half_a, p.half_b);
    translation = select(by_b, -transposed_times(p.rotation, p.translation), p.translation);
    rotation = select(by_b, transposed(p.rotation), p.rotation);
  }
};

}  // namespace detail

/// The points along the chosen axis of two boxes that are at most `margin` apart, in the world. Only for boxes within the
/// margin of each other.
template <class S>
BoxManifold<S> box_manifold(const BoxPair<S>& p, const BoxChoice<S>& choice, const S& margin, const Pose<S>& pose_a,
                            const Pose<S>& pose_b) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S size_a = length(p.half_a), size_b = length(p.half_b), noise = box_noise(p, size_a, size_b), one(1), zero(0);
  const detail::MeetingBoxes<S> boxes(p, choice.axis);

  // The axes of the clipping box turned until its face's comes last; of the other box the same by its columns.
  const auto face = detail::longest_axis(boxes.normal);
  const Vec3<S> n = face.turned(boxes.normal), half = face.turned(boxes.half_clip), t = face.turned(boxes.translation);
  const Vec3<S>*rows = boxes.rotation.row,
        turned[3] = {face.pick(rows[1], rows[2], rows[0]), face.pick(rows[2], rows[0], rows[1]),
                     face.pick(rows[0], rows[1], rows[2])};
  const Vec3<S> lean = turned[0] * n.x + turned[1] * n.y + turned[2] * n.z;
  const auto other = detail::longest_axis(lean);
  const Vec3<S> half_other = other.turned(boxes.half_other), x = other.turned(turned[0]), y = other.turned(turned[1]),
                z = other.turned(turned[2]);
  const Mask positive = n.z >= zero, other_positive = other.pick(lean) < zero;
  const S height = select(positive, half.z, -half.z), reach = select(other_positive, half_other.z, -half_other.z);

  detail::LaidOver<S> faces;
  const S steep = one / n.z, rise_u = z.x * half_other.x * steep, rise_v = z.y * half_other.y * steep;
  faces.half = {half.x, half.y};
  faces.apart = (t.z + z.z * reach - height) * steep;
  faces.center = {t.x + x.z * reach - n.x * faces.apart, t.y + y.z * reach - n.y * faces.apart};
  faces.u = {x.x * half_other.x - n.x * rise_u, y.x * half_other.x - n.y * rise_u};
  faces.v = {x.y * half_other.y - n.x * rise_v, y.y * half_other.y - n.y * rise_v};
  const S inverse = one / (faces.u.x * faces.v.y - faces.u.y * faces.v.x);
  faces.to_u = {faces.v.y * inverse, -faces.v.x * inverse};
  faces.to_v = {-faces.u.y * inverse, faces.u.x * inverse};
  faces.slope = {faces.to_u.x * rise_u + faces.to_v.x * rise_v, faces.to_u.y * rise_u + faces.to_v.y * rise_v};
  const S length_u = sqrt(faces.u.x * faces.u.x + faces.u.y * faces.u.y),
          length_v = sqrt(faces.v.x * faces.v.x + faces.v.y * faces.v.y);
  const FlatPoint<S> per_length{length_v * abs(inverse), length_u * abs(inverse)};
  const S near = S(T(2 * same_place)) * least(least(half.x, half.y), least(length_u, length_v));
  faces.slack = noise;
  faces.slack_uv = {noise * per_length.x, noise * per_length.y};

  detail::Ring<S> corners = faces.shared();
  const S nearest = corners.find_deepest();
  detail::drop_idle_corners(corners, near);

  // From the clipping box to the world.
  const Pose<S> frame{select(boxes.by_b, pose_b.translation, pose_a.translation),
                      {select(boxes.by_b, pose_b.rotation.x, pose_a.rotation.x),
                       select(boxes.by_b, pose_b.rotation.y, pose_a.rotation.y),
                       select(boxes.by_b, pose_b.rotation.z, pose_a.rotation.z),
                       select(boxes.by_b, pose_b.rotation.w, pose_a.rotation.w)}};
  const Mat3<S> turn = rotation_of(frame.rotation);
  const Vec3<S> wx = face.turned(turn.row[0]), wy = face.turned(turn.row[1]), wz = face.turned(turn.row[2]),
                across{dot(wx, n), dot(wy, n), dot(wz, n)};
  const auto side = [](const S& at, const S& from) {
    return select(at >= from, S(2), select(at <= -from, S(1), S(0)));
  };
  const auto face_part = [&](const auto& axes, const Mask& upper) {
    return axes.pick(S(0), S(18), S(36)) + select(upper, S(9), S(0));
  };
  const S clip_face = face_part(face, positive), other_face = face_part(other, other_positive),
          limit = greatest(margin, choice.distance + noise);
  const FlatPoint<S> rim{half.x - near, half.y - near}, rim_uv{one - near * per_length.x, one - near * per_length.y};

  BoxManifold<S> found;
  found.normal = select(boxes.by_b, -across, across);
  found.filled = zero;
  for (std::size_t i = 0; i < corners.size; ++i) {
    const S& apart = corners.apart[i];
    const Mask here = corners.is[i] & (apart <= limit);
    if (!any(here)) continue;
    const FlatPoint<S> at = corners.at(i);
    const FlatPoint<S> uv = faces.in_uv(at);
    const Vec3<S> place{at.x, at.y, height}, on_clip{dot(wx, place), dot(wy, place), dot(wz, place)},
        on_other = on_clip + across * apart;
    const S of_clip = clip_face + side(at.x, rim.x) + side(at.y, rim.y) * S(3),
            of_other = other_face + side(uv.x, rim_uv.x) + side(uv.y, rim_uv.y) * S(3);
    auto& slot = found.slots[i];
    slot.a = frame.translation + select(boxes.by_b, on_other, on_clip);
    slot.b = frame.translation + select(boxes.by_b, on_clip, on_other);
    slot.distance = apart;
    slot.part_a = select(boxes.by_b, of_other, of_clip);
    slot.part_b = select(boxes.by_b, of_clip, of_other);
    found.filled = found.filled + select(here, S(T(1 << i)), zero);
  }
  const S allowed = S(T(face_preference)) * least(size_a, size_b);
  const Mask known = (found.filled > zero) & (nearest <= choice.distance + allowed);
  found.known = select(known, one, zero);
  return found;
}

}  // namespace graze
