// A line that is cut into strips no narrower than the boxes on it are long.
//
// Guarantee: boxes no longer than `length` whose closed intervals overlap begin in the same strip or in neighbouring
// ones; the strip of a number never descends as the number grows. At most `most` strips, whatever the numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace graze {

template <class T>
class Strips {
 public:
  static constexpr std::uint32_t most = 4096;

  /// Sets equal strips for numbers from `lowest` to `highest`, both finite with a finite difference. Returns false
  /// where they would have to be wider than boxes are long: `adapt` then makes better ones.
  bool set(T lowest, T highest, T length) {
    bounds_.clear();
    origin_ = lowest;
    const T range = highest - lowest;
    width_ = std::max(length * slack, range / T(most - 2));
    inverse_ = range > T(0) ? T(1) / width_ : T(0);
    if (!(inverse_ <= std::numeric_limits<T>::max())) inverse_ = T(0);  // all of it is one strip
    count_ = static_cast<std::uint32_t>((highest - origin_) * inverse_) + 1;
    return length * slack >= width_ || range <= T(0);
  }

  /// Makes strips that follow where boxes begin: none much narrower than `length`, and none but the last with less than
  /// a 4096th of all of them. Sorts `begins`.
  void adapt(std::span<T> begins, T length) {
    std::sort(begins.begin(), begins.end());
    const std::size_t least = begins.size() / most + 1;
    bounds_.assign(1, begins[0]);
    std::size_t last = 0;
    for (std::size_t i = 1; i < begins.size(); ++i) {
      const bool wide = begins[i] - bounds_.back() >= length * slack && begins[i] > bounds_.back();
      if (!wide || i - last < least) continue;
      bounds_.push_back(begins[i]);
      last = i;
    }
    count_ = static_cast<std::uint32_t>(bounds_.size());
  }

  std::uint32_t count() const { return count_; }

  /// The strip of a number in the range that the strips were made for.
  std::uint32_t strip(T v) const {
    return bounds_.empty() ? static_cast<std::uint32_t>(static_cast<std::int32_t>((v - origin_) * inverse_))
                           : search(v);
  }
  /// The strip of any number: those outside are in the outermost strips.
  std::uint32_t nearest(T v) const {
    if (!bounds_.empty()) return search(v);
    if (!(v > origin_)) return 0;
    const T at = (v - origin_) * inverse_;
    return at < T(count_) ? static_cast<std::uint32_t>(at) : count_ - 1;
  }
  std::size_t memory() const { return bounds_.capacity() * sizeof(T); }

 private:
  /// A strip's width over its boxes' greatest length: the place of a number among 4096 strips is off by 4096 times a
  /// few roundings, a thousandth in single precision.
  static constexpr T slack = T(1.004);

  std::uint32_t search(T v) const {
    const auto after = std::upper_bound(bounds_.begin(), bounds_.end(), v);
    return after == bounds_.begin() ? 0 : static_cast<std::uint32_t>(after - bounds_.begin()) - 1;
  }

  T origin_{}, width_{}, inverse_{};
  std::uint32_t count_ = 1;
  std::vector<T> bounds_;
};

}  // namespace graze
