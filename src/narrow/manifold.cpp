#include "narrow/manifold.hpp"

#include <algorithm>
#include <cmath>

namespace graze {

namespace {

/// A feature takes 16 bits: two for its kind, fourteen for its number. Larger numbers wrap, which can only make two
/// features that touch at the same time share a name in shapes of more than 16,384 parts.
constexpr std::uint32_t number_bits = 14, number_mask = (1u << number_bits) - 1;
constexpr std::uint32_t of_kind(std::uint32_t kind, std::uint32_t number) {
  return (kind << number_bits) | (number & number_mask);
}

/// Coordinates across the normal and along it.
struct Flat {
  double x, y, height;
};

struct Basis {
  Vec3d u, v, n;
  Flat flat(const Vec3d& p) const { return {dot(p, u), dot(p, v), dot(p, n)}; }
  Vec3d point(double x, double y, double height) const { return u * x + v * y + n * height; }
};

/// The polygon of an intersection in the making. `edge` is the feature that the side from this vertex to the next
/// lies on. "A" is the face that is cut here, "B" the one that cuts.
struct Corner {
  double x, y;
  std::uint32_t feature_a, feature_b;
  std::uint32_t edge_a;  ///< A's edge that leaves this corner; 0 when the side is one of B's
};
using Corners = SmallVector<Corner, 32>;

/// A face seen along the normal, counter-clockwise, with the height of its plane or line over any point.
class FlatFace {
 public:
  FlatFace(const PlacedFace& face, const Basis& basis, bool reversed) : face_(face) {
    const std::size_t n = face.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = reversed ? n - 1 - i : i;
      flat_.push_back(basis.flat(face.vertices[k]));
      ids_.push_back(face.ids[k]);
    }
    slope(basis);
  }

  std::size_t size() const { return flat_.size(); }
  const Flat& operator[](std::size_t i) const { return flat_[i]; }
  std::uint32_t vertex(std::size_t i) const { return vertex_feature(ids_[i]); }
  std::uint32_t edge(std::size_t i) const { return edge_feature(ids_[i], ids_[(i + 1) % size()]); }
  std::uint32_t whole() const { return size() == 2 ? edge(0) : face_feature(face_.id); }
  double height(double x, double y) const {
    return flat_[0].height + slope_x_ * (x - flat_[0].x) + slope_y_ * (y - flat_[0].y);
  }

 private:
  void slope(const Basis& basis) {
    if (size() == 2) {
      const double dx = flat_[1].x - flat_[0].x, dy = flat_[1].y - flat_[0].y, l = dx * dx + dy * dy;
      const double rise = l > 0 ? (flat_[1].height - flat_[0].height) / l : 0;
      slope_x_ = rise * dx;
      slope_y_ = rise * dy;
      return;
    }
    const Vec3d m = polygon_normal(face_);
    const double up = dot(m, basis.n);
    if (up == 0) return;
    slope_x_ = -dot(m, basis.u) / up;
    slope_y_ = -dot(m, basis.v) / up;
  }

  const PlacedFace& face_;
  SmallVector<Flat, 16> flat_;
  SmallVector<std::uint32_t, 16> ids_;
  double slope_x_ = 0, slope_y_ = 0;
};

/// Keeps what lies left of `clip`'s edge i (Sutherland, Hodgman 1974, "Reentrant polygon clipping").
Corners cut(const Corners& subject, const FlatFace& clip, std::size_t i, bool closed, std::uint32_t whole) {
  const Flat &p = clip[i], &q = clip[(i + 1) % clip.size()];
  const double ex = q.x - p.x, ey = q.y - p.y;
  const auto side = [&](const Corner& c) { return ex * (c.y - p.y) - ey * (c.x - p.x); };
  Corners kept;
  const std::size_t n = subject.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Corner& from = subject[k];
    const double at = side(from);
    if (at >= 0) kept.push_back(from);
    if (k + 1 == n && !closed) break;
    const Corner& to = subject[(k + 1) % n];
    const double next = side(to);
    if ((at >= 0) == (next >= 0)) continue;
    const double t = at / (at - next);
    Corner crossing{from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t, from.edge_a, 0, 0};
    // A's edge crosses B's, or a side that is B's already ends at the corner where two of B's edges meet.
    if (from.edge_a != 0) {
      crossing.feature_b = clip.edge(i);
    } else {
      crossing.feature_a = whole;
      crossing.feature_b = clip.vertex(at >= 0 ? i : (i + 1) % clip.size());
    }
    if (at < 0) crossing.edge_a = from.edge_a;  // entering: the rest of the side; leaving, the next side is B's edge
    kept.push_back(crossing);
  }
  return kept;
}

