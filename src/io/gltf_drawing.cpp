#include "io/gltf_drawing.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <functional>

namespace graze::io {

namespace {

/// The looks of colliders: alone in the file, or over and beside the meshes that the file shows by itself.
struct ColliderLooks {
  Look still, moving, touching;
};
constexpr ColliderLooks alone{
    {"static", 0.75, 0.78, 0.82, 1}, {"moving", 0.4, 0.55, 0.72, 1}, {"touching", 0.85, 0.35, 0.25, 0.8}};
constexpr ColliderLooks over{
    {"collider", 0.75, 0.78, 0.82, 0.3}, {"collider", 0.75, 0.78, 0.82, 0.3}, {"touching", 0.85, 0.35, 0.25, 0.45}};

constexpr Look contact_look{"contact", 0.75, 0.05, 0.1, 1}, normal_look{"normal", 0.1, 0.2, 0.35, 1},
    path_look{"path", 0.95, 0.6, 0.1, 1}, ghost_look{"ghost", 0.95, 0.6, 0.1, 0.15},
    impact_look{"impact", 0.95, 0.6, 0.1, 0.6}, gap_look{"gap", 0.75, 0.05, 0.1, 1}, a_look{"A", 0.12, 0.44, 0.92, 0.6},
    b_look{"B", 0.85, 0.51, 0.17, 0.6}, asleep_look{"asleep", 0.63, 0.65, 0.68, 1},
    other_look{"bounds", 0.68, 0.71, 0.74, 1}, joint_look{"joint", 0.42, 0.3, 0.58, 1};

const Look& look_of(DrawMeaning meaning, DrawLayer layer, bool kept) {
  const ColliderLooks& looks = kept ? over : alone;
  switch (meaning) {
  case DrawMeaning::a: return a_look;
  case DrawMeaning::b: return b_look;
  case DrawMeaning::fixed: return looks.still;
  case DrawMeaning::moving: return looks.moving;
  case DrawMeaning::touched:
  case DrawMeaning::touching: return layer == DrawLayer::casts ? impact_look : looks.touching;
  case DrawMeaning::asleep: return asleep_look;
  case DrawMeaning::trigger: return trigger_look;
  case DrawMeaning::contact: return contact_look;
  case DrawMeaning::normal: return normal_look;
  case DrawMeaning::gap: return gap_look;
  case DrawMeaning::path: return path_look;
  case DrawMeaning::ghost: return ghost_look;
  case DrawMeaning::joint: return joint_look;
  case DrawMeaning::ruled_out:
  case DrawMeaning::bounds: break;
  }
  return other_look;
}

/// The solid that stands for a point.
Polygons octahedron(double r) {
  const Shaped shape =
      ConvexHull<double>(std::vector<Vec3d>{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}});
  return tessellate(shape, Posed{}, {}, 0);
}

/// Appends the faces of `part`, moved by `by`.
void append_faces(Polygons& whole, const Polygons& part, const Vec3d& by = {}) {
  const auto first = static_cast<std::uint32_t>(whole.points.size());
  for (const Vec3d& p : part.points) whole.points.push_back(p + by);
  for (const auto& loop : part.loops) {
    whole.loops.push_back(loop);
    for (std::uint32_t& v : whole.loops.back()) v += first;
  }
}

/// An arrow from the origin along +Y.
Polygons arrow_up(double length) {
  Polygons whole;
  const auto add = [&](double height, double bottom, double top, double middle) {
    const Shaped solid = Cylinder<double>(height, bottom, top);
    append_faces(whole, tessellate(solid, Posed{{0, middle, 0}, {}}, {}, 0));
  };
  add(length * 0.75, length * 0.03, length * 0.03, length * 0.375);
  add(length * 0.25, length * 0.09, 0, length * 0.875);
  return whole;
}

/// The turn that takes +Y to a unit vector: the quaternion of half of it, as the normalised sum of both.
Quatd turn_to(const Vec3d& direction) {
  if (direction.y < -0.999999) return {1, 0, 0, 0};
  return normalized(Quatd{direction.z, 0, -direction.x, 1 + direction.y});
}

/// The thin solid that stands for a line.
Polygons rod(const Vec3d& from, const Vec3d& to, double radius) {
  const Posed middle{(from + to) * 0.5, turn_to(normalized(to - from))};
  return tessellate(Shaped(Cylinder<double>(length(to - from), radius, radius)), middle, {}, 0);
}

/// The radii of the solids that stand for points and for lines, in parts of the area.
constexpr double dot_radius = 1.0 / 150, rod_radius = 1.0 / 400;

/// Moves a surface outwards, so that it does not flicker against another at the same place.
void lift(Polygons& shape, double distance) {
  std::vector<Vec3d> outward(shape.points.size());
  for (const auto& loop : shape.loops)
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vec3d& corner = shape.points[loop[0]];
      const Vec3d area = cross(shape.points[loop[i]] - corner, shape.points[loop[i + 1]] - corner);
      for (const std::uint32_t v : {loop[0], loop[i], loop[i + 1]}) outward[v] += area;
    }
  for (std::size_t i = 0; i < outward.size(); ++i)
    if (const double size = length(outward[i]); size > 0) shape.points[i] += outward[i] * (distance / size);
}

}  // namespace

