// Drawing into a glTF model: polygons as meshes with looks, and debug draw by these.
//
// Guarantee: all additions are valid glTF 2.0; nothing that was in the model changes.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "graze/draw.hpp"
#include "graze/io/scene.hpp"
#include "io/gltf_model.hpp"

namespace graze::io {

struct Look {
  const char* name;
  double r, g, b, alpha;
};

inline constexpr Look trigger_look{"trigger", 0.4, 0.7, 0.5, 0.3};

/// Puts thin solids in the place of loops of one point or two, for a scene of that size: a mesh has only triangles.
void thicken(Polygons& shape, double size);

/// Writes polygons into a model.
class ModelWriter {
 public:
  explicit ModelWriter(GltfModel& model) : model_(model) {}

  /// Adds one node with one mesh.
  void add(const std::string& name, const Polygons& shape, const Look& look);
  /// Adds one more node with a mesh that is there.
  void place(const std::string& name, std::size_t mesh, const Posed& pose);
  /// Adds a node with nothing but a name and a place.
  void mark(const std::string& name, const Vec3d& at);
  /// Polygons as triangles with corners of their own, so that faces look flat; no mesh when there are none.
  std::optional<std::size_t> mesh(const std::string& name, const Polygons& shape, const Look& look);

 private:
  std::size_t material(const Look& look);
  std::size_t positions(const std::vector<Vec3d>& points);

  GltfModel& model_;
  std::map<std::string, std::size_t> materials_;
};

/// The look of a collider that touches nothing: alone in its file, or (`kept`) beside the meshes that the file shows.
const Look& collider_look(bool kept, bool fixed);

/// Debug draw into a model: shapes as meshes, points as small octahedra, arrows and lines as thin solids, each a node
/// of its own. A text is a node without a mesh that bears the words as its name.
class GltfDraw final : public DebugDraw {
 public:
  /// Looks are those of a model that was a file (`kept`), or of one that has nothing but what is drawn.
  GltfDraw(ModelWriter& writer, const DrawArea& area, bool kept) : DebugDraw(area), writer_(writer), kept_(kept) {}

  /// Sets the name of the nodes of shapes that follow.
  void name(const std::string& name) { name_ = name; }

  bool wants(DrawLayer) const override { return true; }
  void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) override;
  void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) override;
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) override;
  void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) override;
  void polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) override;
  void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) override;

 private:
  void place(const Polygons& shape, const Look& look, const Posed& pose);

  ModelWriter& writer_;
  bool kept_;
  std::string name_;
  std::map<std::string, std::optional<std::size_t>> meshes_;  ///< of dots and arrows, by their looks
};

/// The bounds of all bounded shapes; a box of size 2 when there are none.
Aabbd extent(const Scene& scene);
/// Whether a file's name ends as those of the format do.
bool is_gltf(const std::filesystem::path& file);

/// Draws the colliders of a scene, those of `touching` tinted. In a model that was a file (`kept`) only colliders that
/// show no mesh of their own, and over their meshes those that are tinted.
void draw_colliders(GltfDraw& canvas, const GltfModel& model, const Scene& scene,
                    const std::set<std::uint32_t>& touching, bool kept);

}  // namespace graze::io
