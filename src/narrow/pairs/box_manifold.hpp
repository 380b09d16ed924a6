// Box against box, the points of contact: the face of one laid over the face of the other along a normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are the corners of the area that the faces
// share, as `lay_over` gives them, up to rounding; where what is nearest lies nearer than these by more than
// `face_preference`, `known` says so.
#pragma once

#include "graze/contact.hpp"
#include "narrow/features.hpp"
#include "narrow/one_of_three.hpp"
#include "narrow/pairs/box_choice.hpp"
#include "narrow/pairs/box_outline.hpp"

namespace graze {

/// A point of contact of one pair.
template <class T>
struct BoxSlot {
  Vec3<T> a, b;
  T distance, part_a, part_b;
};

/// The points of contact, a slot each; which of the slots hold one is another matter in every lane.
template <class S>
struct BoxManifold {
  using Column = S[most_box_points];

  Vec3<S> normal;               ///< unit, from A to B, in the world
  Column a[3], b[3], distance;  ///< the slots' numbers, each where its slot is
  Column part_a, part_b;        ///< of A and of B: a number of `box_features`
  S filled;                     ///< slot i holds a point: bit i of this number
  S known;                      ///< not 0: what is nearest is among them, or hardly nearer

  BoxSlot<S> slot(std::size_t i) const {
    return {{a[0][i], a[1][i], a[2][i]}, {b[0][i], b[1][i], b[2][i]}, distance[i], part_a[i], part_b[i]};
  }
  void put(std::size_t i, const BoxSlot<S>& slot) {
    for (std::size_t k = 0; k < 3; ++k) a[k][i] = slot.a[k], b[k][i] = slot.b[k];
    distance[i] = slot.distance, part_a[i] = slot.part_a, part_b[i] = slot.part_b;
  }
};

/// What of a box `part_a` and `part_b` name: 9 times the number of a face, and 3 times where along the second of the
/// axes that follow the face's and where along the first: 0 within, 1 at the negative side, 2 at the positive.
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

/// The number of such a part: of a face, whose axis is the one of `axis`, at its negative side or at its positive.
template <class S, class M>
S face_part(const OneOfThree<S>& axis, const M& positive) {
  return axis.pick(S(0), S(18), S(36)) + select(positive, S(9), S(0));
}
/// Where along an axis of the face: as far out as `rim` either way, or within. Of a number or of several.
template <class S, class Some>
Some part_along(const Some& at, const Some& rim) {
  return select(at >= rim, Some(S(2)), select(at <= -rim, Some(S(1)), Some(S(0))));
}

namespace detail {

/// Two boxes as they meet along an axis, seen from the one whose face is a rectangle then.
template <class S>
struct MeetingBoxes {
  using Mask = decltype(S() < S());

  Mask by_b;         ///< that one is B
  Vec3<S> normal;    ///< from it to the other; of a face exactly one of its axes
  BoxPair<S> boxes;  ///< that one as A

  MeetingBoxes(const BoxPair<S>& p, const S& axis) {
    const S zero(0), one(1);
    const Mask of_edges = axis >= S(6);
    by_b = (axis >= S(3)) & (!of_edges);
    const OneOfThree<S> face(select(of_edges, zero, axis - select(by_b, S(3), zero)));
    const Vec3<S> unit = face.unit();
    const S side = dot(p.translation, either(
                                          by_b, [&] { return face.pick(p.rotation); }, [&] { return unit; })),
            toward = select(side < zero, S(-1), one);
    normal = unit * select(by_b, -toward, toward);
    if (any(of_edges)) normal = select(of_edges, of_product(p, axis - S(6)), normal);
    boxes = either(
        by_b, [&] { return seen_from_b(p); }, [&] { return p; });
  }

 private:
  /// The unit vector of A's i-th axis times B's j-th, from A to B, by 3 i + j.
  static Vec3<S> of_product(const BoxPair<S>& p, const S& number) {
    using std::sqrt;
    const S zero(0), first = select(number < S(3), zero, select(number < S(6), S(1), S(2)));
    const Vec3<S> along = OneOfThree<S>(number - first * S(3)).pick(p.rotation);
    const Vec3<S> product = OneOfThree<S>(first).pick(
        Vec3<S>{zero, -along.z, along.y}, Vec3<S>{along.z, zero, -along.x}, Vec3<S>{-along.y, along.x, zero});
    const S scale = S(1) / sqrt(length_squared(product));
    return product * (scale * select(dot(p.translation, product) < zero, S(-1), S(1)));
  }
};

}  // namespace detail

/// The points along the chosen axis of two boxes that are at most `margin` apart, in the world. Only for boxes within
/// the margin of each other.
template <class S>
void box_manifold(const BoxPair<S>& p, const BoxChoice<S>& choice, const S& margin, const Pose<S>& pose_a,
                  const Pose<S>& pose_b, BoxManifold<S>& found) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S size_a = length(p.half_a), size_b = length(p.half_b), noise = box_noise(p, size_a, size_b), one(1), zero(0);
  const detail::MeetingBoxes<S> seen(p, choice.axis);
  const BoxPair<S>& boxes = seen.boxes;

