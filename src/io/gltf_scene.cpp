// The reading of a glTF file as bodies and colliders: nodes, KHR_implicit_shapes and KHR_physics_rigid_bodies.
#include <algorithm>
#include <map>

#include "graze/io/scene.hpp"
#include "io/gltf_animation.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_extensions.hpp"
#include "io/gltf_node.hpp"
#include "io/gltf_physics.hpp"
#include "io/mesh_collider.hpp"
#include "io/question.hpp"
#include "io/scaled_shape.hpp"
#include "io/scene_file.hpp"

namespace graze::io {

namespace {

constexpr const char* physics_extension = "KHR_physics_rigid_bodies";
constexpr const char* shapes_extension = "KHR_implicit_shapes";

std::vector<JsonValue> list(const JsonValue& json, const char* key) {
  const auto found = json.find(key);
  return found ? found->elements() : std::vector<JsonValue>{};
}

std::optional<JsonValue> extension(const JsonValue& json, const char* name) {
  const auto all = json.find("extensions");
  return all ? all->find(name) : std::nullopt;
}

void require_regular(const JsonValue& node, const Affine& map) {
  if (is_regular(map)) return;
  throw InvalidValue(node.path(), "a transform with a scale that is neither zero nor singular",
                     "one of determinant " + validate::number(determinant(map.linear)));
}

class SceneReader {
 public:
  SceneReader(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
              const LoadOptions& options)
      : document_(bytes, folder), root_(document_.json(), ""), options_(options), nodes_(list(root_, "nodes")) {
    scene_.source = name;
  }

  Scene run() {
    if (const auto shared = extension(root_, shapes_extension)) shapes_ = list(*shared, "shapes");
    if (const auto physics = extension(root_, physics_extension)) {
      for (const JsonValue& m : list(*physics, "physicsMaterials")) materials_.push_back(read_physics_material(m));
      filters_ = list(*physics, "collisionFilters");
      for (const JsonValue& filter : filters_) read_filter(filter);
      for (const JsonValue& j : list(*physics, "physicsJoints")) descriptions_.push_back(read_joint_description(j));
    }
    walk();
    for (const JointNode& joint : joint_nodes_) read_joint(joint);
    if (scene_.colliders.empty() && !(options_.physics_only && moves_))
      meshes_collide();
    else if (options_.chosen)
      notice("the file has colliders of its own, which stay: none are made of its meshes");
    if (const auto name = required_of_meshes(root_))
      notice(name->path() + ": " + name->string() + " is not read, and no collider is made of a mesh");
    if (skipped_primitives_ > 0)
      notice(std::to_string(skipped_primitives_) + " primitives of points or lines are skipped");
    if (options_.animations) {
      tree_.source = scene_.source;
      for (const Body& body : scene_.bodies) tree_.bodies.push_back(static_cast<std::size_t>(body.node));
      auto tree = std::make_shared<const NodeTree>(std::move(tree_));
      scene_.animations = read_animations(document_, std::move(tree), scene_.notices);
    }
    return std::move(scene_);
  }

 private:
  struct Visit {
    std::size_t node;
    Affine parent;
    int body;                   ///< of the nearest ancestor with a motion, or -1
    int fixed = -1;             ///< without one, of the nearest ancestor with a collider, or -1
    std::ptrdiff_t above = -1;  ///< the parent's node, or -1
  };
  /// The place of a node, and the body that a joint on it holds; without one it holds the world.
  struct NodePlace {
    Affine map;
    std::optional<std::uint32_t> body;
  };
  struct JointNode {
    std::size_t node;
    JsonValue json;
  };

  void notice(const std::string& text) { scene_.notices.push_back(text); }

  std::uint64_t system_bit(const JsonValue& name) {
    const std::string text = name.string();
    auto& names = scene_.collision_systems;
    const auto found = std::find(names.begin(), names.end(), text);
    const auto place = static_cast<std::size_t>(found - names.begin());
    // The last bit is for colliders that name no system.
    if (place >= 63) name.fail("one of at most 63 collision systems");
    if (found == names.end()) names.push_back(text);
    return std::uint64_t{1} << place;
  }

