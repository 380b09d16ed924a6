// Cores with curved sides: a polygon inside the Minkowski difference A - B grows where the origin is nearest.
//
// Guarantee: with every step there is a proven lower and upper bound of the distance or the depth, and it ends when
// they meet. No step of GJK's that drops a vertex can go round in circles, since none is dropped: outside, the steps
// are those of GJK (Gilbert, Johnson, Keerthi 1988), inside those of the expanding polytope (van den Bergen 2001), on
// one polygon.
#include <limits>

#include "graze/small_vector.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

namespace {

/// A vertex of the growing polygon: the point of the difference furthest along `direction`.
struct Vertex {
  Vec2d direction;
  CorePoint a, b;
  Vec2d point;
};

/// The point of the polygon's outline nearest to the origin.
struct Foot {
  std::size_t edge = 0;  ///< from vertex `edge` to the next
  double parameter = 0;
  Vec2d point{};
  bool inside = false;  ///< the origin is inside
  Vec2d normal{};       ///< outward, towards the origin where that is outside
  double reach = 0;     ///< of the polygon along the normal
};

constexpr std::size_t most_vertices = 256;

/// The difference as a support function, in A's frame.
template <class T>
struct Difference {
  const Core<T>&a, &b;
  const Pose2d& b_in_a;

  Vertex operator()(const Vec2d& direction) const {
    CorePoint on_b = support(b, -inverse_rotate(b_in_a.rotation, direction));
    on_b.point = transform(b_in_a, on_b.point);
    const CorePoint on_a = support(a, direction);
    return {direction, on_a, on_b, on_a.point - on_b.point};
  }
};

class GrowingPolygon {
 public:
  std::size_t size() const { return vertices_.size(); }
  const Vertex& operator[](std::size_t i) const { return vertices_[i]; }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  void push(const Vertex& v) { vertices_.push_back(v); }

  /// Puts `v` where its direction belongs, which is near vertex `i`: the foot may be an end of an edge, and the
  /// direction beyond that end's. Directions of neighbours are less than half a turn apart.
  void insert(std::size_t i, const Vertex& v) {
    const auto behind = [&](std::size_t k) { return cross(vertices_[k].direction, v.direction) >= 0; };
    for (std::size_t k = 0; k < size() && !behind(i); ++k) i = i == 0 ? size() - 1 : i - 1;
    for (std::size_t k = 0; k < size() && behind(next(i)); ++k) i = next(i);
    vertices_.push_back(v);
    for (std::size_t k = size() - 1; k > i + 1; --k) vertices_[k] = vertices_[k - 1];
    vertices_[i + 1] = v;
  }

  /// The foot of a difference that is known up to `near`.
  Foot foot(double near) const {
    for (std::size_t i = 0; i < size(); ++i)
      if (length_squared(vertices_[i].point) <= near * near) return at_vertex(i);
    Foot inner;
    double least_reach = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i) {
      const Vec2d p = vertices_[i].point, e = vertices_[next(i)].point - p;
      const double l = length(e);
      if (!(l > 0)) continue;
      const double reach = cross(p, e) / l;
      if (reach < least_reach) {
        least_reach = reach;
        inner = foot_on(i);
        inner.normal = right(e) / l;
        inner.reach = reach;
        inner.inside = true;
      }
    }
    const double allowed = 4 * least_reach * least_reach;
    if (least_reach >= 0 && inner.inside && length_squared(inner.point) <= allowed) return inner;
    // The foot lies on an edge in line with the nearest one, as with polygons, or there is no inside.
    Foot outside = nearest_outside(inner, near);
    if (!(least_reach >= 0 && inner.inside && length_squared(outside.point) <= allowed)) return outside;
    outside.inside = true;
    outside.normal = inner.normal;
    outside.reach = inner.reach;
    return outside;
  }

 private:
  Foot foot_on(std::size_t i) const {
    const Vec2d p = vertices_[i].point, q = vertices_[next(i)].point, e = q - p;
    const double l2 = length_squared(e);
    Foot f;
    f.edge = i;
    f.parameter = l2 > 0 ? clamp(-dot(p, e) / l2, 0.0, 1.0) : 0.0;
    f.point = f.parameter <= 0.5 ? p + e * f.parameter : q - e * (1 - f.parameter);
    return f;
  }
  /// A vertex at the origin, up to what the difference is known to. The way to the origin is rounding there and has no
  /// direction; the one along which the vertex is furthest is a normal, since the difference ends at the origin there.
  Foot at_vertex(std::size_t i) const {
    Foot f;
    f.edge = i;
    f.point = vertices_[i].point;
    f.normal = normalized(vertices_[i].direction);
    f.reach = dot(f.point, f.normal);
    f.inside = f.reach >= 0;
    return f;
  }
  Foot nearest_outside(const Foot& otherwise, double near) const {
    Foot best = otherwise;
    double squared = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i)
      if (const Foot f = foot_on(i); length_squared(f.point) < squared) squared = length_squared(f.point), best = f;
    best.inside = false;
    // Within an edge the normal is both the edge's and the way's to the origin: rounding of the vertices turns the
    // longer of the two least, and the way is all rounding where the edge runs through the origin. The edge faces the
    // origin, unless the difference is thinner than it is known and this is its other side.
    const Vec2d across = right(vertices_[next(best.edge)].point - vertices_[best.edge].point);
    const double squared_across = length_squared(across), beyond = dot(best.point, across);
    const bool within = 0 < best.parameter && best.parameter < 1;
    const bool longer = squared_across > squared;
    const bool faces = beyond <= 0 || beyond * beyond <= near * near * squared_across;
    best.normal = normalized(within && longer && faces ? across : -best.point);
    best.reach = dot(best.point, best.normal);
    return best;
  }

  SmallVector<Vertex, 24> vertices_;
};

