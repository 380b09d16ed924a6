// The fifth stage of a world: from pairs to contact manifolds, in plain arrays.
//
// Guarantee: for each pair what `contacts` answers, bit for bit, whatever was remembered from the last call and on
// however many threads it runs; but for what moves over the seam of fixed bodies side by side, which meets them as if
// they were one, and for a pair that has more points than it may, of which those are left that `reduce` chooses. Pairs
// are sorted; their manifolds and points stand as they were found, kind of pair by kind of pair, and those of one pair
// one behind the other. What is remembered only saves work: a pair of which neither body changed keeps its manifolds,
// where few pairs changed also their places, and one that was apart is tried first along the direction in which it was,
// but for pairs of balls, capsules, boxes, triangles and half-spaces that have a kernel: those are asked about many at
// a time.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "graze/contact.hpp"
#include "graze/executor.hpp"
#include "graze/world/bins.hpp"
#include "graze/world/bodies.hpp"
#include "graze/world/point_choice.hpp"
#include "graze/world/refilled.hpp"

namespace graze {

template <class T, class PlacedRef>
struct Surroundings;
template <class T, class Space>
struct Waiting;

/// Two bodies within the margin of each other, and where their manifolds stand.
template <class T>
struct ContactPair {
  std::uint32_t a, b;  ///< indices of bodies, a < b; normals point from a to b
  bool overlap;        ///< distance <= 0
  std::uint32_t first_manifold, manifold_count;
};

/// Points that share a normal, and where they stand.
template <class T, class Space = graze::Space<T>>
struct ContactManifold {
  typename Space::Vec normal{};    ///< unit, from a to b
  std::uint32_t piece_a, piece_b;  ///< of a composite: the first triangle or child of it that touches
  std::uint32_t first_point, point_count;
};

/// A point of contact and what a solver has pushed there so far.
template <class T, class Space = graze::Space<T>>
struct SolverPoint : Space::ContactPoint {
  typename Space::Vec
      impulse{};  ///< the solver's own: carried on to the same point of the next update, zero at a new one
};

/// What an update found. The solver writes the points' impulses, nobody anything else.
template <class T, class Space = graze::Space<T>>
struct ContactArrays {
  std::vector<ContactPair<T>> pairs;                 ///< sorted
  std::vector<ContactManifold<T, Space>> manifolds;  ///< in an order of their own, as are the points
  std::vector<SolverPoint<T, Space>> points;         ///< of all manifolds, one behind the other

  std::span<const ContactManifold<T, Space>> manifolds_of(const ContactPair<T>& p) const {
    return std::span(manifolds).subspan(p.first_manifold, p.manifold_count);
  }
  std::span<const SolverPoint<T, Space>> points_of(const ContactManifold<T, Space>& m) const {
    return std::span(points).subspan(m.first_point, m.point_count);
  }
};

/// Finds the contacts of the pairs.
template <class T, class Space = graze::Space<T>>
class GRAZE_API ManifoldFinder {
  using Vec = typename Space::Vec;
  using Shape = typename Space::Shape;
  using Pose = typename Space::Pose;
  using PlacedRef = typename Space::PlacedRef;

 public:
  static constexpr std::size_t all_points = (std::numeric_limits<std::size_t>::max)();  ///< keeps all of them

  /// A finder that leaves at most so many points of a pair, chosen as by `reduce` of its manifolds.
  explicit ManifoldFinder(std::size_t points_per_pair = all_points) : points_per_pair_(points_per_pair) {}

  /// The contacts of `pairs` (sorted), each up to the smaller margin of its two bodies. A pair with a trigger is only
  /// asked whether it overlaps, and has no manifolds. Where no body changed and the pairs are the same, nothing is
  /// done. Calls `paired` once, from any thread, when those in contact stand in `contacts().pairs`; their manifolds and
  /// points may still be put together while it runs.
  void find(
      const BodyArrays<T, Space>& bodies, std::span<const IdPair> pairs, Executor& executor,
      const std::function<void()>& paired = [] {});

  /// Those of the last time.
  ContactArrays<T, Space>& contacts() { return now_; }
  /// Those of the last time.
  const ContactArrays<T, Space>& contacts() const { return now_; }

  std::size_t memory() const;

 private:
  /// What a candidate pair was after the last call, if not one of those in contact.
  static constexpr std::uint32_t unknown = ~std::uint32_t{0}, apart = unknown - 1;
  /// So many that a thread which comes late to the last task costs little, and as many as kernels take at a time.
  static constexpr std::size_t pairs_per_task = 256;
  /// What one thread finds, one behind the other, on lines that no other thread writes.
  struct alignas(64) Found {
    Refilled<ContactManifold<T, Space>> manifolds;
    Refilled<SolverPoint<T, Space>> points;
    // Kept for their storage.
    std::vector<typename Space::Manifold> composite;
    std::vector<SolverPoint<T, Space>> sorted;
    PointChoice<T, Space> choice;
  };
  /// A task's pairs and where what is found of them stands: among what its thread found, and in the end.
  struct Task {
    std::size_t number = 0, found = 0;
    std::size_t first_manifold = 0, manifold_count = 0, first_point = 0, point_count = 0;
    std::size_t contacts = 0;  ///< pairs that touch
    std::size_t to_manifold = 0, to_point = 0;
  };
  /// A pair that touches, as `ContactPair`, but its manifolds are counted within the task.
  struct Touch {
    std::uint32_t first_manifold, manifold_count;
    bool overlap;
  };
  /// A pair whose contacts are found anew and put where the last ones stand.
  struct Asked {
    std::uint32_t place, contact;  ///< among the pairs, and what it was after the last call
    std::size_t first_manifold;    ///< of the task that looks at it
  };
  /// Manifolds of the last call, one behind the other, that are to be copied.
  struct Run {
    std::uint32_t begin = 0, end = 0;
  };
  /// What a pair has to know of a body before it looks at it.
  struct Seen {
    const void* concrete;  ///< as kernels take it, or null
    T margin;
    std::uint8_t traits;  ///< bits of those below
  };
  /// The fixed bodies that one which moves may touch: `count` of the neighbours, from `first` on.
  struct Around {
    std::uint32_t first = 0, count = 0, filled = 0;
  };
  /// `fresh`: another body had its index in the last call.
  static constexpr std::uint8_t changed = 1, trigger = 2, fixed = 4, fresh = 8;

