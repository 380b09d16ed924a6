#include "io/gltf_check.hpp"

#include <tiny_gltf.h>

#include <algorithm>

#include "io/gltf_extensions.hpp"
#include "io/parsed_number.hpp"

namespace graze::io {

namespace {

std::vector<JsonValue> objects(const JsonValue& root, const char* key) {
  const auto list = root.find(key);
  if (!list) return {};
  auto elements = list->elements();
  for (const JsonValue& e : elements)
    if (!e.json().is_object()) e.fail("an object");
  return elements;
}

void whole_if_there(const JsonValue& object, const char* key) {
  if (const auto value = object.find(key)) value->whole_number();
}

/// Checks that the file may be read as glTF 2.0, which a later version may forbid by its `minVersion`.
void check_version(const JsonValue& asset) {
  const JsonValue version = asset.at("version");
  if (!version.string().starts_with("2.")) version.fail("a version 2.x of glTF");
  const auto least = asset.find("minVersion");
  if (!least) return;
  const std::string text = least->string();
  const auto [value, length, error] = parse_number(text);
  if (error != std::errc() || length != text.size() || !(value <= 2)) least->fail("a version of at most 2.0");
}

void check_accessor(const JsonValue& accessor, std::size_t views) {
  accessor.at("count").whole_number();
  const JsonValue component = accessor.at("componentType"), type = accessor.at("type");
  if (tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component.whole_number())) <= 0)
    component.fail("a component type of glTF: 5120 to 5126");
  static constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  if (std::find(std::begin(types), std::end(types), type.string()) == std::end(types))
    type.fail("one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
  whole_if_there(accessor, "byteOffset");
  if (const auto view = accessor.find("bufferView")) view->index_below(views);
}

void check_view(const JsonValue& view, std::size_t buffers) {
  view.at("buffer").index_below(buffers);
  view.at("byteLength").whole_number();
  whole_if_there(view, "byteOffset");
  if (const auto stride = view.find("byteStride")) {
    const std::size_t bytes = stride->whole_number();
    if (bytes < 4 || bytes > 252 || bytes % 4 != 0) stride->fail("a multiple of 4 from 4 to 252");
  }
}

void check_primitive(const JsonValue& primitive, std::size_t accessors) {
  if (const auto attributes = primitive.find("attributes")) {
    if (!attributes->json().is_object()) attributes->fail("an object");
    for (const auto& [name, index] : attributes->json().items())
      JsonValue(index, attributes->path() + "." + name).index_below(accessors);
  }
  if (const auto indices = primitive.find("indices")) indices->index_below(accessors);
  if (const auto mode = primitive.find("mode"); mode && mode->whole_number() > 6) mode->fail("a mode of glTF: 0 to 6");
}

void check_animation(const JsonValue& animation, std::size_t accessors) {
  for (const JsonValue& sampler : objects(animation, "samplers"))
    for (const char* key : {"input", "output"}) sampler.at(key).index_below(accessors);
}

bool is_text(const JsonValue& buffer) { return buffer.has("uri") && buffer.at("uri").string().starts_with("data:"); }

}  // namespace

void check_gltf(const Json& json, bool chunk) {
  const JsonValue root(json, "");
  check_version(root.at("asset"));
  check_required_extensions(root);
  for (const char* key : {"cameras", "images", "materials", "nodes", "samplers", "scenes", "skins", "textures"})
    objects(root, key);

  const auto buffers = objects(root, "buffers"), views = objects(root, "bufferViews"),
             accessors = objects(root, "accessors");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    buffers[i].at("byteLength").whole_number();
    if (buffers[i].has("uri"))
      buffers[i].at("uri").string();
    else if (i > 0 || !chunk)
      throw InvalidValue(buffers[i].path() + ".uri", "a value, of all but the first buffer of a .glb", "nothing");
  }
  for (const JsonValue& view : views) check_view(view, buffers.size());
  for (const JsonValue& accessor : accessors) check_accessor(accessor, views.size());
  for (const JsonValue& animation : objects(root, "animations")) check_animation(animation, accessors.size());
  for (const JsonValue& mesh : objects(root, "meshes"))
    for (const JsonValue& primitive : objects(mesh, "primitives")) check_primitive(primitive, accessors.size());
}

void check_gltf_buffers(const Json& json, const std::string& missing) {
  for (const JsonValue& buffer : objects(JsonValue(json, ""), "buffers")) {
    if (!buffer.has("uri")) continue;
    const JsonValue uri = buffer.at("uri");
    if (!is_text(buffer)) {
      if (!missing.empty() && missing.ends_with(uri.string())) uri.fail("a file below the scene's folder");
      continue;
    }
    std::vector<unsigned char> bytes;
    std::string type;
    if (!tinygltf::DecodeDataURI(&bytes, type, uri.string(), 0, false)) uri.fail("base64 data");
    const JsonValue length = buffer.at("byteLength");
    if (bytes.size() != length.whole_number()) length.fail("the " + std::to_string(bytes.size()) + " bytes of its uri");
  }
}

}  // namespace graze::io
