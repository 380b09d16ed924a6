// Costs of the contacts of a pair beside those of a body, kind of pair by kind of pair, as measured.
//
// Guarantee: all ranks compute with the same costs, once they are shared. A sample of the pairs of a kind is timed by
// itself, and the median of ranks taken: seconds of one and the same update differ by a tenth and more between ranks of
// a machine that does other things besides, and borders drawn by them would go to and fro. The number of pairs is
// counted.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "graze/world/bodies.hpp"
#include "graze/world/manifolds.hpp"
#include "mpi/exchange.hpp"

namespace graze::mpi {

class PairCosts {
 public:
  /// The kind of a shape, for shapes whose contacts cost about the same: of one type, and hulls within a
  /// factor of two of corners.
  using Kind = std::uint16_t;

  /// `measures`: whether costs are measured; else all pairs cost the same.
  explicit PairCosts(bool measures) : measures_(measures) {}

  /// Calls `charge(pair, cost)` for each pair, the cost in units of a body's.
  template <class T, class Charge>
  void charge(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, Charge&& charge) {
    const Bodies kinds = kinds_of(bodies, pairs);
    const std::vector<float> table = table_of(kinds.kinds);
    const std::vector<std::uint8_t> due = due_of(kinds.kinds);
    due_ = false;
    for (const IdPair& pair : pairs) {
      const std::size_t kind = kinds.of_pair(pair);
      due_ |= due[kind] != 0;
      charge(pair, table[kind]);
    }
  }

  /// Measures the kinds of pairs that are not known or were measured long ago, for the next `share`, where there are
  /// any among those that were charged last.
  template <class T>
  void measure(const BodyArrays<T>& bodies, std::span<const IdPair> pairs) {
    if (measures_ && due_) measure(bodies, pairs, kinds_of(bodies, pairs));
  }
  /// Sends the measurements of each rank to all. All ranks, once an update.
  void share(Together& together);

  /// Records the seconds of a pair of two kinds, for the next `share`.
  void note(Kind a, Kind b, double seconds) { news_[ordered(a, b)] = seconds; }
  /// The cost of a pair of two kinds, in units of a body's; a usual one where it was never measured.
  float of(Kind a, Kind b) const;

 private:
  using Pair = std::pair<Kind, Kind>;
  struct Known {
    double seconds;
    std::uint64_t update;  ///< in which it was measured
  };
  /// The kinds of the bodies of some pairs, by number.
  struct Bodies {
    std::vector<std::uint8_t> of;  ///< of each body
    std::vector<Kind> kinds;
    std::size_t of_pair(const IdPair& p) const { return of[p.a] * kinds.size() + of[p.b]; }
  };

  static Pair ordered(Kind a, Kind b) { return {std::min(a, b), std::max(a, b)}; }
  bool is_due(Kind a, Kind b) const;
  /// Whether each two of the kinds are to be measured.
  std::vector<std::uint8_t> due_of(const std::vector<Kind>& kinds) const;
  template <class T>
  static Bodies kinds_of(const BodyArrays<T>& bodies, std::span<const IdPair> pairs);
  template <class T>
  void measure(const BodyArrays<T>& bodies, std::span<const IdPair> pairs, const Bodies& kinds);
  std::vector<float> table_of(const std::vector<Kind>& kinds) const;

  bool measures_;
  std::map<Pair, Known> known_;
  std::map<Pair, double> news_;
  std::uint64_t updates_ = 0;
  bool due_ = true;  ///< some kind that was charged last has to be measured, or nothing was charged yet
};

}  // namespace graze::mpi
