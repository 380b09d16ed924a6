#include "composite/internal_edges/ghost_contacts.hpp"

#include <algorithm>
#include <optional>

#include "composite/closest.hpp"
#include "composite/internal_edges/face_contact.hpp"
#include "composite/internal_edges/occluders.hpp"
#include "composite/internal_edges/voronoi_neighbours.hpp"
#include "graze/geometry.hpp"
#include "narrow/pair_table.hpp"
#include "shape/mesh_data.hpp"

namespace graze {

namespace {

/// The face normal of a triangle on the side where the other shape is, in the world; zero without area.
template <class T>
Vec3<T> normal_towards(const Triangle<T>& triangle, const Pose<T>& pose, const LeafInContext<T>& other,
                       const Vec3<T>& point) {
  const Vec3<T> face = rotate(pose.rotation, face_normal(triangle));
  return dot(face, middle_of(other) - point) < T(0) ? -face : face;
}

/// Whether a triangle can have nothing over it: it pushes to its front, and around it are only those of its own mesh.
/// A triangle that pushes to its back is the wall of a closed mesh that is met from inside, below the top.
template <class T>
bool lies_open(const LeafInContext<T>& self, const Vec3<T>& outward) {
  const auto* triangle = self.piece.template as<Triangle<T>>();
  if (!triangle || !self.beside.empty() || self.whole.template as<Compound<T>>()) return false;
  const Vec3<T> front = cross(triangle->point(1) - triangle->point(0), triangle->point(2) - triangle->point(0));
  return dot(front, rotate(conjugate(self.pose.rotation), outward)) >= T(0);
}

/// Whether a piece is a triangle of a surface that nothing else is around: any cover of it is another triangle of that
/// surface, which reaches into the other shape and has a contact of its own.
template <class T>
bool is_of_lone_surface(const LeafInContext<T>& self) {
  return self.beside.empty() && (self.whole.template as<Mesh<T>>() || self.whole.template as<HeightField<T>>());
}

/// The outward normal that a solid piece has instead of one that leaves the Voronoi region of its feature: that of the
/// neighbour which rises above it, as far as the other shape touches that, or of a face of its own, if nothing rises
/// above those.
template <class T>
std::optional<Vec3<T>> normal_of_surface(const LeafInContext<T>& self, const Placed<T>& neighbour,
                                         const LeafInContext<T>& other, const Vec3<T>& point, const Vec3<T>& outward,
                                         T margin) {
  if (const auto* triangle = neighbour.shape.template as<Triangle<T>>()) {
    const Vec3<T> face = normal_towards(*triangle, neighbour.pose, other, point);
    if (face != Vec3<T>{} && !neighbour_outside_region(self, point, face, Among::all)) return face;
  }
  const bool beside_ground = is_ground(neighbour.shape);
  if (beside_ground && !neighbour_outside_region(self, point, plane_normal(neighbour.pose), Among::all))
    return plane_normal(neighbour.pose);
  Manifold<T> beside;
  if (!beside_ground) convex_contacts(neighbour.shape, neighbour.pose, other.piece, other.pose, margin, beside);
  if (!beside.points.empty()) {
    const LeafInContext<T> next{self.whole, self.whole_pose, neighbour.shape, neighbour.pose, self.beside};
    const Vec3<T> place = standing_point<T>(beside.points, &ContactPoint<T>::a);
    if (!neighbour_outside_region(self, place, beside.normal, Among::all) &&
        !surface_over(next, place, beside.normal, other))
      return beside.normal;
  }
  std::optional<OnSurface<T>> seen = surface_over(self, point, outward, other);
  if (!seen || seen->outside_region) seen = own_surface(self, point, outward, other);
  return seen ? std::optional(seen->normal) : std::nullopt;
}

/// A manifold without points between the pieces that another is between, and as sure as that is.
template <class T>
Manifold<T> between_same_pieces(const Manifold<T>& like) {
  Manifold<T> manifold;
  manifold.piece_a = like.piece_a;
  manifold.piece_b = like.piece_b;
  manifold.status = like.status;
  manifold.error = like.error;
  return manifold;
}

/// The manifold of two pieces along `outward`, a normal of A or B. Where their faces do not meet, as of a thing that
/// stands beside the piece on the continuation of its face, it has no points; and where pieces that touch (`distance`)
/// have none along it that does, whatever else is within the margin.
template <class T>
Manifold<T> laid_along(const LeafInContext<T>& a, const LeafInContext<T>& b, bool of_a, const Vec3<T>& outward,
                       T margin, T distance, const Manifold<T>& like) {
  Manifold<T> manifold = between_same_pieces(like);
  contacts_along(a.piece, a.pose, b.piece, b.pose, of_a ? outward : -outward, margin, manifold);
  const auto touches = [](const ContactPoint<T>& p) { return p.distance <= T(0); };
  if (distance <= T(0) && std::none_of(manifold.points.begin(), manifold.points.end(), touches))
    manifold.points.clear();
  return manifold;
}

/// One point: where the other shape reaches furthest below the plane of the piece's face. Its distance is `nearest` at
/// least.
template <class T>
Manifold<T> furthest_below(const LeafInContext<T>& self, const LeafInContext<T>& other, bool of_a,
                           const Vec3<T>& outward, const Manifold<T>& like,
                           T nearest = -std::numeric_limits<T>::infinity()) {
  const Vec3<T> lowest = furthest(other.piece, other.pose, -outward);
  const T distance = greatest(nearest, dot(lowest - furthest(self.piece, self.pose, outward), outward));
  const Vec3<T> above = lowest - outward * distance;
  Manifold<T> manifold = between_same_pieces(like);
  manifold.normal = of_a ? outward : -outward;
  manifold.points.push_back({of_a ? above : lowest, of_a ? lowest : above, distance, like.points[0].feature});
  return manifold;
}

/// Whether a piece goes as far as a place in the plane of one of its faces, but for `beside`.
template <class T>
bool reaches_to(const LeafInContext<T>& self, const Vec3<T>& place, T beside = T(0)) {
  const T noise = tolerance<T> * max_abs(bounds(self.piece, self.pose).extent()) + place_noise(self, place);
  return distance_to(self, place) <= beside + noise;
}

/// The contact `tilted` of pieces that are apart, laid along the face whose normal leans from its own because an edge
/// runs beside the face's rim: point by point, as far as that lean explains where they are.
template <class T>
Manifold<T> beside_edge(const LeafInContext<T>& self, bool of_a, const Vec3<T>& outward, const Vec3<T>& face,
                        const Manifold<T>& tilted) {
  Manifold<T> manifold = between_same_pieces(tilted);
  manifold.normal = of_a ? face : -face;
  const T top = dot(furthest(self.piece, self.pose, face), face), lean = T(2) * length(outward - face);
  for (const ContactPoint<T>& p : tilted.points) {
    const Vec3<T> beyond = of_a ? p.b : p.a;
    const T distance = dot(beyond, face) - top;
    const Vec3<T> place = beyond - face * distance;
    if (!reaches_to(self, place, lean * greatest(T(0), distance))) continue;
    manifold.points.push_back({of_a ? place : beyond, of_a ? beyond : place, distance, p.feature});
  }
  return manifold;
}

/// The rounding error of the coordinates of a place on a piece, wherever the origin is.
template <class T>
T own_noise(const LeafInContext<T>& self, const Vec3<T>& place) {
  return place_noise(self, place) + coordinate_noise(max_abs(bounds(self.piece, self.pose).extent()));
}

/// One point, where a corner of the other shape pokes through a triangle: no faces meet there that could be laid over
/// each other. None where the corner lies beside the triangle, or another of the surface is nearer to it: it is that
/// one's. Balls and capsules have none.
template <class T>
Manifold<T> poking_corner(const LeafInContext<T>& self, const LeafInContext<T>& other, bool of_a,
                          const Vec3<T>& outward, const Manifold<T>& like) {
  const bool round = other.piece.template as<Sphere<T>>() || other.piece.template as<Capsule<T>>();
  if (round || !self.piece.template as<Triangle<T>>()) return between_same_pieces(like);
  Manifold<T> found = furthest_below(self, other, of_a, outward, like);
  const ContactPoint<T>& point = found.points[0];
  const Vec3<T>&place = of_a ? point.a : point.b, &corner = of_a ? point.b : point.a;
  if (!reaches_to(self, place)) return between_same_pieces(like);
  const T nearest = std::abs(any_closest(self.whole, self.whole_pose, corner).distance);
  return nearest < std::abs(point.distance) - own_noise(self, place) ? between_same_pieces(like) : found;
}

/// Whether a triangle of a mesh is known to lie level with all around it.
template <class T>
bool lies_level(const LeafInContext<T>& self) {
  const auto* mesh = self.whole.template as<Mesh<T>>();
  return mesh && mesh->data().level[self.number];
}

/// Whether a triangle reaches further along a normal than where the contact stands, which that of an own feature never
/// does. Near a corner this is less than what coordinates may be off by, but more than what they are when both come
/// from one pose.
template <class T>
bool leans_over(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward) {
  const Vec3<T> further = furthest(self.piece, self.pose, outward) - point;
  return dot(further, outward) > region_slack<T> * length(further) + own_noise(self, point) / T(32);
}

/// The replacement of a contact's normal that is none of the surface's.
template <class T>
struct Correction {
  Vec3<T> normal;                              ///< outward
  std::optional<Distance<T>> least_way = {};   ///< from the piece to the other shape, if the normal is of that
  bool elsewhere = false;                      ///< the contact is another piece's
  std::optional<Vec3<T>> unless_covered = {};  ///< a place on the piece; where it is covered, the contact is elsewhere
};

template <class T>
std::optional<Correction<T>> as_correction(const std::optional<Vec3<T>>& normal) {
  return normal ? std::optional(Correction<T>{*normal}) : std::nullopt;
}

/// The correction of a triangle's normal that leaves the Voronoi region of its feature: the face's, on the side where
/// the other shape is, unless a sheet covers that.
template <class T>
std::optional<Correction<T>> along_face(const LeafInContext<T>& self, const Triangle<T>& triangle,
                                        const LeafInContext<T>& other, const Vec3<T>& point) {
  const Vec3<T> face = normal_towards(triangle, self.pose, other, point);
  if (face == Vec3<T>{}) return std::nullopt;
  if (lies_open(self, face)) return Correction<T>{face};
  if (is_of_lone_surface(self)) return Correction<T>{face, {}, false, point};
  const std::optional<OnSurface<T>> over = surface_over(self, point, face, other);
  return Correction<T>{over ? over->normal : face};
}

/// The least way out of a triangle, if its normal is one of the surface's and not that of the triangle's face. That of
/// a face of the other shape, which a contact takes where it is about as good, leaves the region of an edge that it
/// leans over, though that edge is a ridge and touched.
template <class T>
std::optional<Correction<T>> least_way_out(const LeafInContext<T>& self, const LeafInContext<T>& other) {
  const Distance<T> d = convex_distance<T>(self.piece, self.pose, other.piece, other.pose);
  if (face_along(self, d.normal) != Vec3<T>{} || neighbour_outside_region(self, d.a, d.normal)) return std::nullopt;
  if (!lies_open(self, d.normal) && surface_over(self, d.a, d.normal, other)) return std::nullopt;
  return Correction<T>{d.normal, d};
}

/// Adds where two pieces are deepest in each other, unless the manifold has a point as deep: what lies on a ridge meets
/// it along a line, and round sides that are laid on it end before.
template <class T>
void add_deepest(const LeafInContext<T>& self, bool of_a, const Distance<T>& d, const Manifold<T>& like,
                 Manifold<T>& manifold) {
  // Distances are of the pair alone, wherever it is.
  const T noise = coordinate_noise(max_abs(bounds(self.piece, self.pose).extent())) / T(16);
  for (const ContactPoint<T>& p : manifold.points)
    if (p.distance <= d.distance + noise) return;
  manifold.normal = of_a ? d.normal : -d.normal;
  manifold.points.push_back({of_a ? d.a : d.b, of_a ? d.b : d.a, d.distance, like.points[0].feature});
}

/// Whether a piece is a triangle of the skin of a body beside which nothing stands.
template <class T>
bool is_of_mover(const LeafInContext<T>& self) {
  return self.of_body && self.beside.empty();
}

/// A contact as one of its two pieces sees it.
template <class T>
struct SeenContact {
  const Manifold<T>& manifold;
  Vec3<T> ContactPoint<T>::*side;
  Vec3<T> outward;
  bool on_face;  ///< of the piece: the normal is that of one
  T distance;    ///< signed, of the two
};

/// Whether the other shape reaches right through the body that a mesh bounds, behind a plane with this normal.
template <class T>
bool reaches_through(const LeafInContext<T>& self, const LeafInContext<T>& other, const Vec3<T>& own) {
  const Vec3<T> from = furthest(other.piece, other.pose, -own) - self.whole_pose.translation;
  const Vec3<T> local = rotate(conjugate(self.whole_pose.rotation), own);
  const Aabb<T>& box = self.whole.template as<Mesh<T>>()->data().tree.bounds();
  const Vec3<T> center = box.center(), half = box.extent() / T(2);
  return dot(from, own) <= dot(center, local) - dot(half, abs(local));
}

/// Whether a place on a triangle of a body's skin is on one of the body's own edges or corners, where the skin bends
/// away from the triangle's plane, and the other shape is only near or reaches right through the body behind that
/// plane. What goes further than the triangle beyond the edge is asked about by itself, and the triangle's plane has
/// nothing to do with it: a box that leans on a floor is as deep along its sides as the floor is wide.
template <class T>
bool is_on_ridge(const LeafInContext<T>& self, const LeafInContext<T>& other, const SeenContact<T>& contact,
                 const Vec3<T>& point) {
  if (!is_of_mover(self)) return false;
  const Vec3<T> own = rotate(self.pose.rotation, face_normal(*self.piece.template as<Triangle<T>>()));
  if (contact.distance <= T(0) && !reaches_through(self, other, own)) return false;
  const auto faces = faces_around(self, point);
  const bool bends = std::any_of(faces.begin(), faces.end(), [&](const Vec3<T>& f) { return !leads_along(f, own); });
  return bends && !neighbour_outside_region(self, point, own, Among::all);
}

/// Whether a contact's normal is that of the least way out itself: no direction parts the two more.
template <class T>
bool is_least_way(const LeafInContext<T>& self, const LeafInContext<T>& other, const SeenContact<T>& contact) {
  const Vec3<T> high = furthest(self.piece, self.pose, contact.outward);
  const Vec3<T> from = furthest(other.piece, other.pose, -contact.outward) - high;
  const T noise = T(4) * std::numeric_limits<T>::epsilon() * (max_abs(high) + max_abs(from));
  return dot(from, contact.outward) >= contact.distance - noise;
}

/// The place of a contact on the edge or corner of a solid that its normal belongs to. Its points may lie a little
/// beside that, on a face; the nearest points are on it, unless another way out is as good and they are of that: then
/// they lie lower.
template <class T>
Vec3<T> place_on_solid(const LeafInContext<T>& self, const LeafInContext<T>& other, const SeenContact<T>& contact) {
  const Vec3<T> of_points = standing_point<T>(contact.manifold.points, contact.side);
  const Vec3<T> nearest = convex_distance<T>(self.piece, self.pose, other.piece, other.pose).a;
  return dot(of_points - nearest, contact.outward) > own_noise(self, nearest) ? of_points : nearest;
}

/// The distance of two pieces along a normal that leads out of one; negative is a depth.
template <class T>
T apart_along(const LeafInContext<T>& self, const LeafInContext<T>& other, const Vec3<T>& outward) {
  return dot(furthest(other.piece, other.pose, -outward) - furthest(self.piece, self.pose, outward), outward);
}

/// The normal of the face of a piece that leans least from a direction; zero where it has none there.
template <class T>
Vec3<T> leaning_least(const LeafInContext<T>& self, const Vec3<T>& outward) {
  Face<T> face;
  const Vec3<T> local = rotate(conjugate(self.pose.rotation), outward);
  self.piece.visit([&](const auto& c) {
    if constexpr (requires { c.core_face(local, face, T()); })
      c.core_face(local, face, side_lean<T>);
    else if constexpr (requires { c.core_face(local, face); })
      c.core_face(local, face);
  });
  Vec3<T> sum{};
  for (std::size_t i = 2; i < face.vertices.size(); ++i)
    sum += cross(face.vertices[i - 1] - face.vertices[0], face.vertices[i] - face.vertices[0]);
  return rotate(self.pose.rotation, normalized(sum, Vec3<T>{}));
}

/// The correction of a solid's normal that leaves the Voronoi region of its feature where no neighbour has one: that of
/// a face of its own which leans least from the way to the middle of the other shape, or from the normal, and above
/// which nothing rises. Without one the contact is a neighbour's.
template <class T>
Correction<T> own_face(const LeafInContext<T>& self, const LeafInContext<T>& other, const Vec3<T>& point,
                       const Vec3<T>& outward) {
  const Vec3<T> to_middle = normalized(middle_of(other) - point, outward);
  for (const Vec3<T>& direction : {to_middle, outward}) {
    const Vec3<T> own = leaning_least(self, direction);
    if (own != Vec3<T>{} && !neighbour_outside_region(self, point, own, Among::all)) return {own};
  }
  return {outward, {}, true};
}

/// The correction of a contact whose normal is none of the surface's; nothing for another.
template <class T>
std::optional<Correction<T>> corrected(const LeafInContext<T>& self, const LeafInContext<T>& other,
                                       const SeenContact<T>& contact, T margin) {
  const auto* triangle = self.piece.template as<Triangle<T>>();
  const Vec3<T>& outward = contact.outward;
  const bool open = lies_open(self, outward);
  if (contact.on_face && open) return std::nullopt;
  const Vec3<T> point = contact.on_face || triangle ? standing_point<T>(contact.manifold.points, contact.side)
                                                    : place_on_solid(self, other, contact);
  if (open && lies_level(self)) {
    const Vec3<T> face = normal_towards(*triangle, self.pose, other, point);
    if (lies_open(self, face)) return Correction<T>{face};
  }
  if (!contact.on_face) {
    std::optional<Placed<T>> neighbour = neighbour_outside_region(self, point, outward);
    const bool leans = triangle && leans_over(self, point, outward);
    if (leans && !neighbour)
      neighbour = neighbour_outside_region(self, furthest(self.piece, self.pose, outward), outward);
    // Where two skins cross, the least way out is that of edges which neither body has, and a face of one cuts through
    // the flat of the other: what that reaches there has contacts of its own.
    const bool skins = self.of_body && other.of_body;
    if (!skins && (leans || (triangle && neighbour && !is_least_way(self, other, contact))))
      if (const auto least = least_way_out(self, other)) return least;
    const bool of_other = skins && face_along(other, -outward) != Vec3<T>{};
    const bool stands = face_along(self, outward, standing_lean<T>) != Vec3<T>{};
    if (neighbour && (of_other || (!stands && is_on_ridge(self, other, contact, point))))
      return Correction<T>{outward, {}, true};
    if (neighbour && triangle) return along_face(self, *triangle, other, point);
    if (neighbour) {
      const auto normal = normal_of_surface(self, *neighbour, other, point, outward, margin);
      return normal ? as_correction(normal) : own_face(self, other, point, outward);
    }
  }
  if (open) return std::nullopt;
  if (is_of_lone_surface(self))
    return is_covered(self, point, outward, other) ? std::optional(Correction<T>{outward, {}, true}) : std::nullopt;
  const std::optional<OnSurface<T>> over = surface_over(self, point, outward, other);
  return as_correction(over ? std::optional(over->normal) : std::nullopt);
}

/// Whether the contact of a mover's triangle is that of the triangles beside it: its own face stands across the refused
/// normal, and along that face's the two are far deeper than they are. So a side wall of a body of triangles meets the
/// edge of a tile below it.
template <class T>
bool is_of_another(const SeenContact<T>& contact, const Correction<T>& right, T apart, T noise) {
  constexpr T across = T(0.5);  // a cosine
  return apart < T(2) * contact.distance - noise && dot(right.normal, contact.outward) <= across;
}

/// A correction that is no wall of a neighbour. Where three pieces meet in a corner the sight of one may end on the
/// wall of another, and along that wall's normal the other shape is as deep as it is wide. A face of the piece itself,
/// the one that leans least from the refused normal or from the way to the middle of the other shape, is taken before
/// one along which the two are deeper, if nothing rises above it and nothing covers it.
template <class T>
std::optional<Correction<T>> least_deep(const LeafInContext<T>& self, const LeafInContext<T>& other,
                                        const SeenContact<T>& contact, std::optional<Correction<T>> right) {
  const bool is_triangle = self.piece.template as<Triangle<T>>() != nullptr;
  if (!right || right->least_way || (is_triangle && !is_of_mover(self))) return right;
  const Vec3<T> point = standing_point<T>(contact.manifold.points, contact.side);
  const T noise = own_noise(self, point);
  T apart = apart_along(self, other, right->normal);
  if (apart >= contact.distance - noise) return right;
  if (is_triangle)
    return is_of_another(contact, *right, apart, noise) ? Correction<T>{contact.outward, {}, true} : right;
  const Vec3<T> to_middle = normalized(middle_of(other) - point, contact.outward);
  for (const Vec3<T>& direction : {contact.outward, to_middle}) {
    const Vec3<T> own = leaning_least(self, direction);
    if (own == Vec3<T>{} || apart_along(self, other, own) <= apart + noise) continue;
    if (neighbour_outside_region(self, point, own, Among::all) || surface_over(self, point, own, other)) continue;
    right = Correction<T>{own};
    apart = apart_along(self, other, own);
  }
  return right;
}

/// Whether points that were laid along a corrected normal are deeper than the pieces are in each other, and in their
/// middle the other shape does not reach up to the piece: it lies beside that then, and only goes on below its plane,
/// as the base of a cone beside a sheet does.
template <class T>
bool is_beside(const LeafInContext<T>& self, const LeafInContext<T>& other, const SeenContact<T>& contact,
               const Manifold<T>& laid) {
  if (laid.points.empty()) return false;
  Vec3<T> sum{};
  for (const ContactPoint<T>& p : laid.points) sum += p.*contact.side;
  const Vec3<T> middle = sum / T(laid.points.size());
  const T noise = own_noise(self, middle), deep = T(2) * least(contact.distance, T(0)) - noise;
  const bool deeper =
      std::any_of(laid.points.begin(), laid.points.end(), [&](const auto& p) { return p.distance < deep; });
  return deeper && distance_to(other, middle) > noise;
}

/// Whether a corrected contact is another piece's, after it was laid: where the piece is not met along its face,
/// nothing need be known of what covers it.
template <class T>
bool is_of_another_piece(const LeafInContext<T>& self, const LeafInContext<T>& other, const Correction<T>& right,
                         const Manifold<T>& laid) {
  return right.elsewhere ||
         (right.unless_covered && !laid.points.empty() && is_covered(self, *right.unless_covered, right.normal, other));
}

/// One point for pieces that touch, along a corrected normal along which nothing shows how deep they are: where the
/// other shape reaches furthest below the piece, or, if that is beside the piece, where they meet.
template <class T>
Manifold<T> touching_point(const LeafInContext<T>& self, const LeafInContext<T>& other, bool of_a,
                           const SeenContact<T>& contact, const Vec3<T>& outward, const Manifold<T>& like) {
  Manifold<T> manifold = furthest_below(self, other, of_a, outward, like, contact.distance);
  ContactPoint<T>& point = manifold.points[0];
  if (reaches_to(self, point.*contact.side)) return manifold;
  const Vec3<T> place = standing_point<T>(like.points, contact.side), beyond = place + outward * point.distance;
  point.a = of_a ? place : beyond;
  point.b = of_a ? beyond : place;
  return manifold;
}

/// Whether a piece has a surface around it that a contact with the other can be a ghost of.
template <class T>
bool is_settled(const LeafInContext<T>& self, const LeafInContext<T>& other) {
  return !(self.whole.convex() && self.beside.empty()) && !is_ground(self.piece) && may_lie(other);
}

/// Whether a contact that has been laid along a normal of the other surface has one of the piece's surface no longer:
/// something rises above the plane through it, be it the piece itself, or covers it.
template <class T>
bool refuses(const LeafInContext<T>& self, const LeafInContext<T>& other, bool of_a, const Manifold<T>& manifold) {
  const Vec3<T> outward = of_a ? manifold.normal : -manifold.normal;
  const Vec3<T> point = standing_point<T>(manifold.points, of_a ? &ContactPoint<T>::a : &ContactPoint<T>::b);
  if (face_along(self, outward) == Vec3<T>{}) {
    // The pieces around are asked below; a body in one piece is none of them.
    if (self.whole.convex() && piece_rises_above(self.piece, self.pose, point, outward)) return true;
    if (neighbour_outside_region(self, point, outward, Among::all)) return true;
  }
  return !lies_open(self, outward) && surface_over(self, point, outward, other);
}

}  // namespace

template <class T>
Settled<T> settle_normal(const LeafInContext<T>& a, const LeafInContext<T>& b, T margin, const Manifold<T>& manifold,
                         T distance) {
  Settled<T> settled{manifold, {}, false};
  Manifold<T>& now = settled.manifold;
  enum class Laid { never, by_a, by_b } laid = Laid::never;  // the last that has laid it anew
  Manifold<T> accepted;                                      // by A, before B is asked
  for (const bool of_a : {true, false}) {
    const LeafInContext<T>&self = of_a ? a : b, &other = of_a ? b : a;
    if (!is_settled(self, other) || now.points.empty()) continue;
    if (!of_a) accepted = now;
    const Vec3<T> outward = of_a ? now.normal : -now.normal, face = face_along(self, outward);
    const bool on_face = face != Vec3<T>{}, tilted = on_face && face != outward;
    Manifold<T> found;
    if (tilted) {
      found = now;
      now = laid_along(a, b, of_a, face, margin, distance, found);
    }
    // Rounding may leave one without points; and a corner or a ball, which stands on the face alone, has none to be
    // laid.
    const bool sliver = now.points.empty();
    const auto side = of_a ? &ContactPoint<T>::a : &ContactPoint<T>::b;
    const SeenContact<T> seen{sliver ? found : now, side, on_face ? face : outward, on_face, distance};
    const auto right = least_deep(self, other, seen, corrected(self, other, seen, margin));
    if (right && !right->elsewhere) {
      if (!sliver) found = now;
      now = laid_along(a, b, of_a, right->normal, margin, distance, found);
      if (now.points.empty() && !right->least_way) now = poking_corner(self, other, of_a, right->normal, found);
    }
    if (right && is_of_another_piece(self, other, *right, now)) {
      now = between_same_pieces(now);
      settled.instead = manifold;
      settled.instead_is_ghost = true;
    } else if (right) {
      if (right->least_way)
        add_deepest(self, of_a, *right->least_way, found, now);
      else if (is_beside(self, other, seen, now))
        now = between_same_pieces(now);
      // Whether the two are as deep as that at all, nothing laid along the normal has shown.
      if (now.points.empty()) settled.instead = touching_point(self, other, of_a, seen, right->normal, found);
    } else if (sliver) {
      const Manifold<T> corner = furthest_below(self, other, of_a, face, found);
      if (reaches_to(self, corner.points[0].*side))
        now = corner;
      else if (distance > T(0))
        now = beside_edge(self, of_a, outward, face, found);
      else
        settled.instead = found;
    }
    if (right) laid = of_a ? Laid::by_a : Laid::by_b;
  }
  // A is asked again of what B lays anew, and B of what a mover lays as A.
  if (now.points.empty()) return settled;
  if (laid == Laid::by_b && is_settled(a, b) && refuses(a, b, true, now)) {
    settled.instead = accepted;
    now = between_same_pieces(now);
  } else if (laid == Laid::by_a && is_of_mover(a) && refuses(b, a, false, now)) {
    settled.instead = manifold;
    settled.instead_is_ghost = true;
    now = between_same_pieces(now);
  }
  return settled;
}

template Settled<float> settle_normal(const LeafInContext<float>&, const LeafInContext<float>&, float,
                                      const Manifold<float>&, float);
template Settled<double> settle_normal(const LeafInContext<double>&, const LeafInContext<double>&, double,
                                       const Manifold<double>&, double);

}  // namespace graze
