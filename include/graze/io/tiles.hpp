// Scenes in parts: a glTF that references tiles, each a scene file of its own, and each read by whoever needs it.
//
// A tile is a node without parent or children whose `extras` say `{"grazeTile": "FILE"}`, with the file's name relative
// to the folder of the glTF and below it. Its translation and rotation place the tile; it has no scale and no matrix. A
// tile references no tiles. Programs that do not know of tiles show the scene without them.
//
// Guarantee: as `load_scene`: what is not so raises `InvalidValue` with file and place.
#pragma once

#include <filesystem>
#include <vector>

#include "graze/io/scene.hpp"

namespace graze::io {

/// A file's own content, or one of its tiles.
struct ScenePart {
  std::filesystem::path file;  ///< what is read
  Posed pose{};                ///< where its content stands in the scene
  bool tile = false;           ///< one of the tiles, otherwise the file's own content
};

/// The parts of a scene: the file's own content first, then its tiles in the order of their nodes. Reads the file, and
/// no tile. Throws `InvalidValue`.
GRAZE_API std::vector<ScenePart> scene_parts(const std::filesystem::path& file);

/// Reads one part, and stands it where it belongs. What `load_scene` gives is all of its parts, one behind the other by
/// `append`. Animations of tiles are left out, and a notice says so. Throws `InvalidValue`.
GRAZE_API Scene load_part(const ScenePart& part, const LoadOptions& options = {});

}  // namespace graze::io
