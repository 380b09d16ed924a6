#include "io/animated_scene.hpp"

#include <algorithm>
#include <cstring>

#include "graze/io/file.hpp"
#include "io/gltf_drawing.hpp"
#include "io/gltf_node.hpp"

namespace graze::io {

namespace {

/// The rounding of a right angle or of equal lengths in a product of maps. Files hold their turns in single precision,
/// but a quaternion is a turn whatever its digits; a larger error is a shear.
constexpr double shear_rounding = 1e-9;

Affine inverse(const Affine& map) {
  const Vec3d x = map.linear.column(0), y = map.linear.column(1), z = map.linear.column(2);
  const double volume = determinant(map.linear);
  const Mat3d rows{{cross(y, z) / volume, cross(z, x) / volume, cross(x, y) / volume}};
  return {rows, -(rows * map.translation), map.signs};
}

/// The scale of a map that turns and scales evenly, or nothing.
std::optional<double> even_scale(const Mat3d& linear) {
  const double scale = length(linear.column(0));
  if (!(determinant(linear) > 0)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      const double wanted = i == j ? scale * scale : 0;
      if (!(std::abs(dot(linear.column(i), linear.column(j)) - wanted) <= shear_rounding * scale * scale))
        return std::nullopt;
    }
  return scale;
}

/// The diagonal of a matrix that has only zeros beside it, or nothing.
std::optional<Vec3d> diagonal(const Mat3d& m) {
  const Vec3d d{m.row[0].x, m.row[1].y, m.row[2].z};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j && !(std::abs(m.row[i][j]) <= shear_rounding * max_abs(d))) return std::nullopt;
  return d;
}

Json numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }
Json numbers(const Quatd& q) { return {q.x, q.y, q.z, q.w}; }

/// The nodes of a file: whose child each is, and its map to the world.
struct NodeMaps {
  explicit NodeMaps(const Json& file) {
    const auto nodes = file.find("nodes");
    if (nodes == file.end()) return;
    const std::size_t count = nodes->size();
    parent.resize(count);
    world.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      if (const auto children = (*nodes)[i].find("children"); children != (*nodes)[i].end())
        for (const Json& c : *children)
          if (c.is_number_unsigned() && c.get<std::size_t>() < count) parent[c.get<std::size_t>()] = i;
    std::vector<char> known(count, 0);
    std::vector<std::size_t> path;
    for (std::size_t i = 0; i < count; ++i) {
      // A node that is its own ancestor stands in no scene; its path ends where it was entered.
      for (std::size_t n = i; !known[n]; n = *parent[n]) {
        known[n] = 1;
        path.push_back(n);
        if (!parent[n]) break;
      }
      for (; !path.empty(); path.pop_back()) {
        const std::size_t n = path.back();
        const Affine own = node_map(JsonValue((*nodes)[n], "nodes[" + std::to_string(n) + "]"));
        world[n] = parent[n] ? world[*parent[n]] * own : own;
      }
    }
  }

  std::vector<std::optional<std::size_t>> parent;
  std::vector<Affine> world;
};

/// A node whose keyframes are a body's motion seen from the node's parent.
struct MovedNode {
  std::size_t node;
  std::optional<std::size_t> carrier;  ///< the moving body, by its place among these, that its parent moves with
  Posed rest{};                        ///< of its parent: in the carrier's frame, or in the world
  double scale = 1;                    ///< of its parent
  std::vector<float> translations, rotations;
};

class AnimatedScene final : public Recording {
 public:
  AnimatedScene(const std::filesystem::path& file, const Scene& scene, const std::filesystem::path& source)
      : file_(file), scene_(scene), moving_(moving_bodies(scene)) {
    const bool kept = is_gltf(source);
    if (kept) model_ = GltfModel(source);
    check_writable(file);
    const NodeMaps maps(model_.json());
    for (const std::uint32_t b : moving_) nodes_.push_back(kept ? hung_node(maps, b) : own_node(b));
    kept ? draw_below_nodes(maps) : draw_below_bodies();
  }

