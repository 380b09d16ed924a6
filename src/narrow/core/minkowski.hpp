// The Minkowski difference of two cores, given by its support function.
//
// Everything iterative works in double, whichever scalar the shapes have: scalar code is as fast in it, and float's
// tolerance is then met without an argument about cancellation. The frame is that of A, so coordinates are of the order
// of the pair and not of the scene.
#pragma once

#include <optional>

#include "graze/shape.hpp"
#include "narrow/core/support_point.hpp"

namespace graze {

/// B - A for the cores of two concrete shapes, in the frame of A. Takes any types with `core_support` and
/// `core_extent`.
template <class A, class B>
class MinkowskiDifference {
 public:
  MinkowskiDifference(const A& a, const B& b, const Posed& b_in_a)
      : a_(a), b_(b), rotation_(rotation_matrix(b_in_a.rotation)), translation_(b_in_a.translation) {
    size_ = greatest(static_cast<double>(a.core_extent()), static_cast<double>(b.core_extent()));
    reach_ = size_ + max_abs(translation_);
  }

  /// The point of the difference that lies *least* far along `direction`: A's support point along it, B's against it.
  /// Its offset along a unit direction is the shapes' separation along that direction.
  SupportPoint support(const Vec3d& direction) const {
    const Vec3d a = a_.core_support(direction);
    const Vec3d b = rotation_ * b_.core_support(transposed_times(rotation_, -direction)) + translation_;
    return {a, b, b - a};
  }

  const Vec3d& center_offset() const { return translation_; }
  const Mat3d& rotation_of_b() const { return rotation_; }
  /// The larger of the two cores' extents, to which tolerances are relative.
  double size() const { return size_; }
  /// The largest coordinate that can occur, to which rounding errors are relative.
  double reach() const { return reach_; }

 private:
  const A& a_;
  const B& b_;
  Mat3d rotation_;
  Vec3d translation_;
  double size_, reach_;
};

/// Bound of a component of a unit vector that counts as zero, many times its rounding: set to zero, it does not
/// reappear when a small pair is tested at a large scale.
inline constexpr double negligible = 1e-30;

/// A core that is the Minkowski sum of a box and an ellipsoid, both about `center` along the core's own axes. A
/// cylinder is a segment, a box of zero width, plus a disc, an ellipsoid of zero height.
struct SummedCore {
  Vec3d center, half, radii;
};

/// A shape's core behind one type, so that the iterations are compiled once for all pairs of shapes. The data for
/// support queries of the simplest shapes are taken out of the shape once, in double.
template <class T>
class ShapeCore {
 public:
  explicit ShapeCore(const Shape<T>& shape) : shape_(shape) {
    shape.visit([&](const auto& c) {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>) take(c);
    });
  }

  Vec3d core_support(const Vec3d& d) const {
    switch (kind_) {
    case Kind::point: return vertex_[0];
    case Kind::box:
      return {d.x < 0 ? -vertex_[0].x : vertex_[0].x, d.y < 0 ? -vertex_[0].y : vertex_[0].y,
              d.z < 0 ? -vertex_[0].z : vertex_[0].z};
    case Kind::triangle: return vertex_[detail::furthest(vertex_, 3, d)];
    case Kind::hull: return shape_.template as<ConvexHull<T>>()->core_support(d);
    case Kind::round: {
      const double squared = d.x * d.x + d.z * d.z;
      if (!(squared > 1e-200 && squared < 1e200)) break;
      return round_support(d, std::sqrt(squared));
    }
    case Kind::ellipsoid: {
      const Vec3d v = scaled(vertex_[0], d);
      const double squared = dot(v, v);
      if (!(squared > 1e-200 && squared < 1e200)) break;
      return scaled(vertex_[0], v) * (1 / std::sqrt(squared));
    }
    case Kind::other: break;
    }
    return shape_.visit([&](const auto& c) -> Vec3d {
      if constexpr (BoundedConvex<std::decay_t<decltype(c)>>)
        return c.core_support(d);
      else
        return {};
    });
  }
  double core_extent() const { return extent_; }

