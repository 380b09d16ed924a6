// What an explanation says of composites: how their answer came about at the pair of pieces that decides it.
//
// Guarantee: nothing is kept when no explanation is asked for, and asking changes no bit of the answer.
#pragma once

#include <optional>
#include <string>

#include "graze/query.hpp"
#include "mid/piece_pairs.hpp"

namespace graze {

/// The pair of convex pieces that is deepest or nearest of those offered.
template <class T>
class DecidingPair {
 public:
  explicit DecidingPair(Trace* trace) : trace_(trace) {}

  void offer(T distance, const Part<T>& a, const Part<T>& b) {
    if (!trace_ || (pair_ && !(distance < pair_->distance))) return;
    pair_.emplace(Pair{distance, {a.shape, a.pose}, {b.shape, b.pose}, a.number, b.number});
  }

  /// Asks the pair again, by `ask(shape_a, pose_a, shape_b, pose_b, trace)`, and names the pieces in front of the
  /// method. `a` and `b` are the whole shapes.
  template <class Ask>
  void explain(const Shape<T>& a, const Shape<T>& b, Ask&& ask) const {
    if (!trace_) return;
    trace_->method = "pieces of composites";
    if (!pair_) return;
    ask(pair_->a.shape, pair_->a.pose, pair_->b.shape, pair_->b.pose, trace_);
    const auto name = [](const Shape<T>& whole, std::string letter, std::uint32_t piece) {
      if (whole.convex()) return letter;
      letter += " piece ";
      return letter += std::to_string(piece);
    };
    std::string method("pieces of composites, ");
    method += name(a, "A", pair_->piece_a);
    method += " and ";
    method += name(b, "B", pair_->piece_b);
    method += ": ";
    method += trace_->method;
    trace_->method = method;
  }

 private:
  struct Pair {
    T distance;
    Placed<T> a, b;
    std::uint32_t piece_a, piece_b;
  };

  Trace* trace_;
  std::optional<Pair> pair_;
};

}  // namespace graze
