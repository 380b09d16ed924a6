// The caller's renderer behind a C++ one.
#pragma once

#include <string>

#include "c/arguments.hpp"
#include "graze/draw.hpp"

namespace graze::c {

inline DrawMeaning meaning_of(GrazeDrawMeaning meaning) {
  return enumerator<DrawMeaning>(meaning, static_cast<int>(DrawMeaning::joint) + 1, "meaning");
}

/// A renderer whose functions are C's.
class CallersDraw final : public DebugDraw {
 public:
  explicit CallersDraw(const GrazeDebugDraw* on) : DebugDraw(area_of(given(on, "on"))), on_(*on) {}

  bool wants(DrawLayer layer) const override { return (on_.layers >> static_cast<int>(layer) & 1) != 0; }
  void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) override {
    if (on_.point != nullptr) on_.point(on_.user, &at.x, of(layer), of(meaning));
  }
  void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) override {
    if (on_.line != nullptr) on_.line(on_.user, &from.x, &to.x, of(layer), of(meaning));
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) override {
    if (on_.triangle != nullptr) on_.triangle(on_.user, &a.x, &b.x, &c.x, of(layer), of(meaning));
  }
  void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) override {
    if (on_.text != nullptr) on_.text(on_.user, &at.x, std::string(words).c_str(), of(layer), of(meaning));
  }

  void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) override {
    if (on_.arrow == nullptr) return DebugDraw::arrow(from, direction, layer, meaning);
    on_.arrow(on_.user, &from.x, &direction.x, of(layer), of(meaning));
  }

 private:
  static_assert(sizeof(Vec3d) == 3 * sizeof(double), "a place is read as three numbers");

  static GrazeDrawLayer of(DrawLayer layer) { return static_cast<GrazeDrawLayer>(layer); }
  static GrazeDrawMeaning of(DrawMeaning meaning) { return static_cast<GrazeDrawMeaning>(meaning); }
  static DrawArea area_of(const GrazeDebugDraw* on) {
    DrawArea area{{on->center[0], on->center[1], on->center[2]}, on->size};
    validate::point(area.center, "on.center");
    if (!(area.size > 0) || !(area.size <= largest_magnitude<double>))
      validate::fail("on.size", "a size > 0", area.size);
    return area;
  }

  GrazeDebugDraw on_;
};

/// Sets the area of a renderer to that of a whole world.
template <class AnyWorld>
void look_at(const AnyWorld& world, GrazeDebugDraw* on) {
  given(on, "on");
  const DrawArea area = draw_area(world);
  on->center[0] = area.center.x, on->center[1] = area.center.y, on->center[2] = area.center.z;
  on->size = area.size;
}

}  // namespace graze::c
