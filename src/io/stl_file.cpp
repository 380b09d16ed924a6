#include "io/stl_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "graze/error.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

/// A binary file: 80 bytes for anybody's use and a count; of each triangle a normal, three points and two bytes more.
constexpr std::size_t header_size = 84, count_at = 80, triangle_size = 50, first_point = 12, point_size = 12;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}
double number_at(std::string_view bytes, std::size_t at) {
  const std::uint32_t word = word_at(bytes, at);
  float number;
  std::memcpy(&number, &word, sizeof number);  // not every standard library has `std::bit_cast`
  return static_cast<double>(number);
}

void add_triangle(const std::array<Vec3d, 3>& corners, TriangleSoup& soup) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), corners.begin(), corners.end());
  soup.triangles.push_back({first, first + 1, first + 2});
}

TriangleSoup read_binary(std::string_view bytes, std::uint32_t count) {
  TriangleSoup soup;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Vec3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = header_size + i * triangle_size + first_point + k * point_size;
      for (std::size_t axis = 0; axis < 3; ++axis) corners[k][axis] = number_at(bytes, at + 4 * axis);
      validate::point(corners[k], "triangles[" + std::to_string(i) + "][" + std::to_string(k) + "]");
    }
    add_triangle(corners, soup);
  }
  return soup;
}

/// The three numbers at the end of a line, finite or not; nothing when they are no numbers.
std::optional<Vec3d> vector_in(const Words& words, std::size_t from) {
  Vec3d v;
  if (words.size() != from + 3) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = number_in(words[from + i]);
    if (!value) return std::nullopt;
    v[i] = *value;
  }
  return v;
}

/// Whether coordinates are finite in single precision too, which other programs use.
bool finite_in_single(const Vec3d& v) {
  const Vec3f single = converted<float>(v);
  return std::isfinite(single.x) && std::isfinite(single.y) && std::isfinite(single.z);
}

TriangleSoup read_text(std::string_view text) {
  TriangleSoup soup;
  TextLines lines(text);
  std::array<Vec3d, 3> corners;
  std::size_t count = 0;
  bool within_solid = false;
  const auto facet_ends = [&] {
    if (count != 0) lines.fail("a facet of 3 vertices");
  };
  while (lines.next()) {
    const Words words = lines.words();
    if (words.empty()) continue;
    if (words[0] == "solid" || words[0] == "endsolid") {
      facet_ends();
      within_solid = words[0] == "solid";
    } else if (words[0] == "facet") {
      facet_ends();
      // Programs write normals of triangles without area as nan.
      if (words.size() < 2 || words[1] != "normal" || !vector_in(words, 2)) lines.fail("facet normal and 3 numbers");
    } else if (words[0] == "endfacet" || words[0] == "endloop") {
      facet_ends();
    } else if (words[0] == "vertex") {
      const auto point = vector_in(words, 1);
      if (!point || !finite_in_single(*point)) lines.fail("vertex and 3 finite numbers, in single precision");
      corners[count++] = *point;
      if (count == 3) add_triangle(corners, soup), count = 0;
    }
  }
  if (count != 0) throw InvalidValue("", "facets of 3 vertices", std::to_string(count) + " in the last");
  if (soup.triangles.empty()) throw InvalidValue("", "a mesh with triangles", "no facets");
  if (within_solid) throw InvalidValue(lines.place(), "endsolid behind the last facet", "the end of the file");
  return soup;
}

}  // namespace

TriangleSoup read_stl(std::string_view bytes) {
  const std::uint32_t count = bytes.size() >= header_size ? word_at(bytes, count_at) : 0;
  if (bytes.size() >= header_size && bytes.size() == header_size + triangle_size * std::size_t{count})
    return read_binary(bytes, count);
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t begin = text.find_first_not_of(" \t\r\n\v\f");
  if (begin != std::string_view::npos && text.substr(begin).starts_with("solid")) return read_text(text);
  if (bytes.size() < header_size)
    throw InvalidValue("", "a text that begins with solid, or a binary header of 84 bytes",
                       std::to_string(bytes.size()) + " bytes");
  throw InvalidValue("byte 80",
                     "a count of triangles, 50 bytes each, that fits " + std::to_string(bytes.size()) +
                         " bytes: " + std::to_string((bytes.size() - header_size) / triangle_size),
                     std::to_string(count));
}

}  // namespace graze::io
