#include "io/body_distribution.hpp"

#include <cmath>

#include "dynamics/body_mass.hpp"

namespace graze::io {

namespace {

/// The inertia that a mass at `arm` from the centre adds (Steiner's parallel axis theorem).
Mat3d at_arm(double mass, const Vec3d& arm) {
  const double square = length_squared(arm);
  Mat3d inertia;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) inertia.row[i][j] = mass * ((i == j ? square : 0) - arm[i] * arm[j]);
  return inertia;
}

Mat3d sum(const Mat3d& a, const Mat3d& b) { return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}}; }

Vec3d box_inertia(double mass, const Vec3d& size) {
  const Vec3d s{size.x * size.x, size.y * size.y, size.z * size.z};
  return Vec3d{s.y + s.z, s.z + s.x, s.x + s.y} * (mass / 12);
}

/// The inertia of a ball of water, for a body with a mass and no shape.
double ball_inertia(double mass) {
  const double radius = std::cbrt(0.75 * mass / (1000 * 3.14159265358979324));
  return 0.4 * mass * radius * radius;
}

/// Volume, centre and inertia of all colliders together, in the frame of the body; and the box around them.
struct Colliders {
  MassProperties<double> properties{};
  Aabbd box = Aabbd::empty();
  bool any = false;
};

Colliders colliders_of(const Scene& scene, std::uint32_t body) {
  Colliders all;
  const Posed& frame = scene.bodies[body].pose;
  std::vector<std::pair<MassProperties<double>, Posed>> parts;
  for (const Collider& c : scene.colliders) {
    if (c.body != body || c.trigger) continue;
    const Posed at = relative(frame, c.pose);
    parts.emplace_back(mass_properties(c.shape), at);
    all.box = all.any ? merged(all.box, bounds(c.shape, at)) : bounds(c.shape, at);
    all.any = true;
    all.properties.volume += parts.back().first.volume;
    all.properties.center += transform(at, parts.back().first.center) * parts.back().first.volume;
  }
  if (!(all.properties.volume > 0)) return all;
  all.properties.center = all.properties.center / all.properties.volume;
  for (const auto& [p, at] : parts) {
    const Mat3d r = rotation_matrix(at.rotation);
    const Mat3d turned = r * p.inertia * transposed(r);
    all.properties.inertia =
        sum(all.properties.inertia, sum(turned, at_arm(p.volume, transform(at, p.center) - all.properties.center)));
  }
  return all;
}

}  // namespace

Dynamics<double> distribution_of(const Scene& scene, std::uint32_t body) {
  const BodyMotion& motion = *scene.bodies[body].motion;
  Dynamics<double> d;
  d.kinematic = motion.kinematic;
  d.gravity_factor = motion.gravity_factor;
  const Colliders all = colliders_of(scene, body);
  const bool solid = all.properties.volume > 0;
  d.center_of_mass = motion.center_of_mass.value_or(solid     ? all.properties.center
                                                    : all.any ? (all.box.lower + all.box.upper) / 2.0
                                                              : Vec3d{});
  if (motion.kinematic) return d;
  if (!motion.mass && !solid) throw InvalidValue("motion.mass", "a value, of a body without volume", "nothing");
  const double mass = motion.mass ? *motion.mass : d.density * all.properties.volume;
  d.mass = mass;
  if (motion.inertia_diagonal) {
    d.inertia_diagonal = motion.inertia_diagonal;
    d.inertia_orientation = motion.inertia_orientation;
  } else if (!std::isfinite(mass)) {
    d.inertia_diagonal = Vec3d{mass, mass, mass};
  } else if (solid) {
    const auto axes = principal_axes(all.properties.inertia * (mass / all.properties.volume));
    d.inertia_diagonal = axes.diagonal;
    d.inertia_orientation = axes.rotation;
  } else {
    const double ball = ball_inertia(mass);
    d.inertia_diagonal = all.any ? box_inertia(mass, all.box.upper - all.box.lower) : Vec3d{ball, ball, ball};
  }
  return d;
}

}  // namespace graze::io
