// The first contact of two convex pieces of moving bodies.
//
// Guarantee: that of `graze/cast.hpp`, for convex shapes. Everything is in double and in world axes
// about A's moving origin.
//
// Method: conservative advancement. At a time when the shapes are apart, the plane between them is proven to stay
// between them for a while; then the distance is computed anew. Work is saved by proving a long while. A translation
// follows its planes exactly, GJK searching for better ones as it goes (see `free_translation`). For a shape that
// turns, a bound of the speed alone (Mirtich) gains a constant factor a step, while the shapes' extents along the
// plane's turning normal gain ever more digits a step (see `Separation`); and where all that a shape ever turns through
// stays behind the plane, it stays for any number of turns (see `Envelope`).
#pragma once

#include <optional>

#include "graze/motion.hpp"
#include "graze/shape.hpp"

namespace graze {

/// The turning of a body about its origin, from `start`.
struct Turning {
  Quatd start{};
  Vec3d angular{};

  Quatd at(double t) const;
  bool none() const { return angular == Vec3d{}; }
};

/// Two bodies on their ways: the turning of each, and B's origin seen from A's.
struct PairMotion {
  Turning a, b;
  Vec3d offset{}, velocity{};

  Vec3d offset_at(double t) const { return offset + velocity * t; }
};

/// A piece and its place in its body.
template <class T>
struct Piece {
  explicit Piece(const Shape<T>& shape, const Posed& local = {});

  const Shape<T>& shape;
  Posed local;
  double core_reach;  ///< the radius about the body's origin of a ball that holds the core; infinite for a half-space
  double radius;      ///< of the ball that the core is rounded by

  /// The radius about the body's origin of a ball that holds the whole piece.
  double reach() const { return core_reach + radius; }
};

struct Interval {
  double begin, end;
};

struct Impact {
  double t, distance;
  Vec3d normal, a, b;  ///< the points about A's origin at time t
  Status status;
};

class SurfaceSeams;

/// The rule by which shapes are in contact.
struct CastRule {
  double tolerance;  ///< the D of `graze/cast.hpp`
  double coarse;     ///< that of the larger shape alone, for curved shapes whose distance is known no better
  double slack;      ///< rounding to T of the poses and motions of the bodies
  Separating separating;
  const SurfaceSeams *seams_a = nullptr, *seams_b = nullptr;  ///< of pieces that are triangles of a surface
};

/// The first time in the interval at which the pieces come within the rule's tolerance.
template <class T>
std::optional<Impact> time_of_impact(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b,
                                     const Interval& interval, const CastRule& rule);

}  // namespace graze
