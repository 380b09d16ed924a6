// glTF files of tests, which live in a string: buffers as data URIs, and what a file is refused for.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "graze/io/scene.hpp"

namespace graze::io {

/// The bytes in base64, as the uri of a buffer.
inline std::string data_uri(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:application/octet-stream;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// What loading the file is refused with, or "loaded".
inline std::string gltf_refusal(const std::string& file, const LoadOptions& options = {}) {
  try {
    load_gltf(file, "test.gltf", options);
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "loaded";
}
inline std::string gltf_refusal(const nlohmann::json& file) { return gltf_refusal(file.dump()); }

}  // namespace graze::io
