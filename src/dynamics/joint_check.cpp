// Joints that are refused: frames that are not finite, limits without an axis, drives that pull backwards, axes that
// the plane does not have.
#include <cmath>
#include <string>

#include "dynamics/joints.hpp"
#include "graze/detail/validate.hpp"

namespace graze {

namespace plane {

namespace {

template <class T>
void check_frame(const Pose2<T>& frame, const std::string& path) {
  detail::checked_point(frame.translation, path + ".translation");
  const T square = frame.rotation.cosine * frame.rotation.cosine + frame.rotation.sine * frame.rotation.sine;
  if (!std::isfinite(square) || !(square > T(0)))
    validate::fail(path + ".rotation", "finite and not zero", static_cast<double>(square));
}

}  // namespace

}  // namespace plane

namespace {

template <class T>
T positive(T value, const std::string& path) {
  if (const char* expectation = validate::fault_of_length(value))
    validate::fail(path, expectation, static_cast<double>(value));
  return value;
}

template <class T>
T finite(T value, const std::string& path) {
  if (const char* expectation = validate::fault_of_coordinate(value))
    validate::fail(path, expectation, static_cast<double>(value));
  return value;
}

void check_space(JointSpace space, const std::string& path) {
  if (space > JointSpace::angular)
    throw InvalidValue(path, "linear or angular", std::to_string(static_cast<int>(space)));
}

template <class T>
void check_limit(const JointLimit<T>& limit, const std::string& path) {
  check_space(limit.space, path + ".space");
  if (count(limit.axes) == 0) throw InvalidValue(path + ".axes", "at least one axis", "none");
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (!(limit.min < infinity))
    validate::fail(path + ".min", "a number or minus infinity", static_cast<double>(limit.min));
  if (!(limit.max > -infinity)) validate::fail(path + ".max", "a number or infinity", static_cast<double>(limit.max));
  if (!(limit.min <= limit.max)) validate::fail(path + ".min", "at most max", static_cast<double>(limit.min));
  if (count(limit.axes) > 1 && limit.max < T(0))
    validate::fail(path + ".max", "at least 0 of a limit with several axes", static_cast<double>(limit.max));
  if (limit.stiffness) positive(*limit.stiffness, path + ".stiffness");
  positive(limit.damping, path + ".damping");
}

template <class T>
void check_drive(const JointDrive<T>& drive, const std::string& path) {
  check_space(drive.space, path + ".space");
  if (drive.mode > DriveMode::acceleration)
    throw InvalidValue(path + ".mode", "force or acceleration", std::to_string(static_cast<int>(drive.mode)));
  if (drive.axis > 2) throw InvalidValue(path + ".axis", "0, 1 or 2", std::to_string(drive.axis));
  finite(drive.position_target, path + ".position_target");
  finite(drive.velocity_target, path + ".velocity_target");
  positive(drive.stiffness, path + ".stiffness");
  positive(drive.damping, path + ".damping");
  if (!(drive.max_force >= T(0)))
    validate::fail(path + ".max_force", "a number >= 0", static_cast<double>(drive.max_force));
}

template <class T>
void check_frames(const Joint<T>& joint) {
  validate::point(joint.frame_a.translation, "joint.frame_a.translation");
  validate::point(joint.frame_b.translation, "joint.frame_b.translation");
  validate::rotation(joint.frame_a.rotation, "joint.frame_a.rotation");
  validate::rotation(joint.frame_b.rotation, "joint.frame_b.rotation");
}
template <class T>
void check_axes(const JointLimit<T>&, const Space<T>&, const std::string&) {}
template <class T>
void check_axes(const JointDrive<T>&, const Space<T>&, const std::string&) {}

template <class T>
void check_frames(const Joint<T, plane::Space<T>>& joint) {
  plane::check_frame(joint.frame_a, "joint.frame_a");
  plane::check_frame(joint.frame_b, "joint.frame_b");
}
/// Checks the axes of a joint in the plane, where bodies move along x and y and turn about z.
template <class T>
void check_axes(const JointLimit<T>& limit, const plane::Space<T>&, const std::string& path) {
  const bool linear = limit.space == JointSpace::linear;
  if (linear ? limit.axes[2] : limit.axes[0] || limit.axes[1])
    throw InvalidValue(path + ".axes", linear ? "x and y, of a joint of the plane" : "z, of a joint of the plane",
                       linear          ? "z"
                       : limit.axes[0] ? "x"
                                       : "y");
}
template <class T>
void check_axes(const JointDrive<T>& drive, const plane::Space<T>&, const std::string& path) {
  const bool linear = drive.space == JointSpace::linear;
  if (linear == (drive.axis == 2))
    throw InvalidValue(path + ".axis", linear ? "0 or 1, of a joint of the plane" : "2, of a joint of the plane",
                       std::to_string(drive.axis));
}

}  // namespace

template <class T, class Space>
void check(const Joint<T, Space>& joint) {
  check_frames(joint);
  for (std::size_t i = 0; i < joint.limits.size(); ++i) {
    const std::string path = "joint.limits[" + std::to_string(i) + "]";
    check_limit(joint.limits[i], path);
    check_axes(joint.limits[i], Space{}, path);
  }
  for (std::size_t i = 0; i < joint.drives.size(); ++i) {
    const std::string path = "joint.drives[" + std::to_string(i) + "]";
    check_drive(joint.drives[i], path);
    check_axes(joint.drives[i], Space{}, path);
  }
}

template void check(const Joint<float>&);
template void check(const Joint<double>&);
template void check(const Joint<float, plane::Space<float>>&);
template void check(const Joint<double, plane::Space<double>>&);

}  // namespace graze
