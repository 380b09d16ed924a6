// Contacts of an untapered capsule whose side lies on a triangle or along an edge of it, across lanes, in double.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are those of the general path, up to
// rounding, with the same features. For rounded triangles only contacts over the face are known.
#pragma once

#include "narrow/core/answer_rounding.hpp"
#include "narrow/pairs/capsule_triangle_distance.hpp"
#include "narrow/pairs/sphere_capsule_contacts.hpp"

namespace graze {

namespace sphere_capsule {

/// A capsule whose side touches a triangle.
template <class S>
struct CapsuleOnTriangle {
  using Mask = decltype(S() < S());

  const SphereCapsuleAndTriangle<S> pair;
  const CoreDistance<S>& at;  ///< closest points, as rounded
  S half, radii, smaller, noise;
  Vec3<S> axis;                  ///< axis of the capsule, in the world
  Vec3<S> way, middle, outward;  ///< in the triangle's frame: the axis, its middle, and the opposite of the normal
  S facing;                      ///< `TriangleRegions::facing` of `outward`

  CapsuleOnTriangle(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose,
                    const Rounded<TriangleCore<S>, S>& triangle, const Pose<S>& pose_triangle,
                    const CoreDistance<S>& closest)
      : pair(capsule.radius, capsule.core.half_height, pose, triangle, pose_triangle),
        at(closest),
        half(capsule.core.half_height),
        radii(capsule.radius + triangle.radius) {
    using std::abs;
    const S size = half + capsule.radius, size_triangle = pair.triangle.extent() + triangle.radius;
    smaller = least(size, size_triangle);
    noise = S(box_rounding<double>) * (size + size_triangle + abs(at.distance));
    axis = rotation_of(pose.rotation).column(1);
    way = transposed_times(pair.turn, axis);
    middle = transposed_times(pair.turn, pair.between);
    outward = transposed_times(pair.turn, -at.normal);
    facing = pair.triangle.facing(outward);
  }

  /// The side of the capsule seen along a unit vector towards it, which encloses an angle of cosine `up` with the axis.
  Side<S> side(const S& up) const { return {half, pair.radius_round, -up, S(1) - up * up}; }
  /// The position along the axis of the capsule's closest point.
  S closest_along() const { return dot(at.a - at.normal * pair.radius_round - pair.origin, axis); }
  Mask keep(SegmentContact<S>& found, const Mask& first, const Mask& second, const S& margin,
            double most_merged) const {
    return keep_points(found, first, second, greatest(margin, at.distance + noise), S(most_merged) * smaller,
                       at.distance + S(face_preference) * smaller);
  }

  /// The contacts where the face touches: the axis clipped by the triangle's edges.
  SegmentContact<S> on_face(const S& margin, const Mask& asked, const AnswerRounding& rounded) const {
    using std::abs, std::sqrt;
    const S zero(0), one(1), distance = at.distance;
    const Vec3<S> front = pair.triangle.normal(), face = select(facing > zero, front, -front);
    // Along the face's normal where that shows about the whole distance, as on the general path.
    const S rise = dot(way, face), height = dot(middle - pair.triangle.point(0), face);
    const Mask by_face = (height - abs(rise) * half - radii >= distance - S(face_preference) * smaller) |
                         (max_abs(outward - face) <= S(rounded.normal));
    const Vec3<S> v = select(by_face, face, outward);
    const S up = dot(way, v), steep = select(by_face, one, one / dot(v, face));
    const Side<S> side = this->side(up);
    const SeenTriangle<S> seen = pair.triangle.seen(v, facing);
    const S near = least(side.near_end(), S(near_end<S>) * seen.shortest_squared()),
            slack = S(along_rim) * sqrt(near) + S(rounded.normal) * (radii + smaller);
    S from[3], pace[3];
    Stretch<S> stretch(half);
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = dot(seen.inward[i], middle - pair.triangle.point(i));
      pace[i] = dot(seen.inward[i], way);
      stretch.cut(from[i], pace[i], slack * slack * seen.squared[i]);
    }

