// graze collide --frames: the events of a scene's animation.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "graze/io/collide_frames.hpp"

namespace graze::cli {

struct FramesOptions {
  bool frames = false;
  double fps = 30;
  std::optional<double> duration;
  std::string animation;

  /// Adds the options and returns the flag for frames.
  CLI::Option* add_to(CLI::App& command);
};

/// Plays an animation and prints its events, as a table or as JSON. Throws `InvalidValue`.
void print_frames(const io::Scene& scene, const FramesOptions& options, std::optional<double> margin,
                  io::Precision precision, bool json);

}  // namespace graze::cli
