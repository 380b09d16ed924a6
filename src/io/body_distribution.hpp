// The distribution of mass of a scene's body.
#pragma once

#include "graze/dynamics.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// The mass, centre and inertia of a moving body in its own frame, complete: values that the file leaves out follow
/// from the colliders, filled evenly. A body without volume is spread like the box around it, one without colliders
/// like a ball. A density where no mass is given is `Dynamics`' own. Throws `InvalidValue` for a body without volume or
/// mass.
Dynamics<double> distribution_of(const Scene& scene, std::uint32_t body);

}  // namespace graze::io
