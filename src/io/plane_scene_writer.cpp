// Scenes of the plane as JSON.
#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"
#include "io/json_value.hpp"
#include "io/shape_writer.hpp"

namespace graze::io {

namespace {

using plane::Vec2d;

JsonWriter& put(JsonWriter& out, const Vec2d& v) { return out.open('[').number(v.x).number(v.y).close(']'); }

/// Writes the motion of a body, without values that are the default.
void write_motion(JsonWriter& out, const PlaneSceneBody& body) {
  const PlaneMotion &motion = body.motion, usual;
  if (body.type != MotionType::fixed)
    out.key("motion").raw(body.type == MotionType::dynamic ? "\"dynamic\"" : "\"kinematic\"");
  if (!(motion.linear == usual.linear)) put(out.key("linear"), motion.linear);
  const auto number = [&](const char* name, double value, double otherwise) {
    if (value != otherwise) out.key(name).number(value);
  };
  number("angular", motion.angular, usual.angular);
  if (motion.mass) out.key("mass").number(*motion.mass);
  if (motion.inertia) out.key("inertia").number(*motion.inertia);
  number("gravityFactor", motion.gravity_factor, usual.gravity_factor);
  number("friction", motion.friction, usual.friction);
  number("restitution", motion.restitution, usual.restitution);
}

/// Writes the names behind the bits of a filter. The last bit is that of colliders that belong to no system.
void write_filter(JsonWriter& out, const Filter& filter, const std::vector<std::string>& systems) {
  constexpr std::uint64_t no_system = std::uint64_t(1) << 63;
  const auto names = [&](const char* key, std::uint64_t bits) {
    out.key(key).open('[');
    for (std::size_t i = 0; i < systems.size(); ++i)
      if (bits >> i & 1) out.raw(json_quoted(systems[i]));
    out.close(']');
  };
  if (filter.category != no_system) names("systems", filter.category);
  if (filter.mask & no_system) {
    if (~filter.mask != 0) names("notCollideWith", ~filter.mask);
  } else {
    names("collideWith", filter.mask);
  }
}

}  // namespace

std::string to_json(const PlaneScene& scene) {
  std::vector<std::size_t> colliders(scene.bodies.size());
  for (const PlaneCollider& c : scene.colliders) ++colliders[c.body];
  JsonWriter out;
  out.open('{').key("dimension").raw("2");
  if (scene.gravity) put(out.key("gravity"), *scene.gravity);
  out.key("bodies").open('[');
  for (const PlaneCollider& c : scene.colliders) {
    const PlaneSceneBody& body = scene.bodies[c.body];
    write_shape(out.open('{').key("name").raw(json_quoted(c.name)).key("shape"), c.shape);
    write_pose(out, c.pose);
    if (colliders[c.body] > 1 || body.name != c.name) out.key("body").raw(json_quoted(body.name));
    write_motion(out, body);
    if (c.trigger) out.key("trigger").value(true);
    write_filter(out, c.filter, scene.collision_systems);
    out.close('}');
  }
  return out.close(']').close('}').take();
}

}  // namespace graze::io
