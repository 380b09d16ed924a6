// The decision when the borders between ranks are drawn anew.
//
// Guarantee: drawings end. In a scene that lies still at most twelve in a row gain nothing, however unevenly its work
// is shared: a body cannot be cut, and borders move what is lent across them.
#pragma once

#include <algorithm>

namespace graze::mpi {

class Redrawing {
 public:
  /// `threshold`: the largest load over the mean from which on borders are drawn.
  explicit Redrawing(double threshold) : threshold_(threshold) {}

  /// Whether to draw; called once an update, with the imbalance and the work of all ranks in the update before: a count
  /// of bodies and of pairs that may touch. The same work as the last time means that nothing moved since.
  bool is_due(double imbalance, double work) {
    if (work != work_) {
      in_vain_ = 0;
      best_ = imbalance;
    } else if (drawn_) {
      in_vain_ = imbalance * gain < best_ ? 0 : in_vain_ + 1;
      best_ = std::min(best_, imbalance);
    }
    drawn_ = false;
    work_ = work;
    if (imbalance <= threshold_) return false;
    return in_vain_ < few_in_vain || (in_vain_ < most_in_vain && imbalance > best_ * near);
  }
  /// Records that borders were drawn.
  void drawn() { drawn_ = true; }

 private:
  /// The factor by which a balance has to be better to count as better.
  static constexpr double gain = 1.02;
  /// Drawings without gain after which borders stay if they are nearly as good as the best were, and if they are not.
  /// Costs that were found under other borders do not fit the new ones, so that drawings go to and fro.
  static constexpr int few_in_vain = 3, most_in_vain = 12;
  static constexpr double near = 1.05;

  double threshold_, best_ = 1, work_ = -1;
  int in_vain_ = 0;
  bool drawn_ = false;
};

}  // namespace graze::mpi
