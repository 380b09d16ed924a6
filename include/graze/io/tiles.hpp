// Tiled scenes: a glTF that references tiles, each a scene file of its own, read on demand.
//
// A tile is a node without parent or children whose `extras` are `{"grazeTile": "FILE"}`, with the file's name relative
// to the folder of the glTF and below it. Its translation and rotation place the tile; it has no scale and no matrix. A
// tile references no tiles. Programs without support for tiles show the scene without them.
//
// Guarantee: that of `load_scene`: a violation raises `InvalidValue` with file and place.
#pragma once

#include <filesystem>
#include <vector>

#include "graze/io/scene.hpp"

namespace graze::io {

/// A file's own content, or one of its tiles.
struct ScenePart {
  std::filesystem::path file;  ///< file to be read
  Posed pose{};                ///< pose of its content in the scene
  bool tile = false;           ///< true for a tile, false for the file's own content
};

/// The parts of a scene: the file's own content first, then its tiles in the order of their nodes. Reads the file, and
/// no tile. Throws `InvalidValue`.
GRAZE_API std::vector<ScenePart> scene_parts(const std::filesystem::path& file);

/// Reads one part, and moves it to its place. `load_scene` returns all parts, joined by `append`. Animations of tiles
/// are left out, with a notice. Throws `InvalidValue`.
GRAZE_API Scene load_part(const ScenePart& part, const LoadOptions& options = {});

}  // namespace graze::io
