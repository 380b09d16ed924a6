#include "io/obj_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "draw/cut_polygon.hpp"
#include "graze/error.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

/// The most corners of a polygon. Cutting it takes time that grows with their square: 1024 take some milliseconds.
constexpr std::size_t most_face_corners = 1024;

/// The numbers of a line behind its first word, at least `least` and at most `most` of them; nothing for another line.
std::optional<std::vector<double>> numbers_of(const Words& words, std::size_t least, std::size_t most) {
  if (words.size() < least + 1 || words.size() > most + 1) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto value = number_in(words[i]);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

/// One of a file's lists into which faces point, counted from 1, or backwards from the face by negative numbers.
struct ObjList {
  const char* name;
  std::size_t count = 0, most = 0, line = 0;  ///< most: the largest index that was named, and where

  /// The place in the list, from 0 on, that a word on line `at` names.
  std::optional<std::uint32_t> place(std::string_view word, std::size_t at) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || end != word.data() + word.size() || index == 0) return std::nullopt;
    if (index < 0) {
      const std::int64_t from_end = static_cast<std::int64_t>(count) + index;
      return from_end >= 0 ? std::optional(static_cast<std::uint32_t>(from_end)) : std::nullopt;
    }
    if (static_cast<std::size_t>(index) > most) {
      most = static_cast<std::size_t>(index);
      line = at;
    }
    return static_cast<std::uint32_t>(index - 1);
  }
  /// Checks the indices at the end, as a face may stand before its points.
  void finish() const {
    if (most > count)
      throw InvalidValue("line " + std::to_string(line),
                         "the index of one of the " + std::to_string(count) + " " + name, std::to_string(most));
  }
};

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : lines_(text) {}

  TriangleSoup read() {
    while (lines_.next_joined()) {
      const Words words = lines_.words();
      if (words.empty()) continue;
      if (words[0] == "v") read_point(words);
      if (words[0] == "vn") count(normals_, numbers_of(words, 3, 3).has_value(), "vn and 3 numbers");
      if (words[0] == "vt") count(textures_, numbers_of(words, 1, 3).has_value(), "vt and 1 to 3 numbers");
      if (words[0] == "f" || words[0] == "l" || words[0] == "p") read_corners(words);
    }
    for (const ObjList* list : {&points_, &textures_, &normals_}) list->finish();
    if (!faces_) throw InvalidValue("", "a mesh with triangles", "a file without faces (lines that begin with f)");
    return soup_of_faces();
  }

 private:
  void read_point(const Words& words) {
    const auto values = numbers_of(words, 3, 6);
    // A coordinate has to be a number in single precision too, which other programs use.
    const auto finite = [](double v) { return std::isfinite(static_cast<float>(v)); };
    if (!values || values->size() == 5 || !std::all_of(values->begin(), values->end(), finite))
      lines_.fail("v and 3 finite numbers (or 4 with a weight, or 6 with a colour), in single precision");
    const Vec3d p{(*values)[0], (*values)[1], (*values)[2]};
    const double weight = values->size() == 4 ? (*values)[3] : 1;
    if (weight == 0) lines_.fail("a weight that is not zero");
    ++points_.count;
    positions_.push_back(validate::point(p / weight, lines_.place()));
  }

  void count(ObjList& list, bool right, const char* expectation) {
    if (!right) lines_.fail(expectation);
    ++list.count;
  }

  /// The point of a corner: `point`, `point/texture`, `point//normal` or `point/texture/normal`.
  std::optional<std::uint32_t> corner(std::string_view word) {
    ObjList* const lists[] = {&points_, &textures_, &normals_};
    std::optional<std::uint32_t> point;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t end = word.find('/');
      const std::string_view part = word.substr(0, end);
      if (i == 0 || !part.empty()) {
        const auto place = lists[i]->place(part, lines_.line());
        if (!place) return std::nullopt;
        if (i == 0) point = place;
      }
      if (end == std::string_view::npos) return point;
      word.remove_prefix(end + 1);
    }
    return std::nullopt;
  }

  /// Reads the corners of a face. Those of lines and points (`l`, `p`) are checked and left.
  void read_corners(const Words& words) {
    const bool face = words[0] == "f";
    faces_ = faces_ || face;
    if (face && words.size() > most_face_corners + 1)
      throw InvalidValue(lines_.place(), "a face of at most " + std::to_string(most_face_corners) + " corners",
                         std::to_string(words.size() - 1));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto point = corner(words[i]);
      if (!point)
        throw InvalidValue(lines_.place(),
                           "corners of a face, line or point: indices from 1 to " + std::to_string(points_.count) +
                               ", or backwards from -1, as 1, 1/1, 1//1 or 1/1/1",
                           quoted(words[i]));
      if (face) corners_.push_back(*point);
    }
    if (face) face_ends_.push_back(corners_.size());
  }

  TriangleSoup soup_of_faces() {
    constexpr std::uint32_t unused = 0xffffffffu;
    std::vector<std::uint32_t> numbers(positions_.size(), unused);
    TriangleSoup soup;
    for (std::uint32_t& point : corners_) {
      if (numbers[point] == unused) {
        numbers[point] = static_cast<std::uint32_t>(soup.points.size());
        soup.points.push_back(positions_[point]);
      }
      point = numbers[point];
    }
    std::size_t begin = 0;
    for (const std::size_t end : face_ends_) {
      cut_polygon(soup.points, std::span(corners_).subspan(begin, end - begin), soup.triangles);
      begin = end;
    }
    return soup;
  }

  TextLines lines_;
  ObjList points_{"points (v)"}, textures_{"texture coordinates (vt)"}, normals_{"normals (vn)"};
  std::vector<Vec3d> positions_;
  std::vector<std::uint32_t> corners_;  ///< of all faces, by the points' places in the file
  std::vector<std::size_t> face_ends_;  ///< in these
  bool faces_ = false;
};

}  // namespace

TriangleSoup read_obj(std::string_view text) { return ObjReader(text).read(); }

}  // namespace graze::io
