// A simulation of the plane: `graze::Simulation` (`graze/simulation.hpp`) with bodies of two dimensions.
//
// Guarantee: that of `graze::Simulation`, whose code it is, over the trait of this space: the same bits for any
// executor and after `restore`, no length, speed or time built in, and nothing changed by a call that throws. The
// documentation there of masses, materials, joints, sleep, continuous collision and reports holds here, with the types
// of the plane. Free bodies fall and turn exactly up to rounding.
//
//     graze::plane::Simulation<float> simulation;
//     graze::plane::Body<float> ground{graze::plane::HalfPlane<float>()};
//     ground.fixed = true;
//     simulation.add(ground);
//     const graze::BodyId crate = simulation.add({graze::plane::Box<float>({1, 1}), {{0, 3}, {}}});
//     simulation.step(1 / 60.0f);
#pragma once

#include "graze/plane/joint.hpp"
#include "graze/plane/rigid.hpp"
#include "graze/plane/world.hpp"
#include "graze/simulation.hpp"

namespace graze::plane {

/// Settings of a simulation of the plane. Gravity is (0, -9.81) by default.
template <class T>
using SimulationSettings = graze::SimulationSettings<T, Space<T>>;
/// The material of a surface. The velocity of a conveyor's surface is a vector in the body's frame, of which the part
/// along the surface counts.
template <class T>
using Material = graze::Material<T, Vec2<T>>;
template <class T>
using StepReport = graze::StepReport<T, Space<T>>;
template <class T>
using State = graze::State<T, Space<T>>;
template <class T>
using Simulation = graze::Simulation<T, Space<T>>;

using Simulationf = Simulation<float>;
using Simulationd = Simulation<double>;

}  // namespace graze::plane
