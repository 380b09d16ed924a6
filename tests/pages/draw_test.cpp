// docs/draw.md: a renderer of the page's four functions is told of a simulation's bodies.
#include "draw_includes.inc"

#include <gtest/gtest.h>

#include <set>

#include "graze/graze.hpp"

namespace {

const std::set<graze::DrawLayer> layers{graze::DrawLayer::shapes};
std::size_t triangles_drawn = 0;

#include "draw_1.inc"

void MyDraw::point(const graze::Vec3d&, graze::DrawLayer, graze::DrawMeaning) {}
void MyDraw::line(const graze::Vec3d&, const graze::Vec3d&, graze::DrawLayer, graze::DrawMeaning) {}
void MyDraw::triangle(const graze::Vec3d&, const graze::Vec3d&, const graze::Vec3d&, graze::DrawLayer layer,
                      graze::DrawMeaning) {
  EXPECT_EQ(layer, graze::DrawLayer::shapes);
  ++triangles_drawn;
}
void MyDraw::text(const graze::Vec3d&, std::string_view, graze::DrawLayer, graze::DrawMeaning) {}

}  // namespace

TEST(Pages, ARendererOfFourFunctionsIsToldOfABox) {
  graze::Simulation<double> simulation;
  simulation.add({graze::Box<double>({1, 1, 1}), {}});
#include "draw_2.inc"
  EXPECT_EQ(triangles_drawn, 12u);
}
