// A renderer in Python: an object with any of a renderer's methods.
#pragma once

#include <optional>
#include <set>

#include "convert.hpp"

namespace graze::python {

/// The renderer that draws while one call of `draw` takes.
class PythonDraw final : public DebugDraw {
 public:
  /// Reads `center`, `size` and `layers` where the object has them. Throws `InvalidValue` for other values, and a
  /// TypeError for another form, of a method as well.
  explicit PythonDraw(const py::object& on);

  bool wants(DrawLayer layer) const override { return !layers_ || layers_->contains(layer); }
  void point(const Vec3d& at, DrawLayer layer, DrawMeaning meaning) override;
  void line(const Vec3d& from, const Vec3d& to, DrawLayer layer, DrawMeaning meaning) override;
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) override;
  void text(const Vec3d& at, std::string_view words, DrawLayer layer, DrawMeaning meaning) override;
  void polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) override;
  void arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) override;

 private:
  void read_layers(const py::object& words);

  py::object on_;
  std::optional<std::set<DrawLayer>> layers_;
  /// The object's methods, or None.
  py::object point_, line_, triangle_, text_, polygon_, arrow_;
};

/// The meaning of a word. Throws `InvalidValue` for a word that is none.
DrawMeaning meaning_of(const std::string& word);

}  // namespace graze::python