TraceSupport in_world(const Pose2d& pose, const Vertex& v) {
  const Vec2d a = transform(pose, v.a.point), b = transform(pose, v.b.point);
  return {{a.x, a.y, 0}, {b.x, b.y, 0}};
}

/// One step of the growth for the trace: those outside are GJK's, those inside EPA's.
void record(const GrowingPolygon& polygon, const Foot& foot, const Vertex& found, const Pose2d& pose, Trace& steps) {
  const Vec2d n = rotate(pose.rotation, foot.normal);
  const double reached = dot(found.point, foot.normal);
  // Shown as B - A, in which a polygon of A - B runs counter-clockwise too.
  std::vector<TraceSupport> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i) vertices.push_back(in_world(pose, polygon[i]));
  if (foot.inside) {
    steps.epa.push_back(
        {{n.x, n.y, 0}, foot.reach, reached, in_world(pose, found), polygon.size() + 1, std::move(vertices)});
    return;
  }
  TraceGjk step;
  step.simplex.push_back(in_world(pose, polygon[foot.edge]));
  if (foot.parameter > 0) step.simplex.push_back(in_world(pose, polygon[polygon.next(foot.edge)]));
  step.direction = {n.x, n.y, 0};
  step.found = in_world(pose, found);
  step.lower = greatest(-reached, steps.gjk.empty() ? 0.0 : steps.gjk.back().lower);
  step.upper = length(foot.point);
  step.polygon = std::move(vertices);
  steps.gjk.push_back(std::move(step));
}

/// The answer on the edge of a foot.
Nearest on_edge(const GrowingPolygon& polygon, const Foot& foot, double distance) {
  const Vertex &p = polygon[foot.edge], &q = polygon[polygon.next(foot.edge)];
  const auto between = [&](const CorePoint& from, const CorePoint& to) {
    const double t = foot.parameter;
    return CorePoint{t <= 0.5 ? from.point + (to.point - from.point) * t : to.point - (to.point - from.point) * (1 - t),
                     t <= 0.5 ? from.feature : to.feature};
  };
  Nearest out;
  out.normal = foot.normal;
  out.distance = distance;
  out.a = between(p.a, q.a);
  out.b = between(p.b, q.b);
  return out;
}

}  // namespace

template <class T>
double accuracy(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size) {
  const bool users = a.kind == CoreKind::user || b.kind == CoreKind::user;
  const double epsilon = users ? double(std::numeric_limits<T>::epsilon()) : std::numeric_limits<double>::epsilon();
  const double rounding = 8 * epsilon * size + 8 * std::numeric_limits<double>::epsilon() * length(b_in_a.translation);
  return greatest(goal * size, rounding);
}

template <class T>
Nearest nearest_curved(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double size, Trace* steps,
                       const Pose2d& pose_a) {
  const Difference<T> difference{a, b, b_in_a};
  GrowingPolygon polygon;
  for (const Vec2d& d : {Vec2d{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) polygon.push(difference(d));
  const double near = accuracy(a, b, b_in_a, size);
  for (;;) {
    const Foot foot = polygon.foot(near);
    const Vertex found = difference(foot.normal);
    const double reached = dot(found.point, foot.normal);
    if (steps) record(polygon, foot, found, pose_a, *steps);
    // Outside: the distance lies between the gap along this normal and the polygon's distance. Inside: the depth lies
    // between the polygon's and what the difference reaches along the normal.
    const double gap = reached - foot.reach;
    const bool met = gap <= near, full = polygon.size() >= most_vertices;
    if (met || full) {
      const double outside = greatest(-reached, 0.0);
      Nearest out = on_edge(polygon, foot, foot.inside ? -reached : outside);
      if (foot.inside) {
        // Along the normal as far as the difference reaches, so that b - a = distance * normal.
        out.a.point += foot.normal * gap;
      }
      if (!met) out.status = Status::bounded, out.error = gap;
      return out;
    }
    polygon.insert(foot.edge, found);
  }
}

template double accuracy(const Core<float>&, const Core<float>&, const Pose2d&, double);
template double accuracy(const Core<double>&, const Core<double>&, const Pose2d&, double);
template Nearest nearest_curved(const Core<float>&, const Core<float>&, const Pose2d&, double, Trace*, const Pose2d&);
template Nearest nearest_curved(const Core<double>&, const Core<double>&, const Pose2d&, double, Trace*, const Pose2d&);

}  // namespace graze::plane
