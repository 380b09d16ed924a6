// KHR_physics_rigid_bodies: materials, motions and joints as a solver needs them.
//
// Guarantee: all numbers are finite and in range: masses and moments of inertia above zero, or infinite where the file
// has zero; moments that some body can have; frictions, restitutions, stiffnesses and dampings of at least zero; limits
// of one to three different axes whose least is not above the greatest. All else raises `InvalidValue` with the place
// in the file, the expected and the found value. Values that a file leaves out are not made up.
#pragma once

#include "graze/io/scene.hpp"
#include "io/affine.hpp"
#include "io/json_value.hpp"

namespace graze::io {

/// An element of `physicsMaterials`.
Material read_physics_material(const JsonValue& json);

/// A node's `motion`, all of it in the node's own space.
BodyMotion read_motion(const JsonValue& json);

/// The motion of a node as that of its body: `map` is the node's to the world, and `rotation` the body's. The
/// velocities are those in the world. Positions are scaled with the node; velocities are of metres and radians a second
/// along its axes, which a negative scale turns around.
BodyMotion in_body_frame(BodyMotion motion, const Affine& map, const Quatd& rotation);

/// The limits and drives of an element of `physicsJoints`.
struct JointDescription {
  std::vector<JointLimit> limits;
  std::vector<JointDrive> drives;
};
JointDescription read_joint_description(const JsonValue& json);

}  // namespace graze::io
