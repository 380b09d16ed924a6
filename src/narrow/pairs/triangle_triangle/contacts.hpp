// Triangle against triangle, the points of contact: the two faces, or an edge of one, clipped by each other along a
// normal, or the two nearest points; across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. Where `known` is set, normal, points and features are
// those that `contacts_of_faces` gives, up to rounding; where rounding chooses among corners at about the same place,
// others of them. Edges that run along each other, faces away from the nearest points, and points too close together to
// be distinguished are never known.
#pragma once

#include "graze/contact.hpp"
#include "narrow/core/answer_rounding.hpp"
#include "narrow/pairs/box_box/clip_box_faces.hpp"
#include "narrow/pairs/triangle_triangle/clip_triangles.hpp"
#include "narrow/pairs/triangle_triangle/distance.hpp"

namespace graze {

/// The distance of a pair, from which its points are found.
template <class T>
struct FoundTriangles {
  T distance;  ///< minus infinity where it is not proven
  Distance<double> at;
};

/// A pair of triangles that may touch, as the contact routines take it: in the unit and the frame of `two_triangles`.
template <class Row>
struct MeetingTriangles {
  using S = typename RowOf<Row>::Number;

  const TwoTriangles<Row>& p;
  const TriangleAxes<S>& axes;
  S distance;         ///< signed
  Vec3<S> normal, a;  ///< direction from A to B and the point on A, of the nearest points
  S margin;
  S unit;          ///< unit of the frame, in that of the answer
  Vec3<S> origin;  ///< origin of the frame, in the answer's frame
};

/// By how much faces tilt, and where to, for the choice among points that are equally deep: far more than rounding
/// makes of a hundredth of an edge, and far less than a depth that matters. The direction is the world's, hence the
/// same when A and B are swapped, and no axis along which things are laid out.
inline constexpr Vec3d level_tilt{0.83e-11, 0.31e-11, 0.47e-11};

/// Whether a contact point is deeper than another or, where only rounding tells their depths apart, comes first by its
/// place.
struct IsDeeperTilted {
  template <class T>
  bool operator()(const ContactPoint<T>& point, const ContactPoint<T>& than) const {
    const auto height = [](const ContactPoint<T>& p) {
      return static_cast<double>(p.distance) - dot(level_tilt, converted<double>(p.a));
    };
    return height(point) < height(than);
  }
};

namespace detail {

/// The feature of a triangle that faces the other triangle.
template <class S>
struct ShownPart {
  using Mask = decltype(S() < S());
  S facing;  ///< cosine between the outward direction and its front normal
  Mask whole, edge;
  Vec3<S> along;  ///< vector along the edge
};
/// `most_fall`: squared slope of an edge above which only its upper end counts.
template <class Row, class S>
ShownPart<S> shown_part(const FlatTriangle<Row>& t, const Vec3<S>& outward, const S& most_fall) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  ShownPart<S> shown;
  shown.facing = dot(t.normal, outward);
  shown.whole = abs(shown.facing) >= S(T(furthest_lean));
  shown.edge = shown.whole & (!shown.whole);
  shown.along = {S(0), S(0), S(0)};
  if (all(shown.whole)) return shown;
  const Row height = dot(to_all<Row>(outward), t.point), rise = dot(to_all<Row>(outward), t.edge),
            fall = rise * rise * t.per();
  const Mask top0 = (height[0] >= height[1]) & (height[0] >= height[2]), top1 = (!top0) & (height[1] >= height[2]);
  const auto top = AxisPermutation<S>::of(top0, top1);
  const S after = top.pick(fall[0], fall[1], fall[2]), before = top.pick(fall[2], fall[0], fall[1]);
  const auto edge_of = [&](int i) { return corner_of(t.edge, i); };
  shown.edge = (!shown.whole) & (least(after, before) <= most_fall);
  shown.along = select(after < before, top.pick(edge_of(0), edge_of(1), edge_of(2)),
                       top.pick(edge_of(2), edge_of(0), edge_of(1)));
  return shown;
}

/// The features of both triangles along a normal.
template <class S>
struct ShownParts {
  using Mask = decltype(S() < S());
  ShownPart<S> of[2];  ///< features of A and of B
  Mask crossing;       ///< a vertex of either, or two edges: they meet in one point
  Mask parallel;       ///< two edges that are about parallel and run along each other

