// Events of touching, for pairs that are found now by one rank and now by another: those that began, go on, or ended.
//
// Guarantee: the events of `EventTracker` in one world. Each rank keeps the pairs that it found; only pairs that it
// misses, or did not have, are compared with those of others, on a rank that the keys name.
#pragma once

#include "graze/mpi/world.hpp"
#include "mpi/exchange.hpp"

namespace graze::mpi {

class KeyedEvents {
 public:
  /// Finds the events of an update. `pairs` are sorted. All ranks.
  void update(Together& together, std::span<const KeyedPair> pairs);

  const std::vector<KeyedEvent>& events() const { return events_; }
  std::size_t memory() const {
    return (events_.capacity() + last_.capacity()) * sizeof(KeyedEvent) +
           apart_.capacity() * sizeof(std::pair<Key, Key>);
  }

 private:
  struct Claim;
  void find_claims(std::span<const KeyedPair> pairs, ByRank<Claim>& claims);
  void keep_apart(std::span<const KeyedPair> pairs);

  std::vector<KeyedEvent> events_, last_;   ///< all but the ends touch
  std::vector<std::pair<Key, Key>> apart_;  ///< found here in the last update, and not touching
};

}  // namespace graze::mpi
