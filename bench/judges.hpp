// What is right: what Graze answers in double precision. Its tests hold that against an independent reference.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "graze/shape.hpp"
#include "measure.hpp"

namespace graze::bench {

/// Pairs as shapes of Graze in double precision; hulls that share their corners are built once.
class Reference {
 public:
  explicit Reference(const std::vector<Pair>& pairs);

  std::size_t size() const { return pairs_->size(); }
  const Pair& pair(std::size_t i) const { return (*pairs_)[i]; }
  const Shape<double>& a(std::size_t i) const { return shapes_[2 * i]; }
  const Shape<double>& b(std::size_t i) const { return shapes_[2 * i + 1]; }
  /// The signed distance after the part t of A's motion, over the size.
  double gap(std::size_t i, double t = 0) const;

 private:
  const std::vector<Pair>* pairs_;
  std::vector<Shape<double>> shapes_;
};

/// Within this of touching, relative to the size, either answer is right: single precision resolves about a hundredth.
inline constexpr double band = 1e-4;
/// By what parts of the size the answers to rays and casts may be off.
inline constexpr double fine = 1e-3, coarse = 1e-2;

/// For `overlap`, `distance` and `contacts`. The error is that of the signed distance, or of the depth of the deepest
/// contact of pairs that overlap.
Judge distance_judge(const Reference& reference, Query query);

/// The first hit has to be where it is within `fine` of the size. Rays that pass or enter by less than the band are not
/// counted where the answer is another.
Judge ray_judge(const Reference& reference);

/// How near two bodies come on the way: the least of the gap, which is a convex function of time.
double least_gap(const Reference& reference, std::size_t i);
/// Whether the answer misses a hit, finds one where there is none, or tells a time at which the shapes are further
/// apart or deeper than `same` times their size.
bool wrong_cast(const Reference& reference, std::size_t i, double least, double t, double same);
/// Pairs that miss or meet by less than `coarse` are not counted; the error is the gap at the time of the answer.
Judge cast_judge(const Reference& reference);

/// For `make_pairs`: whether two bodies touch, by Graze in double precision.
MakeTouching make_touching();

}  // namespace graze::bench
