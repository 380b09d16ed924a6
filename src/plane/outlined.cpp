#include "graze/plane/shape/outlined.hpp"

#include <algorithm>
#include <string>

#include "graze/plane/shape/flat.hpp"
#include "plane/orientation.hpp"
#include "plane/partition.hpp"

namespace graze::plane {

namespace {

using Kind = OutlineVertex::Kind;

std::string vertex_path(std::size_t i) { return "points[" + std::to_string(i) + "]"; }

[[noreturn]] void refuse(std::size_t vertex, const char* expected, const Vec2d& found) {
  throw InvalidValue(vertex_path(vertex), expected,
                     "[" + validate::number(found.x) + ", " + validate::number(found.y) + "]");
}

/// The given points, checked: in range, and no two in a row the same.
template <class T>
std::vector<Vec2<T>> checked_points(std::span<const Vec2<T>> points, std::size_t fewest, bool closed) {
  if (points.size() < fewest)
    throw InvalidValue("points", "at least " + std::to_string(fewest) + " points", std::to_string(points.size()));
  std::vector<Vec2<T>> out;
  out.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2<T> p = detail::checked_point(points[i], vertex_path(i));
    out.push_back({validate::resolved(p.x) + T(0), validate::resolved(p.y) + T(0)});
    const bool same =
        (i > 0 && out[i] == out[i - 1]) || (closed && i > 0 && i + 1 == points.size() && out[i] == out[0]);
    if (same) refuse(i, "a point other than its neighbours", converted<double>(p));
  }
  return out;
}

template <class T>
T extent_of(const std::vector<Vec2<T>>& points) {
  T out(0);
  for (const Vec2<T>& p : points) out = greatest(out, length(p));
  return out;
}

/// The orientation of an outline, positive where it runs counter-clockwise: that of its lowest vertex, which is convex.
double turn_of(std::span<const Vec2d> outline) {
  const std::size_t n = outline.size();
  const auto lowest = static_cast<std::size_t>(
      std::min_element(outline.begin(), outline.end(),
                       [](const Vec2d& a, const Vec2d& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }) -
      outline.begin());
  return orientation(outline[(lowest + n - 1) % n], outline[lowest], outline[(lowest + 1) % n]);
}

/// A segment's ends as they are seen from the other side.
OutlineVertex reversed(const OutlineVertex& v, double turn) {
  OutlineVertex out = v;
  out.arriving = -v.leaving;
  out.leaving = -v.arriving;
  if (v.kind == Kind::first)
    out.kind = Kind::last;
  else if (v.kind == Kind::last)
    out.kind = Kind::first;
  else
    out.kind = turn <= 0 ? Kind::convex : Kind::reflex;
  return out;
}

}  // namespace

template <class T>
void Pieces<T>::add(std::span<const Vec2<T>> vertices, std::span<const OutlineVertex> outline) {
  first_.push_back(static_cast<std::uint32_t>(vertices_.size()));
  first_outline_.push_back(static_cast<std::uint32_t>(outline_.size()));
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  outline_.insert(outline_.end(), outline.begin(), outline.end());
}

template <class T>
std::vector<Vec2<T>> Pieces<T>::outline_vertices() const {
  std::vector<std::pair<std::uint32_t, Vec2<T>>> numbered;
  for (std::uint32_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < vertices(i).size(); ++k) numbered.emplace_back(outline(i)[k].number, vertices(i)[k]);
  const auto by_number = [](const auto& p, const auto& q) { return p.first < q.first; };
  const auto same = [](const auto& p, const auto& q) { return p.first == q.first; };
  std::sort(numbered.begin(), numbered.end(), by_number);
  numbered.erase(std::unique(numbered.begin(), numbered.end(), same), numbered.end());
  std::vector<Vec2<T>> out;
  out.reserve(numbered.size());
  for (const auto& [number, vertex] : numbered) out.push_back(vertex);
  return out;
}

template <class T>
void Pieces<T>::build() {
  build(0, 0, size());
}

template <class T>
Aabb2<double> Pieces<T>::build(std::uint32_t node, std::uint32_t from, std::uint32_t to) {
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  Aabb2<double> box;
  if (to - from == 1) {
    const std::span<const Vec2<T>> all = vertices(from);
    box = {converted<double>(all[0]), converted<double>(all[0])};
    for (const Vec2<T>& v : all) box = merged(box, Aabb2<double>{converted<double>(v), converted<double>(v)});
  } else {
    const std::uint32_t middle = from + (to - from) / 2;
    const Aabb2<double> low = build(2 * node + 1, from, middle);
    box = merged(low, build(2 * node + 2, middle, to));
  }
  boxes_[node] = box;
  return box;
}

