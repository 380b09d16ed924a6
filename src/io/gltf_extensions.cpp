#include "io/gltf_extensions.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace graze::io {

namespace {

using Names = std::span<const std::string_view>;

constexpr std::string_view of_meshes[] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                          "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};

/// Extensions that are read, and those that are nothing to colliders and bodies. Quantized points are refused where
/// they are met, which those of a collider need not be.
constexpr std::string_view read_or_unseen[] = {"KHR_implicit_shapes",
                                               "KHR_physics_rigid_bodies",
                                               "KHR_mesh_quantization",
                                               "KHR_animation_pointer",
                                               "KHR_techniques_webgl",
                                               "KHR_xmp",
                                               "KHR_xmp_json_ld",
                                               "KHR_audio_emitter",
                                               "KHR_interactivity",
                                               "KHR_node_visibility",
                                               "KHR_node_selectability",
                                               "KHR_node_hoverability",
                                               "EXT_mesh_features",
                                               "EXT_mesh_manifold",
                                               "EXT_instance_features",
                                               "EXT_feature_metadata",
                                               "EXT_structural_metadata",
                                               "CESIUM_RTC",
                                               "CESIUM_primitive_outline",
                                               "FB_geometry_metadata",
                                               "FB_ngon_encoding",
                                               "GODOT_single_root",
                                               "AGI_articulations",
                                               "AGI_stk_metadata",
                                               "MSFT_lod"};

/// Words behind the vendor's prefix with which extensions of looks begin, as in KHR_materials_clearcoat.
constexpr std::string_view looks[] = {"materials_", "texture_", "lights_", "packing_"};

bool contains(Names names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

bool is_look(std::string_view name) {
  const std::string_view rest = name.substr(std::min(name.find('_') + 1, name.size()));
  return std::any_of(std::begin(looks), std::end(looks), [&](std::string_view look) { return rest.starts_with(look); });
}

std::vector<JsonValue> required(const JsonValue& root) {
  const auto list = root.find("extensionsRequired");
  return list ? list->elements() : std::vector<JsonValue>{};
}

}  // namespace

void check_required_extensions(const JsonValue& root) {
  for (const JsonValue& name : required(root)) {
    const std::string text = name.string();
    if (!contains(read_or_unseen, text) && !contains(of_meshes, text) && !is_look(text))
      name.fail("an extension that is read (KHR_implicit_shapes, KHR_physics_rigid_bodies) or only seen (materials, "
                "textures, lights)");
  }
}

std::optional<JsonValue> required_of_meshes(const JsonValue& root) {
  for (const JsonValue& name : required(root))
    if (contains(of_meshes, name.string())) return name;
  return std::nullopt;
}

}  // namespace graze::io
