#include "io/gltf_model.hpp"

#include <tiny_gltf.h>

#include <array>
#include <cstring>
#include <optional>

#include "graze/io/file.hpp"
#include "io/gltf_document.hpp"

namespace graze::io {

namespace {

using Bytes = std::vector<unsigned char>;

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

/// The lists that things are added to.
constexpr const char* added_lists[] = {"accessors", "animations", "buffers", "bufferViews",
                                       "materials", "meshes",     "nodes"};

std::optional<Bytes> read_bytes(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  Bytes bytes((std::istreambuf_iterator<char>(in)), {});
  if (!in.good() && !in.eof()) return std::nullopt;
  return bytes;
}

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

/// The binary chunk of a .glb whose header and first chunk are known to be right; empty without one.
std::span<const unsigned char> chunk_of(const Bytes& bytes) {
  if (bytes.size() < 20 || std::memcmp(bytes.data(), "glTF", 4) != 0) return {};
  const std::size_t at = std::size_t{20} + word(bytes, 12);
  if (at > bytes.size() || bytes.size() - at < 8 || word(bytes, at + 4) != binary_chunk) return {};
  return std::span(bytes).subspan(at + 8, std::min<std::size_t>(word(bytes, at), bytes.size() - at - 8));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string percent_decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
    text += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
    if (low >= 0) i += 2;
  }
  return text;
}

std::optional<Bytes> resource(const std::filesystem::path& folder, const std::string& uri) {
  const auto file = file_below(folder, uri);
  return file ? read_bytes(*file) : std::nullopt;
}

std::string base64(const Bytes& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < n ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The kind of a picture by its first bytes: its file's name may lie. Empty when unknown.
std::string picture_type(const Bytes& bytes) {
  const std::string head(bytes.begin(),
                         bytes.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(12, bytes.size())));
  if (head.starts_with("\x89PNG")) return "image/png";
  if (head.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (head.starts_with("\xabKTX 20")) return "image/ktx2";
  if (head.starts_with("RIFF") && head.ends_with("WEBP")) return "image/webp";
  if (head.starts_with("DDS ")) return "image/vnd-ms.dds";
  return "";
}

std::string string_at(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

/// A list of the file, made if it is not there.
Json& list_at(Json& object, const char* key) {
  Json& list = object[key];
  if (list.is_null()) list = Json::array();
  if (!list.is_array()) throw InvalidValue(key, "a list", shown(list));
  return list;
}

/// The nodes that are no node's child.
Json root_nodes(const Json& nodes) {
  std::vector<char> child(nodes.size(), 0);
  for (const Json& node : nodes)
    for (const Json& c : node.value("children", Json::array()))
      if (c.is_number_unsigned() && c.get<std::size_t>() < child.size()) child[c.get<std::size_t>()] = 1;
  Json roots = Json::array();
  for (std::size_t i = 0; i < child.size(); ++i)
    if (!child[i]) roots.push_back(i);
  return roots;
}

/// Numbers of four bytes each.
std::string words(std::initializer_list<std::size_t> values) {
  std::string bytes;
  for (const std::size_t value : values) {
    const auto v = static_cast<std::uint32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&v), 4);
  }
  return bytes;
}

}  // namespace

std::optional<std::filesystem::path> file_below(const std::filesystem::path& folder, const std::string& uri) {
  if (uri.starts_with("data:")) return std::nullopt;
  const auto file = (folder / percent_decoded(uri)).lexically_normal();
  const auto inner = file.lexically_relative(folder.lexically_normal());
  if (inner.empty() || *inner.begin() == "..") return std::nullopt;
  return file;
}

GltfModel::GltfModel() : json_{{"asset", {{"version", "2.0"}, {"generator", "graze"}}}} { shown_scene(); }

GltfModel::GltfModel(const std::filesystem::path& file) {
  open_file(file);  // throws with its name if it is not there
  const auto bytes = read_bytes(file);
  if (!bytes) throw InvalidValue(file.string(), "", "not a regular file");
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  try {
    json_ = GltfDocument(std::string(bytes->begin(), bytes->end()), folder).json();
    embed_buffers(folder, chunk_of(*bytes));
    embed_images(folder);
    // Lists that are added to later are made now: a fault of the file is named with the file.
    for (const char* list : added_lists) list_at(json_, list);
    list_at(shown_scene(), "nodes");
  } catch (const Json::exception& e) {
    throw InvalidValue(file.string(), "a glTF 2.0 scene", std::string("another: ") + e.what());
  } catch (const InvalidValue& e) {
    throw InvalidValue(file.string() + (e.path().empty() ? "" : ": " + e.path()), e.expectation(), e.found());
  }
}

