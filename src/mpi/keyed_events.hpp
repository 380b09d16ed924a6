// Who began to touch, still does, no longer does, of pairs that are found now by one rank and now by another.
//
// Guarantee: as `EventTracker` of one world. Each rank remembers what it found; only what it misses, or had not, is
// compared with the others', on a rank that the keys name.
#pragma once

#include "graze/mpi/world.hpp"
#include "mpi/exchange.hpp"

namespace graze::mpi {

class KeyedEvents {
 public:
  /// `pairs` sorted. All ranks.
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
