// Drawing into a glTF model: polygons as meshes, dots, arrows, and the looks that they have.
//
// Guarantee: what is added is valid glTF 2.0; nothing that was in the model changes.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "graze/io/scene.hpp"
#include "graze/tessellate.hpp"
#include "io/gltf_model.hpp"

namespace graze::io {

struct Look {
  const char* name;
  double r, g, b, alpha;
};

inline constexpr Look contact_look{"contact", 0.75, 0.05, 0.1, 1}, normal_look{"normal", 0.1, 0.2, 0.35, 1},
    trigger_look{"trigger", 0.4, 0.7, 0.5, 0.3};

/// Draws polygons into a model.
class ModelWriter {
 public:
  explicit ModelWriter(GltfModel& model) : model_(model) {}

  /// One node with one mesh.
  void add(const std::string& name, const Polygons& shape, const Look& look);
  /// One more node with a mesh that is there.
  void place(const std::string& name, std::size_t mesh, const Posed& pose);
  /// Polygons as triangles with corners of their own, so that faces look flat; no mesh when there are none.
  std::optional<std::size_t> mesh(const std::string& name, const Polygons& shape, const Look& look);

 private:
  std::size_t material(const Look& look);
  std::size_t positions(const std::vector<Vec3d>& points);

  GltfModel& model_;
  std::map<std::string, std::size_t> materials_;
};

/// How a collider looks that touches nothing: alone in its file, or (`kept`) beside what the file shows by itself.
const Look& collider_look(bool kept, bool fixed);

/// What a contact point is drawn as.
Polygons octahedron(double radius);
/// An arrow from the origin along +Y.
Polygons arrow_up(double length);
/// The turn that takes +Y to a unit vector.
Quatd turn_to(const Vec3d& direction);

/// The bounds of all that is bounded; a box of size 2 when nothing is.
Aabbd extent(const Scene& scene);
/// Whether a file's name ends as those of the format do.
bool is_gltf(const std::filesystem::path& file);

/// Draws the colliders of a scene, those of `touching` tinted. In a model that was a file (`kept`) only what shows no
/// mesh of its own, and over what is tinted.
void draw_colliders(ModelWriter& writer, const GltfModel& model, const Scene& scene,
                    const std::set<std::uint32_t>& touching, bool kept);

}  // namespace graze::io