  ShownParts() = default;
  template <class Row>
  ShownParts(const TwoTriangles<Row>& p, const Vec3<S>& normal, const S& most_fall) {
    using T = typename LaneOf<S>::type;
    constexpr T lean = static_cast<T>(face_lean<double> * face_lean<double>);
    const FlatTriangle<Row>* const triangle[2] = {&p.a, &p.b};
    const Vec3<S> outward[2] = {normal, -normal};
    for (int i = 0; i < 2; ++i) of[i] = shown_part(*triangle[i], outward[i], most_fall);
    const ShownPart<S>&a = of[0], &b = of[1];
    crossing = !((a.whole & (b.whole | b.edge)) | (b.whole & a.edge));
    const S product = dot(cross(a.along, b.along), normal), along_a = dot(a.along, normal),
            along_b = dot(b.along, normal);
    parallel = a.edge & b.edge &
               (product * product <= (length_squared(a.along) - along_a * along_a) *
                                         (length_squared(b.along) - along_b * along_b) * S(lean));
  }
};

/// The normal of contacts, and the kind of contact along it.
template <class S>
struct ContactNormal {
  using Mask = decltype(S() < S());
  Vec3<S> normal;
  S most_fall;    ///< as in `shown_part`
  Mask gap;       ///< the distance equals the separation along the normal of a face or of two edges, up to rounding
  Mask in_point;  ///< the contact is at the nearest points
  Mask known;     ///< no edges run along each other
};

/// The normal of one of the two faces if it is about as good as that of the nearest points, else that one: as
/// `preferred_normal` of the general path.
template <class Row, class S>
Vec3<S> preferred_normal(const MeetingTriangles<Row>& m, const ShownParts<S>& shown, const AnswerRounding& rounded) {
  using Mask = decltype(S() < S());
  const TwoTriangles<Row>& p = m.p;
  const Vec3<S> of_a = select(shown.of[0].facing > S(0), p.a.normal, -p.a.normal),
                of_b = select(shown.of[1].facing > S(0), -p.b.normal, p.b.normal);
  const auto same = [&](const ShownPart<S>& part, const Vec3<S>& n) -> Mask {
    return part.whole & (max_abs(n - m.normal) <= S(rounded.normal));
  };
  const Mask same_a = same(shown.of[0], of_a), same_b = (!same_a) & same(shown.of[1], of_b);
  PreferredNormal<S> preferred(m.distance, m.normal, m.axes.smaller);
  const Vec3<S> normals[2] = {of_a, of_b};
  for (int i = 0; i < 2; ++i) preferred.consider(shown.of[i].whole, normals[i], p.gap_along(normals[i]));
  return select(same_a, of_a, select(same_b, of_b, preferred.best));
}

/// The normal of the best axis where faces, or a face and an edge, meet along it at the least distance; else one by the
/// nearest points.
template <class Row>
auto contact_normal(const MeetingTriangles<Row>& m, const AnswerRounding& rounded) {
  using S = typename RowOf<Row>::Number;
  using Mask = decltype(S() < S());
  // Largest slope of an edge to be clipped, along an axis and along the line of the nearest points.
  constexpr double fall_off_axis = (1 - furthest_lean) * (1 - furthest_lean),
                   fall_off_nearest = side_lean<double> * side_lean<double>;
  const S& noise = m.axes.noise;
  const TriangleAxis<S>&face = m.axes.face, &edge = m.axes.edge;
  const AxisChoice<S> choice = choose_axis(face.separation, edge.separation, noise, m.axes.smaller);
  const Mask best = (choice.edge_best & choice.edge_chosen) | (!(choice.edge_best | choice.edge_chosen));
  const S& separation = choice.separation;
  const Mask deep = separation <= noise, near = deep | (best & (m.distance <= separation + S(laid_slack) * noise));
  const Vec3<S> axis = select(choice.edge_chosen, edge.normal, face.normal);
  const Vec3<S> normals[2] = {axis, m.normal};
  constexpr double falls[2] = {fall_off_axis, fall_off_nearest};
  ShownParts<S> along[2];
  for (int i = 0; i < 2; ++i) {
    along[i] = ShownParts<S>(m.p, normals[i], S(falls[i]));
    if (all(near & (!along[0].crossing))) break;
  }
  const ShownParts<S>&shown = along[0], &of_nearest = along[1];
  const Mask along_axis = near & (!shown.crossing), gap = along_axis & (!deep), none = near & (!near),
             known = !(near & shown.parallel);
  ContactNormal<S> found{axis, S(fall_off_axis), gap, none, known};
  if (all(along_axis)) return found;
  found.in_point = (!along_axis) & of_nearest.crossing;
  found.known = found.known & (!(found.in_point & of_nearest.parallel));
  found.normal =
      select(along_axis, axis, select(of_nearest.crossing, m.normal, preferred_normal(m, of_nearest, rounded)));
  found.most_fall = select(along_axis, S(fall_off_axis), S(fall_off_nearest));
  return found;
}

/// An orthonormal frame about a unit normal (Duff et al. 2017, "Building an orthonormal basis, revisited", Journal of
/// Computer Graphics Techniques 6).
template <class S>
struct FrameAcross {
  Vec3<S> u, v, n;
  explicit FrameAcross(const Vec3<S>& normal) : n(normal) {
    const S sign = select(n.z < S(0), S(-1), S(1)), a = S(-1) / (sign + n.z), b = n.x * n.y * a;
    u = {S(1) + sign * n.x * n.x * a, sign * b, -sign * n.x};
    v = {b, sign + n.y * n.y * a, -n.y};
  }
  /// A face seen from its front; `outward` is 1 for A's and -1 for B's.
  template <class Row>
  TriangleFace<S> face(const FlatTriangle<Row>& t, const S& outward, const S& most_fall, const S& rounding) const {
    const Row x = dot(to_all<Row>(u), t.point), y = dot(to_all<Row>(v), t.point), up = dot(to_all<Row>(n), t.point),
              rise = dot(to_all<Row>(n), t.edge), fall = rise * rise * t.per(), far = -up * Row(outward);
    const auto vertex_at = [&](int i) { return FlatVertex<S>{{x[i], y[i]}, up[i], S(double(i))}; };
    return {vertex_at,
            {dot(t.normal, n) * outward,
             {-outward * dot(t.normal, u), -outward * dot(t.normal, v)},
             {far[0], far[1], far[2]},
             {fall[0], fall[1], fall[2]},
             most_fall},
            rounding};
  }
  FlatPoint<S> flat(const Vec3<S>& p) const { return {dot(p, u), dot(p, v)}; }
};

/// Whether any two corners are no further apart than `most_merged` in x and in y.
template <class S>
auto any_merged(const ContactPolygon<S>& corners, const S& most_merged) {
  using std::abs;
  using Mask = decltype(S() < S());
  Mask found = most_merged < S(0);
  for (std::size_t i = 1; i < least(corners.size(), std::size_t{6}); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const FlatPoint<S> p = corners.at(i), q = corners.at(k);
      const Mask near =
          corners.has(i) & corners.has(k) & (abs(p.x - q.x) <= most_merged) & (abs(p.y - q.y) <= most_merged);
      found = found | near;
    }
  return found;
}

}  // namespace detail

