// A shape as contacts need it: its core's support points and faces in the frame of the pair, and the height of its
// rounded surface over a place on a face.
//
// Guarantee: all in double; a place on the surface is exact to double's rounding, whatever the core.
#pragma once

#include <optional>

#include "narrow/core/core.hpp"
#include "narrow/core/minkowski.hpp"
#include "narrow/general.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/rounded_face.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// Newton's method begins close and doubles its digits: three steps are the rule.
inline constexpr int newton_steps = 8;

/// One of the two shapes, in the frame of A.
template <class T>
class Side {
 public:
  Side(const Shape<T>& shape, const Posed& pose) : shape_(shape), pose_(pose), turn_(rotation_matrix(pose.rotation)) {
    shape.visit([&](const auto& c) {
      radius_ = static_cast<double>(rounding_radius(c, shape.rounding()));
      size_ = static_cast<double>(c.core_extent()) + radius_;
      using C = std::decay_t<decltype(c)>;
      flat_sided_ = std::is_same_v<C, Box<T>> || std::is_same_v<C, Rectangle<T>> || std::is_same_v<C, Triangle<T>> ||
                    std::is_same_v<C, ConvexHull<T>>;
      straight_ = std::is_same_v<C, Capsule<T>> || std::is_same_v<C, LineSegment<T>>;
      whole_ = has_core(c) || std::is_same_v<C, Triangle<T>>;
    });
  }

  double radius() const { return radius_; }
  double size() const { return size_; }
  /// Whether its faces are the same along whatever direction they are met.
  bool flat_sided() const { return flat_sided_; }
  bool round_side() const { return shape_.template as<Cylinder<T>>() != nullptr; }

  Vec3d core_support(const Vec3d& direction) const {
    return placed(ShapeCore<T>(shape_).core_support(transposed_times(turn_, direction)));
  }
  /// The support face, which leans little from the direction; with `sides`, the one that leans least, but of capsules
  /// and segments, whose special pairs have one point where their side leans.
  PlacedFace face(const Vec3d& direction, bool sides = false) const {
    return face_within(direction, sides && !straight_ ? side_lean<T> : face_lean<T>);
  }
  /// The face on a half-space, which clips nothing: the one that leans least. Where the side of a tapered capsule
  /// leans, an end ball reaches beyond its generator.
  PlacedFace face_on_plane(const Vec3d& direction) const {
    const auto* capsule = shape_.template as<Capsule<T>>();
    return face_within(direction, capsule && capsule->tapered() ? face_lean<T> : side_lean<T>);
  }
  /// The height of the surface over a place on the face, along the unit vector `outward`; nothing where the line misses
  /// it.
  std::optional<double> rise(const RoundedFace& face, const Vec3d& from, const Vec3d& outward) const {
    const auto exit = face.exit(from);
    if (!exit) return std::nullopt;
    return !whole_ && !exit->on_plane ? around_core(from, outward, exit->rise) : exit->rise;
  }

 private:
  PlacedFace face_within(const Vec3d& direction, T lean) const {
    Face<T> face;
    const Vec3<T> local = converted<T>(transposed_times(turn_, direction));
    shape_.visit([&](const auto& c) {
      using C = std::decay_t<decltype(c)>;
      if constexpr (requires { c.core_face(local, face, T()); })
        c.core_face(local, face, lean);
      else if constexpr (BoundedConvex<C>)
        c.core_face(local, face);
    });
    PlacedFace there;
    there.id = face.id;
    for (const Vec3<T>& v : face.vertices) there.vertices.push_back(placed(converted<double>(v)));
    for (const std::uint32_t id : face.ids) there.ids.push_back(id);
    return there;
  }

  Vec3d placed(const Vec3d& point) const { return turn_ * point + pose_.translation; }

  /// Newton's method on the distance to the core, which is convex along the line. A face of a curved core is a polygon
  /// inscribed in the rim, or one generator of the side, and the surface bulges out between their balls; for a hull,
  /// another face may protrude beyond a sharp corner.
  double around_core(const Vec3d& from, const Vec3d& outward, double rise) const {
    const Shape<T> point = Sphere<T>(T(0));
    const Vec3d local = transposed_times(turn_, from - pose_.translation), direction = transposed_times(turn_, outward);
    for (int i = 0; i < newton_steps; ++i) {
      const auto core = general_distance(shape_, point, Posed{local + direction * rise, {}}).core;
      const double short_of = radius_ - core.distance, slope = dot(core.normal, direction);
      if (!(std::abs(short_of) > rounding_error * size_) || !(slope > 0)) break;
      rise += short_of / slope;
    }
    return rise;
  }

  const Shape<T>& shape_;
  Posed pose_;
  Mat3d turn_;
  double radius_ = 0, size_ = 0;
  bool flat_sided_ = false, straight_ = false;
  bool whole_ = false;  ///< nothing of the rounded core protrudes over the edges of its rounded face
};

}  // namespace graze
