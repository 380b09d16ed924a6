// What a scene's file says of motion: bodies and joints by the names of `Simulation.add` and `Simulation.join`.
#pragma once

#include "scene_text.hpp"

#include "graze/joint.hpp"

#include <pybind11/stl.h>

namespace graze::python {

/// The motion of a body by name, or None for one that is fixed.
inline py::object object_of(const std::optional<io::BodyMotion>& motion) {
  if (!motion) return py::none();
  py::dict out;
  out["kinematic"] = motion->kinematic;
  out["mass"] = motion->mass;
  out["center_of_mass"] = motion->center_of_mass ? py::object(array_of(*motion->center_of_mass)) : py::none();
  out["inertia"] =
      motion->inertia_diagonal
          ? py::object(py::make_tuple(tuple_of(*motion->inertia_diagonal), tuple_of(motion->inertia_orientation)))
          : py::none();
  out["linear_velocity"] = array_of(motion->linear_velocity);
  out["angular_velocity"] = array_of(motion->angular_velocity);
  out["gravity_factor"] = motion->gravity_factor;
  return out;
}

inline JointSpace space_of(bool angular) { return angular ? JointSpace::angular : JointSpace::linear; }

/// A joint by name.
inline py::dict object_of(const io::Joint& joint) {
  py::list limits, drives;
  for (const io::JointLimit& l : joint.limits)
    limits.append(JointLimit<double>{space_of(l.angular), l.axes, l.min, l.max, l.stiffness, l.damping});
  for (const io::JointDrive& d : joint.drives) {
    const DriveMode mode = d.acceleration ? DriveMode::acceleration : DriveMode::force;
    drives.append(JointDrive<double>{space_of(d.angular), mode, d.axis, d.position_target, d.velocity_target,
                                     d.stiffness, d.damping, d.max_force});
  }
  py::dict out;
  out["name"] = file_text(joint.name);
  out["a"] = joint.body_a;
  out["frame_a"] = joint.frame_a;
  out["b"] = joint.body_b;
  out["frame_b"] = joint.frame_b;
  out["limits"] = limits;
  out["drives"] = drives;
  out["enable_collision"] = joint.enable_collision;
  return out;
}

}  // namespace graze::python
