#include "io/gltf_document.hpp"

#include <tiny_gltf.h>

#include <cstring>
#include <fstream>

namespace graze::io {

namespace {

/// No scene or buffer file is larger; what says that it is is not read.
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

bool no_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;  // pictures are for renderers
}

/// Buffers may be read from below the scene's folder only.
struct Files {
  std::filesystem::path folder;

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
    return static_cast<Files*>(user)->allowed(name) && std::filesystem::is_regular_file(name, ignored);
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
};

GltfDocument::~GltfDocument() = default;

GltfDocument::GltfDocument(const std::string& bytes, const std::filesystem::path& folder)
    : buffers_(std::make_unique<Buffers>()) {
  if (bytes.size() > largest_file)
    throw InvalidValue("", "a file below 2 GiB", std::to_string(bytes.size()) + " bytes");
  const std::string_view text = json_text(bytes);
  json_ = parse_json(text);  // bounds the nesting, which tinygltf does not
  if (!json_.is_object()) throw InvalidValue("", "a glTF object", shown(json_));

  Files files{folder.empty() ? folder : std::filesystem::absolute(folder)};
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(no_image, nullptr);
  loader.SetFsCallbacks(callbacks(files));
  std::string error, warning;
  bool loaded = false;
  try {
    const auto size = static_cast<unsigned>(bytes.size());
    const std::string base = files.folder.string();
    loaded = bytes.starts_with("glTF")
                 ? loader.LoadBinaryFromMemory(&buffers_->model, &error, &warning,
                                               reinterpret_cast<const unsigned char*>(bytes.data()), size, base)
                 : loader.LoadASCIIFromString(&buffers_->model, &error, &warning, bytes.data(), size, base);
  } catch (const std::exception& e) {
    error = e.what();
  }
  while (!error.empty() && (error.back() == '\n' || error.back() == ' ')) error.pop_back();
  if (!loaded) throw InvalidValue("", "a glTF 2.0 scene", "one that cannot be read: " + error);
}

namespace {

/// The bytes of an accessor, every bound checked.
class Elements {
 public:
  Elements(const tinygltf::Model& model, int index, int wanted_type, const std::string& path) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
      throw InvalidValue(path, "an index below " + std::to_string(model.accessors.size()), std::to_string(index));
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::string name = "accessors[" + std::to_string(index) + "]";
    if (accessor.type != wanted_type)
      throw InvalidValue(name + ".type", wanted_type == TINYGLTF_TYPE_VEC3 ? "\"VEC3\"" : "\"SCALAR\"", "another");
    if (accessor.sparse.isSparse) throw InvalidValue(name + ".sparse", "nothing (not supported)", "a sparse accessor");
    component_ = accessor.componentType;
    count_ = accessor.count;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_));
    if (size <= 0) throw InvalidValue(name + ".componentType", "a component type of glTF", std::to_string(component_));
    element_ = static_cast<std::size_t>(size) * (wanted_type == TINYGLTF_TYPE_VEC3 ? 3 : 1);
    const std::string view_name = name + ".bufferView";
    if (accessor.bufferView < 0 || static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size())
      throw InvalidValue(view_name, "an index below " + std::to_string(model.bufferViews.size()),
                         std::to_string(accessor.bufferView));
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
      throw InvalidValue(view_name + ".buffer", "an index below " + std::to_string(model.buffers.size()),
                         std::to_string(view.buffer));
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    stride_ = view.byteStride != 0 ? view.byteStride : element_;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
      throw InvalidValue(view_name, "a range within the " + std::to_string(data.size()) + " bytes of its buffer",
                         std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength));
    // count elements end at offset + (count - 1) stride + element; by division, since the product may overflow.
    const std::size_t room = view.byteLength;
    const bool fits = count_ == 0 || (accessor.byteOffset <= room && element_ <= room - accessor.byteOffset &&
                                      (count_ - 1) <= (room - accessor.byteOffset - element_) / stride_);
    if (!fits) throw InvalidValue(name + ".count", "as many elements as its buffer view holds", std::to_string(count_));
    begin_ = data.data() + view.byteOffset + accessor.byteOffset;
  }

  std::size_t count() const { return count_; }
  int component() const { return component_; }

  Vec3d vector(std::size_t i) const {
    float v[3];
    std::memcpy(v, begin_ + i * stride_, sizeof v);
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  }
  std::uint32_t whole(std::size_t i) const {
    const unsigned char* at = begin_ + i * stride_;
    if (element_ == 1) return *at;
    std::uint16_t half = 0;
    std::uint32_t full = 0;
    if (element_ == 2) return std::memcpy(&half, at, 2), half;
    return std::memcpy(&full, at, 4), full;
  }

 private:
  const unsigned char* begin_ = nullptr;
  std::size_t count_ = 0, stride_ = 0, element_ = 0;
  int component_ = 0;
};

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

void append_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& path,
                      TriangleSoup& soup) {
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end())
    throw InvalidValue(path + ".attributes.POSITION", "an accessor", "nothing");
  if (primitive.extensions.count("KHR_draco_mesh_compression") != 0)
    throw InvalidValue(path + ".extensions", "plain triangles", "KHR_draco_mesh_compression, which is not supported");
  const Elements points(model, position->second, TINYGLTF_TYPE_VEC3, path + ".attributes.POSITION");
  if (points.component() != TINYGLTF_COMPONENT_TYPE_FLOAT)
    throw InvalidValue(path + ".attributes.POSITION", "float positions",
                       "component type " + std::to_string(points.component()));
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (std::size_t i = 0; i < points.count(); ++i)
    soup.points.push_back(validate::point(points.vector(i), path + ".POSITION[" + std::to_string(i) + "]"));

  std::vector<std::uint32_t> order;
  if (primitive.indices >= 0) {
    const Elements indices(model, primitive.indices, TINYGLTF_TYPE_SCALAR, path + ".indices");
    for (std::size_t i = 0; i < indices.count(); ++i) {
      const std::uint32_t index = indices.whole(i);
      if (index >= points.count())
        throw InvalidValue(path + ".indices[" + std::to_string(i) + "]",
                           "an index below " + std::to_string(points.count()), std::to_string(index));
      order.push_back(first + index);
    }
  } else {
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
  TriangleSoup soup;
  for (std::size_t i = 0; i < model.meshes[mesh].primitives.size(); ++i) {
    const tinygltf::Primitive& primitive = model.meshes[mesh].primitives[i];
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
      ++skipped;
      continue;
    }
    append_primitive(model, primitive, "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(i) + "]",
                     soup);
  }
  return soup;
}

}  // namespace graze::io
