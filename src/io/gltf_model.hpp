// A glTF file in memory to which things are added, and which is written as one file.
//
// Guarantee: all that the file held stays as it was, known to this library or not: every element at its index, every
// extension, every picture byte for byte. Therefore it is kept as the JSON that it is and not as some library's model
// of it, which would drop unknown parts.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/json_value.hpp"

namespace graze::io {

/// The file that a scene in `folder` names: one below that folder, so that a scene cannot have any other read; none for
/// data in the address itself.
std::optional<std::filesystem::path> file_below(const std::filesystem::path& folder, const std::string& uri);

class GltfModel {
 public:
  /// Makes an empty scene.
  GltfModel();
  /// Opens a .gltf or .glb file, with all files that it refers to below its own folder. Throws `InvalidValue`.
  explicit GltfModel(const std::filesystem::path& file);

  /// The file as it is now.
  const Json& json() const { return json_; }
  /// A node, to be changed.
  Json& node(std::size_t index) { return json_.at("nodes").at(index); }
  /// Puts a node below another, or, without one, at the top of the scene that is shown; wherever it was before.
  void move_node(std::size_t index, std::optional<std::size_t> parent);

  /// Whether a node of the file shows a mesh of its own.
  bool has_mesh(int node) const;

  /// Adds an element to one of the file's lists ("meshes", "nodes", ...); returns its index.
  std::size_t add(const char* list, Json element);
  /// Adds bytes of which accessors or pictures are made, as a buffer view; `target` as in the format, 0 for none.
  std::size_t add_view(std::span<const unsigned char> bytes, int target = 0);
  /// Adds a node to the scene that is shown.
  std::size_t add_root(Json node);

  /// The text of one file with everything in it.
  std::string text() const;
  /// Writes that to a file: text when its name ends in .gltf, else binary.
  void save(const std::filesystem::path& file) const;

  /// The parts of the file that could not be taken along, one sentence each.
  const std::vector<std::string>& notices() const { return notices_; }

 private:
  Json& shown_scene();
  Json without_empty_lists() const;
  void embed_buffers(const std::filesystem::path& folder, std::span<const unsigned char> chunk);
  void embed_images(const std::filesystem::path& folder);

  Json json_;
  std::vector<unsigned char> data_;  ///< of the first buffer, the only one that a .glb holds as bytes
  std::vector<std::string> notices_;
};

}  // namespace graze::io