Corners corners_of(const FlatFace& subject, const FlatFace& other) {
  Corners corners;
  for (std::size_t i = 0; i < subject.size(); ++i)
    corners.push_back({subject[i].x, subject[i].y, subject.vertex(i), other.whole(), subject.edge(i)});
  return corners;
}

/// The ends of the stretch that two edges run along each other, each end on both: nothing unless they are parallel up to
/// the lean that makes a face.
void along_each_other(const FlatFace& a, const FlatFace& b, const Basis& basis, FaceContacts& contacts) {
  const double ax = a[1].x - a[0].x, ay = a[1].y - a[0].y, bx = b[1].x - b[0].x, by = b[1].y - b[0].y;
  const double la = ax * ax + ay * ay, lb = bx * bx + by * by, cross = ax * by - ay * bx, along = ax * bx + ay * by;
  if (!(la > 0 && lb > 0) || cross * cross > face_lean<double> * face_lean<double> * la * lb) return;
  const auto add = [&](double s, double t, std::uint32_t feature_a, std::uint32_t feature_b) {
    contacts.push_back({basis.point(a[0].x + ax * s, a[0].y + ay * s, a[0].height + (a[1].height - a[0].height) * s),
                        basis.point(b[0].x + bx * t, b[0].y + by * t, b[0].height + (b[1].height - b[0].height) * t),
                        feature_id(feature_a, feature_b)});
  };
  const auto on_a = [&](std::size_t i) { return ((b[i].x - a[0].x) * ax + (b[i].y - a[0].y) * ay) / la; };
  const auto on_b = [&](std::size_t i) { return ((a[i].x - b[0].x) * ax + (a[i].y - b[0].y) * ay) / along; };
  const std::size_t low = on_a(0) <= on_a(1) ? 0 : 1, high = 1 - low;
  const double from = on_a(low), to = on_a(high);
  if (from > 1 || to < 0) return;
  from > 0 ? add(from, static_cast<double>(low), a.edge(0), b.vertex(low)) : add(0, on_b(0), a.vertex(0), b.edge(0));
  to < 1 ? add(to, static_cast<double>(high), a.edge(0), b.vertex(high)) : add(1, on_b(1), a.vertex(1), b.edge(0));
}

}  // namespace

std::uint32_t feature_id(std::uint32_t of_a, std::uint32_t of_b) { return (of_a << 16) | of_b; }
std::uint32_t vertex_feature(std::uint32_t vertex) { return of_kind(1, vertex); }
std::uint32_t edge_feature(std::uint32_t vertex, std::uint32_t other) {
  const std::uint32_t low = std::min(vertex, other), high = std::max(vertex, other);
  return of_kind(2, low * 127 + high);
}
std::uint32_t face_feature(std::uint32_t face) { return of_kind(3, face); }

Vec3d polygon_normal(const PlacedFace& face) {
  Vec3d sum;
  const std::size_t n = face.vertices.size();
  const Vec3d& origin = face.vertices[0];
  for (std::size_t i = 1; i + 1 < n; ++i) sum += cross(face.vertices[i] - origin, face.vertices[i + 1] - origin);
  return unit(sum, Vec3d{});
}

void lay_over(const PlacedFace& a, const PlacedFace& b, const Vec3d& normal, FaceContacts& contacts) {
  if (a.vertices.size() < 2 || b.vertices.size() < 2) return;
  const Vec3d u = any_perpendicular(normal);
  const Basis basis{u, cross(normal, u), normal};
  // A's face is counter-clockwise seen against the normal, B's seen along it.
  const FlatFace fa(a, basis, false), fb(b, basis, true);
  if (fa.size() == 2 && fb.size() == 2) return along_each_other(fa, fb, basis, contacts);

  // An edge is cut by a polygon, never the reverse.
  const bool swapped = fb.size() == 2;
  const FlatFace &subject = swapped ? fb : fa, &clip = swapped ? fa : fb;
  Corners corners = corners_of(subject, clip);
  for (std::size_t i = 0; i < clip.size() && !corners.empty(); ++i)
    corners = cut(corners, clip, i, subject.size() > 2, subject.whole());
  for (const Corner& c : corners) {
    const std::uint32_t feature = swapped ? feature_id(c.feature_b, c.feature_a) : feature_id(c.feature_a, c.feature_b);
    contacts.push_back(
        {basis.point(c.x, c.y, fa.height(c.x, c.y)), basis.point(c.x, c.y, fb.height(c.x, c.y)), feature});
  }
}

}  // namespace graze
