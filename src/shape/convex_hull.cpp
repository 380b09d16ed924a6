#include "graze/shape/convex_hull.hpp"

#include <algorithm>

#include "graze/shape/triangle.hpp"
#include "shape/furthest_vertex.hpp"
#include "shape/hull_descent.hpp"
#include "shape/hull_hierarchy.hpp"
#include "shape/hull_polygons.hpp"

namespace graze {

namespace {

template <class T>
void fill_flat(HullData<T>& hull, const std::vector<std::uint32_t>& polygon, std::span<const Vec3<T>> points,
               std::span<const GridPoint> grid) {
  const Loops both{polygon, {polygon.rbegin(), polygon.rend()}};
  fill_faces(hull, both, points, grid);
}

template <class T>
void fill_segment(HullData<T>& hull, const std::vector<std::uint32_t>& ends, std::span<const Vec3<T>> points) {
  for (const std::uint32_t v : ends) hull.vertices.push_back(points[v]);
  hull.face_begin = {0};
  hull.incident_begin.assign(ends.size() + 1, 0);
  if (ends.size() == 1) {
    hull.neighbor_begin = {0, 0};
    return;
  }
  hull.edges.push_back({{0, 1}, {HullData<T>::no_face, HullData<T>::no_face}});
  hull.neighbor_begin = {0, 1, 2};
  hull.neighbors = {1, 0};
}

/// A choice that no compiler makes a branch of, for conditions that no processor predicts. Not every standard library
/// has `std::bit_cast`.
template <class N>
N without_jump(bool condition, N yes, N no) {
  using Bits = std::conditional_t<sizeof(N) == 4, std::uint32_t, std::uint64_t>;
  const Bits chosen = Bits(0) - static_cast<Bits>(condition), other = __builtin_bit_cast(Bits, no);
  return __builtin_bit_cast(N, other ^ ((other ^ __builtin_bit_cast(Bits, yes)) & chosen));
}

/// A vertex of a hull, read from the blocks if it has any: a scan has just read these.
template <class T>
Vec3<T> scanned_vertex(const HullData<T>& hull, std::uint32_t v) {
  if constexpr (std::is_same_v<T, float>)
    if (!hull.blocks.empty()) {
      const VertexBlock& block = hull.blocks[v / VertexBlock::size];
      const std::size_t k = v % VertexBlock::size;
      return {block.x[k], block.y[k], block.z[k]};
    }
  return hull.vertices[v];
}

/// The vertices that lie as high along a direction as the highest, within rounding.
template <class T>
class HighVertices {
 public:
  HighVertices(const ConvexHull<T>& hull, const Vec3<T>& direction) : hull_(hull.data()), direction_(direction) {
    const T below = T(64) * std::numeric_limits<T>::epsilon() * hull_.extent;
    if constexpr (std::is_same_v<T, float>) by_bits_ = !hull_.blocks.empty();
    if (by_bits_) {
      static const auto kernel = GRAZE_KERNEL(chosen_isa(), highest_vertices);
      HighestVertices highest{};
      if constexpr (std::is_same_v<T, float>) highest = kernel(scanned(hull_), direction, below);
      top_ = highest.top;
      bits_ = highest.bits;
      several_ = (bits_ & (bits_ - 1)) != 0;
    } else {
      top_ = static_cast<std::uint32_t>(hull.support_vertex(direction));
      level_ = dot(hull_.vertices[top_], direction) - below;
      // Another vertex is as high only where a neighbour of the top is.
      const auto beside = hull_.around(top_);
      several_ = std::any_of(beside.begin(), beside.end(), [&](std::uint32_t v) { return has(v); });
    }
  }

  std::uint32_t top() const { return top_; }
  bool several() const { return several_; }
  std::ptrdiff_t among(std::span<const std::uint32_t> vertices) const {
    return std::count_if(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return has(v); });
  }

 private:
  bool has(std::uint32_t v) const {
    return by_bits_ ? (bits_ >> v & 1) != 0 : dot(hull_.vertices[v], direction_) >= level_;
  }

  const HullData<T>& hull_;
  Vec3<T> direction_;
  T level_ = 0;
  bool by_bits_ = false, several_ = false;
  std::uint32_t top_ = 0;
  VertexBits bits_ = 0;
};

}  // namespace

