// What a world of many ranks holds on one of them, and the steps of its update.
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "graze/pairs.hpp"
#include "mpi/body_record.hpp"
#include "mpi/keyed_events.hpp"
#include "mpi/owned_bodies.hpp"
#include "mpi/partition.hpp"

namespace graze::mpi {

/// What a pair of which contacts are looked for costs beside a body: some 100 ns beside 50.
constexpr float cost_of_pair = 2, cost_of_body = 1;

/// A point of both boxes, if they overlap.
template <class T>
Vec3<double> common_point(const Aabb<T>& a, const Aabb<T>& b) {
  return converted<double>(greatest(a.lower, b.lower));
}

/// Counts the seconds since the last call.
class Clock {
 public:
  double lap() {
    const double before = std::exchange(since_, now());
    return since_ - before;
  }

 private:
  static double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  double since_ = now();
};

template <class T>
struct World<T>::Parts {
  Parts(MPI_Comm c, WorldSettings<T> s, Executor* e)
      : comm(c),
        settings(std::move(s)),
        executor(e ? e : &serial),
        partition(c),
        manifolds(settings.points_per_pair.value_or(ManifoldFinder<T>::all_points)) {}

  /// A body that stands here, lent or not.
  struct Local {
    Key key;
    const Body<T>* body;  ///< among `owned` or `guests`
    bool lent;
  };
  /// A fixed body for the rank on which one that moves lives.
  struct Sent {
    BodyRecord<T> standing;
    Key moving;
  };

  void check(Key key, bool there) const {
    if (owned.contains(key) != there)
      throw InvalidValue("key", there ? "that of a body that lives on this rank" : "one that no body has",
                         std::to_string(key));
  }
  typename OwnedBodies<T>::Entry& entry(Key key) {
    const auto found = owned.find(key);
    if (!found) check(key, true);
    return *found;
  }

  /// The steps of an update in blocks (world_blocks.cpp).
  class InBlocks;

  // The steps of an update; those that exchange something all ranks do together.
  void balance(Together& together);
  void migrate(Together& together);
  void lend(Together& together);
  void find_pairs(Together& together);
  void find_contacts();
  void find_events(Together& together);
  void let_go_of_contacts();

  void find_who_leaves(ByRank<BodyRecord<T>>& to);
  void find_who_is_lent(ByRank<BodyRecord<T>>& to);
  void find_own_pairs(ByRank<Sent>& to);
  void take_pairs(const ByRank<Sent>& from);
  void take_in(const BodyRecord<T>& record);
  bool is_far_from_borders(typename OwnedBodies<T>::Entry& o) const;
  void find_bounds_here();
  std::vector<std::uint32_t> sort_local();
  std::uint32_t place_of(Key key) const;

  MPI_Comm comm;
  WorldSettings<T> settings;
  SerialExecutor serial;
  Executor* executor;
  SharedShapes<T> shared;
  OwnedBodies<T> owned;
  Partition partition;
  double drawn_imbalance = 1;

  // Of the last update.
  std::vector<Local> local;    ///< sorted by key
  std::deque<Body<T>> guests;  ///< the bodies of those that are lent
  std::unique_ptr<BodyArrays<T>> arrays;
  std::vector<Aabb<T>> boxes;
  PairFinder<T> finder;
  std::vector<IdPair> candidates, mine;
  /// Kept for its storage. What it remembers is of other bodies by now, which only guides where it looks first.
  ManifoldFinder<T> manifolds;
  std::vector<KeyedPair> pairs;
  KeyedEvents events;
  WorldReport report;
};

}  // namespace graze::mpi