/// Writes the points of two triangles within the margin of each other, in their unit and frame.
template <class Row, class S>
void lay_triangles(const MeetingTriangles<Row>& m, const AnswerRounding& rounded, ContactSlots<S>& found) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S &noise = m.axes.noise, &smaller = m.axes.smaller;
  const detail::ContactNormal<S> along = detail::contact_normal(m, rounded);
  const detail::FrameAcross<S> frame(along.normal);
  const detail::TriangleFace<S> a = frame.face(m.p.a, S(1), along.most_fall, noise),
                                b = frame.face(m.p.b, S(-1), along.most_fall, noise);
  const S near = S(same_place) * sqrt(least(a.shortest_squared(), b.shortest_squared())), near_squared = near * near;
  // Whether there is anything to clip: along a face's normal a triangle may show a vertex where it shows an edge along
  // the line of the nearest points.
  const Mask clipped = (a.whole & (b.whole | b.edge)) | (b.whole & a.edge);
  // An edge along a rim may lie beside the face by the effect of the normal's rounding on its projection.
  const S slack = select(a.edge | b.edge, S(along_rim) * near + S(rounded.normal) * smaller, noise);

  const Mask none = noise < S(0);
  detail::Corner<S> slots[most_contact_slots];
  for (detail::Corner<S>& slot : slots) slot = {{S(0), S(0)}, none};
  if (!all(along.in_point)) detail::shared_corners<Row>(a, b, slack, slots);
  const FlatPoint<S> at_nearest = frame.flat(m.a);
  for (std::size_t i = 0; i < most_contact_slots; ++i) {
    slots[i].at = {select(along.in_point, at_nearest.x, slots[i].at.x),
                   select(along.in_point, at_nearest.y, slots[i].at.y)};
    slots[i].is = i == 0 ? along.in_point | slots[i].is : (!along.in_point) & slots[i].is;
  }
  detail::ContactPolygon<S> corners = detail::ring_of(slots, [&](const FlatPoint<S>& at) {
    return select(along.in_point, m.distance, b.apart_at(at) - a.apart_at(at));
  });
  const S nearest =
      corners.find_deepest_tilted(frame.flat({S(T(level_tilt.x)), S(T(level_tilt.y)), S(T(level_tilt.z))}));
  detail::simplify(corners, near);

  found.normal = along.normal;
  found.filled = S(0);
  const S height_of_nearest = dot(m.a, along.normal), limit = greatest(m.margin, m.distance + noise);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const S apart = corners.apart_at(i);
    const Mask here = corners.has(i) & (apart <= limit);
    if (!any(here)) continue;
    const FlatPoint<S> at = corners.at(i);
    const Vec3<S> on_a =
        frame.u * at.x + frame.v * at.y + along.normal * select(along.in_point, height_of_nearest, a.apart_at(at));
    const Vec3<S> place = m.origin + on_a * m.unit;
    const S far = apart * m.unit;
    found.put(i, {place, place + along.normal * far, far, a.part(at, near_squared), b.part(at, near_squared)});
    found.filled = found.filled + select(here, S(T(1 << i)), S(0));
  }
  const S allowed = select(along.gap, S(laid_slack) * noise, S(face_preference) * smaller);
  const Mask known = along.known & (along.in_point | clipped) & (found.filled > S(0)) &
                     (nearest <= m.distance + allowed) & (near > S(laid_slack) * noise) &
                     (!detail::any_merged(corners, S(rounded.point) * smaller));
  found.known = one_where<S>(known);
}

/// Writes the points of two triangles in a unit of their own, in the answer's unit, from their axes and nearest points.
template <class Row, class S>
void lay_triangles(const TrianglesInUnits<S>& in, const TwoTriangles<Row>& p, const TriangleAxes<S>& axes,
                   const Distance<S>& at, const S& margin, const AnswerRounding& rounded, ContactSlots<S>& found) {
  const S per = S(1) / in.unit;
  const Vec3<S> origin = in.a.pose.translation * in.unit;
  lay_triangles(MeetingTriangles<Row>{p, axes, at.distance * per, at.normal, (at.a - origin) * per, margin * per,
                                      in.unit, origin},
                rounded, found);
}

}  // namespace graze
