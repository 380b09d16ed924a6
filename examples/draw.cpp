// Debug draw: a renderer of a screen that writes what a simulation draws into an SVG picture, as seen from the side.
#include <graze/draw.hpp>

#include <cstdio>
#include <fstream>
#include <string>

namespace {

class Svg : public graze::DebugDraw {
 public:
  using DebugDraw::DebugDraw;

  bool wants(graze::DrawLayer layer) const override { return layer != graze::DrawLayer::bounds; }
  void point(const graze::Vec3d& at, graze::DrawLayer, graze::DrawMeaning meaning) override {
    over_ += "<circle " + place("cx", "cy", at) + " r='4' fill='" + color(meaning) + "'/>\n";
  }
  void line(const graze::Vec3d& from, const graze::Vec3d& to, graze::DrawLayer layer,
            graze::DrawMeaning meaning) override {
    (layer == graze::DrawLayer::shapes ? under_ : over_) += "<line " + place("x1", "y1", from) + place("x2", "y2", to) +
                                                            " stroke='" + color(meaning) + "' stroke-width='2'/>\n";
  }
  void triangle(const graze::Vec3d& a, const graze::Vec3d& b, const graze::Vec3d& c, graze::DrawLayer,
                graze::DrawMeaning meaning) override {
    under_ += "<polygon points='" + place("", "", a) + place("", "", b) + place("", "", c) + "' fill='" +
              color(meaning) + "' fill-opacity='.3'/>\n";
  }
  void text(const graze::Vec3d& at, std::string_view words, graze::DrawLayer, graze::DrawMeaning) override {
    over_ += "<text " + place("x", "y", at) + ">" + std::string(words) + "</text>\n";
  }
  std::string picture() const {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='600'>\n" + under_ + over_ + "</svg>\n";
  }

 private:
  /// Coordinates of the picture as two attributes, or as a pair without their names.
  std::string place(const std::string& x, const std::string& y, const graze::Vec3d& p) const {
    const double scale = 500 / area().size;
    const std::string u = std::to_string(300 + scale * (p.x - area().center.x));
    const std::string v = std::to_string(300 - scale * (p.y - area().center.y));
    return x.empty() ? u + "," + v + " " : " " + x + "='" + u + "' " + y + "='" + v + "'";
  }
  static std::string color(graze::DrawMeaning meaning) {
    const graze::DrawColor c = graze::suggested_color(meaning);
    return "rgb(" + std::to_string(c.red) + "," + std::to_string(c.green) + "," + std::to_string(c.blue) + ")";
  }

  std::string under_, over_;
};

}  // namespace

int main() {
  graze::Simulationd simulation;
  graze::Body<double> floor{graze::Box<double>({8, 1, 8}), {{0, -0.5, 0}, {}}};
  floor.fixed = true;
  simulation.add(floor);
  for (int i = 0; i < 5; ++i) simulation.add({graze::Box<double>({1, 1, 1}), {{0.1 * i, 0.5 + 1.1 * i, 0}, {}}});
  for (int step = 0; step < 90; ++step) simulation.step(1.0 / 60);

  Svg svg(graze::draw_area(simulation.world()));
  draw(svg, simulation);
  std::ofstream("pile.svg") << svg.picture();
  std::printf("pile.svg shows %zu points of contact\n", simulation.world().contacts().points.size());
}
