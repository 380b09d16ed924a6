// The distinction of shapes in contact that press against each other from those that slide along each other.
//
// Guarantee: shapes slide from one time to another only when a plane shows it: one along which they overlap, at both
// times, by no more than they may sink, and which leads over no seam of the surface that a shape is a triangle of
// (`cast/surface_seams.hpp`). Shapes that pass through each other have no such plane, however thin they are: the depth
// to which they may sink is a part of their widths across the plane, and so leaves no way to its other side.
#pragma once

#include "cast/surface_seams.hpp"
#include "cast/turning_envelope.hpp"

namespace graze {

/// The part of their depth by which shapes that turn deep in each other may get deeper: less takes thousands of steps a
/// turn.
inline constexpr double sinking_turned = 1.0 / 8;

/// The part of the way to the middle of each other that shapes may sink: a quarter of it is far from the middle, where
/// both sides of a thin shape are as near.
inline constexpr double sinking_of_way = 1.0 / 4;

/// The part of the smaller shape to which coordinates may be rounded for it to be known to slide.
inline constexpr double slack_of_size = 1.0 / 16;

/// The depth along a plane that still shows sliding, as a multiple of that to which shapes may sink: steps end half as
/// much deeper, and a plane that is taken over from another time is not the best of its own.
inline constexpr double sinking_shown = 3;

/// The cosine below which a normal is that of the other side of a shape that was met: near its end even a thick needle
/// is thinner than shapes may sink, and its other side no proof that they slid.
inline constexpr double opposite_side = -0.7;

/// The seams of two pieces, of those that are triangles of a surface.
template <class T>
struct PieceSeams {
  const SurfaceSeams *a, *b;

  /// A direction of the world in the frame of a piece.
  static Vec3d own(const PieceAt<T>& piece, const Vec3d& n) { return rotate(conjugate(piece.pose().rotation), n); }
  /// Whether the normal of an impact leads over the seam of either on which its point lies.
  bool crossed_at(const Impact& impact, const PieceAt<T>& at_a, const PieceAt<T>& at_b, const Vec3d& offset) const {
    return crossed_at(a, at_a, impact.normal, impact.a) || crossed_at(b, at_b, -impact.normal, impact.b - offset);
  }
  static bool crossed_at(const SurfaceSeams* seams, const PieceAt<T>& at, const Vec3d& n, const Vec3d& point) {
    return seams != nullptr && seams->crossed_by(own(at, n), inverse_transform(at.pose(), point));
  }
  /// Whether a unit normal from A to B leads over a seam of either.
  bool crossed_by(const Vec3d& n, const PieceAt<T>& at_a, const PieceAt<T>& at_b) const {
    return (a && a->crossed_by(own(at_a, n))) || (b && b->crossed_by(own(at_b, -n)));
  }
};

template <class T>
class Sliding {
 public:
  /// `tolerance`: the D of `graze/cast.hpp`; `slack`: the rounding to T of poses and coordinates.
  Sliding(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b, double tolerance, double slack,
          const PieceSeams<T>& seams)
      : motion_(motion), a_(a), b_(b), tolerance_(tolerance), slack_(slack), seams_(seams) {}

  /// Begins with shapes that are in contact at the start of the cast.
  void start(const Impact& impact) {
    base_ = least(0.0, impact.distance);
    turns_deep_ = still() ? 0 : -base_ * sinking_turned;
  }

  /// The depth along a normal, beyond that at the start, to which the shapes may get.
  double may_sink(const Vec3d& n, const PieceAt<T>& a, const PieceAt<T>& b) {
    const double way = (width(a_, a, n) + width(b_, b, n)) / 2 + base_;
    return greatest(least(most_sinking(), way * sinking_of_way), least_sinking());
  }
  double base() const { return base_; }

  /// Whether no plane at hand shows that the shapes slid from one impact to the next: neither that across the normal of
  /// either, nor the one between them along which they move.
  bool passed(const Impact& from, const Impact& to, const PieceAt<T>& a, const PieceAt<T>& b) {
    return passed(from, to, to.t, a, b);
  }

