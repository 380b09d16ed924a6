#include "io/gltf_document.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <optional>

#include "io/gltf_check.hpp"
#include "io/gltf_extensions.hpp"

namespace graze::io {

namespace {

/// The largest size of a scene or buffer file that is read.
constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 31;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// The JSON of a .gltf, or of the first chunk of a .glb.
std::string_view json_text(const std::string& bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < 20)
    throw InvalidValue("header", "a GLB header of 20 bytes", std::to_string(bytes.size()) + " bytes");
  if (word(bytes, 4) != 2) throw InvalidValue("header.version", "2", std::to_string(word(bytes, 4)));
  if (word(bytes, 8) > bytes.size())
    throw InvalidValue("header.length", "at most the " + std::to_string(bytes.size()) + " bytes of the file",
                       std::to_string(word(bytes, 8)));
  const std::uint32_t length = word(bytes, 12);
  if (length > bytes.size() - 20)
    throw InvalidValue("chunk[0].length", "at most " + std::to_string(bytes.size() - 20), std::to_string(length));
  return std::string_view(bytes).substr(20, length);
}

/// The file with some view for each sparse accessor without one, if there are such: tinygltf refuses triangles that
/// name such an accessor, which glTF allows. Any view will do, as that of a sparse accessor is read from the JSON.
std::optional<std::string> with_stand_in_views(const std::string& bytes, std::string_view text, const Json& json) {
  const auto lacks_view = [](const Json& accessor) {
    return accessor.is_object() && accessor.contains("sparse") && !accessor.contains("bufferView");
  };
  const auto accessors = json.find("accessors");
  if (accessors == json.end() || !accessors->is_array() ||
      std::none_of(accessors->begin(), accessors->end(), lacks_view))
    return std::nullopt;
  Json changed = json;
  for (Json& accessor : changed["accessors"])
    if (lacks_view(accessor)) accessor["bufferView"] = 0;
  std::string written = changed.dump();
  if (written.size() > largest_file - bytes.size())
    throw InvalidValue("", "a file below 2 GiB", std::to_string(bytes.size()) + " bytes, and more written in full");
  if (!bytes.starts_with("glTF")) return written;
  written.resize((written.size() + 3) / 4 * 4, ' ');
  const std::size_t rest = 20 + text.size(), end = word(bytes, 8);
  std::string glb = bytes.substr(0, 20) + written + (end > rest ? bytes.substr(rest, end - rest) : "");
  const auto total = static_cast<std::uint32_t>(glb.size()), length = static_cast<std::uint32_t>(written.size());
  std::memcpy(glb.data() + 8, &total, 4);
  std::memcpy(glb.data() + 12, &length, 4);
  return glb;
}

bool no_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;  // pictures are for renderers
}

/// The files of buffers, which may be read from below the scene's folder only.
struct Files {
  std::filesystem::path folder;
  std::string missing{};  ///< file that is not there

  bool allowed(const std::string& name) const {
    if (folder.empty()) return false;
    const auto inner = std::filesystem::path(name).lexically_normal().lexically_relative(folder.lexically_normal());
    return !inner.empty() && *inner.begin() != "..";
  }
};

tinygltf::FsCallbacks callbacks(Files& files) {
  tinygltf::FsCallbacks c{};
  c.user_data = &files;
  c.FileExists = [](const std::string& name, void* user) {
    std::error_code ignored;
    auto& own = *static_cast<Files*>(user);
    const bool there = own.allowed(name) && std::filesystem::is_regular_file(name, ignored);
    if (!there) own.missing = name;
    return there;
  };
  c.ExpandFilePath = [](const std::string& name, void*) { return name; };
  c.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error, const std::string& name, void* user) {
    std::error_code failed;
    const auto size = std::filesystem::file_size(name, failed);
    if (!static_cast<Files*>(user)->allowed(name) || failed || size > largest_file) {
      *error += "cannot read " + name;
      return false;
    }
    std::ifstream in(name, std::ios::binary);
    out->resize(size);
    in.read(reinterpret_cast<char*>(out->data()), static_cast<std::streamsize>(size));
    return static_cast<std::uintmax_t>(in.gcount()) == size;
  };
  c.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
  return c;
}

}  // namespace

struct GltfDocument::Buffers {
  tinygltf::Model model;
  std::size_t zeros_left = max_zero_elements;
};

GltfDocument::~GltfDocument() = default;

