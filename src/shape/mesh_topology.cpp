#include "shape/mesh_topology.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace graze {

namespace {

using Index = std::array<std::uint32_t, 3>;

bool repeats_corner(const Index& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

template <class T>
bool before(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// A triangle's corners in an order by which two triangles can be compared.
template <class T>
std::array<Vec3<T>, 3> canonical(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  if (a == b || b == c || c == a) {
    const Vec3<T>& other = a == b ? c : b;  // of the two places
    return before(a, other) ? std::array{a, a, other} : std::array{other, other, a};
  }
  if (before(a, b)) return before(a, c) ? std::array{a, b, c} : std::array{c, a, b};
  return before(b, c) ? std::array{b, c, a} : std::array{c, a, b};
}

/// The finaliser of Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators".
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The bits of a number. Not every standard library has `std::bit_cast`.
std::uint64_t bits_of(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

template <class T>
std::uint64_t hash_of(const Vec3<T>& p) {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < 3; ++i)  // + 0: the two zeros are one number
    hash = mixed(hash + 0x9e3779b97f4a7c15u + bits_of(static_cast<double>(p[i]) + 0.0));
  return hash;
}

}  // namespace

EdgeUses::EdgeUses(std::span<const Index> triangles, std::size_t points) : begin_(points + 1, 0) {
  const auto each_use = [&](const auto& f) {
    for (std::uint32_t number = 0; number < triangles.size(); ++number) {
      const Index& t = triangles[number];
      if (repeats_corner(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = t[i], to = t[(i + 1) % 3];
        f(least(from, to), Use{greatest(from, to), number, from < to});
      }
    }
  };
  each_use([&](std::uint32_t low, const Use&) { ++begin_[low + 1]; });
  for (std::size_t i = 0; i < points; ++i) begin_[i + 1] += begin_[i];
  uses_.resize(begin_[points]);
  std::vector<std::uint32_t> filled(begin_.begin(), begin_.end() - 1);
  each_use([&](std::uint32_t low, const Use& use) { uses_[filled[low]++] = use; });
  const auto before = [](const Use& a, const Use& b) {
    return a.high != b.high ? a.high < b.high : a.upwards != b.upwards ? a.upwards : a.triangle < b.triangle;
  };
  for (std::size_t i = 0; i < points; ++i) std::sort(uses_.begin() + begin_[i], uses_.begin() + begin_[i + 1], before);
}

bool EdgeUses::bound_solid() const {
  return !uses_.empty() && each([](std::uint32_t, std::uint32_t, bool paired) { return paired; });
}

std::vector<TrianglesAcross> EdgeUses::across(std::span<const Index> triangles) const {
  std::vector<TrianglesAcross> out(triangles.size(), {no_triangle, no_triangle, no_triangle});
  const auto set = [&](std::uint32_t low, const Use& use, std::uint32_t next) {
    const Index& t = triangles[use.triangle];
    const std::uint32_t from = use.upwards ? low : use.high;
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] == from) out[use.triangle][i] = next;
  };
  for (std::uint32_t i = 0; i + 1 < begin_.size(); ++i)
    for (std::size_t first = begin_[i], end = first; first < begin_[i + 1]; first = end) {
      end = end_of_edge(i, first);
      if (end - first == 1) continue;
      for (std::size_t at = first; at < end; ++at) set(i, uses_[at], uses_[at + 1 < end ? at + 1 : first].triangle);
    }
  return out;
}

template <class T>
std::vector<bool> level_triangles(std::span<const Vec3<T>> points, std::span<const Index> triangles,
                                  const EdgeUses& edges) {
  std::vector<char> level(points.size(), 1);
  edges.each([&](std::uint32_t i, std::uint32_t j, bool paired) {
    if (!paired) level[i] = level[j] = 0;
    return true;
  });
  // Half of the sine from the first normal seen at a corner, so that no two there differ by more than the whole.
  std::vector<Vec3<T>> normals(points.size());
  for (const Index& t : triangles) {
    if (repeats_corner(t)) continue;
    const Vec3<T>& a = points[t[0]];
    const Vec3<T> normal = normalized(cross(points[t[1]] - a, points[t[2]] - a), Vec3<T>{});
    for (const std::uint32_t i : t) {
      Vec3<T>& first = normals[i];
      if (first == Vec3<T>{}) first = normal;
      if (normal == Vec3<T>{} || length_squared(normal - first) > level_sine<T> * level_sine<T> / T(4)) level[i] = 0;
    }
  }
  std::vector<bool> out(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Index& t = triangles[i];
    out[i] = !repeats_corner(t) && level[t[0]] != 0 && level[t[1]] != 0 && level[t[2]] != 0;
  }
  return out;
}

template <class T>
std::vector<std::uint32_t> different_triangles(std::span<const Vec3<T>> points, std::span<const Index> triangles) {
  std::vector<std::uint64_t> hashes(points.size());
  std::transform(points.begin(), points.end(), hashes.begin(), [](const Vec3<T>& p) { return hash_of(p); });
  // A place holds a part of the hash, by which most others differ from it, and the triangle's number plus one.
  const std::size_t places = std::bit_ceil(2 * triangles.size() + 1);
  std::vector<std::uint64_t> table(places, 0);
  std::vector<std::uint32_t> out;
  out.reserve(triangles.size());
  const auto corners = [&](std::uint32_t i) {
    const Index& t = triangles[i];
    return canonical(points[t[0]], points[t[1]], points[t[2]]);
  };
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint64_t a = hashes[triangles[i][0]], b = hashes[triangles[i][1]], c = hashes[triangles[i][2]];
    // A sum does not depend on the order, and each place counts once in it.
    const std::uint64_t hash = mixed(a + (b != a ? b : 0) + (c != a && c != b ? c : 0));
    const std::uint64_t part = hash & 0xffffffff00000000u;
    const auto repeats = [&](std::uint64_t held) {
      return (held & 0xffffffff00000000u) == part && corners(static_cast<std::uint32_t>(held) - 1) == corners(i);
    };
    std::size_t place = hash & (places - 1);
    while (table[place] != 0 && !repeats(table[place])) place = (place + 1) & (places - 1);
    if (table[place] != 0) continue;
    table[place] = part | (std::uint64_t{i} + 1);
    out.push_back(i);
  }
  return out;
}

template std::vector<bool> level_triangles(std::span<const Vec3f>, std::span<const Index>, const EdgeUses&);
template std::vector<bool> level_triangles(std::span<const Vec3d>, std::span<const Index>, const EdgeUses&);
template std::vector<std::uint32_t> different_triangles(std::span<const Vec3f>, std::span<const Index>);
template std::vector<std::uint32_t> different_triangles(std::span<const Vec3d>, std::span<const Index>);

}  // namespace graze