void ModelWriter::add(const std::string& name, const Polygons& shape, const Look& look) {
  if (const auto drawn = mesh(name, shape, look)) model_.add_root({{"name", name}, {"mesh", *drawn}});
}

void ModelWriter::place(const std::string& name, std::size_t mesh, const Posed& pose) {
  const auto& t = pose.translation;
  const auto& q = pose.rotation;
  model_.add_root(
      {{"name", name}, {"mesh", mesh}, {"translation", {t.x, t.y, t.z}}, {"rotation", {q.x, q.y, q.z, q.w}}});
}

void ModelWriter::mark(const std::string& name, const Vec3d& at) {
  model_.add_root({{"name", name}, {"translation", {at.x, at.y, at.z}}});
}

void thicken(Polygons& shape, double size) {
  const auto thin = [](const std::vector<std::uint32_t>& loop) { return loop.size() < 3; };
  const auto middle = std::stable_partition(shape.loops.begin(), shape.loops.end(), std::not_fn(thin));
  const std::vector<std::vector<std::uint32_t>> loops(middle, shape.loops.end());
  shape.loops.erase(middle, shape.loops.end());
  for (const auto& loop : loops) {
    const Vec3d from = shape.points[loop.front()], to = shape.points[loop.back()];
    if (from == to)
      append_faces(shape, octahedron(size * dot_radius), from);
    else
      append_faces(shape, rod(from, to, size * rod_radius));
  }
}

std::optional<std::size_t> ModelWriter::mesh(const std::string& name, const Polygons& shape, const Look& look) {
  std::vector<Vec3d> corners;
  for (const auto& loop : shape.loops)
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      for (const std::uint32_t v : {loop[0], loop[i], loop[i + 1]}) corners.push_back(shape.points[v]);
  if (corners.empty()) return std::nullopt;
  const Json primitive{{"attributes", {{"POSITION", positions(corners)}}}, {"material", material(look)}};
  return model_.add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
}

/// The material of a look, made when first used: a file gets no materials that nothing has.
std::size_t ModelWriter::material(const Look& look) {
  const auto found = materials_.find(look.name);
  if (found != materials_.end()) return found->second;
  Json json{
      {"name", look.name},
      {"doubleSided", true},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {look.r, look.g, look.b, look.alpha}}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}};
  if (look.alpha < 1) json["alphaMode"] = "BLEND";
  return materials_[look.name] = model_.add("materials", json);
}