  /// The core as a sum, where it is one.
  std::optional<SummedCore> summed() const {
    const Vec3d& v = vertex_[0];
    switch (kind_) {
    case Kind::point: return SummedCore{v, {}, {}};
    case Kind::box: return SummedCore{{}, v, {}};
    case Kind::ellipsoid: return SummedCore{{}, {}, v};
    case Kind::round:
      if (v.x == v.z) return SummedCore{{}, {0, v.y, 0}, {v.x, 0, v.x}};
      break;
    default: break;
    }
    return std::nullopt;
  }

 private:
  enum class Kind : unsigned char { point, box, triangle, hull, round, ellipsoid, other };

  /// The support point of a cylinder, `across` being the length of the direction across its axis.
  Vec3d round_support(const Vec3d& d, double across) const {
    const double bottom = vertex_[0].x, height = vertex_[0].y, top = vertex_[0].z;
    const bool up = height * d.y + top * across >= bottom * across - height * d.y;
    const double r = (up ? top : bottom) / across, dust = negligible * across;
    return {std::abs(d.x) > dust ? d.x * r : 0, up ? height : -height, std::abs(d.z) > dust ? d.z * r : 0};
  }

  void take(const Sphere<T>& sphere) {
    rest(sphere, Kind::point);
    vertex_[0] = converted<double>(sphere.center());
  }
  void take(const Capsule<T>& capsule) {
    if (capsule.tapered()) return rest(capsule, Kind::other);
    rest(capsule, Kind::box);  // of zero width
    vertex_[0] = {0, static_cast<double>(capsule.half_height()), 0};
  }
  void take(const Box<T>& box) {
    rest(box, Kind::box);
    vertex_[0] = converted<double>(box.half_extents());
  }
  void take(const Rectangle<T>& rectangle) { take(rectangle.as_box()); }
  void take(const Triangle<T>& triangle) {
    rest(triangle, Kind::triangle);
    for (std::size_t i = 0; i < 3; ++i) vertex_[i] = converted<double>(triangle.point(i));
  }
  void take(const ConvexHull<T>& hull) { rest(hull, Kind::hull); }
  void take(const Cylinder<T>& cylinder) {
    rest(cylinder, Kind::round);
    vertex_[0] = {static_cast<double>(cylinder.radius_bottom()), static_cast<double>(cylinder.half_height()),
                  static_cast<double>(cylinder.radius_top())};
  }
  void take(const Ellipsoid<T>& ellipsoid) {
    rest(ellipsoid, Kind::ellipsoid);
    vertex_[0] = converted<double>(ellipsoid.radii());
  }
  template <class C>
  void take(const C& concrete) {
    rest(concrete, Kind::other);
  }
  template <class C>
  void rest(const C& concrete, Kind kind) {
    kind_ = kind;
    extent_ = static_cast<double>(concrete.core_extent());
  }

  const Shape<T>& shape_;
  Kind kind_ = Kind::other;
  double extent_ = 0;
  Vec3d vertex_[3];
};

/// `normalized` for scalar code: one square root and one division, unless a square under- or overflows.
inline Vec3d unit(const Vec3d& v, const Vec3d& fallback = {0, 1, 0}) {
  const double squared = dot(v, v);
  if (squared > 1e-200 && squared < 1e200) return v * (1 / std::sqrt(squared));
  return normalized(v, fallback);
}

/// Two unit vectors perpendicular to the unit vector n and to each other; u x v = n (Duff et al. 2017, "Building an
/// orthonormal basis, revisited").
inline void tangents_at(const Vec3d& n, Vec3d& u, Vec3d& v) {
  const double s = n.z < 0 ? -1 : 1, a = -1 / (s + n.z), b = n.x * n.y * a;
  u = {1 + s * n.x * n.x * a, s * b, -s * n.x};
  v = {b, s + n.y * n.y * a, -n.y};
}

/// Rounding errors of the general path: some tens of operations on coordinates up to `reach`.
inline constexpr double rounding_error = 32 * std::numeric_limits<double>::epsilon();

}  // namespace graze
