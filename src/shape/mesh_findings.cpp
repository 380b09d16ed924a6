#include "graze/shape/mesh_findings.hpp"

#include <algorithm>
#include <numeric>

#include "shape/mesh_data.hpp"
#include "shape/mesh_topology.hpp"

namespace graze {

namespace {

using Index = std::array<std::uint32_t, 3>;

/// The height of a triangle, as a part of its longest side, below which it is a sliver: remeshing tools call such a
/// triangle degenerate.
constexpr double sliver_height = 1e-3;

/// The distance from an edge, as a part of its length, within which a corner lies on it: the reach by which contacts
/// decide as well (`on_piece` in `leaf_in_context.hpp`).
constexpr double on_edge = 1e-4;

/// The number of the first point that lies at the place of each point.
template <class T>
std::vector<std::uint32_t> first_at_place(std::span<const Vec3<T>> points) {
  std::vector<std::uint32_t> sorted(points.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Vec3<T>&p = points[i], &q = points[j];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : i < j;
  });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool same = i > 0 && points[sorted[i]] == points[sorted[i - 1]];
    first[sorted[i]] = same ? first[sorted[i - 1]] : sorted[i];
  }
  return first;
}

/// One side of a triangle: its ends by number, the lesser first, and the corner across from it.
struct Side {
  std::uint32_t low, high, across;
  std::uint32_t triangle;
  bool upwards;  ///< run through from the lesser to the greater
};

bool same_edge(const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; }

/// The search for findings, in `double`, so that no area is lost for being small beside the coordinates' scalar.
template <class T>
class Finder {
 public:
  explicit Finder(const Mesh<T>& mesh) : mesh_(mesh.data()), place_(first_at_place<T>(mesh.points())) {}

  MeshFindings found() {
    for (std::uint32_t i = 0; i < place_.size(); ++i) out_.repeated_points += place_[i] != i ? 1 : 0;
    judge_triangles();
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    for (auto at = sides_.begin(); at != sides_.end();) {
      const auto end = std::find_if(at, sides_.end(), [&](const Side& side) { return !same_edge(side, *at); });
      judge_edge(std::span<const Side>(&*at, static_cast<std::size_t>(end - at)));
      at = end;
    }
    return out_;
  }

 private:
  Vec3d point(std::uint32_t number) const { return converted<double>(mesh_.points[number]); }

  void judge_triangles() {
    const std::vector<std::uint32_t> different = different_triangles<T>(mesh_.points, mesh_.triangles);
    out_.triangles = mesh_.triangles.size();
    out_.repeated_triangles = out_.triangles - different.size();
    sides_.reserve(3 * different.size());
    normals_.resize(mesh_.triangles.size());
    for (const std::uint32_t i : different) judge_triangle(i);
  }

  void judge_triangle(std::uint32_t number) {
    const Index& t = mesh_.triangles[number];
    const Vec3d a = point(t[0]), b = point(t[1]), c = point(t[2]), area = cross(b - a, c - a);
    const double longest = greatest(length(b - a), greatest(length(c - b), length(a - c)));
    const double height = longest > 0 ? length(area) / longest : 0;
    // A triangle as low as the rounding of its coordinates is a line.
    const double rounding = 2.0 * static_cast<double>(std::numeric_limits<T>::epsilon()) *
                            greatest(max_abs(a), greatest(max_abs(b), max_abs(c)));
    if (!(height > rounding)) {
      ++out_.without_area;
      return;
    }
    if (height < sliver_height * longest) ++out_.slivers;
    normals_[number] = normalized(area);
    const Index at{place_[t[0]], place_[t[1]], place_[t[2]]};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = at[k], to = at[(k + 1) % 3];
      sides_.push_back({least(from, to), greatest(from, to), at[(k + 2) % 3], number, from < to});
    }
  }

  void judge_edge(std::span<const Side> sides) {
    if (sides.size() == 1) {
      ++out_.open_edges;
      if (has_corner_inside(sides[0])) ++out_.t_junctions;
    } else if (sides.size() > 2 || sides[0].upwards == sides[1].upwards) {
      ++out_.irregular_edges;
    } else {
      judge_pair(sides[0], sides[1]);
    }
  }

  void judge_pair(const Side& first, const Side& second) {
    const Vec3d &n = normals_[first.triangle], &m = normals_[second.triangle];
    const double height = dot(n, point(second.across) - point(second.low));
    if (length_squared(n - m) < static_cast<double>(level_sine<T>) * static_cast<double>(level_sine<T>))
      ++out_.flat_edges;
    else
      ++(height > 0 ? out_.concave_edges : out_.convex_edges);
  }

  /// Whether the corner of another triangle lies on the edge, its ends apart.
  bool has_corner_inside(const Side& side) const {
    const Vec3d a = point(side.low), along = point(side.high) - a;
    const double reach = on_edge * length(along);
    const Vec3d inverse{1 / (along.x + 0.0), 1 / (along.y + 0.0), 1 / (along.z + 0.0)};
    const auto is_inside = [&](std::uint32_t corner) {
      const Vec3d from = point(corner) - a;
      const double t = dot(from, along) / length_squared(along);
      return t > on_edge && t < 1 - on_edge && length(from - along * t) <= reach;
    };
    const auto has_none = [&](std::uint32_t number) {
      const Index& t = mesh_.triangles[number];
      return number == side.triangle || std::none_of(t.begin(), t.end(), is_inside);
    };
    return !visit_ray(
        mesh_.tree, a, inverse, [] { return 1.0; }, has_none, 0.0, reach);
  }

  const MeshData<T>& mesh_;
  std::vector<std::uint32_t> place_;
  std::vector<Vec3d> normals_;
  std::vector<Side> sides_;
  MeshFindings out_;
};

}  // namespace

template <class T>
MeshFindings findings(const Mesh<T>& mesh) {
  return Finder<T>(mesh).found();
}

template MeshFindings findings(const Mesh<float>&);
template MeshFindings findings(const Mesh<double>&);

}  // namespace graze
