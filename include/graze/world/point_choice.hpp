// The choice of points that a pair of bodies keeps, among all of its manifolds, by the rule of `reduce.hpp`.
//
// Guarantee: the choice follows from the points, their order and their normals alone. Memory serves pair after pair.
#pragma once

#include <cstddef>
#include <vector>

#include "graze/world/space.hpp"

namespace graze {

/// Chooses the points of a pair that are kept.
template <class T, class Space = graze::Space<T>>
class GRAZE_API PointChoice {
  using Vec = typename Space::Vec;

 public:
  /// Forgets the points of the last pair.
  void clear() { points_.clear(); }
  /// Adds a point of the manifold with that number and normal (unit, from A to B).
  void add(const typename Space::ContactPoint& p, const Vec& normal, std::size_t manifold) {
    points_.push_back({p.position(), normal, p.distance, T(0), manifold, false});
  }
  std::size_t size() const { return points_.size(); }
  /// Marks `count` of the points, of which there must be more. Costs `count` times their number.
  void choose(std::size_t count);
  /// Whether the i-th added point is marked.
  bool kept(std::size_t i) const { return points_[i].kept; }
  /// Bytes that are held.
  std::size_t memory() const { return points_.capacity() * sizeof(Candidate); }

 private:
  struct Candidate {
    Vec place, normal;
    T distance;
    T apart_squared;  ///< squared distance from the nearest point kept so far
    std::size_t manifold;
    bool kept;
  };

  static bool before(const Candidate& p, const Candidate& q);
  void choose_of_one(std::size_t count);

  std::vector<Candidate> points_;
  typename Space::Manifold one_;
};

}  // namespace graze
