#include "narrow/sat/polyhedron.hpp"

#include <algorithm>
#include <array>

#include "narrow/box_parts.hpp"

namespace graze {

namespace {

/// Height difference within which vertices are level, relative to their coordinates: some roundings.
constexpr double same_height = 64 * std::numeric_limits<double>::epsilon();

/// Faces at each vertex of a flat polygon: its front and its back.
constexpr std::array<std::uint32_t, 2> front_and_back{0, 1};
/// Faces at each vertex of a box: all of them, because where a side has zero length, as in a rectangle, the first of
/// two vertices at one place may not be on the face along a direction.
constexpr std::array<std::uint32_t, 6> faces_of_box{0, 1, 2, 3, 4, 5};

/// Height of a triangle, relative to its longest side, below which the separating-axis test takes it for an edge: a
/// thicker one has half of double's digits left for its normal.
constexpr double slenderest = 1e-6;

}  // namespace

template <class T>
Vec3d triangle_normal(const Triangle<T>& t) {
  const Vec3d p = converted<double>(t.point(0)), u = converted<double>(t.point(1)) - p,
              v = converted<double>(t.point(2)) - p;
  const double longest = greatest(length_squared(u), greatest(length_squared(v), length_squared(v - u)));
  const Vec3d n = cross(u, v);
  return length_squared(n) > slenderest * slenderest * longest * longest ? n : Vec3d{};
}

template <class T>
std::size_t Polyhedron::edge_count(const Shape<T>& shape) {
  if (shape.template as<Box<T>>() || shape.template as<Rectangle<T>>()) return box_parts.edges.size();
  if (const auto* triangle = shape.template as<Triangle<T>>()) return triangle_normal(*triangle) == Vec3d{} ? 0 : 6;
  if (const auto* hull = shape.template as<ConvexHull<T>>()) {
    const HullData<T>& data = hull->data();
    return data.dimension == 3 ? data.edges.size() : data.dimension == 2 ? 2 * data.edges.size() : 0;
  }
  return 0;
}

template <class T>
void Polyhedron::set(const Box<T>& box) {
  const Vec3d h = converted<double>(box.half_extents());
  for (int i = 0; i < 8; ++i) vertices_.push_back({i & 1 ? h.x : -h.x, i & 2 ? h.y : -h.y, i & 4 ? h.z : -h.z});
  for (const Vec3d& n : {Vec3d{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}})
    normals_.push_back(n);
  edges_ = box_parts.edges;
  begins_ = box_parts.begins;
  loops_ = box_parts.loops;
  incident_begins_ = {};
  incident_ = faces_of_box;
}

template <class T>
void Polyhedron::set(const Triangle<T>& triangle) {
  const Vec3d n = unit(triangle_normal(triangle));
  for (std::size_t i = 0; i < 3; ++i) vertices_.push_back(converted<double>(triangle.point(i)));
  normals_.push_back(n);
  normals_.push_back(-n);
  for (const std::uint32_t v : {0u, 1u, 2u, 2u, 1u, 0u}) flat_loops_.push_back(v);
  add_sides();
}

template <class T>
void Polyhedron::set(const ConvexHull<T>& hull) {
  const HullData<T>& data = hull.data();
  for (const Vec3<T>& v : data.vertices) vertices_.push_back(converted<double>(v));
  for (const Plane<T>& plane : data.planes) normals_.push_back(unit(converted<double>(plane.normal)));
  if (data.dimension == 2) {
    for (const std::uint32_t v : data.loops) flat_loops_.push_back(v);
    add_sides();
    return;
  }
  edges_ = data.edges;
  begins_ = data.face_begin;
  loops_ = data.loops;
  incident_begins_ = data.incident_begin;
  incident_ = data.incident;
}

/// Adds the front's edges, each between the front and a side and again between the side and the back.
void Polyhedron::add_sides() {
  const auto count = static_cast<std::uint32_t>(flat_loops_.size() / 2);
  flat_begins_.push_back(0);
  flat_begins_.push_back(count);
  flat_begins_.push_back(2 * count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t from = flat_loops_[i], to = flat_loops_[(i + 1) % count], side = 2 + i;
    normals_.push_back(unit(cross(vertices_[to] - vertices_[from], normals_[0])));
    flat_loops_.push_back(from);
    flat_loops_.push_back(to);
    flat_begins_.push_back(static_cast<std::uint32_t>(flat_loops_.size()));
    flat_edges_.push_back({{from, to}, {0, side}});
    flat_edges_.push_back({{from, to}, {side, 1}});
  }
  edges_ = {flat_edges_.data(), flat_edges_.size()};
  begins_ = {flat_begins_.data(), flat_begins_.size()};
  loops_ = {flat_loops_.data(), flat_loops_.size()};
  incident_begins_ = {};
  incident_ = front_and_back;
}

void Polyhedron::add_offsets() {
  for (std::size_t f = 0; f < normals_.size(); ++f) offsets_.push_back(dot(normals_[f], vertices_[loop(f)[0]]));
}

template <class T>
void Polyhedron::take(const Shape<T>& shape) {
  if (const auto* box = shape.template as<Box<T>>()) return set(*box);
  if (const auto* rectangle = shape.template as<Rectangle<T>>()) return set(rectangle->as_box());
  if (const auto* triangle = shape.template as<Triangle<T>>()) return set(*triangle);
  if (const auto* hull = shape.template as<ConvexHull<T>>()) set(*hull);
}

template <class T>
void Polyhedron::set(const Shape<T>& shape) {
  take(shape);
  add_offsets();
}

template <class T>
void Polyhedron::set(const Shape<T>& shape, const Mat3d& rotation, const Vec3d& translation) {
  take(shape);
  for (Vec3d& v : vertices_) v = rotation * v + translation;
  for (Vec3d& n : normals_) n = rotation * n;
  add_offsets();
}

std::size_t Polyhedron::support_vertex(const Vec3d& direction) const {
  return detail::furthest(vertices_.data(), vertices_.size(), direction);
}

PlacedFace Polyhedron::support_face(const Vec3d& direction) const {
  const auto top = static_cast<std::uint32_t>(support_vertex(direction));
  const auto faces = incident_begins_.empty()
                         ? incident_
                         : incident_.subspan(incident_begins_[top], incident_begins_[top + 1] - incident_begins_[top]);
  // For a direction perpendicular to an edge, the edge's far end is level with the top: a face that has both ends is
  // the edge's own.
  const double level = dot(vertices_[top], direction) - same_height * max_abs(vertices_[top]);
  std::ptrdiff_t most_tied = 0;
  double most = -1;
  std::uint32_t best = 0;
  for (const std::uint32_t f : faces) {
    const double along = dot(normals_[f], direction);
    const auto corners = loop(f);
    const auto tied = std::count_if(corners.begin(), corners.end(),
                                    [&](std::uint32_t v) { return dot(vertices_[v], direction) >= level; });
    if (tied == 0 || along < furthest_lean || tied < most_tied || (tied == most_tied && along <= most)) continue;
    most_tied = tied;
    most = along;
    best = f;
  }

  PlacedFace face;
  const auto push = [&](std::uint32_t v) {
    // Corners that coincide because a side has zero length: the face is less than a polygon.
    if (!face.vertices.empty() && (vertices_[v] == face.vertices.back() || vertices_[v] == face.vertices[0])) return;
    face.vertices.push_back(vertices_[v]);
    face.ids.push_back(v);
  };
  if (most >= furthest_lean) {
    face.id = best;
    for (const std::uint32_t v : loop(face.id)) push(v);
    return face;
  }
  // The edge that falls off least.
  double least_fall = 1 - furthest_lean;
  std::uint32_t other = top;
  for (const HullEdge& e : edges_) {
    if (e.vertex[0] != top && e.vertex[1] != top) continue;
    const std::uint32_t end = e.vertex[0] == top ? e.vertex[1] : e.vertex[0];
    const Vec3d along = vertices_[top] - vertices_[end];
    const double fall = dot(along, direction), l = length(along);
    if (!(l > 0) || fall > least_fall * l) continue;
    least_fall = fall / l;
    other = end;
  }
  push(std::min(top, other));
  push(std::max(top, other));
  return face;
}

template Vec3d triangle_normal(const Triangle<float>&);
template Vec3d triangle_normal(const Triangle<double>&);
template std::size_t Polyhedron::edge_count(const Shape<float>&);
template std::size_t Polyhedron::edge_count(const Shape<double>&);
template void Polyhedron::set(const Shape<float>&);
template void Polyhedron::set(const Shape<double>&);
template void Polyhedron::set(const Shape<float>&, const Mat3d&, const Vec3d&);
template void Polyhedron::set(const Shape<double>&, const Mat3d&, const Vec3d&);

}  // namespace graze
