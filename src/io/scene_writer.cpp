#include "graze/io/scene_writer.hpp"

#include <tiny_gltf.h>

#include <cstring>
#include <set>

#include "graze/io/tessellate.hpp"

namespace graze::io {

namespace {

class Writer {
 public:
  Writer() {
    model_.asset.version = "2.0";
    model_.asset.generator = "graze";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  int material(const char* name, double r, double g, double b, double alpha) {
    tinygltf::Material m;
    m.name = name;
    m.pbrMetallicRoughness.baseColorFactor = {r, g, b, alpha};
    m.pbrMetallicRoughness.metallicFactor = 0;
    m.pbrMetallicRoughness.roughnessFactor = 0.8;
    m.doubleSided = true;
    if (alpha < 1) m.alphaMode = "BLEND";
    model_.materials.push_back(m);
    return static_cast<int>(model_.materials.size()) - 1;
  }

  /// One node with one mesh, its polygons as triangles with corners of their own, so that faces look flat.
  void add(const std::string& name, const Polygons& shape, int material) {
    std::vector<Vec3d> corners;
    for (const auto& loop : shape.loops)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        for (const std::uint32_t v : {loop[0], loop[i], loop[i + 1]}) corners.push_back(shape.points[v]);
    if (corners.empty()) return;
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = material;
    primitive.attributes["POSITION"] = positions(corners);
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(primitive);
    model_.meshes.push_back(mesh);
    tinygltf::Node node;
    node.name = name;
    node.mesh = static_cast<int>(model_.meshes.size()) - 1;
    model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(node);
  }

  void save(const std::filesystem::path& file) {
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToFile(&model_, file.string(), true, true, false, true))
      throw InvalidValue(file.string(), "a file that can be written", "an error");
  }

 private:
  int positions(const std::vector<Vec3d>& points) {
    auto& data = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = points.size() * 12;
    view.target = TINYGLTF_TARGET_ARRAY_BUFFER;
    Aabbd box = Aabbd::empty();
    data.resize(data.size() + view.byteLength);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float v[3] = {static_cast<float>(points[i].x), static_cast<float>(points[i].y),
                          static_cast<float>(points[i].z)};
      std::memcpy(data.data() + view.byteOffset + i * 12, v, 12);
      box = merged(box, cast<double>(Vec3f{v[0], v[1], v[2]}));
    }
    model_.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.count = points.size();
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.minValues = {box.lower.x, box.lower.y, box.lower.z};
    accessor.maxValues = {box.upper.x, box.upper.y, box.upper.z};
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  tinygltf::Model model_;
};

Polygons octahedron(const Vec3d& center, double r) {
  const Shaped shape =
      ConvexHull<double>(std::vector<Vec3d>{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}});
  return tessellate(shape, {center, {}}, {}, 0);
}

/// The turn that takes +Y to a unit vector: half of it, added and normalised.
Quatd turn_to(const Vec3d& direction) {
  if (direction.y < -0.999999) return {1, 0, 0, 0};
  return normalized(Quatd{direction.z, 0, -direction.x, 1 + direction.y});
}

void add_arrow(Writer& writer, const Vec3d& from, const Vec3d& direction, double length, int material) {
  const Quatd turn = turn_to(direction);
  const auto part = [&](double height, double bottom, double top, double middle) {
    const Posed pose{from + direction * middle, turn};
    writer.add("normal", tessellate(Cylinder<double>(height, bottom, top), pose, {}, 0), material);
  };
  part(length * 0.75, length * 0.03, length * 0.03, length * 0.375);
  part(length * 0.25, length * 0.09, 0, length * 0.875);
}

}  // namespace

void write_contacts(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs) {
  Aabbd all = Aabbd::empty();
  for (const Collider& c : scene.colliders)
    if (const Aabbd box = bounds(c.shape, c.pose); max_abs(box.extent()) < 1e300) all = merged(all, box);
  if (!(all.lower.x <= all.upper.x)) all = {{-1, -1, -1}, {1, 1, 1}};
  const double size = max_abs(all.extent());

  Writer writer;
  const int still = writer.material("static", 0.75, 0.78, 0.82, 1),
            moving = writer.material("moving", 0.4, 0.55, 0.72, 1),
            touching = writer.material("touching", 0.85, 0.35, 0.25, 0.8),
            trigger = writer.material("trigger", 0.4, 0.7, 0.5, 0.3),
            dot = writer.material("contact", 0.75, 0.05, 0.1, 1), arrow = writer.material("normal", 0.1, 0.2, 0.35, 1);
  std::set<std::uint32_t> touched;
  for (const TouchingPair& p : pairs)
    if (p.overlap && !p.trigger) touched.insert({p.a, p.b});
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    const bool fixed = scene.bodies[c.body].type == MotionType::fixed;
    const int look = c.trigger ? trigger : touched.count(i) != 0 && !fixed ? touching : fixed ? still : moving;
    writer.add(c.name, tessellate(c.shape, c.pose, all.center(), size), look);
  }
  for (const TouchingPair& pair : pairs)
    for (const auto& m : pair.manifolds) {
      Vec3d middle;
      for (const auto& p : m.points) {
        middle += p.position() / static_cast<double>(m.points.size());
        writer.add("contact", octahedron(p.position(), size / 150), dot);
      }
      add_arrow(writer, middle, m.normal, size / 12, arrow);
    }
  writer.save(file);
}

}  // namespace graze::io
