// Words about scenes of either space.
#pragma once

#include <string>

#include "convert.hpp"
#include "graze/io/scene.hpp"

namespace graze::python {

inline const char* text_of(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::dynamic ? "dynamic" : "kinematic";
}

/// A text as Python writes it.
inline std::string quoted(const std::string& text) { return py::str(py::repr(py::str(text))); }

/// The text of a scene: its file, and how much is in it.
template <class Scene>
std::string scene_text(const char* name, const Scene& scene) {
  return "<" + std::string(name) + " " + quoted(scene.source) + ": " + std::to_string(scene.bodies.size()) +
         " bodies, " + std::to_string(scene.colliders.size()) + " colliders>";
}

}  // namespace graze::python
