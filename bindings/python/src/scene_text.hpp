// Words about scenes of either space.
#pragma once

#include <string>

#include "convert.hpp"
#include "graze/io/scene.hpp"

namespace graze::python {

inline const char* text_of(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::dynamic ? "dynamic" : "kinematic";
}

/// A text that may come from the name of a file, whose bytes need not be UTF-8: as `os.fsdecode` has it.
inline py::str file_text(const std::string& text) {
  PyObject* decoded = PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size()));
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

/// A text as Python writes it.
inline std::string quoted(const std::string& text) { return py::str(py::repr(file_text(text))); }

/// The text of a scene: its file, and how much is in it.
template <class Scene>
std::string scene_text(const char* name, const Scene& scene) {
  return "<" + std::string(name) + " " + quoted(scene.source) + ": " + std::to_string(scene.bodies.size()) +
         " bodies, " + std::to_string(scene.colliders.size()) + " colliders>";
}

}  // namespace graze::python