  void add(const SimulationFrame& frame) override {
    if (frame.bodies.size() != moving_.size())
      throw InvalidValue("bodies", std::to_string(moving_.size()) + " states", std::to_string(frame.bodies.size()));
    times_.push_back(static_cast<float>(frame.time));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      MovedNode& n = nodes_[i];
      const Posed under = n.carrier ? compose(frame.bodies[*n.carrier].pose, n.rest) : n.rest;
      const Posed local = relative(under, frame.bodies[i].pose);
      push(n.translations, local.translation / n.scale);
      push(n.rotations, normalized(local.rotation));
    }
  }

  void close() override {
    if (!nodes_.empty() && !times_.empty()) model_.add("animations", animation());
    model_.save(file_);
  }

  std::vector<std::string> notices() const override { return model_.notices(); }

 private:
  static void push(std::vector<float>& values, const Vec3d& v) {
    for (const double x : {v.x, v.y, v.z}) values.push_back(static_cast<float>(x));
  }
  /// Appends a rotation: of its two quaternions the one next to the last, so that players take the short way.
  static void push(std::vector<float>& values, const Quatd& q) {
    const std::size_t n = values.size();
    const double parts[4] = {q.x, q.y, q.z, q.w};
    double along = 0;
    for (std::size_t k = 0; k < 4 && n >= 4; ++k) along += static_cast<double>(values[n - 4 + k]) * parts[k];
    for (const double x : parts) values.push_back(static_cast<float>(along < 0 ? -x : x));
  }

  /// The place among the moving bodies of the body that a node moves with, or nothing.
  std::optional<std::size_t> carrier_of(const NodeMaps& maps, std::optional<std::size_t> node) const {
    for (; node; node = maps.parent[*node])
      for (std::size_t i = 0; i < moving_.size(); ++i)
        if (scene_.bodies[moving_[i]].node == static_cast<int>(*node)) return i;
    return std::nullopt;
  }

  /// The node of a body, which keeps its place in the tree where a translation, a turn and its scale can express its
  /// motion there. Under a parent that scales unevenly they cannot: the node then hangs on one of its own at the top.
  MovedNode hung_node(const NodeMaps& maps, std::uint32_t b) {
    const Body& body = scene_.bodies[b];
    const auto node = static_cast<std::size_t>(body.node);
    const auto parent = maps.parent.at(node);
    const Affine under = parent ? maps.world[*parent] : Affine{};
    const Affine unscaled{transposed(rotation_matrix(body.pose.rotation)) * maps.world[node].linear, {}};
    const auto scale = even_scale(under.linear);
    const auto own_scale = diagonal(unscaled.linear);
    if (!scale || !own_scale) return hung_anew(maps, b, unscaled);
    MovedNode moved{node, carrier_of(maps, parent), rigid_part(under), *scale, {}, {}};
    const Posed local = relative(moved.rest, body.pose);
    if (moved.carrier) moved.rest = relative(scene_.bodies[moving_[*moved.carrier]].pose, moved.rest);
    Json& json = model_.node(node);
    json.erase("matrix");
    json["translation"] = numbers(local.translation / *scale);
    json["rotation"] = numbers(local.rotation);
    if (const Vec3d s = *own_scale / *scale; s != Vec3d{1, 1, 1} || json.contains("scale")) json["scale"] = numbers(s);
    return moved;
  }

  /// Hangs a body's node on two new ones, which at rest have the map of its parent: the node itself stays as it is.
  MovedNode hung_anew(const NodeMaps& maps, std::uint32_t b, const Affine& unscaled) {
    const Body& body = scene_.bodies[b];
    const auto node = static_cast<std::size_t>(body.node);
    const auto parent = maps.parent[node];
    const Affine own = parent ? inverse(maps.world[*parent]) * maps.world[node] : maps.world[node];
    const Affine between = unscaled * inverse(own);
    Json matrix = Json::array();
    for (std::size_t c = 0; c < 3; ++c)
      for (const double x : {between.linear.column(c).x, between.linear.column(c).y, between.linear.column(c).z, 0.0})
        matrix.push_back(x);
    for (const double x : {between.translation.x, between.translation.y, between.translation.z, 1.0})
      matrix.push_back(x);
    const std::size_t root = model_.add_root({{"name", body.name + " (moved)"},
                                              {"translation", numbers(body.pose.translation)},
                                              {"rotation", numbers(body.pose.rotation)}});
    const std::size_t scaling = model_.add_root({{"name", body.name + " (scaled)"}, {"matrix", std::move(matrix)}});
    model_.move_node(scaling, root);
    model_.move_node(node, scaling);
    return {root, {}, {}, 1, {}, {}};
  }

  /// A node for a body of a scene that is drawn alone.
  MovedNode own_node(std::uint32_t b) {
    const Body& body = scene_.bodies[b];
    const std::size_t node = model_.add_root({{"name", body.name},
                                              {"translation", numbers(body.pose.translation)},
                                              {"rotation", numbers(body.pose.rotation)}});
    return {node, {}, {}, 1, {}, {}};
  }

  void draw_below_nodes(const NodeMaps& maps) {
    for (const Collider& c : scene_.colliders) {
      const auto node = static_cast<std::size_t>(c.node);
      if (!model_.has_mesh(c.node)) draw(c, node, inverse(maps.world.at(node)), true);
    }
  }

  void draw_below_bodies() {
    for (const Collider& c : scene_.colliders) {
      const auto place = std::find(moving_.begin(), moving_.end(), c.body);
      if (place == moving_.end()) {
        draw(c, std::nullopt, {}, false);
        continue;
      }
      const Posed to_body = graze::inverse(scene_.bodies[c.body].pose);
      draw(c, nodes_[static_cast<std::size_t>(place - moving_.begin())].node,
           {rotation_matrix(to_body.rotation), to_body.translation}, false);
    }
  }

  /// A collider as a mesh below a node, whose space `to_node` leads to.
  void draw(const Collider& c, std::optional<std::size_t> node, const Affine& to_node, bool kept) {
    const Aabbd all = extent(scene_);
    Polygons shape = tessellate(c.shape, c.pose, all.center(), max_abs(all.extent()));
    thicken(shape, max_abs(all.extent()));
    for (Vec3d& p : shape.points) p = to_node(p);
    const bool fixed = scene_.bodies[c.body].type == MotionType::fixed;
    const auto mesh = writer_.mesh(c.name, shape, c.trigger ? trigger_look : collider_look(kept, fixed));
    if (!mesh) return;
    const std::size_t drawn = model_.add_root({{"name", c.name}, {"mesh", *mesh}});
    if (node) model_.move_node(drawn, *node);
  }

  std::size_t accessor(const char* type, std::size_t width, const std::vector<float>& values) {
    std::vector<unsigned char> bytes(values.size() * sizeof(float));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    constexpr int float_component = 5126;
    Json json{{"bufferView", model_.add_view(bytes)},
              {"componentType", float_component},
              {"count", values.size() / width},
              {"type", type}};
    if (width == 1) {  // of the times, for which the format requires them
      json["min"] = {values.front()};
      json["max"] = {values.back()};
    }
    return model_.add("accessors", std::move(json));
  }

  Json animation() {
    const std::size_t times = accessor("SCALAR", 1, times_);
    Json samplers = Json::array(), channels = Json::array();
    const auto move = [&](std::size_t node, const char* path, std::size_t values) {
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
      samplers.push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    };
    for (const MovedNode& n : nodes_) {
      move(n.node, "translation", accessor("VEC3", 3, n.translations));
      move(n.node, "rotation", accessor("VEC4", 4, n.rotations));
    }
    return {{"name", "simulation"}, {"samplers", samplers}, {"channels", channels}};
  }

  std::filesystem::path file_;
  const Scene& scene_;
  std::vector<std::uint32_t> moving_;
  GltfModel model_;
  ModelWriter writer_{model_};
  std::vector<MovedNode> nodes_;  ///< of the moving bodies
  std::vector<float> times_;
};

}  // namespace

std::unique_ptr<Recording> record_animation(const std::filesystem::path& file, const Scene& scene,
                                            const std::filesystem::path& source) {
  return std::make_unique<AnimatedScene>(file, scene, source);
}

}  // namespace graze::io
