#include "narrow/manifold/rounded_face.hpp"

namespace graze {

namespace {

constexpr double never = -std::numeric_limits<double>::infinity();

/// The parameter at which the line leaves a ball about `center`. Squares only the part across the line, so that a small
/// ball far from `from` keeps its digits.
double leaves_ball(const Vec3d& from, const Vec3d& direction, const Vec3d& center, double radius) {
  const Vec3d to = from - center;
  const double along = dot(to, direction);
  const double half_squared = radius * radius - length_squared(to - direction * along);
  return half_squared >= 0 ? std::sqrt(half_squared) - along : never;
}

/// The parameter at which the line leaves the cylinder about an edge, between its ends only: the balls there are
/// separate.
double leaves_cylinder(const Vec3d& from, const Vec3d& direction, const Vec3d& start, const Vec3d& end, double radius) {
  const Vec3d edge = end - start, to = from - start;
  const double squared = length_squared(edge);
  if (!(squared > 0)) return never;
  const double place = dot(to, edge) / squared, pace = dot(direction, edge) / squared;
  const Vec3d across = direction - edge * pace, beside = to - edge * place;
  const double steep = length_squared(across);
  if (!(steep > 0)) return never;
  const double along = dot(beside, across) / steep;
  const double half_squared = (radius * radius - length_squared(beside - across * along)) / steep;
  if (!(half_squared >= 0)) return never;
  const double leaves = std::sqrt(half_squared) - along, at = place + leaves * pace;
  return at >= 0 && at <= 1 ? leaves : never;
}

}  // namespace

RoundedFace::RoundedFace(const PlacedFace& face, const Vec3d& outward, double radius)
    : face_(face), outward_(outward), radius_(radius) {
  if (radius == 0 || face.vertices.size() < 3) return;
  normal_ = polygon_normal(face);
  up_ = dot(normal_, outward);
}

std::optional<RoundedFace::Exit> RoundedFace::exit(const Vec3d& from) const {
  const std::size_t n = face_.vertices.size();
  double last = never;
  if (up_ > 0) {
    // The plane bounds the whole face: where the foot lies inside, nothing else is left later. Else the foot moves from
    // inside across some edges, and the last surface is that of one of these.
    const double rise = (radius_ + dot(face_.vertices[0] - from, normal_)) / up_;
    const Vec3d foot = from + outward_ * rise - normal_ * radius_;
    bool inside = true;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d &start = face_.vertices[i], &end = face_.vertices[i + 1 == n ? 0 : i + 1];
      if (dot(cross(end - start, foot - start), normal_) >= 0) continue;
      inside = false;
      last = greatest(last, leaves_edge(from, start, end));
    }
    if (inside) return Exit{rise, true};
  } else if (n == 1) {
    last = leaves_ball(from, outward_, face_.vertices[0], radius_);
  } else {
    for (std::size_t i = n == 2 ? 1 : 0; i < n; ++i)
      last = greatest(last, leaves_edge(from, face_.vertices[i], face_.vertices[i + 1 == n ? 0 : i + 1]));
  }
  if (last == never) return std::nullopt;
  return Exit{last, false};
}

double RoundedFace::leaves_edge(const Vec3d& from, const Vec3d& start, const Vec3d& end) const {
  const double balls = greatest(leaves_ball(from, outward_, start, radius_), leaves_ball(from, outward_, end, radius_));
  return greatest(balls, leaves_cylinder(from, outward_, start, end, radius_));
}

}  // namespace graze