  // The axes of the clipping box turned until its face's comes last; of the other box the same by its columns.
  const auto face = OneOfThree<S>::longest(seen.normal);
  const Vec3<S> n = face.turned(seen.normal), half = face.turned(boxes.half_a), t = face.turned(boxes.translation);
  const Mat3<S> turned = face.turned(boxes.rotation);
  const Vec3<S> lean = turned.row[0] * n.x + turned.row[1] * n.y + turned.row[2] * n.z;
  const auto other = OneOfThree<S>::longest(lean);
  const Vec3<S> half_other = other.turned(boxes.half_b), x = other.turned(turned.row[0]),
                y = other.turned(turned.row[1]), z = other.turned(turned.row[2]);
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
  const Vec3<S> origin = select(seen.by_b, pose_b.translation, pose_a.translation);
  const Mat3<S> turn = either(
      seen.by_b, [&] { return rotation_of(pose_b.rotation); }, [&] { return rotation_of(pose_a.rotation); });
  const Vec3<S> wx = face.turned(turn.row[0]), wy = face.turned(turn.row[1]), wz = face.turned(turn.row[2]),
                across{dot(wx, n), dot(wy, n), dot(wz, n)};
  const S clip_face = face_part(face, positive), other_face = face_part(other, other_positive),
          limit = greatest(margin, choice.distance + noise);
  const FlatPoint<S> rim{half.x - near, half.y - near}, rim_uv{one - near * per_length.x, one - near * per_length.y};

  found.normal = select(seen.by_b, -across, across);
  found.filled = zero;
  using Some = typename detail::Ring<S>::Some;
  constexpr int step = detail::Ring<S>::step;
  const auto by_b = Some::Mask::of(seen.by_b);
  const auto part = [](const S& of_face, const Some& u, const Some& v, const FlatPoint<S>& edge) {
    return Some(of_face) + part_along<S>(u, Some(edge.x)) + part_along<S>(v, Some(edge.y)) * Some(S(3));
  };
  for (std::size_t i = 0; i < corners.size(); i += step) {
    const Some x_at = corners.some(corners.x, i), y_at = corners.some(corners.y, i),
               apart = corners.some(corners.apart, i);
    const auto here = corners.are(i) & (apart <= Some(limit));
    if (!any(here)) continue;
    const auto put = [&](const Some& of_clip, const Some& of_other, S* of_a, S* of_b) {
      select(by_b, of_other, of_clip).store(of_a + i);
      select(by_b, of_clip, of_other).store(of_b + i);
    };
    const auto put_place = [&](const Vec3<S>& w, const S& from, const S& normal, S* of_a, S* of_b) {
      const Some on_clip = Some(w.x) * x_at + Some(w.y) * y_at + Some(w.z * height),
                 on_other = on_clip + Some(normal) * apart;
      put(Some(from) + on_clip, Some(from) + on_other, of_a, of_b);
    };
    put_place(wx, origin.x, across.x, found.a[0], found.b[0]);
    put_place(wy, origin.y, across.y, found.a[1], found.b[1]);
    put_place(wz, origin.z, across.z, found.a[2], found.b[2]);
    const Some from_x = x_at - Some(faces.center.x), from_y = y_at - Some(faces.center.y);
    const Some u_at = from_x * Some(faces.to_u.x) + from_y * Some(faces.to_u.y),
               v_at = from_x * Some(faces.to_v.x) + from_y * Some(faces.to_v.y);
    put(part(clip_face, x_at, y_at, rim), part(other_face, u_at, v_at, rim_uv), found.part_a, found.part_b);
    apart.store(found.distance + i);
    const Some filled = select(here, corners.powers(i), Some(zero));
    for (int k = 0; k < step; ++k) found.filled = found.filled + filled[k];
  }
  const S allowed = S(T(face_preference)) * least(size_a, size_b);
  const Mask known = (found.filled > zero) & (nearest <= choice.distance + allowed);
  found.known = select(known, one, zero);
}

}  // namespace graze