  bool kinds_stay(const BodyArrays<T, Space>& bodies) const;
  void look(const BodyArrays<T, Space>& bodies);
  void look_at(const BodyArrays<T, Space>& bodies, std::uint32_t index);
  void remember(std::span<const IdPair> pairs);
  void keep_axes_where_of_use();
  void find_neighbours(const BodyArrays<T, Space>& bodies);
  bool ground_pairs_differ() const;
  std::span<const PlacedRef> neighbours_of(std::uint32_t index) const;
  Surroundings<T, PlacedRef> beside(const IdPair& pair) const;
  void find_some(const BodyArrays<T, Space>& bodies, Task& task);
  void find_of_a_kind(const BodyArrays<T, Space>& bodies, std::span<const std::uint32_t> places,
                      Waiting<T, Space>& waiting, Task& task);
  class TaskSink;
  void find_waiting(const BodyArrays<T, Space>& bodies, Waiting<T, Space>& waiting, Task& task);
  void find_one(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task);
  void find_single(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task);
  void find_composite(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task);
  bool stays(const BodyArrays<T, Space>& bodies, const IdPair& pair, const Vec& normal,
             std::span<const SolverPoint<T, Space>> points) const;
  void keep_last(std::uint32_t place, Run& run, Task& task);
  void copy_last(Run& run, Task& task);
  void keep_apart(std::uint32_t place);
  void fetch(const BodyArrays<T, Space>& bodies, std::uint32_t index) const;
  void touch(std::uint32_t place, Task& task, std::size_t first_manifold, std::size_t manifolds, bool overlap);
  T margin_of(const IdPair& pair) const;
  void keep(const BodyArrays<T, Space>& bodies, std::uint32_t place, Task& task, bool overlap, const Vec& normal,
            std::size_t points);
  std::size_t reduce_one(Found& found, const Vec& normal, std::size_t first_point) const;
  void reduce_many(Found& found, std::size_t first_manifold, std::size_t first_point) const;
  bool mend(const BodyArrays<T, Space>& bodies);
  bool list_asked();
  void find_asked(const BodyArrays<T, Space>& bodies);
  bool fits(const Asked& asked) const;
  void put_in_place(const Asked& asked);
  void find_on_threads(const BodyArrays<T, Space>& bodies, Executor& executor);
  void run_task(const BodyArrays<T, Space>& bodies, std::size_t number, std::size_t found);
  void join_pairs(Executor& executor);
  void join_pairs(std::size_t begin, std::size_t end, std::uint32_t place);
  void join_tasks(Executor& executor, const std::function<void()>& paired);
  void join_task(const Task& task);
  void carry_one(std::uint32_t place, std::span<SolverPoint<T, Space>> points) const;
  void carry_many(std::uint32_t place, std::span<SolverPoint<T, Space>> points,
                  std::vector<SolverPoint<T, Space>>& sorted) const;
  std::span<const SolverPoint<T, Space>> last_points(std::uint32_t place) const;

  std::size_t points_per_pair_;
  std::vector<Seen> seen_;  ///< of each body
  Bins bins_;
  const Shape* shapes_ = nullptr;            ///< where those stood
  std::vector<std::uint32_t> last_changes_;  ///< which of them are seen as changed
  std::vector<std::uint32_t> generations_;   ///< of each body
  std::vector<Around> around_;               ///< of each body that is in a pair with a fixed one
  std::vector<PlacedRef> neighbours_;
  std::size_t ground_ = 0;       ///< how many bodies are fixed
  bool ground_changed_ = false;  ///< some of them did
  std::vector<IdPair> pairs_, last_pairs_;
  /// Of each pair: its place among those in contact, or as above; once it was looked at and until all were, its touch.
  std::vector<std::uint32_t> contact_, last_contact_;
  /// Of each pair, in the frame of a: along it they were apart; zero for none. Only where pairs without a kernel are.
  std::vector<Vec> axes_, last_axes_;
  bool keeps_axes_ = false;
  std::vector<Found> found_;
  std::vector<Asked> asked_;
  std::vector<std::uint32_t> asked_places_;  ///< those of `asked_`
  std::vector<Task> tasks_;
  std::vector<Touch> touches_;                 ///< room for as many of each task as it has pairs
  std::vector<std::uint32_t> first_contacts_;  ///< of each range of pairs
  ContactArrays<T, Space> now_, last_;
};

}  // namespace graze