template <class T>
ConvexHull<T>::ConvexHull(std::span<const Vec3<T>> given) {
  if (given.empty()) throw InvalidValue("points", "at least one point", "none");
  std::vector<Vec3<T>> resolved;
  resolved.reserve(given.size());
  std::vector<Vec3d> precise;
  precise.reserve(given.size());
  double largest = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    resolved.push_back(validate::resolved(validate::point(given[i], "points[" + std::to_string(i) + "]")));
    precise.push_back(converted<double>(resolved.back()));
    largest = std::max(largest, max_abs(precise.back()));
  }
  const std::span<const Vec3<T>> points = resolved;
  auto hull = std::make_shared<HullData<T>>();
  const Grid grid = to_grid(precise);
  // The error of a plane through three points by the rounding of their coordinates, and the grid's step.
  const double merge = 4 * (grid.step + static_cast<double>(std::numeric_limits<T>::epsilon()) * largest);
  hull->tolerance = static_cast<T>(2 * merge);

  const HullSurface surface = hull_surface(grid.points);
  hull->dimension = surface.dimension;
  if (surface.dimension == 3) {
    fill_faces(*hull, merged_loops(surface.triangles, precise, merge), points, grid.points);
    std::vector<Vec3d> kept;
    for (const Vec3<T>& v : hull->vertices) kept.push_back(converted<double>(v));
    build_hierarchy(*hull, to_grid(kept).points);
  } else if (surface.dimension == 2) {
    fill_flat(*hull, surface.polygon, points, grid.points);
  } else {
    fill_segment(*hull, surface.polygon, points);
  }
  for (const Vec3<T>& v : hull->vertices) hull->extent = greatest(hull->extent, length(v));
  fill_blocks(*hull);
  data_ = std::move(hull);
}

template <class T>
template <class S>
std::size_t ConvexHull<T>::support_vertex(const Vec3<S>& direction) const {
  const HullData<T>& hull = *data_;
  if (!hull.blocks.empty()) {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), furthest_vertex<T, S>);
    return kernel(scanned(hull), direction);
  }
  if (hull.hierarchy.empty()) return detail::furthest(hull.vertices.data(), hull.vertices.size(), direction);
  return descended(hull, direction);
}

template <class T>
void ConvexHull<T>::core_face(const Vec3<T>& direction, Face<T>& face, T lean) const {
  const HullData<T>& hull = *data_;
  face.clear();
  const Vec3<T> n = normalized(direction);
  const auto faces = static_cast<std::uint32_t>(hull.planes.size());

  // An edge across the direction has its far end as high: a face that has both ends is the edge's own.
  const HighVertices<T> high(*this, n);
  const std::uint32_t top = high.top();
  std::uint32_t best = HullData<T>::no_face;
  std::ptrdiff_t most_tied = 0;
  T least_squared = lean * lean;
  for (const std::uint32_t f : hull.faces_at(top)) {
    const Vec3<T>& m = hull.planes[f].normal;
    const T squared_sine = length_squared(cross(m, n));
    const std::ptrdiff_t tied = high.several() ? high.among(hull.loop(f)) : 1;
    // A branch on which of them is better would be mispredicted often.
    const bool leans_little = (dot(m, n) > T(0)) & (squared_sine <= lean * lean);
    const bool better = leans_little & ((tied > most_tied) | ((tied == most_tied) & (squared_sine <= least_squared)));
    most_tied = without_jump(better, tied, most_tied);
    least_squared = without_jump(better, squared_sine, least_squared);
    best = without_jump(better, f, best);
  }
  if (best != HullData<T>::no_face) {
    for (const std::uint32_t v : hull.loop(best)) face.push(scanned_vertex(hull, v), v);
    face.id = best;
    return;
  }
  T least_lean = lean;
  for (const std::uint32_t v : hull.around(top)) {
    const Vec3<T> edge = hull.vertices[top] - hull.vertices[v];
    const T fall = dot(edge, n) / length(edge);
    if (fall > least_lean) continue;
    least_lean = fall;
    best = v;
  }
  face.push(hull.vertices[top], top);
  face.id = faces + top;
  if (best == HullData<T>::no_face) return;
  face.push(hull.vertices[best], best);
  face.id = faces + static_cast<std::uint32_t>(hull.vertices.size()) + least(top, best);
}

template <class T>
Aabb<T> ConvexHull<T>::core_bounds(const Pose<T>& pose) const {
  const Mat3<T> m = rotation_matrix(pose.rotation);
  Vec3<T> lower, upper;
  for (std::size_t i = 0; i < 3; ++i) {
    upper[i] = dot(m.row[i], data_->vertices[support_vertex(m.row[i])]);
    lower[i] = dot(m.row[i], data_->vertices[support_vertex(-m.row[i])]);
  }
  return {pose.translation + lower, pose.translation + upper};
}

template class ConvexHull<float>;
template class ConvexHull<double>;
template std::size_t ConvexHull<float>::support_vertex(const Vec3<float>&) const;
template std::size_t ConvexHull<float>::support_vertex(const Vec3<double>&) const;
template std::size_t ConvexHull<double>::support_vertex(const Vec3<double>&) const;

}  // namespace graze