  /// `passed` for shapes that are apart at the second time. Thin shapes are apart again before they are on the other
  /// side, so the plane is to show it for a while longer.
  bool passed_out(const Impact& from, const Impact& to, const PieceAt<T>& a, const PieceAt<T>& b) {
    return passed(from, to, still() ? to.t + 2 * size() / length(motion_.velocity) : to.t, a, b);
  }

 private:
  /// The depth to which shapes may sink at most, however wide they are.
  double most_sinking() {
    if (!(sink_ > 0))
      sink_ = sinking * static_cast<double>(cast_tolerance<T>) * size() + least(slack_, size() * slack_of_size);
    return greatest(sink_, turns_deep_);
  }
  /// The depth to which they may sink in any case: the error of a distance.
  double least_sinking() const { return tolerance_ / 16; }

  bool still() const { return motion_.a.none() && motion_.b.none(); }
  /// `a` and `b` are at the second time; `until` is later than that only for bodies that do not turn.
  bool passed(const Impact& from, const Impact& to, double until, const PieceAt<T>& a, const PieceAt<T>& b) {
    std::optional<PieceAt<T>> begin_a, begin_b;
    const auto slid_from = [&](const Vec3d& n) {
      if (still()) return slides_at(from.t, n, a, b);
      if (!begin_a) begin_a.emplace(a_, motion_.a.at(from.t));
      if (!begin_b) begin_b.emplace(b_, motion_.b.at(from.t));
      return slides_at(from.t, n, *begin_a, *begin_b);
    };
    const auto shows_sliding = [&](const Vec3d& n) {
      return !seams_.crossed_by(n, a, b) && slides_at(until, n, a, b) && slid_from(n);
    };
    const bool other_side = dot(from.normal, to.normal) < opposite_side;
    if (shows_sliding(from.normal) || (!other_side && shows_sliding(to.normal))) return false;
    if (is_half_space(a_) || is_half_space(b_)) return true;
    const Vec3d& v = motion_.velocity;
    const Vec3d between = from.normal * dot(to.normal, v) - to.normal * dot(from.normal, v);
    return !(length(between) > 0) || !shows_sliding(unit(between));
  }
  bool slides_at(double t, const Vec3d& n, const PieceAt<T>& a, const PieceAt<T>& b) {
    const double gap = dot(n, motion_.offset_at(t) + b.support(-n) - a.support(n)) - a_.radius - b_.radius;
    // Most planes need no widths, which cost twice what the gap does.
    if (gap >= base_ - sinking_shown * least_sinking()) return true;
    if (gap < base_ - sinking_shown * greatest(most_sinking(), least_sinking())) return false;
    return gap >= base_ - sinking_shown * may_sink(n, a, b);
  }
  static double width(const Piece<T>& piece, const PieceAt<T>& at, const Vec3d& n) {
    if (is_half_space(piece)) return infinity;
    return dot(n, at.support(n) - at.support(-n)) + 2 * piece.radius;
  }
  /// Half of the length of a shape, or more: a shape with corners may stand far from the origin of its body.
  static double size(const Piece<T>& piece) {
    const double core = piece.shape.visit([](const auto& c) {
      using C = std::decay_t<decltype(c)>;
      if constexpr (std::is_same_v<C, HalfSpace<T>>)
        return infinity;
      else if constexpr (std::is_same_v<C, Triangle<T>>)
        return static_cast<double>(greatest(greatest(length(c.point(1) - c.point(0)), length(c.point(2) - c.point(1))),
                                            length(c.point(0) - c.point(2)))) /
               2;
      else
        return static_cast<double>(c.core_extent());
    });
    return core + piece.radius;
  }
  /// The size of the smaller shape; none of two half-spaces.
  double size() const {
    const double smaller = least(size(a_), size(b_));
    return smaller < infinity ? smaller : 0;
  }

  const PairMotion& motion_;
  const Piece<T>&a_, &b_;
  double tolerance_, slack_, sink_ = 0, base_ = 0, turns_deep_ = 0;
  PieceSeams<T> seams_;
};

}  // namespace graze
