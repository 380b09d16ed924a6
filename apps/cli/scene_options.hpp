// The options that commands for scenes share.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "graze/io/scene.hpp"

namespace graze::cli {

struct SceneOptions {
  std::vector<std::string> files;
  std::string colliders;

  /// Adds the options; with `or_plane` the help says that a scene of the plane will do.
  void add_to(CLI::App& command, bool or_plane = true);
  io::LoadOptions load_options(bool animations = false, bool physics_only = false) const;
  /// Loads all files in one scene, each at the origin, with their animations if `animations`. With `physics_only` the
  /// meshes of files that have motions, and no colliders, do not collide. Throws `InvalidValue`.
  io::Scene load(bool animations = false, bool physics_only = false) const;
  /// Whether it is a scene of the plane, which is one file alone. Throws `InvalidValue` for one among others.
  bool is_in_plane() const;
  /// The file that can be drawn into; empty when there are several.
  std::string only_file() const { return files.size() == 1 ? files[0] : ""; }
};

}  // namespace graze::cli
