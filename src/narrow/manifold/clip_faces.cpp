#include "narrow/manifold/clip_faces.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/manifold/polygon.hpp"

namespace graze {

namespace {

using Flat = FlatPoint<double>;
using Outline = SmallVector<Flat, 32>;

struct Basis {
  Vec3d u, v, n;
  Flat flat(const Vec3d& p) const { return {dot(p, u), dot(p, v)}; }
  Vec3d point(const Flat& p, double height) const { return u * p.x + v * p.y + n * height; }
};

/// A corner of a face with the edge that begins there.
struct FlatEdge {
  Flat from;
  double x, y, squared;  ///< the vector to the next corner
  std::uint32_t id;      ///< number of the corner

  /// Twice the signed area of the triangle with a point: positive where that lies to the left.
  double left(const Flat& p) const { return x * (p.y - from.y) - y * (p.x - from.x); }
};

/// A face seen along the normal, counter-clockwise, with the height of its plane or line over any point.
class FlatFace {
 public:
  FlatFace(const PlacedFace& face, const Basis& basis, bool reversed) : face_(face) {
    const std::size_t n = face.vertices.size();
    const Vec3d* vertices = face.vertices.data();
    const std::uint32_t* ids = face.ids.data();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = reversed ? n - 1 - i : i;
      FlatEdge& edge = edges_.emplace_back();
      edge.from = basis.flat(vertices[k]);
      edge.id = ids[k];
    }
    FlatEdge* const edges = edges_.data();
    for (std::size_t i = 0; i < n; ++i) {
      const Flat &from = edges[i].from, &to = edges[i + 1 == n ? 0 : i + 1].from;
      edges[i].x = to.x - from.x;
      edges[i].y = to.y - from.y;
      edges[i].squared = edges[i].x * edges[i].x + edges[i].y * edges[i].y;
    }
    base_ = dot(face.vertices[reversed ? n - 1 : 0], basis.n);
    slope(basis, dot(face.vertices[reversed ? 0 : n - 1], basis.n));
  }

  std::size_t size() const { return edges_.size(); }
  const Flat& operator[](std::size_t i) const { return edges_[i].from; }
  const FlatEdge& edge(std::size_t i) const { return edges_[i]; }
  double height(const Flat& p) const {
    const Flat& first = edges_[0].from;
    return base_ + slope_x_ * (p.x - first.x) + slope_y_ * (p.y - first.y);
  }
  /// The squared length of the shortest edge; infinite for a vertex.
  double shortest_edge_squared() const {
    double shortest = std::numeric_limits<double>::infinity();
    if (size() > 1)
      for (const FlatEdge& edge : edges_) shortest = least(shortest, edge.squared);
    return shortest;
  }

  /// The feature of the face that a point on it lies on, within `near`: a vertex, an edge or the face.
  std::uint32_t feature(const Flat& p, double near) const {
    const std::size_t n = edges_.size();
    const FlatEdge* const edges = edges_.data();
    if (n == 1) return vertex_feature(edges[0].id);
    if (n == 2) {
      for (std::size_t i = 0; i < 2; ++i)
        if (distance_squared(p, edges[i].from) <= near * near) return vertex_feature(edges[i].id);
      return edge_feature(edges[0].id, edges[1].id);
    }
    // The first edge that it lies on, and whether it also lies on the next one or, where that is the first of all, the
    // last.
    std::size_t first = n;
    bool on_next = false, on = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double inside = edges[i].left(p);
      on = (inside <= 0) | (inside * inside <= near * near * edges[i].squared);
      on_next |= on & (first + 1 == i);
      first = (on & (first == n)) ? i : first;
    }
    if (first == n) return face_feature(face_.id);
    const std::size_t after = first + 1 == n ? 0 : first + 1;
    if (on_next) return vertex_feature(edges[after].id);
    return first == 0 && on ? vertex_feature(edges[0].id) : edge_feature(edges[first].id, edges[after].id);
  }

 private:
  void slope(const Basis& basis, double last) {
    if (size() == 1) return;
    if (size() == 2) {
      const FlatEdge& edge = edges_[0];
      const double rise = edge.squared > 0 ? (last - base_) / edge.squared : 0;
      slope_x_ = rise * edge.x;
      slope_y_ = rise * edge.y;
      return;
    }
    const Vec3d m = polygon_normal(face_);
    const double up = dot(m, basis.n);
    if (up == 0) return;
    slope_x_ = -dot(m, basis.u) / up;
    slope_y_ = -dot(m, basis.v) / up;
  }

  const PlacedFace& face_;
  SmallVector<FlatEdge, 16> edges_;
  double base_, slope_x_ = 0, slope_y_ = 0;
};

/// Keeps the part of an outline left of the line along an edge (Sutherland, Hodgman 1974, "Reentrant polygon
/// clipping"); of a segment also a part no further to the right than `beside`. Returns whether anything was to the
/// right: `kept` is written only then.
bool cut(const Outline& subject, const FlatEdge& edge, bool closed, double beside, Outline& kept) {
  const std::size_t n = subject.size();
  const Flat* points = subject.data();
  const double outside = closed ? 0 : -beside * std::sqrt(edge.squared);
  SmallVector<double, 32> sides;
  bool all = true;
  for (std::size_t k = 0; k < n; ++k) {
    const double side = edge.left(points[k]);
    sides.push_back(side);
    all &= side >= outside;
  }
  if (all) return false;
  kept.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t after = k + 1 == n ? 0 : k + 1;
    const Flat &from = points[k], &to = points[after];
    const double at = sides[k], next = sides[after];
    if (at >= outside) kept.push_back(from);
    if (k + 1 == n && !closed) break;
    if ((at >= outside) != (next >= outside)) {
      const double t = std::clamp(at / (at - next), 0.0, 1.0);
      kept.push_back({from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t});
    }
  }
  return true;
}

