// The fifth stage of a world: from pairs to contact manifolds, in plain arrays.
//
// Guarantee: for each pair what `contacts` answers, bit for bit, in the order of the pairs, whatever was remembered from
// the last call and on however many threads it runs; but for what moves over the seam of fixed bodies side by side,
// which meets them as if they were one. What is remembered only saves work: a pair of which neither body
// changed keeps its manifolds, and one that was apart is tried first along the direction in which it was, but for boxes and
// balls: those are asked about many at a time.
#pragma once

#include <span>
#include <vector>

#include "graze/contact.hpp"
#include "graze/executor.hpp"
#include "graze/world/bins.hpp"
#include "graze/world/bodies.hpp"

namespace graze {

template <class T>
struct PairRef;
template <class T>
struct Surroundings;

/// Two bodies within the margin of each other, and where their manifolds stand.
template <class T>
struct ContactPair {
  std::uint32_t a, b;  ///< indices of bodies, a < b; normals point from a to b
  bool overlap;        ///< distance <= 0
  std::uint32_t first_manifold, manifold_count;
};

/// Points that share a normal, and where they stand.
template <class T>
struct ContactManifold {
  Vec3<T> normal{};
  std::uint32_t piece_a, piece_b;  ///< of a composite: the first triangle or child of it that touches
  std::uint32_t first_point, point_count;
};

/// A point of contact and what a solver has pushed there so far.
template <class T>
struct SolverPoint : ContactPoint<T> {
  Vec3<T> impulse{};  ///< the solver's own: carried on to the same point of the next update, zero at a new one
};

/// What an update found. The solver writes the points' impulses, nobody anything else.
template <class T>
struct ContactArrays {
  std::vector<ContactPair<T>> pairs;  ///< sorted
  std::vector<ContactManifold<T>> manifolds;
  std::vector<SolverPoint<T>> points;

  std::span<const ContactManifold<T>> manifolds_of(const ContactPair<T>& p) const {
    return std::span(manifolds).subspan(p.first_manifold, p.manifold_count);
  }
  std::span<const SolverPoint<T>> points_of(const ContactManifold<T>& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

template <class T>
class ManifoldFinder {
 public:
  /// The contacts of `pairs` (sorted), each up to the smaller margin of its two bodies. A pair with a trigger is only
  /// asked whether it overlaps, and has no manifolds.
  void find(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, Executor& executor);

  ContactArrays<T>& contacts() { return now_; }
  const ContactArrays<T>& contacts() const { return now_; }

  std::size_t memory() const;

 private:
  /// What is remembered of a candidate pair.
  struct Memory {
    bool apart = false;                 ///< they were, when they were asked about last
    Vec3<T> axis{};                     ///< in the frame of a: along it; zero for none
    std::uint32_t contact = no_result;  ///< its place among the pairs in contact
  };
  /// What a task finds, until all are gathered in order.
  struct Found {
    std::vector<ContactManifold<T>> manifolds;
    std::vector<SolverPoint<T>> points;
    Manifolds<T> composite;  ///< kept for its storage
  };
  /// Where a pair's result stands.
  struct Result {
    std::uint32_t task = 0, first_manifold = 0, manifold_count = 0, point_count = 0;
    bool overlap = false;
  };
  static constexpr std::uint32_t no_result = ~std::uint32_t{0};
  /// What a pair has to know of its bodies before it looks at them: bits of a byte each.
  static constexpr std::uint8_t box = 1, ball = 2, changed = 4, trigger = 8, fixed = 16;

  void find_traits(const BodyArrays<T>& bodies);
  void remember(std::span<const IdPair> pairs);
  void find_neighbours(const BodyArrays<T>& bodies);
  std::span<const PlacedRef<T>> neighbours_of(std::uint32_t index) const;
  Surroundings<T> beside(const IdPair& pair) const;
  void find_some(const BodyArrays<T>& bodies, std::span<const std::uint32_t> places, std::uint32_t task);
  void find_boxes(const BodyArrays<T>& bodies, std::span<const PairRef<T>> boxes, const std::uint32_t* places,
                  std::uint32_t task);
  void find_balls(std::span<const PairRef<T>> balls, const std::uint32_t* places, std::uint32_t task);
  void keep(std::uint32_t place, std::uint32_t task, T distance, const Vec3<T>& normal,
            std::span<const ContactPoint<T>> points);
  void find_one(const BodyArrays<T>& bodies, const IdPair& pair, std::uint32_t place, std::uint32_t task);
  void keep_last(std::uint32_t contact, std::uint32_t place, std::uint32_t task);
  void gather(std::span<const IdPair> pairs, Executor& executor);
  void carry_impulses(const ContactPair<T>& pair, const ContactPair<T>& last, std::vector<SolverPoint<T>>& old);

  std::vector<std::uint8_t> traits_;  ///< of each body
  Bins bins_;
  std::vector<std::uint32_t> first_neighbour_;  ///< of each body: the fixed bodies that it may touch
  std::vector<PlacedRef<T>> neighbours_;
  bool ground_changed_ = false;  ///< some fixed body did
  std::vector<IdPair> pairs_, last_pairs_;
  std::vector<Memory> memory_, last_memory_;
  std::vector<Found> found_;
  std::vector<std::vector<SolverPoint<T>>> scratch_;  ///< of each task
  std::vector<Result> results_;
  std::vector<std::uint32_t> places_, first_point_;  ///< of the pairs in contact: among all, and of their points
  ContactArrays<T> now_, last_;
};

}  // namespace graze
