#include "narrow/pairs/box_triangle.hpp"

namespace graze {

namespace {

void keep(SeparatingAxis& best, double separation, const Vec3d& normal, std::size_t number) {
  if (separation > best.separation) best = {best.kind, separation, normal, number, number};
}

}  // namespace

void BoxTriangle::look_from_box(SeparatingAxis& best) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = p_[0][i], b = p_[1][i], c = p_[2][i];
    const double above = least(a, least(b, c)) - half_[i], below = -greatest(a, greatest(b, c)) - half_[i];
    Vec3d e;
    e[i] = 1;
    keep(best, below, -e, 2 * i);
    keep(best, above, e, 2 * i + 1);
  }
}

void BoxTriangle::look_from_triangle(SeparatingAxis& best) const {
  const double offset = dot(normal_, p_[0]), across = reach(normal_);
  keep(best, -across - offset, -normal_, 0);
  keep(best, -across + offset, normal_, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d side = unit(cross(p_[i == 2 ? 0 : i + 1] - p_[i], normal_));
    keep(best, -reach(side) - dot(side, p_[i]), -side, 2 + i);
  }
}

void BoxTriangle::look_along_edges(double least_gain, SeparatingAxis& best) const {
  double most = least_gain;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3d &on = p_[j], &off = p_[j == 0 ? 2 : j - 1];
    const Vec3d f = p_[j == 2 ? 0 : j + 1] - on;
    const double parallel_squared = parallel_edges<double> * length_squared(f);
    const Vec3d products[] = {{0, -f.z, f.y}, {f.z, 0, -f.x}, {-f.y, f.x, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& n = products[i];
      // The whole edge is one place along its product, so that the triangle has but two.
      const double one = dot(n, on), other = dot(n, off), across = reach(n);
      const double above = least(one, other) - across, below = -greatest(one, other) - across;
      const double apart = greatest(above, below), squared = length_squared(n);
      // No better than what is known, told without a root.
      if (!(squared > parallel_squared) || (apart <= 0 && (most >= 0 || apart * apart >= most * most * squared)))
        continue;
      const double scale = 1 / std::sqrt(squared);
      if (!(apart * scale > most)) continue;
      most = apart * scale;
      best = {AxisKind::edges, most, n * (above > below ? scale : -scale), i, j};
    }
  }
}

SeparatingAxes BoxTriangle::axes(double enough) const {
  SeparatingAxes axes;
  look_from_box(axes.face_a);
  if (axes.face_a.separation > enough) return axes;
  look_from_triangle(axes.face_b);
  const double best = axes.best_face().separation;
  if (best <= enough) look_along_edges(best, axes.edge);
  return axes;
}

PlacedFace BoxTriangle::face_b(const Vec3d& normal) const {
  PlacedFace face;
  const double facing = -dot(normal_, normal);
  const auto push = [&](std::size_t i) {
    face.vertices.push_back(p_[i]);
    face.ids.push_back(static_cast<std::uint32_t>(i));
  };
  if (std::abs(facing) >= furthest_lean) {
    const bool front = facing > 0;
    face.id = front ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i) push(front ? i : 2 - i);
    return face;
  }
  const std::size_t top = detail::furthest(p_, 3, -normal);
  std::size_t other = top;
  double least_fall = 1 - furthest_lean;
  for (const std::size_t end : {(top + 1) % 3, (top + 2) % 3}) {
    const Vec3d along = p_[top] - p_[end];
    const double fall = -dot(along, normal), l = length(along);
    if (fall > least_fall * l) continue;
    least_fall = fall / l;
    other = end;
  }
  push(least(top, other));
  if (other != top) push(greatest(top, other));
  return face;
}

}  // namespace graze