/// Appends the ends of the stretch along which two edges overlap, each end on both: nothing unless the edges are
/// parallel up to the lean that makes a face.
void along_each_other(const FlatFace& a, const FlatFace& b, const Basis& basis, double near, FaceContacts& contacts) {
  const double ax = a[1].x - a[0].x, ay = a[1].y - a[0].y, bx = b[1].x - b[0].x, by = b[1].y - b[0].y;
  const double la = ax * ax + ay * ay, lb = bx * bx + by * by, across = ax * by - ay * bx, along = ax * bx + ay * by;
  if (!(la > 0 && lb > 0) || across * across > face_lean<double> * face_lean<double> * la * lb) return;
  const auto add = [&](const Flat& p, const Flat& q) {
    contacts.push_back(
        {basis.point(p, a.height(p)), basis.point(q, b.height(q)), feature_id(a.feature(p, near), b.feature(q, near))});
  };
  const auto point_of_a = [&](double s) { return Flat{a[0].x + ax * s, a[0].y + ay * s}; };
  const auto point_of_b = [&](const Flat& p) {
    const double t = ((p.x - b[0].x) * ax + (p.y - b[0].y) * ay) / along;
    return Flat{b[0].x + bx * t, b[0].y + by * t};
  };
  const auto place = [&](const Flat& q) { return ((q.x - a[0].x) * ax + (q.y - a[0].y) * ay) / la; };
  const std::size_t low = place(b[0]) <= place(b[1]) ? 0 : 1, high = 1 - low;
  const double from = place(b[low]), to = place(b[high]);
  if (from > 1 || to < 0) return;
  from > 0 ? add(point_of_a(from), b[low]) : add(a[0], point_of_b(a[0]));
  to < 1 ? add(point_of_a(to), b[high]) : add(a[1], point_of_b(a[1]));
}

/// Shows a cut along side `i` of the cutting face.
void show_cut(const FlatFace& clip, std::size_t i, const FlatFace& subject, const Outline& left, const Basis& basis,
              CutObserver& observer) {
  const auto on = [&](const FlatFace& face, const Flat& p) { return basis.point(p, face.height(p)); };
  std::vector<Vec3d> remainder;
  for (const Flat& p : left) remainder.push_back(on(subject, p));
  observer.cut(on(clip, clip[i]), on(clip, clip[i + 1 == clip.size() ? 0 : i + 1]), remainder);
}

double nearness(const FlatFace& a, const FlatFace& b) {
  return same_place * std::sqrt(least(a.shortest_edge_squared(), b.shortest_edge_squared()));
}

}  // namespace

Vec3d polygon_normal(const PlacedFace& face) {
  Vec3d sum;
  const std::size_t n = face.vertices.size();
  const Vec3d& origin = face.vertices[0];
  for (std::size_t i = 1; i + 1 < n; ++i) sum += cross(face.vertices[i] - origin, face.vertices[i + 1] - origin);
  return unit(sum, Vec3d{});
}

std::uint32_t feature_at(const PlacedFace& a, const Vec3d& on_a, const PlacedFace& b, const Vec3d& on_b,
                         const Vec3d& normal) {
  const bool vertex_a = a.vertices.size() == 1, vertex_b = b.vertices.size() == 1;
  if (vertex_a && vertex_b) return feature_id(vertex_feature(a.ids[0]), vertex_feature(b.ids[0]));
  const Vec3d u = any_perpendicular(normal);
  const Basis basis{u, cross(normal, u), normal};
  if (vertex_a || vertex_b) {
    const FlatFace face(vertex_a ? b : a, basis, vertex_a);
    const std::uint32_t feature = face.feature(basis.flat(vertex_a ? on_b : on_a), nearness(face, face));
    return vertex_a ? feature_id(vertex_feature(a.ids[0]), feature) : feature_id(feature, vertex_feature(b.ids[0]));
  }
  const FlatFace fa(a, basis, false), fb(b, basis, true);
  const double near = nearness(fa, fb);
  return feature_id(fa.feature(basis.flat(on_a), near), fb.feature(basis.flat(on_b), near));
}

void clip_faces(const PlacedFace& a, const PlacedFace& b, const Vec3d& normal, double beside, FaceContacts& contacts,
                CutObserver* observer) {
  if (a.vertices.size() < 2 || b.vertices.size() < 2) return;
  const Vec3d u = any_perpendicular(normal);
  const Basis basis{u, cross(normal, u), normal};
  // A's face is counter-clockwise seen against the normal, B's seen along it.
  const FlatFace fa(a, basis, false), fb(b, basis, true);
  const double near = nearness(fa, fb);
  if (fa.size() == 2 && fb.size() == 2) return along_each_other(fa, fb, basis, near, contacts);

  // An edge is cut by a polygon, never the reverse.
  const FlatFace &subject = fb.size() == 2 ? fb : fa, &clip = fb.size() == 2 ? fa : fb;
  Outline one, other, *now = &one, *next = &other;
  for (std::size_t i = 0; i < subject.size(); ++i) one.push_back(subject[i]);
  for (std::size_t i = 0; i < clip.size() && !now->empty(); ++i) {
    if (cut(*now, clip.edge(i), subject.size() > 2, along_rim * near + beside, *next)) std::swap(now, next);
    if (observer) show_cut(clip, i, subject, *now, basis, *observer);
  }
  Outline& outline = *now;
  simplify(outline, near, [&](const Flat& p) { return fb.height(p) - fa.height(p); });
  for (const Flat& p : outline)
    contacts.push_back({basis.point(p, fa.height(p)), basis.point(p, fb.height(p)),
                        feature_id(fa.feature(p, near), fb.feature(p, near))});
}

}  // namespace graze