/// Moves the buffers into the file. The first becomes the bytes of the .glb, which keeps all indices; others stay or
/// become text.
void GltfModel::embed_buffers(const std::filesystem::path& folder, std::span<const unsigned char> chunk) {
  Json& buffers = list_at(json_, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string uri = string_at(buffers[i], "uri");
    const bool text = uri.starts_with("data:");
    if (i > 0 && (uri.empty() || text)) continue;
    Bytes bytes;
    std::string type;
    if (uri.empty()) {
      bytes.assign(chunk.begin(), chunk.end());
    } else if (text) {
      tinygltf::DecodeDataURI(&bytes, type, uri, 0, false);
    } else if (auto read = resource(folder, uri)) {
      bytes = std::move(*read);
    }
    const auto length = buffers[i].value("byteLength", std::size_t{0});
    if (bytes.size() < length)
      throw InvalidValue("buffers[" + std::to_string(i) + "]", std::to_string(length) + " bytes",
                         std::to_string(bytes.size()));
    bytes.resize(length);  // a chunk may be padded
    if (i == 0) {
      data_ = std::move(bytes);
      buffers[i].erase("uri");
    } else {
      buffers[i]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    }
  }
}

/// Moves pictures in files of their own into the .glb; nothing is decoded.
void GltfModel::embed_images(const std::filesystem::path& folder) {
  if (!json_.contains("images")) return;
  for (Json& image : list_at(json_, "images")) {
    const std::string uri = string_at(image, "uri");
    if (uri.empty() || uri.starts_with("data:")) continue;
    const auto bytes = resource(folder, uri);
    const std::string type = bytes ? picture_type(*bytes) : "";
    if (type.empty()) {
      notices_.push_back("picture " + uri + " is " +
                         (bytes ? "of an unknown kind" : "not a file below the scene's folder") +
                         ": it stays outside of the written file");
      continue;
    }
    image.erase("uri");
    image["mimeType"] = type;
    image["bufferView"] = add_view(*bytes);
  }
}

bool GltfModel::has_mesh(int node) const {
  const auto nodes = json_.find("nodes");
  if (node < 0 || nodes == json_.end() || static_cast<std::size_t>(node) >= nodes->size()) return false;
  return (*nodes)[static_cast<std::size_t>(node)].contains("mesh");
}

std::size_t GltfModel::add(const char* list, Json element) {
  Json& elements = list_at(json_, list);
  elements.push_back(std::move(element));
  return elements.size() - 1;
}

std::size_t GltfModel::add_view(std::span<const unsigned char> bytes, int target) {
  Json& buffers = list_at(json_, "buffers");
  if (buffers.empty()) buffers.push_back(Json::object());
  data_.resize((data_.size() + 3) / 4 * 4);  // accessors must begin at a multiple of their components' size
  const std::size_t begin = data_.size();
  data_.insert(data_.end(), bytes.begin(), bytes.end());
  buffers[0]["byteLength"] = data_.size();
  Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  return add("bufferViews", std::move(view));
}

/// The scene that is shown. A file without scenes shows every node, as the loader reads it; one that gets a scene must
/// list them.
Json& GltfModel::shown_scene() {
  Json& scenes = list_at(json_, "scenes");
  if (scenes.empty()) {
    scenes.push_back({{"nodes", root_nodes(list_at(json_, "nodes"))}});
    json_["scene"] = 0u;
  }
  const Json index = json_.value("scene", Json(0u));
  if (!index.is_number_unsigned() || index.get<std::size_t>() >= scenes.size())
    throw InvalidValue("scene", "an index below " + std::to_string(scenes.size()), shown(index));
  return scenes[index.get<std::size_t>()];
}

std::size_t GltfModel::add_root(Json node) {
  const std::size_t index = add("nodes", std::move(node));
  list_at(shown_scene(), "nodes").push_back(index);
  return index;
}

void GltfModel::move_node(std::size_t index, std::optional<std::size_t> parent) {
  const auto leave = [&](Json& owner, const char* key) {
    if (!owner.is_object() || !owner.contains(key)) return;
    Json& list = owner[key];
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i] == Json(index)) {
        list.erase(i);
        break;
      }
    if (list.empty()) owner.erase(key);
  };
  for (Json& node : list_at(json_, "nodes")) leave(node, "children");
  for (Json& scene : list_at(json_, "scenes")) leave(scene, "nodes");
  list_at(parent ? node(*parent) : shown_scene(), parent ? "children" : "nodes").push_back(index);
}

/// The JSON without empty lists, which the format does not have.
Json GltfModel::without_empty_lists() const {
  Json json = json_;
  for (const char* list : added_lists)
    if (json.contains(list) && json[list].empty()) json.erase(list);
  if (json.contains("scenes"))
    for (Json& scene : json["scenes"])
      if (scene.contains("nodes") && scene["nodes"].empty()) scene.erase("nodes");
  return json;
}

std::string GltfModel::text() const {
  Json json = without_empty_lists();
  if (!data_.empty()) json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(data_);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void GltfModel::save(const std::filesystem::path& file) const {
  if (std::string ending = file.extension().string(); ending.size() == 5 && (ending.back() | 0x20) == 'f')
    return write_file(file, text());
  std::string text = without_empty_lists().dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string binary(data_.begin(), data_.end());
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const std::size_t size = 20 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
  if (size >> 32 != 0) throw InvalidValue(file.string(), "a file below 4 GiB", std::to_string(size) + " bytes");

  const std::string head = "glTF" + words({2, size, text.size(), json_chunk});
  const std::string binary_head = binary.empty() ? "" : words({binary.size(), binary_chunk});
  write_file(file, std::array<std::string_view, 4>{head, text, binary_head, binary});
}

}  // namespace graze::io
