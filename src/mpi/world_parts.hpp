// The state of a world of many ranks on one of them, and the steps of its update.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "graze/world/candidates.hpp"
#include "mpi/body_record.hpp"
#include "mpi/keyed_events.hpp"
#include "mpi/owned_bodies.hpp"
#include "mpi/pair_costs.hpp"
#include "mpi/partition.hpp"
#include "mpi/redrawing.hpp"

namespace graze::mpi {

/// The unit of work.
constexpr float cost_of_body = 1;

/// Charges a pair to its bodies. Where one of them is lent, the other bears all of it: it is work of this rank and near
/// that body.
inline void charge_pair(float cost, bool a_lives_here, bool b_lives_here, float& of_a, float& of_b) {
  of_a += b_lives_here ? cost / 2 : cost;
  of_b += a_lives_here ? cost / 2 : cost;
}

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
        redrawing(settings.imbalance),
        pair_costs(settings.measured),
        manifolds(settings.points_per_pair.value_or(ManifoldFinder<T>::all_points)) {}

  /// A body that others lent.
  struct Guest {
    Key key;
    Body<T> body;
    bool near = false;  ///< as of `BodyRecord`
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
  /// The arrays of the last update, where they are kept and the body has a place in them.
  BodyArrays<T>* arrays_of(const typename OwnedBodies<T>::Entry& entry) {
    return arrays && entry.place != nowhere ? arrays.get() : nullptr;
  }
  typename OwnedBodies<T>::Entry& entry(Key key) {
    const auto found = owned.find(key);
    if (!found) check(key, true);
    return *found;
  }

  /// The steps of an update in blocks (world_blocks.cpp).
  class InBlocks;

  // The steps of an update; those that exchange something all ranks do together.
  void charge_pairs(Together& together);
  double expected_cost(Together& together);
  void balance(Together& together);
  void migrate(Together& together);
  void lend(Together& together);
  void find_pairs(Together& together);
  void find_contacts();
  void find_events(Together& together);
  void let_go_of_contacts();

  std::optional<Key> find_who_leaves(Key first, ByRank<BodyRecord<T>>& to);
  bool place_own();
  void find_who_is_lent(ByRank<BodyRecord<T>>& to);
  void place_guests(const ByRank<BodyRecord<T>>& from, bool all_placed);
  void place_anew(std::vector<Guest> guests);
  void bring_up(std::uint32_t place, const Body<T>& body, bool reshaped);
  void take_ground(const std::vector<BodyRecord<T>>& ground);
  void find_bounds_of(std::span<const std::uint32_t> places);
  void find_own_pairs(ByRank<Sent>& to);
  void take_pairs(const ByRank<Sent>& from);
  bool is_inside(const Aabb<T>& box) const;
  Aabb<T> bounds_of(const Body<T>& body) const;
  std::uint32_t place_of(Key key) const;

  MPI_Comm comm;
  WorldSettings<T> settings;
  SerialExecutor serial;
  Executor* executor;
  SharedShapes<T> shared;
  OwnedBodies<T> owned;
  Partition partition;
  Redrawing redrawing;
  PairCosts pair_costs;
  std::uint64_t candidates_before = 0;  ///< looked at in the update before

  /// The state of a place of the arrays: a body that lives here, one that is lent, or one that did or was and is not
  /// any more. Places of the latter are kept, because what is lent at borders comes and goes.
  enum Standing : std::uint8_t { away, lives, lent };

  static constexpr std::uint32_t nowhere = OwnedBodies<T>::nowhere;

  // Arrays by place, in the order of the bodies' keys.
  std::vector<Key> keys;
  std::vector<Standing> standing, before;  ///< now, and in the last update
  std::unique_ptr<BodyArrays<T>> arrays;
  std::vector<Aabb<T>> boxes;
  std::unique_ptr<CandidateFinder<T>> finder;
  std::vector<std::uint32_t> late;  ///< places that changed after the last candidates were found
  std::vector<IdPair> mine;
  ManifoldFinder<T> manifolds;
  std::vector<KeyedPair> pairs;
  KeyedEvents events;
  WorldReport report;
};

}  // namespace graze::mpi