GltfDocument::GltfDocument(const std::string& bytes, const std::filesystem::path& folder)
    : buffers_(std::make_unique<Buffers>()) {
  if (bytes.size() > largest_file)
    throw InvalidValue("", "a file below 2 GiB", std::to_string(bytes.size()) + " bytes");
  const std::string_view text = json_text(bytes);
  json_ = parse_json(text);  // bounds the nesting, which tinygltf does not
  if (!json_.is_object()) throw InvalidValue("", "a glTF object", shown(json_));
  // A chunk of bytes behind the first has a header of its own.
  check_gltf(json_, bytes.starts_with("glTF") && bytes.size() >= 20 + text.size() + 8);

  const auto changed = with_stand_in_views(bytes, text, json_);
  const std::string& file = changed ? *changed : bytes;
  Files files{folder.empty() ? folder : std::filesystem::absolute(folder)};
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(no_image, nullptr);
  loader.SetFsCallbacks(callbacks(files));
  std::string error, warning;
  bool loaded = false;
  try {
    const auto size = static_cast<unsigned>(file.size());
    const std::string base = files.folder.string();
    loaded = file.starts_with("glTF")
                 ? loader.LoadBinaryFromMemory(&buffers_->model, &error, &warning,
                                               reinterpret_cast<const unsigned char*>(file.data()), size, base)
                 : loader.LoadASCIIFromString(&buffers_->model, &error, &warning, file.data(), size, base);
  } catch (const std::exception& e) {
    error = e.what();
  }
  if (loaded) return;
  check_gltf_buffers(json_, files.missing);
  while (!error.empty() && (error.back() == '\n' || error.back() == ' ')) error.pop_back();
  std::replace(error.begin(), error.end(), '\n', ' ');
  throw InvalidValue("", "a glTF 2.0 scene", "one that cannot be read: " + error);
}

namespace {

/// The corners of a primitive in threes: a list, a strip or a fan.
std::vector<Mesh<double>::Index> corners_of(int mode, const std::vector<std::uint32_t>& order) {
  std::vector<Mesh<double>::Index> triangles;
  if (order.size() < 3) return triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < order.size(); i += 3) triangles.push_back({order[i], order[i + 1], order[i + 2]});
  } else {
    for (std::size_t i = 0; i + 2 < order.size(); ++i) {
      const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN, odd = i % 2 == 1;
      if (fan)
        triangles.push_back({order[0], order[i + 1], order[i + 2]});
      else
        triangles.push_back({order[odd ? i + 1 : i], order[odd ? i : i + 1], order[i + 2]});
    }
  }
  return triangles;
}

/// Checks that triangles have three corners each; `path`: where these are.
void check_corners(int mode, std::size_t count, const std::string& path) {
  if (mode == TINYGLTF_MODE_TRIANGLES && count % 3 != 0)
    throw InvalidValue(path, "three corners for each triangle", std::to_string(count));
}

void append_primitive(const AccessorSource& source, const tinygltf::Primitive& primitive, const std::string& path,
                      TriangleSoup& soup) {
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end())
    throw InvalidValue(path + ".attributes.POSITION", "an accessor", "nothing");
  if (primitive.extensions.count("KHR_draco_mesh_compression") != 0)
    throw InvalidValue(path + ".extensions", "plain triangles", "KHR_draco_mesh_compression, which is not supported");
  const Elements points(source, position->second, TINYGLTF_TYPE_VEC3, path + ".attributes.POSITION");
  if (points.component() != TINYGLTF_COMPONENT_TYPE_FLOAT)
    throw InvalidValue(path + ".attributes.POSITION", "float positions",
                       "component type " + std::to_string(points.component()));
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (std::size_t i = 0; i < points.count(); ++i)
    soup.points.push_back(validate::point(points.vector(i), path + ".POSITION[" + std::to_string(i) + "]"));

  std::vector<std::uint32_t> order;
  if (primitive.indices >= 0) {
    const Elements indices(source, primitive.indices, TINYGLTF_TYPE_SCALAR, path + ".indices");
    check_corners(primitive.mode, indices.count(), path + ".indices");
    for (std::size_t i = 0; i < indices.count(); ++i) {
      const std::uint32_t index = indices.whole(i);
      if (index >= points.count())
        throw InvalidValue(path + ".indices[" + std::to_string(i) + "]",
                           "an index below " + std::to_string(points.count()), std::to_string(index));
      order.push_back(first + index);
    }
  } else {
    check_corners(primitive.mode, points.count(), path + ".attributes.POSITION");
    for (std::size_t i = 0; i < points.count(); ++i) order.push_back(first + static_cast<std::uint32_t>(i));
  }
  const auto triangles = corners_of(primitive.mode, order);
  soup.triangles.insert(soup.triangles.end(), triangles.begin(), triangles.end());
}

}  // namespace

TriangleSoup GltfDocument::triangles(std::size_t mesh, int& skipped) const {
  const tinygltf::Model& model = buffers_->model;
  if (mesh >= model.meshes.size())
    throw InvalidValue("mesh", "an index below " + std::to_string(model.meshes.size()), std::to_string(mesh));
  // Named before the faults that come of it: a compressed mesh has no points of its own.
  if (const auto name = required_of_meshes(JsonValue(json_, "")))
    name->fail("no extension of how meshes are stored, as they are read");
  TriangleSoup soup;
  for (std::size_t i = 0; i < model.meshes[mesh].primitives.size(); ++i) {
    const tinygltf::Primitive& primitive = model.meshes[mesh].primitives[i];
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
      ++skipped;
      continue;
    }
    append_primitive({model, json_, buffers_->zeros_left}, primitive,
                     "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(i) + "]", soup);
  }
  return soup;
}

Elements GltfDocument::elements(const JsonValue& index, std::size_t width) const {
  const std::size_t i = index.whole_number(), count = buffers_->model.accessors.size();
  if (i >= count) index.fail("an index below " + std::to_string(count));
  const int type = width == 4 ? TINYGLTF_TYPE_VEC4 : width == 3 ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_SCALAR;
  return {{buffers_->model, json_, buffers_->zeros_left}, static_cast<int>(i), type, index.path()};
}

}  // namespace graze::io