  std::uint64_t systems(const JsonValue& filter, const char* key) {
    std::uint64_t bits = 0;
    for (const JsonValue& name : list(filter, key)) bits |= system_bit(name);
    return bits;
  }

  static constexpr std::uint64_t unnamed = std::uint64_t{1} << 63;

  /// A filter's systems as bits. A collider without a name belongs to the unnamed system; a list of systems to collide
  /// with leaves everything else out, a list of systems not to collide with leaves everything else in.
  Filter read_filter(const JsonValue& json) {
    Filter filter;
    const std::uint64_t own = systems(json, "collisionSystems");
    filter.category = own != 0 ? own : unnamed;
    if (json.has("collideWithSystems") && json.has("notCollideWithSystems"))
      throw InvalidValue(json.path(), "collideWithSystems or notCollideWithSystems", "both, which exclude each other");
    if (json.has("collideWithSystems"))
      filter.mask = systems(json, "collideWithSystems");
    else
      filter.mask = ~systems(json, "notCollideWithSystems");
    return filter;
  }

  void walk() {
    std::vector<char> visited(nodes_.size(), 0);
    tree_.nodes.resize(nodes_.size());
    places_.resize(nodes_.size());
    std::vector<Visit> stack;
    for (const std::size_t root : root_nodes()) stack.push_back({root, {}, -1});
    std::reverse(stack.begin(), stack.end());
    while (!stack.empty()) {
      const Visit visit = stack.back();
      stack.pop_back();
      const JsonValue& node = nodes_[visit.node];
      if (visited[visit.node]++)
        throw InvalidValue(node.path(), "a node with one parent, in a tree", "a node that is reached twice");
      const Affine map = visit.parent * keep_node(visit, node);
      int fixed = visit.fixed;
      const int body = read_node(visit, node, map, fixed);
      const int held = body < 0 ? fixed : body;
      places_[visit.node] = NodePlace{map, held < 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(held))};
      const auto above = static_cast<std::ptrdiff_t>(stack.size());
      for (const JsonValue& child : list(node, "children"))
        stack.push_back({child.index_below(nodes_.size()), map, body, fixed, static_cast<std::ptrdiff_t>(visit.node)});
      std::reverse(stack.begin() + above, stack.end());  // the first child is visited first
    }
  }

  /// Keeps a node's map, which its animations need as well.
  const Affine& keep_node(const Visit& visit, const JsonValue& json) {
    TreeNode& node = tree_.nodes[visit.node];
    node.parent = visit.above;
    if (!json.has("matrix")) node.rest = node_transform(json);
    node.map = node_map(json);
    tree_.order.push_back(visit.node);
    return node.map;
  }

  /// The roots of the scene to show; in a file without scenes, the nodes that are no node's child.
  std::vector<std::size_t> root_nodes() {
    std::vector<std::size_t> roots;
    const auto scenes = list(root_, "scenes");
    if (!scenes.empty()) {
      const auto chosen = root_.find("scene");
      for (const JsonValue& r : list(scenes[chosen ? chosen->index_below(scenes.size()) : 0], "nodes"))
        roots.push_back(r.index_below(nodes_.size()));
      return roots;
    }
    std::vector<char> child(nodes_.size(), 0);
    for (const JsonValue& node : nodes_)
      for (const JsonValue& c : list(node, "children")) child[c.index_below(nodes_.size())] = 1;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!child[i]) roots.push_back(i);
    return roots;
  }

  std::string name_of(std::size_t index) const {
    const auto name = nodes_[index].find("name");
    return name ? name->string() : "node " + std::to_string(index);
  }

