// Composites that move, taken apart: the pairs of convex pieces that may come near each other in some stretch of time.
//
// Guarantee: every pair of pieces whose true sweeps come near is visited; of a translation nearer ones first, and none
// that could only meet later than the limit.
#pragma once

#include "cast/time_of_impact.hpp"
#include "composite/leaves.hpp"
#include "composite/sweep.hpp"
#include "narrow/general.hpp"

namespace graze {

/// A piece with the number of the outermost composite's child or triangle that it belongs to.
template <class T>
struct NumberedPiece {
  Piece<T> piece;
  std::uint32_t number = 0;
  bool outermost = true;
  const Shape<T>* surface = nullptr;  ///< the mesh or height field of which it is a triangle
  std::uint32_t in_surface = 0;       ///< its number there

  NumberedPiece child(const Shape<T>& shape, const Pose<T>& local, std::uint32_t its_number) const {
    const bool is_surface = piece.shape.template as<Mesh<T>>() || piece.shape.template as<HeightField<T>>();
    return {Piece<T>(shape, in_double(local)), outermost ? its_number : number, false,
            is_surface ? &piece.shape : nullptr, its_number};
  }
};

/// The motion with B's part and A's exchanged.
inline PairMotion exchanged(const PairMotion& m) { return {m.b, m.a, -m.offset, -m.velocity}; }

/// The sweep of `b` in the interval, seen from the frame of `a`.
template <class T>
Sweep<T> sweep_of(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b, const Interval& interval,
                  double margin) {
  const auto frame_at = [&](double t) { return compose(Posed{{}, motion.a.at(t)}, a.local); };
  const auto bounds_at = [&](double t) {
    const Posed pose_b = compose(Posed{motion.offset_at(t), motion.b.at(t)}, b.local);
    return bounds(b.shape, converted<T>(relative(frame_at(t), pose_b)));
  };
  const double duration = interval.end - interval.begin;
  const T grow = static_cast<T>(margin * (1 + static_cast<double>(std::numeric_limits<T>::epsilon())));
  const auto moved = [&] { return converted<T>(rotate(conjugate(frame_at(0).rotation), motion.velocity * duration)); };
  if (motion.a.none() && motion.b.none()) return safe_sweep(bounds_at(interval.begin), moved(), grow);

  // From the middle of the interval nothing of B moves further, seen from A, than for half of it at its greatest speed.
  const double reach = b.reach();
  if (!(reach < std::numeric_limits<double>::infinity())) return {Aabb<T>::everything(), {}};
  const double away =
      greatest(length(motion.offset_at(interval.begin)), length(motion.offset_at(interval.end))) + reach;
  const double speed = length(motion.velocity) + length(motion.a.angular) * away + length(motion.b.angular) * reach;
  const double path = speed * duration / 2;
  // Nor does a body that turns fast leave the ball about its origin.
  if (motion.a.none() && path > reach) {
    const Vec3<T> center = converted<T>(relative(frame_at(0), Posed{motion.offset_at(interval.begin), {}}).translation);
    return safe_sweep(inflated({center, center}, static_cast<T>(reach * 1.0001)), moved(), grow);
  }
  return safe_sweep(bounds_at((interval.begin + interval.end) / 2), Vec3<T>{}, static_cast<T>(path * 1.0001) + grow);
}

/// Calls `f(piece_a, piece_b)` for all pairs of convex pieces that may come within `margin` in the interval, unless
/// only when more than the part `limit()` of it is over.
template <class T, class Limit, class F>
void visit_moving_pairs(const PairMotion& motion, const NumberedPiece<T>& a, const NumberedPiece<T>& b,
                        const Interval& interval, double margin, const Limit& limit, F& f) {
  if (!a.piece.shape.convex()) {
    const Sweep<T> region = sweep_of(motion, a.piece, b.piece, interval, margin);
    visit_pieces(a.piece.shape, converted<T>(a.piece.local), SweepQuestion<T>{region}, limit,
                 [&](const Shape<T>& shape, const Pose<T>& local, std::uint32_t number) {
                   visit_moving_pairs(motion, a.child(shape, local, number), b, interval, margin, limit, f);
                 });
  } else if (!b.piece.shape.convex()) {
    const Sweep<T> region = sweep_of(exchanged(motion), b.piece, a.piece, interval, margin);
    visit_pieces(b.piece.shape, converted<T>(b.piece.local), SweepQuestion<T>{region}, limit,
                 [&](const Shape<T>& shape, const Pose<T>& local, std::uint32_t number) {
                   visit_moving_pairs(motion, a, b.child(shape, local, number), interval, margin, limit, f);
                 });
  } else {
    f(a, b);
  }
}

}  // namespace graze
