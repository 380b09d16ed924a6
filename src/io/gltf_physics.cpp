#include "io/gltf_physics.hpp"

#include "io/gltf_node.hpp"

namespace graze::io {

namespace {

void read_if_there(const JsonValue& json, const char* key, double& value) {
  if (const auto v = json.find(key)) value = v->number<double>();
}
void read_positive_if_there(const JsonValue& json, const char* key, double& value) {
  if (const auto v = json.find(key)) value = v->length<double>();
}

/// Infinity for zero: JSON has no word for it, and the extension writes it so (section "Motions").
double infinite_if_zero(double value) { return value > 0 ? value : std::numeric_limits<double>::infinity(); }

Combine read_combine(const JsonValue& json) {
  const std::string name = json.string();
  if (name == "average") return Combine::average;
  if (name == "minimum") return Combine::minimum;
  if (name == "maximum") return Combine::maximum;
  if (name == "multiply") return Combine::multiply;
  json.fail("one of average, minimum, maximum, multiply");
}

/// Reads moments of inertia. No mass distribution has a moment above the sum of the two others: each is the sum of two
/// of three non-negative integrals. The numbers of files are rounded.
Vec3d read_inertia(const JsonValue& json) {
  Vec3d moments = json.lengths<double>();
  for (std::size_t i = 0; i < 3; ++i) moments[i] = infinite_if_zero(moments[i]);
  const bool finite = std::isfinite(moments.x) && std::isfinite(moments.y) && std::isfinite(moments.z);
  for (std::size_t i = 0; i < 3 && finite; ++i)
    if (moments[i] * (1 - file_precision) > moments[(i + 1) % 3] + moments[(i + 2) % 3])
      json.elements()[i].fail("a moment of inertia that is at most the sum of the two others, " +
                              validate::number(moments[(i + 1) % 3] + moments[(i + 2) % 3]));
  return moments;
}

/// One to three different axes.
std::array<bool, 3> read_axes(const JsonValue& json) {
  std::array<bool, 3> axes{};
  const auto list = json.elements();
  if (list.empty()) json.fail("one to three axes, each 0, 1 or 2");
  for (const JsonValue& axis : list) {
    const std::size_t i = axis.index_below(3);
    if (axes[i]) axis.fail("an axis that is not named twice");
    axes[i] = true;
  }
  return axes;
}

JointLimit read_limit(const JsonValue& json) {
  JointLimit limit;
  const auto linear = json.find("linearAxes"), angular = json.find("angularAxes");
  if (linear.has_value() == angular.has_value())
    throw InvalidValue(json.path(), "either linearAxes or angularAxes", linear ? "both" : "neither");
  limit.angular = angular.has_value();
  limit.axes = read_axes(limit.angular ? *angular : *linear);
  read_if_there(json, "min", limit.min);
  read_if_there(json, "max", limit.max);
  if (limit.min > limit.max) json.at("min").fail("at most the limit's max, " + validate::number(limit.max));
  // A limit with several axes is one of a distance, or of an angle without a sign, which is never below zero.
  const bool several = limit.axes[0] + limit.axes[1] + limit.axes[2] > 1;
  if (several && limit.max < 0) json.at("max").fail("at least 0 of a limit with several axes");
  if (const auto v = json.find("stiffness")) limit.stiffness = v->length<double>();
  read_positive_if_there(json, "damping", limit.damping);
  return limit;
}

JointDrive read_drive(const JsonValue& json) {
  JointDrive drive;
  const JsonValue type = json.at("type"), mode = json.at("mode");
  if (type.string() != "linear" && type.string() != "angular") type.fail("linear or angular");
  if (mode.string() != "force" && mode.string() != "acceleration") mode.fail("force or acceleration");
  drive.angular = type.string() == "angular";
  drive.acceleration = mode.string() == "acceleration";
  drive.axis = static_cast<std::uint8_t>(json.at("axis").index_below(3));
  // Writers give "without limit" as the largest float.
  if (const auto v = json.find("maxForce")) drive.max_force = v->positive_or_zero<double>();
  read_if_there(json, "positionTarget", drive.position_target);
  read_if_there(json, "velocityTarget", drive.velocity_target);
  read_positive_if_there(json, "stiffness", drive.stiffness);
  read_positive_if_there(json, "damping", drive.damping);
  return drive;
}

}  // namespace

Material read_physics_material(const JsonValue& json) {
  Material material;
  read_positive_if_there(json, "staticFriction", material.static_friction);
  read_positive_if_there(json, "dynamicFriction", material.dynamic_friction);
  if (const auto v = json.find("restitution")) {
    material.restitution = v->positive_or_zero<double>();
    if (material.restitution > 1) v->fail("a number from 0 to 1");  // as the schema has it; a simulation takes no other
  }
  if (const auto v = json.find("frictionCombine")) material.friction_combine = read_combine(*v);
  if (const auto v = json.find("restitutionCombine")) material.restitution_combine = read_combine(*v);
  return material;
}

BodyMotion read_motion(const JsonValue& json) {
  BodyMotion m;
  if (const auto v = json.find("isKinematic")) m.kinematic = v->boolean();
  if (const auto v = json.find("mass")) m.mass = infinite_if_zero(v->length<double>());
  if (const auto v = json.find("centerOfMass")) m.center_of_mass = v->vector<double>();
  if (const auto v = json.find("inertiaDiagonal")) m.inertia_diagonal = read_inertia(*v);
  if (const auto v = json.find("inertiaOrientation")) m.inertia_orientation = read_quaternion(*v);
  m.linear_velocity = vector_or(json, "linearVelocity", {});
  m.angular_velocity = vector_or(json, "angularVelocity", {});
  read_if_there(json, "gravityFactor", m.gravity_factor);
  return m;
}

BodyMotion in_body_frame(BodyMotion motion, const Affine& map, const Quatd& rotation) {
  if (motion.center_of_mass) motion.center_of_mass = rotate(conjugate(rotation), map.linear * *motion.center_of_mass);
  motion.linear_velocity = rotate(rotation, scaled(map.signs, motion.linear_velocity));
  motion.angular_velocity = rotate(rotation, scaled(map.signs, motion.angular_velocity));
  // A turn R seen from the other side of the signs D is D R D, whose axis is D's times its determinant.
  Quatd& turn = motion.inertia_orientation;
  const Vec3d& d = map.signs;
  turn = {d.y * d.z * turn.x, d.z * d.x * turn.y, d.x * d.y * turn.z, turn.w};
  return motion;
}

JointDescription read_joint_description(const JsonValue& json) {
  JointDescription description;
  if (const auto limits = json.find("limits"))
    for (const JsonValue& limit : limits->elements()) description.limits.push_back(read_limit(limit));
  if (const auto drives = json.find("drives"))
    for (const JsonValue& drive : drives->elements()) description.drives.push_back(read_drive(drive));
  return description;
}

}  // namespace graze::io