  /// Reads a node's physics; returns the body that its children belong to. `fixed` becomes the body of its collider.
  int read_node(const Visit& visit, const JsonValue& node, const Affine& map, int& fixed) {
    int body = visit.body;
    const auto mesh = node.find("mesh");
    if (mesh) mesh_nodes_.push_back({visit.node, map, body});
    const auto physics = extension(node, physics_extension);
    if (!physics) return body;
    if (const auto motion = physics->find("motion")) {
      require_regular(node, map);
      validate::point(map.translation, node.path() + " (in the world).translation");
      const Posed pose = body_pose(map);
      const BodyMotion m = in_body_frame(read_motion(*motion), map, pose.rotation);
      body = add_body(visit.node, m.kinematic ? MotionType::kinematic : MotionType::dynamic, m, pose);
      moves_ = true;
    }
    if (const auto collider = physics->find("collider")) {
      read_collider(visit.node, *collider, map, body, false);
      if (body < 0) fixed = static_cast<int>(scene_.bodies.size()) - 1;
    }
    if (const auto trigger = physics->find("trigger")) read_collider(visit.node, *trigger, map, body, true);
    if (const auto joint = physics->find("joint")) joint_nodes_.push_back({visit.node, *joint});
    return body;
  }

  int add_body(std::size_t node, MotionType type, std::optional<BodyMotion> motion, const Posed& pose) {
    scene_.bodies.push_back({name_of(node), static_cast<int>(node), type, motion, pose});
    return static_cast<int>(scene_.bodies.size()) - 1;
  }

  /// Reads a joint once all nodes are in their places, as the other end may be anywhere in the tree.
  void read_joint(const JointNode& at) {
    const JsonValue other = at.json.at("connectedNode");
    const std::size_t connected = other.index_below(nodes_.size());
    if (!places_[connected]) other.fail("a node of the scene");
    const JointDescription& description = descriptions_[at.json.at("joint").index_below(descriptions_.size())];
    Joint joint{
        name_of(at.node),   static_cast<int>(at.node), places_[at.node]->body, places_[connected]->body, {}, {}, false,
        description.limits, description.drives};
    joint.frame_a = joint_frame(at.node);
    joint.frame_b = joint_frame(connected);
    if (const auto v = at.json.find("enableCollision")) joint.enable_collision = v->boolean();
    const auto moves = [&](const std::optional<std::uint32_t>& body) {
      return body && scene_.bodies[*body].type != MotionType::fixed;
    };
    if (joint.body_a == joint.body_b || (!moves(joint.body_a) && !moves(joint.body_b)))
      notice(joint.name + ": a joint of what cannot move against each other is skipped");
    else
      scene_.joints.push_back(std::move(joint));
  }

  /// A node's frame in the body that it belongs to.
  Posed joint_frame(std::size_t node) const {
    const NodePlace& place = *places_[node];
    require_regular(nodes_[node], place.map);
    validate::point(place.map.translation, nodes_[node].path() + " (in the world).translation");
    const Posed frame = rigid_part(place.map);
    return place.body ? relative(scene_.bodies[*place.body].pose, frame) : frame;
  }

  void read_collider(std::size_t node, const JsonValue& json, const Affine& map, int body, bool trigger) {
    const auto geometry = json.find("geometry");
    if (!geometry && json.has("nodes")) {
      notice(name_of(node) + ": a trigger made of other nodes' triggers is those triggers");
      return;
    }
    const Shaped shape = read_geometry(json.at("geometry"));
    require_regular(nodes_[node], map);
    Collider collider = placed(node, shape, map, body);
    collider.trigger = trigger;
    if (const auto f = json.find("collisionFilter"))
      collider.filter = read_filter(filters_[f->index_below(filters_.size())]);
    else
      collider.filter.category = unnamed;
    if (const auto m = json.find("physicsMaterial")) collider.material = materials_[m->index_below(materials_.size())];
    scene_.colliders.push_back(std::move(collider));
  }

  Collider placed(std::size_t node, const Shaped& shape, const Affine& map, int body) {
    if (body < 0) body = add_body(node, MotionType::fixed, {}, body_pose(map));
    const MappedShape result = mapped_at(node, shape, map);
    tree_.colliders.push_back({shape, node, map});
    if (!result.notice.empty()) notice(name_of(node) + ": " + result.notice);
    return {name_of(node),
            static_cast<int>(node),
            static_cast<std::uint32_t>(body),
            result.shape,
            result.pose,
            {},
            false,
            {}};
  }

