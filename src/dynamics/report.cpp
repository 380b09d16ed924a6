// Measurements of a simulation from outside.
#include "dynamics/simulation_parts.hpp"

namespace graze {

template <class T, class Space>
StepReport<T, Space> Simulation<T, Space>::report() const {
  const SimulationParts<T, Space>& p = *parts_;
  StepReport<T, Space> r = p.last;
  const auto alive = p.world.bodies().alive();
  for (std::uint32_t i = 0; i < p.bodies.size(); ++i) {
    const SimulatedBody<T, Space>& body = p.bodies[i];
    if (alive[i] == 0 || !body.movable) continue;
    const T mass = body.mass.mass;
    r.kinetic_energy += mass * length_squared(body.free.linear) / T(2) + rotational_energy(body.free);
    r.potential_energy -= mass * body.gravity_factor * dot(p.settings.gravity, body.free.center);
    r.momentum += body.free.linear * mass;
    r.angular_momentum += cross(body.free.center, body.free.linear) * mass + body.free.angular_momentum;
  }
  std::size_t deep = 0;
  for (const SolverPoint<T, Space>& point : p.world.contacts().points) {
    if (!(point.distance < T(0))) continue;
    r.deepest = greatest(r.deepest, -point.distance);
    r.mean_depth -= point.distance;
    ++deep;
  }
  if (deep != 0) r.mean_depth /= T(deep);
  return r;
}

#define GRAZE_REPORT(T, Space) template StepReport<T, Space> Simulation<T, Space>::report() const;
GRAZE_REPORT(float, Space<float>)
GRAZE_REPORT(double, Space<double>)
GRAZE_REPORT(float, plane::Space<float>)
GRAZE_REPORT(double, plane::Space<double>)
#undef GRAZE_REPORT

}  // namespace graze
