#include "graze/io/gltf_files.hpp"

#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "io/gltf_model.hpp"

namespace graze::io {

std::vector<std::filesystem::path> buffer_files(const std::filesystem::path& scene) {
  std::vector<std::filesystem::path> files;
  try {
    std::ifstream in = open_file(scene);
    const Json json = Json::parse(in, nullptr, false);
    const auto buffers = json.is_object() ? json.find("buffers") : json.end();
    if (buffers == json.end() || !buffers->is_array()) return files;
    for (const Json& buffer : *buffers) {
      const auto uri = buffer.is_object() ? buffer.find("uri") : buffer.end();
      if (uri == buffer.end() || !uri->is_string()) continue;
      if (const auto file = file_below(std::filesystem::absolute(scene).parent_path(), uri->get<std::string>()))
        files.push_back(*file);
    }
  } catch (const InvalidValue&) {
    // A file that cannot be opened names none.
  }
  return files;
}

std::string whole_gltf(const std::filesystem::path& scene) { return GltfModel(scene).text(); }

}  // namespace graze::io
