#include "graze/plane/mass.hpp"

#include <numbers>

#include "graze/angles.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

namespace {

using std::numbers::pi;

/// Area, first moments and the polar second moment about the origin of the frame; those of a union are the sums of its
/// parts'.
struct Moments {
  double area = 0, x = 0, y = 0, polar = 0;

  Moments& operator+=(const Moments& m) {
    area += m.area, x += m.x, y += m.y, polar += m.polar;
    return *this;
  }
};

/// The moments of a part with its own centre and a polar moment about that.
Moments at(const Vec2d& center, double area, double polar) {
  return {area, area * center.x, area * center.y, polar + area * length_squared(center)};
}

/// The triangle between the origin and the edge from p to q, negative where it runs clockwise.
Moments triangle(const Vec2d& p, const Vec2d& q) {
  const double twice = cross(p, q);
  return {twice / 2, twice * (p.x + q.x) / 6, twice * (p.y + q.y) / 6,
          twice * (dot(p, p) + dot(p, q) + dot(q, q)) / 12};
}

/// The rectangle over the edge from p to q, as deep as `depth` along the unit vector `outward`.
Moments strip(const Vec2d& p, const Vec2d& q, const Vec2d& outward, double depth) {
  const double w = length(q - p), area = w * depth;
  return at((p + q) * 0.5 + outward * (depth / 2), area, area * (w * w + depth * depth) / 12);
}

/// The part of a disc about `corner` between two directions, `angle` apart, symmetric about the unit vector `middle`.
Moments sector(const Vec2d& corner, const Vec2d& middle, double angle, double radius) {
  if (!(angle > 0)) return {};
  const double area = angle * radius * radius / 2;
  // The centre of a sector, and its polar moment about the corner less what the centre's distance makes of it.
  const double away = 4 * radius * cosine_sine(angle / 2).sine / (3 * angle), own = area * radius * radius / 2;
  return at(corner + middle * away, area, own - area * away * away);
}

/// A ring of support points, each a vertex of a polygon inside and of one outside: their mean is right to second order.
template <class T>
Moments sampled(const Core<T>& core) {
  constexpr int count = 4096;
  Moments out;
  Vec2d before{};
  for (int i = 0; i <= count; ++i) {
    const CosineSine turn = cosine_sine(2 * pi * (i % count) / count);
    const Vec2d n{turn.cosine, turn.sine}, p = support(core, n).point + n * core.radius;
    if (i > 0) out += triangle(before, p);
    before = p;
  }
  return out;
}

/// The vertices of a polygon, those upon each other once.
template <class T>
std::vector<Vec2d> corners_of(const Core<T>& core) {
  std::vector<Vec2d> out;
  for (std::uint32_t i = 0; i < core.count; ++i)
    if (const Vec2d v = core.vertex(i); out.empty() || !(v == out.back())) out.push_back(v);
  while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  return out;
}

Moments inside(const std::vector<Vec2d>& corners) {
  // Seen from a vertex, so that what is far from the origin keeps its digits.
  const Vec2d from = corners[0];
  Moments seen;
  for (std::size_t i = 0; i < corners.size(); ++i)
    seen += triangle(corners[i] - from, corners[(i + 1) % corners.size()] - from);
  if (!(seen.area > 0)) return {};
  const Vec2d center{seen.x / seen.area, seen.y / seen.area};
  return at(from + center, seen.area, seen.polar - seen.area * length_squared(center));
}

/// The rounding of a vertex between edges with the normals `before` and `after`.
Moments rounded_corner(const Vec2d& corner, const Vec2d& before, const Vec2d& after, double radius) {
  return sector(corner, normalized(before + after, left(before)), angle_of(dot(before, after), cross(before, after)),
                radius);
}

/// A polygon with its rounding: the polygon, a strip along each edge, a sector at each corner.
template <class T>
Moments of_convex(const Core<T>& core) {
  const double r = core.radius;
  const std::vector<Vec2d> corners = corners_of(core);
  if (corners.size() == 1) return at(corners[0], pi * r * r, pi * r * r * r * r / 2);
  Moments out = inside(corners);
  if (!(r > 0)) return out;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d &v = corners[i], &w = corners[(i + 1) % n];
    const Vec2d after = normalized(right(w - v)), before = normalized(right(v - corners[(i + n - 1) % n]));
    out += strip(v, w, after, r);
    out += n == 2 ? sector(v, right(after), pi, r) : rounded_corner(v, before, after, r);
  }
  return out;
}

