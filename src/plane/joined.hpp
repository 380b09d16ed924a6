// Contacts of polygons and chains, joined over the seams of their pieces.
//
// Guarantee: pieces give contacts only along normals of their outlines; points of pieces side by side that share a
// normal are one manifold of at most two points, so that seams leave no trace. Its features name vertices of outlines.
// What overlaps has a contact, but for what lies behind a one-sided chain.
#pragma once

#include <optional>
#include <vector>

#include "graze/plane/query.hpp"
#include "plane/leaves.hpp"
#include "plane/nearest.hpp"

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

/// Gathers the contacts of two bodies of which at least one has an outline.
template <class T>
class Joined {
 public:
  Joined(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, Manifolds<T>& out)
      : a_(a), b_(b), pose_a_(at_unit(pose_a)), pose_b_(at_unit(pose_b)), out_(out), first_(out.size()) {}

  /// Contacts of one pair of pieces, whose nearest points are `found`.
  void add(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found, double margin);
  /// A second visit, to pairs that overlap where no pair gave contacts: lines that cross, and ends that reach through a
  /// corner, leave no normal that is the outline's. The deepest pair then stands in, as it is without its neighbours.
  void stand_in(const LeafPair<T>& pair, const Pose2d& b_in_a, const Nearest& found);
  /// Once after each visit. Returns whether there are contacts.
  bool finish();

 private:
  /// Which side of a chain faces the other body's centre.
  struct ChainSide {
    const Chain<T>* chain = nullptr;
    Pose2d pose{};
    bool left = false;
  };
  bool face(Core<T>& segment, const Pose2d& pose, const Vec2d& other_center, ChainSide& known) const;
  bool faces(Core<T>& a, Core<T>& b, const LeafPair<T>& pair, const Pose2d& b_in_a);
  void join(const Manifold<T>& manifold, T tolerated);

  const Shape<T>&a_, &b_;
  Pose2d pose_a_, pose_b_;
  Manifolds<T>& out_;
  std::size_t first_;
  ChainSide side_a_, side_b_;
  double size_ = 0;
  /// What is told where nothing else is: of the first visit the least deep of the contacts whose points lie beside
  /// their edges, of the second the deepest.
  std::optional<Manifold<T>> instead_;
  double deepest_ = 0;  ///< and how deep that one is
};

extern template class Joined<float>;
extern template class Joined<double>;

}  // namespace graze::plane