template <class T>
Polygon<T>::Polygon(std::span<const Vec2<T>> points) {
  const std::vector<Vec2<T>> given = checked_points(points, 3, true);
  std::vector<Vec2d> all;
  all.reserve(given.size());
  for (const Vec2<T>& p : given) all.push_back(converted<double>(p));
  if (const std::int64_t at = first_crossing(all); at >= 0)
    refuse(static_cast<std::size_t>(at), "the start of an edge that meets no other", all[static_cast<std::size_t>(at)]);

  // Vertices on straight lines are left out; the rest keep their numbers.
  const std::size_t n = all.size();
  std::vector<Vec2d> outline;
  std::vector<std::uint32_t> number;
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(all[(i + n - 1) % n], all[i], all[(i + 1) % n]) == 0) continue;
    outline.push_back(all[i]);
    number.push_back(static_cast<std::uint32_t>(i));
  }
  if (turn_of(outline) < 0) {
    std::reverse(outline.begin(), outline.end());
    std::reverse(number.begin(), number.end());
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  const auto next = [count](std::uint32_t i) { return i + 1 == count ? 0 : i + 1; };
  const auto previous = [count](std::uint32_t i) { return i == 0 ? count - 1 : i - 1; };

  auto pieces = std::make_shared<Pieces<T>>();
  for (const std::vector<std::uint32_t>& ring : convex_pieces(outline)) {
    std::vector<Vec2<T>> vertices;
    std::vector<OutlineVertex> around;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t i = ring[k], p = previous(i), q = next(i);
      OutlineVertex v;
      v.arriving = normalized(outline[i] - outline[p]);
      v.leaving = normalized(outline[q] - outline[i]);
      v.kind = orientation(outline[p], outline[i], outline[q]) > 0 ? OutlineVertex::Kind::convex
                                                                   : OutlineVertex::Kind::reflex;
      v.outer = ring[(k + 1) % ring.size()] == q;
      v.number = number[i];
      around.push_back(v);
      vertices.push_back(given[number[i]]);
    }
    pieces->add(vertices, around);
  }
  pieces->build();
  pieces_ = std::move(pieces);
  extent_ = extent_of(given);
}

template <class T>
Chain<T>::Chain(std::span<const Vec2<T>> points, bool closed, ChainSides sides) : closed_(closed), sides_(sides) {
  const std::vector<Vec2<T>> given = checked_points(points, closed ? 3 : 2, closed);
  const std::size_t n = given.size(), segments = closed ? n : n - 1;
  const auto wide = [&](std::size_t i) { return converted<double>(given[i % n]); };
  const auto around = [&](std::size_t i) {
    OutlineVertex v;
    const bool starts = !closed && i == 0, ends = !closed && i + 1 == n;
    v.leaving = ends ? Vec2d{} : normalized(wide(i + 1) - wide(i));
    v.arriving = starts ? v.leaving : normalized(wide(i) - wide(i + n - 1));
    if (ends) v.leaving = v.arriving;
    const double turn = starts || ends ? 0 : orientation(wide(i + n - 1), wide(i), wide(i + 1));
    v.kind = starts ? Kind::first : ends ? Kind::last : turn >= 0 ? Kind::convex : Kind::reflex;
    v.number = static_cast<std::uint32_t>(i);
    return std::pair{v, reversed(v, turn)};
  };
  auto pieces = std::make_shared<Pieces<T>>();
  for (std::size_t i = 0; i < segments; ++i) {
    auto [start, start_back] = around(i);
    auto [end, end_back] = around((i + 1) % n);
    // Edge 0 runs along the chain and is its right side, edge 1 runs back and is its left one.
    end.outer = start_back.outer = false;
    pieces->add(std::vector<Vec2<T>>{given[i], given[(i + 1) % n]},
                std::vector<OutlineVertex>{start, end, start_back, end_back});
  }
  pieces->build();
  pieces_ = std::move(pieces);
  extent_ = extent_of(given);
}

template class Pieces<float>;
template class Pieces<double>;
template class Polygon<float>;
template class Polygon<double>;
template class Chain<float>;
template class Chain<double>;

}  // namespace graze::plane
