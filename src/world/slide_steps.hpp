// Casts, one after the other, of a shape that slides through a world: written once for space and the plane.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "graze/slide.hpp"

namespace graze {

/// A motion leads into a plane when it does so by more than this sine: below are the roundings of a normal.
template <class T>
constexpr T into = T(-64) * std::numeric_limits<T>::epsilon();

template <class T, class Vec>
bool leads_into_none(const Vec& motion, std::span<const Vec> normals) {
  for (const Vec& n : normals)
    if (dot(motion, n) < into<T> * length(motion)) return false;
  return true;
}

/// The motion that makes most of `motion` among those that lead into none of the planes.
template <class T, class Vec>
class NearestMotion {
 public:
  NearestMotion(const Vec& motion, std::span<const Vec> normals) : motion_(motion), normals_(normals) {}

  void consider(const Vec& candidate) {
    const T made = dot(candidate, motion_);
    if (!(made > most_) || !leads_into_none<T>(candidate, normals_)) return;
    most_ = made;
    best_ = candidate;
  }
  const Vec& best() const { return best_; }

 private:
  const Vec& motion_;
  std::span<const Vec> normals_;
  Vec best_{};
  T most_ = T(0);
};

/// The result of `slide`, where `along(motion, normals)` is what is left of a motion in front of what is in the way.
template <class Result, class Shape, class Pose, class Vec, class World, class Along>
Result slide_through(const World& world, const Shape& shape, const Pose& pose, const Vec& motion,
                     const QueryFilter& filter, const SlideOptions& options, const Along& along) {
  using T = std::decay_t<decltype(motion.x)>;
  Result result{pose, motion, {}};
  std::vector<Vec> normals;
  Vec whole = motion;  // what is left to do, before the planes that are met take from it
  for (int i = 0; i < options.iterations && !(result.left == Vec{}); ++i) {
    const auto hit = world.cast(shape, result.pose, {result.left, {}}, T(1), filter, CastOptions{Separating::ignored});
    if (!hit) {
      result.pose.translation += result.left;
      result.left = {};
      break;
    }
    result.touched.push_back(*hit);
    const T made = hit->hit.t;
    result.pose.translation += result.left * made;
    // Away from where a plane was met it need not hold any more.
    if (made > T(0)) normals.clear();
    normals.push_back(-hit->hit.normal);
    whole = whole * (T(1) - made);
    result.left = along(whole, std::span<const Vec>(normals));
  }
  return result;
}

}  // namespace graze
