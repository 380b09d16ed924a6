#include "graze/io/plane_scene.hpp"

#include "io/plane_question.hpp"
#include "io/plane_scene_parts.hpp"
#include "io/scene_file.hpp"
#include "io/svg_scene.hpp"

namespace graze::io {

namespace {

/// The largest size of a drawing that is read: it has more shapes than anybody draws.
constexpr std::size_t largest_file = std::size_t(1) << 28;

std::vector<std::string> read_names(const JsonValue& json) {
  std::vector<std::string> out;
  for (const JsonValue& name : json.elements()) out.push_back(name.string());
  return out;
}

plane::Vec2d read_vector(const JsonValue& json) {
  const Vec3d v = json.plane_vector<double>();
  return {v.x, v.y};
}

PlaneMotion read_physics(const JsonValue& json) {
  PlaneMotion motion;
  if (const auto v = json.find("linear")) motion.linear = read_vector(*v);
  if (const auto v = json.find("angular")) motion.angular = v->number<double>();
  if (const auto v = json.find("mass")) motion.mass = v->number<double>();
  if (const auto v = json.find("inertia")) motion.inertia = v->number<double>();
  if (const auto v = json.find("gravityFactor")) motion.gravity_factor = v->number<double>();
  if (const auto v = json.find("friction")) motion.friction = v->number<double>();
  if (const auto v = json.find("restitution")) motion.restitution = v->number<double>();
  return motion;
}

PlaneSceneBuilder::Role read_role(const JsonValue& json) {
  PlaneSceneBuilder::Role role;
  role.physics = read_physics(json);
  if (const auto b = json.find("body")) role.body = b->string();
  if (const auto m = json.find("motion")) {
    const auto motion = motion_named(m->json().is_string() ? m->string() : "");
    if (!motion) m->fail("one of static, kinematic, dynamic");
    role.motion = *motion;
  }
  if (const auto t = json.find("trigger")) role.trigger = t->boolean();
  if (const auto s = json.find("systems")) role.systems = read_names(*s);
  if (const auto s = json.find("collideWith")) role.collide_with = read_names(*s);
  if (const auto s = json.find("notCollideWith")) role.not_collide_with = read_names(*s);
  if (json.has("collideWith") && json.has("notCollideWith")) json.at("notCollideWith").fail("none beside collideWith");
  return role;
}

void read_collider(const JsonValue& json, std::size_t number, PlaneSceneBuilder& scene) {
  json.keys({"name", "shape", "translation", "rotation", "body", "motion", "trigger", "systems", "collideWith",
             "notCollideWith", "linear", "angular", "mass", "inertia", "gravityFactor", "friction", "restitution"});
  std::string name = "collider " + std::to_string(number);
  if (const auto n = json.find("name")) name = n->string();
  plane::Pose2d pose;
  if (const auto v = json.find("translation")) pose.translation = read_vector(*v);
  if (const auto r = json.find("rotation")) pose.rotation = plane::Rot2d::from_angle(r->number<double>());
  scene.add(std::move(name), read_role(json), read_plane_shape<double>(json.at("shape")), pose);
}

}  // namespace

std::optional<MotionType> motion_named(std::string_view name) {
  if (name == "static") return MotionType::fixed;
  if (name == "kinematic") return MotionType::kinematic;
  if (name == "dynamic") return MotionType::dynamic;
  return {};
}

std::uint32_t PlaneSceneBuilder::body_of(const std::string& name, const Role& role) {
  const auto next = static_cast<std::uint32_t>(scene_.bodies.size());
  if (!role.body.empty()) {
    const auto [found, made] = bodies_.emplace(role.body, next);
    if (!made) {
      if (scene_.bodies[found->second].type != role.motion)
        throw InvalidValue("", "one motion of all that belongs to body " + role.body, "two");
      if (!(scene_.bodies[found->second].motion == role.physics))
        throw InvalidValue("", "one mass, velocity and material of all that belongs to body " + role.body, "two");
      return found->second;
    }
  }
  scene_.bodies.push_back({role.body.empty() ? name : role.body, role.motion, role.physics});
  return next;
}

std::uint64_t PlaneSceneBuilder::bits_of(const std::vector<std::string>& names) {
  std::uint64_t bits = 0;
  for (const std::string& name : names) {
    const auto [found, made] = systems_.emplace(name, static_cast<std::uint32_t>(systems_.size()));
    if (found->second >= 63) throw InvalidValue("", "at most 63 collision systems in all", "more");
    if (made) scene_.collision_systems.push_back(name);
    bits |= std::uint64_t(1) << found->second;
  }
  return bits;
}

std::uint32_t PlaneSceneBuilder::add(std::string name, const Role& role, plane::Shaped shape, const plane::Pose2d& pose,
                                     std::optional<std::uint32_t> body) {
  PlaneCollider collider{std::move(name), 0, std::move(shape), pose, {}, role.trigger};
  collider.body = body ? *body : body_of(collider.name, role);
  // A collider that belongs to no system has the last bit.
  collider.filter.category = role.systems.empty() ? std::uint64_t(1) << 63 : bits_of(role.systems);
  if (!role.collide_with.empty()) collider.filter.mask = bits_of(role.collide_with);
  if (!role.not_collide_with.empty()) collider.filter.mask = ~bits_of(role.not_collide_with);
  collider.filter.group = -1 - static_cast<std::int32_t>(collider.body);
  scene_.colliders.push_back(std::move(collider));
  return scene_.colliders.back().body;
}

bool is_plane_scene(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  return ending == "svg" || ending == "json";
}

PlaneScene load_plane_svg(const std::string& bytes, const std::string& source_name) {
  XmlElement root;
  try {
    root = read_xml(bytes);
  } catch (const InvalidValue& e) {
    throw InvalidValue(source_name + ": " + e.path(), e.expectation(), e.found());
  }
  return read_svg(root, source_name);
}

PlaneScene load_plane_json(const std::string& bytes, const std::string& source_name) {
  try {
    const Json json = parse_json(bytes);
    const JsonValue root(json, "");
    if (!json.is_object()) root.fail("one JSON object");
    root.keys({"dimension", "gravity", "bodies"});
    if (root.at("dimension").json() != 2) root.at("dimension").fail("2");
    PlaneSceneBuilder scene(source_name);
    if (const auto gravity = root.find("gravity")) scene.set_gravity(read_vector(*gravity));
    std::size_t number = 0;
    for (const JsonValue& body : root.at("bodies").elements()) {
      try {
        read_collider(body, number++, scene);
      } catch (const InvalidValue& e) {
        if (!e.path().empty()) throw;
        throw e.below(body.path());
      }
    }
    return scene.take();
  } catch (const InvalidValue& e) {
    throw InvalidValue(e.path().empty() ? source_name : source_name + ": " + e.path(), e.expectation(), e.found());
  }
}

PlaneScene load_plane_scene(const std::filesystem::path& file) {
  std::error_code failed;
  if (std::filesystem::is_regular_file(file, failed) && std::filesystem::file_size(file, failed) > largest_file)
    throw InvalidValue(file.string(), "a file of at most 256 MiB", "a larger one");
  const std::string bytes = read_file(file), name = file.filename().string(), ending = ending_of(file);
  if (ending == "svg") return load_plane_svg(bytes, name);
  if (ending == "json") return load_plane_json(bytes, name);
  throw InvalidValue(file.string(), "a file that ends in .svg or .json", "\"." + ending + "\"");
}

}  // namespace graze::io
