// A renderer that writes down what it is told, so that tests can hold it against the scene.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graze/draw.hpp"

namespace graze::testing {

struct DrawnPart {
  DrawLayer layer;
  DrawMeaning meaning;
  std::vector<Vec3d> at;
  std::string words{};
};

/// The renderer, with the defaults for all that has one.
class DrawRecorder : public DebugDraw {
 public:
  using DebugDraw::DebugDraw;

  bool wants(DrawLayer layer) const override { return off != layer; }
  void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) override {
    points.push_back({layer, meaning, {at}});
  }
  void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) override {
    lines.push_back({layer, meaning, {from, to}});
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) override {
    triangles.push_back({layer, meaning, {a, b, c}});
  }
  void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) override {
    texts.push_back({layer, meaning, {at}, std::string(words)});
  }

  std::optional<DrawLayer> off;
  std::vector<DrawnPart> points, lines, triangles, texts;
};

inline std::size_t count_of(const std::vector<DrawnPart>& parts, DrawLayer layer, DrawMeaning meaning) {
  return static_cast<std::size_t>(std::count_if(
      parts.begin(), parts.end(), [&](const DrawnPart& p) { return p.layer == layer && p.meaning == meaning; }));
}

}  // namespace graze::testing
