#include "io/mesh_text.hpp"

#include <algorithm>
#include <charconv>
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

/// One of an OBJ file's lists that faces point into, counted from 1, or backwards from the face by negative numbers.
struct ObjList {
  const char* name;
  std::size_t count = 0, most = 0, line = 0;  ///< most: the largest index that was named, and where

  bool accepts(std::string_view word, std::size_t at) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || end != word.data() + word.size() || index == 0) return false;
    if (index < 0) return index >= -static_cast<std::int64_t>(count);
    if (static_cast<std::size_t>(index) > most) {
      most = static_cast<std::size_t>(index);
      line = at;
    }
    return true;
  }
  /// A face may stand before its points.
  void finish() const {
    if (most > count)
      throw InvalidValue("line " + std::to_string(line),
                         "the index of one of the " + std::to_string(count) + " " + name, std::to_string(most));
  }
};

struct ObjCheck {
  ObjList points{"points (v)"}, textures{"texture coordinates (vt)"}, normals{"normals (vn)"};

  /// `point`, `point/texture`, `point//normal` or `point/texture/normal`.
  bool corner(std::string_view word, std::size_t line) {
    ObjList* const lists[] = {&points, &textures, &normals};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t end = word.find('/');
      const std::string_view part = word.substr(0, end);
      if ((i == 0 || !part.empty()) && !lists[i]->accepts(part, line)) return false;
      if (end == std::string_view::npos) return true;
      word.remove_prefix(end + 1);
    }
    return false;
  }
};

}  // namespace

void check_obj(std::string_view text) {
  ObjCheck check;
  TextLines lines(text);
  bool faces = false;
  while (lines.next_joined()) {
    const Words words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "v") {
      const std::size_t count = words.size() - 1;
      if ((count != 3 && count != 4 && count != 6) || !finite_numbers(words))
        lines.fail("v and 3 finite numbers (or 4 with a weight, or 6 with a colour), in single precision");
      if (count == 4 && number_in(words[4]) == 0.0) lines.fail("a weight that is not zero");
      ++check.points.count;
    } else if (words[0] == "vn") {
      if (words.size() != 4 || !numbers(words, 1)) lines.fail("vn and 3 numbers");
      ++check.normals.count;
    } else if (words[0] == "vt") {
      if (words.size() < 2 || words.size() > 4 || !numbers(words, 1)) lines.fail("vt and 1 to 3 numbers");
      ++check.textures.count;
    } else if (words[0] == "f" || words[0] == "l" || words[0] == "p") {
      faces = faces || words[0] == "f";
      for (std::size_t i = 1; i < words.size(); ++i)
        if (!check.corner(words[i], lines.line()))
          throw InvalidValue(lines.place(),
                             "corners of a face, line or point: indices from 1 to " +
                                 std::to_string(check.points.count) +
                                 ", or backwards from -1, as 1, 1/1, 1//1 or 1/1/1",
                             quoted(words[i]));
    }
  }
  for (const ObjList* list : {&check.points, &check.textures, &check.normals}) list->finish();
  if (!faces) throw InvalidValue("", "a mesh with triangles", "a file without faces (lines that begin with f)");
}

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
