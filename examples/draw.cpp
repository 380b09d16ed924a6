// Debug draw: a renderer of a screen that writes what a simulation draws into an SVG picture, as seen from the side.
#include <graze/draw.hpp>

#include <fstream>
#include <string>

class Svg : public graze::DebugDraw {
 public:
  using DebugDraw::DebugDraw;

  bool wants(graze::DrawLayer layer) const override { return layer != graze::DrawLayer::bounds; }
  void point(const graze::Vec3d& at, graze::DrawLayer, graze::DrawMeaning meaning) override {
    over_ += "<path d='M" + place(at) + "h0' stroke-width='8' stroke='" + color(meaning) + "'/>\n";
  }
  void line(const graze::Vec3d& from, const graze::Vec3d& to, graze::DrawLayer layer,
            graze::DrawMeaning meaning) override {
    (layer == graze::DrawLayer::shapes ? under_ : over_) +=
        "<path d='M" + place(from) + "L" + place(to) + "' stroke-width='2' stroke='" + color(meaning) + "'/>\n";
  }
  void triangle(const graze::Vec3d& a, const graze::Vec3d& b, const graze::Vec3d& c, graze::DrawLayer,
                graze::DrawMeaning meaning) override {
    under_ += "<path d='M" + place(a) + "L" + place(b) + " " + place(c) + "Z' fill-opacity='.3' fill='" +
              color(meaning) + "'/>\n";
  }
  void text(const graze::Vec3d& at, std::string_view words, graze::DrawLayer, graze::DrawMeaning) override {
    over_ += "<text transform='translate(" + place(at) + ")'>" + std::string(words) + "</text>\n";
  }
  std::string picture() const {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='600' stroke-linecap='round'>\n" + under_ +
           over_ + "</svg>\n";
  }

 private:
  /// Coordinates of the picture.
  std::string place(const graze::Vec3d& p) const {
    const double scale = 500 / area().size;
    return std::to_string(300 + scale * (p.x - area().center.x)) + "," +
           std::to_string(300 - scale * (p.y - area().center.y));
  }
  static std::string color(graze::DrawMeaning meaning) {
    const graze::DrawColor c = graze::suggested_color(meaning);
    return "rgb(" + std::to_string(c.red) + "," + std::to_string(c.green) + "," + std::to_string(c.blue) + ")";
  }

  std::string under_, over_;
};

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
}
