#include "graze/io/owners_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "graze/error.hpp"
#include "graze/geometry.hpp"
#include "io/drawing.hpp"

namespace graze::io {

namespace {

/// The pixels below which a body is a square; more in a scene of so many bodies that drawing them all takes too much.
constexpr double smallest_drawn = 3.5, smallest_of_many = 24;
constexpr std::uint64_t many = 20000;
/// The colour of bodies that do not move, which is paler.
constexpr Color of_fixed{205, 211, 217};
/// Owners that have a line in the legend.
constexpr std::size_t most_words = 16;
constexpr double owners_edge = 40, legend_width = 190;
constexpr Panel owners_panel{owners_edge, owners_edge + 25, picture_width - 2 * owners_edge - legend_width,
                             picture_height - 2 * owners_edge - 10};

/// The colour of an owner, far from all others, also from the next one: hues by the golden angle, in two lightnesses.
Color color_of_owner(std::uint32_t owner) {
  const double hue = std::fmod(210 + 137.50776405 * owner, 360) / 60, light = owner % 2 == 0 ? 0.84 : 0.7;
  const double part = 1 - std::abs(std::fmod(hue, 2) - 1);
  constexpr double pale = 0.3;
  const double wheel[6][3] = {{1, part, 0}, {part, 1, 0}, {0, 1, part}, {0, part, 1}, {part, 0, 1}, {1, 0, part}};
  const auto& pure = wheel[static_cast<std::size_t>(hue) % 6];
  Color color{};
  for (std::size_t i = 0; i < 3; ++i) color[i] = 255 * light * (pale + (1 - pale) * pure[i]);
  return color;
}

std::vector<Vec3d> corners_of(const Aabbd& box) {
  std::vector<Vec3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z});
  return corners;
}

double size_of_area(const Aabbd& box) { return std::max(max_abs(box.extent()), least_size); }

/// The twelve edges of a region, as far as it is in the picture.
std::string region_lines(const View& view, const Aabbd& region, const Aabbd& whole, const Color& color) {
  const Aabbd part{greatest(region.lower, whole.lower), least(region.upper, whole.upper)};
  if (part.lower.x > part.upper.x || part.lower.y > part.upper.y || part.lower.z > part.upper.z) return "";
  const std::vector<Vec3d> corners = corners_of(part);
  std::string out;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (const std::size_t bit : {1U, 2U, 4U})
      if ((i & bit) == 0)
        out += line(view, corners[i], corners[i | bit], hex(color, 0.75), 1.4, " stroke-opacity=\".8\"");
  return out;
}

template <class E>
void put(std::string& bytes, const E& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class E>
E take(std::string_view& bytes) {
  if (bytes.size() < sizeof(E)) throw InvalidValue("picture", "more bytes", std::to_string(bytes.size()));
  E value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

struct PackedFace {
  double depth;
  std::int32_t level, x, y;  ///< of a square
  std::uint8_t background, square;
  std::uint32_t length;
};

}  // namespace

OwnersPicture::OwnersPicture(const Aabbd& whole, const Vec3d& direction, std::uint64_t bodies)
    : whole_(whole.lower.x <= whole.upper.x ? whole : Aabbd{{-1, -1, -1}, {1, 1, 1}}),
      direction_(direction),
      smallest_(bodies < many ? smallest_drawn : smallest_of_many) {
  if (direction == Vec3d{}) throw InvalidValue("direction", "a direction that is not zero", "0, 0, 0");
}

void OwnersPicture::add_square(const Place& place, Face face) {
  const auto [there, added] = squares_.try_emplace(place, face);
  if (!added && there->second.depth < face.depth) there->second = std::move(face);
}

void OwnersPicture::add(const Shaped& shape, const Posed& pose, bool fixed, std::uint32_t owner) {
  const View view(direction_, corners_of(whole_), owners_panel);
  const Color own = color_of_owner(owner), color = fixed ? mixed(own, of_fixed, 0.5) : own;
  const Aabbd box = bounds(shape, pose);
  const double pixels = max_abs(box.extent()) * view.scale();
  if (pixels < smallest_) {
    // Squares are drawn on a grid as coarse as the body, rounded up to a power of two; large ones behind all small
    // ones.
    const int level = std::max(1, static_cast<int>(std::ceil(std::log2(std::max(pixels, 1.0)))));
    const double side = std::ldexp(1.0, level);
    const Vec3d at = box.center();
    const auto cell = [&](double x) { return static_cast<std::int32_t>(std::floor(x / side)); };
    const Place place{level, cell(view.x(at)), cell(view.y(at))};
    add_square(place, {view.depth(at), level > 3,
                       fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                                   place[1] * side, place[2] * side, side, side, hex(color))});
    return;
  }
  SvgDraw canvas(view, {whole_.center(), size_of_area(whole_)}, 0.45 * size_of_area(whole_));
  canvas.set_tint(color);
  draw(canvas, shape, pose, DrawMeaning::fixed);
  for (SvgDraw::Face& face : canvas.take_faces()) faces_.push_back({face.depth, face.background, std::move(face.text)});
}