std::size_t ModelWriter::positions(const std::vector<Vec3d>& points) {
  std::vector<unsigned char> bytes(points.size() * 12);
  Aabbd box = Aabbd::empty();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float v[3] = {static_cast<float>(points[i].x), static_cast<float>(points[i].y),
                        static_cast<float>(points[i].z)};
    std::memcpy(bytes.data() + i * 12, v, 12);
    box = merged(box, converted<double>(Vec3f{v[0], v[1], v[2]}));
  }
  constexpr int array_buffer = 34962, float_component = 5126;
  return model_.add("accessors", {{"bufferView", model_.add_view(bytes, array_buffer)},
                                  {"componentType", float_component},
                                  {"count", points.size()},
                                  {"type", "VEC3"},
                                  {"min", {box.lower.x, box.lower.y, box.lower.z}},
                                  {"max", {box.upper.x, box.upper.y, box.upper.z}}});
}

const Look& collider_look(bool kept, bool fixed) {
  const ColliderLooks& looks = kept ? over : alone;
  return fixed ? looks.still : looks.moving;
}

/// Places one mesh for all shapes that look alike; none in a scene without extent, where nothing would be seen.
void GltfDraw::place(const Polygons& shape, const Look& look, const Posed& pose) {
  const auto [at, made] = meshes_.try_emplace(look.name);
  if (made) at->second = writer_.mesh(look.name, shape, look);
  if (at->second) writer_.place(look.name, *at->second, pose);
}

void GltfDraw::point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) {
  place(octahedron(area().size * dot_radius), look_of(meaning, layer, kept_), {at, {}});
}

void GltfDraw::arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) {
  place(arrow_up(area().size / 12), look_of(meaning, layer, kept_), {from, turn_to(direction)});
}

/// Draws a line as a thin rod.
void GltfDraw::line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) {
  if (!(length(to - from) > 0)) return;
  const Look& look = look_of(meaning, layer, kept_);
  writer_.add(look.name, rod(from, to, area().size * rod_radius), look);
}

void GltfDraw::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) {
  polygons({{a, b, c}, {{0, 1, 2}}, false, false}, layer, meaning);
}

void GltfDraw::text(const Vec3d& at, std::string_view words, DrawLayer, DrawMeaning) {
  writer_.mark(std::string(words), at);
}

void GltfDraw::polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) {
  const Look& look = look_of(meaning, layer, kept_);
  Polygons solid = shape;
  thicken(solid, area().size);
  writer_.add(layer == DrawLayer::casts ? look.name : name_, solid, look);
}

Aabbd extent(const Scene& scene) {
  Aabbd all = Aabbd::empty();
  for (const Collider& c : scene.colliders)
    if (const Aabbd box = bounds(c.shape, c.pose); max_abs(box.extent()) < 1e300) all = merged(all, box);
  return all.lower.x <= all.upper.x ? all : Aabbd{{-1, -1, -1}, {1, 1, 1}};
}

bool is_gltf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".glb" || ending == ".gltf";
}

/// Draws colliders. One that shows a mesh of its own is drawn over only where it is tinted.
void draw_colliders(GltfDraw& canvas, const GltfModel& model, const Scene& scene,
                    const std::set<std::uint32_t>& touching, bool kept) {
  const double lifted = kept ? canvas.area().size / 1000 : 0;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    const bool fixed = scene.bodies[c.body].type == MotionType::fixed, tinted = !c.trigger && touching.count(i) != 0;
    if (!tinted && model.has_mesh(c.node)) continue;
    Polygons shape = tessellate(c.shape, c.pose, canvas.area().center, canvas.area().size);
    if (lifted > 0) lift(shape, lifted);
    canvas.name(c.name);
    canvas.polygons(shape, DrawLayer::shapes,
                    c.trigger ? DrawMeaning::trigger
                    : tinted  ? DrawMeaning::touching
                    : fixed   ? DrawMeaning::fixed
                              : DrawMeaning::moving);
  }
}

}  // namespace graze::io
