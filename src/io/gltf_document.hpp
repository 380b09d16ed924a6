// A glTF file opened: its JSON, and its buffers through tinygltf.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/gltf_accessor.hpp"
#include "io/json_value.hpp"
#include "io/triangle_soup.hpp"

namespace graze::io {

class GltfDocument {
 public:
  /// `folder`: where buffers in files of their own may be read from; empty to read none. Throws `InvalidValue`.
  GltfDocument(const std::string& bytes, const std::filesystem::path& folder);
  ~GltfDocument();

  const Json& json() const { return json_; }
  /// The triangles of a mesh; other primitives are left out and counted in `skipped`.
  TriangleSoup triangles(std::size_t mesh, int& skipped) const;
  /// The elements of the accessor that `index` names, of `width` components each: 1, 3 or 4. They live as long as this.
  Elements elements(const JsonValue& index, std::size_t width) const;

 private:
  struct Buffers;
  Json json_;
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace graze::io
