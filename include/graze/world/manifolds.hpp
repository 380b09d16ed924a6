// The fifth stage of a world: from pairs to contact manifolds, in plain arrays.
//
// Guarantee: each pair gets the answer of `contacts`, bit for bit, whatever was kept from the last call and on however
// many threads it runs. Exceptions are bodies that move over the seam of fixed bodies side by side, which meet these as
// if they were one, and pairs with more points than allowed, which keep those that `reduce` chooses. Pairs are sorted;
// their manifolds and points are in the order in which they were found, kind of pair by kind of pair, and those of one
// pair are contiguous. Data kept from the last call only saves work: a pair of which neither body changed keeps its
// manifolds, and where few pairs changed also their places; a pair that was apart is tested first along its last
// separating direction, except for pairs of balls, capsules, boxes, triangles and half-spaces that have a kernel, which
// are answered many at a time.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "graze/contact.hpp"
#include "graze/detail/refilled.hpp"
#include "graze/executor.hpp"
#include "graze/world/bins.hpp"
#include "graze/world/bodies.hpp"
#include "graze/world/point_choice.hpp"

namespace graze {

template <class T, class PlacedRef>
struct Surroundings;
template <class T, class Space>
struct Waiting;

/// Two bodies within the margin of each other, and the range of their manifolds.
template <class T>
struct ContactPair {
  std::uint32_t a, b;  ///< indices of bodies, a < b; normals point from a to b
  bool overlap;        ///< what `contacts` returns: distance <= 0
  std::uint32_t first_manifold, manifold_count;
};

/// Points that share a normal.
template <class T, class Space = graze::Space<T>>
struct ContactManifold {
  typename Space::Vec normal{};    ///< unit, from a to b
  std::uint32_t piece_a, piece_b;  ///< the first triangle or child of a composite that touches
  std::uint32_t first_point, point_count;
};

/// A point of contact, with the solver's impulse there.
template <class T, class Space = graze::Space<T>>
struct SolverPoint : Space::ContactPoint {
  typename Space::Vec
      impulse{};  ///< the solver's: carried over to the same point of the next update, zero at a new one
};

/// Contacts of an update. Only the solver writes to them: the points' impulses.
template <class T, class Space = graze::Space<T>>
struct ContactArrays {
  std::vector<ContactPair<T>> pairs;                 ///< sorted
  std::vector<ContactManifold<T, Space>> manifolds;  ///< in the order in which they were found, as are the points
  std::vector<SolverPoint<T, Space>> points;         ///< points of a manifold are contiguous

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
  static constexpr std::size_t all_points = (std::numeric_limits<std::size_t>::max)();  ///< no limit on a pair's points

  /// A finder that keeps at most so many points of a pair, chosen as by `reduce` of its manifolds.
  explicit ManifoldFinder(std::size_t points_per_pair = all_points) : points_per_pair_(points_per_pair) {}

  /// Finds the contacts of `pairs` (sorted), each up to the smaller margin of its two bodies. A pair with a trigger is
  /// only tested for overlap, and has no manifolds. Nothing is done where no body changed and the pairs are the same.
  /// Calls `paired` once, from any thread, when `contacts().pairs` holds the pairs in contact; their manifolds and
  /// points may still be put together while it runs.
  void find(
      const BodyArrays<T, Space>& bodies, std::span<const IdPair> pairs, Executor& executor,
      const std::function<void()>& paired = [] {});

  /// The contacts of the last call.
  ContactArrays<T, Space>& contacts() { return now_; }
  /// The contacts of the last call.
  const ContactArrays<T, Space>& contacts() const { return now_; }

  std::size_t memory() const;

 private:
  /// States of a candidate pair without contact after the last call: not computed, or apart.
  static constexpr std::uint32_t unknown = ~std::uint32_t{0}, apart = unknown - 1;
  /// Large enough that a thread which comes late to the last task costs little, and a multiple of what kernels take at
  /// a time.
  static constexpr std::size_t pairs_per_task = 256;
  /// Results of one thread, contiguous, on cache lines that no other thread writes.
  struct alignas(64) Found {
    Refilled<ContactManifold<T, Space>> manifolds;
    Refilled<SolverPoint<T, Space>> points;
    // Kept for their storage.
    std::vector<typename Space::Manifold> composite;
    std::vector<SolverPoint<T, Space>> sorted;
    PointChoice<T, Space> choice;
  };
  /// A task's pairs and the range of its results: among its thread's, and in the end.
  struct Task {
    std::size_t number = 0, found = 0;
    std::size_t first_manifold = 0, manifold_count = 0, first_point = 0, point_count = 0;
    std::size_t contacts = 0;  ///< number of pairs that touch
    std::size_t to_manifold = 0, to_point = 0;
  };
  /// A pair that touches, as `ContactPair`, but with its manifolds counted within the task.
  struct Touch {
    std::uint32_t first_manifold, manifold_count;
    bool overlap;
  };
  /// A pair whose contacts are found anew and put in the place of the last ones.
  struct Asked {
    std::uint32_t place, contact;  ///< index among the pairs, and its state after the last call
    std::size_t first_manifold;    ///< counted within the task that answers it
  };
  /// Contiguous manifolds of the last call that are to be copied.
  struct Run {
    std::uint32_t begin = 0, end = 0;
  };
  /// Attributes of a body, gathered before its pairs are visited.
  struct Seen {
    const void* concrete;  ///< the shape as kernels take it, or null
    T margin;
    std::uint8_t traits;  ///< bits from the list below
  };
  /// The fixed bodies that a moving one may touch: `count` of the neighbours, from `first` on.
  struct Around {
    std::uint32_t first = 0, count = 0, filled = 0;
  };
  /// Bits of `Seen::traits`; `fresh`: another body had its index in the last call.
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
  std::vector<Seen> seen_;  ///< by body
  Bins bins_;
  const Shape* shapes_ = nullptr;            ///< address of the bodies' shapes at the last call
  std::vector<std::uint32_t> last_changes_;  ///< bodies whose `changed` bit is set
  std::vector<std::uint32_t> generations_;   ///< by body
  std::vector<Around> around_;               ///< by body, for those in a pair with a fixed one
  std::vector<PlacedRef> neighbours_;
  std::size_t ground_ = 0;       ///< number of fixed bodies
  bool ground_changed_ = false;  ///< whether any fixed body, or pair with one, changed
  std::vector<IdPair> pairs_, last_pairs_;
  /// By pair: its index among those in contact, or a state from above; while pairs are being answered, its touch.
  std::vector<std::uint32_t> contact_, last_contact_;
  /// By pair, in the frame of a: the direction along which they were apart; zero for none. Kept only where there are
  /// pairs without a kernel.
  std::vector<Vec> axes_, last_axes_;
  bool keeps_axes_ = false;
  std::vector<Found> found_;
  std::vector<Asked> asked_;
  std::vector<std::uint32_t> asked_places_;  ///< the pairs of `asked_`
  std::vector<Task> tasks_;
  std::vector<Touch> touches_;                 ///< for each task room for as many as it has pairs
  std::vector<std::uint32_t> first_contacts_;  ///< by range of pairs
  ContactArrays<T, Space> now_, last_;
};

}  // namespace graze
