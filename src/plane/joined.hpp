// Contacts of polygons and chains, joined over the seams of their pieces.
//
// Guarantee: pieces give contacts only along normals of their outlines; points of pieces side by side that share a
// normal are one manifold of at most two points, so that seams leave no trace. Its features name vertices of outlines.
// Bodies that overlap have a contact, but for what lies behind a one-sided chain. A side that lies over several pieces
// in line is held by all of them, however it leans.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "graze/plane/query.hpp"
#include "graze/small_vector.hpp"
#include "plane/leaves.hpp"
#include "plane/manifold.hpp"
#include "plane/nearest.hpp"
#include "plane/on_outline.hpp"
#include "plane/seam_step.hpp"

namespace graze::plane {

/// Appends the points and the normal of a manifold in A's frame to one that has none yet.
template <class T>
void take_world(const Manifold<double>& of_a, const LeafPair<T>& pair, Manifold<T>& out) {
  out.normal = converted<T>(rotate(pair.pose_a.rotation, of_a.normal));
  out.piece_a = pair.piece_a;
  out.piece_b = pair.piece_b;
  for (const ContactPoint<double>& p : of_a.points) {
    ContactPoint<T>& point = out.points.emplace_back();
    point.a = converted<T>(transform(pair.pose_a, p.a));
    point.b = converted<T>(transform(pair.pose_a, p.b));
    point.distance = static_cast<T>(p.distance);
    point.feature = p.feature;
    point.weight = static_cast<T>(p.weight);
  }
}
template <class T>
Manifold<T> in_world(const Manifold<double>& of_a, const LeafPair<T>& pair) {
  Manifold<T> out;
  take_world(of_a, pair, out);
  return out;
}

/// Copies the status of a pair's distance, and the error that it may have, to the answer.
template <class T, class Answer>
void take_status(const Nearest& found, const LeafPair<T>& pair, Answer& out) {
  // An error within the tolerance of T is none.
  if (found.status == Status::bounded && found.error <= double(tolerance<T>) / 2 * pair.size()) return;
  out.status = found.status;
  out.error = static_cast<decltype(out.error)>(found.error);
}

/// Appends the manifold of two convex shapes, if they are within `margin`, and returns whether they overlap.
template <class T>
bool add_manifold(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found, double margin,
                  Manifolds<T>& manifolds) {
  if (const Manifold<double> m = manifold(pair.a, pair.b, b_in_a, found, margin); !m.points.empty()) {
    take_world(m, pair, manifolds.emplace_back());
    take_status(found, pair, manifolds.back());
  }
  return found.distance - pair.a.radius - pair.b.radius <= 0;
}

/// Gathers the contacts of two bodies of which at least one has an outline.
template <class T>
class Joined {
 public:
  Joined(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, Manifolds<T>& out)
      : a_(a), b_(b), pose_a_(at_unit(pose_a)), pose_b_(at_unit(pose_b)), out_(out), first_(out.size()) {}

  /// Learns the sizes of a pair of pieces, which tolerances refer to. For each pair, before its contacts.
  void measure(const LeafPair<T>& pair);
  /// Contacts of one pair of pieces, whose nearest points are `found`.
  void add(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found, double margin);
  /// A second visit, to pairs that overlap where no pair gave a contact that does: lines that cross, and ends that reach
  /// through a corner, leave no normal that is the outline's. The deepest pair then stands in, as it is without its
  /// neighbours.
  void stand_in(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found);
  /// Ends a visit. Returns whether there are contacts, and of bodies that overlap one that touches, whatever else is
  /// within the margin. A stand-in far deeper than what it replaces is left out unless `stands_in()`.
  template <class StandsIn>
  bool finish(bool overlaps, const StandsIn& stands_in) {
    join_doubtful();
    extend_in_line();
    unite();
    const auto counts = [&](const Manifold<T>& m) {
      const auto touches = [](const ContactPoint<T>& p) { return p.distance <= T(0); };
      return !overlaps || std::any_of(m.points.begin(), m.points.end(), touches);
    };
    if (std::any_of(out_.begin() + static_cast<std::ptrdiff_t>(first_), out_.end(), counts)) return true;
    if (!instead_ || !counts(*instead_) || (deeper_ && !stands_in())) return false;
    out_.push_back(*instead_);
    return true;
  }

 private:
  /// The side of a chain that faces the other body's centre.
  struct ChainSide {
    const Chain<T>* chain = nullptr;
    Pose2d pose{};
    bool left = false;
  };
  /// A manifold, as numbers that take no memory of their own.
  struct InLine {
    Vec2<T> normal;
    std::uint32_t piece_a, piece_b;
    std::size_t count;
    ContactPoint<T> points[2];
    double doubt = 0;  ///< error that its normal was assumed to have