std::string OwnersPicture::packed() const {
  std::string bytes;
  const auto add_one = [&](const Face& f, const Place* square) {
    PackedFace head{};
    head.depth = f.depth;
    head.background = f.background;
    head.length = static_cast<std::uint32_t>(f.text.size());
    if (square) head.square = 1, head.level = (*square)[0], head.x = (*square)[1], head.y = (*square)[2];
    put(bytes, head);
    bytes += f.text;
  };
  for (const Face& f : faces_) add_one(f, nullptr);
  for (const auto& [place, f] : squares_) add_one(f, &place);
  return bytes;
}

void OwnersPicture::add_packed(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto head = take<PackedFace>(bytes);
    if (bytes.size() < head.length) throw InvalidValue("picture", "more bytes", std::to_string(bytes.size()));
    Face face{head.depth, head.background != 0, std::string(bytes.substr(0, head.length))};
    bytes.remove_prefix(head.length);
    if (head.square != 0)
      add_square({head.level, head.x, head.y}, std::move(face));
    else
      faces_.push_back(std::move(face));
  }
}

std::string OwnersPicture::svg(const std::string& title, const std::vector<Owner>& owners) const {
  const View view(direction_, corners_of(whole_), owners_panel);
  std::vector<const Face*> sorted;
  for (const Face& f : faces_) sorted.push_back(&f);
  for (auto square = squares_.rbegin(); square != squares_.rend(); ++square) sorted.push_back(&square->second);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Face* a, const Face* b) {
    return a->background != b->background ? a->background : a->depth < b->depth;
  });
  std::string out = svg_head() + "<g stroke-width=\".6\" stroke-linejoin=\"round\">\n";
  for (const Face* f : sorted) out += f->text;
  out += "</g>\n<g fill=\"none\">\n";
  for (std::uint32_t i = 0; i < owners.size(); ++i)
    out += region_lines(view, owners[i].region, whole_, color_of_owner(i));
  out += "</g>\n<g font-family=\"system-ui, sans-serif\">\n" + text(24, 32, 17, title);
  const double left = picture_width - legend_width - 12;
  double y = owners_edge + 30;
  for (std::uint32_t i = 0; i < owners.size() && i < most_words; ++i, y += 24) {
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" rx=\"3\" fill=\"{}\"/>\n", left, y,
                       hex(color_of_owner(i)));
    out += text(left + 20, y + 11.5, 13, owners[i].words, "soft");
  }
  if (owners.size() > most_words)
    out += text(left, y + 11.5, 13, fmt::format("and {} more", owners.size() - most_words), "soft");
  return out + "</g>\n</svg>\n";
}

}  // namespace graze::io
