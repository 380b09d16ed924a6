#include "plane/partition.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "plane/orientation.hpp"

namespace graze::plane {

namespace {

int side(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const double o = orientation(a, b, c);
  return o > 0 ? 1 : o < 0 ? -1 : 0;
}

/// Whether a point of the line through a and b lies between them.
bool between(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  return least(a.x, b.x) <= p.x && p.x <= greatest(a.x, b.x) && least(a.y, b.y) <= p.y && p.y <= greatest(a.y, b.y);
}

bool segments_meet(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  const int ac = side(a, b, c), ad = side(a, b, d), ca = side(c, d, a), cb = side(c, d, b);
  if (ac * ad < 0 && ca * cb < 0) return true;
  return (ac == 0 && between(a, b, c)) || (ad == 0 && between(a, b, d)) || (ca == 0 && between(c, d, a)) ||
         (cb == 0 && between(c, d, b));
}

using ContactPolygon = std::vector<std::uint32_t>;

/// Triangles by cutting ears (Meisters 1975, "Polygons have ears").
std::vector<ContactPolygon> triangles(std::span<const Vec2d> outline) {
  const auto n = static_cast<std::uint32_t>(outline.size());
  std::vector<std::uint32_t> next(n), previous(n);
  for (std::uint32_t i = 0; i < n; ++i) next[i] = (i + 1) % n, previous[(i + 1) % n] = i;
  const auto turn = [&](std::uint32_t i) { return side(outline[previous[i]], outline[i], outline[next[i]]); };
  // Only vertices that do not turn to the left can lie in a triangle of three in a row, and cutting makes no new ones.
  std::vector<std::uint32_t> hollow;
  for (std::uint32_t i = 0; i < n; ++i)
    if (turn(i) <= 0) hollow.push_back(i);
  const auto is_ear = [&](std::uint32_t i) {
    if (turn(i) <= 0) return false;
    const std::uint32_t p = previous[i], q = next[i];
    return std::none_of(hollow.begin(), hollow.end(), [&](std::uint32_t k) {
      return k != p && k != i && k != q && side(outline[p], outline[i], outline[k]) >= 0 &&
             side(outline[i], outline[q], outline[k]) >= 0 && side(outline[q], outline[p], outline[k]) >= 0;
    });
  };
  std::vector<ContactPolygon> out;
  std::uint32_t at = 0, tried = 0;
  for (std::uint32_t left = n; left > 3 && tried <= left;) {
    if (!is_ear(at)) {
      at = next[at];
      ++tried;
      continue;
    }
    out.push_back({previous[at], at, next[at]});
    next[previous[at]] = next[at];
    previous[next[at]] = previous[at];
    hollow.erase(std::remove_if(
                     hollow.begin(), hollow.end(),
                     [&](std::uint32_t k) { return k == at || ((k == previous[at] || k == next[at]) && turn(k) > 0); }),
                 hollow.end());
    at = previous[at];
    --left;
    tried = 0;
  }
  out.push_back({previous[at], at, next[at]});
  return out;
}

}  // namespace

std::int64_t first_crossing(std::span<const Vec2d> outline) {
  const std::size_t n = outline.size();
  const auto start = [&](std::size_t i) { return outline[i]; };
  const auto end = [&](std::size_t i) { return outline[i + 1 == n ? 0 : i + 1]; };
  const auto low = [&](std::size_t i) { return least(start(i).x, end(i).x); };
  const auto high = [&](std::size_t i) { return greatest(start(i).x, end(i).x); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
  std::size_t first = n;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = k + 1; l < n && low(order[l]) <= high(order[k]); ++l) {
      const std::size_t i = std::min(order[k], order[l]), j = std::max(order[k], order[l]);
      if (i >= first || j == i + 1 || (i == 0 && j + 1 == n)) continue;
      if (segments_meet(start(i), end(i), start(j), end(j))) first = i;
    }
  }
  // Two edges in a row share more than their vertex where the outline turns back.
  for (std::size_t i = 0; i < std::min(first, n); ++i) {
    const Vec2d a = start(i), b = end(i), c = end(i + 1 == n ? 0 : i + 1);
    if (side(a, b, c) == 0 && dot(b - a, c - b) < 0) first = i;
  }
  return first == n ? -1 : static_cast<std::int64_t>(first);
}

std::vector<std::vector<std::uint32_t>> convex_pieces(std::span<const Vec2d> outline) {
  /// An edge of one ring, with its neighbours in it; `ring` is the one that it began in.
  struct Edge {
    std::uint32_t from, to;
    std::size_t before, after, ring;
  };
  const std::vector<ContactPolygon> rings = triangles(outline);
  std::vector<Edge> edges;
  std::vector<std::size_t> first(rings.size()), joined(rings.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> by_ends;
  std::vector<std::pair<std::size_t, std::size_t>> cuts;  // both edges along each
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::size_t start = edges.size();
    first[r] = start, joined[r] = r;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = rings[r][k], b = rings[r][(k + 1) % 3];
      by_ends[{a, b}] = edges.size();
      if (const auto other = by_ends.find({b, a}); other != by_ends.end())
        cuts.emplace_back(edges.size(), other->second);
      edges.push_back({a, b, start + (k + 2) % 3, start + (k + 1) % 3, r});
    }
  }
  // Joined rings form a tree; the way to its root is halved while it is walked (Tarjan, van Leeuwen 1984).
  const auto root = [&](std::size_t r) {
    while (joined[r] != r) r = joined[r] = joined[joined[r]];
    return r;
  };
  for (const auto& [l, r] : cuts) {
    // The ends of the cut have to be convex without it. Two rings of a simple polygon share no more than one cut.
    if (side(outline[edges[edges[l].before].from], outline[edges[l].from], outline[edges[edges[r].after].to]) < 0 ||
        side(outline[edges[edges[r].before].from], outline[edges[l].to], outline[edges[edges[l].after].to]) < 0)
      continue;
    const auto link = [&](std::size_t before, std::size_t after) {
      edges[before].after = after, edges[after].before = before;
    };
    const std::size_t left = root(edges[l].ring), start = edges[l].after;
    link(edges[l].before, edges[r].after);
    link(edges[r].before, edges[l].after);
    joined[root(edges[r].ring)] = left;
    first[left] = start;
  }
  std::vector<std::vector<std::uint32_t>> pieces;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (joined[r] != r) continue;
    std::vector<std::uint32_t>& piece = pieces.emplace_back();
    std::size_t at = first[r];
    do piece.push_back(edges[at].from), at = edges[at].after;
    while (at != first[r]);
  }
  return pieces;
}

}  // namespace graze::plane
