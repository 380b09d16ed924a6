#include "io/ply_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "draw/cut_polygon.hpp"
#include "graze/detail/validate.hpp"
#include "io/text_lines.hpp"

namespace graze::io {

namespace {

/// The most corners of a polygon. Cutting it takes time that grows with their square: 1024 take some milliseconds.
constexpr std::size_t most_corners = 1024;
/// The mark between two triangle strips, -1 in the file.
constexpr std::uint32_t strip_end = 0xffffffffu;

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string name;
  std::size_t count;
  std::vector<Property> properties;
};

std::size_t size_of(Type type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Type type_of(std::string_view word, const std::string& place) {
  static constexpr std::pair<std::string_view, Type> names[] = {
      {"char", Type::int8},   {"uchar", Type::uint8},   {"short", Type::int16},     {"ushort", Type::uint16},
      {"int", Type::int32},   {"uint", Type::uint32},   {"float", Type::float32},   {"double", Type::float64},
      {"int8", Type::int8},   {"uint8", Type::uint8},   {"int16", Type::int16},     {"uint16", Type::uint16},
      {"int32", Type::int32}, {"uint32", Type::uint32}, {"float32", Type::float32}, {"float64", Type::float64}};
  for (const auto& [name, type] : names)
    if (word == name) return type;
  throw InvalidValue(place, "one of the types char, uchar, short, ushort, int, uint, float, double", quoted(word));
}

template <class V>
double loaded(const char* at, bool swapped) {
  char bytes[sizeof(V)];
  std::memcpy(bytes, at, sizeof(V));
  if (swapped) std::reverse(bytes, bytes + sizeof(V));
  V value;
  std::memcpy(&value, bytes, sizeof(V));
  return static_cast<double>(value);
}

class PlyReader {
 public:
  explicit PlyReader(std::string_view bytes) : lines_(bytes) {}

  TriangleSoup run() {
    read_header();
    body_ = lines_.rest();
    for (const Element& element : elements_) read_element(element);
    return triangles();
  }

 private:
  void read_header() {
    if (!lines_.next() || lines_.words() != Words{"ply"}) lines_.fail("ply");
    bool formatted = false;
    while (lines_.next()) {
      const Words words = lines_.words();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words == Words{"end_header"}) {
        if (!formatted) lines_.fail("a line with the format before it");
        return;
      }
      if (words[0] == "format" && words.size() == 3) {
        formatted = true;
        ascii_ = words[1] == "ascii";
        big_ = words[1] == "binary_big_endian";
        if (!ascii_ && !big_ && words[1] != "binary_little_endian")
          lines_.fail("format ascii, binary_little_endian or binary_big_endian");
      } else if (words[0] == "element" && words.size() == 3) {
        elements_.push_back({std::string(words[1]), lines_.whole(words[2]), {}});
      } else if (words[0] == "property" && words.size() == 3 && !elements_.empty()) {
        elements_.back().properties.push_back({std::string(words[2]), type_of(words[1], lines_.place()), {}});
      } else if (words[0] == "property" && words.size() == 5 && words[1] == "list" && !elements_.empty()) {
        elements_.back().properties.push_back(
            {std::string(words[4]), type_of(words[3], lines_.place()), type_of(words[2], lines_.place())});
      } else {
        lines_.fail("a line of a PLY header: format, element, property, comment, obj_info or end_header");
      }
    }
    throw InvalidValue("", "a PLY header that ends with end_header", "the end of the file");
  }

  void read_element(const Element& element) {
    std::size_t least = 0;
    for (const Property& p : element.properties) least += smallest(p.count ? *p.count : p.type);
    // The last number of a text needs nothing behind it.
    const std::size_t room = body_.size() - at_ + (ascii_ ? 1 : 0);
    if (element.count > 0 && (least == 0 || element.count > room / least))
      throw InvalidValue("element " + element.name,
                         "at most the " + std::to_string(least == 0 ? 0 : room / least) +
                             " that the rest of the file has room for",
                         std::to_string(element.count));
    if (element.name == "vertex") find_coordinates(element);
    for (std::size_t i = 0; i < element.count; ++i) read_instance(element, i);
  }

  std::size_t smallest(Type type) const { return ascii_ ? 2 : size_of(type); }

  void find_coordinates(const Element& element) const {
    for (const char* name : {"x", "y", "z"})
      if (std::none_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) { return p.name == name && !p.count; }))
        throw InvalidValue("element vertex", "the properties x, y and z", std::string("no ") + name);
  }

  void read_instance(const Element& element, std::size_t i) {
    const bool vertex = element.name == "vertex", strips = element.name == "tristrips";
    Vec3d point{};
    for (const Property& p : element.properties) {
      if (p.count) {
        const bool corners = p.name == "vertex_indices" || p.name == "vertex_index";
        read_list(element, p, i, corners && (strips || element.name == "face") ? (strips ? 's' : 'f') : 0);
        continue;
      }
      const double value = number(p.type);
      const std::size_t axis = p.name == "x" ? 0 : p.name == "y" ? 1 : p.name == "z" ? 2 : 3;
      if (!vertex || axis == 3) continue;
      if (const char* expectation = validate::fault_of_coordinate(value))
        fail(element, i, p, expectation, validate::number(value));
      point[axis] = value;
    }
    if (vertex) soup_.points.push_back(point);
  }

  void read_list(const Element& element, const Property& p, std::size_t i, char kind) {
    const double length = number(*p.count);
    const std::size_t room = (body_.size() - at_ + (ascii_ ? 1 : 0)) / smallest(p.type);
    if (!(length >= 0) || length != std::floor(length) || length > static_cast<double>(room))
      fail(element, i, p,
           "a list of at most the " + std::to_string(room) + " numbers that the rest of the file has room for",
           "one of " + validate::number(length));
    const auto count = static_cast<std::size_t>(length);
    if (kind == 'f' && count > most_corners)
      fail(element, i, p, "a face of at most " + std::to_string(most_corners) + " corners", std::to_string(count));
    for (std::size_t k = 0; k < count; ++k) {
      const double index = number(p.type);
      if (kind == 0) continue;
      const bool ends = kind == 's' && index == -1;
      if (!ends && !(index >= 0 && index < strip_end && index == std::floor(index)))
        fail(element, i, p, "indices >= 0", validate::number(index));
      corners_.push_back(ends ? strip_end : static_cast<std::uint32_t>(index));
    }
    if (kind == 0) return;
    if (count >= 3)
      lists_.push_back({corners_.size() - count, count, i, kind == 's'});
    else
      corners_.resize(corners_.size() - count);  // a line or a point
  }

  [[noreturn]] void fail(const Element& element, std::size_t i, const Property& p, const std::string& expectation,
                         const std::string& found) const {
    throw InvalidValue((ascii_ ? line() + ": " : "") + element.name + "[" + std::to_string(i) + "]." + p.name,
                       expectation, found);
  }

  /// The line of the body's last number.
  std::string line() const { return "line " + std::to_string(lines_.line() + 1 + line_ends_); }

  double number(Type type) {
    if (ascii_) return text_number();
    const std::size_t size = size_of(type);
    if (body_.size() - at_ < size)
      throw InvalidValue("byte " + std::to_string(body_.size()), "a number of " + std::to_string(size) + " bytes",
                         "the end of the file");
    const char* from = body_.data() + at_;
    at_ += size;
    const bool swapped = big_ != (std::endian::native == std::endian::big);
    switch (type) {
    case Type::int8: return loaded<std::int8_t>(from, swapped);
    case Type::uint8: return loaded<std::uint8_t>(from, swapped);
    case Type::int16: return loaded<std::int16_t>(from, swapped);
    case Type::uint16: return loaded<std::uint16_t>(from, swapped);
    case Type::int32: return loaded<std::int32_t>(from, swapped);
    case Type::uint32: return loaded<std::uint32_t>(from, swapped);
    case Type::float32: return loaded<float>(from, swapped);
    default: return loaded<double>(from, swapped);
    }
  }

  double text_number() {
    for (; at_ < body_.size() && is_space(body_[at_]); ++at_) line_ends_ += body_[at_] == '\n' ? 1 : 0;
    const std::size_t begin = at_;
    while (at_ < body_.size() && !is_space(body_[at_])) ++at_;
    const std::string_view word = body_.substr(begin, at_ - begin);
    const auto value = number_in(word);
    if (!value) throw InvalidValue(line(), "a number", word.empty() ? "the end of the file" : quoted(word));
    return *value;
  }

  TriangleSoup triangles() {
    const std::span<const std::uint32_t> corners(corners_);
    for (const List& list : lists_) {
      const auto loop = corners.subspan(list.begin, list.count);
      for (std::size_t k = 0; k < loop.size(); ++k)
        if (loop[k] >= soup_.points.size() && !(list.strip && loop[k] == strip_end))
          throw InvalidValue((list.strip ? "tristrips[" : "face[") + std::to_string(list.number) + "][" +
                                 std::to_string(k) + "]",
                             "an index below " + std::to_string(soup_.points.size()), std::to_string(loop[k]));
      list.strip ? cut_strips(loop) : cut_polygon(soup_.points, loop, soup_.triangles);
    }
    return std::move(soup_);
  }

  void cut_strips(std::span<const std::uint32_t> strip) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
      if (strip[i] == strip_end) begin = i + 1;
      if (i < begin + 2) continue;
      const bool odd = (i - begin) % 2 == 1;
      soup_.triangles.push_back({strip[odd ? i - 1 : i - 2], strip[odd ? i - 2 : i - 1], strip[i]});
    }
  }

  struct List {
    std::size_t begin, count, number;
    bool strip;
  };

  TextLines lines_;
  bool ascii_ = false, big_ = false;
  std::vector<Element> elements_;
  std::string_view body_;
  std::size_t at_ = 0, line_ends_ = 0;
  TriangleSoup soup_;
  std::vector<std::uint32_t> corners_;
  std::vector<List> lists_;
};

}  // namespace

TriangleSoup read_ply(std::string_view bytes) { return PlyReader(bytes).run(); }

}  // namespace graze::io