/// A piece of a solid polygon; its rounding stands on the outline and not on cuts.
template <class T>
Moments of_piece(const Core<T>& core) {
  Moments out = inside(corners_of(core));
  if (!(core.radius > 0)) return out;
  for (std::uint32_t i = 0; i < core.count; ++i) {
    const OutlineVertex& v = core.outline[i];
    if (!v.outer) continue;
    out += strip(core.vertex(i), core.vertex(core.next(i)), right(v.leaving), core.radius);
    if (v.kind == OutlineVertex::Kind::convex)
      out += rounded_corner(core.vertex(i), right(v.arriving), right(v.leaving), core.radius);
  }
  return out;
}

/// The hull of two discs on the Y axis: the trapezium between the points where the sides touch, and two sectors.
template <class T>
Moments of_tapered(const Core<T>& core) {
  const double h = core.half_height, bottom = core.radii.x + core.radius, top = core.radii.y + core.radius;
  const double s = (bottom - top) / (2 * h), c = std::sqrt(greatest(1 - s * s, 0.0));  // the sides' normal (c, s)
  const Vec2d n{c, s}, low = Vec2d{0, -h} + n * bottom, high = Vec2d{0, h} + n * top;
  Moments out;
  const Vec2d corners[] = {low, high, {0, h}, {-high.x, high.y}, {-low.x, low.y}, {0, -h}};
  for (std::size_t i = 0; i < 6; ++i) out += triangle(corners[i], corners[(i + 1) % 6]);
  const double tilt = angle_of(c, s);
  out += sector({0, h}, {0, 1}, pi - 2 * tilt, top);
  out += sector({0, -h}, {0, -1}, pi + 2 * tilt, bottom);
  return out;
}

template <class T>
Moments of_leaf(const Core<T>& core) {
  switch (core.kind) {
  case CoreKind::polygon: return core.outline && !core.chain ? of_piece(core) : of_convex(core);
  case CoreKind::tapered: return of_tapered(core);
  case CoreKind::ellipse:
    if (core.radius == 0) {
      const double area = pi * core.radii.x * core.radii.y;
      return at({}, area, area * length_squared(core.radii) / 4);
    }
    return sampled(core);
  case CoreKind::user: return sampled(core);
  case CoreKind::half_plane: break;
  }
  return {};
}

/// The moments of a part in its place in the body.
Moments placed(const Moments& m, const Pose2d& pose) {
  if (!(m.area > 0)) return {};
  const Vec2d center{m.x / m.area, m.y / m.area};
  return at(transform(pose, center), m.area, m.polar - m.area * length_squared(center));
}

}  // namespace

template <class T>
MassProperties<T> mass_properties(const Shape<T>& shape) {
  Moments all;
  for_each_leaf(shape, Pose2<T>{}, [&](const Core<T>& core, const Pose2d& pose, double, std::uint32_t) {
    all += placed(of_leaf(core), pose);
  });
  MassProperties<T> out;
  if (!(all.area > 0)) return out;
  const Vec2d center{all.x / all.area, all.y / all.area};
  out.area = static_cast<T>(all.area);
  out.center = converted<T>(center);
  out.inertia = static_cast<T>(greatest(all.polar - all.area * length_squared(center), 0.0));
  return out;
}

template MassProperties<float> mass_properties(const Shape<float>&);
template MassProperties<double> mass_properties(const Shape<double>&);

}  // namespace graze::plane
