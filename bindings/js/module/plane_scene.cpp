// Drawings for JavaScript: the elements of an SVG in, a scene of the plane out, both as JSON.
#include <cstddef>
#include <string>
#include <string_view>

#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"
#include "io/json_value.hpp"
#include "io/svg_scene.hpp"

namespace {

using graze::io::Json;
using graze::io::XmlElement;

std::string scene;  ///< the last one

/// An element from [name, line, {attribute: value, ...}, [elements inside]], as the package's own script makes it.
XmlElement element_of(const Json& json, int depth = 0) {
  if (depth > graze::io::most_xml_depth)
    throw graze::InvalidValue("", "elements nested at most 100 deep", "deeper ones");
  XmlElement made{json.at(0).get<std::string>(), json.at(1).get<std::size_t>(), {}, {}};
  for (const auto& [name, value] : json.at(2).items()) made.attributes.emplace_back(name, value.get<std::string>());
  for (const Json& child : json.at(3)) made.children.push_back(element_of(child, depth + 1));
  return made;
}

std::string read(std::string_view elements) {
  try {
    return graze::io::to_json(graze::io::read_svg(element_of(graze::io::parse_json(elements)), "drawing"));
  } catch (const graze::InvalidValue& e) {
    return Json{{"error", e.what()}}.dump();
  }
}

}  // namespace

extern "C" {

/// Reads a drawing of `length` bytes; returns where the scene's bytes are, and writes their number to `count`.
__attribute__((export_name("graze_js_plane_scene"))) const char*
graze_js_plane_scene(const char* elements, std::size_t length, std::size_t* count) {
  scene = read({elements, length});
  *count = scene.size();
  return scene.data();
}

}  // extern "C"
