#include "io/mesh_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "graze/error.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

/// assimp holds numbers in single precision.
bool finite_numbers(const Words& words) {
  return std::all_of(words.begin() + 1, words.end(), [](std::string_view word) {
    const auto value = number_in(word);
    return value && std::isfinite(static_cast<float>(*value));
  });
}

/// What is not used may be no number: programs write normals of triangles without area as nan.
bool numbers(const Words& words, std::size_t from) {
  return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(from), words.end(),
                     [](std::string_view word) { return number_in(word).has_value(); });
}

}  // namespace

void check_stl(std::string_view bytes) {
  constexpr std::size_t header = 84, triangle = 50;
  std::uint32_t count = 0;
  if (bytes.size() >= header) std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() >= header && bytes.size() == header + triangle * std::size_t{count}) return;

  const std::size_t begin = bytes.find_first_not_of(" \t\r\n\v\f");
  if (begin == std::string_view::npos || !bytes.substr(begin).starts_with("solid")) {
    if (bytes.size() < header)
      throw InvalidValue("", "a text that begins with solid, or a binary header of 84 bytes",
                         std::to_string(bytes.size()) + " bytes");
    throw InvalidValue("byte 80",
                       "a count of triangles, 50 bytes each, that fits " + std::to_string(bytes.size()) +
                           " bytes: " + std::to_string((bytes.size() - header) / triangle),
                       std::to_string(count));
  }
  TextLines lines(bytes);
  std::size_t corners = 0;
  while (lines.next()) {
    const Words words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "facet" && (words.size() != 5 || words[1] != "normal" || !numbers(words, 2)))
      lines.fail("facet normal and 3 numbers");
    if (words[0] != "vertex") continue;
    if (words.size() != 4 || !finite_numbers(words)) lines.fail("vertex and 3 finite numbers, in single precision");
    ++corners;
  }
  if (corners < 3) throw InvalidValue("", "a mesh with triangles", std::to_string(corners) + " vertices");
}

}  // namespace graze::io