  /// A shape under a node's map. Transforms multiply from node to node, and so may grow out of bounds.
  MappedShape mapped_at(std::size_t node, const Shaped& shape, const Affine& map) const {
    const std::string path = nodes_[node].path() + " (in the world)";
    validate::point(map.translation, path + ".translation");
    try {
      return mapped(shape, map);
    } catch (const InvalidValue& e) {
      throw e.below(path);
    }
  }

  /// `shape` is an index of KHR_implicit_shapes; `node` (of older drafts) or `mesh` name triangles.
  Shaped read_geometry(const JsonValue& json) {
    if (const auto s = json.find("shape")) return read_implicit(shapes_[s->index_below(shapes_.size())]);
    const auto hull = json.find("convexHull");
    const MeshColliders kind = hull && hull->boolean() ? MeshColliders::hull : MeshColliders::mesh;
    if (const auto m = json.find("mesh")) return mesh_shape(*m, kind);
    const JsonValue n = json.at("node");
    return mesh_shape(nodes_[n.index_below(nodes_.size())].at("mesh"), kind);
  }

  Shaped mesh_shape(const JsonValue& mesh, MeshColliders kind) {
    const std::size_t index = mesh.index_below(list(root_, "meshes").size());
    const TriangleSoup soup = document_.triangles(index, skipped_primitives_);
    if (soup.triangles.empty()) mesh.fail("a mesh with triangles");
    return mesh_collider(soup, kind);
  }

  /// The shapes of the extension are written as those of the query protocol, plus what other extensions add to them.
  static Shaped read_implicit(const JsonValue& json) {
    const std::string type = json.at("type").string();
    static constexpr const char* known[] = {"sphere", "box", "capsule", "cylinder", "plane"};
    if (std::find(std::begin(known), std::end(known), type) == std::end(known))
      json.at("type").fail("one of sphere, box, capsule, cylinder, plane");
    Json plain{{"type", type}};
    if (const auto own = json.find(type.c_str())) plain[type] = own->json();
    return read_shape<double>(JsonValue(plain, json.path()));
  }

  void meshes_collide() {
    scene_.bodies.clear();
    scene_.colliders.clear();
    scene_.joints.clear();
    for (const Visit& v : mesh_nodes_) {
      const auto mesh = nodes_[v.node].at("mesh");
      const std::size_t index = mesh.index_below(list(root_, "meshes").size());
      const TriangleSoup soup = document_.triangles(index, skipped_primitives_);
      if (soup.triangles.empty()) continue;
      require_regular(nodes_[v.node], v.parent);
      scene_.colliders.push_back(placed(v.node, mesh_collider(soup, options_.mesh_colliders), v.parent, -1));
    }
  }

  GltfDocument document_;
  JsonValue root_;
  LoadOptions options_;
  std::vector<JsonValue> nodes_, shapes_, filters_;
  std::vector<Material> materials_;
  std::vector<JointDescription> descriptions_;
  std::vector<std::optional<NodePlace>> places_;  ///< by node, of those in the scene
  std::vector<JointNode> joint_nodes_;
  bool moves_ = false;             ///< a node has a motion
  std::vector<Visit> mesh_nodes_;  ///< with the node's own map in `parent`
  NodeTree tree_;
  Scene scene_;
  int skipped_primitives_ = 0;
};

}  // namespace

Scene load_gltf_from(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                     const LoadOptions& options) {
  try {
    return SceneReader(bytes, name, folder, options).run();
  } catch (const InvalidValue& e) {
    throw InvalidValue(e.path().empty() ? name : name + ": " + e.path(), e.expectation(), e.found());
  } catch (const std::bad_alloc&) {
    throw InvalidValue(name, "a scene that fits into memory", "a larger one");
  }
}

Scene load_gltf(const std::string& bytes, const std::string& source_name, const LoadOptions& options) {
  return load_gltf_from(bytes, source_name, {}, options);
}

}  // namespace graze::io
