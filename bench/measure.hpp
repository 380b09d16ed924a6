// Asking all libraries the same: how long each takes, and how much of it is right.
//
// All are in one process and take turns in every repetition, so that what slows the machine down slows all of them.
// Times are the processor's, of the one thread that asks.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "peer.hpp"

namespace graze::bench {

/// How one library did on one query for one set of pairs.
struct Cell {
  /// `absent`: it has no such shape or query. `silent`: it answers, and finds none of the pairs that overlap.
  enum class State { absent, silent, measured };
  State state = State::absent;
  double nanoseconds = 0;                   ///< per pair: the median of the repetitions
  double spread = 0;                        ///< of the repetitions: between their quartiles, relative to the median
  std::size_t timed = 0;                    ///< pairs in a repetition
  std::size_t asked = 0;                    ///< pairs that are not within the band in which either answer is right
  std::size_t wrong = 0;                    ///< of those, the ones it has wrong or has no answer for
  std::size_t failed = 0;                   ///< the ones it has no answer for
  std::size_t points = 0, overlapping = 0;  ///< points of contact found, in how many pairs
  std::vector<double> errors;               ///< relative to the size
};

/// What to think of an answer.
struct Verdict {
  bool counts = true;  ///< false: either answer is right
  bool meets = false;  ///< what is so
  bool wrong = false;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< relative to the size; NaN where there is none to tell
};
using Judge = std::function<Verdict(std::size_t, const Answer&)>;

/// Asks once about every pair and judges the answers; with `patience` about as many as that many seconds allow, but a
/// thousand.
Cell judged(Peer& peer, Query query, std::size_t pairs, const Judge& judge,
            double patience = std::numeric_limits<double>::infinity());

struct TimingOptions {
  std::size_t repetitions = 9;
  /// A repetition lasts at least so long, in as many turns through the pairs as it takes; and not much longer than
  /// `most_seconds`: a library that is too slow for all pairs is asked about the first ones.
  double least_seconds = 1e-3, most_seconds = std::numeric_limits<double>::infinity();
};

/// Times those of the cells, one for each of `peers()`, that answer.
void time(Query query, std::size_t pairs, const TimingOptions& options, std::vector<Cell>& cells);

/// What this thread has had of the processor, so that a neighbour on the machine is not in it.
double processor_seconds();
/// By the clock: of work on several threads nothing else says how long one waits for it.
double clock_seconds();

/// Of values in any order; 0 of none.
double quantile(std::vector<double> values, double share);

/// How a run was made, as a list of what and how much: the day, the machine, the compiler and its flags, and versions.
using Conditions = std::vector<std::pair<std::string, std::string>>;
Conditions conditions();

/// Graze first; without those whose names `libraries` does not match.
void choose_peers(const std::string& libraries);

/// Where the run is, on a terminal.
void progress(std::size_t done, std::size_t all, const std::string& what);

/// Swallows what the libraries write while it lives: FCL writes a line for each pair that it cannot answer.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  std::unique_ptr<std::streambuf> nothing_;
  std::streambuf* kept_;
};

}  // namespace graze::bench
