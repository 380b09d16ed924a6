// The reach of bodies that turn, in either space, and the bodies of the plane that are refused.
#include "graze/world/space.hpp"

#include <cmath>

#include "graze/plane/space.hpp"
#include "plane/leaves.hpp"
#include "shape/reach.hpp"

namespace graze {

template <class T>
Aabb<T> Space<T>::bounds_turning(const Shape& shape, const Pose& pose, const Turning& angular) {
  return graze::bounds_turning(shape, pose, angular);
}

template <class T>
T Space<T>::speed_of_turning(const Shape& shape, const Turning& angular) {
  const T turning = length(angular);
  return turning > T(0) ? turning * reach_of(shape) : T(0);
}

template struct Space<float>;
template struct Space<double>;

namespace plane {

namespace {

/// The radius of the disc about the shape's origin that holds it; infinite for a shape without end.
template <class T>
T extent_or_infinity(const Shape<T>& shape) {
  return is_bounded(shape) ? extent(shape) : std::numeric_limits<T>::infinity();
}

}  // namespace

template <class T>
Aabb<T> Space<T>::bounds_turning(const Shape& shape, const Pose& pose, const Turning& angular) {
  if (angular == T(0)) return bounds(shape, pose);
  // The sums of an extent lose a few units in the last place, far less than this.
  const T safe = T(1.0001);
  const T reach = extent_or_infinity(shape) * safe;
  const Vec corner{reach, reach};
  return flat({pose.translation - corner, pose.translation + corner});
}

template <class T>
T Space<T>::speed_of_turning(const Shape& shape, const Turning& angular) {
  return angular != T(0) ? std::abs(angular) * extent_or_infinity(shape) : T(0);
}

template <class T>
auto Space<T>::checked(const Pose& pose) -> Pose {
  const Rot2<T>& turn = pose.rotation;
  detail::checked_point(pose.translation, "pose.translation");
  if (const char* expectation = validate::fault_of_coordinate(turn.cosine))
    validate::fail("pose.rotation.cosine", expectation, static_cast<double>(turn.cosine));
  if (const char* expectation = validate::fault_of_coordinate(turn.sine))
    validate::fail("pose.rotation.sine", expectation, static_cast<double>(turn.sine));
  if (turn.cosine == T(0) && turn.sine == T(0)) validate::fail("pose.rotation", "not zero", "[0, 0]");
  // A rotation of unit length stays bit for bit, whereas dividing it once more by its length could change it: its
  // square is off by twice three quarters of a rounding in each component, and by one in the sum.
  const T off = turn.cosine * turn.cosine + turn.sine * turn.sine - T(1);
  const bool is_unit = std::abs(off) <= T(4) * std::numeric_limits<T>::epsilon();
  return {pose.translation, is_unit ? turn : normalized(turn)};
}

template <class T>
void Space<T>::check(const Vec& linear, const Turning& angular) {
  detail::checked_point(linear, "linear");
  if (const char* expectation = validate::fault_of_coordinate(angular))
    validate::fail("angular", expectation, static_cast<double>(angular));
}

template struct Space<float>;
template struct Space<double>;

}  // namespace plane

}  // namespace graze
