// The cylinder, the cone and the truncated cone.
//
// Guarantee: one shape for the three, as in glTF's KHR_implicit_shapes: a zero radius makes a cone, two equal ones a
// cylinder. Support points are exact; only the *face* of a cap is a polygon, inscribed in its rim: a regular octagon,
// which reaches at least cos(pi / 8) = 0.923 of the radius in every direction. Where the cap leans by `turning_lean` (a
// milliradian) or more, the octagon is turned, by a sixteenth of a turn at most, so that one of its corners is the
// lowest point of the rim: a cylinder that tips is held at the whole radius in the direction in which it leans.
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// A cylinder, a cone or a truncated cone along the Y axis.
template <class T>
class Cylinder {
 public:
  static constexpr const char* name = "cylinder";

  /// A cylinder of `height` along Y about the origin; all >= 0. Throws `InvalidValue`.
  Cylinder(T height, T radius_bottom, T radius_top)
      : half_height_(validate::size(height, "height") / T(2)),
        radius_bottom_(validate::size(radius_bottom, "radiusBottom")),
        radius_top_(validate::size(radius_top, "radiusTop")) {}
  /// A cylinder proper: one radius.
  Cylinder(T height, T radius) : Cylinder(height, radius, radius) {}

  /// Half of the height, along Y.
  T half_height() const { return half_height_; }
  /// The radius at -Y.
  T radius_bottom() const { return radius_bottom_; }
  /// The radius at +Y.
  T radius_top() const { return radius_top_; }

  T core_radius() const { return T(0); }
  T core_extent() const {
    const T r = greatest(radius_bottom_, radius_top_);
    using std::sqrt;
    return sqrt(half_height_ * half_height_ + r * r);
  }

  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    const S h(half_height_), bottom(radius_bottom_), top(radius_top_);
    // Along the axis the support point is the middle of a cap, the one of its points that is without bias.
    const Vec3<S> flat{direction.x, S(0), direction.z};
    const S scale = greatest(abs(flat).x, abs(flat).z);
    if (!(scale > S(0))) return {S(0), direction.y < S(0) ? -h : h, S(0)};
    const Vec3<S> scaled_flat = flat / scale;
    const S across = length(scaled_flat);
    const bool up = h * direction.y + top * across * scale >= bottom * across * scale - h * direction.y;
    const S r = (up ? top : bottom) / across;
    return {scaled_flat.x * r, up ? h : -h, scaled_flat.z * r};
  }

  /// A cap (as a regular polygon of `cap_vertices` inscribed in the rim, with a corner where the rim reaches furthest),
  /// a generator of the side, or a point. Beyond `face_lean` the one of cap and side that leans less.
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    using std::sqrt;
    face.clear();
    const Vec3<T> n = normalized(direction);
    const T across = sqrt(n.x * n.x + n.z * n.z);
    if (across <= face_lean<T>) return cap(n, across, face);
    using std::abs;
    const T height = T(2) * half_height_, taper = radius_bottom_ - radius_top_;
    const T slant = sqrt(height * height + taper * taper);
    const Vec3<T> out{n.x / across, T(0), n.z / across};
    // (height, taper) / slant is the side's normal in the half-plane through the axis; its tangent is (-taper, height).
    const T rise = n.y * height - across * taper;
    const bool has_cap = (n.y >= T(0) ? radius_top_ : radius_bottom_) > T(0);
    if (has_cap && across <= lean && across * slant <= abs(rise)) return cap(n, across, face);
    if (slant > T(0) && abs(rise) <= lean * slant) {
      face.push({out.x * radius_bottom_, -half_height_, out.z * radius_bottom_}, 0);
      face.push({out.x * radius_top_, half_height_, out.z * radius_top_}, 1);
      face.id = 2;
      return;
    }
    face.push(core_support(n), rise > T(0) ? 1 : 0);
    face.id = rise > T(0) ? 4 : 3;
  }

  Aabb<T> core_bounds(const Pose<T>& pose) const {
    using std::sqrt;
    const Vec3<T> axis = rotation_matrix(pose.rotation).column(1);
    // A disc with unit normal n reaches r sqrt(1 - n_i^2) along axis i.
    const auto across = [](T c) { return sqrt(greatest(T(0), T(1) - c * c)); };
    const Vec3<T> disc{across(axis.x), across(axis.y), across(axis.z)};
    const Vec3<T> low = pose.translation - axis * half_height_, high = pose.translation + axis * half_height_;
    return merged(Aabb<T>{low - disc * radius_bottom_, low + disc * radius_bottom_},
                  Aabb<T>{high - disc * radius_top_, high + disc * radius_top_});
  }

  static constexpr std::size_t cap_vertices = 8;  ///< corners of the polygon that represents a cap in contacts
  /// The lean (a sine) from which on a corner of a cap's polygon lies where the rim reaches furthest. Below it the
  /// polygon turns there in proportion: the direction of a smaller lean is a solver's noise, and points are to stay.
  static constexpr T turning_lean = T(1e-3);

 private:
  /// A rotation about the axis, as its cosine and sine.
  struct Turn {
    T cosine, sine;
  };

  /// The rotation that takes the corner of `circle` nearest to the lean of a unit direction into it.
  static Turn turn_to_lean(const T (&circle)[cap_vertices][2], const Vec3<T>& n, T across) {
    if (!(across > T(0))) return {T(1), T(0)};
    const T x = n.x / across, z = n.z / across;
    std::size_t nearest = 0;
    const auto along = [&](std::size_t i) { return circle[i][0] * x + circle[i][1] * z; };
    for (std::size_t i = 1; i < cap_vertices; ++i)
      if (along(i) > along(nearest)) nearest = i;
    const T share = least(T(1), across / turning_lean);
    const T cosine = T(1) - share + share * along(nearest);
    const T sine = share * (circle[nearest][0] * z - circle[nearest][1] * x);
    using std::sqrt;
    const T size = sqrt(cosine * cosine + sine * sine);
    return {cosine / size, sine / size};
  }

  void cap(const Vec3<T>& n, T across, Face<T>& face) const {
    const bool top = n.y >= T(0);
    const T r = top ? radius_top_ : radius_bottom_;
    const T y = top ? half_height_ : -half_height_;
    face.id = top ? 1 : 0;
    if (r == T(0)) return face.push({T(0), y, T(0)}, 2);
    // An eighth of a turn at a time, by exact doubling of the corner's coordinates: (1,0), (s,s), (0,1), ...
    const T s = T(0.70710678118654752440L);
    const T circle[cap_vertices][2] = {{T(1), T(0)},  {s, s},   {T(0), T(1)},  {-s, s},
                                       {T(-1), T(0)}, {-s, -s}, {T(0), T(-1)}, {s, -s}};
    const Turn turn = turn_to_lean(circle, n, across);
    for (std::size_t i = 0; i < cap_vertices; ++i) {
      const std::size_t k = top ? cap_vertices - 1 - i : i;  // counter-clockwise seen from outside
      const T x = circle[k][0] * turn.cosine - circle[k][1] * turn.sine;
      const T z = circle[k][0] * turn.sine + circle[k][1] * turn.cosine;
      face.push({x * r, y, z * r}, k);
    }
  }

  T half_height_, radius_bottom_, radius_top_;
};

}  // namespace graze