    explicit InLine(const Manifold<T>& m)
        : normal(m.normal), piece_a(m.piece_a), piece_b(m.piece_b), count(m.points.size()) {
      std::copy(m.points.begin(), m.points.end(), points);
    }
    InLine() = default;
    Manifold<T> manifold() const {
      Manifold<T> m;
      m.normal = normal, m.piece_a = piece_a, m.piece_b = piece_b;
      for (std::size_t i = 0; i < count; ++i) m.points.push_back(points[i]);
      return m;
    }
  };
  bool face(Core<T>& segment, const Pose2d& pose, const Vec2d& other_center, ChainSide& known) const;
  bool faces(Core<T>& a, Core<T>& b, const LeafPair<T>& pair, const Pose2d& b_in_a);
  bool gives_way(const OnOutline& found, const LeafPair<T>& pair) const;
  void keep_in_line(const Core<T>& a, const Core<T>& b, const LeafPair<T>& pair, const Pose2d& b_in_a, double margin);
  void join(const Manifold<T>& manifold);
  bool extend(const Manifold<T>& manifold, std::size_t end);
  template <class At>
  bool stands_out(std::span<const ContactPoint<T>> points, const ContactPoint<T>& first, const ContactPoint<T>& second,
                  const At& at) const;
  void unite();
  void extend_in_line();
  void keep_doubtful(const Manifold<T>& manifold, double taken);
  void join_doubtful();
  T tolerated() const { return static_cast<T>(double(tolerance<T>) * size_); }
  /// The gap that rounding leaves between the points of pieces side by side, whose places in the world come from
  /// different poses: a few units in the last place of each.
  T seam_gap(const ContactPoint<T>& there) const {
    return tolerated() + T(4) * std::numeric_limits<T>::epsilon() * max_abs(there.a);
  }

  const Shape<T>&a_, &b_;
  Pose2d pose_a_, pose_b_;
  Manifolds<T>& out_;
  std::size_t first_;
  ChainSide side_a_, side_b_;
  double size_ = 0;
  double step_ = 0;  ///< height up to which what stands out between two points is a seam
  /// Contacts of pieces whose nearest points are a neighbour's, along the pieces' own normals.
  SmallVector<InLine, 4> in_line_;
  /// Contacts of curved pieces whose normals come from a search and belong to a piece within the error of that search,
  /// `off_` at most; the surest first. A neighbour may have the same contact exactly.
  SmallVector<InLine, 4> doubtful_;
  double off_ = 0;
  /// The contact that stands in where there is no other: after the first visit the least deep of the contacts whose
  /// points lie beside their edges, after the second the deepest.
  std::optional<Manifold<T>> instead_;
  bool deeper_ = false;  ///< whether `instead_` has a far side's normal, or is far deeper than what it replaces
  double deepest_ = 0;   ///< depth of `instead_`
};

/// Appends the contacts of all pairs of pieces that `visit(see)` calls `see` with, the same in every visit, and returns
/// whether any overlap. Where bodies that overlap have none that touches, the deepest pair stands in if `stands_in()`
/// says so.
template <class T, class Visit, class StandsIn>
bool join_contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, double margin,
                   Manifolds<T>& manifolds, const Visit& visit, const StandsIn& stands_in) {
  bool overlaps = false;
  Joined<T> joined(a, pose_a, b, pose_b, manifolds);
  visit([&](const LeafPair<T>& pair) {
    const Pose2d b_in_a = relative(pair.pose_a, pair.pose_b);
    const Nearest found = nearest(pair.a, pair.b, b_in_a, pair.size());
    joined.measure(pair);
    if (!pair.a.outline && !pair.b.outline) {
      overlaps = add_manifold(pair, b_in_a, found, margin, manifolds) || overlaps;
      return;
    }
    overlaps = overlaps || found.distance - pair.a.radius - pair.b.radius <= 0;
    joined.add(pair, b_in_a, found, margin);
  });
  if (joined.finish(overlaps, stands_in) || !overlaps) return overlaps;
  if (!stands_in()) return true;
  visit([&](const LeafPair<T>& pair) {
    const Pose2d b_in_a = relative(pair.pose_a, pair.pose_b);
    joined.stand_in(pair, b_in_a, nearest(pair.a, pair.b, b_in_a, pair.size()));
  });
  joined.finish(overlaps, stands_in);
  return true;
}

extern template class Joined<float>;
extern template class Joined<double>;

}  // namespace graze::plane