    SegmentContact<S> found;
    found.distance = distance;
    found.normal = select(by_face, -(pair.turn * face), at.normal);
    const auto put = [&](typename SegmentContact<S>::Slot& slot, const S& along) -> Mask {
      const S beyond = side.rise(along);
      slot.distance = (height + rise * along) * steep - (beyond + pair.radius_triangle);
      slot.a = pair.origin + (axis * along + found.normal * beyond);
      slot.b = slot.a + found.normal * slot.distance;
      const auto inside = [&](std::size_t i) { return from[i] + pace[i] * along; };
      slot.place = feature_place(part_at(along, half, side.seen, near), seen.part(inside, near));
      return beyond >= zero;
    };
    const Mask meet = stretch.any & (stretch.low <= stretch.high) & (abs(up) <= S(face_lean<double>));
    const Mask first = meet & put(found.slots[0], stretch.low), second = meet & put(found.slots[1], stretch.high);
    const Mask faces = keep(found, first, second, margin, rounded.point);
    if (!all(faces | (!asked))) {
      const Side<S> there = this->side(dot(way, outward));
      const S close = least(there.near_end(), S(near_end<S>) * pair.triangle.seen(outward, facing).shortest_squared());
      const Vec3<S> place = pair.seen_by_triangle(at.b - pair.origin);
      put_closest(found, faces, at,
                  feature_place(part_at(closest_along(), half, there.seen, close),
                                pair.triangle.part_of_face(place, outward, facing, there.near_end())));
    }
    found.filled = select(by_face | (pair.radius_triangle == zero), found.filled, zero);
    return found;
  }

  /// The contacts where an edge or a vertex of the triangle touches.
  SegmentContact<S> along_edge(const S& margin, const AnswerRounding& rounded) const {
    using std::sqrt;
    const TriangleRim<S> rim = pair.triangle.rim(outward);
    const S length = sqrt(rim.squared);
    const Vec3<S> zero{S(0), S(0), S(0)};
    const TurnedAxis<S> own{zero, axis, half}, edge{pair.turn * (rim.start + rim.way * S(0.5)) - pair.between,
                                                    pair.turn * (rim.way / length), length * S(0.5)};
    const SidesAlong<S> sides(own, pair.radius_round, edge, pair.radius_triangle, at.normal);
    const auto place = [&](const S& part_a, const S& part_b) {
      const S end = select(rim.edge == S(2), S(0), rim.edge + S(1)),
              side = select(rim.edge == S(0), S(edge_part + 2), S(edge_part - 1) + rim.edge);
      return feature_place(part_a, select(part_b == S(0), rim.edge, select(part_b == S(1), end, side)));
    };
    SegmentContact<S> found;
    found.distance = at.distance;
    found.normal = at.normal;
    Mask first, second;
    sides.put_ends(pair.origin, S(on_surface) * smaller, place, found, first, second);
    // The angle between edges up to which faces are clipped by each other.
    const S across = dot(cross(axis, edge.axis), at.normal), lean(face_lean<double> * face_lean<double>);
    const Mask parallel = (!rim.pointed) & (across * across <= lean * sides.side_a.seen * sides.side_b.seen);
    const Mask faces = keep(found, first & parallel, second & parallel, margin, rounded.point);
    const S on_b = dot(at.b - pair.origin + at.normal * pair.radius_triangle - edge.middle, edge.axis);
    const S part_a = select(rim.pointed, part_at(closest_along(), half, sides.side_a.seen, sides.side_a.near_end()),
                            sides.part_a(closest_along()));
    put_closest(found, faces, at,
                select(rim.pointed, feature_place(part_a, rim.top), place(part_a, sides.part_b(on_b))));
    return found;
  }
};

}  // namespace sphere_capsule

/// The contacts of a capsule whose side touches. `at`: the closest points, as rounded to the scalar of the shapes.
/// `margin`: largest distance of contacts. `lies`: the lanes to be answered, pairs within the margin of each other;
/// others have no answer.
template <class S, class M>
SegmentContact<S> side_contact(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose,
                               const Rounded<TriangleCore<S>, S>& triangle, const Pose<S>& pose_triangle,
                               const CoreDistance<S>& at, const S& margin, const M& lies,
                               const AnswerRounding& rounded) {
  const sphere_capsule::CapsuleOnTriangle<S> on(capsule, pose, triangle, pose_triangle, at);
  const auto whole = on.pair.triangle.seen_whole(on.facing);
  if (!any(lies & (!whole))) return on.on_face(margin, lies, rounded);
  const SegmentContact<S> edge = on.along_edge(margin, rounded);
  if (!any(lies & whole)) return edge;
  return select(whole, on.on_face(margin, lies & whole, rounded), edge);
}

}  // namespace graze
